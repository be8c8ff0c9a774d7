#ifndef signorini_run_platform_h
#define signorini_run_platform_h

#include <string>

namespace Signorini
{
  /** Program, build type, deal.II and BLAS in use, one per line. */
  std::string
  versions();
} // namespace Signorini

#endif
