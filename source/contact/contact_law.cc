#include <signorini/contact/contact_law.h>
#include <signorini/input/instantiate.h>

#include <cmath>

namespace Signorini
{
  using namespace dealii;

  void
  ContactLaw::declare_parameters(const bool in_pair, ParameterHandler &prm)
  {
    FrictionLaw::declare_parameters(in_pair, prm);
    declare_contact_processes(in_pair, prm);
  }



  EntryConditions
  ContactLaw::conditions()
  {
    EntryConditions list = FrictionLaw::conditions();
    for (const EntryCondition &condition : contact_process_conditions())
      list.push_back(condition);
    return list;
  }



  ContactLaw
  ContactLaw::parse(const Constants &constants, const PairEntries &entries)
  {
    return {FrictionLaw::parse(constants, entries),
            parse_contact_processes(entries)};
  }



  double
  ContactLaw::largest_friction(const double area) const
  {
    const double stress = friction_.largest_shear_stress();
    return std::isfinite(stress) ? stress * area : stress;
  }



  double
  ContactLaw::recession(const ContactState &state, const unsigned int k) const
  {
    double recession = 0.;
    for (const auto &process : processes_)
      recession +=
        process->recession(state.quantities.at(process->quantity().name)[k]);
    return recession;
  }



  template <int dim>
  void
  ContactLaw::advance(const double             step_size,
                      const ContactPoint<dim> &point,
                      const unsigned int       k,
                      ContactState            &state) const
  {
    std::array<double, 2> slip = {{0., 0.}};
    if (state.forces.normal[k] > 0.)
      slip = point.slip;
    else
      state.slips[k] = slip;
    for (unsigned int j = 0; j < 2; ++j)
      state.slips[k][j] += slip[j];
    const double way    = std::hypot(slip[0], slip[1]);
    state.slip_rates[k] = way / step_size;
    state.slip_ways[k]  = state.is_slipping[k] ? state.slip_ways[k] + way : 0.;
    for (const auto &process : processes_)
      {
        double &value = state.quantities.at(process->quantity().name)[k];
        value         = process->advance(
          value, {step_size, point.pressure(state.forces.normal[k]), way});
      }
  }



#define INSTANTIATE(dim)                                       \
  template void ContactLaw::advance(const double,              \
                                    const ContactPoint<dim> &, \
                                    const unsigned int,        \
                                    ContactState &) const;
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
