#ifndef signorini_run_contact_parameters_h
#define signorini_run_contact_parameters_h

#include <signorini/contact/contact_model.h>
#include <signorini/contact/rigid_body.h>
#include <signorini/input/entry_condition.h>
#include <signorini/input/space_time_function.h>
#include <signorini/run/pair_parameters.h>
#include <signorini/solid/solid_model.h>
#include <signorini/variational_inequality/algorithm_parameters.h>

#include <memory>
#include <string>
#include <vector>

namespace Signorini
{
  /** The section `Contact`. */
  struct ContactParameters
  {
    std::vector<std::string>    pairs; // as written
    AlgorithmParameters         algorithm;
    double                      relative_penalty_stiffness; // of the body's, 1
    double                      force_tolerance;            // 1
    std::vector<PairParameters> of_pairs;                   // one a pair

    /** @param pairs as written, each of which may have a section. */
    static void
    declare_parameters(const std::vector<std::string> &pairs,
                       dealii::ParameterHandler       &prm);

    /** Which entries are read under which choice. */
    static EntryConditions
    conditions();

    /** @throws InputError. */
    static ContactParameters
    parse(const Constants &constants, dealii::ParameterHandler &prm);
  };

  /**
   * Finds the bodies and the boundaries that the pairs name.
   * @throws InputError when there is none of that name.
   */
  template <int dim>
  std::unique_ptr<ContactModel<dim>>
  create_contact_model(
    const ContactParameters                            &parameters,
    const SolidModel<dim>                              &solid,
    const std::vector<std::unique_ptr<RigidBody<dim>>> &rigid_bodies);
} // namespace Signorini

#endif
