#ifndef signorini_variational_inequality_coulomb_alternation_h
#define signorini_variational_inequality_coulomb_alternation_h

#include <signorini/variational_inequality/coulomb_system.h>
#include <signorini/variational_inequality/dense_factor.h>

#include <vector>

namespace Signorini
{
  /** Numbers of solve_coulomb_alternating(). */
  struct AlternationControl
  {
    // epsilon, m. 0: 1e-10 of the length scale of the system, below what a time
    // step asks for.
    double regularisation_slip = 0.;

    // Largest change of normal and tangential forces from one alternation to
    // the next, relative to the largest force, 1.
    double force_tolerance = 1e-4;

    // Alternations to try before the fallback.
    unsigned int most_alternations = 100;
  };

  /**
   * Coulomb's law in two dimensions by two sub-problems in turns [MC, sec. 5.3,
   * figs. 12b, 13, 14]:
   *
   *  I.  The friction forces are held. The quadratic programme of the gap
   *      constraints gives normal forces and the contact set.
   *  II. The contact set and the friction bounds f_k = min(mu_k lambda_k,
   *      largest friction) are held. Newton's method with the multipliers of
   *      the equations A du = G solves the regularised law
   *      tau_k = f_k slip_k / epsilon, at most f_k [MC, eqs. 21-26, 52-65 with
   *      the slip over the step for the velocity].
   *
   * Ends when both kinds of forces change by less than the tolerance. The
   * friction forces are relaxed by Aitken's rule where the alternation
   * oscillates. If it does not settle, the fallback solves Coulomb's law.
   *
   * Newton's method in II is restarted from the minimum that the cutting planes
   * give (solve_given_bounds()) should it come back to a state.
   *
   * @return forces that obey the law to the tolerance and to epsilon; gaps and
   *   friction bounds belong to I.
   */
  CoulombSolution
  solve_coulomb_alternating(const CoulombSystem       &system,
                            const std::vector<double> &start,
                            DenseFactor               &factor,
                            const AlternationControl  &control);
} // namespace Signorini

#endif
