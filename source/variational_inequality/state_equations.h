#ifndef signorini_variational_inequality_state_equations_h
#define signorini_variational_inequality_state_equations_h

#include <signorini/variational_inequality/coulomb_newton.h>

#include <vector>

namespace Signorini
{
  /**
   * The linear system of one Newton step: from the point x the step goes to
   * x_base + P z, where x_base has what the states fix (no force where open,
   * the bound where a single tangent slips) and z are the forces left. They
   * make e = 0 where closed and v = 0 where stuck, and obey the linearised
   * projection where two tangents slip. Scaled to a unit diagonal.
   */
  class StateEquations
  {
  public:
    StateEquations(const CoulombSystem             &system,
                   const std::vector<ContactState> &states,
                   const std::vector<double>       &x,
                   const std::vector<double>       &y);

    /** x + its Newton step, from @p factor of these equations or a new one;
     * empty if they cannot be solved. */
    std::vector<double>
    solve(DenseFactor &factor) const;

    /** Does the step lead to the solution of these states, or only nearer? */
    bool
    are_linear() const
    {
      return linear;
    }

  private:
    // A column of P: a force, and a second one that it brings along. The same
    // numbers tell the row of y that vanishes.
    struct Unknown
    {
      unsigned int row;
      unsigned int follower;
      double       slope;
    };

    // A tangent in a slip that is no line: the row of z, its contact.
    struct Projection
    {
      unsigned int unknown;
      unsigned int contact;
      unsigned int component;
    };

    void
    add_contact(const unsigned int k, const std::vector<double> &x);

    DenseFactor::Key
    key() const;

    std::vector<double>
    matrix() const;

    void
    linearise_projection(const Projection    &projection,
                         std::vector<double> &matrix,
                         double              *right_hand_side) const;

    void
    add_step(std::vector<double> &z, std::vector<double> &point) const;

    double
    scaling(const unsigned int row) const;

    const CoulombSystem             &system;
    const std::vector<ContactState> &states;
    const std::vector<double>       &x;
    const std::vector<double>       &y;
    std::vector<double>              base;
    std::vector<double>              base_residual;
    std::vector<Unknown>             unknowns;
    std::vector<Projection>          projections;
    bool                             linear = true;
  };
} // namespace Signorini

#endif
