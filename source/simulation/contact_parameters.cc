#include <signorini/contact/rigid_target.h>
#include <signorini/input_error.h>
#include <signorini/named_list.h>
#include <signorini/nearest_name.h>
#include <signorini/simulation/contact_parameters.h>

#include <deal.II/base/parameter_handler.h>

#include <sstream>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    typename ContactModel<dim>::PairDescription
    parse_pair(const std::string                                  &text,
               const SolidModel<dim>                              &solid,
               const std::vector<std::unique_ptr<RigidBody<dim>>> &rigid_bodies,
               const FrictionLaw                                  &friction)
    {
      const std::string entry = "Contact / Pairs";
      const std::size_t on    = text.find(" on ");
      const std::size_t dot   = text.find('.');
      if (on == std::string::npos || dot == std::string::npos || dot > on)
        throw InputError(entry + ": found \"" + text +
                         "\". Write \"BODY.BOUNDARY on RIGID BODY\", for "
                         "instance \"beam.bottom on floor\".");
      const std::string contactor = Utilities::trim(text.substr(0, dot));
      for (const auto &rigid_body : rigid_bodies)
        if (rigid_body->name() == contactor)
          throw InputError(entry + ": found \"" + text + "\", but \"" +
                           contactor +
                           "\" is a rigid body. It stands after \"on\": write "
                           "\"BODY.BOUNDARY on " +
                           contactor + "\".");
      const Body<dim>  &body = solid.body(contactor, entry);
      const std::string boundary =
        Utilities::trim(text.substr(dot + 1, on - dot - 1));
      const std::string target = Utilities::trim(text.substr(on + 4));
      try
        {
          body.mesh().boundary(boundary);
        }
      catch (const InputError &error)
        {
          throw InputError(entry + ": " + error.what());
        }
      std::vector<std::string> names;
      for (const auto &rigid_body : rigid_bodies)
        {
          if (rigid_body->name() == target)
            return {&body,
                    boundary,
                    std::make_unique<RigidTarget<dim>>(*rigid_body),
                    friction};
          names.push_back(rigid_body->name());
        }
      throw InputError(entry + ": there is no rigid body \"" + target + "\"." +
                       did_you_mean(target, names) + " The rigid bodies are: " +
                       comma_separated(names) + ".");
    }
  } // namespace



  void
  ContactParameters::declare_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Contact");
    prm.declare_entry("Pairs",
                      "",
                      Patterns::Anything(),
                      "What may touch: `BODY.BOUNDARY on RIGID BODY', "
                      "separated by commas.");
    FrictionLaw::declare_parameters(prm);
    AlgorithmParameters::declare_parameters(prm);
    prm.declare_entry("Relative penalty stiffness",
                      "0",
                      Patterns::Double(0.),
                      "Penalty stiffness as a multiple of the static "
                      "stiffness of the bodies where they are loaded; 0: "
                      "Penalty stiffness counts. Unit: 1.");
    prm.declare_entry("Force tolerance",
                      "1e-4",
                      Patterns::Double(0.),
                      "A step over a curved target has converged when "
                      "contact forces change by less than this part of the "
                      "largest [MC, sec. 5.2: 0.01 %]. Unit: 1.");
    prm.leave_subsection();
  }



  ContactParameters
  ContactParameters::parse(const Constants &constants, ParameterHandler &prm)
  {
    prm.enter_subsection("Contact");
    const ContactParameters parameters = {
      split_list(prm.get("Pairs"), ','),
      AlgorithmParameters::parse(prm),
      prm.get_double("Relative penalty stiffness"),
      prm.get_double("Force tolerance"),
      FrictionLaw::parse(constants, "Contact", prm)};
    prm.leave_subsection();
    return parameters;
  }



  template <int dim>
  std::unique_ptr<ContactModel<dim>>
  create_contact_model(
    const ContactParameters                            &parameters,
    const SolidModel<dim>                              &solid,
    const std::vector<std::unique_ptr<RigidBody<dim>>> &rigid_bodies)
  {
    std::vector<typename ContactModel<dim>::PairDescription> pairs;
    for (const auto &pair : parameters.pairs)
      pairs.push_back(
        parse_pair(pair, solid, rigid_bodies, parameters.friction));
    return std::make_unique<ContactModel<dim>>(std::move(pairs),
                                               solid.is_fixed(),
                                               solid.constraints());
  }



  template <int dim>
  void
  refuse_overclosure(const ContactModel<dim> &contact,
                     const Vector<double>    &displacement)
  {
    const auto points = contact.evaluate({displacement, 0.});
    for (const auto &pair : contact.pairs())
      {
        double     smallest = 0., extent = 0.;
        Point<dim> place;
        for (unsigned int n = 0; n < pair.contactor.nodes.size(); ++n)
          {
            const double gap   = points[pair.first_contact + n].gap;
            const auto  &point = pair.contactor.nodes[n].point;
            extent =
              std::max(extent, point.distance(pair.contactor.nodes[0].point));
            if (gap < smallest)
              {
                smallest = gap;
                place    = point;
              }
          }
        if (smallest >= -1e-10 * extent)
          continue;
        std::ostringstream message;
        message << "Contact / Pairs: at t = 0 the node of body "
                << pair.body->name() << " at (" << place << ") lies "
                << -smallest << " m inside of \"" << pair.target->name()
                << "\". Move one of them apart, or turn the normal (plane) "
                   "or the Side (circle, sphere, cylinder) round.";
        throw InputError(message.str());
      }
    const std::string held = contact.held_penetration({displacement, 0.});
    if (!held.empty())
      throw InputError("Contact / Pairs: " + held);
  }



  template std::unique_ptr<ContactModel<2>>
  create_contact_model(const ContactParameters &,
                       const SolidModel<2> &,
                       const std::vector<std::unique_ptr<RigidBody<2>>> &);
  template std::unique_ptr<ContactModel<3>>
  create_contact_model(const ContactParameters &,
                       const SolidModel<3> &,
                       const std::vector<std::unique_ptr<RigidBody<3>>> &);
  template void
  refuse_overclosure(const ContactModel<2> &, const Vector<double> &);
  template void
  refuse_overclosure(const ContactModel<3> &, const Vector<double> &);
} // namespace Signorini
