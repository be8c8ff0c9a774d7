#include <signorini/variational_inequality/kkt_residual.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // A comparison with NaN is false: std::max would lose it.
    void
    raise(double &maximum, const double value)
    {
      if (std::isnan(value))
        maximum = std::numeric_limits<double>::infinity();
      else
        maximum = std::max(maximum, value);
    }

    double
    quotient(const double value, const double scale)
    {
      if (!std::isfinite(value) || !std::isfinite(scale))
        return std::numeric_limits<double>::infinity();
      return value == 0. ? 0. : value / scale;
    }

    // What is left of a value when it is only known to this size.
    double
    beyond(const double value, const double rounding)
    {
      return std::abs(value) <= rounding ?
               0. :
               value - std::copysign(rounding, value);
    }

    // The terms of a balance of n forces are known to this part of their sum.
    double
    relative_rounding(const unsigned int n)
    {
      return 8. * std::sqrt(n + 1.) * std::numeric_limits<double>::epsilon();
    }

    // 1. Balance of forces, and the scale F.
    void
    measure_stationarity(const InterfaceProblem  &problem,
                         const InterfaceSolution &solution,
                         KKTResidual             &residual)
    {
      InterfaceVector stiffness_force = solution.displacement;
      problem.stiffness().multiply(stiffness_force);
      InterfaceVector terms = solution.displacement; // absolute, summed up
      problem.stiffness().multiply_absolute(terms);
      InterfaceVector contact_force(problem.size());
      for (unsigned int k = 0; k < problem.n_contacts(); ++k)
        {
          const InterfaceContact &contact = problem.contact(k);
          contact.normal.add_to(contact_force, solution.forces.normal[k]);
          if (k < solution.forces.tangential.size())
            for (unsigned int j = 0; j < contact.tangents.size(); ++j)
              contact.tangents[j].add_to(contact_force,
                                         solution.forces.tangential[k][j]);
        }

      const InterfaceVector &force     = problem.force();
      const double           share     = relative_rounding(problem.size());
      double                 unbalance = 0.;
      for (unsigned int i = 0; i < problem.size(); ++i)
        {
          raise(residual.force_scale, std::abs(force(i)));
          raise(residual.force_scale, std::abs(stiffness_force(i)));
          raise(residual.force_scale, std::abs(contact_force(i)));
          const double rest = stiffness_force(i) - force(i) + contact_force(i);
          terms(i) += std::abs(force(i)) + std::abs(contact_force(i));
          raise(unbalance, std::abs(beyond(rest, share * terms(i))));
        }
      for (const double lambda : solution.forces.normal)
        raise(residual.negative_force, -lambda);
      residual.stationarity = quotient(unbalance, residual.force_scale);
    }

    // 2. The scale l.
    void
    measure_length_scale(const InterfaceProblem    &problem,
                         const InterfaceSolution   &solution,
                         const std::vector<double> &gaps,
                         KKTResidual               &residual)
    {
      const InterfaceVector &free = problem.free_displacement();
      for (unsigned int k = 0; k < problem.n_contacts(); ++k)
        {
          const InterfaceContact &contact = problem.contact(k);
          if (contact.is_out_of_reach())
            continue;
          const bool closed  = gaps[k] <= 0. || solution.forces.normal[k] != 0.;
          const auto add_row = [&](const SparseRow &row,
                                   const double     constant) {
            raise(residual.length_scale, row.absolute_dot(free));
            raise(residual.length_scale,
                  row.absolute_dot(solution.displacement));
            if (closed)
              raise(residual.length_scale, std::abs(constant));
          };
          add_row(contact.normal, contact.gap);
          if (contact.has_friction())
            for (unsigned int j = 0; j < contact.tangents.size(); ++j)
              add_row(contact.tangents[j], contact.slip[j]);
        }
    }

    // To what a solution with the factor of S can tell gaps and slips, m.
    double
    length_rounding(const InterfaceProblem &problem,
                    const KKTResidual      &residual)
    {
      return std::numeric_limits<double>::epsilon() * residual.length_scale /
             problem.stiffness().smallest_pivot();
    }

    // 4. Coulomb's law.
    void
    measure_friction(const InterfaceProblem  &problem,
                     const InterfaceSolution &solution,
                     const double             rounding,
                     KKTResidual             &residual)
    {
      for (unsigned int k = 0; k < solution.forces.tangential.size(); ++k)
        {
          const InterfaceContact      &contact = problem.contact(k);
          const std::array<double, 2> &tau     = solution.forces.tangential[k];
          const double                 bound =
            contact.friction_bound(solution.forces.normal[k]);
          raise(residual.friction_excess, std::hypot(tau[0], tau[1]) - bound);
          if (!contact.has_friction() || contact.is_out_of_reach())
            continue;
          // Without pressure there is no friction, whatever the slip.
          if (bound == 0.)
            {
              raise(residual.friction,
                    quotient(std::hypot(tau[0], tau[1]), residual.force_scale));
              continue;
            }
          const double          radius = quotient(bound, residual.force_scale);
          std::array<double, 2> force = {{0., 0.}}, moved = {{0., 0.}};
          for (unsigned int j = 0; j < contact.tangents.size(); ++j)
            {
              const double slip =
                beyond(problem.slip_after(k, j, solution.displacement),
                       contact.rounding + rounding);
              force[j] = quotient(tau[j], residual.force_scale);
              moved[j] = force[j] + quotient(slip, residual.length_scale);
            }
          const double length = std::hypot(moved[0], moved[1]);
          const double factor = length > radius ? radius / length : 1.;
          raise(residual.friction,
                std::hypot(force[0] - factor * moved[0],
                           force[1] - factor * moved[1]));
        }
    }
  } // namespace



  double
  KKTResidual::norm() const
  {
    double norm = 0.;
    raise(norm, stationarity);
    raise(norm, quotient(penetration, length_scale));
    raise(norm, quotient(negative_force, force_scale));
    raise(norm, complementarity);
    raise(norm, quotient(friction_excess, force_scale));
    raise(norm, friction);
    return norm;
  }



  KKTResidual
  kkt_residual(const InterfaceProblem  &problem,
               const InterfaceSolution &solution)
  {
    AssertDimension(solution.displacement.size(), problem.size());
    AssertDimension(solution.forces.normal.size(), problem.n_contacts());
    Assert(solution.forces.tangential.empty() ||
             solution.forces.tangential.size() == problem.n_contacts(),
           ExcDimensionMismatch(solution.forces.tangential.size(),
                                problem.n_contacts()));

    KKTResidual residual;
    measure_stationarity(problem, solution, residual);
    std::vector<double> gaps(problem.n_contacts());
    for (unsigned int k = 0; k < gaps.size(); ++k)
      gaps[k] = problem.gap_after(k, solution.displacement);
    measure_length_scale(problem, solution, gaps, residual);
    const double rounding = length_rounding(problem, residual);

    // 3. Penetration, and a force across an open gap. A product of the two
    // would pass a small force across a wide gap.
    for (unsigned int k = 0; k < gaps.size(); ++k)
      {
        if (problem.contact(k).is_out_of_reach())
          continue;
        const double gap =
          beyond(gaps[k], problem.contact(k).rounding + rounding);
        raise(residual.penetration, -gap);
        if (solution.forces.normal[k] > 0. && gap > 0.)
          raise(residual.complementarity,
                std::min(quotient(solution.forces.normal[k],
                                  residual.force_scale),
                         quotient(gap, residual.length_scale)));
      }
    measure_friction(problem, solution, rounding, residual);
    return residual;
  }
} // namespace Signorini
