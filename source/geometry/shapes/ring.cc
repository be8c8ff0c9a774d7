#include <signorini/geometry/degrees.h>
#include <signorini/geometry/empty_mesh.h>
#include <signorini/geometry/entries.h>
#include <signorini/geometry/shapes/ring.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/grid/manifold_lib.h>

namespace Signorini
{
  using namespace dealii;

  bool
  RingShape::is_full() const
  {
    return end_angle - start_angle == 360.;
  }



  void
  RingShape::declare_parameters(ParameterHandler &prm)
  {
    prm.declare_entry("Inner radius",
                      "0.5",
                      Patterns::Double(),
                      "Greater than 0. Unit: m.");
    prm.declare_entry("Outer radius",
                      "1",
                      Patterns::Double(),
                      "Greater than the inner radius. Unit: m.");
    prm.declare_entry("Angles",
                      "0, 360",
                      Patterns::List(Patterns::Double(), 2, 2, ","),
                      "Where the ring starts and ends, counter-clockwise from "
                      "the x axis. The end is greater than the start, by 360 "
                      "for the full ring, else by less. Unit: degree.");
  }



  void
  RingShape::parse_parameters(const Entries &entries)
  {
    const std::vector<double>       angles = entries.numbers("Angles");
    const std::vector<unsigned int> cells  = entries.counts("Cells", 1);
    inner_radius                           = entries.positive("Inner radius");
    outer_radius                           = entries.positive("Outer radius");
    start_angle                            = angles[0];
    end_angle                              = angles[1];
    n_around                               = cells[0];
    n_radial                               = cells[1];

    if (!(outer_radius > inner_radius))
      entries.refuse("Outer radius",
                     "must be greater than Inner radius = " +
                       entries.text("Inner radius") + ".");
    if (!(end_angle > start_angle && end_angle - start_angle <= 360.))
      entries.refuse("Angles",
                     "the second angle must be greater than the first one, by "
                     "not more than 360.");
    if ((end_angle - start_angle) / n_around > 120.)
      entries.refuse("Cells",
                     "the first number must be larger, so that no cell spans "
                     "more than 120 degrees.");
  }



  Mesh<2>
  ring_mesh(const RingShape &shape)
  {
    const unsigned int n_rays   = shape.n_around + (shape.is_full() ? 0 : 1);
    const unsigned int n_layers = shape.n_radial + 1;

    std::vector<Point<2>> vertices;
    for (unsigned int i = 0; i < n_rays; ++i)
      for (unsigned int j = 0; j < n_layers; ++j)
        {
          const double radius = (shape.inner_radius * (shape.n_radial - j) +
                                 shape.outer_radius * j) /
                                shape.n_radial;
          const double angle =
            (shape.start_angle * (shape.n_around - i) + shape.end_angle * i) /
            shape.n_around;
          vertices.push_back(
            shape.center +
            radius * Point<2>(cos_degrees(angle), sin_degrees(angle)));
        }

    // The first direction of each cell goes outward, the second one around.
    std::vector<CellData<2>> cells;
    for (unsigned int i = 0; i < shape.n_around; ++i)
      for (unsigned int j = 0; j < shape.n_radial; ++j)
        {
          const unsigned int here = i * n_layers + j;
          const unsigned int next = ((i + 1) % n_rays) * n_layers + j;
          cells.emplace_back();
          cells.back().vertices    = {here, here + 1, next, next + 1};
          cells.back().material_id = 0;
        }

    Mesh<2> mesh = empty_mesh<2>();
    mesh.triangulation->create_triangulation(vertices, cells, SubCellData());
    mesh.boundaries = {{"inner", 0}, {"outer", 1}};
    if (!shape.is_full())
      mesh.boundaries.insert({{"start", 2}, {"end", 3}});
    for (const auto &cell : mesh.triangulation->active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->at_boundary())
          cell->face(f)->set_boundary_id(f);

    mesh.triangulation->set_all_manifold_ids(0);
    mesh.triangulation->set_manifold(0, SphericalManifold<2>(shape.center));
    return mesh;
  }



  void
  Ring::declare_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Ring");
    prm.declare_entry("Centre",
                      "0, 0",
                      Patterns::List(Patterns::Double(), 2, 2, ","),
                      "Centre of the circles. Unit: m.");
    RingShape::declare_parameters(prm);
    prm.declare_entry("Cells",
                      "24, 4",
                      Patterns::List(Patterns::Integer(), 2, 2, ","),
                      "Number of cells along the circles and from the inner to "
                      "the outer one, at least 1.");
    prm.leave_subsection();
  }



  void
  Ring::parse_parameters(const ParameterHandler &prm)
  {
    const Entries entries(prm, "Ring");
    shape.center = entries.point<2>("Centre");
    shape.parse_parameters(entries);
  }



  Mesh<2>
  Ring::create() const
  {
    return ring_mesh(shape);
  }
} // namespace Signorini
