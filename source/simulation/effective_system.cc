#include <signorini/input_error.h>
#include <signorini/linear_algebra/cholesky_condensation.h>
#include <signorini/linear_algebra/sparse_cholesky.h>
#include <signorini/simulation/effective_system.h>
#include <signorini/variational_inequality/kkt_residual.h>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // Weaker than this, the solutions of the interface problem have lost more
    // digits than the tolerances allow.
    constexpr double weakest_pivot = 1e-6;

    // False if the matrix is not positive definite, or too weak.
    bool
    set_if_definite(const FullMatrix<double> &matrix,
                    const double              weakest,
                    InterfaceProblem         &problem)
    {
      try
        {
          auto       stiffness = InterfaceStiffness::from_matrix(matrix);
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

    // Adds springs that resist any correction, as soft as it may be.
    void
    set_with_least_springs(FullMatrix<double> &matrix,
                           const double        largest,
                           InterfaceProblem   &problem)
    {
      double spring = 0.;
      while (!set_if_definite(matrix, weakest_pivot, problem))
        {
          const double next = std::max(1e-6 * largest, 3. * spring);
          for (unsigned int i = 0; i < matrix.m(); ++i)
            matrix(i, i) += next - spring;
          spring = next;
        }
    }

    double
    largest_diagonal(const FullMatrix<double> &matrix)
    {
      double largest = 0.;
      for (unsigned int i = 0; i < matrix.m(); ++i)
        largest = std::max(largest, matrix(i, i));
      return largest;
    }

    // stiffness += spring row^T row, force += spring target row^T: a spring
    // without force where row . du = target.
    void
    add_spring(const SparseRow    &row,
               const double        target,
               const double        spring,
               FullMatrix<double> &stiffness,
               Vector<double>     &force)
    {
      for (const auto &[i, a] : row)
        for (const auto &[j, b] : row)
          stiffness(i, j) += spring * a * b;
      row.add_to(force, spring * target);
    }
  } // namespace



  template <int dim>
  EffectiveSystem<dim>::EffectiveSystem(
    const SolidModel<dim>              &solid,
    const ContactModel<dim>            &contact,
    std::unique_ptr<InterfaceAlgorithm> algorithm,
    Timings                            &timings)
    : solid_(solid)
    , contact_(contact)
    , timings_(timings)
    , algorithm_(std::move(algorithm))
    , solver_(std::make_unique<CholeskyCondensation>())
    , is_factorised_(false)
    , may_be_weak_(false)
    , is_indefinite_(false)
    , indefinite_unknown_(0)
    , interface_spring_(0.)
    , last_softness_(0.)
    , section_factorisation_(timings.add("factorisation"))
    , section_substitution_(timings.add("substitution"))
    , section_interface_(timings.add("interface problem"))
  {
    const auto timing = timings_.measure("ordering");
    solver_->prepare(solid.sparsity(),
                     solid.is_fixed(),
                     contact.interface_dofs());
    matrix_.reinit(solid.sparsity());
  }



  template <int dim>
  void
  EffectiveSystem<dim>::factorise(const Factors              &factors,
                                  const SparseMatrix<double> *tangent)
  {
    if (is_factorised_ && !tangent && factors == factors_)
      return;
    const auto timing = timings_.measure(section_factorisation_);
    is_factorised_    = false;
    matrix_.copy_from(tangent ? *tangent : solid_.stiffness());
    matrix_ *= factors.stiffness;
    if (factors.mass != 0.)
      matrix_.add(factors.mass, solid_.mass());
    if (factors.damping != 0.)
      matrix_.add(factors.damping, solid_.damping());
    for (unsigned int i = solid_.first_lumped(); i < solid_.n_dofs(); ++i)
      matrix_.diag_element(i) *= factors.lumped;
    if (factors.mass == 0.)
      for (unsigned int i = 0; i < solid_.proximal_stiffness().size(); ++i)
        matrix_.diag_element(i) += solid_.proximal_stiffness()[i];
    is_indefinite_    = false;
    may_be_weak_      = tangent && factors.mass == 0.;
    interface_spring_ = 0.;
    try
      {
        solver_->factorise(matrix_);
      }
    catch (const NotPositiveDefinite &failure)
      {
        // Inertia makes K^ definite in steps that are short enough.
        if (!may_be_weak_)
          throw;
        is_indefinite_      = true;
        indefinite_unknown_ = failure.unknown;
        factorise_with_springs();
      }
    problem_.set_stiffness(solver_->interface_stiffness());
    stiffness_     = solver_->interface_stiffness();
    factors_       = factors;
    is_factorised_ = true;
  }



  template <int dim>
  void
  EffectiveSystem<dim>::factorise_with_springs()
  {
    const SparseMatrix<double> &initial   = solid_.stiffness();
    const auto                 &interface = contact_.interface_dofs();
    for (const unsigned int i : interface)
      interface_spring_ = std::max(interface_spring_, initial.diag_element(i));
    for (const unsigned int i : interface)
      matrix_.diag_element(i) += interface_spring_;
    // The softest that will do: the closer to the limit, the faster the
    // iteration leaves what is unstable.
    constexpr double smallest = 1e-10, largest = 1., growth = 3.;
    double           softness = 0.;
    while (true)
      try
        {
          solver_->factorise(matrix_);
          last_softness_ = softness;
          return;
        }
      catch (const NotPositiveDefinite &)
        {
          const double next =
            softness > 0. ?
              growth * softness :
              std::max(smallest, last_softness_ / (growth * growth));
          if (next > largest)
            throw;
          for (unsigned int i = 0; i < solid_.first_lumped(); ++i)
            matrix_.diag_element(i) +=
              (next - softness) * initial.diag_element(i);
          softness = next;
        }
  }



  template <int dim>
  typename EffectiveSystem<dim>::Correction
  EffectiveSystem<dim>::correct(const Vector<double>                 &residual,
                                const std::vector<ContactPoint<dim>> &points,
                                const InterfaceForces     &multipliers,
                                const std::vector<double> &coefficients)
  {
    Vector<double> reduced_force;
    {
      const auto timing = timings_.measure(section_substitution_);
      reduced_force     = solver_->condense(residual);
    }
    Correction        correction;
    InterfaceSolution solution;
    {
      const auto timing = timings_.measure(section_interface_);
      pose_interface_problem(points, multipliers, coefficients, reduced_force);
      solution = algorithm_->solve(problem_, multipliers);

      // The conditions of optimality are not those that a penalty obeys, or a
      // friction that creeps.
      correction.kkt_residual = algorithm_->obeys_the_law() ?
                                  kkt_residual(problem_, solution).norm() :
                                  0.;
    }
    const auto timing = timings_.measure(section_substitution_);
    correction.motion.reinit(residual.size());
    solver_->expand(solution.displacement, correction.motion);
    solid_.constraints().distribute(correction.motion);
    correction.multipliers       = std::move(solution.forces);
    correction.is_slipping       = std::move(solution.is_slipping);
    correction.fallback_contacts = std::move(solution.fallback_contacts);
    return correction;
  }



  template <int dim>
  void
  EffectiveSystem<dim>::pose_interface_problem(
    const std::vector<ContactPoint<dim>> &points,
    const InterfaceForces                &multipliers,
    const std::vector<double>            &coefficients,
    Vector<double>                       &reduced_force)
  {
    problem_.set_contacts(contact_.constraints(points, coefficients));
    const double weakest = may_be_weak_ ? weakest_pivot : 0.;
    if (contact_.is_flat() && interface_spring_ == 0. &&
        (!may_be_weak_ || stiffness_.smallest_pivot() > weakest))
      {
        problem_.set_reduced_force(reduced_force);
        return;
      }
    stiffness_.multiply_factor(reduced_force);
    const FullMatrix<double> plain     = stiffness_.matrix();
    FullMatrix<double>       stiffness = plain;
    for (unsigned int i = 0; i < stiffness.m(); ++i)
      stiffness(i, i) -= interface_spring_;
    contact_.add_geometric_stiffness(points, multipliers.normal, stiffness);
    if (set_if_definite(stiffness, weakest, problem_))
      {
        problem_.set_force(reduced_force);
        return;
      }
    hold_closed_contacts(multipliers,
                         largest_diagonal(plain),
                         stiffness,
                         reduced_force);
    set_with_least_springs(stiffness, largest_diagonal(plain), problem_);
    problem_.set_force(reduced_force);
  }



  template <int dim>
  void
  EffectiveSystem<dim>::hold_closed_contacts(const InterfaceForces &multipliers,
                                             const double           spring,
                                             FullMatrix<double>    &stiffness,
                                             Vector<double>        &force) const
  {
    for (unsigned int k = 0; k < problem_.n_contacts(); ++k)
      {
        const InterfaceContact &contact = problem_.contact(k);
        if (multipliers.normal[k] <= 0. || contact.is_out_of_reach())
          continue;
        add_spring(contact.normal, contact.gap, spring, stiffness, force);
        const auto  &friction = multipliers.tangential[k];
        const double bound    = contact.friction_bound(multipliers.normal[k]);
        if (std::hypot(friction[0], friction[1]) < 0.99 * bound)
          for (unsigned int j = 0; j < contact.tangents.size(); ++j)
            add_spring(
              contact.tangents[j], -contact.slip[j], spring, stiffness, force);
      }
  }



  template <int dim>
  Vector<double>
  EffectiveSystem<dim>::respond(const Vector<double> &force)
  {
    const auto     timing   = timings_.measure(section_substitution_);
    Vector<double> trailing = solver_->condense(force);
    stiffness_.solve_transposed_factor(trailing);
    Vector<double> motion(force.size());
    solver_->expand(trailing, motion);
    solid_.constraints().distribute(motion);
    return motion;
  }



  template class EffectiveSystem<2>;
  template class EffectiveSystem<3>;
} // namespace Signorini
