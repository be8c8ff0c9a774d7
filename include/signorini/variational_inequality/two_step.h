#ifndef signorini_variational_inequality_two_step_h
#define signorini_variational_inequality_two_step_h

#include <signorini/variational_inequality/coulomb_alternation.h>
#include <signorini/variational_inequality/interface_algorithm.h>

namespace Signorini
{
  /**
   * The two-step algorithm [MC, sec. 5.3]: solve_coulomb_alternating(). Gap
   * constraints are exact; friction is regularised, so that contacts that stick
   * creep by up to epsilon. Without friction it is the quadratic programme of
   * the gap constraints.
   */
  class TwoStep : public InterfaceAlgorithm
  {
  public:
    /** @throws InputError if a number is negative or not finite, or the
     * tolerance or the number of alternations is zero. */
    explicit TwoStep(const AlternationControl &control);

    std::string
    name() const override;

    bool
    enforces_exactly() const override;

    /** Not if a slip was chosen over which friction is regularised. */
    bool
    satisfies_coulomb() const override
    {
      return control.regularisation_slip == 0.;
    }

  private:
    /** @throws InputError for friction in three dimensions. */
    InterfaceSolution
    solve_closed(const InterfaceProblem &problem,
                 const InterfaceForces  &starting_forces) const override;

    AlternationControl control;
  };
} // namespace Signorini

#endif
