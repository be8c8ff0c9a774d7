#include <signorini/variational_inequality/coulomb_gauss_seidel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace Signorini
{
  namespace
  {
    // Coulomb's law of a single contact: q = y + M x with all others held.
    class LocalProblem
    {
    public:
      LocalProblem(const CoulombSystem &system, const unsigned int k)
        : contact(system.contact(k))
        , n(contact.n_tangents + 1)
      {
        for (unsigned int a = 0; a < n; ++a)
          for (unsigned int b = 0; b < n; ++b)
            M[a][b] = system(contact.row + a, contact.row + b);
      }

      // New forces, from the old ones @p x.
      void
      solve(const std::array<double, 3> &q, std::array<double, 3> &x) const
      {
        if (!(q[0] > 0.))
          x = {{0., 0., 0.}};
        else if (n == 1)
          x[0] = M[0][0] > 0. ? q[0] / M[0][0] : x[0];
        else if (!stick(q, x) && !slip(q, x))
          project(q, x);
      }

    private:
      bool
      stick(const std::array<double, 3> &q, std::array<double, 3> &x) const
      {
        // Gauss without pivoting: M is positive definite.
        std::array<std::array<double, 3>, 3> A = M;
        std::array<double, 3>                f = q;
        for (unsigned int p = 0; p < n; ++p)
          {
            if (!(A[p][p] > 1e-14 * M[p][p]))
              return false;
            for (unsigned int i = p + 1; i < n; ++i)
              {
                const double factor = A[i][p] / A[p][p];
                for (unsigned int j = p; j < n; ++j)
                  A[i][j] -= factor * A[p][j];
                f[i] -= factor * f[p];
              }
          }
        for (unsigned int p = n; p-- > 0;)
          {
            for (unsigned int j = p + 1; j < n; ++j)
              f[p] -= A[p][j] * f[j];
            f[p] /= A[p][p];
          }
        if (!(f[0] > 0.) ||
            std::hypot(f[1], n > 2 ? f[2] : 0.) > contact.bound(f[0]))
          return false;
        x = f;
        return true;
      }

      // Forces under a slip along the unit vector @p n, and the slip that they
      // leave. False without a normal force.
      bool
      slip_along(const std::array<double, 2> &n_slip,
                 const std::array<double, 3> &q,
                 std::array<double, 3>       &x,
                 std::array<double, 2>       &v) const
      {
        double coupling = 0.;
        for (unsigned int a = 1; a < n; ++a)
          coupling += M[0][a] * n_slip[a - 1];
        double lambda =
          q[0] / (M[0][0] + contact.friction_coefficient * coupling);
        double f = contact.friction_coefficient * lambda;
        if (f > contact.largest_friction)
          {
            f      = contact.largest_friction;
            lambda = (q[0] - coupling * f) / M[0][0];
          }
        if (!(lambda > 0.))
          return false;
        x = {{lambda, f * n_slip[0], f * n_slip[1]}};
        for (unsigned int a = 1; a < n; ++a)
          {
            v[a - 1] = q[a];
            for (unsigned int b = 0; b < n; ++b)
              v[a - 1] -= M[a][b] * x[b];
          }
        return true;
      }

      bool
      slip(const std::array<double, 3> &q, std::array<double, 3> &x) const
      {
        std::array<double, 3> force = {{0., 0., 0.}};
        std::array<double, 2> v     = {{0., 0.}};
        if (n == 2)
          {
            for (const double sign : {1., -1.})
              if (slip_along({{sign, 0.}}, q, force, v) && sign * v[0] >= 0.)
                {
                  x = force;
                  return true;
                }
            return false;
          }

        // In 3-D the angle at which the slip is along itself: where the part
        // across it changes its sign.
        constexpr unsigned int n_angles = 48;
        const auto             across   = [&](const double angle) {
          const std::array<double, 2> direction = {
            {std::cos(angle), std::sin(angle)}};
          return slip_along(direction, q, force, v) ?
                                 direction[0] * v[1] - direction[1] * v[0] :
                                 std::numeric_limits<double>::quiet_NaN();
        };
        const double step = 2. * 3.14159265358979323846 / n_angles;
        for (unsigned int i = 0; i < n_angles; ++i)
          {
            double       left = i * step, right = left + step;
            const double value = across(left);
            if (!(value * across(right) <= 0.))
              continue;
            for (unsigned int bisection = 0; bisection < 52; ++bisection)
              {
                const double middle = 0.5 * (left + right);
                (value * across(middle) > 0. ? left : right) = middle;
              }
            const double angle = 0.5 * (left + right);
            across(angle);
            if (std::cos(angle) * v[0] + std::sin(angle) * v[1] >= 0.)
              {
                x = force;
                return true;
              }
          }
        return false;
      }

      // Repeated projection.
      void
      project(const std::array<double, 3> &q, std::array<double, 3> &x) const
      {
        double trace = 0.;
        for (unsigned int a = 1; a < n; ++a)
          trace += M[a][a];
        for (unsigned int step = 0; step < 30; ++step)
          {
            std::array<double, 3> y = q;
            for (unsigned int a = 0; a < n; ++a)
              for (unsigned int b = 0; b < n; ++b)
                y[a] -= M[a][b] * x[b];
            x[0]          = std::max(0., x[0] + y[0] / M[0][0]);
            double length = 0.;
            for (unsigned int a = 1; a < n; ++a)
              {
                x[a] += y[a] / trace;
                length = std::hypot(length, x[a]);
              }
            const double f = contact.bound(x[0]);
            if (length > f)
              for (unsigned int a = 1; a < n; ++a)
                x[a] *= f / length;
          }
      }

      const DualContact                   &contact;
      unsigned int                         n;
      std::array<std::array<double, 3>, 3> M = {};
    };
  } // namespace



  bool
  sweep_coulomb(const CoulombSystem &system,
                const unsigned int   n_sweeps,
                std::vector<double> &x)
  {
    std::vector<double> y = system.residual(x);
    for (unsigned int sweep = 0; sweep < n_sweeps; ++sweep)
      {
        for (unsigned int k = 0; k < system.n_contacts(); ++k)
          {
            const unsigned int    row = system.contact(k).row;
            const unsigned int    n   = system.contact(k).n_tangents + 1;
            std::array<double, 3> q = {{0., 0., 0.}}, force = q;
            for (unsigned int a = 0; a < n; ++a)
              {
                force[a] = x[row + a];
                q[a]     = y[row + a];
                for (unsigned int b = 0; b < n; ++b)
                  q[a] += system(row + a, row + b) * x[row + b];
              }
            LocalProblem(system, k).solve(q, force);
            for (unsigned int a = 0; a < n; ++a)
              {
                const double change = force[a] - x[row + a];
                x[row + a]          = force[a];
                if (change != 0.)
                  for (unsigned int i = 0; i < system.size(); ++i)
                    y[i] -= system(i, row + a) * change;
              }
          }
        // Afresh: the changes gather rounding.
        y = system.residual(x);
        if (system.error(x, y) <= system.rounding(x))
          return true;
      }
    return false;
  }
} // namespace Signorini
