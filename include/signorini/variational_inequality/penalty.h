#ifndef signorini_variational_inequality_penalty_h
#define signorini_variational_inequality_penalty_h

#include <signorini/variational_inequality/interface_algorithm.h>

namespace Signorini
{
  /**
   * Contact elements with a normal and a tangential stiffness [MC, sec. 2]:
   * lambda_k = K_N (A_k du - G_k)+, and tau_k is K_T slip_k, cut off at the
   * friction bound f_k. Without friction it is the minimum of
   * 1/2 du^T S du - du^T r + K_N / 2 sum_k ((A_k du - G_k)+)^2.
   * From the dual with the compliances 1 / K_N and 1 / K_T, so that no matrix
   * is spoilt by a large stiffness.
   */
  class Penalty : public InterfaceAlgorithm
  {
  public:
    /** @param stiffness K_N, N/m.
     * @param tangential_stiffness K_T, N/m; 0: the same as K_N.
     * @throws InputError unless they are positive and finite. */
    explicit Penalty(const double stiffness,
                     const double tangential_stiffness = 0.);

    std::string
    name() const override;

    bool
    enforces_exactly() const override;

  private:
    InterfaceSolution
    solve_closed(const InterfaceProblem &problem,
                 const InterfaceForces  &starting_forces) const override;

    double stiffness;
    double tangential_stiffness;
  };
} // namespace Signorini

#endif
