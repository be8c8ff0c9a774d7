#include <signorini/geometry/empty_mesh.h>
#include <signorini/geometry/entries.h>
#include <signorini/geometry/mesh_cutout.h>
#include <signorini/input/input_error.h>
#include <signorini/input/instantiate.h>
#include <signorini/input/number_text.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold.h>
#include <deal.II/grid/tria.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    using Cells =
      std::vector<typename Triangulation<dim>::active_cell_iterator>;

    template <int dim>
    Neighbourhood<dim>
    parse_item(const std::string &item, const Entries &entries)
    {
      const std::vector<std::string> words =
        Utilities::split_string_list(item, ':');
      const auto where = words.size() == 2 ?
                           parse_neighbourhood<dim>(words[0], words[1]) :
                           std::nullopt;
      if (!where || where->radius == 0.)
        entries.refuse("Keep cells near",
                       "cannot understand \"" + item + "\". Each item is `" +
                         (dim == 2 ? "x, y" : "x, y, z") +
                         " : radius', with the point and the radius in m, the "
                         "radius greater than zero.");
      return *where;
    }

    // Cells of the same order, and with the same order of their corners. The
    // faces and lines of a cell have the same numbers, too.
    template <int dim>
    void
    create_copy(const Cells<dim> &cells, Triangulation<dim> &copy)
    {
      std::map<unsigned int, unsigned int> new_index;
      std::vector<Point<dim>>              vertices;
      std::vector<CellData<dim>>           data;
      for (const auto &cell : cells)
        {
          data.emplace_back(cell->n_vertices());
          data.back().material_id = cell->material_id();
          data.back().manifold_id = cell->manifold_id();
          for (const unsigned int v : cell->vertex_indices())
            {
              const auto [place, is_new] =
                new_index.emplace(cell->vertex_index(v), vertices.size());
              if (is_new)
                vertices.push_back(cell->vertex(v));
              data.back().vertices[v] = place->second;
            }
        }
      copy.create_triangulation(vertices, data, SubCellData());
    }

    // The id of a face or line on the surface of the copy.
    template <typename Iterator>
    types::boundary_id
    id_on_surface(const Iterator &old, const types::boundary_id cut)
    {
      const types::boundary_id id = old->boundary_id();
      return id == numbers::internal_face_boundary_id ? cut : id;
    }

    template <int dim>
    void
    copy_ids(const Cells<dim>        &cells,
             const types::boundary_id cut,
             Triangulation<dim>      &copy)
    {
      auto old = cells.begin();
      for (const auto &cell : copy.active_cell_iterators())
        {
          for (const unsigned int f : cell->face_indices())
            {
              const auto face = cell->face(f);
              face->set_manifold_id((*old)->face(f)->manifold_id());
              if (face->at_boundary())
                face->set_boundary_id(id_on_surface((*old)->face(f), cut));
            }
          if (dim == 3)
            for (unsigned int l = 0; l < cell->n_lines(); ++l)
              {
                const auto line = cell->line(l);
                line->set_manifold_id((*old)->line(l)->manifold_id());
                if (line->at_boundary())
                  line->set_boundary_id(id_on_surface((*old)->line(l), cut));
              }
          ++old;
        }
    }

    template <int dim>
    void
    copy_manifolds(const Triangulation<dim> &old, Triangulation<dim> &copy)
    {
      for (const types::manifold_id id : copy.get_manifold_ids())
        if (id != numbers::flat_manifold_id)
          copy.set_manifold(id, old.get_manifold(id));
    }

    template <int dim>
    types::boundary_id
    free_boundary_id(const Mesh<dim> &mesh)
    {
      const auto                   ids = mesh.triangulation->get_boundary_ids();
      std::set<types::boundary_id> taken(ids.begin(), ids.end());
      for (const auto &[name, id] : mesh.boundaries)
        taken.insert(id);
      types::boundary_id id = 0;
      while (taken.count(id) > 0)
        ++id;
      return id;
    }

    // Leaves out the names of which nothing is left.
    template <typename Id>
    void
    keep_names(const std::set<Id> &left, std::map<std::string, Id> &names)
    {
      for (auto name = names.begin(); name != names.end();)
        name =
          left.count(name->second) > 0 ? std::next(name) : names.erase(name);
    }

    template <int dim>
    [[noreturn]] void
    refuse_empty(const Triangulation<dim> &triangulation)
    {
      const auto corners =
        GridTools::compute_bounding_box(triangulation).get_boundary_points();
      std::ostringstream message;
      message << "no cell of the mesh reaches into the "
              << (dim == 2 ? "circles" : "spheres")
              << ". The mesh lies between (" << corners.first << ") and ("
              << corners.second
              << "), in m. Give a point on the body, or a larger radius.";
      throw InputError("Keep cells near", message.str());
    }
  } // namespace



  template <int dim>
  void
  MeshCutout<dim>::declare_parameters(ParameterHandler &prm)
  {
    prm.declare_entry("Keep cells near",
                      "",
                      NumberText(),
                      std::string("`") + (dim == 2 ? "x, y" : "x, y, z") +
                        " : radius ; ...': the part of the mesh that stays, "
                        "for a submodel: the cells that reach into a circle or "
                        "sphere around a point, before the refinements. The "
                        "faces between them and the rest are the boundary "
                        "`cut'. Empty: all. Unit of the point and the radius: "
                        "m.");
  }



  template <int dim>
  MeshCutout<dim>
  MeshCutout<dim>::parse(const ParameterHandler &prm)
  {
    const Entries entries(prm, "");
    MeshCutout    cutout;
    for (const std::string &item :
         Utilities::split_string_list(entries.text("Keep cells near"), ';'))
      cutout.near.push_back(parse_item<dim>(item, entries));
    return cutout;
  }



  template <int dim>
  void
  MeshCutout<dim>::apply(Mesh<dim> &mesh) const
  {
    if (near.empty())
      return;
    const Triangulation<dim> &old = *mesh.triangulation;
    Assert(!old.has_hanging_nodes(),
           ExcMessage("The cut comes before the refinements."));
    if (mesh.boundaries.count("cut") > 0)
      throw InputError(
        "Keep cells near",
        "the faces next to cells that are left out are the boundary \"cut\", "
        "but the mesh has a boundary of this name. Rename it in the mesh.");

    Cells<dim> cells;
    for (const auto &cell : old.active_cell_iterators())
      if (std::any_of(near.begin(), near.end(), [&](const auto &where) {
            return where.is_reached_by(cell->bounding_box());
          }))
        cells.push_back(cell);
    if (cells.empty())
      refuse_empty(old);

    Mesh<dim> kept         = empty_mesh<dim>();
    kept.boundaries        = mesh.boundaries;
    kept.regions           = mesh.regions;
    kept.boundaries["cut"] = free_boundary_id(mesh);
    create_copy<dim>(cells, *kept.triangulation);
    copy_ids<dim>(cells, kept.boundaries["cut"], *kept.triangulation);
    copy_manifolds(old, *kept.triangulation);

    std::set<types::material_id> materials;
    for (const auto &cell : cells)
      materials.insert(cell->material_id());
    const auto ids = kept.triangulation->get_boundary_ids();
    keep_names({ids.begin(), ids.end()}, kept.boundaries);
    keep_names(materials, kept.regions);
    mesh = std::move(kept);
  }



#define INSTANTIATE(dim) template struct MeshCutout<dim>;
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
