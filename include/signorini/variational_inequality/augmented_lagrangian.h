#ifndef signorini_variational_inequality_augmented_lagrangian_h
#define signorini_variational_inequality_augmented_lagrangian_h

#include <signorini/variational_inequality/interface_algorithm.h>

namespace Signorini
{
  /**
   * Uzawa's loop around the penalty method [MC, sec. 2]:
   * lambda_k <- (lambda_k + K_N (A_k du - G_k))+, where du minimises
   * 1/2 du^T S du - du^T r + 1/(2 K_N) sum_k ((lambda_k + K_N (A_k du -
   * G_k))+)^2 for the lambda before. Each minimum is the dual with the
   * compliance 1 / K_N and the gaps moved by lambda_k / K_N. Ends when no
   * contact penetrates, and none with a force is open, by more than the
   * tolerance.
   */
  class AugmentedLagrangian : public InterfaceAlgorithm
  {
  public:
    /**
     * @param stiffness K_N, N/m.
     * @param penetration_tolerance m.
     * @param maximal_iterations updates of lambda.
     * @throws InputError unless all three are positive and finite.
     */
    AugmentedLagrangian(const double       stiffness,
                        const double       penetration_tolerance,
                        const unsigned int maximal_iterations);

    std::string
    name() const override;

    bool
    enforces_exactly() const override;

  private:
    /** @throws InterfaceError at the maximal number of iterations. */
    InterfaceSolution
    solve_closed(const InterfaceProblem &problem,
                 const InterfaceForces  &starting_forces) const override;

    // Contacts that penetrate, or are open under a force, beyond the tolerance.
    std::vector<unsigned int>
    unsettled(const InterfaceProblem  &problem,
              const InterfaceSolution &solution) const;

    double       stiffness;
    double       penetration_tolerance;
    unsigned int maximal_iterations;
  };
} // namespace Signorini

#endif
