#include <signorini/variational_inequality/solution_refinement.h>

#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // A contact force that may change, and what it must not change.
    struct ActiveRow
    {
      unsigned int contact;
      int          tangent; // none: the normal
      double       rest;    // gap, or slip with the other sign, m
    };

    bool
    slips(const InterfaceContact &contact,
          const InterfaceForces  &forces,
          const unsigned int      k)
    {
      const auto  &tau   = forces.tangential[k];
      const double bound = contact.friction_bound(forces.normal[k]);
      return std::hypot(tau[0], tau[1]) >= (1. - 1e-12) * bound;
    }

    std::vector<ActiveRow>
    active_rows(const InterfaceProblem  &problem,
                const InterfaceSolution &solution)
    {
      std::vector<ActiveRow> rows;
      for (unsigned int k = 0; k < problem.n_contacts(); ++k)
        {
          const InterfaceContact &contact = problem.contact(k);
          if (contact.is_out_of_reach() || solution.forces.normal[k] <= 0.)
            continue;
          rows.push_back({k, -1, problem.gap_after(k, solution.displacement)});
          if (contact.has_friction() && !slips(contact, solution.forces, k))
            for (unsigned int j = 0; j < contact.tangents.size(); ++j)
              rows.push_back(
                {k, int(j), -problem.slip_after(k, j, solution.displacement)});
        }
      return rows;
    }

    const SparseRow &
    kinematic_row(const InterfaceProblem &problem, const ActiveRow &row)
    {
      const InterfaceContact &contact = problem.contact(row.contact);
      return row.tangent < 0 ? contact.normal : contact.tangents[row.tangent];
    }

    // How the tangential forces of a contact that slips follow the normal one.
    std::array<double, 2>
    friction_of_normal(const InterfaceProblem &problem,
                       const InterfaceForces  &forces,
                       const ActiveRow        &row)
    {
      const InterfaceContact &contact = problem.contact(row.contact);
      if (row.tangent >= 0 || !contact.has_friction() ||
          !slips(contact, forces, row.contact))
        return {{0., 0.}};
      const auto  &tau    = forces.tangential[row.contact];
      const double size   = std::hypot(tau[0], tau[1]);
      const double normal = forces.normal[row.contact];
      const bool   is_limited =
        contact.friction_coefficient * normal > contact.largest_friction;
      const double factor =
        size > 0. && !is_limited ? contact.friction_coefficient / size : 0.;
      return {{factor * tau[0], factor * tau[1]}};
    }

    // r - S du - A^T lambda - T^T tau.
    InterfaceVector
    unbalanced_force(const InterfaceProblem  &problem,
                     const InterfaceSolution &solution)
    {
      InterfaceVector product(solution.displacement);
      problem.stiffness().multiply(product);
      InterfaceVector force(problem.force());
      force -= product;
      for (unsigned int k = 0; k < problem.n_contacts(); ++k)
        {
          const InterfaceContact &contact = problem.contact(k);
          contact.normal.add_to(force, -solution.forces.normal[k]);
          if (!solution.forces.tangential.empty())
            for (unsigned int j = 0; j < contact.tangents.size(); ++j)
              contact.tangents[j].add_to(force,
                                         -solution.forces.tangential[k][j]);
        }
      return force;
    }

    // S^-1 times the force of a unit of a row.
    InterfaceVector
    response(const InterfaceProblem      &problem,
             const ActiveRow             &row,
             const std::array<double, 2> &friction)
    {
      if (row.tangent >= 0)
        return problem.tangent_response(row.contact, row.tangent);
      InterfaceVector result(problem.response(row.contact));
      for (unsigned int j = 0; j < 2; ++j)
        if (friction[j] != 0.)
          result.add(friction[j], problem.tangent_response(row.contact, j));
      return result;
    }
  } // namespace



  bool
  refine(const InterfaceProblem &problem, InterfaceSolution &solution)
  {
    const auto      rows   = active_rows(problem, solution);
    InterfaceVector motion = unbalanced_force(problem, solution);
    problem.stiffness().solve(motion);
    if (!rows.empty())
      {
        const unsigned int                 n = rows.size();
        std::vector<std::array<double, 2>> frictions;
        std::vector<InterfaceVector>       responses;
        for (const ActiveRow &row : rows)
          {
            frictions.push_back(
              friction_of_normal(problem, solution.forces, row));
            responses.push_back(response(problem, row, frictions.back()));
          }
        InterfaceMatrix compliance(n);
        InterfaceVector lack(n), change(n);
        for (unsigned int a = 0; a < n; ++a)
          {
            const SparseRow &row = kinematic_row(problem, rows[a]);
            lack[a]              = row.dot(motion) - rows[a].rest;
            for (unsigned int b = 0; b < n; ++b)
              compliance(a, b) = row.dot(responses[b]);
          }
        try
          {
            compliance.gauss_jordan();
          }
        catch (const InterfaceMatrix::ExcNotRegular &)
          {
            return false;
          }
        compliance.vmult(change, lack);
        for (unsigned int a = 0; a < n; ++a)
          {
            const ActiveRow &row = rows[a];
            motion.add(-change[a], responses[a]);
            if (row.tangent >= 0)
              solution.forces.tangential[row.contact][row.tangent] += change[a];
            else
              {
                solution.forces.normal[row.contact] += change[a];
                for (unsigned int j = 0; j < 2; ++j)
                  if (frictions[a][j] != 0.)
                    solution.forces.tangential[row.contact][j] +=
                      change[a] * frictions[a][j];
              }
          }
      }
    solution.displacement += motion;
    return true;
  }
} // namespace Signorini
