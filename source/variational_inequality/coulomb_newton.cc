#include <signorini/variational_inequality/coulomb_newton.h>

#include <algorithm>
#include <cmath>

#include "state_equations.h"

namespace Signorini
{
  namespace
  {
    // Of the length scale: nearly dependent rows allow no better, and whoever
    // asked measures the result anew. Forces do not count: those of rows that
    // contradict each other are huge.
    constexpr double acceptable = 1e-10;

    bool
    were_seen(const std::vector<std::vector<ContactState>> &seen,
              const std::vector<ContactState>              &states)
    {
      return std::find(seen.begin(), seen.end(), states) != seen.end();
    }
  } // namespace



  std::vector<ContactState>
  contact_states(const CoulombSystem       &system,
                 const std::vector<double> &x,
                 const std::vector<double> &y)
  {
    std::vector<ContactState> states(system.n_contacts());
    for (unsigned int k = 0; k < system.n_contacts(); ++k)
      {
        const DualContact &contact = system.contact(k);
        ContactState      &state   = states[k];
        const double       lambda =
          x[contact.row] + y[contact.row] / system.normal_weight(k);
        if (!(lambda > 0.))
          continue;
        state.kind = ContactState::stick;
        if (contact.n_tangents == 0)
          continue;
        const double weight = system.tangential_weight(k);
        double       length = 0.;
        for (unsigned int a = 0; a < contact.n_tangents; ++a)
          {
            state.direction[a] =
              x[contact.row + 1 + a] + y[contact.row + 1 + a] / weight;
            length = std::hypot(length, state.direction[a]);
          }
        if (length <= contact.bound(lambda))
          {
            state.direction = {{0., 0.}};
            continue;
          }
        state.kind = ContactState::slip;
        state.capped =
          contact.friction_coefficient * lambda > contact.largest_friction;
        for (unsigned int a = 0; a < contact.n_tangents; ++a)
          state.direction[a] /= length;
      }
    return states;
  }



  CoulombSolution
  solve_coulomb_newton(const CoulombSystem       &system,
                       const std::vector<double> &start,
                       DenseFactor               &factor,
                       const unsigned int         most_iterations)
  {
    CoulombSolution solution;
    solution.x                       = start;
    std::vector<double>       x      = start;
    std::vector<double>       y      = system.residual(x);
    double                    best   = system.error(x, y);
    std::vector<ContactState> states = contact_states(system, x, y);
    std::vector<std::vector<ContactState>> seen;
    unsigned int                           n_without_progress = 0;
    while (solution.n_iterations < most_iterations && n_without_progress < 20)
      {
        const StateEquations equations(system, states, x, y);
        std::vector<double>  new_x = equations.solve(factor);
        if (new_x.empty())
          break;
        ++solution.n_iterations;
        seen.push_back(states);
        x = std::move(new_x);
        y = system.residual(x);

        const double error = system.error(x, y);
        ++n_without_progress;
        if (error < best)
          {
            best               = error;
            solution.x         = x;
            n_without_progress = 0;
          }
        const double rounding = system.rounding(x);
        if (error <= rounding)
          {
            solution.x      = std::move(x);
            solution.solved = true;
            return solution;
          }
        states = contact_states(system, x, y);
        // Confirmed, or a cycle between states that rounding cannot tell apart.
        if (were_seen(seen, states))
          break;
      }
    solution.solved = best <= acceptable * system.scale();
    if (!solution.solved)
      solution.suspects =
        system.wrong_contacts(solution.x, system.rounding(solution.x));
    return solution;
  }
} // namespace Signorini
