#include <signorini/input_error.h>
#include <signorini/linear_algebra/cholesky_condensation.h>
#include <signorini/simulation/effective_system.h>
#include <signorini/variational_inequality/kkt_residual.h>

namespace Signorini
{
  using namespace dealii;

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
    solver_->factorise(matrix_);
    problem_.set_stiffness(solver_->interface_stiffness());
    stiffness_     = solver_->interface_stiffness();
    factors_       = factors;
    is_factorised_ = true;
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
    if (contact_.is_flat())
      {
        problem_.set_reduced_force(reduced_force);
        return;
      }
    problem_.set_stiffness(
      stiffness_with_curvature(points, multipliers.normal));
    stiffness_.multiply_factor(reduced_force);
    problem_.set_force(reduced_force);
  }



  template <int dim>
  InterfaceStiffness
  EffectiveSystem<dim>::stiffness_with_curvature(
    const std::vector<ContactPoint<dim>> &points,
    const std::vector<double>            &normal_forces) const
  {
    const FullMatrix<double> plain     = stiffness_.matrix();
    FullMatrix<double>       stiffness = plain;
    contact_.add_geometric_stiffness(points, normal_forces, stiffness);
    try
      {
        return InterfaceStiffness::from_matrix(stiffness);
      }
    catch (const ComputationError &)
      {
        return InterfaceStiffness::from_matrix(plain);
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
