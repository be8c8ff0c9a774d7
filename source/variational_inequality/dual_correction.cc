// The part of DualIteration that finds new forces on the working set.
#include <signorini/variational_inequality/bound_constrained_qp.h>
#include <signorini/variational_inequality/interface_error.h>
#include <signorini/variational_inequality/interface_types.h>

#include <algorithm>
#include <limits>

#include "dual_iteration.h"

namespace Signorini
{
  using namespace dealii;

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
    const unsigned int     m = working_set.size();
    const InterfaceMatrix &kept =
      problem.compliance_matrix(working_set, false).matrix();
    InterfaceMatrix soft;
    if (terms.compliance != 0.)
      {
        soft = kept;
        soft.diagadd(terms.compliance);
      }
    const InterfaceMatrix &W = terms.compliance != 0. ? soft : kept;
    std::vector<double>    d(m), start(m);
    for (unsigned int i = 0; i < m; ++i)
      start[i] = solution.forces.normal[working_set[i]];
    for (unsigned int i = 0; i < m; ++i)
      {
        d[i] = excess[working_set[i]];
        for (unsigned int j = 0; j < m; ++j)
          d[i] += W(i, j) * start[j];
      }

    const BoundConstrainedSolution result = solve_bound_constrained_qp(
      W, d, start, std::numeric_limits<double>::epsilon() * length_scale);
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
    std::vector<double> x;
    const CoulombSystem system = coulomb_system(x);
    DenseFactor &factor = problem.compliance_matrix(working_set, true).factor();
    if (is_first_correction)
      factor.settle();
    is_first_correction          = false;
    const CoulombSolution result = method(system, x, factor);
    solution.n_iterations += result.n_iterations;
    if (!result.solved && add_all())
      {
        // What jams alone may be pushed open by others.
        correct_all_forces();
        return;
      }
    if (!result.solved)
      fail("Friction: the search for the contacts that stick or slip came back "
           "to a state it had seen, and no other way led to a solution either. "
           "A smaller step or less friction helps",
           contacts_at(result.suspects));
    law_tolerance = result.law_tolerance;
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



  std::vector<unsigned int>
  DualIteration::contacts_at(const std::vector<unsigned int> &positions) const
  {
    std::vector<unsigned int> contacts;
    for (const unsigned int i : positions)
      contacts.push_back(working_set[i]);
    return contacts;
  }



  void
  DualIteration::fail(const std::string        &message,
                      std::vector<unsigned int> contacts)
  {
    std::sort(contacts.begin(), contacts.end());
    throw InterfaceError(message, contacts);
  }
} // namespace Signorini
