#include <signorini/dynamics/unheld_bodies.h>
#include <signorini/input/input_error.h>
#include <signorini/input/instantiate.h>
#include <signorini/input/name_table.h>
#include <signorini/input/named_list.h>
#include <signorini/run/overclosure.h>
#include <signorini/run/problem.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    const NameTable<Kinematics> &
    kinematics_names()
    {
      static const NameTable<Kinematics> table = {
        {"small strain", Kinematics::small_strain},
        {"finite strain", Kinematics::finite_strain}};
      return table;
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
      prm.declare_entry(
        "Kinematics",
        "small strain",
        Patterns::Selection(kinematics_names().names()),
        "small strain: the bodies' strains and rotations are "
        "small, though they may slide and contact may be "
        "anywhere; finite strain: large strains and rotations.");
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
      prm.declare_entry("Submodel of",
                        "",
                        Patterns::Anything(),
                        "Folder of the results of a global run with Output / "
                        "Displacements for submodels = true, from where the "
                        "program is started. Boundaries in Supports / From "
                        "global run follow it; Keep cells near cuts a body "
                        "out of it.");
      prm.declare_entry("Constants",
                        "",
                        Patterns::Anything(),
                        "Names for numbers, to be used in all numbers and "
                        "expressions: `h = 0.02, b = 2*h'. pi is always "
                        "known.");
    }

    // Whether a rigid body stands behind the last word of a pair.
    bool
    names_target(const std::string &pairs, const std::string &body)
    {
      for (const std::string &pair : split_list(pairs, ','))
        if (pair.substr(pair.rfind(' ') + 1) == body)
          return true;
      return false;
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
                       DofVector              &vector)
    {
      if (prm.get(entry).empty())
        return;
      const SpaceTimeFunction<dim> function(prm.get(entry),
                                            dim,
                                            constants,
                                            "Body " + body.name() + " / " +
                                              entry,
                                            Dependence::space);
      for (const auto &node : body.nodes())
        for (unsigned int c = 0; c < dim; ++c)
          vector[node.dofs[c]] = function.value(node.point, 0., c);
    }

    void
    refuse_missing_mass(const std::string               &name,
                        const bool                       is_dynamic,
                        const std::vector<RigidBodyDof> &unknowns)
    {
      for (unsigned int c = 0; c < unknowns.size(); ++c)
        if (is_dynamic && !unknowns[c].motion && unknowns[c].mass <= 0.)
          throw InputError(
            "Rigid body " + name + " / " +
              (c == 2 && unknowns[0].mass > 0. ? "Moment of inertia" : "Mass"),
            "must be greater than zero in a dynamic run, since the body has "
            "free components. Give it, or set Time / Analysis = static.");
    }

    template <int dim>
    bool
    is_elastic(const SolidModel<dim> &solid)
    {
      for (const auto &part : solid.parts())
        for (const Material *const material : part.body->materials())
          if (material->n_history_values() > 0)
            return false;
      return true;
    }

    // The mean force over a step does the work of an energy that depends on
    // the deformation alone.
    template <int dim>
    void
    refuse_expansion_with_conserved_energy(const SolidModel<dim> &solid)
    {
      for (const auto &part : solid.parts())
        for (const Material *const material : part.body->materials())
          if (material->expands())
            throw InputError("Time / Scheme",
                             "energy momentum is for bodies whose energy is "
                             "that of their deformation, and body " +
                               part.body->name() +
                               " has a Thermal expansion. Set Scheme = "
                               "Chung-Hulbert.");
    }

    // The nodes of each body that may lose their mass: of contactors and of
    // deforming targets.
    template <int dim>
    std::vector<std::vector<Node<dim>>>
    contact_nodes(const SolidModel<dim>   &solid,
                  const ContactModel<dim> &contact)
    {
      std::set<unsigned int> unknowns; // first ones of nodes
      for (const auto &pair : contact.pairs())
        {
          for (const auto &node : pair.contactor.nodes)
            unknowns.insert(node.dofs[0]);
          for (const unsigned int unknown : pair.target->unknowns())
            unknowns.insert(unknown);
        }
      std::vector<std::vector<Node<dim>>> lists;
      for (const auto &part : solid.parts())
        {
          std::vector<Node<dim>> nodes;
          for (const auto &node : part.body->nodes())
            if (unknowns.count(node.dofs[0]) > 0)
              nodes.push_back(node);
          lists.push_back(nodes);
        }
      return lists;
    }

    // Asks for loads and motions at the start, the end, and some steps in
    // between as the run will do, so that a formula that has no value there is
    // found before anything is computed. A large problem gets fewer samples.
    template <int dim>
    void
    try_formulas(const Problem<dim> &problem, const DofVector &displacement)
    {
      const TimeParameters  &time  = problem.time;
      const SolidModel<dim> &solid = *problem.solid;
      const double n_steps         = std::ceil(time.end_time / time.step_size);
      const double n_samples =
        std::min(n_steps, std::max(1., std::min(50., 2e5 / solid.n_dofs())));
      DofVector motion(solid.n_dofs()), velocity(motion), acceleration(motion);
      for (unsigned int i = 0; i <= n_samples; ++i)
        {
          const double sample =
            std::min(time.end_time,
                     std::round(i * n_steps / n_samples) * time.step_size);
          solid.apply_supports(sample, motion);
          solid.external_force(sample, displacement);
          for (const auto &body : problem.rigid_bodies)
            body->placement({displacement, sample});
          for (const auto &part : solid.parts())
            if (const auto *const temperature = part.body->temperature())
              for (const auto &node : part.body->nodes())
                temperature->value(node.point, sample);
          if (time.dynamic)
            solid.apply_support_rates(sample,
                                      time.step_size,
                                      velocity,
                                      acceleration);
        }
    }
  } // namespace



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
    ContactParameters::declare_parameters(outline.pairs, prm);
    TimeParameters::declare_parameters(prm);
    AdaptivityParameters::declare_parameters(prm);
    OutputParameters<dim>::declare_parameters(prm);
  }



  template <int dim>
  ConditionList
  problem_conditions(const ProblemOutline &outline)
  {
    ConditionList list;
    list.add({}, {read_if_set({"Submodel of"}, "From global run")});
    for (unsigned int b = 0; b < outline.bodies.size(); ++b)
      {
        const std::string body = "Body " + outline.bodies[b];
        list.add({body}, Body<dim>::conditions());
        list.add(
          {body},
          {read_with({"Initial velocity"}, "Time/Analysis", {"dynamic"})});
        list.add({body, "Loads"}, Loads<dim>::conditions());
        list.add({body, "Material"}, material_conditions());
        for (const auto &region : outline.regions[b])
          list.add({body, "Material " + region}, material_conditions());
      }
    for (const auto &name : outline.rigid_bodies)
      {
        list.add({"Rigid body " + name}, RigidBody<dim>::conditions());
        list.add({},
                 {{{"Rigid body " + name},
                   "Contact/Pairs",
                   [name](const EntryCondition::Choice &pairs) {
                     return names_target(pairs.value, name);
                   },
                   "Name a pair with it",
                   false}});
      }
    list.add({"Contact"}, ContactParameters::conditions());
    for (const auto &pair : outline.pairs)
      list.add({"Contact", "Pair " + pair}, PairParameters::conditions());
    list.add({"Time"}, TimeParameters::conditions());
    list.add({"Adaptivity"}, AdaptivityParameters::conditions());
    return list;
  }



  template <int dim>
  Problem<dim>
  Problem<dim>::create(const ProblemOutline                &outline,
                       const std::string                   &directory,
                       const std::vector<RefinementPasses> &passes,
                       ParameterHandler                    &prm)
  {
    Problem problem;
    problem.constants = parse_constants(prm.get("Constants"), "Constants");
    const Constants &constants  = problem.constants;
    problem.title               = prm.get("Title");
    const Kinematics kinematics = kinematics_names().at(prm.get("Kinematics"));
    problem.time                = TimeParameters::parse(prm);
    problem.adaptivity =
      AdaptivityParameters::parse(problem.time.end_time, prm);

    const GlobalRun global_run = {prm.get("Submodel of"),
                                  problem.time.dynamic ?
                                    TimeInterpolation::cubic :
                                    TimeInterpolation::linear,
                                  problem.time.end_time};

    // 1. Bodies, with all that belongs to each
    std::vector<typename SolidModel<dim>::Part> parts;
    unsigned int                                n_dofs = 0;
    for (const auto &name : outline.bodies)
      {
        prm.enter_subsection("Body " + name);
        auto body =
          std::make_unique<Body<dim>>(name,
                                      outline.formulation,
                                      kinematics,
                                      directory,
                                      n_dofs,
                                      passes.empty() ? RefinementPasses() :
                                                       passes[parts.size()],
                                      prm);
        n_dofs += body->n_dofs();
        body->read_temperature(constants, prm);
        Loads<dim>    loads(*body, constants, prm);
        Supports<dim> supports(*body, constants, global_run, prm);
        parts.push_back(
          {std::move(body), std::move(loads), std::move(supports)});
        prm.leave_subsection();
      }
    std::vector<RigidBodyDof> rigid_body_dofs;
    for (const auto &name : outline.rigid_bodies)
      {
        prm.enter_subsection("Rigid body " + name);
        problem.rigid_bodies.push_back(std::make_unique<RigidBody<dim>>(
          name, directory, constants, n_dofs, prm));
        prm.leave_subsection();
        const auto unknowns = problem.rigid_bodies.back()->unknowns();
        refuse_missing_mass(name, problem.time.dynamic, unknowns);
        rigid_body_dofs.insert(rigid_body_dofs.end(),
                               unknowns.begin(),
                               unknowns.end());
        n_dofs += unknowns.size();
      }
    problem.solid =
      std::make_unique<SolidModel<dim>>(std::move(parts), rigid_body_dofs);
    problem.time.parse_scheme(kinematics == Kinematics::finite_strain &&
                                is_elastic(*problem.solid),
                              prm);
    if (problem.time.conserves_energy)
      refuse_expansion_with_conserved_energy(*problem.solid);
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
    for (unsigned int l = 0; l < rigid_body_dofs.size(); ++l)
      problem.initial_velocity[n_dofs - rigid_body_dofs.size() + l] =
        rigid_body_dofs[l].initial_velocity;

    // 2. Pairs
    problem.contact_parameters = ContactParameters::parse(constants, prm);
    problem.contact = create_contact_model(problem.contact_parameters,
                                           *problem.solid,
                                           problem.rigid_bodies);
    DofVector start(problem.initial_displacement);
    problem.solid->apply_supports(0., start);
    try_formulas(problem, start);
    treat_overclosure(problem.contact_parameters.of_pairs,
                      start,
                      *problem.contact);
    if (!problem.time.dynamic ||
        problem.time.initial_state == InitialState::still)
      refuse_unheld_bodies(*problem.solid,
                           *problem.contact,
                           problem.rigid_bodies,
                           start,
                           problem.time.end_time);

    // 3. Matrices, which have to know the nodes that lose their mass
    problem.solid->assemble({problem.time.dynamic,
                             problem.time.lump_mass,
                             problem.time.contact_mass,
                             contact_nodes(*problem.solid, *problem.contact)});
    auto &contact = problem.contact_parameters;
    if (contact.relative_penalty_stiffness > 0.)
      contact.algorithm.penalty_stiffness =
        contact.relative_penalty_stiffness *
        problem.solid->stiffness_at_load(problem.time.end_time);

    problem.output =
      OutputParameters<dim>::parse(*problem.solid, constants, prm);
    return problem;
  }



#define INSTANTIATE(dim)                                                         \
  template void          declare_problem_parameters<dim>(const ProblemOutline &, \
                                                ParameterHandler &);    \
  template ConditionList problem_conditions<dim>(const ProblemOutline &);        \
  template struct Problem<dim>;
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
