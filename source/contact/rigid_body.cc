#include <signorini/contact/rigid_body.h>

#include <deal.II/base/parameter_handler.h>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  void
  RigidBody<dim>::declare_parameters(ParameterHandler &prm)
  {
    declare_rigid_surface_parameters<dim>(prm);
    prm.declare_entry("Motion",
                      "",
                      Patterns::Anything(),
                      "Its displacement as a function of t, components "
                      "separated by `;': `0 ; -1e-3*t'. Empty: at rest. Unit: "
                      "m.");
  }



  template <int dim>
  RigidBody<dim>::RigidBody(const std::string &name,
                            const Constants   &constants,
                            ParameterHandler  &prm)
    : name_(name)
    , surface_(create_rigid_surface<dim>(prm, "Rigid body " + name))
  {
    if (!prm.get("Motion").empty())
      motion_ = std::make_unique<SpaceTimeFunction<dim>>(
        prm.get("Motion"), dim, constants, "Rigid body " + name + " / Motion");
  }



  template <int dim>
  Tensor<1, dim>
  RigidBody<dim>::translation(const double time) const
  {
    return motion_ ? motion_->vector_value(Point<dim>(), time) :
                     Tensor<1, dim>();
  }



  template class RigidBody<2>;
  template class RigidBody<3>;
} // namespace Signorini
