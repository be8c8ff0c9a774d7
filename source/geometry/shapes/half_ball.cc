#include <signorini/geometry/empty_mesh.h>
#include <signorini/geometry/entries.h>
#include <signorini/geometry/shapes/half_ball.h>
#include <signorini/input/instantiate.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <map>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    std::string
    half_disc_or_ball()
    {
      return dim == 2 ? "Half disc" : "Half ball";
    }

    // The direction from the cut into the body, for each place of the cut.
    const std::map<std::string, Tensor<1, 3>> &
    inward_directions()
    {
      static const std::map<std::string, Tensor<1, 3>> list = {
        {"left", Tensor<1, 3>({1., 0., 0.})},
        {"right", Tensor<1, 3>({-1., 0., 0.})},
        {"bottom", Tensor<1, 3>({0., 1., 0.})},
        {"top", Tensor<1, 3>({0., -1., 0.})},
        {"back", Tensor<1, 3>({0., 0., 1.})},
        {"front", Tensor<1, 3>({0., 0., -1.})}};
      return list;
    }

    // The rotation that takes the x axis to `first`, a unit vector along an
    // axis. Its entries are 0, 1 and -1, so that no digit is lost.
    Tensor<2, 3>
    rotation_of_x_axis(const Tensor<1, 3> &first)
    {
      Tensor<1, 3> second;
      if (first[2] == 0.)
        {
          second[0] = -first[1];
          second[1] = first[0];
        }
      else
        second[1] = 1.;
      const Tensor<1, 3> third = cross_product_3d(first, second);

      Tensor<2, 3> rotation;
      for (unsigned int d = 0; d < 3; ++d)
        {
          rotation[d][0] = first[d];
          rotation[d][1] = second[d];
          rotation[d][2] = third[d];
        }
      return rotation;
    }
  } // namespace



  template <int dim>
  void
  HalfBall<dim>::declare_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection(half_disc_or_ball<dim>());
    RoundShape<dim>::declare_parameters(prm);
    prm.declare_entry("Flat side",
                      "top",
                      Patterns::Selection(dim == 2 ?
                                            "left|right|bottom|top" :
                                            "left|right|bottom|top|back|front"),
                      "The side of the body on which the cut is; with top the "
                      "round side points down.");
    prm.leave_subsection();
  }



  template <int dim>
  void
  HalfBall<dim>::parse_parameters(const ParameterHandler &prm)
  {
    const Entries entries(prm, half_disc_or_ball<dim>());
    shape     = RoundShape<dim>::parse(entries);
    flat_side = entries.text("Flat side");
  }



  template <int dim>
  Mesh<dim>
  HalfBall<dim>::create() const
  {
    // deal.II's half ball lies in x >= 0.
    Mesh<dim> mesh = empty_mesh<dim>();
    GridGenerator::half_hyper_ball(*mesh.triangulation,
                                   Point<dim>(),
                                   shape.radius);
    mesh.boundaries["rim"]  = 0;
    mesh.boundaries["flat"] = 1;

    const Tensor<2, 3> rotation =
      rotation_of_x_axis(inward_directions().at(flat_side));
    GridTools::transform(
      [&](const Point<dim> &p) {
        Point<dim> moved = shape.center;
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int j = 0; j < dim; ++j)
            moved[i] += rotation[i][j] * p[j];
        return moved;
      },
      *mesh.triangulation);

    refine_round(shape, 0, *mesh.triangulation);
    return mesh;
  }

#define INSTANTIATE(dim) template class HalfBall<dim>;
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
