#include <signorini/dynamics/condensed_contact_system.h>
#include <signorini/input/input_error.h>
#include <signorini/input/instantiate.h>
#include <signorini/linear_algebra/cholesky_condensation.h>
#include <signorini/linear_algebra/sparse_cholesky.h>
#include <signorini/variational_inequality/interface_algorithm.h>
#include <signorini/variational_inequality/interface_problem_io.h>
#include <signorini/variational_inequality/kkt_residual.h>
#include <signorini/variational_inequality/solution_refinement.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // The weakest pivot that a stiffness may have. Weaker than the first, the
    // solutions of the interface problem lose more digits than the tolerances
    // allow; but slender bodies are weak by nature, and only what is far weaker
    // than they are without a load is about to lose its stiffness.
    double
    weakest_of(const InterfaceStiffness &unloaded)
    {
      return std::clamp(1e-2 * unloaded.smallest_pivot(), 1e-13, 1e-6);
    }

    // Mean diagonal entry of the unknowns that a mode moves; zero if none of
    // them has a stiffness.
    double
    mean_stiffness(const DofMatrix &stiffness, const DofVector &mode)
    {
      double       sum = 0.;
      unsigned int n   = 0;
      for (unsigned int i = 0; i < mode.size(); ++i)
        if (mode[i] != 0. && stiffness.diag_element(i) > 0.)
          {
            sum += stiffness.diag_element(i);
            ++n;
          }
      return n > 0 ? sum / n : 0.;
    }

    // Rigid bodies have no stiffness of their own: theirs is the smallest.
    void
    replace_zeros(std::vector<double> &stiffnesses, const double otherwise)
    {
      double smallest = otherwise;
      for (const double stiffness : stiffnesses)
        if (stiffness > 0.)
          smallest = std::min(smallest, stiffness);
      for (double &stiffness : stiffnesses)
        if (stiffness == 0.)
          stiffness = smallest;
    }

    InterfaceVector
    restrict_to(const std::vector<unsigned int> &unknowns,
                const DofVector                 &values)
    {
      InterfaceVector result(unknowns.size());
      for (unsigned int i = 0; i < unknowns.size(); ++i)
        result[i] = values[unknowns[i]];
      return result;
    }

  } // namespace



  template <int dim>
  CondensedContactSystem<dim>::CondensedContactSystem(
    const SolidModel<dim>              &solid,
    const ContactModel<dim>            &contact,
    std::unique_ptr<InterfaceAlgorithm> algorithm,
    const bool                          is_static,
    Timings                            &timings)
    : solid_(solid)
    , contact_(contact)
    , timings_(timings)
    , algorithm_(std::move(algorithm))
    , mass_(&solid.mass())
    , may_lack_mass_(false)
    , solver_(std::make_unique<CholeskyCondensation>())
    , is_factorised_(false)
    , may_be_weak_(false)
    , is_indefinite_(false)
    , indefinite_unknown_(0)
    , last_softness_(0.)
    , weakest_pivot_(0.)
    , trailing_(contact.interface_dofs())
    , section_factorisation_(timings.add("factorisation"))
    , section_substitution_(timings.add("substitution"))
    , section_interface_(timings.add("interface problem"))
  {
    const auto timing = timings_.measure("ordering");
    if (is_static)
      pin_free_modes();
    trailing_spring_.reinit(trailing_.size());
    solver_->prepare(solid.sparsity(),
                     solid.dof_map().constrained(),
                     trailing_);
    matrix_.reinit(solid.sparsity());
  }



  template <int dim>
  void
  CondensedContactSystem<dim>::pin_free_modes()
  {
    const DofVector        at_start(solid_.n_dofs());
    std::vector<DofVector> motions;
    for (auto &mode : solid_.free_modes(at_start))
      {
        mode_stiffness_.push_back(
          mean_stiffness(solid_.stiffness(), mode.motion));
        motions.push_back(std::move(mode.motion));
      }
    DofVector everything(solid_.n_dofs());
    everything = 1.;
    replace_zeros(mode_stiffness_,
                  mean_stiffness(solid_.stiffness(), everything));
    const auto pins = FreeModes::pins(motions, solid_.dof_map());
    for (const unsigned int pin : pins)
      {
        const auto found = std::find(trailing_.begin(), trailing_.end(), pin);
        pins_.push_back(found - trailing_.begin());
        if (found == trailing_.end())
          trailing_.push_back(pin);
      }
    place(at_start);
  }



  template <int dim>
  void
  CondensedContactSystem<dim>::place(const DofVector &displacement)
  {
    if (pins_.empty())
      return;
    std::vector<InterfaceVector> modes;
    for (const auto &mode : solid_.free_modes(displacement))
      modes.push_back(restrict_to(trailing_, mode.motion));
    free_modes_ = FreeModes(modes, mode_stiffness_);
  }



  template <int dim>
  void
  CondensedContactSystem<dim>::use_mass(const DofMatrix &mass,
                                        const bool       is_everywhere)
  {
    is_factorised_ = is_factorised_ && mass_ == &mass;
    mass_          = &mass;
    may_lack_mass_ = !is_everywhere;
  }



  template <int dim>
  void
  CondensedContactSystem<dim>::factorise(const SystemFactors &factors,
                                         const DofMatrix     *tangent)
  {
    if (is_factorised_ && !tangent && factors == factors_)
      return;
    const auto timing = timings_.measure(section_factorisation_);
    is_factorised_    = false;
    matrix_.copy_from(tangent ? *tangent : solid_.stiffness());
    matrix_ *= factors.stiffness;
    if (factors.mass != 0.)
      matrix_.add(factors.mass, *mass_);
    if (factors.damping != 0.)
      matrix_.add(factors.damping, solid_.damping());
    for (unsigned int i = solid_.dof_map().n_body_dofs(); i < solid_.n_dofs();
         ++i)
      matrix_.diag_element(i) *= factors.rigid;
    is_indefinite_   = false;
    may_be_weak_     = tangent && (factors.mass == 0. || may_lack_mass_);
    trailing_spring_ = 0.;
    for (unsigned int k = 0; k < pins_.size(); ++k)
      add_spring(pins_[k], mode_stiffness_[k]);
    try
      {
        solver_->factorise(matrix_);
      }
    catch (const NotPositiveDefinite &failure)
      {
        // Inertia makes K^ definite in steps that are short enough, but for
        // nodes without mass.
        if (!may_be_weak_)
          throw;
        is_indefinite_      = true;
        indefinite_unknown_ = failure.unknown;
        factorise_with_springs();
      }
    problem_.set_stiffness(solver_->interface_stiffness());
    has_plain_stiffness_ = true;
    stiffness_           = solver_->interface_stiffness();
    if (factors.mass == 0. && weakest_pivot_ == 0.)
      weakest_pivot_ = weakest_of(stiffness_);
    factors_       = factors;
    is_factorised_ = true;
  }



  template <int dim>
  void
  CondensedContactSystem<dim>::add_spring(const unsigned int trailing,
                                          const double       spring)
  {
    matrix_.diag_element(trailing_[trailing]) += spring;
    trailing_spring_[trailing] += spring;
  }



  template <int dim>
  void
  CondensedContactSystem<dim>::factorise_with_springs()
  {
    const DofMatrix &initial = solid_.stiffness();
    for (unsigned int i = 0; i < trailing_.size(); ++i)
      add_spring(i, initial.diag_element(trailing_[i]));
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
          for (unsigned int i = 0; i < solid_.dof_map().n_body_dofs(); ++i)
            matrix_.diag_element(i) +=
              (next - softness) * initial.diag_element(i);
          softness = next;
        }
  }



  template <int dim>
  ContactCorrection
  CondensedContactSystem<dim>::correct(
    const DofVector                      &residual,
    const std::vector<ContactPoint<dim>> &points,
    const InterfaceForces                &multipliers,
    const ContactState                   &at_start)
  {
    InterfaceVector reduced_force;
    {
      const auto timing = timings_.measure(section_substitution_);
      reduced_force     = solver_->condense(residual);
    }
    ContactCorrection correction;
    InterfaceSolution solution;
    {
      const auto timing = timings_.measure(section_interface_);
      problem_.set_contacts(contact_.constraints(points, at_start));
      solution = solve_interface_problem(points, multipliers, reduced_force);

      // The conditions of optimality are not those that a penalty obeys, or a
      // friction that creeps.
      correction.kkt_residual =
        algorithm_->satisfies_coulomb() ? residual_of_refined(solution) : 0.;
    }
    const auto timing = timings_.measure(section_substitution_);
    correction.motion.reinit(residual.size());
    solver_->expand(solution.displacement, correction.motion);
    solid_.dof_map().constraints().distribute(correction.motion);
    correction.multipliers       = std::move(solution.forces);
    correction.is_slipping       = std::move(solution.is_slipping);
    correction.fallback_contacts = std::move(solution.fallback_contacts);
    return correction;
  }



  template <int dim>
  double
  CondensedContactSystem<dim>::residual_of_refined(
    InterfaceSolution &solution) const
  {
    // More digits than this no tolerance asks for.
    constexpr double   enough     = 1e-10;
    constexpr unsigned most_steps = 3;
    double             residual   = kkt_residual(problem_, solution).norm();
    for (unsigned int step = 0; step < most_steps && residual > enough; ++step)
      {
        InterfaceSolution refined = solution;
        if (!refine(problem_, refined))
          break;
        const double next = kkt_residual(problem_, refined).norm();
        if (!(next < residual))
          break;
        residual = next;
        solution = std::move(refined);
      }
    return residual;
  }



  template <int dim>
  DofVector
  CondensedContactSystem<dim>::respond(const DofVector &force)
  {
    const auto      timing   = timings_.measure(section_substitution_);
    InterfaceVector trailing = solver_->condense(force);
    stiffness_.solve_transposed_factor(trailing);
    DofVector motion(force.size());
    solver_->expand(trailing, motion);
    solid_.dof_map().constraints().distribute(motion);
    return motion;
  }



  template <int dim>
  void
  CondensedContactSystem<dim>::write_last_problem(std::ostream &stream) const
  {
    if (problem_.size() > 0)
      write_interface_problem(problem_, stream);
  }



  template <int dim>
  std::unique_ptr<ContactSystem<dim>>
  make_contact_system(const SolidModel<dim>     &solid,
                      const ContactModel<dim>   &contact,
                      const AlgorithmParameters &algorithm,
                      const bool                 is_static,
                      Timings                   &timings)
  {
    return std::make_unique<CondensedContactSystem<dim>>(
      solid, contact, make_interface_algorithm(algorithm), is_static, timings);
  }



#define INSTANTIATE(dim)                                            \
  template class CondensedContactSystem<dim>;                       \
  template std::unique_ptr<ContactSystem<dim>> make_contact_system( \
    const SolidModel<dim> &,                                        \
    const ContactModel<dim> &,                                      \
    const AlgorithmParameters &,                                    \
    const bool,                                                     \
    Timings &);
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
