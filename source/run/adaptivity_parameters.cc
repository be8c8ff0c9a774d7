#include <signorini/input/input_error.h>
#include <signorini/input/named_list.h>
#include <signorini/run/adaptivity_parameters.h>

#include <deal.II/base/parameter_handler.h>

namespace Signorini
{
  using namespace dealii;

  void
  AdaptivityParameters::declare_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Adaptivity");
    prm.declare_entry("Maximal meshes",
                      "1",
                      Patterns::Integer(1, 100),
                      "The problem is solved on a mesh, the mesh refined where "
                      "contact and error ask for it, and again, until the "
                      "quantities settle, but on no more meshes than this. "
                      "Then the run is made. 1: with the mesh as it is.");
    prm.declare_entry("Settled at",
                      "0.01",
                      Patterns::Double(0., 1.),
                      "Relative change of all quantities, while the number of "
                      "unknowns doubles and the estimated error falls, at "
                      "which the mesh is good enough. Unit: 1.");
    prm.declare_entry("Quantities",
                      "",
                      Patterns::Anything(),
                      "What has to settle, separated by `|': formulas of the "
                      "final state as in the Expected results, such as "
                      "`final(rack.right_2.pressure_max) | "
                      "field_max(pinion.root_2.von_mises)'. Without: the "
                      "largest pressure of each pair.");
    prm.declare_entry("Cells across contact",
                      "16",
                      Patterns::Integer(0, 10000),
                      "Cells around what is in contact are cut until so many "
                      "go into its width, on both bodies and half a width "
                      "deep. 0: contact is refined by its error only.");
    prm.declare_entry("Error share",
                      "0.3",
                      Patterns::Double(0.01, 1.),
                      "Of the estimated error of the energy, summed up from "
                      "its greatest share on: cells with this part of it are "
                      "refined. Unit: 1.");
    prm.declare_entry("Smallest cell",
                      "0",
                      Patterns::Double(0.),
                      "Cells are not cut to less than this width, so that "
                      "corners and point loads do not take all. Unit: m.");
    prm.declare_entry("Maximal unknowns",
                      "500000",
                      Patterns::Integer(1),
                      "A mesh with more of them is not refined again.");
    prm.declare_entry("Time",
                      "0",
                      Patterns::Double(0.),
                      "The meshes are made for the state at this time; 0: at "
                      "the End time. Unit: s.");
    prm.declare_entry("Step size",
                      "0",
                      Patterns::Double(0.),
                      "Steps to that time; 0: those of the section Time. "
                      "One step is enough for elastic bodies without friction. "
                      "Unit: s.");
    prm.leave_subsection();
  }



  EntryConditions
  AdaptivityParameters::conditions()
  {
    return {read_if_set({"Settled at",
                         "Quantities",
                         "Cells across contact",
                         "Error share",
                         "Smallest cell",
                         "Maximal unknowns",
                         "Time",
                         "Step size"},
                        "Maximal meshes")};
  }



  AdaptivityParameters
  AdaptivityParameters::parse(const double end_time, ParameterHandler &prm)
  {
    AdaptivityParameters parameters;
    prm.enter_subsection("Adaptivity");
    parameters.maximal_meshes       = prm.get_integer("Maximal meshes");
    parameters.settled_at           = prm.get_double("Settled at");
    parameters.quantities           = split_list(prm.get("Quantities"), '|');
    parameters.cells_across_contact = prm.get_integer("Cells across contact");
    parameters.error_share          = prm.get_double("Error share");
    parameters.smallest_cell        = prm.get_double("Smallest cell");
    parameters.maximal_unknowns     = prm.get_integer("Maximal unknowns");
    parameters.time                 = prm.get_double("Time");
    parameters.step_size            = prm.get_double("Step size");
    if (parameters.time > end_time)
      throw InputError("Adaptivity / Time",
                       "found " + prm.get("Time") +
                         " s, which is after the End time of the run. Choose a "
                         "time within the run.");
    if (parameters.time == 0.)
      parameters.time = end_time;
    if (parameters.step_size > parameters.time)
      throw InputError("Adaptivity / Step size",
                       "found " + prm.get("Step size") +
                         " s, which is more than the time that is to be "
                         "reached. Choose a shorter step.");
    prm.leave_subsection();
    return parameters;
  }
} // namespace Signorini
