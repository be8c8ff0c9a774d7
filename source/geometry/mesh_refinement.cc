#include <signorini/geometry/boundary_distance.h>
#include <signorini/geometry/empty_mesh.h>
#include <signorini/geometry/entries.h>
#include <signorini/geometry/memory_estimate.h>
#include <signorini/geometry/mesh_refinement.h>
#include <signorini/geometry/neighbourhood.h>
#include <signorini/geometry/refinement_passes.h>
#include <signorini/input/input_error.h>
#include <signorini/input/instantiate.h>
#include <signorini/input/named_errors.h>
#include <signorini/input/number_text.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/grid/tria.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    using Words = std::vector<std::string>;

    // Enough for a factor of 1e9 in size; more is a slip of the pen.
    bool
    is_n_times(const double value)
    {
      return value >= 0. && value <= 30. && value == std::floor(value);
    }

    template <int dim>
    typename MeshRefinement<dim>::Towards
    parse_towards(const std::string &item, const Entries &entries)
    {
      const Words  words = Utilities::split_string_list(item, ':');
      const double n_times =
        number_or_nan(words.size() > 1 ? words[1] : std::string());
      const double distance = words.size() > 2 ? number_or_nan(words[2]) : -1.;
      if (words.size() > 3 || words[0].empty() || !is_n_times(n_times) ||
          !(words.size() < 3 || distance >= 0.))
        entries.refuse("Refinements towards",
                       "cannot understand \"" + item +
                         "\". Each item is `boundary : times' or `boundary : "
                         "times : distance', with times from 0 to 30 and the "
                         "distance in m, not negative, for example "
                         "`rim : 3 ; bottom : 2 : 0.001'.");
      return {words[0], static_cast<unsigned int>(n_times), distance};
    }

    template <int dim>
    typename MeshRefinement<dim>::Near
    parse_near(const std::string &item, const Entries &entries)
    {
      const Words  words   = Utilities::split_string_list(item, ':');
      const auto   where   = words.size() == 3 ?
                               parse_neighbourhood<dim>(words[0], words[1]) :
                               std::nullopt;
      const double n_times = where ? number_or_nan(words[2]) : 0.;
      if (!where || !is_n_times(n_times))
        entries.refuse("Refinements near",
                       "cannot understand \"" + item + "\". Each item is `" +
                         (dim == 2 ? "x, y" : "x, y, z") +
                         " : radius : times', with the point and the radius "
                         "in m, the radius not negative, and times from 0 to "
                         "30.");
      return {where->center, where->radius, static_cast<unsigned int>(n_times)};
    }

    template <int dim>
    void
    check_n_cells(const double n_cells)
    {
      if (n_cells > maximal_n_cells)
        throw InputError(
          "The refinements of the mesh make more than 20 million cells. Ask "
          "for fewer in the section of the body (Initial refinements, Global "
          "refinements, Refinements towards, Refinements near).");
      with_prefix("The refinements of the mesh: ",
                  [&] { require_memory(n_cells, dim); });
    }

    template <int dim>
    void
    refine_flagged(Triangulation<dim> &triangulation)
    {
      double n_cells = triangulation.n_active_cells();
      for (const auto &cell : triangulation.active_cell_iterators())
        if (cell->refine_flag_set())
          n_cells += GeometryInfo<dim>::max_children_per_cell - 1;
      check_n_cells<dim>(n_cells);
      try
        {
          triangulation.execute_coarsening_and_refinement();
        }
      catch (const typename Triangulation<dim>::DistortedCellList &)
        {
          throw InputError(
            "Refining the mesh made a cell with a re-entrant corner. The cells "
            "are too coarse or too flat for the curved boundary; begin with "
            "more cells.");
        }
    }

    template <int dim>
    void
    flag_cells_on(const types::boundary_id boundary,
                  Triangulation<dim>      &triangulation)
    {
      for (const auto &cell : triangulation.active_cell_iterators())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary() && face->boundary_id() == boundary)
            cell->set_refine_flag();
    }

    template <int dim>
    void
    flag_cells_within(const double             distance,
                      const types::boundary_id boundary,
                      Triangulation<dim>      &triangulation)
    {
      const BoundaryDistance<dim> boundary_distance(triangulation, boundary);
      for (const auto &cell : triangulation.active_cell_iterators())
        for (const unsigned int v : cell->vertex_indices())
          if (boundary_distance.is_within(cell->vertex(v), distance))
            {
              cell->set_refine_flag();
              break;
            }
    }

    template <int dim>
    void
    flag_cells_near(const Neighbourhood<dim> &where,
                    Triangulation<dim>       &triangulation)
    {
      for (const auto &cell : triangulation.active_cell_iterators())
        if (where.is_reached_by(cell->bounding_box()))
          cell->set_refine_flag();
    }
  } // namespace



  template <int dim>
  void
  MeshRefinement<dim>::declare_parameters(ParameterHandler &prm)
  {
    const std::string point = dim == 2 ? "x, y" : "x, y, z";
    prm.declare_entry("Global refinements",
                      "0",
                      Patterns::Integer(),
                      "How often all cells are cut in half in each direction, "
                      "0 to 30.");
    prm.declare_entry("Refinements towards",
                      "",
                      NumberText::behind_names(),
                      "`boundary : times ; ...': how often the cells on a "
                      "boundary are cut in half. `boundary : times : distance "
                      "; ...': the same for all cells with a vertex not "
                      "farther than this distance from the boundary. Unit of "
                      "the distance: m.");
    prm.declare_entry("Refinements near",
                      "",
                      NumberText(),
                      "`" + point +
                        " : radius : times ; ...': how often the cells that "
                        "reach into a circle or sphere around a point are cut "
                        "in half. Unit of the point and the radius: m.");
  }



  template <int dim>
  MeshRefinement<dim>
  MeshRefinement<dim>::parse(const ParameterHandler &prm)
  {
    const Entries  entries(prm, "");
    MeshRefinement refinement;
    refinement.n_global = entries.count("Global refinements", 0);
    if (!is_n_times(refinement.n_global))
      entries.refuse("Global refinements", "must be from 0 to 30.");
    for (const std::string &item :
         Utilities::split_string_list(entries.text("Refinements towards"), ';'))
      refinement.towards.push_back(parse_towards<dim>(item, entries));
    for (const std::string &item :
         Utilities::split_string_list(entries.text("Refinements near"), ';'))
      refinement.near.push_back(parse_near<dim>(item, entries));
    return refinement;
  }



  template <int dim>
  void
  MeshRefinement<dim>::apply(Mesh<dim> &mesh) const
  {
    // A misspelt boundary is found before the work.
    with_entry("Refinements towards", [&] {
      for (const Towards &item : towards)
        mesh.boundary(item.boundary);
    });

    refine_globally(*mesh.triangulation, n_global);
    for (const Towards &item : towards)
      for (unsigned int i = 0; i < item.n_times; ++i)
        {
          const types::boundary_id id = mesh.boundary(item.boundary);
          if (item.distance < 0.)
            flag_cells_on(id, *mesh.triangulation);
          else
            flag_cells_within(item.distance, id, *mesh.triangulation);
          refine_flagged(*mesh.triangulation);
        }
    for (const Near &item : near)
      for (unsigned int i = 0; i < item.n_times; ++i)
        {
          flag_cells_near<dim>({item.center, item.radius}, *mesh.triangulation);
          refine_flagged(*mesh.triangulation);
        }
  }



  template <int dim>
  void
  refine_globally(Triangulation<dim> &triangulation, const unsigned int n_times)
  {
    check_n_cells<dim>(triangulation.n_active_cells() *
                       std::pow(2., static_cast<double>(dim) * n_times));
    for (unsigned int i = 0; i < n_times; ++i)
      {
        triangulation.set_all_refine_flags();
        refine_flagged(triangulation);
      }
  }

  template <int dim>
  void
  refine_again(const RefinementPasses &passes,
               Triangulation<dim>     &triangulation)
  {
    for (const std::vector<bool> &flags : passes)
      {
        if (flags.size() != triangulation.n_active_cells())
          throw InputError("The adaptive refinement does not fit the mesh.");
        for (const auto &cell : triangulation.active_cell_iterators())
          if (flags[cell->active_cell_index()])
            cell->set_refine_flag();
        refine_flagged(triangulation);
      }
  }



#define INSTANTIATE(dim)                                    \
  template struct MeshRefinement<dim>;                      \
  template void refine_globally<dim>(Triangulation<dim> &,  \
                                     const unsigned int);   \
  template void refine_again<dim>(const RefinementPasses &, \
                                  Triangulation<dim> &);
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
