#include <signorini/simulation/platform.h>
#include <signorini/version.h>

#include <deal.II/base/config.h>

#include <sstream>

extern "C"
{
  char *
  openblas_get_config();

  void
  openblas_set_num_threads(int n_threads);
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



  void
  limit_blas_threads(const unsigned int n_threads)
  {
    openblas_set_num_threads(static_cast<int>(n_threads));
  }
} // namespace Signorini
