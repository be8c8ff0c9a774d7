#include <signorini/variational_inequality/coulomb_fallback.h>
#include <signorini/variational_inequality/coulomb_gauss_seidel.h>
#include <signorini/variational_inequality/coulomb_newton.h>
#include <signorini/variational_inequality/lemke.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // The complementarity problem in unknowns scaled to a unit diagonal:
    // force times sqrt(w), slip by sqrt(w).
    class ComplementarityForm
    {
    public:
      explicit ComplementarityForm(const CoulombSystem &system)
        : system(system)
      {
        for (unsigned int k = 0; k < system.n_contacts(); ++k)
          {
            const DualContact &contact = system.contact(k);
            first.push_back(n);
            n += 1;
            if (contact.n_tangents > 0)
              n += std::isfinite(contact.largest_friction) ? 4 : 3;
          }
        M.reinit(n, n);
        q.resize(n);
        for (unsigned int k = 0; k < system.n_contacts(); ++k)
          add_contact(k);
      }

      std::vector<double>
      forces(const std::vector<double> &z) const
      {
        std::vector<double> x(system.size());
        for (unsigned int k = 0; k < system.n_contacts(); ++k)
          {
            const unsigned int row = system.contact(k).row;
            x[row]                 = scale(row) * z[first[k]];
            if (system.contact(k).n_tangents > 0)
              x[row + 1] = scale(row + 1) * (z[first[k] + 1] - z[first[k] + 2]);
          }
        return x;
      }

      InterfaceMatrix     M;
      std::vector<double> q;

    private:
      double
      scale(const unsigned int row) const
      {
        const double diagonal = system(row, row);
        return diagonal > 0. ? 1. / std::sqrt(diagonal) : 1.;
      }

      // Row @p i of w gets factor times y of @p row, without its constant.
      void
      add_residual(const unsigned int i,
                   const unsigned int row,
                   const double       factor)
      {
        for (unsigned int k = 0; k < system.n_contacts(); ++k)
          {
            const unsigned int other = system.contact(k).row;
            const auto         entry = [&](const unsigned int j) {
              return -factor * scale(row) * scale(j) * system(row, j);
            };
            M(i, first[k]) += entry(other);
            if (system.contact(k).n_tangents > 0)
              {
                M(i, first[k] + 1) += entry(other + 1);
                M(i, first[k] + 2) -= entry(other + 1);
              }
          }
        q[i] += factor * scale(row) * system.constant()[row];
      }

      void
      add_contact(const unsigned int k)
      {
        const DualContact &contact = system.contact(k);
        const unsigned int row = contact.row, i = first[k];
        add_residual(i, row, -1.);
        if (contact.n_tangents == 0)
          return;
        add_residual(i + 1, row + 1, -1.);
        add_residual(i + 2, row + 1, 1.);
        const bool capped = std::isfinite(contact.largest_friction);
        for (unsigned int g = i + 3; g < i + (capped ? 5 : 4); ++g)
          {
            M(i + 1, g) = M(i + 2, g) = 1.;
            M(g, i + 1) = M(g, i + 2) = -1.;
          }
        M(i + 3, i) =
          contact.friction_coefficient * scale(row) / scale(row + 1);
        if (capped)
          q[i + 4] = contact.largest_friction / scale(row + 1);
      }

      const CoulombSystem      &system;
      std::vector<unsigned int> first;
      unsigned int              n = 0;
    };

    constexpr unsigned int n_directions = 10;

    bool
    is_planar(const CoulombSystem &system)
    {
      for (unsigned int k = 0; k < system.n_contacts(); ++k)
        if (system.contact(k).n_tangents > 1)
          return false;
      return true;
    }
  } // namespace



  std::vector<double>
  solve_coulomb_by_pivoting(const CoulombSystem &system,
                            const unsigned int   direction)
  {
    Assert(is_planar(system), ExcInternalError());
    const ComplementarityForm form(system);
    // Any positive numbers do; these repeat in every run.
    std::vector<double> cover;
    for (unsigned int i = 0; i < form.q.size(); ++i)
      cover.push_back(1. + 0.9 * std::sin(double(direction) * (1. + 2. * i)));
    const auto z = solve_complementarity(form.M, form.q, cover);
    return z ? form.forces(*z) : std::vector<double>();
  }



  CoulombSolution
  solve_coulomb_fallback(const CoulombSystem       &system,
                         const std::vector<double> &start,
                         DenseFactor               &factor)
  {
    CoulombSolution     best;
    unsigned int        n_iterations = 0;
    std::vector<double> x            = start;
    const auto          suspects = system.wrong_contacts(x, system.rounding(x));
    const auto          ends_from = [&](const std::vector<double> &point) {
      best = solve_coulomb_newton(system, point, factor);
      n_iterations += best.n_iterations;
      best.n_iterations = n_iterations;
      best.fell_back    = true;
      if (best.solved)
        best.suspects = suspects;
      return best.solved;
    };

    for (const unsigned int n_sweeps : {5, 20, 75})
      {
        sweep_coulomb(system, n_sweeps, x);
        if (ends_from(x))
          return best;
      }
    if (is_planar(system))
      for (unsigned int direction = 0; direction < n_directions; ++direction)
        {
          const std::vector<double> pivoted =
            solve_coulomb_by_pivoting(system, direction);
          if (!pivoted.empty() && ends_from(pivoted))
            return best;
        }
    for (const unsigned int n_sweeps : {400, 1500})
      {
        sweep_coulomb(system, n_sweeps, x);
        if (ends_from(x))
          return best;
      }
    return best;
  }



  CoulombSolution
  solve_coulomb(const CoulombSystem       &system,
                const std::vector<double> &start,
                DenseFactor               &factor)
  {
    CoulombSolution solution = solve_coulomb_newton(system, start, factor);
    if (solution.solved)
      return solution;
    const unsigned int n_iterations = solution.n_iterations;
    solution = solve_coulomb_fallback(system, solution.x, factor);
    solution.n_iterations += n_iterations;
    return solution;
  }
} // namespace Signorini
