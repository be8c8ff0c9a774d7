#include <signorini/geometry/mesh.h>
#include <signorini/input/input_error.h>
#include <signorini/input/instantiate.h>
#include <signorini/input/nearest_name.h>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  types::boundary_id
  Mesh<dim>::boundary(const std::string &name) const
  {
    const auto found = boundaries.find(name);
    if (found != boundaries.end())
      return found->second;

    std::vector<std::string> names;
    for (const auto &entry : boundaries)
      names.push_back(entry.first);
    throw InputError("The mesh has no boundary \"" + name +
                     "\". Its boundaries are: " + comma_separated(names) + "." +
                     did_you_mean(name, names));
  }

#define INSTANTIATE(dim) template struct Mesh<dim>;
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
