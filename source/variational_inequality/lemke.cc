#include <signorini/variational_inequality/lemke.h>

#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // Of entries of the order of one: no pivot, and a tie.
    constexpr double no_pivot = 1e-11;
    constexpr double tie      = 1e-12;

    // Rows of w - M z - z_0 cover = q in terms of the basic variables.
    // Variables: w_i is i, z_i is n + i, the artificial z_0 is 2 n; the last
    // column holds their values.
    class Tableau
    {
    public:
      Tableau(const InterfaceMatrix     &M,
              const std::vector<double> &q,
              const std::vector<double> &cover)
        : n(q.size())
        , table(n, 2 * n + 2)
        , basis(n)
      {
        for (unsigned int i = 0; i < n; ++i)
          {
            table(i, i) = 1.;
            for (unsigned int j = 0; j < n; ++j)
              table(i, n + j) = -M(i, j);
            table(i, 2 * n)     = -cover[i];
            table(i, 2 * n + 1) = q[i];
            basis[i]            = i;
          }
      }

      bool
      run()
      {
        // 1. z_0 enters where q is most negative.
        unsigned int row = 0;
        for (unsigned int i = 1; i < n; ++i)
          if (is_less(i, row, -table(i, 2 * n), -table(row, 2 * n)))
            row = i;
        if (!(value(row) < 0.))
          return true;
        unsigned int entering = exchange(row, 2 * n);

        // 2. The complement of what leaves enters, until z_0 leaves.
        for (unsigned int step = 0; step < 50 * (n + 10); ++step)
          {
            const unsigned int complement =
              entering < n ? entering + n : entering - n;
            const int leaving_row = blocking_row(complement);
            if (leaving_row < 0)
              return false;
            entering = exchange(leaving_row, complement);
            if (entering == 2 * n)
              return true;
          }
        return false;
      }

      std::vector<double>
      solution() const
      {
        std::vector<double> z(n, 0.);
        for (unsigned int i = 0; i < n; ++i)
          if (basis[i] >= n && basis[i] < 2 * n)
            z[basis[i] - n] = std::max(value(i), 0.);
        return z;
      }

    private:
      double
      value(const unsigned int row) const
      {
        return table(row, 2 * n + 1);
      }

      // Is row i / pi lexicographically less than row j / pj? The first columns
      // hold the inverse of the basis.
      bool
      is_less(const unsigned int i,
              const unsigned int j,
              const double       pi,
              const double       pj) const
      {
        double difference = value(i) / pi - value(j) / pj;
        for (unsigned int c = 0; c < n && std::abs(difference) <= tie; ++c)
          difference = table(i, c) / pi - table(j, c) / pj;
        return difference < 0.;
      }

      int
      blocking_row(const unsigned int column) const
      {
        int row = -1;
        for (unsigned int i = 0; i < n; ++i)
          if (table(i, column) > no_pivot)
            {
              // z_0 leaves whenever it may.
              if (row >= 0)
                {
                  const double difference = value(i) / table(i, column) -
                                            value(row) / table(row, column);
                  if (std::abs(difference) <= tie && basis[i] == 2 * n)
                    {
                      row = i;
                      continue;
                    }
                  if (std::abs(difference) <= tie && basis[row] == 2 * n)
                    continue;
                }
              if (row < 0 ||
                  is_less(i, row, table(i, column), table(row, column)))
                row = i;
            }
        return row;
      }

      // @p column becomes basic in @p row; returns what was.
      unsigned int
      exchange(const unsigned int row, const unsigned int column)
      {
        const unsigned int width = 2 * n + 2;
        const double       pivot = table(row, column);
        for (unsigned int c = 0; c < width; ++c)
          table(row, c) /= pivot;
        for (unsigned int i = 0; i < n; ++i)
          if (i != row && table(i, column) != 0.)
            {
              const double factor = table(i, column);
              for (unsigned int c = 0; c < width; ++c)
                table(i, c) -= factor * table(row, c);
              table(i, column) = 0.;
            }
        std::swap(basis[row], leaving);
        basis[row] = column;
        return leaving;
      }

      unsigned int              n;
      InterfaceMatrix           table;
      std::vector<unsigned int> basis;
      unsigned int              leaving = 0;
    };
  } // namespace



  std::optional<std::vector<double>>
  solve_complementarity(const InterfaceMatrix     &M,
                        const std::vector<double> &q,
                        const std::vector<double> &cover)
  {
    AssertDimension(cover.size(), q.size());
    AssertDimension(M.m(), q.size());
    AssertDimension(M.n(), q.size());
    // Values of the order of one, so that ties are told by one number.
    double scale = 0.;
    for (const double entry : q)
      scale = std::max(scale, std::abs(entry));
    if (!(scale > 0.) || !std::isfinite(scale))
      return std::isfinite(scale) ?
               std::make_optional(std::vector<double>(q.size(), 0.)) :
               std::nullopt;
    std::vector<double> scaled = q;
    for (double &entry : scaled)
      entry /= scale;
    Tableau tableau(M, scaled, cover);
    if (!tableau.run())
      return std::nullopt;
    std::vector<double> z = tableau.solution();
    for (double &entry : z)
      entry *= scale;
    return z;
  }
} // namespace Signorini
