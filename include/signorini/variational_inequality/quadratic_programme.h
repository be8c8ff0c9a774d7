#ifndef signorini_variational_inequality_quadratic_programme_h
#define signorini_variational_inequality_quadratic_programme_h

#include <signorini/variational_inequality/interface_algorithm.h>

namespace Signorini
{
  /**
   * The gap constraints without friction, exactly: sub-problem I of
   * [MC, eq. 50], solved for the contact forces (the dual, see solve_dual()).
   * Closed gaps are zero to about 1e-15 of the displacement, forces are not
   * negative, and constraints may be redundant.
   */
  class QuadraticProgramme : public InterfaceAlgorithm
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
