#include <signorini/curves/bernstein_roots.h>

#include <array>
#include <cmath>

namespace Signorini
{
  namespace
  {
    constexpr unsigned int n = 6; // coefficients

    struct Polynomial
    {
      std::array<double, n> c;

      // De Casteljau: value and derivative.
      void
      evaluate(const double t, double &value, double &slope) const
      {
        std::array<double, n> b = c;
        for (unsigned int level = 1; level < n; ++level)
          {
            if (level + 1 == n)
              slope = (n - 1) * (b[1] - b[0]);
            for (unsigned int i = 0; i + level < n; ++i)
              b[i] += t * (b[i + 1] - b[i]);
          }
        value = b[0];
      }

      void
      halve(Polynomial &left, Polynomial &right) const
      {
        std::array<double, n> b = c;
        left.c[0]               = b[0];
        right.c[n - 1]          = b[n - 1];
        for (unsigned int level = 1; level < n; ++level)
          {
            for (unsigned int i = 0; i + level < n; ++i)
              b[i] = 0.5 * (b[i] + b[i + 1]);
            left.c[level]          = b[0];
            right.c[n - 1 - level] = b[n - 1 - level];
          }
      }

      unsigned int
      sign_changes() const
      {
        unsigned int changes = 0;
        double       last    = 0.;
        for (unsigned int i = 0; i < n; ++i)
          if (c[i] != 0.)
            {
              if (last * c[i] < 0.)
                ++changes;
              last = c[i] < 0. ? -1. : 1.;
            }
        return changes;
      }

      bool
      is_negligible(const double negligible) const
      {
        for (unsigned int i = 0; i < n; ++i)
          if (std::abs(c[i]) > negligible)
            return false;
        return true;
      }
    };

    // The one root of f between f(0) < 0 and f(1) > 0.
    double
    bracketed_root(const Polynomial &f)
    {
      double low = 0., high = 1., t = 0.5;
      for (unsigned int i = 0; i < 60; ++i)
        {
          double value = 0., slope = 0.;
          f.evaluate(t, value, slope);
          if (value == 0.)
            break;
          (value < 0. ? low : high) = t;
          double next               = slope > 0. ? t - value / slope : -1.;
          if (!(next > low && next < high))
            next = 0.5 * (low + high);
          if (std::abs(next - t) <= 1e-16)
            break;
          t = next;
        }
      return t;
    }

    void
    find(const Polynomial    &f,
         const double         start,
         const double         size,
         const double         negligible,
         std::vector<double> &roots)
    {
      const unsigned int changes = f.sign_changes();
      const double       first = f.c[0], last = f.c[n - 1];
      if (changes == 0)
        return;
      if (changes == 1 && first < 0. && last > 0.)
        roots.push_back(start + size * bracketed_root(f));
      else if (changes == 1 && first > 0. && last < 0.)
        return;
      else if (f.is_negligible(negligible) || size < 1e-12)
        roots.push_back(start + 0.5 * size);
      else
        {
          Polynomial left, right;
          f.halve(left, right);
          find(left, start, 0.5 * size, negligible, roots);
          find(right, start + 0.5 * size, 0.5 * size, negligible, roots);
          // A root in the very middle is in neither half.
          double value = 0., slope = 0.;
          f.evaluate(0.5, value, slope);
          if (value == 0. && slope > 0.)
            roots.push_back(start + 0.5 * size);
        }
    }
  } // namespace



  void
  rising_roots(const std::array<double, 6> &coefficients,
               const double                 negligible,
               std::vector<double>         &roots)
  {
    roots.clear();
    find({coefficients}, 0., 1., negligible, roots);
  }
} // namespace Signorini
