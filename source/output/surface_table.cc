#include <signorini/input/input_error.h>
#include <signorini/input/instantiate.h>
#include <signorini/input/named_list.h>
#include <signorini/output/surface_table.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numeric>

namespace Signorini
{
  template <int dim>
  void
  write_surface_table(const SurfaceData<dim> &surface, const std::string &path)
  {
    std::vector<unsigned int> order(surface.nodes.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(),
                     order.end(),
                     [&](const unsigned int a, const unsigned int b) {
                       return surface.nodes[a][0] < surface.nodes[b][0];
                     });

    std::ofstream file(path);
    file.precision(10);
    for (unsigned int c = 0; c < dim; ++c)
      file << (c > 0 ? "," : "") << component_name(c);
    for (const auto &[name, values] : surface.scalar_fields)
      file << ',' << name;
    file << '\n';
    for (const unsigned int n : order)
      {
        file << surface.nodes[n][0];
        for (unsigned int c = 1; c < dim; ++c)
          file << ',' << surface.nodes[n][c];
        for (const auto &[name, values] : surface.scalar_fields)
          {
            file << ',';
            if (std::isfinite(values[n]))
              file << values[n];
          }
        file << '\n';
      }
    file.flush();
    if (!file)
      throw ComputationError("Cannot write \"" + path +
                             "\": is the disk full?");
  }



#define INSTANTIATE(dim)                                      \
  template void write_surface_table(const SurfaceData<dim> &, \
                                    const std::string &);
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
