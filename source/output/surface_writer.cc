#include <signorini/input/instantiate.h>
#include <signorini/output/surface_writer.h>

#include <deal.II/base/data_out_base.h>

#include <algorithm>
#include <sstream>
#include <tuple>

namespace Signorini
{
  namespace
  {
    using namespace dealii;

    template <int dim>
    using FacePatch = DataOutBase::Patch<dim - 1, dim>;

    // First and last component, name, and kind of what is no scalar.
    using Range =
      std::tuple<unsigned int,
                 unsigned int,
                 std::string,
                 DataComponentInterpretation::DataComponentInterpretation>;

    template <int dim>
    bool
    is_consistent(const SurfaceData<dim> &surface)
    {
      const auto fits = [&](const auto &field) {
        return field.second.size() == surface.nodes.size();
      };
      return !surface.faces.empty() &&
             std::all_of(surface.scalar_fields.begin(),
                         surface.scalar_fields.end(),
                         fits) &&
             std::all_of(surface.vector_fields.begin(),
                         surface.vector_fields.end(),
                         fits);
    }

    // Components one after the other: the scalars, then the vectors.
    template <int dim>
    FacePatch<dim>
    face_patch(const SurfaceData<dim> &surface, const unsigned int face)
    {
      constexpr unsigned int n_vertices =
        GeometryInfo<dim - 1>::vertices_per_cell;
      const std::vector<unsigned int> &nodes = surface.faces[face];
      AssertDimension(nodes.size(), n_vertices);

      FacePatch<dim> patch;
      patch.patch_index    = face;
      patch.n_subdivisions = 1;
      patch.reference_cell = ReferenceCells::get_hypercube<dim - 1>();
      patch.data.reinit(surface.scalar_fields.size() +
                          dim * surface.vector_fields.size(),
                        n_vertices);
      for (unsigned int v = 0; v < n_vertices; ++v)
        {
          AssertIndexRange(nodes[v], surface.nodes.size());
          patch.vertices[v]      = surface.nodes[nodes[v]];
          unsigned int component = 0;
          for (const auto &field : surface.scalar_fields)
            patch.data(component++, v) = field.second[nodes[v]];
          for (const auto &field : surface.vector_fields)
            for (unsigned int d = 0; d < dim; ++d)
              patch.data(component++, v) = field.second[nodes[v]][d];
        }
      return patch;
    }

    template <int dim>
    std::string
    vtu_text(const SurfaceData<dim> &surface,
             const double            time,
             const unsigned int      number)
    {
      Assert(is_consistent(surface),
             ExcMessage("The surface " + surface.name +
                        " has no faces, or a field without a value per node."));
      std::vector<FacePatch<dim>> patches;
      for (unsigned int face = 0; face < surface.faces.size(); ++face)
        patches.push_back(face_patch(surface, face));

      std::vector<std::string> names;
      for (const auto &field : surface.scalar_fields)
        names.push_back(field.first);
      std::vector<Range> ranges;
      for (const auto &field : surface.vector_fields)
        {
          ranges.emplace_back(
            names.size(),
            names.size() + dim - 1,
            field.first,
            DataComponentInterpretation::component_is_part_of_vector);
          names.insert(names.end(), dim, field.first);
        }

      std::ostringstream text;
      DataOutBase::write_vtu(
        patches,
        names,
        ranges,
        DataOutBase::VtkFlags(
          time, number, false, DataOutBase::VtkFlags::best_speed),
        text);
      return text.str();
    }
  } // namespace



  template <int dim>
  SurfaceWriter<dim>::SurfaceWriter(const std::string &folder)
    : collection_(folder + "/contact.pvd")
  {}



  template <int dim>
  void
  SurfaceWriter<dim>::write(const std::vector<SurfaceData<dim>> &surfaces,
                            const double                         time)
  {
    std::vector<std::string> parts;
    for (const SurfaceData<dim> &surface : surfaces)
      parts.push_back(surface.name);
    collection_.write(parts,
                      time,
                      [&](const unsigned int i, const unsigned int number) {
                        return vtu_text(surfaces[i], time, number);
                      });
  }



#define INSTANTIATE(dim) template class SurfaceWriter<dim>;
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
