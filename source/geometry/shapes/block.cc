#include <signorini/geometry/degrees.h>
#include <signorini/geometry/empty_mesh.h>
#include <signorini/geometry/entries.h>
#include <signorini/geometry/shapes/block.h>
#include <signorini/input/instantiate.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    std::string
    rectangle_or_box()
    {
      return dim == 2 ? "Rectangle" : "Box";
    }
  } // namespace



  template <int dim>
  void
  Block<dim>::declare_parameters(ParameterHandler &prm)
  {
    const Patterns::List point(Patterns::Double(), dim, dim, ",");
    const Patterns::List counts(Patterns::Integer(), dim, dim, ",");

    prm.enter_subsection(rectangle_or_box<dim>());
    prm.declare_entry("Corners",
                      dim == 2 ? "0, 0 ; 1, 1" : "0, 0, 0 ; 1, 1, 1",
                      Patterns::List(point, 2, 2, ";"),
                      "The corner with the smallest and the one with the "
                      "largest coordinates. Unit: m.");
    prm.declare_entry("Cells",
                      dim == 2 ? "1, 1" : "1, 1, 1",
                      counts,
                      "Number of cells in each direction, at least 1.");
    prm.declare_entry("Grading",
                      dim == 2 ? "1, 1" : "1, 1, 1",
                      point,
                      "Size of the last cell divided by that of the first one "
                      "in each direction, from 1e-6 to 1e6; 1 is uniform.");
    prm.declare_entry("Angle",
                      "0",
                      Patterns::Double(),
                      dim == 2 ? "Turns the finished mesh counter-clockwise "
                                 "about the origin. Unit: degree." :
                                 "Turns the finished mesh counter-clockwise "
                                 "about the z axis. Unit: degree.");
    prm.leave_subsection();
  }



  template <int dim>
  void
  Block<dim>::parse_parameters(const ParameterHandler &prm)
  {
    const Entries                  entries(prm, rectangle_or_box<dim>());
    const std::vector<std::string> corners =
      Utilities::split_string_list(entries.text("Corners"), ';');
    const std::vector<double> first =
      Utilities::string_to_double(Utilities::split_string_list(corners[0]));
    const std::vector<double> second =
      Utilities::string_to_double(Utilities::split_string_list(corners[1]));

    n_cells = entries.counts("Cells", 1);
    grading = entries.numbers("Grading");
    angle   = entries.number("Angle");
    for (unsigned int d = 0; d < dim; ++d)
      {
        if (!(first[d] < second[d]))
          entries.refuse("Corners",
                         "each coordinate of the first corner must be less "
                         "than that of the second one.");
        if (!(grading[d] >= 1e-6 && grading[d] <= 1e6))
          entries.refuse("Grading", "each ratio must be from 1e-6 to 1e6.");
        if (n_cells[d] == 1 && grading[d] != 1.)
          entries.refuse("Grading",
                         "a direction with a single cell (see Cells) can only "
                         "have the ratio 1.");
        first_corner[d]  = first[d];
        second_corner[d] = second[d];
      }
  }



  template <int dim>
  Mesh<dim>
  Block<dim>::create() const
  {
    std::vector<std::vector<double>> points;
    Point<dim>                       counts;
    for (unsigned int d = 0; d < dim; ++d)
      {
        points.push_back(graded_points(
          first_corner[d], second_corner[d], n_cells[d], grading[d]));
        counts[d] = n_cells[d];
      }

    // A mesh of unit cells, whose vertices are then looked up: no rounding
    // errors of accumulated cell sizes in the coordinates.
    Mesh<dim> mesh = empty_mesh<dim>();
    GridGenerator::subdivided_hyper_rectangle(
      *mesh.triangulation, n_cells, Point<dim>(), counts, true);
    const double cosine = cos_degrees(angle), sine = sin_degrees(angle);
    GridTools::transform(
      [&](const Point<dim> &index) {
        Point<dim> p;
        for (unsigned int d = 0; d < dim; ++d)
          p[d] = points[d][static_cast<unsigned int>(std::lround(index[d]))];
        Point<dim> turned = p;
        turned[0]         = cosine * p[0] - sine * p[1];
        turned[1]         = sine * p[0] + cosine * p[1];
        return turned;
      },
      *mesh.triangulation);
    for (const auto &cell : mesh.triangulation->active_cell_iterators())
      cell->set_material_id(0);

    const std::vector<std::string> names = {
      "left", "right", "bottom", "top", "back", "front"};
    for (unsigned int side = 0; side < 2 * dim; ++side)
      mesh.boundaries[names[side]] = side;
    return mesh;
  }



  std::vector<double>
  graded_points(const double       begin,
                const double       end,
                const unsigned int n_cells,
                const double       ratio)
  {
    // With q^(n-1) = ratio, the point i is at (q^i - 1) / (q^n - 1). expm1
    // keeps all digits when q is close to 1.
    const double log_q = n_cells > 1 ? std::log(ratio) / (n_cells - 1.) : 0.;

    std::vector<double> points(n_cells + 1);
    for (unsigned int i = 0; i <= n_cells; ++i)
      {
        const double fraction =
          log_q == 0. ? i / double(n_cells) :
                        std::expm1(i * log_q) / std::expm1(n_cells * log_q);
        points[i] = begin + fraction * (end - begin);
      }
    points.back() = end;
    return points;
  }

#define INSTANTIATE(dim) template class Block<dim>;
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
