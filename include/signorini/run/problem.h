#ifndef signorini_run_problem_h
#define signorini_run_problem_h

#include <signorini/contact/contact_model.h>
#include <signorini/contact/rigid_body.h>
#include <signorini/input/unread_entries.h>
#include <signorini/linear_algebra/types.h>
#include <signorini/run/adaptivity_parameters.h>
#include <signorini/run/contact_parameters.h>
#include <signorini/run/output_parameters.h>
#include <signorini/run/problem_outline.h>
#include <signorini/solid/solid_model.h>
#include <signorini/time/time_parameters.h>

#include <memory>
#include <string>
#include <vector>

namespace Signorini
{
  /** Declares every section and entry of a problem of this outline. */
  template <int dim>
  void
  declare_problem_parameters(const ProblemOutline     &outline,
                             dealii::ParameterHandler &prm);

  /** Which of them are read under which choice. */
  template <int dim>
  ConditionList
  problem_conditions(const ProblemOutline &outline);

  /** A whole .prm, made into objects: all that a run needs to begin. */
  template <int dim>
  struct Problem
  {
    std::string                                  title;
    TimeParameters                               time;
    ContactParameters                            contact_parameters;
    AdaptivityParameters                         adaptivity;
    Constants                                    constants;
    OutputParameters<dim>                        output;
    std::vector<std::unique_ptr<RigidBody<dim>>> rigid_bodies;
    std::unique_ptr<SolidModel<dim>>             solid;
    std::unique_ptr<ContactModel<dim>>           contact;
    DofVector                                    initial_displacement; // m
    DofVector                                    initial_velocity;     // m/s

    /**
     * Makes the objects from a handler into which the file was applied.
     * @param directory of the .prm, where paths in it start
     * @param passes refinements of each body beside those of the file; empty
     *               for none
     * @throws InputError.
     */
    static Problem
    create(const ProblemOutline                &outline,
           const std::string                   &directory,
           const std::vector<RefinementPasses> &passes,
           dealii::ParameterHandler            &prm);
  };
} // namespace Signorini

#endif
