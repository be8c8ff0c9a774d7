#include <signorini/dynamics/step_contact.h>
#include <signorini/input/instantiate.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  StepContact<dim>::StepContact(const ContactModel<dim>       &contact,
                                const State                   &old_state,
                                std::vector<ContactPoint<dim>> old_points,
                                const State                   &state,
                                const std::vector<ContactPoint<dim>> &points,
                                const double                          old_share)
    : old_share_(old_share)
    , share_(1. - old_share_)
    , contact_(contact)
    , old_state_(old_state)
    , old_points_(std::move(old_points))
    , state_(state)
    , points_(points)
    , motion_(state.displacement)
  {
    motion_ -= old_state.displacement;
  }



  template <int dim>
  double
  StepContact<dim>::work() const
  {
    DofVector force(motion_.size());
    if (old_share_ != 0.)
      contact_.add_contact_forces(old_points_,
                                  old_state_.contact.forces,
                                  old_share_,
                                  force);
    contact_.add_contact_forces(points_, state_.contact.forces, share_, force);
    return motion_ * force;
  }



  template <int dim>
  double
  StepContact<dim>::tangential_work() const
  {
    double work = 0.;
    for (unsigned int k = 0; k < points_.size(); ++k)
      for (unsigned int j = 0; j < dim - 1; ++j)
        work -= points_[k].slip[j] *
                (old_share_ * old_state_.contact.forces.tangential[k][j] +
                 share_ * state_.contact.forces.tangential[k][j]);
    return work;
  }



  template <int dim>
  double
  StepContact<dim>::friction() const
  {
    double taken = 0.;
    for (unsigned int k = 0; k < points_.size(); ++k)
      {
        double of_contact = 0.;
        for (unsigned int j = 0; j < dim - 1; ++j)
          of_contact +=
            points_[k].slip[j] *
            (old_share_ * old_state_.contact.forces.tangential[k][j] +
             share_ * state_.contact.forces.tangential[k][j]);
        taken += std::max(0., of_contact);
      }
    return taken;
  }



  template <int dim>
  double
  StepContact<dim>::wear() const
  {
    double taken = 0.;
    for (unsigned int k = 0; k < points_.size(); ++k)
      taken +=
        (old_share_ * old_state_.contact.forces.normal[k] +
         share_ * state_.contact.forces.normal[k]) *
        (state_.contact.recessions[k] - old_state_.contact.recessions[k]);
    return taken;
  }



  template <int dim>
  double
  StepContact<dim>::undue_work() const
  {
    double work = 0.;
    for (const auto &pair : contact_.pairs())
      for (unsigned int n = 0; n < pair.contactor.nodes.size(); ++n)
        {
          const unsigned int k = pair.first_contact + n;
          const double       old_force =
            old_share_ * old_state_.contact.forces.normal[k];
          const double force = share_ * state_.contact.forces.normal[k];
          const double change =
            state_.contact.gaps[k] - old_state_.contact.gaps[k];
          // A gap out of reach is infinite.
          if (pair.target->unknowns().empty() && std::isfinite(change))
            {
              work += (old_force + force) * change;
              continue;
            }
          work += pair_work(old_share_, old_state_, old_points_, k) +
                  pair_work(share_, state_, points_, k);
        }
    return work;
  }



  template <int dim>
  double
  StepContact<dim>::pair_work(const double                          share,
                              const State                          &state,
                              const std::vector<ContactPoint<dim>> &points,
                              const unsigned int                    k) const
  {
    double work = 0.;
    if (share == 0. || state.contact.forces.normal[k] == 0.)
      return work;
    work = state.contact.forces.normal[k] * points[k].gap_gradient.dot(motion_);
    for (unsigned int j = 0; j < dim - 1; ++j)
      work += state.contact.forces.tangential[k][j] *
              (points_[k].slip[j] - points[k].slip_gradients[j].dot(motion_));
    return share * work;
  }



  template <int dim>
  InterfaceForces
  StepContact<dim>::normal_forces() const
  {
    InterfaceForces forces(state_.contact.forces.normal);
    for (unsigned int k = 0; k < forces.normal.size(); ++k)
      forces.normal[k] = old_share_ * old_state_.contact.forces.normal[k] +
                         share_ * forces.normal[k];
    return forces;
  }



#define INSTANTIATE(dim) template class StepContact<dim>;
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
