#include <signorini/contact/sphere.h>
#include <signorini/input/input_error.h>
#include <signorini/input/instantiate.h>
#include <signorini/input/named_list.h>
#include <signorini/input/number_text.h>

#include <deal.II/base/parameter_handler.h>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  Sphere<dim>::Sphere(const Point<dim>     &centre,
                      const double          radius,
                      const Tensor<1, dim> &axis,
                      const bool            inside)
    : centre_(centre)
    , radius_(radius)
    , axis_(axis.norm() > 0. ? axis / axis.norm() : axis)
    , sign_(inside ? -1. : 1.)
  {}



  template <int dim>
  void
  Sphere<dim>::declare_parameters(ParameterHandler  &prm,
                                  const std::string &name)
  {
    prm.enter_subsection(name);
    prm.declare_entry(name == "Cylinder" ? "Point on axis" : "Centre",
                      dim == 2 ? "0, 0" : "0, 0, 0",
                      NumberText(),
                      "Where it is at t = 0. Unit: m.");
    if (name == "Cylinder")
      prm.declare_entry("Axis",
                        "0, 0, 1",
                        NumberText(),
                        "Direction of its axis; any length.");
    prm.declare_entry("Radius",
                      "1",
                      Patterns::Double(),
                      "Greater than zero. Unit: m.");
    prm.declare_entry("Side",
                      "outside",
                      Patterns::Selection("outside|inside"),
                      "outside: bodies touch it from without. inside: it is a "
                      "hole, and bodies touch it from within.");
    prm.leave_subsection();
  }



  template <int dim>
  std::unique_ptr<RigidSurface<dim>>
  Sphere<dim>::create(ParameterHandler  &prm,
                      const std::string &name,
                      const std::string &section)
  {
    const std::string path        = section + " / " + name + " / ";
    const bool        is_cylinder = name == "Cylinder";
    const std::string place       = is_cylinder ? "Point on axis" : "Centre";
    prm.enter_subsection(name);
    const Point<dim> centre = parse_point<dim>(prm.get(place), path + place);
    const Tensor<1, dim> axis =
      is_cylinder ? parse_point<dim>(prm.get("Axis"), path + "Axis") :
                    Tensor<1, dim>();
    const double      radius = prm.get_double("Radius");
    const std::string found  = prm.get("Radius");
    const bool        inside = prm.get("Side") == "inside";
    prm.leave_subsection();
    if (radius <= 0.)
      throw InputError(path + "Radius",
                       "must be greater than zero, in m, found " + found + ".");
    if (is_cylinder && axis.norm() == 0.)
      throw InputError(path + "Axis",
                       "has length zero; give a direction, such as 0, 0, 1.");
    return std::make_unique<Sphere<dim>>(centre, radius, axis, inside);
  }



  template <int dim>
  SurfacePoint<dim>
  Sphere<dim>::closest(const Point<dim> &point) const
  {
    Tensor<1, dim> arm = point - centre_;
    arm -= (arm * axis_) * axis_;
    const double distance = arm.norm();
    // On the axis every direction is as near; any of them is a normal.
    Tensor<1, dim> direction;
    if (distance > 0.)
      direction = arm / distance;
    else
      direction[axis_[0] == 0. ? 0 : 1] = 1.;

    SymmetricTensor<2, dim> curvature;
    if (distance > 0.)
      curvature = (unit_symmetric_tensor<dim>() -
                   symmetrize(outer_product(direction, direction)) -
                   symmetrize(outer_product(axis_, axis_))) *
                  (sign_ / distance);
    return {sign_ * (distance - radius_), sign_ * direction, curvature};
  }



  template <int dim>
  bool
  Sphere<dim>::is_flat() const
  {
    return false;
  }



  template <int dim>
  std::vector<Point<dim>>
  Sphere<dim>::outline() const
  {
    std::vector<Point<dim>> points;
    constexpr unsigned int  n = 180;
    if (dim == 2)
      for (unsigned int i = 0; i <= n; ++i)
        {
          const double angle = 2. * numbers::PI * (i % n) / n;
          Point<dim>   point = centre_;
          point[0] += radius_ * std::cos(angle);
          point[1] += radius_ * std::sin(angle);
          points.push_back(point);
        }
    return points;
  }



#define INSTANTIATE(dim) template class Sphere<dim>;
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
