#include <signorini/run/platform.h>
#include <signorini/version.h>

#include <deal.II/base/config.h>

#include <sstream>

extern "C"
{
  char *
  openblas_get_config();
}

namespace Signorini
{
  std::string
  versions()
  {
    std::ostringstream text;
#ifdef DEBUG
    const char *const build_type = "Debug";
#else
    const char *const build_type = "Release";
#endif
    text << "Signorini " << SIGNORINI_VERSION << " (" << build_type << ")\n"
         << "deal.II " << DEAL_II_PACKAGE_VERSION << "\n"
         << "BLAS: " << openblas_get_config() << "\n";
    return text.str();
  }
} // namespace Signorini
