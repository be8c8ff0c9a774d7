#include <signorini/contact/rigid_body.h>
#include <signorini/input/input_error.h>
#include <signorini/input/instantiate.h>
#include <signorini/input/named_list.h>
#include <signorini/input/number_text.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    constexpr const char *rotation_name = "rotation";

    // x and y, then the rotation; in 3-D x, y and z.
    template <int dim>
    unsigned int
    parse_rigid_component(const std::string &text, const std::string &entry)
    {
      if (dim == 2 && text == rotation_name)
        return 2;
      try
        {
          return parse_component<dim>(text, entry);
        }
      catch (const InputError &)
        {
          throw InputError(entry,
                           "found \"" + text + "\", allowed are " +
                             (dim == 2 ? "x, y and rotation." : "x, y and z."));
        }
    }
  } // namespace



  template <int dim>
  void
  RigidBody<dim>::declare_parameters(ParameterHandler &prm)
  {
    declare_rigid_surface_parameters<dim>(prm);
    prm.declare_entry("Motion",
                      "",
                      Patterns::Anything(),
                      "Its displacement as a function of t, components "
                      "separated by `;': `0 ; -1e-3*t'. Empty: at rest. Free "
                      "components do not follow it. Unit: m.");
    prm.declare_entry("Centre of rotation",
                      "",
                      NumberText(),
                      "The point about which it turns; of a free body its "
                      "centre of mass. Empty: the origin. Unit: m.");
    prm.declare_entry("Free",
                      "",
                      Patterns::Anything(),
                      "Components that are found from the forces on it, "
                      "separated by commas: x, y and rotation in 2-D; x, y "
                      "and z in 3-D. Empty: its motion is given.");
    prm.declare_entry("Mass",
                      "0",
                      Patterns::Double(0.),
                      "Mass, over the thickness or full circle. Needed by "
                      "free components of a dynamic run. Unit: kg.");
    prm.declare_entry("Force",
                      "",
                      Patterns::Anything(),
                      "Force on its centre as a function of t, components "
                      "separated by `;'. Acts on free components. Unit: N.");
    prm.declare_entry("Initial velocity",
                      "",
                      Patterns::Anything(),
                      "Of its free components at t = 0, separated by `;'. "
                      "Unit: m/s.");
    if (dim == 3)
      return;
    prm.declare_entry("Rotation",
                      "",
                      Patterns::Anything(),
                      "Its angle as a function of t, counter-clockwise. "
                      "Empty: it does not turn. Unit: rad.");
    prm.declare_entry("Moment of inertia",
                      "0",
                      Patterns::Double(0.),
                      "About its centre. Needed by a free rotation of a "
                      "dynamic run. Unit: kg m^2.");
    prm.declare_entry("Moment",
                      "",
                      Patterns::Anything(),
                      "Moment on a free rotation as a function of t, "
                      "counter-clockwise. Unit: N m.");
    prm.declare_entry("Initial angular velocity",
                      "0",
                      Patterns::Double(),
                      "Of a free rotation at t = 0. Unit: rad/s.");
  }



  template <int dim>
  EntryConditions
  RigidBody<dim>::conditions()
  {
    EntryConditions list = rigid_surface_conditions<dim>();
    list.push_back(contradiction(
      read_if_set({"Mass", "Force", "Initial velocity"}, "Free")));
    list.push_back(contradiction(
      read_unless_listed({"Motion"},
                         "Free",
                         dim == 2 ? std::vector<std::string>{"x", "y"} :
                                    std::vector<std::string>{"x", "y", "z"})));
    if (dim == 2)
      {
        list.push_back(contradiction(read_if_listed(
          {"Moment", "Moment of inertia", "Initial angular velocity"},
          "Free",
          rotation_name)));
        list.push_back(contradiction(
          read_unless_listed({"Rotation"}, "Free", {rotation_name})));
      }
    list.push_back(read_with({"Initial velocity", "Initial angular velocity"},
                             "Time/Analysis",
                             {"dynamic"}));
    return list;
  }



  template <int dim>
  RigidBody<dim>::RigidBody(const std::string &name,
                            const std::string &directory,
                            const Constants   &constants,
                            const unsigned int first_unknown,
                            ParameterHandler  &prm)
    : name_(name)
    , surface_(create_rigid_surface<dim>(prm, "Rigid body " + name, directory))
    , motion_(parse_function("Motion", dim, Dependence::time, constants, prm))
    , force_(parse_function("Force", dim, Dependence::time, constants, prm))
    , first_unknown_(first_unknown)
  {
    const std::string path = "Rigid body " + name + " / ";
    if (!prm.get("Centre of rotation").empty())
      centre_ = parse_point<dim>(prm.get("Centre of rotation"),
                                 path + "Centre of rotation");
    if (dim == 2)
      {
        rotation_ =
          parse_function("Rotation", 1, Dependence::time, constants, prm);
        moment_ = parse_function("Moment", 1, Dependence::time, constants, prm);
      }
    parse_free_components(prm.get("Free"), path + "Free");
    parse_inertia(prm);
    parse_initial_velocity(constants, prm);
  }



  template <int dim>
  std::unique_ptr<SpaceTimeFunction<dim>>
  RigidBody<dim>::parse_function(const std::string      &entry,
                                 const unsigned int      n_values,
                                 const Dependence        dependence,
                                 const Constants        &constants,
                                 const ParameterHandler &prm) const
  {
    if (prm.get(entry).empty())
      return nullptr;
    return std::make_unique<SpaceTimeFunction<dim>>(prm.get(entry),
                                                    n_values,
                                                    constants,
                                                    "Rigid body " + name_ +
                                                      " / " + entry,
                                                    dependence);
  }



  template <int dim>
  void
  RigidBody<dim>::parse_free_components(const std::string &list,
                                        const std::string &entry)
  {
    for (const std::string &item : split_list(list, ','))
      is_component_free_[parse_rigid_component<dim>(item, entry)] = true;
    is_free_ =
      std::count(is_component_free_.begin(), is_component_free_.end(), true) >
      0;
  }



  template <int dim>
  void
  RigidBody<dim>::parse_inertia(const ParameterHandler &prm)
  {
    mass_.fill(prm.get_double("Mass"));
    lever_ = surface_->reference_length();
    if (dim == 3)
      return;
    const double inertia = prm.get_double("Moment of inertia");
    if (inertia > 0. && mass_[0] > 0.)
      lever_ = std::sqrt(inertia / mass_[0]);
    mass_[2] = inertia / (lever_ * lever_);
  }



  template <int dim>
  void
  RigidBody<dim>::parse_initial_velocity(const Constants        &constants,
                                         const ParameterHandler &prm)
  {
    if (const auto velocity = parse_function(
          "Initial velocity", dim, Dependence::none, constants, prm))
      for (unsigned int c = 0; c < dim; ++c)
        initial_velocity_[c] = velocity->value(Point<dim>(), 0., c);
    if (dim == 2)
      initial_velocity_[2] =
        lever_ * prm.get_double("Initial angular velocity");
  }



  template <int dim>
  bool
  RigidBody<dim>::is_flat() const
  {
    const bool turns = (rotation_ && rotation_->depends_on_time()) ||
                       (dim == 2 && is_free_ && is_component_free_[2]);
    return surface_->is_flat() && !turns;
  }



  template <int dim>
  std::vector<RigidBodyDof>
  RigidBody<dim>::unknowns() const
  {
    std::vector<RigidBodyDof> list;
    if (!is_free_)
      return list;
    for (unsigned int c = 0; c < n_components; ++c)
      {
        const bool   turns = c == dim;
        RigidBodyDof unknown;
        unknown.mass             = mass_[c];
        unknown.initial_velocity = initial_velocity_[c];
        unknown.force            = [this, c, turns](const double time) {
          if (turns)
            return moment_ ? moment_->value(Point<dim>(), time) / lever_ : 0.;
          return force_ ? force_->value(Point<dim>(), time, c) : 0.;
        };
        if (!is_component_free_[c])
          unknown.motion = [this, c, turns](const double time) {
            if (turns)
              return rotation_ ? rotation_->value(Point<dim>(), time) * lever_ :
                                 0.;
            return motion_ ? motion_->value(Point<dim>(), time, c) : 0.;
          };
        list.push_back(unknown);
      }
    return list;
  }



  template <int dim>
  RigidPlacement<dim>
  RigidBody<dim>::placement(const Configuration &configuration) const
  {
    RigidPlacement<dim> placement;
    placement.centre = centre_;
    if (is_free_)
      {
        for (unsigned int c = 0; c < dim; ++c)
          placement.translation[c] =
            configuration.displacement[first_unknown_ + c];
        if (dim == 2)
          placement.angle =
            configuration.displacement[first_unknown_ + 2] / lever_;
      }
    else
      {
        if (motion_)
          placement.translation =
            motion_->vector_value(Point<dim>(), configuration.time);
        if (rotation_)
          placement.angle = rotation_->value(Point<dim>(), configuration.time);
      }
    placement.rotation = rotation_by<dim>(placement.angle);
    return placement;
  }



#define INSTANTIATE(dim) template class RigidBody<dim>;
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
