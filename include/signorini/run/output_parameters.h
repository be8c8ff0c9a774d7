#ifndef signorini_run_output_parameters_h
#define signorini_run_output_parameters_h

#include <signorini/solid/solid_model.h>

#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace Signorini
{
  /** The sections `Output` and `Expected results`. */
  template <int dim>
  struct OutputParameters
  {
    /** A node whose motion the history records. */
    struct Monitor
    {
      std::string name;
      Node<dim>   node;
    };

    std::string          directory;
    unsigned int         steps_between_fields;        // 0: not by steps
    double               time_between_fields;         // s; 0: not by time
    unsigned int         steps_between_checkpoints;   // 0: not by steps
    double               minutes_between_checkpoints; // 0: not by the clock
    std::vector<double>  interface_times;             // s, increasing
    bool                 logs_residuals;
    bool                 keeps_displacements; // for submodels
    double               fringe_value;        // Pa; 0: no fringes
    std::vector<Monitor> monitors;
    std::string          checks;

    static void
    declare_parameters(dealii::ParameterHandler &prm);

    /** @throws InputError. */
    static OutputParameters
    parse(const SolidModel<dim>    &solid,
          const Constants          &constants,
          dealii::ParameterHandler &prm);

    /** True if fields are due at the end of this step. */
    bool
    fields_are_due(const unsigned int step,
                   const double       old_time,
                   const double       time) const;

    /** True if the interface problem of this step is to be written. */
    bool
    interface_is_due(const double old_time, const double time) const;
  };
} // namespace Signorini

#endif
