#include <signorini/input_error.h>
#include <signorini/named_list.h>
#include <signorini/nearest_name.h>
#include <signorini/simulation/problem.h>
#include <signorini/solid/rigid_motion.h>

#include <deal.II/base/parameter_handler.h>

#include <set>
#include <sstream>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    std::string
    joined(const std::vector<std::string> &names)
    {
      std::string list;
      for (const auto &name : names)
        list += (list.empty() ? "" : ", ") + name;
      return list.empty() ? "(none)" : list;
    }

    void
    declare_general_parameters(ParameterHandler &prm)
    {
      prm.declare_entry("Title",
                        "",
                        Patterns::Anything(),
                        "One line that says what is computed.");
      prm.declare_entry("Formulation",
                        "plane strain",
                        Patterns::Selection(formulation_names()),
                        "plane strain, plane stress, axisymmetric (x is the "
                        "radius, y the axis; forces are those of the full "
                        "circle) or three dimensional.");
      prm.declare_entry("Bodies",
                        "",
                        Patterns::Anything(),
                        "Names of the deformable bodies, separated by commas. "
                        "Each has a section `Body NAME'.");
      prm.declare_entry("Rigid bodies",
                        "",
                        Patterns::Anything(),
                        "Names of the rigid bodies, separated by commas. Each "
                        "has a section `Rigid body NAME'.");
      prm.declare_entry("Constants",
                        "",
                        Patterns::Anything(),
                        "Names for numbers, to be used in all expressions: "
                        "`F = 1e3, h = 0.02'. pi is always known.");
    }

    void
    declare_contact_parameters(ParameterHandler &prm)
    {
      prm.enter_subsection("Contact");
      prm.declare_entry("Pairs",
                        "",
                        Patterns::Anything(),
                        "What may touch: `BODY.BOUNDARY on RIGID BODY', "
                        "separated by commas.");
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

    template <int dim>
    void
    declare_body_parameters(const std::vector<std::string> &regions,
                            ParameterHandler               &prm)
    {
      Body<dim>::declare_parameters(regions, prm);
      Supports<dim>::declare_parameters(prm);
      Loads<dim>::declare_parameters(prm);
      prm.declare_entry("Initial displacement",
                        "",
                        Patterns::Anything(),
                        "At t = 0, components separated by `;'. Unit: m.");
      prm.declare_entry("Initial velocity",
                        "",
                        Patterns::Anything(),
                        "At t = 0, components separated by `;'. Unit: m/s.");
    }

    template <int dim>
    void
    set_initial_values(const Body<dim>        &body,
                       const std::string      &entry,
                       const Constants        &constants,
                       const ParameterHandler &prm,
                       Vector<double>         &vector)
    {
      if (prm.get(entry).empty())
        return;
      const SpaceTimeFunction<dim> function(
        prm.get(entry), dim, constants, "Body " + body.name() + " / " + entry);
      for (const auto &node : body.nodes())
        for (unsigned int c = 0; c < dim; ++c)
          vector[node.dofs[c]] = function.value(node.point, 0., c);
    }

    template <int dim>
    typename ContactModel<dim>::PairNames
    parse_pair(const std::string                                  &text,
               const SolidModel<dim>                              &solid,
               const std::vector<std::unique_ptr<RigidBody<dim>>> &rigid_bodies)
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
            return {&body, boundary, rigid_body.get()};
          names.push_back(rigid_body->name());
        }
      const std::string nearest = nearest_name(target, names);
      throw InputError(
        entry + ": there is no rigid body \"" + target + "\"." +
        (nearest.empty() ? "" : " Did you mean \"" + nearest + "\"?") +
        " The rigid bodies are: " + joined(names) + ".");
    }

    ContactMass
    contact_mass(const std::string &name)
    {
      return name == "consistent" ? ContactMass::consistent :
             name == "affine"     ? ContactMass::affine :
                                    ContactMass::redistributed;
    }

    // The nodes of each body that carry no mass, or would not.
    template <int dim>
    std::vector<std::vector<Node<dim>>>
    contact_nodes(const SolidModel<dim>   &solid,
                  const ContactModel<dim> &contact)
    {
      std::vector<std::vector<Node<dim>>> lists;
      for (const auto &part : solid.parts())
        {
          std::vector<Node<dim>> nodes;
          for (const auto &pair : contact.pairs())
            if (pair.body == part.body.get())
              nodes.insert(nodes.end(),
                           pair.contactor.nodes.begin(),
                           pair.contactor.nodes.end());
          lists.push_back(nodes);
        }
      return lists;
    }

    template <int dim>
    void
    refuse_overclosure(const ContactModel<dim> &contact,
                       const Vector<double>    &displacement)
    {
      const auto points = contact.evaluate(displacement, 0.);
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
                  << -smallest << " m inside of the rigid body \""
                  << pair.target->name()
                  << "\". Move one of them apart, or turn the normal (plane) "
                     "or the Side (circle, sphere, cylinder) round.";
          throw InputError(message.str());
        }
      const std::string held = contact.held_penetration(displacement, 0.);
      if (!held.empty())
        throw InputError("Contact / Pairs: " + held);
    }



    // One list of names at the top of the file, of which `used` knows those
    // that came before.
    void
    check_names(const std::vector<std::string> &names,
                const std::string              &place,
                std::set<std::string>          &used)
    {
      for (const auto &name : names)
        {
          if (name.empty())
            throw InputError(place + "a name is empty. Remove a comma, or "
                                     "write the name that is missing.");
          if (name.find_first_of(".|:/ \t") != std::string::npos)
            throw InputError(place + "the name \"" + name +
                             "\" has one of the characters . | : / or a "
                             "blank, which part names in other entries. Use "
                             "letters, digits, - and _.");
          if (!used.insert(name).second)
            throw InputError(place + "two bodies have the name \"" + name +
                             "\". Give each, rigid or not, a name of its "
                             "own.");
        }
    }
  } // namespace



  ProblemOutline
  ProblemOutline::read(const ParameterFile &file)
  {
    ProblemOutline outline;
    try
      {
        outline.formulation =
          formulation_from_name(file.get("Formulation", "plane strain"));
      }
    catch (const InputError &error)
      {
        throw InputError(file.where("Formulation") + ": " + error.what() +
                         did_you_mean(file.get("Formulation", ""),
                                      split_list(formulation_names(), '|')));
      }
    outline.bodies       = split_list(file.get("Bodies", ""), ',');
    outline.rigid_bodies = split_list(file.get("Rigid bodies", ""), ',');
    if (outline.bodies.empty())
      throw InputError(file.path() +
                       ": the entry Bodies names no body. Write \"set Bodies "
                       "= NAME\" and a section \"Body NAME\".");
    std::set<std::string> names;
    check_names(outline.bodies, file.where("Bodies") + ": Bodies: ", names);
    check_names(outline.rigid_bodies,
                file.where("Rigid bodies") + ": Rigid bodies: ",
                names);
    for (const auto &name : outline.bodies)
      outline.regions.push_back(
        split_list(file.get("Body " + name + "/Regions", ""), ','));
    return outline;
  }



  template <int dim>
  void
  declare_problem_parameters(const ProblemOutline &outline,
                             ParameterHandler     &prm)
  {
    declare_general_parameters(prm);
    for (unsigned int b = 0; b < outline.bodies.size(); ++b)
      {
        prm.enter_subsection("Body " + outline.bodies[b]);
        declare_body_parameters<dim>(outline.regions[b], prm);
        prm.leave_subsection();
      }
    for (const auto &name : outline.rigid_bodies)
      {
        prm.enter_subsection("Rigid body " + name);
        RigidBody<dim>::declare_parameters(prm);
        prm.leave_subsection();
      }
    declare_contact_parameters(prm);
    TimeParameters::declare_parameters(prm);
    OutputParameters<dim>::declare_parameters(prm);
  }



  template <int dim>
  Problem<dim>
  Problem<dim>::create(const ProblemOutline &outline,
                       const std::string    &directory,
                       ParameterHandler     &prm)
  {
    Problem         problem;
    const Constants constants =
      parse_constants(prm.get("Constants"), "Constants");
    problem.title = prm.get("Title");
    problem.time  = TimeParameters::parse(prm);

    // 1. Bodies, with all that belongs to each
    std::vector<typename SolidModel<dim>::Part> parts;
    unsigned int                                n_dofs = 0;
    for (const auto &name : outline.bodies)
      {
        prm.enter_subsection("Body " + name);
        auto body = std::make_unique<Body<dim>>(
          name, outline.formulation, directory, n_dofs, prm);
        n_dofs += body->n_dofs();
        Loads<dim>    loads(*body, constants, prm);
        Supports<dim> supports(*body, constants, prm);
        parts.push_back(
          {std::move(body), std::move(loads), std::move(supports)});
        prm.leave_subsection();
      }
    problem.solid = std::make_unique<SolidModel<dim>>(std::move(parts));
    problem.initial_displacement.reinit(n_dofs);
    problem.initial_velocity.reinit(n_dofs);
    for (const auto &part : problem.solid->parts())
      {
        prm.enter_subsection("Body " + part.body->name());
        set_initial_values(*part.body,
                           "Initial displacement",
                           constants,
                           prm,
                           problem.initial_displacement);
        set_initial_values(*part.body,
                           "Initial velocity",
                           constants,
                           prm,
                           problem.initial_velocity);
        prm.leave_subsection();
      }
    if (!problem.time.dynamic)
      for (const auto &part : problem.solid->parts())
        refuse_free_rigid_motion(*part.body, problem.solid->is_fixed());

    // 2. Targets and pairs
    for (const auto &name : outline.rigid_bodies)
      {
        prm.enter_subsection("Rigid body " + name);
        problem.rigid_bodies.push_back(
          std::make_unique<RigidBody<dim>>(name, constants, prm));
        prm.leave_subsection();
      }
    prm.enter_subsection("Contact");
    std::vector<typename ContactModel<dim>::PairNames> pairs;
    for (const auto &pair : split_list(prm.get("Pairs"), ','))
      pairs.push_back(parse_pair(pair, *problem.solid, problem.rigid_bodies));
    problem.contact_parameters = {AlgorithmParameters::parse(prm),
                                  prm.get_double("Relative penalty stiffness"),
                                  prm.get_double("Force tolerance")};
    prm.leave_subsection();
    problem.contact =
      std::make_unique<ContactModel<dim>>(pairs,
                                          problem.solid->is_fixed(),
                                          problem.solid->is_hanging());
    Vector<double> start(problem.initial_displacement);
    problem.solid->apply_supports(0., start);
    refuse_overclosure(*problem.contact, start);

    // 3. Matrices, which have to know the nodes that lose their mass
    problem.solid->assemble({problem.time.dynamic,
                             problem.time.lump_mass,
                             contact_mass(problem.time.contact_mass),
                             contact_nodes(*problem.solid, *problem.contact)});
    auto &contact = problem.contact_parameters;
    if (contact.relative_penalty_stiffness > 0.)
      contact.algorithm.penalty_stiffness =
        contact.relative_penalty_stiffness *
        problem.solid->stiffness_at_load(problem.time.end_time);

    problem.output = OutputParameters<dim>::parse(*problem.solid, prm);
    return problem;
  }



  template void
  declare_problem_parameters<2>(const ProblemOutline &, ParameterHandler &);
  template void
  declare_problem_parameters<3>(const ProblemOutline &, ParameterHandler &);
  template struct Problem<2>;
  template struct Problem<3>;
} // namespace Signorini
