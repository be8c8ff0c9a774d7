#include <signorini/geometry/empty_mesh.h>
#include <signorini/geometry/entries.h>
#include <signorini/geometry/shapes/ball.h>
#include <signorini/input/instantiate.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/grid/grid_generator.h>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    std::string
    disc_or_ball()
    {
      return dim == 2 ? "Disc" : "Ball";
    }
  } // namespace



  template <int dim>
  void
  Ball<dim>::declare_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection(disc_or_ball<dim>());
    RoundShape<dim>::declare_parameters(prm);
    prm.leave_subsection();
  }



  template <int dim>
  void
  Ball<dim>::parse_parameters(const ParameterHandler &prm)
  {
    shape = RoundShape<dim>::parse(Entries(prm, disc_or_ball<dim>()));
  }



  template <int dim>
  Mesh<dim>
  Ball<dim>::create() const
  {
    Mesh<dim> mesh = empty_mesh<dim>();
    GridGenerator::hyper_ball_balanced(*mesh.triangulation,
                                       shape.center,
                                       shape.radius);
    mesh.boundaries["rim"] = 0;
    refine_round(shape, 0, *mesh.triangulation);
    return mesh;
  }

#define INSTANTIATE(dim) template class Ball<dim>;
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
