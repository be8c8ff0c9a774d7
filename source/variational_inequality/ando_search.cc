#include <signorini/variational_inequality/ando_search.h>
#include <signorini/variational_inequality/bound_constrained_qp.h>
#include <signorini/variational_inequality/coulomb_fallback.h>
#include <signorini/variational_inequality/coulomb_newton.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // The programme of step (iii) in its dual: the multipliers (lambda, nu)
    // >= 0 of all gaps and of the planes of contacts with a friction bound.
    class SignedProgramme
    {
    public:
      SignedProgramme(const CoulombSystem       &system,
                      const std::vector<double> &bounds,
                      const std::vector<double> &start)
        : system(system)
        , bounds(bounds)
        , x(start)
        , signs(system.n_contacts(), 0)
      {
        // Step (i); what does not slip resists as before.
        const std::vector<double> y = system.residual(x);
        for (unsigned int k = 0; k < system.n_contacts(); ++k)
          {
            const unsigned int row = system.contact(k).row;
            rows.push_back(row);
            owner.push_back(k);
            if (system.contact(k).n_tangents == 0 || !(bounds[k] > 0.))
              continue;
            const double slip = x[row + 1] / bounds[k] +
                                y[row + 1] / std::max(system.scale(), 1e-300);
            signs[k] = slip < 0. ? -1 : 1;
            rows.push_back(row + 1);
            owner.push_back(k);
          }
      }

      // Steps (ii) and (iii).
      QPOutcome
      solve()
      {
        const unsigned int  n = rows.size();
        std::vector<double> fixed(system.size(), 0.), u(n, 0.);
        for (unsigned int k = 0; k < system.n_contacts(); ++k)
          if (signs[k] != 0)
            fixed[system.contact(k).row + 1] = signs[k] * bounds[k];
        const std::vector<double> left = system.residual(fixed);
        InterfaceMatrix           W(n, n);
        std::vector<double>       d(n);
        for (unsigned int i = 0; i < n; ++i)
          {
            d[i] = factor(i) * left[rows[i]];
            u[i] = factor(i) * (x[rows[i]] - fixed[rows[i]]);
            for (unsigned int j = 0; j < n; ++j)
              W(i, j) = factor(i) * factor(j) * system(rows[i], rows[j]);
          }
        const BoundConstrainedSolution result = solve_bound_constrained_qp(
          W, d, u, std::numeric_limits<double>::epsilon() * system.scale());
        n_iterations += result.n_iterations;
        if (result.outcome != QPOutcome::solved)
          {
            suspects = result.suspects;
            return result.outcome;
          }
        multipliers = result.x;
        x           = fixed;
        for (unsigned int i = 0; i < n; ++i)
          x[rows[i]] += factor(i) * multipliers[i];
        return QPOutcome::solved;
      }

      // Steps (iv) to (vi): false if no reversal lowers the objective.
      bool
      reverse_active_planes()
      {
        bool reversed = false;
        for (unsigned int i = 0; i < rows.size(); ++i)
          if (is_plane(i) &&
              multipliers[i] > 2. * (1. + 1e-12) * bounds[owner[i]])
            {
              signs[owner[i]] = -signs[owner[i]];
              reversed        = true;
            }
        return reversed;
      }

      // Those whose multipliers grow without bound.
      bool
      reverse_contradictory_planes()
      {
        bool reversed = false;
        for (const unsigned int i : suspects)
          if (is_plane(i))
            {
              signs[owner[i]] = -signs[owner[i]];
              reversed        = true;
            }
        return reversed;
      }

      // 1/2 x^T (W + C) x - d^T x + ..., minus the objective of the minimum.
      double
      objective() const
      {
        const std::vector<double> y   = system.residual(x);
        double                    sum = 0.;
        for (unsigned int i = 0; i < system.size(); ++i)
          sum += 0.5 * x[i] * (y[i] + system.constant()[i]);
        return sum;
      }

      std::vector<unsigned int>
      suspicious_contacts() const
      {
        std::vector<unsigned int> list;
        for (const unsigned int i : suspects)
          list.push_back(owner[i]);
        std::sort(list.begin(), list.end());
        list.erase(std::unique(list.begin(), list.end()), list.end());
        return list;
      }

      const std::vector<double> &
      forces() const
      {
        return x;
      }

      unsigned int n_iterations = 0;

    private:
      bool
      is_plane(const unsigned int i) const
      {
        return rows[i] != system.contact(owner[i]).row;
      }

      double
      factor(const unsigned int i) const
      {
        return is_plane(i) ? -signs[owner[i]] : 1.;
      }

      const CoulombSystem       &system;
      const std::vector<double> &bounds;
      std::vector<double>        x;
      std::vector<int>           signs; // s_k; 0 without a bound
      std::vector<unsigned int>  rows, owner, suspects;
      std::vector<double>        multipliers;
    };

    std::vector<double>
    friction_bounds(const CoulombSystem &system, const std::vector<double> &x)
    {
      std::vector<double> bounds;
      for (unsigned int k = 0; k < system.n_contacts(); ++k)
        bounds.push_back(system.contact(k).bound(x[system.contact(k).row]));
      return bounds;
    }

    bool
    has_force(const std::vector<double> &x)
    {
      return std::any_of(x.begin(), x.end(), [](const double force) {
        return force != 0.;
      });
    }

    // Linear systems that correct the state of a warm start before the planes
    // are set up.
    constexpr unsigned int most_corrections = 10;

    // Bounds that have not settled by then oscillate.
    constexpr unsigned int first_mean  = 4;
    constexpr unsigned int most_bounds = 40;
  } // namespace



  GivenBoundSolution
  solve_given_bounds(const CoulombSystem       &system,
                     const std::vector<double> &bounds,
                     const std::vector<double> &start)
  {
    SignedProgramme    programme(system, bounds, start);
    GivenBoundSolution solution;
    double             last_objective  = std::numeric_limits<double>::max();
    const unsigned int most_programmes = 20 + 4 * system.n_contacts();
    while (solution.n_programmes < most_programmes)
      {
        const QPOutcome outcome = programme.solve();
        ++solution.n_programmes;
        solution.n_iterations = programme.n_iterations;
        if (outcome == QPOutcome::unbounded &&
            programme.reverse_contradictory_planes())
          continue;
        if (outcome != QPOutcome::solved)
          break;
        // The dual has no duality gap: what it reaches is the minimum of the
        // programme, with the opposite sign. Not falling is rounding.
        const double objective = -programme.objective();
        const bool   falls     = objective < last_objective;
        last_objective         = objective;
        if (!falls || !programme.reverse_active_planes())
          {
            solution.solved = true;
            break;
          }
      }
    solution.x        = programme.forces();
    solution.suspects = programme.suspicious_contacts();
    return solution;
  }



  CoulombSolution
  solve_coulomb_ando(const CoulombSystem       &system,
                     const std::vector<double> &start,
                     DenseFactor               &factor)
  {
    std::vector<double> x     = start, bounds;
    CoulombSolution     exact = solve_coulomb_newton(
      system, x, factor, has_force(start) ? most_corrections : 1);
    unsigned int n_iterations = exact.n_iterations;
    for (unsigned int step = 0; step < most_bounds && !exact.solved; ++step)
      {
        // 1. The bound of the last iterate, and its minimum. A bound that
        // oscillates calms down as a mean of the last two.
        const std::vector<double> old_bounds = bounds;
        bounds                               = friction_bounds(system, x);
        if (step >= first_mean)
          for (unsigned int k = 0; k < bounds.size(); ++k)
            bounds[k] = 0.5 * (bounds[k] + old_bounds[k]);
        const GivenBoundSolution given = solve_given_bounds(system, bounds, x);
        n_iterations += given.n_iterations;
        if (!given.solved)
          {
            exact.suspects = given.suspects;
            break;
          }
        x = given.x;

        // 2. The bound inside the system of these states. Without any bound
        // the states of this programme say nothing about friction.
        if (std::any_of(bounds.begin(), bounds.end(), [](const double bound) {
              return bound > 0.;
            }))
          {
            exact = solve_coulomb_newton(system, x, factor, 1);
            n_iterations += exact.n_iterations;
          }
      }
    if (!exact.solved)
      {
        exact = solve_coulomb_fallback(system, x, factor);
        n_iterations += exact.n_iterations;
      }
    exact.n_iterations = n_iterations;
    return exact;
  }
} // namespace Signorini
