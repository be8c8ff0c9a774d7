#ifndef signorini_variational_inequality_semismooth_newton_h
#define signorini_variational_inequality_semismooth_newton_h

#include <signorini/variational_inequality/interface_algorithm.h>

namespace Signorini
{
  /**
   * Gap constraints and Coulomb's friction together, exactly, in two and three
   * dimensions: Newton's method on the dual with the friction bound inside
   * (solve_coulomb_newton()). If it comes back to a state, a globally
   * convergent method takes its place (solve_coulomb_fallback()). Without
   * friction it is the quadratic programme of the gap constraints.
   */
  class SemismoothNewton : public InterfaceAlgorithm
  {
  public:
    std::string
    name() const override;

    bool
    enforces_exactly() const override;

  private:
    InterfaceSolution
    solve_closed(const InterfaceProblem &problem,
                 const InterfaceForces  &starting_forces) const override;
  };
} // namespace Signorini

#endif
