#ifndef signorini_curves_bernstein_roots_h
#define signorini_curves_bernstein_roots_h

#include <array>
#include <vector>

namespace Signorini
{
  /**
   * Where the polynomial of degree 5 f(xi) = sum_i B_i(xi) c_i in Bernstein
   * form goes from negative to positive in 0 < xi < 1.
   *
   * No root is missed: the signs of the coefficients change at least as often
   * as the polynomial does, so that an interval is halved until there is one
   * change, or none, and one change means one root [Schneider1990].
   * The root is then found by Newton's method kept inside of a bracket.
   *
   * @param negligible coefficients below this count as zero; where all of them
   * are, the middle of the interval stands for all of it
   */
  void
  rising_roots(const std::array<double, 6> &coefficients,
               const double                 negligible,
               std::vector<double>         &roots);
} // namespace Signorini

#endif
