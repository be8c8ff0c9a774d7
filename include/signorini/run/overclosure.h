#ifndef signorini_run_overclosure_h
#define signorini_run_overclosure_h

#include <signorini/contact/contact_model.h>
#include <signorini/linear_algebra/types.h>
#include <signorini/run/pair_parameters.h>

#include <string>
#include <vector>

namespace Signorini
{
  /**
   * Does what the .prm says with nodes inside of their target at t = 0.
   * @throws InputError where the pair refuses them, or a held node is one.
   */
  template <int dim>
  void
  treat_overclosure(const std::vector<PairParameters> &parameters,
                    const DofVector                   &displacement,
                    ContactModel<dim>                 &contact);

  /**
   * A line for each pair at t = 0: contactor nodes, how many see the target,
   * the smallest gap, how much overclosure is taken away, and whether the two
   * surfaces face each other.
   */
  template <int dim>
  std::string
  describe_pairs(const ContactModel<dim> &contact,
                 const DofVector         &displacement);
} // namespace Signorini

#endif
