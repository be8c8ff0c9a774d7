#ifndef signorini_tests_random_curves_h
#define signorini_tests_random_curves_h

#include <signorini/curves/curve_weights.h>

#include <deal.II/base/numbers.h>

#include <random>

namespace Signorini
{
  /** Random nodes and curves of all families, the same in every run. */
  class RandomCurves
  {
  public:
    explicit RandomCurves(const unsigned int seed)
      : generator(seed)
    {}

    double
    number(const double from, const double to)
    {
      return std::uniform_real_distribution<double>(from, to)(generator);
    }

    dealii::Point<2>
    point(const double from, const double to)
    {
      const double x = number(from, to);
      return {x, number(from, to)};
    }

    /** A wavy line from left to right, or a wavy ring, body on the left. */
    std::vector<dealii::Point<2>>
    nodes(const unsigned int n, const bool is_closed)
    {
      std::vector<dealii::Point<2>> result;
      for (unsigned int i = 0; i < n; ++i)
        {
          const double s = i + number(-0.3, 0.3), r = number(-0.3, 0.3);
          const double angle = 2. * dealii::numbers::PI * s / n;
          if (is_closed)
            result.emplace_back((2. + r) * std::cos(angle),
                                (2. + r) * std::sin(angle));
          else
            result.emplace_back(2. - 4. * s / (n - 1), 2. * r);
        }
      return result;
    }

  private:
    std::mt19937 generator;
  };
} // namespace Signorini

#endif
