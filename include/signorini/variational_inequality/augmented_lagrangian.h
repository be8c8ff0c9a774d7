#ifndef signorini_variational_inequality_augmented_lagrangian_h
#define signorini_variational_inequality_augmented_lagrangian_h

#include <signorini/variational_inequality/interface_algorithm.h>

namespace Signorini
{
  /**
   * Uzawa's loop around the penalty method [MC, sec. 2]:
   * lambda_k <- (lambda_k + K_N (A_k du - G_k))+ and
   * tau_k <- P(tau_k + K_T slip_k), where P projects on the disc of radius
   * f_k, and du is the displacement under these new forces. Each update is the
   * dual with the compliances 1 / K_N, 1 / K_T, the gaps moved by
   * lambda_k / K_N and the slips by tau_k / K_T. Ends when no contact
   * penetrates, none with a force is open, and no slip differs from that of
   * Coulomb's law, |tau_k - old tau_k| / K_T, by more than the tolerance.
   */
  class AugmentedLagrangian : public InterfaceAlgorithm
  {
  public:
    /**
     * @param stiffness K_N, N/m.
     * @param penetration_tolerance m.
     * @param maximal_iterations updates of lambda.
     * @param tangential_stiffness K_T, N/m; 0: the same as K_N.
     * @throws InputError unless all are positive and finite.
     */
    AugmentedLagrangian(const double       stiffness,
                        const double       penetration_tolerance,
                        const unsigned int maximal_iterations,
                        const double       tangential_stiffness = 0.);

    std::string
    name() const override;

    bool
    enforces_exactly() const override;

  private:
    /** @throws InterfaceError at the maximal number of iterations. */
    InterfaceSolution
    solve_closed(const InterfaceProblem &problem,
                 const InterfaceForces  &starting_forces) const override;

    // Contacts that penetrate, are open under a force, or slip otherwise than
    // Coulomb's law says, beyond the tolerance.
    std::vector<unsigned int>
    unsettled(const InterfaceProblem  &problem,
              const InterfaceForces   &old_forces,
              const InterfaceSolution &solution) const;

    double       stiffness;
    double       tangential_stiffness;
    double       penetration_tolerance;
    unsigned int maximal_iterations;
  };
} // namespace Signorini

#endif
