#include <signorini/input/as_text.h>
#include <signorini/input/input_error.h>
#include <signorini/input/name_table.h>
#include <signorini/time/time_parameters.h>

#include <deal.II/base/parameter_handler.h>

#include <functional>
#include <map>
#include <optional>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    using Scheme = std::function<GeneralizedAlpha(const ParameterHandler &)>;

    // The one list of time integration schemes, by their .prm names.
    const std::map<std::string, Scheme> &
    schemes()
    {
      static const std::map<std::string, Scheme> list = {
        {"trapezoidal",
         [](const ParameterHandler &) { return trapezoidal_rule(); }},
        {"Newmark",
         [](const ParameterHandler &prm) {
           return newmark(prm.get_double("beta"), prm.get_double("gamma"));
         }},
        {"HHT",
         [](const ParameterHandler &prm) {
           return hilber_hughes_taylor(prm.get_double("alpha_H"));
         }},
        {"Chung-Hulbert",
         [](const ParameterHandler &prm) {
           return chung_hulbert(prm.get_double("Spectral radius"));
         }},
        {"Meguid-Czekanski",
         [](const ParameterHandler &) { return meguid_czekanski(); }},
        {"energy momentum",
         [](const ParameterHandler &) { return midpoint_rule(); }},
        {"generalized alpha", [](const ParameterHandler &prm) {
           return generalized_alpha(prm.get_double("alpha_B"),
                                    prm.get_double("alpha_H"),
                                    prm.get_double("beta"),
                                    prm.get_double("gamma"));
         }}};
      return list;
    }

    std::string
    scheme_names()
    {
      std::string names = "automatic";
      for (const auto &[name, scheme] : schemes())
        names += "|" + name;
      return names;
    }

    constexpr char   conserving[]          = "energy momentum";
    constexpr double usual_spectral_radius = 0.98;

    const NameTable<InitialState> &
    initial_states()
    {
      static const NameTable<InitialState> table = {
        {"as given", InitialState::as_given}, {"static", InitialState::still}};
      return table;
    }

    const NameTable<FinalRelaxation> &
    final_relaxations()
    {
      static const NameTable<FinalRelaxation> table = {
        {"none", FinalRelaxation::none},
        {"static", FinalRelaxation::still},
        {"damped", FinalRelaxation::damped}};
      return table;
    }

    // Without a value the scheme decides.
    const NameTable<std::optional<ContactMass>> &
    contact_masses()
    {
      static const NameTable<std::optional<ContactMass>> table = {
        {"automatic", std::nullopt},
        {"consistent", ContactMass::consistent},
        {"redistributed", ContactMass::redistributed}};
      return table;
    }

    // Large strains and rotations need a scheme that keeps energy by
    // construction; others are bound to it only in what is linear. Plastic flow
    // takes more than they make, and massless nodes serve impacts.
    std::string
    scheme_name(const bool is_large_and_elastic, const ParameterHandler &prm)
    {
      const std::string name = prm.get("Scheme");
      if (name != "automatic")
        return name;
      // Who says how it damps, or that nodes lose their mass, means the other.
      const bool speaks_of_other =
        prm.get_double("Spectral radius") != usual_spectral_radius ||
        contact_masses().at(prm.get("Contact mass")) ==
          ContactMass::redistributed;
      if (!is_large_and_elastic || speaks_of_other)
        return "Chung-Hulbert";
      return conserving;
    }

    ContactMass
    contact_mass_for(const std::string &scheme, const ParameterHandler &prm)
    {
      const auto        asked = contact_masses().at(prm.get("Contact mass"));
      const bool        needs_all = scheme == conserving;
      const ContactMass usual =
        needs_all ? ContactMass::consistent : ContactMass::redistributed;
      if (needs_all && asked == ContactMass::redistributed)
        throw InputError(
          "Time / Contact mass",
          "redistributed takes the mass from nodes, and the scheme energy "
          "momentum needs that of every node. Set Contact mass = consistent, "
          "or Scheme = Chung-Hulbert.");
      return asked.value_or(usual);
    }

    void
    declare_scheme(ParameterHandler &prm)
    {
      prm.declare_entry(
        "Scheme",
        "automatic",
        Patterns::Selection(scheme_names()),
        "Time integration. automatic: energy momentum for elastic bodies with "
        "finite strain unless a Spectral radius or Contact mass = "
        "redistributed is given, and Chung-Hulbert for others. energy momentum keeps energy, momentum and angular "
        "momentum of elastic bodies in steps of any size, whatever their "
        "strains and rotations; contact forces ring with it, and where cells "
        "flow it is of second order only. Chung-Hulbert reads `Spectral "
        "radius', HHT "
        "`alpha_H', Newmark `beta' and `gamma', generalized alpha all four "
        "numbers; trapezoidal and Meguid-Czekanski (the set of their section "
        "6.4) read none.");
      prm.declare_entry("Spectral radius",
                        std::to_string(usual_spectral_radius).substr(0, 4),
                        Patterns::Double(),
                        "Factor per step of infinitely high frequencies, in "
                        "[0, 1]: 1 keeps them, 0 removes them. Unit: 1.");
      prm.declare_entry(
        "alpha_B",
        "0",
        Patterns::Double(),
        "Weight of the old state in the inertia term. Unit: 1.");
      prm.declare_entry("alpha_H",
                        "0",
                        Patterns::Double(),
                        "Weight of the old state in all other terms. Unit: 1.");
      prm.declare_entry("beta",
                        "0.25",
                        Patterns::Double(),
                        "Newmark's beta. Unit: 1.");
      prm.declare_entry("gamma",
                        "0.5",
                        Patterns::Double(),
                        "Newmark's gamma. Unit: 1.");
    }
  } // namespace



  void
  TimeParameters::declare_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Time");
    prm.declare_entry("Analysis",
                      "dynamic",
                      Patterns::Selection("dynamic|static"),
                      "dynamic: with inertia. static: without inertia; time "
                      "only scales loads and motions (load stepping).");
    prm.declare_entry("Initial state",
                      "as given",
                      Patterns::Selection(initial_states().names()),
                      "What a dynamic run starts from. as given: the initial "
                      "displacements of the bodies, which need not be in "
                      "balance. static: the equilibrium that a static step "
                      "from there finds under the loads and supports at t = 0, "
                      "with contact and friction; velocities are as given.");
    prm.declare_entry("Final relaxation",
                      "none",
                      Patterns::Selection(final_relaxations().names()),
                      "What takes the vibration out of the bodies after the "
                      "End time of a dynamic run and leaves residual "
                      "stresses. static: one step without inertia. damped: "
                      "more steps of the Step size, with the bodies stopped "
                      "whenever their kinetic energy begins to fall, until "
                      "nearly none is left. Rigid bodies fly on.");
    prm.declare_entry("End time",
                      "1",
                      Patterns::Double(0.),
                      "The run goes from t = 0 to this time. Unit: s.");
    prm.declare_entry("Step size",
                      "0.1",
                      Patterns::Double(0.),
                      "Size of a time step (static: load step). Unit: s.");
    StepControl::declare_parameters(prm);
    declare_scheme(prm);
    prm.declare_entry(
      "Contact mass",
      "automatic",
      Patterns::Selection(contact_masses().names()),
      "automatic: consistent with the scheme energy momentum, "
      "redistributed with others. redistributed: nodes lose their mass when they come "
      "into contact, and contact forces do not ring. It goes "
      "inwards; mass, centre of mass and moments of inertia of "
      "each body are kept, and so are its energy and momenta. "
      "Where a surface that flows is about to wrinkle without its mass, all "
      "get theirs back for the rest of the run, with a Spectral radius of at "
      "most 0.8. "
      "consistent: every node keeps its mass.");
    prm.declare_entry("Contact work",
                      "returned",
                      Patterns::Selection("returned|lost"),
                      "A contact that opens or closes between two times does "
                      "work that the continuous problem does not know. "
                      "returned: the velocity along the contact forces gives "
                      "it back, so that energy is kept. lost: it is not.");
    prm.declare_entry("Mass matrix",
                      "consistent",
                      Patterns::Selection("consistent|lumped"),
                      "consistent, or lumped by row sums.");
    prm.declare_entry("Maximal iterations",
                      "25",
                      Patterns::Integer(1, 10000),
                      "A step that needs more iterations is cut in half.");
    prm.declare_entry("Residual tolerance",
                      "1e-9",
                      Patterns::Double(1e-15, 1e-3),
                      "Largest unbalanced nodal force, relative to the largest "
                      "nodal force of the step, and largest optimality (KKT) "
                      "residual of the contact problem at which a step has "
                      "converged. Unit: 1.");
    prm.leave_subsection();
  }



  EntryConditions
  TimeParameters::conditions()
  {
    EntryConditions list = {
      contradiction(read_with({"Spectral radius"},
                              "Scheme",
                              {"Chung-Hulbert", "automatic"})),
      contradiction(read_with({"alpha_B"}, "Scheme", {"generalized alpha"})),
      contradiction(
        read_with({"alpha_H"}, "Scheme", {"HHT", "generalized alpha"})),
      contradiction(read_with({"beta", "gamma"},
                              "Scheme",
                              {"Newmark", "generalized alpha"})),
      read_with({"Scheme",
                 "Spectral radius",
                 "alpha_B",
                 "alpha_H",
                 "beta",
                 "gamma",
                 "Contact mass",
                 "Contact work",
                 "Mass matrix"},
                "Analysis",
                {"dynamic"})};
    for (const EntryCondition &condition : StepControl::conditions())
      list.push_back(condition);
    return list;
  }



  TimeParameters
  TimeParameters::parse(ParameterHandler &prm)
  {
    TimeParameters parameters;
    prm.enter_subsection("Time");
    parameters.dynamic       = prm.get("Analysis") == "dynamic";
    parameters.initial_state = initial_states().at(prm.get("Initial state"));
    if (parameters.initial_state == InitialState::still && !parameters.dynamic)
      throw InputError(
        "Time / Initial state",
        "found static, but a static run is in equilibrium after its first step "
        "anyway. Leave the entry out, or set Time / Analysis = dynamic.");
    parameters.final_relaxation =
      final_relaxations().at(prm.get("Final relaxation"));
    if (parameters.final_relaxation != FinalRelaxation::none &&
        !parameters.dynamic)
      throw InputError(
        "Time / Final relaxation",
        "a static run has no vibration to take out. Set Final relaxation = "
        "none.");
    parameters.end_time            = prm.get_double("End time");
    parameters.step_size           = prm.get_double("Step size");
    parameters.return_contact_work = prm.get("Contact work") == "returned";
    parameters.lump_mass           = prm.get("Mass matrix") == "lumped";
    parameters.maximal_iterations  = prm.get_integer("Maximal iterations");
    parameters.residual_tolerance  = prm.get_double("Residual tolerance");

    if (parameters.end_time <= 0.)
      throw InputError("Time / End time",
                       "must be greater than zero, in s, found " +
                         as_text(parameters.end_time) + ".");
    if (parameters.step_size <= 0.)
      throw InputError("Time / Step size",
                       "must be greater than zero, in s, found " +
                         as_text(parameters.step_size) + ".");
    if (parameters.step_size > parameters.end_time * (1. + 1e-12))
      throw InputError("Time / Step size",
                       "found " + as_text(parameters.step_size) +
                         " s, which is greater than the End time of " +
                         as_text(parameters.end_time) +
                         " s. Choose a step that is not longer than the run.");
    parameters.step_control =
      StepControl::parse(parameters.end_time, parameters.dynamic, prm);
    // More fixed ones would take days; automatic ones begin with short steps.
    const double most_steps = parameters.step_control.automatic ? 1e12 : 1e8;
    const double n_steps    = parameters.end_time / parameters.step_size;
    if (n_steps > most_steps * (1. + 1e-9))
      throw InputError("Time / Step size",
                       "found " + as_text(parameters.step_size) +
                         " s, which makes " + as_text(n_steps) +
                         " steps to the End time of " +
                         as_text(parameters.end_time) + " s; allowed are " +
                         as_text(most_steps) + ". Choose a longer step.");
    prm.leave_subsection();
    return parameters;
  }



  void
  TimeParameters::parse_scheme(const bool        is_large_and_elastic,
                               ParameterHandler &prm)
  {
    prm.enter_subsection("Time");
    const std::string name =
      dynamic ? scheme_name(is_large_and_elastic, prm) : "trapezoidal";
    scheme = schemes().at(name)(prm);
    // Where surfaces with mass flow, what rings would do plastic work.
    constexpr double damping = 0.8;
    scheme_with_mass =
      name == "Chung-Hulbert" ?
        chung_hulbert(std::min(damping, prm.get_double("Spectral radius"))) :
        scheme;
    conserves_energy = name == conserving;
    contact_mass     = contact_mass_for(name, prm);
    prm.leave_subsection();
  }
} // namespace Signorini
