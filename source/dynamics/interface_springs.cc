// The part of CondensedContactSystem that solves the interface problem, with
// springs where its stiffness is not positive definite by itself.
#include <signorini/dynamics/condensed_contact_system.h>
#include <signorini/input/input_error.h>
#include <signorini/input/instantiate.h>
#include <signorini/variational_inequality/interface_types.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // What a soft body holds is weak against a stiff one, too.
    double
    weakest_held(const double                          weakest,
                 const std::vector<FreeModes::Spring> &held,
                 const InterfaceMatrix                &stiffness)
    {
      double ratio = 1.;
      for (const auto &[row, spring] : held)
        for (const auto &[i, a] : row)
          if (stiffness(i, i) > 0.)
            ratio = std::min(ratio, spring / stiffness(i, i));
      return std::min(weakest, std::max(1e-2 * ratio, 1e-13));
    }

    // False if the matrix is not positive definite, or too weak.
    bool
    set_if_definite(InterfaceMatrix   matrix,
                    const double      weakest,
                    InterfaceProblem &problem)
    {
      try
        {
          auto stiffness = InterfaceStiffness::from_matrix(std::move(matrix));
          const bool is_strong =
            weakest == 0. || stiffness.smallest_pivot() > weakest;
          if (is_strong)
            problem.set_stiffness(std::move(stiffness));
          return is_strong;
        }
      catch (const ComputationError &)
        {
          return false;
        }
    }

    // Forces on a curved surface turn, and change their places, as it is moved
    // along.
    template <int dim>
    bool
    has_geometric_stiffness(const std::vector<ContactPoint<dim>> &points,
                            const std::vector<double>            &normal_forces)
    {
      for (unsigned int k = 0; k < normal_forces.size(); ++k)
        if (normal_forces[k] != 0. && !points[k].curvatures.empty())
          return true;
      return false;
    }

    double
    largest_diagonal(const InterfaceMatrix &matrix)
    {
      double largest = 0.;
      for (unsigned int i = 0; i < matrix.m(); ++i)
        largest = std::max(largest, matrix(i, i));
      return largest;
    }

    // Adds springs that resist any correction, as soft as it may be, and
    // returns theirs.
    double
    set_with_least_springs(InterfaceMatrix  &matrix,
                           const double      weakest,
                           InterfaceProblem &problem)
    {
      const double largest = largest_diagonal(matrix);
      double       spring  = 0.;
      while (!set_if_definite(matrix, weakest, problem))
        {
          const double next = std::max(1e-6 * largest, 3. * spring);
          for (unsigned int i = 0; i < matrix.m(); ++i)
            matrix(i, i) += next - spring;
          spring = next;
        }
      return spring;
    }

    // Of the nodes of a contact, one after the other: that of the softest.
    double
    series_stiffness(const SparseRow &row, const InterfaceMatrix &stiffness)
    {
      double compliance = 0.;
      for (const auto &[i, a] : row)
        if (stiffness(i, i) > 0.)
          compliance += a * a / stiffness(i, i);
      return compliance > 0. ? 1. / compliance : largest_diagonal(stiffness);
    }
  } // namespace



  template <int dim>
  InterfaceSolution
  CondensedContactSystem<dim>::solve_interface_problem(
    const std::vector<ContactPoint<dim>> &points,
    const InterfaceForces                &multipliers,
    InterfaceVector                      &reduced_force)
  {
    const bool is_as_factorised =
      !has_geometric_stiffness(points, multipliers.normal) &&
      (trailing_.empty() || trailing_spring_.all_zero()) &&
      (!may_be_weak_ || stiffness_.smallest_pivot() > weakest_pivot_);
    if (is_as_factorised)
      {
        if (!has_plain_stiffness_)
          problem_.set_stiffness(InterfaceStiffness(stiffness_));
        has_plain_stiffness_ = true;
        problem_.set_reduced_force(reduced_force);
        return algorithm_->solve(problem_, multipliers);
      }
    has_plain_stiffness_ = false;
    stiffness_.multiply_factor(reduced_force);
    if (!free_modes_.empty() ||
        !set_if_definite(interface_stiffness(points, multipliers),
                         weakest_pivot_,
                         problem_))
      return solve_with_springs(interface_stiffness(points, multipliers),
                                reduced_force,
                                multipliers);
    problem_.set_force(reduced_force);
    return algorithm_->solve(problem_, multipliers);
  }



  template <int dim>
  InterfaceMatrix
  CondensedContactSystem<dim>::interface_stiffness(
    const std::vector<ContactPoint<dim>> &points,
    const InterfaceForces                &multipliers) const
  {
    InterfaceMatrix stiffness = stiffness_.matrix();
    for (unsigned int i = 0; i < stiffness.m(); ++i)
      stiffness(i, i) -= trailing_spring_[i];
    for (const StiffnessBlock &block :
         contact_.geometric_stiffness(points, multipliers.normal))
      block.add_to(stiffness);
    return stiffness;
  }



  template <int dim>
  InterfaceSolution
  CondensedContactSystem<dim>::solve_with_springs(
    const InterfaceMatrix &stiffness,
    const InterfaceVector &force,
    const InterfaceForces &multipliers)
  {
    constexpr unsigned int most_passes = 10;
    InterfaceForces        forces      = multipliers;
    InterfaceVector        centre(force.size());
    double                 last_borne = std::numeric_limits<double>::max();
    for (unsigned int pass = 1;; ++pass)
      {
        // 1. Closed contacts hold the bodies, and springs what these do not
        std::vector<Spring> springs;
        std::vector<double> rests; // row . du without a force
        if (algorithm_->enforces_exactly())
          hold_closed_contacts(forces, stiffness, springs, rests);
        // Later they are where the pass before left them, which may creep.
        for (unsigned int s = 0; s < springs.size() && pass > 1; ++s)
          rests[s] = springs[s].row.dot(centre);
        const double weakest = weakest_held(weakest_pivot_, springs, stiffness);
        for (auto &spring : free_modes_.springs(springs))
          {
            rests.push_back(spring.row.dot(centre));
            springs.push_back(std::move(spring));
          }
        InterfaceMatrix held(stiffness);
        InterfaceVector held_force(force);
        for (unsigned int s = 0; s < springs.size(); ++s)
          {
            const auto &[row, spring] = springs[s];
            for (const auto &[i, a] : row)
              for (const auto &[j, b] : row)
                held(i, j) += spring * a * b;
            row.add_to(held_force, spring * rests[s]);
          }
        const double least = set_with_least_springs(held, weakest, problem_);

        // 2. The contact problem with them
        problem_.set_force(held_force);
        InterfaceSolution solution = algorithm_->solve(problem_, forces);

        // 3. Once more, until they bear nothing. Where the stiffness is
        // indefinite, this would lead away from the linearisation.
        InterfaceVector borne(force.size());
        for (unsigned int s = 0; s < springs.size(); ++s)
          springs[s].row.add_to(borne,
                                springs[s].stiffness *
                                  (springs[s].row.dot(solution.displacement) -
                                   rests[s]));
        const double size   = borne.linfty_norm();
        const bool   is_new = size < 0.5 * last_borne;
        if (least > 0. || size <= 1e-12 * problem_.force().linfty_norm() ||
            !is_new || pass == most_passes)
          return solution;
        last_borne = size;
        centre     = solution.displacement;
        forces     = std::move(solution.forces);
      }
  }



  template <int dim>
  void
  CondensedContactSystem<dim>::hold_closed_contacts(
    const InterfaceForces &forces,
    const InterfaceMatrix &stiffness,
    std::vector<Spring>   &springs,
    std::vector<double>   &rests) const
  {
    const auto hold = [&](const SparseRow &row, const double rest) {
      springs.push_back({row, series_stiffness(row, stiffness)});
      rests.push_back(rest);
    };
    for (unsigned int k = 0; k < problem_.n_contacts(); ++k)
      {
        const InterfaceContact &contact = problem_.contact(k);
        if (forces.normal[k] <= 0. || contact.is_out_of_reach())
          continue;
        hold(contact.normal, contact.gap);
        if (forces.tangential.empty())
          continue;
        const auto  &friction = forces.tangential[k];
        const double bound    = contact.friction_bound(forces.normal[k]);
        if (std::hypot(friction[0], friction[1]) < 0.99 * bound)
          for (unsigned int j = 0; j < contact.tangents.size(); ++j)
            hold(contact.tangents[j], -contact.slip[j]);
      }
  }



#define INSTANTIATE(dim)                                                  \
  template InterfaceSolution CondensedContactSystem<                      \
    dim>::solve_interface_problem(const std::vector<ContactPoint<dim>> &, \
                                  const InterfaceForces &,                \
                                  InterfaceVector &);
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
