#include <signorini/variational_inequality/ando_search.h>
#include <signorini/variational_inequality/bound_constrained_qp.h>
#include <signorini/variational_inequality/coulomb_alternation.h>
#include <signorini/variational_inequality/coulomb_fallback.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // Alternations without half the change: they do not settle.
    constexpr unsigned int patience = 30;

    constexpr double automatic_slip = 1e-10;

    class Alternation
    {
    public:
      Alternation(const CoulombSystem       &system,
                  const std::vector<double> &start,
                  const double               regularisation_slip)
        : system(system)
        , slip_unit(regularisation_slip)
        , x(start)
        , bounds(system.n_contacts(), 0.)
      {}

      // Sub-problem I, and the friction bounds that follow.
      bool
      solve_normal()
      {
        const unsigned int  m = system.n_contacts();
        InterfaceMatrix     W(m, m);
        std::vector<double> d(m), lambda(m), held = x;
        for (unsigned int i = 0; i < m; ++i)
          {
            lambda[i]    = x[row(i)];
            held[row(i)] = 0.;
            for (unsigned int j = 0; j < m; ++j)
              W(i, j) = system(row(i), row(j));
          }
        const std::vector<double> left = system.residual(held);
        for (unsigned int i = 0; i < m; ++i)
          d[i] = left[row(i)];
        const BoundConstrainedSolution result =
          solve_bound_constrained_qp(W,
                                     d,
                                     lambda,
                                     std::numeric_limits<double>::epsilon() *
                                       system.scale());
        n_iterations += result.n_iterations;
        suspects = result.suspects;
        for (unsigned int i = 0; i < m; ++i)
          {
            x[row(i)] = result.x[i];
            bounds[i] = system.contact(i).bound(result.x[i]);
          }
        return result.outcome == QPOutcome::solved;
      }

      // Sub-problem II: the friction forces only; the multipliers of its
      // equations are not the forces of the next sub-problem I.
      bool
      solve_tangential(DenseFactor &factor, std::vector<double> &new_x) const
      {
        new_x = x;
        if (newton(factor, new_x))
          return true;
        const GivenBoundSolution given = solve_given_bounds(system, bounds, x);
        if (!given.solved)
          return false;
        new_x = given.x;
        // If it comes back from there as well, the law without regularisation
        // is as good.
        std::vector<double> regularised = given.x;
        if (newton(factor, regularised))
          new_x = regularised;
        return true;
      }

      // Largest change of all forces against @p old, relative to the largest.
      double
      change(const std::vector<double> &old) const
      {
        double change = 0., size = 0.;
        for (unsigned int i = 0; i < x.size(); ++i)
          {
            change = std::max(change, std::abs(x[i] - old[i]));
            size   = std::max(size, std::abs(x[i]));
          }
        return change == 0. ? 0. : change / size;
      }

      // tau <- tau + omega (new tau - tau), with Aitken's omega.
      void
      relax(const std::vector<double> &new_x)
      {
        std::vector<double> step;
        for (unsigned int k = 0; k < system.n_contacts(); ++k)
          if (system.contact(k).n_tangents > 0)
            step.push_back(new_x[row(k) + 1] - x[row(k) + 1]);
        if (last_step.size() == step.size())
          {
            double product = 0., square = 0.;
            for (unsigned int i = 0; i < step.size(); ++i)
              {
                const double difference = step[i] - last_step[i];
                product += last_step[i] * difference;
                square += difference * difference;
              }
            if (square > 0.)
              omega = std::min(std::max(-omega * product / square, 0.05), 1.);
          }
        unsigned int i = 0;
        for (unsigned int k = 0; k < system.n_contacts(); ++k)
          if (system.contact(k).n_tangents > 0)
            x[row(k) + 1] += omega * step[i++];
        last_step = std::move(step);
      }

      const std::vector<double> &
      forces() const
      {
        return x;
      }

      std::vector<unsigned int> suspects;
      mutable unsigned int      n_iterations = 0;

    private:
      unsigned int
      row(const unsigned int k) const
      {
        return system.contact(k).row;
      }

      // Unknown: the multipliers of the contact set, and tau where
      // |slip| <= epsilon; elsewhere tau = +-f.
      bool
      newton(DenseFactor &factor, std::vector<double> &point) const;

      const CoulombSystem &system;
      const double         slip_unit;
      std::vector<double>  x, bounds, last_step;
      double               omega = 1.;
    };



    bool
    Alternation::newton(DenseFactor &factor, std::vector<double> &point) const
    {
      std::vector<double>           left = system.residual(point);
      std::vector<std::vector<int>> seen;
      for (unsigned int step = 0; step < 50; ++step)
        {
          // 1. The branch of the law that each contact is on.
          std::vector<int> branch(system.n_contacts(), 0);
          for (unsigned int k = 0; k < branch.size(); ++k)
            if (bounds[k] > 0. && std::abs(left[row(k) + 1]) > slip_unit)
              branch[k] = left[row(k) + 1] > 0. ? 1 : -1;
          if (!seen.empty() && seen.back() == branch)
            return true;
          if (std::find(seen.begin(), seen.end(), branch) != seen.end())
            return false;
          seen.push_back(branch);

          // 2. The linear system, scaled to a unit diagonal.
          std::vector<unsigned int> unknown;
          std::vector<double>       soft, scale;
          std::vector<double>       base = point;
          for (unsigned int k = 0; k < branch.size(); ++k)
            {
              const unsigned int i = row(k);
              if (x[i] > 0.)
                {
                  unknown.push_back(i);
                  soft.push_back(0.);
                }
              else
                base[i] = 0.;
              if (system.contact(k).n_tangents == 0)
                continue;
              if (branch[k] == 0 && bounds[k] > 0.)
                {
                  unknown.push_back(i + 1);
                  soft.push_back(slip_unit / bounds[k]);
                }
              else
                base[i + 1] = branch[k] * bounds[k];
            }
          const unsigned int  n = unknown.size();
          std::vector<double> z(n);
          for (const unsigned int i : unknown)
            scale.push_back(system(i, i) > 0. ? 1. / std::sqrt(system(i, i)) :
                                                1.);
          const auto write_row = [&](const unsigned int i, double *entries) {
            for (unsigned int j = 0; j < n; ++j)
              entries[j] =
                scale[i] * scale[j] *
                (system(unknown[i], unknown[j]) + (i == j ? soft[i] : 0.));
          };
          if (!factor.prepare(n, {}, write_row))
            return false;
          ++n_iterations;

          // 3. Solve, with refinement.
          point = base;
          for (unsigned int pass = 0; pass < (factor.is_regularised() ? 5 : 2);
               ++pass)
            {
              left = system.residual(point);
              for (unsigned int i = 0; i < n; ++i)
                z[i] =
                  scale[i] * (left[unknown[i]] - soft[i] * point[unknown[i]]);
              factor.solve(z);
              for (unsigned int i = 0; i < n; ++i)
                point[unknown[i]] += scale[i] * z[i];
            }
          left = system.residual(point);
        }
      return false;
    }
  } // namespace



  CoulombSolution
  solve_coulomb_alternating(const CoulombSystem       &system,
                            const std::vector<double> &start,
                            DenseFactor               &factor,
                            const AlternationControl  &control)
  {
    const double    slip = control.regularisation_slip > 0. ?
                             control.regularisation_slip :
                             automatic_slip * system.scale();
    Alternation     alternation(system, start, slip);
    CoulombSolution solution;
    solution.law_tolerance =
      2. * slip +
      std::max(100. * control.force_tolerance, 1e-9) * system.scale();
    double       least_change  = std::numeric_limits<double>::max();
    unsigned int last_progress = 0;
    for (unsigned int step = 0;
         step < control.most_alternations && step < last_progress + patience;
         ++step)
      {
        const std::vector<double> old = alternation.forces();
        if (!alternation.solve_normal())
          {
            solution.suspects = alternation.suspects;
            break;
          }
        std::vector<double> new_x;
        if (!alternation.solve_tangential(factor, new_x))
          break;
        alternation.relax(new_x);
        const double change = alternation.change(old);
        if (change < 0.5 * least_change)
          {
            least_change  = change;
            last_progress = step;
          }
        if (change <= control.force_tolerance)
          {
            // Normal forces, and with them the bounds, for these friction
            // forces.
            solution.solved = alternation.solve_normal();
            break;
          }
      }
    solution.x = alternation.forces();
    // Forces that settle without a solution, as those of jammed contacts do,
    // must not pass.
    solution.solved = solution.solved &&
                      system.error(solution.x, system.residual(solution.x)) <=
                        solution.law_tolerance;
    solution.n_iterations = alternation.n_iterations;
    if (!solution.solved)
      {
        solution = solve_coulomb_fallback(system, alternation.forces(), factor);
        solution.n_iterations += alternation.n_iterations;
      }
    return solution;
  }
} // namespace Signorini
