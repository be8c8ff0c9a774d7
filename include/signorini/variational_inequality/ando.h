#ifndef signorini_variational_inequality_ando_h
#define signorini_variational_inequality_ando_h

#include <signorini/variational_inequality/interface_algorithm.h>

namespace Signorini
{
  /**
   * The one-step algorithm with artificial cutting planes for nondifferentiable
   * optimisation [MC, sec. 5.4]: solve_coulomb_ando(). Gap constraints, stick
   * and slip are exact. Without friction it is the quadratic programme of the
   * gap constraints.
   *
   * The planes need a slip with a sign: a problem with two tangents and
   * friction is refused.
   */
  class Ando : public InterfaceAlgorithm
  {
  public:
    std::string
    name() const override;

    bool
    enforces_exactly() const override;

  private:
    /** @throws InputError for friction in three dimensions. */
    InterfaceSolution
    solve_closed(const InterfaceProblem &problem,
                 const InterfaceForces  &starting_forces) const override;
  };
} // namespace Signorini

#endif
