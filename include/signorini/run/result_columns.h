#ifndef signorini_run_result_columns_h
#define signorini_run_result_columns_h

#include <signorini/dynamics/state.h>
#include <signorini/output/history.h>
#include <signorini/run/problem.h>

#include <deal.II/base/tensor.h>

#include <functional>
#include <string>
#include <vector>

namespace Signorini
{
  /** Number of candidates that carry a contact force. */
  unsigned int
  n_active_contacts(const State &state);

  /** What happens on one pair in a state. */
  template <int dim>
  struct PairResult
  {
    unsigned int           n_contacts = 0; // candidates with a contact force
    unsigned int           n_slipping = 0;
    dealii::Tensor<1, dim> force;              // on the body, N
    double                 pressure_max  = 0.; // Pa
    double                 pressure_mean = 0.; // of the area in contact, Pa
    double                 gap_min       = 0.; // m
    std::vector<double>    maxima;    // of the quantities of the processes
    std::vector<double>    integrals; // of these over the surface
  };

  /** A state and what several columns are made of. */
  template <int dim>
  struct ResultState
  {
    ResultState(const Problem<dim> &problem, const State &state);

    const State                 &state;
    std::vector<PairResult<dim>> pairs;
  };

  /** One quantity of a run over time. */
  template <int dim>
  struct ResultColumn
  {
    std::string                                     name;
    std::string                                     unit; // empty: none
    std::function<double(const ResultState<dim> &)> value;
  };

  /**
   * The one table of what history.csv has, in its order:
   *  - iterations, residual, kkt_residual of the step;
   *  - MONITOR.displacement_x, ..., MONITOR.velocity_x, ...;
   *  - for each pair: contacts (nodes with contact force), slipping, force_x,
   *    ... (on the body), pressure_max and pressure_mean (contact force over
   *    the area of the nodes in contact), gap_min, penetration =
   *    max(0, -gap_min), and what its contact processes keep: the largest, and
   *    the integral over the surface;
   *  - for each free rigid body: displacement, velocity, and in a dynamic run
   *    momentum and angular momentum;
   *  - for each body of a dynamic run: momentum_x, ..., angular_momentum (3-D:
   *    _x, ...), centre_x, ...; of an axisymmetric one only along the axis;
   *  - the energy ledger: energy.NAME of what is kept, taken, and lost by the
   *    scheme, work.NAME of what came in.
   * The problem must outlive the table.
   */
  template <int dim>
  std::vector<ResultColumn<dim>>
  result_columns(const Problem<dim> &problem);

  /** Adds the columns of the table. */
  template <int dim>
  void
  add_columns(const std::vector<ResultColumn<dim>> &table, History &history);

  /** Appends the row of a state. */
  template <int dim>
  void
  append_row(const std::vector<ResultColumn<dim>> &table,
             const Problem<dim>                   &problem,
             const State                          &state,
             History                              &history);
} // namespace Signorini

#endif
