#include <signorini/geometry/memory_estimate.h>
#include <signorini/input/input_error.h>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Signorini
{
  double
  estimated_memory(const double n_cells, const unsigned int dim)
  {
    const double n        = std::max(2., n_cells);
    const double in_cells = (dim == 2 ? 1500. : 6000.) * n;
    const double factor =
      dim == 2 ? 30. * n * std::log2(n) : 45. * std::pow(n, 4. / 3.);
    return in_cells + 8. * factor;
  }



  double
  physical_memory()
  {
    return double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGESIZE));
  }



  void
  require_memory(const double n_cells, const unsigned int dim)
  {
    const double needed = estimated_memory(n_cells, dim);
    const double there  = physical_memory();
    if (needed <= 2. * there)
      return;
    std::ostringstream message;
    message.precision(2);
    message << n_cells << " cells need about " << needed / 1e9
            << " GB of memory, and this machine has " << there / 1e9
            << " GB. Ask for fewer cells.";
    throw InputError(message.str());
  }
} // namespace Signorini
