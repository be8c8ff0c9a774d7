#ifndef signorini_variational_inequality_penalty_h
#define signorini_variational_inequality_penalty_h

#include <signorini/variational_inequality/interface_algorithm.h>

namespace Signorini
{
  /**
   * Contact elements with a normal stiffness [MC, sec. 2]:
   * lambda_k = K_N (A_k du - G_k)+. The minimum of
   * 1/2 du^T S du - du^T r + K_N / 2 sum_k ((A_k du - G_k)+)^2,
   * from the dual with the compliance 1 / K_N.
   */
  class Penalty : public InterfaceAlgorithm
  {
  public:
    /** @param stiffness K_N, N/m.
     * @throws InputError unless it is positive and finite. */
    explicit Penalty(const double stiffness);

    std::string
    name() const override;

    bool
    enforces_exactly() const override;

  private:
    InterfaceSolution
    solve_closed(const InterfaceProblem &problem,
                 const InterfaceForces  &starting_forces) const override;

    double stiffness;
  };
} // namespace Signorini

#endif
