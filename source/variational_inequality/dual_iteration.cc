#include "dual_iteration.h"

#include <signorini/variational_inequality/bound_constrained_qp.h>
#include <signorini/variational_inequality/interface_error.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    constexpr double epsilon = std::numeric_limits<double>::epsilon();

    // Relative to the length scale: what is aimed at, and what is accepted
    // where the constraints are nearly redundant and rounding allows no more.
    constexpr double target_accuracy   = 16. * epsilon;
    constexpr double accepted_accuracy = 1e-10;

    [[noreturn]] void
    fail(const std::string &message, std::vector<unsigned int> contacts)
    {
      std::sort(contacts.begin(), contacts.end());
      throw InterfaceError(message, contacts);
    }
  } // namespace



  DualIteration::DualIteration(const InterfaceProblem &problem,
                               const InterfaceForces  &starting_forces,
                               const CoulombMethod    &method,
                               const bool              exact,
                               const DualTerms        &terms)
    : problem(problem)
    , method(method)
    , exact(exact)
    , terms(terms)
    , excess(problem.n_contacts())
    , slip_left(problem.n_contacts())
    , in_working_set(problem.n_contacts(), 0)
  {
    const std::vector<double> &starting = starting_forces.normal;
    Assert(starting.empty() || starting.size() == problem.n_contacts(),
           ExcDimensionMismatch(starting.size(), problem.n_contacts()));
    Assert(terms.offsets.empty() ||
             terms.offsets.size() == problem.n_contacts(),
           ExcDimensionMismatch(terms.offsets.size(), problem.n_contacts()));
    solution.forces = InterfaceForces(problem.n_contacts());
    for (unsigned int k = 0; k < starting.size(); ++k)
      if (starting[k] > 0. && !problem.contact(k).is_out_of_reach())
        {
          solution.forces.normal[k] = starting[k];
          if (has_friction(k) &&
              starting_forces.tangential.size() == starting.size())
            for (unsigned int j = 0; j < problem.contact(k).tangents.size();
                 ++j)
              solution.forces.tangential[k][j] =
                starting_forces.tangential[k][j];
          add_to_working_set(k);
        }
  }



  InterfaceSolution
  DualIteration::run()
  {
    update();
    if (working_set.empty() && !add_violated())
      return std::move(solution);

    double last_error = std::numeric_limits<double>::max();
    while (true)
      {
        correct_forces();
        update();
        // The working set only grows, so that this ends.
        if (add_violated())
          {
            last_error = std::numeric_limits<double>::max();
            continue;
          }
        const double error = working_set_error();
        if (error <= target_accuracy * length_scale)
          break;
        // No better than before: this is all that rounding allows.
        if (error >= 0.5 * last_error)
          {
            if (error <= accepted_accuracy * length_scale)
              break;
            fail("Contact forces: the gaps of closed contacts do not reach "
                 "zero, because constraints are nearly redundant. A smaller "
                 "step or a coarser contactor surface helps",
                 working_set);
          }
        last_error = error;
      }
    std::sort(solution.fallback_contacts.begin(),
              solution.fallback_contacts.end());
    solution.fallback_contacts.erase(
      std::unique(solution.fallback_contacts.begin(),
                  solution.fallback_contacts.end()),
      solution.fallback_contacts.end());
    return std::move(solution);
  }



  void
  DualIteration::update()
  {
    problem.prepare_responses(working_set, static_cast<bool>(method));
    solution.displacement = problem.free_displacement();
    for (const unsigned int k : working_set)
      {
        if (solution.forces.normal[k] > 0.)
          solution.displacement.add(-solution.forces.normal[k],
                                    problem.response(k));
        if (has_friction(k))
          for (unsigned int j = 0; j < problem.contact(k).tangents.size(); ++j)
            if (solution.forces.tangential[k][j] != 0.)
              solution.displacement.add(-solution.forces.tangential[k][j],
                                        problem.tangent_response(k, j));
      }
    // Every comparison with NaN is false: such a problem would pass for one
    // without contact. A contact out of reach is as open as can be.
    double sum = 0.;
    for (unsigned int k = 0; k < problem.n_contacts(); ++k)
      {
        const InterfaceContact &contact = problem.contact(k);
        excess[k] = offset(k) - problem.gap_after(k, solution.displacement) -
                    terms.compliance * solution.forces.normal[k];
        if (contact.is_out_of_reach())
          continue;
        sum += excess[k];
        if (has_friction(k) && in_working_set[k] != 0)
          for (unsigned int j = 0; j < contact.tangents.size(); ++j)
            {
              slip_left[k][j] =
                problem.slip_after(k, j, solution.displacement) +
                slip_offset(k, j) -
                terms.tangential_compliance * solution.forces.tangential[k][j];
              sum += slip_left[k][j];
            }
      }
    if (!std::isfinite(sum))
      fail("Contact forces: a gap, a slip or a force is not a finite number. A "
           "smaller step helps",
           {});
  }



  double
  DualIteration::length(const unsigned int k) const
  {
    const InterfaceContact &contact = problem.contact(k);
    const Vector<double>   &free    = problem.free_displacement();
    double length = contact.normal.absolute_dot(free) + std::abs(contact.gap) +
                    std::abs(offset(k));
    if (has_friction(k))
      for (unsigned int j = 0; j < contact.tangents.size(); ++j)
        length =
          std::max(length,
                   contact.tangents[j].absolute_dot(free) +
                     std::abs(contact.slip[j]) + std::abs(slip_offset(k, j)));
    return length;
  }



  void
  DualIteration::add_to_working_set(const unsigned int k)
  {
    in_working_set[k] = 1;
    working_set.push_back(k);
    length_scale        = std::max(length_scale, length(k));
    friction_is_settled = false;
  }



  bool
  DualIteration::add_violated()
  {
    const unsigned int old_size  = working_set.size();
    const double       threshold = target_accuracy * length_scale;
    for (unsigned int k = 0; k < problem.n_contacts(); ++k)
      if (in_working_set[k] == 0 && excess[k] > threshold &&
          (old_size == 0 || excess[k] > target_accuracy * length(k)))
        add_to_working_set(k);
    if (working_set.size() == old_size)
      return false;
    if (working_set_has_friction())
      update(); // the slips of the new ones
    return true;
  }



  bool
  DualIteration::working_set_has_friction() const
  {
    return std::any_of(working_set.begin(),
                       working_set.end(),
                       [this](const unsigned int k) {
                         return has_friction(k);
                       });
  }



  void
  DualIteration::correct_forces()
  {
    if (working_set_has_friction() && !friction_is_settled)
      correct_all_forces();
    else
      correct_normal_forces();
    friction_is_settled = !exact;
  }



  void
  DualIteration::correct_normal_forces()
  {
    // d is formed from the gaps of the present displacement, not from those
    // without contact: the first face then solves for a correction only,
    // which is iterative refinement.
    const unsigned int        m = working_set.size();
    const FullMatrix<double> &kept =
      problem.compliance_matrix(working_set, false).matrix();
    FullMatrix<double> soft;
    if (terms.compliance != 0.)
      {
        soft = kept;
        soft.diagadd(terms.compliance);
      }
    const FullMatrix<double> &W = terms.compliance != 0. ? soft : kept;
    std::vector<double>       d(m), start(m);
    for (unsigned int i = 0; i < m; ++i)
      start[i] = solution.forces.normal[working_set[i]];
    for (unsigned int i = 0; i < m; ++i)
      {
        d[i] = excess[working_set[i]];
        for (unsigned int j = 0; j < m; ++j)
          d[i] += W(i, j) * start[j];
      }

    const BoundConstrainedSolution result =
      solve_bound_constrained_qp(W, d, start, epsilon * length_scale);
    if (result.outcome == QPOutcome::unbounded)
      fail("Contact forces grow without bound: the constraints contradict "
           "each other, as between two surfaces that leave no room. A "
           "smaller step or a larger clearance helps",
           contacts_at(result.suspects));
    if (result.outcome == QPOutcome::stalled)
      fail("Contact forces: the search for the closed contacts came back to "
           "a set it had seen. A smaller step helps",
           contacts_at(result.suspects));
    solution.n_iterations += result.n_iterations;
    for (unsigned int i = 0; i < m; ++i)
      solution.forces.normal[working_set[i]] = result.x[i];
  }



  CoulombSystem
  DualIteration::coulomb_system(std::vector<double> &x) const
  {
    ComplianceMatrix &compliance = problem.compliance_matrix(working_set, true);
    std::vector<DualContact> contacts;
    std::vector<double>      soft, left;
    x.clear();
    for (const unsigned int k : working_set)
      {
        const InterfaceContact &contact = problem.contact(k);
        DualContact             dual;
        dual.row = x.size();
        x.push_back(solution.forces.normal[k]);
        left.push_back(excess[k]);
        soft.push_back(terms.compliance);
        if (has_friction(k))
          {
            dual.n_tangents           = contact.tangents.size();
            dual.friction_coefficient = contact.friction_coefficient;
            dual.largest_friction     = contact.largest_friction;
            for (unsigned int j = 0; j < dual.n_tangents; ++j)
              {
                x.push_back(solution.forces.tangential[k][j]);
                left.push_back(slip_left[k][j]);
                soft.push_back(terms.tangential_compliance);
              }
          }
        contacts.push_back(dual);
      }
    // As for the normal forces: d from what is left, so that a solution is a
    // correction.
    const CoulombSystem       homogeneous(compliance.matrix(),
                                    contacts,
                                    soft,
                                    std::vector<double>(x.size(), 0.),
                                    0.);
    const std::vector<double> minus_Wx = homogeneous.residual(x);
    for (unsigned int i = 0; i < x.size(); ++i)
      left[i] -= minus_Wx[i];
    return CoulombSystem(
      compliance.matrix(), contacts, soft, std::move(left), length_scale);
  }



  void
  DualIteration::correct_all_forces()
  {
    std::vector<double>   x;
    const CoulombSystem   system = coulomb_system(x);
    const CoulombSolution result =
      method(system, x, problem.compliance_matrix(working_set, true).factor());
    solution.n_iterations += result.n_iterations;
    if (!result.solved)
      fail("Friction: the search for the contacts that stick or slip came back "
           "to a state it had seen, and no other way led to a solution either. "
           "A smaller step or less friction helps",
           contacts_at(result.suspects));
    if (result.fell_back)
      {
        ++solution.n_fallbacks;
        for (const unsigned int k : contacts_at(result.suspects))
          solution.fallback_contacts.push_back(k);
      }
    for (unsigned int i = 0; i < working_set.size(); ++i)
      {
        const unsigned int k   = working_set[i];
        const DualContact &row = system.contact(i);
        // Rounding below zero is no force; a state without force has none.
        solution.forces.normal[k] = std::max(result.x[row.row], 0.);
        for (unsigned int j = 0; j < row.n_tangents; ++j)
          solution.forces.tangential[k][j] = result.x[row.row + 1 + j];
      }
  }



  double
  DualIteration::working_set_error() const
  {
    if (exact && working_set_has_friction())
      {
        std::vector<double> x;
        const CoulombSystem system = coulomb_system(x);
        std::vector<double> left;
        for (const unsigned int k : working_set)
          {
            left.push_back(excess[k]);
            if (has_friction(k))
              for (unsigned int j = 0; j < problem.contact(k).tangents.size();
                   ++j)
                left.push_back(slip_left[k][j]);
          }
        return system.error(x, left);
      }
    double error = 0.;
    for (const unsigned int k : working_set)
      error = std::max(error,
                       solution.forces.normal[k] > 0. ? std::abs(excess[k]) :
                                                        excess[k]);
    return error;
  }



  std::vector<unsigned int>
  DualIteration::contacts_at(const std::vector<unsigned int> &positions) const
  {
    std::vector<unsigned int> contacts;
    for (const unsigned int i : positions)
      contacts.push_back(working_set[i]);
    return contacts;
  }
} // namespace Signorini
