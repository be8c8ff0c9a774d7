#include <signorini/input/input_error.h>
#include <signorini/output/log.h>

#include <sys/ioctl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <iostream>

namespace Signorini
{
  namespace
  {
    std::chrono::steady_clock::duration
    duration(const double seconds)
    {
      return std::chrono::duration_cast<std::chrono::steady_clock::duration>(
        std::chrono::duration<double>(seconds));
    }

    // A line longer than the terminal is wide would wrap, and the carriage
    // return would then only reach its last part.
    std::string
    cut_to_terminal(const std::string &text)
    {
      winsize size{};
      if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col < 2)
        return text;
      return text.substr(0, size.ws_col - 1);
    }
  } // namespace



  Log::Settings
  Log::default_settings()
  {
    Settings settings;
    settings.is_terminal = isatty(STDOUT_FILENO) != 0;
    return settings;
  }



  Log::Log(const std::string &file_name)
    : Log(file_name, default_settings())
  {}



  Log::Log(const std::string &file_name, const Settings &settings)
    : Log(file_name, std::cout, settings)
  {}



  Log::Log(const std::string &file_name,
           std::ostream      &console,
           const Settings    &settings)
    : settings(settings)
    , console(console)
    , file_name(file_name)
    , file_works(!file_name.empty())
    , next_refresh(Clock::now())
    , next_line(next_refresh)
  {
    if (file_name.empty())
      return;
    file.open(file_name, settings.append ? std::ios::app : std::ios::out);
    if (!file)
      throw InputError("The log file '" + file_name +
                       "' cannot be created: " + std::strerror(errno) +
                       ". Choose another output folder.");
  }



  Log::~Log()
  {
    if (progress_stands)
      console << std::endl;
  }



  void
  Log::line(const std::string &text)
  {
    clear_progress();
    console << text << std::endl;
    write_to_file(text);
  }



  void
  Log::detail(const std::string &text)
  {
    write_to_file(text);
  }



  bool
  Log::progress_is_due() const
  {
    return Clock::now() >= (settings.is_terminal ? next_refresh : next_line);
  }



  void
  Log::progress(const std::string &text)
  {
    const Clock::time_point now = Clock::now();
    if (settings.is_terminal && now >= next_refresh)
      {
        console << "\r\x1b[K" << cut_to_terminal(text) << std::flush;
        progress_stands = true;
        next_refresh    = now + duration(settings.refresh_interval);
      }
    if (now >= next_line)
      {
        if (!settings.is_terminal)
          console << text << std::endl;
        write_to_file(text);
        next_line = now + duration(settings.line_interval);
      }
  }



  void
  Log::final_progress(const std::string &text)
  {
    line(text);
  }



  void
  Log::write_to_file(const std::string &text)
  {
    if (!file_works)
      return;
    file << text << std::endl;
    if (!file)
      {
        file_works = false;
        clear_progress();
        console << "The log file '" << file_name
                << "' cannot be written to any more: " << std::strerror(errno)
                << ". The run goes on without it." << std::endl;
      }
  }



  void
  Log::clear_progress()
  {
    if (progress_stands)
      console << "\r\x1b[K";
    progress_stands = false;
  }
} // namespace Signorini
