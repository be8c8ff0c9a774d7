#ifndef signorini_time_generalized_alpha_h
#define signorini_time_generalized_alpha_h

namespace Signorini
{
  /**
   * The four numbers of the generalized-alpha method. The weights belong to the
   * *old* state: alpha_B to inertia, alpha_H to all other terms,
   *
   *   M [(1-alpha_B) A_np + alpha_B A_n]
   *     + (1-alpha_H) F_int(U_np) + alpha_H F_int(U_n)
   *       = (1-alpha_H) F_np + alpha_H F_n + contact forces at n+1,
   *
   * with Newmark's formulas for U and V. Second order when
   * gamma = 1/2 - alpha_B + alpha_H. [MC, eqs. 47-49; ChungHulbert1993]
   */
  struct GeneralizedAlpha
  {
    double alpha_B = 0.;
    double alpha_H = 0.;
    double beta    = 0.25;
    double gamma   = 0.5;

    /**
     * The acceleration that Newmark's formula gives to a displacement,
     *   A_np = (U_np - U_n - dt V_n)/(beta dt^2) - (1/(2 beta) - 1) A_n,
     * for any vector type with add() and sadd().
     */
    template <typename VectorType>
    VectorType
    acceleration(const VectorType &displacement,
                 const VectorType &displacement_n,
                 const VectorType &velocity_n,
                 const VectorType &acceleration_n,
                 const double      step_size) const
    {
      const double factor = 1. / (beta * step_size * step_size);
      VectorType   result(acceleration_n);
      result.sadd(1. - 0.5 / beta, factor, displacement);
      result.add(-factor, displacement_n, -factor * step_size, velocity_n);
      return result;
    }

    /** V_np = V_n + dt [(1-gamma) A_n + gamma A_np]. */
    template <typename VectorType>
    VectorType
    velocity(const VectorType &acceleration_np,
             const VectorType &velocity_n,
             const VectorType &acceleration_n,
             const double      step_size) const
    {
      VectorType result(velocity_n);
      result.add(step_size * (1. - gamma),
                 acceleration_n,
                 step_size * gamma,
                 acceleration_np);
      return result;
    }

    /** d A_np / d U_np = 1/(beta dt^2), in 1/s^2. */
    double
    acceleration_factor(const double step_size) const
    {
      return 1. / (beta * step_size * step_size);
    }

    /** d V_np / d U_np = gamma/(beta dt), in 1/s. */
    double
    velocity_factor(const double step_size) const
    {
      return gamma / (beta * step_size);
    }

    bool
    is_second_order() const;
  };

  /** Newmark with gamma = 1/2, beta = 1/4: keeps energy, lets contact ring. */
  GeneralizedAlpha
  trapezoidal_rule();

  /**
   * All forces those of the middle of the step: with mean internal forces that
   * do as much work as the stored energy takes up, it keeps energy and momenta
   * [SimoTarnow1992].
   */
  GeneralizedAlpha
  midpoint_rule();

  /**
   * Newmark's method with both numbers free. @throws InputError unless
   * 2 beta >= gamma >= 1/2 (unconditional stability).
   */
  GeneralizedAlpha
  newmark(const double beta, const double gamma);

  /**
   * [HilberHughesTaylor1977]: alpha_B = 0, second order and of greatest
   * dissipation for the given alpha_H. @throws InputError unless alpha_H lies
   * in [0, 1/2].
   */
  GeneralizedAlpha
  hilber_hughes_taylor(const double alpha_H);

  /**
   * The numbers for a spectral radius at infinite frequency,
   * alpha_B = (2 rho - 1)/(rho + 1), alpha_H = rho/(rho + 1).
   * @throws InputError unless rho lies in [0, 1].
   */
  GeneralizedAlpha
  chung_hulbert(const double spectral_radius);

  /** The set of [MC, sec. 6.4]: alpha_H = sqrt(2) - 1, strongly dissipative. */
  GeneralizedAlpha
  meguid_czekanski();

  /**
   * Four given numbers. @throws InputError, with the condition that fails,
   * unless alpha_B <= alpha_H <= 1/2 and
   * 2 beta >= gamma >= 1/2 - alpha_B + alpha_H.
   */
  GeneralizedAlpha
  generalized_alpha(const double alpha_B,
                    const double alpha_H,
                    const double beta,
                    const double gamma);
} // namespace Signorini

#endif
