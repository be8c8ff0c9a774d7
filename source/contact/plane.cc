#include <signorini/contact/plane.h>
#include <signorini/input/input_error.h>
#include <signorini/input/instantiate.h>
#include <signorini/input/named_list.h>
#include <signorini/input/number_text.h>

#include <deal.II/base/parameter_handler.h>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  Plane<dim>::Plane(const Point<dim> &point, const Tensor<1, dim> &normal)
    : point_(point)
    , normal_(normal / normal.norm())
  {}



  template <int dim>
  void
  Plane<dim>::declare_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Plane");
    prm.declare_entry("Point",
                      dim == 2 ? "0, 0" : "0, 0, 0",
                      NumberText(),
                      "A point on it, at t = 0. Unit: m.");
    prm.declare_entry("Normal",
                      dim == 2 ? "0, 1" : "0, 0, 1",
                      NumberText(),
                      "Its normal, pointing away from the rigid side; any "
                      "length.");
    prm.leave_subsection();
  }



  template <int dim>
  std::unique_ptr<RigidSurface<dim>>
  Plane<dim>::create(ParameterHandler &prm, const std::string &section)
  {
    prm.enter_subsection("Plane");
    const std::string path = section + " / Plane / ";
    const Point<dim> point = parse_point<dim>(prm.get("Point"), path + "Point");
    const Tensor<1, dim> normal =
      parse_point<dim>(prm.get("Normal"), path + "Normal");
    prm.leave_subsection();
    if (normal.norm() == 0.)
      throw InputError(path + "Normal",
                       std::string(
                         "has length zero; give a direction, such as ") +
                         (dim == 2 ? "0, 1." : "0, 0, 1."));
    return std::make_unique<Plane<dim>>(point, normal);
  }



  template <int dim>
  SurfacePoint<dim>
  Plane<dim>::closest(const Point<dim> &point) const
  {
    return {(point - point_) * normal_, normal_, {}};
  }



  template <int dim>
  bool
  Plane<dim>::is_flat() const
  {
    return true;
  }



#define INSTANTIATE(dim) template class Plane<dim>;
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
