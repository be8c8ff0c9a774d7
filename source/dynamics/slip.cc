#include <signorini/dynamics/slip.h>
#include <signorini/input/instantiate.h>

#include <cmath>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  std::vector<double>
  friction_coefficients(const ContactModel<dim> &contact, const State &state)
  {
    std::vector<double> coefficients(contact.n_contacts());
    for (const auto &pair : contact.pairs())
      for (unsigned int n = 0; n < pair.contactor.nodes.size(); ++n)
        {
          const unsigned int k = pair.first_contact + n;
          coefficients[k] = pair.friction.coefficient(state.is_slipping[k] == 0,
                                                      state.slip_rates[k],
                                                      state.slip_ways[k]);
        }
    return coefficients;
  }



  template <int dim>
  void
  find_initial_slip(const std::vector<ContactPoint<dim>> &points, State &state)
  {
    const double rounding = 1e-10 * state.velocity.linfty_norm();
    for (unsigned int k = 0; k < points.size(); ++k)
      if (state.contact_forces.normal[k] > 0.)
        {
          double square = 0.;
          for (const SparseRow &row : points[k].slip_gradients)
            square += std::pow(row.dot(state.velocity), 2);
          state.slip_rates[k]  = std::sqrt(square);
          state.is_slipping[k] = state.slip_rates[k] > rounding;
        }
  }



  template <int dim>
  void
  measure_slip(const double                          step_size,
               const std::vector<ContactPoint<dim>> &points,
               State                                &state)
  {
    for (unsigned int k = 0; k < points.size(); ++k)
      {
        std::array<double, 2> slip = {{0., 0.}};
        if (state.contact_forces.normal[k] > 0.)
          slip = points[k].slip;
        else
          state.slips[k] = slip;
        for (unsigned int j = 0; j < 2; ++j)
          state.slips[k][j] += slip[j];
        const double way    = std::hypot(slip[0], slip[1]);
        state.slip_rates[k] = way / step_size;
        state.slip_ways[k] =
          state.is_slipping[k] ? state.slip_ways[k] + way : 0.;
      }
  }



#define INSTANTIATE(dim)                                                  \
  template std::vector<double> friction_coefficients(                     \
    const ContactModel<dim> &, const State &);                            \
  template void find_initial_slip(const std::vector<ContactPoint<dim>> &, \
                                  State &);                               \
  template void measure_slip(const double,                                \
                             const std::vector<ContactPoint<dim>> &,      \
                             State &);
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
