#include <signorini/input/input_error.h>
#include <signorini/input/instantiate.h>
#include <signorini/input/named_list.h>
#include <signorini/input/number_text.h>
#include <signorini/run/output_parameters.h>

#include <deal.II/base/parameter_handler.h>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  void
  OutputParameters<dim>::declare_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Output");
    prm.declare_entry("Directory",
                      "output",
                      Patterns::Anything(),
                      "Folder in which each run gets a folder of its own, "
                      "relative to where the program is started.");
    prm.declare_entry("Steps between fields",
                      "0",
                      Patterns::Integer(0),
                      "Write fields after so many steps each; 0: not by "
                      "steps. The start and the end are always written.");
    prm.declare_entry("Time between fields",
                      "0",
                      Patterns::Double(0.),
                      "Write fields each time so much time has passed; 0: not "
                      "by time. Unit: s.");
    prm.declare_entry("Steps between checkpoints",
                      "0",
                      Patterns::Integer(0),
                      "Save the run after so many steps each, so that "
                      "`--resume' can go on from there; 0: not by steps.");
    prm.declare_entry("Minutes between checkpoints",
                      "10",
                      Patterns::Double(0., 1e6),
                      "Save the run each time so many minutes of computing "
                      "have passed; 0: not by the clock. A run that is stopped "
                      "by Ctrl-C or `--steps' is saved always.");
    prm.declare_entry("Interface problems at",
                      "",
                      NumberText(),
                      "Times, separated by commas: the interface problem of "
                      "the step that reaches each is written to a text file, "
                      "which `signorini solve-interface' solves by every "
                      "algorithm. That of a step that fails at the Minimal "
                      "step size is written always. Unit: s.");
    prm.declare_entry("Residuals in log",
                      "false",
                      Patterns::Bool(),
                      "Writes the unbalanced force of all iterations of each "
                      "step to the log, relative to the largest force. Where "
                      "a step does not converge they show why; else each is "
                      "about the square of the last.");
    prm.declare_entry("Displacements for submodels",
                      "false",
                      Patterns::Bool(),
                      "Keeps the displacements in full precision whenever "
                      "fields are written, for runs with Submodel of = the "
                      "folder of this one.");
    prm.declare_entry("Fringe value",
                      "0",
                      Patterns::Double(0.),
                      "Difference of the principal stresses in the plane "
                      "from one fringe of a photoelastic picture to the "
                      "next: adds the field fringe_order, (sigma_1 - "
                      "sigma_2)/value; 0: none. Unit: Pa.");
    prm.declare_entry("Monitor",
                      "",
                      Patterns::Anything(),
                      "Nodes whose displacement and velocity go into the "
                      "history: `tip: beam at 0.2, 0.02 | foot: beam at 0, "
                      "0'. The node next to the point is taken.");
    prm.leave_subsection();
    prm.enter_subsection("Expected results");
    prm.declare_entry("Checks",
                      "",
                      Patterns::Anything(),
                      "Conditions on the history and the final fields, "
                      "separated by `|': `tightness: max(floor.penetration) = "
                      "0 +- 1e-12 | final(tip.displacement_y) = -5e-5 +- 1 % "
                      "[beam theory]'. Each may have a name in front, and in "
                      "brackets where the number comes from. A miss is "
                      "reported and makes the program return 4.");
    prm.leave_subsection();
  }



  template <int dim>
  OutputParameters<dim>
  OutputParameters<dim>::parse(const SolidModel<dim> &solid,
                               const Constants       &constants,
                               ParameterHandler      &prm)
  {
    OutputParameters parameters;
    prm.enter_subsection("Output");
    parameters.directory            = prm.get("Directory");
    parameters.steps_between_fields = prm.get_integer("Steps between fields");
    parameters.time_between_fields  = prm.get_double("Time between fields");
    parameters.steps_between_checkpoints =
      prm.get_integer("Steps between checkpoints");
    parameters.minutes_between_checkpoints =
      prm.get_double("Minutes between checkpoints");
    for (const auto &time : split_list(prm.get("Interface problems at"), ','))
      parameters.interface_times.push_back(
        parse_number(time, "Output / Interface problems at"));
    parameters.logs_residuals = prm.get_bool("Residuals in log");
    parameters.keeps_displacements =
      prm.get_bool("Displacements for submodels");
    parameters.fringe_value = prm.get_double("Fringe value");
    const std::string entry = "Output / Monitor";
    for (const auto &[name, place] :
         parse_named_list(prm.get("Monitor"), entry))
      {
        const std::string separator = " at ";
        const std::size_t at        = place.find(separator);
        if (at == std::string::npos)
          throw InputError(entry,
                           "found \"" + place +
                             "\". Write \"NAME: BODY at x, y\".");
        const Body<dim> &body =
          solid.body(Utilities::trim(place.substr(0, at)), entry);
        const Point<dim> point =
          parse_point<dim>(place.substr(at + separator.size()),
                           entry,
                           constants);
        parameters.monitors.push_back({name, body.node_near(point, entry)});
      }
    prm.leave_subsection();
    prm.enter_subsection("Expected results");
    parameters.checks = prm.get("Checks");
    prm.leave_subsection();
    return parameters;
  }



  template <int dim>
  bool
  OutputParameters<dim>::fields_are_due(const unsigned int step,
                                        const double       old_time,
                                        const double       time) const
  {
    if (steps_between_fields > 0 && step % steps_between_fields == 0)
      return true;
    // The tolerance is for times that are sums of many step sizes.
    const double tolerance = 1e-9;
    return time_between_fields > 0. &&
           std::floor(time / time_between_fields + tolerance) >
             std::floor(old_time / time_between_fields + tolerance);
  }



  template <int dim>
  bool
  OutputParameters<dim>::interface_is_due(const double old_time,
                                          const double time) const
  {
    return std::any_of(interface_times.begin(),
                       interface_times.end(),
                       [&](const double due) {
                         const double late = due * (1. - 1e-9);
                         return old_time < late && late <= time;
                       });
  }



#define INSTANTIATE(dim) template struct OutputParameters<dim>;
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
