#include <signorini/output/progress.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace Signorini
{
  std::string
  format_duration(const double seconds)
  {
    // A hundred years: beyond that the number of seconds would overflow.
    const long long total =
      std::llround(std::min(std::max(seconds, 0.), 3.2e9));
    const long long hours   = total / 3600;
    const int       minutes = static_cast<int>(total / 60 % 60);
    const int       rest    = static_cast<int>(total % 60);

    char text[32];
    if (hours > 0)
      std::snprintf(text, sizeof(text), "%lld:%02d:%02d", hours, minutes, rest);
    else
      std::snprintf(text, sizeof(text), "%d:%02d", minutes, rest);
    return text;
  }



  std::string
  progress_line(const Progress &progress)
  {
    std::string line = "step " + std::to_string(progress.step);
    if (progress.n_steps > 0)
      line += "/" + std::to_string(progress.n_steps);

    char time[64];
    std::snprintf(time, sizeof(time), "  t %.3e s", progress.time);
    line += time;
    line += "  iterations " + std::to_string(progress.n_iterations);
    line += "  contacts " + std::to_string(progress.n_contacts);

    const double duration = progress.end_time - progress.start_time;
    const double done     = progress.time - progress.start_time;
    if (done > 0. && duration > 0.)
      line += "  left " + format_duration(progress.elapsed *
                                          std::max(duration - done, 0.) / done);
    return line;
  }
} // namespace Signorini
