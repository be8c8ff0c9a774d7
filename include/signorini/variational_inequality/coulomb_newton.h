#ifndef signorini_variational_inequality_coulomb_newton_h
#define signorini_variational_inequality_coulomb_newton_h

#include <signorini/variational_inequality/coulomb_system.h>
#include <signorini/variational_inequality/dense_factor.h>

#include <array>
#include <vector>

namespace Signorini
{
  /** What a contact does, as Newton's method takes it for granted. */
  struct ContactState
  {
    enum Kind
    {
      open,
      stick, // closed without slip; also closed without friction
      slip
    };

    Kind                  kind      = open;
    bool                  capped    = false;      // f = largest friction
    std::array<double, 2> direction = {{0., 0.}}; // of the slip, 1

    bool
    operator==(const ContactState &other) const
    {
      return kind == other.kind && capped == other.capped &&
             direction == other.direction;
    }
  };

  /** The states that the forces @p x and y = d - (W + C) x suggest: open unless
   * w lambda + e > 0, stick if w tau + v lies in the disc of radius
   * w f(lambda + e / w), otherwise slip along it [AlartCurnier1991]. */
  std::vector<ContactState>
  contact_states(const CoulombSystem       &system,
                 const std::vector<double> &x,
                 const std::vector<double> &y);

  /**
   * Semismooth Newton method on Coulomb's law, with the bound f(lambda) inside:
   * each iteration solves the linear system of the states that the last point
   * suggests (contact_states()). With one tangent a state makes the law linear,
   * so that the method ends exactly when a state confirms itself; a state that
   * comes back before is a cycle and ends it without solution. With two, the
   * projection on the disc is linearised, in the form whose Jacobian stays
   * bounded away from singular [HueberStadlerWohlmuth2008].
   *
   * @param start where the search begins; only the states that it suggests
   *   matter with one tangent.
   * @param factor keeps the last linear system, which often is the next one.
   * @param most_iterations linear systems to try.
   */
  CoulombSolution
  solve_coulomb_newton(const CoulombSystem       &system,
                       const std::vector<double> &start,
                       DenseFactor               &factor,
                       const unsigned int         most_iterations = 60);
} // namespace Signorini

#endif
