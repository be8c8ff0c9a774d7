#include "dual_iteration.h"

#include <signorini/variational_inequality/coulomb_newton.h>
#include <signorini/variational_inequality/interface_types.h>

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
    solution.is_slipping.resize(problem.n_contacts());
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
    check_friction();
    mark_slipping();
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
    const InterfaceVector  &free    = problem.free_displacement();
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
  DualIteration::add_all()
  {
    const unsigned int old_size = working_set.size();
    for (unsigned int k = 0; k < problem.n_contacts(); ++k)
      if (in_working_set[k] == 0 && !problem.contact(k).is_out_of_reach())
        add_to_working_set(k);
    if (working_set.size() == old_size)
      return false;
    solution.forces = InterfaceForces(problem.n_contacts());
    update();
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



  double
  DualIteration::working_set_error() const
  {
    if (exact && working_set_has_friction())
      return coulomb_error();
    double error = 0.;
    for (const unsigned int k : working_set)
      error = std::max(error,
                       solution.forces.normal[k] > 0. ? std::abs(excess[k]) :
                                                        excess[k]);
    return error;
  }



  double
  DualIteration::coulomb_error() const
  {
    std::vector<double> x, left;
    const CoulombSystem system = coulomb_system(x);
    for (const unsigned int k : working_set)
      {
        left.push_back(excess[k]);
        if (has_friction(k))
          for (unsigned int j = 0; j < problem.contact(k).tangents.size(); ++j)
            left.push_back(slip_left[k][j]);
      }
    return system.error(x, left);
  }



  void
  DualIteration::mark_slipping()
  {
    if (!working_set_has_friction())
      return;
    std::vector<double> x;
    const CoulombSystem system = coulomb_system(x);
    const auto          states = contact_states(system, x, system.residual(x));
    const double        stick =
      std::max(law_tolerance, target_accuracy * length_scale);
    for (unsigned int i = 0; i < working_set.size(); ++i)
      {
        const auto &slip = slip_left[working_set[i]];
        solution.is_slipping[working_set[i]] =
          states[i].kind == ContactState::slip &&
          std::hypot(slip[0], slip[1]) > stick;
      }
  }



  void
  DualIteration::check_friction() const
  {
    if (exact || !working_set_has_friction())
      return;
    const double tolerance =
      10. * law_tolerance + accepted_accuracy * length_scale;
    if (!(coulomb_error() <= tolerance))
      fail("Friction: the friction forces do not fit the normal forces, as "
           "between contacts that jam. A smaller step or less friction helps",
           working_set);
  }
} // namespace Signorini
