#ifndef signorini_variational_inequality_state_equations_h
#define signorini_variational_inequality_state_equations_h

#include <signorini/variational_inequality/coulomb_newton.h>

#include <vector>

namespace Signorini
{
  /**
   * The linear system of one Newton step for the forces x, one equation for
   * each: no force where open, e = 0 where closed, v = 0 where stuck, the bound
   * where a single tangent slips, and the linearised projection where two do.
   * Scaled to a unit diagonal.
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
    enum class Kind
    {
      given,     // x_i = its value in base
      vanishing, // y_i = 0
      bound,     // x_i = slope x_normal
      projection
    };

    struct Equation
    {
      Kind         kind      = Kind::given;
      double       slope     = 0.; // of the bound
      unsigned int normal    = 0;  // row of the normal of its contact
      unsigned int contact   = 0;
      unsigned int component = 0; // of the tangent, from 1
    };

    void
    add_contact(const unsigned int k);

    std::vector<DenseFactor::RowKey>
    keys() const;

    void
    write_row(const unsigned int i, double *entries) const;

    void
    write_projection(const unsigned int i, double *entries) const;

    /** The right-hand side of a projection, for the step from base. */
    double
    projection_remainder(const unsigned int i) const;

    const CoulombSystem             &system;
    const std::vector<ContactState> &states;
    const std::vector<double>       &x;
    const std::vector<double>       &y;
    std::vector<Equation>            equations;
    std::vector<double>              scaling;
    std::vector<double>              base;
    std::vector<double>              base_residual;
    bool                             linear = true;
  };
} // namespace Signorini

#endif
