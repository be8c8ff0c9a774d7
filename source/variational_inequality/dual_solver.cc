#include <signorini/variational_inequality/bound_constrained_qp.h>
#include <signorini/variational_inequality/dual_solver.h>
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

    class DualSolver
    {
    public:
      DualSolver(const InterfaceProblem    &problem,
                 const std::vector<double> &starting_forces,
                 const DualTerms           &terms);

      InterfaceSolution
      run();

    private:
      double
      offset(const unsigned int k) const
      {
        return terms.offsets.empty() ? 0. : terms.offsets[k];
      }

      // du, and e_k = A_k du - G_k + o_k - c lambda_k for every contact.
      void
      update();

      void
      add_to_working_set(const unsigned int k);

      // Adds every other contact with e_k > 0; false if there is none.
      bool
      add_violated();

      // New forces on the working set, from the gaps as they are.
      void
      correct_forces();

      // The size of the numbers that cancel in e_k.
      double
      length(const unsigned int k) const;

      // max |e_k| where there is a force, (e_k)+ elsewhere.
      double
      working_set_error() const;

      // The contacts at the given positions of the working set.
      std::vector<unsigned int>
      contacts_at(const std::vector<unsigned int> &positions) const;

      [[noreturn]] static void
      fail(const std::string &message, std::vector<unsigned int> contacts);

      const InterfaceProblem &problem;
      const DualTerms        &terms;

      InterfaceSolution         solution;
      std::vector<double>       excess;
      std::vector<char>         in_working_set;
      std::vector<unsigned int> working_set;
      double                    length_scale = 0.;
    };



    DualSolver::DualSolver(const InterfaceProblem    &problem,
                           const std::vector<double> &starting_forces,
                           const DualTerms           &terms)
      : problem(problem)
      , terms(terms)
      , excess(problem.n_contacts())
      , in_working_set(problem.n_contacts(), 0)
    {
      Assert(starting_forces.empty() ||
               starting_forces.size() == problem.n_contacts(),
             ExcDimensionMismatch(starting_forces.size(),
                                  problem.n_contacts()));
      Assert(terms.offsets.empty() ||
               terms.offsets.size() == problem.n_contacts(),
             ExcDimensionMismatch(terms.offsets.size(), problem.n_contacts()));
      solution.forces = InterfaceForces(problem.n_contacts());
      for (unsigned int k = 0; k < starting_forces.size(); ++k)
        if (starting_forces[k] > 0.)
          {
            solution.forces.normal[k] = starting_forces[k];
            add_to_working_set(k);
          }
    }



    InterfaceSolution
    DualSolver::run()
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
      return std::move(solution);
    }



    void
    DualSolver::update()
    {
      problem.prepare_responses(working_set);
      solution.displacement = problem.free_displacement();
      for (const unsigned int k : working_set)
        if (solution.forces.normal[k] > 0.)
          solution.displacement.add(-solution.forces.normal[k],
                                    problem.response(k));
      // Every comparison with NaN is false: such a problem would pass for one
      // without contact. A contact out of reach is as open as can be.
      double sum = 0.;
      for (unsigned int k = 0; k < problem.n_contacts(); ++k)
        {
          excess[k] = offset(k) - problem.gap_after(k, solution.displacement) -
                      terms.compliance * solution.forces.normal[k];
          if (problem.contact(k).normal.size() > 0)
            sum += excess[k];
        }
      if (!std::isfinite(sum))
        fail("Contact forces: a gap or a force is not a finite number. A "
             "smaller step helps",
             {});
    }



    double
    DualSolver::length(const unsigned int k) const
    {
      const InterfaceContact &contact = problem.contact(k);
      return contact.normal.absolute_dot(problem.free_displacement()) +
             std::abs(contact.gap) + std::abs(offset(k));
    }



    void
    DualSolver::add_to_working_set(const unsigned int k)
    {
      in_working_set[k] = 1;
      working_set.push_back(k);
      length_scale = std::max(length_scale, length(k));
    }



    bool
    DualSolver::add_violated()
    {
      const unsigned int old_size  = working_set.size();
      const double       threshold = target_accuracy * length_scale;
      for (unsigned int k = 0; k < problem.n_contacts(); ++k)
        if (in_working_set[k] == 0 && excess[k] > threshold &&
            (old_size == 0 || excess[k] > target_accuracy * length(k)))
          add_to_working_set(k);
      if (working_set.size() == old_size)
        return false;
      problem.prepare_responses(working_set);
      return true;
    }



    void
    DualSolver::correct_forces()
    {
      // d is formed from the gaps of the present displacement, not from those
      // without contact: the first face then solves for a correction only,
      // which is iterative refinement.
      const unsigned int  m = working_set.size();
      FullMatrix<double>  W(m, m);
      std::vector<double> d(m), start(m);
      for (unsigned int i = 0; i < m; ++i)
        {
          for (unsigned int j = 0; j <= i; ++j)
            W(i, j) = W(j, i) =
              problem.compliance(working_set[i], working_set[j]);
          W(i, i) += terms.compliance;
          start[i] = solution.forces.normal[working_set[i]];
        }
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



    double
    DualSolver::working_set_error() const
    {
      double error = 0.;
      for (const unsigned int k : working_set)
        error = std::max(error,
                         solution.forces.normal[k] > 0. ? std::abs(excess[k]) :
                                                          excess[k]);
      return error;
    }



    std::vector<unsigned int>
    DualSolver::contacts_at(const std::vector<unsigned int> &positions) const
    {
      std::vector<unsigned int> contacts;
      for (const unsigned int i : positions)
        contacts.push_back(working_set[i]);
      return contacts;
    }



    void
    DualSolver::fail(const std::string        &message,
                     std::vector<unsigned int> contacts)
    {
      std::sort(contacts.begin(), contacts.end());
      throw InterfaceError(message, contacts);
    }
  } // namespace



  InterfaceSolution
  solve_dual(const InterfaceProblem    &problem,
             const std::vector<double> &starting_forces,
             const DualTerms           &terms)
  {
    return DualSolver(problem, starting_forces, terms).run();
  }
} // namespace Signorini
