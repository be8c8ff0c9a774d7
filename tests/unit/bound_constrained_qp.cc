#include <signorini/variational_inequality/bound_constrained_qp.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <optional>
#include <random>

#include "interface_reference.h"

BOOST_AUTO_TEST_SUITE(bound_constrained_qp)

using namespace Signorini;
using dealii::FullMatrix;

namespace
{
  struct Programme
  {
    FullMatrix<double>  W;
    std::vector<double> d;
  };

  double
  objective(const Programme &programme, const std::vector<double> &x)
  {
    double value = 0.;
    for (unsigned int i = 0; i < x.size(); ++i)
      {
        value -= programme.d[i] * x[i];
        for (unsigned int j = 0; j < x.size(); ++j)
          value += 0.5 * x[i] * programme.W(i, j) * x[j];
      }
    return value;
  }

  // Largest violation of x >= 0, r <= 0, r = 0 where x > 0, each entry
  // relative to the numbers that cancel in it.
  double
  optimality_error(const Programme &programme, const std::vector<double> &x)
  {
    double error = 0.;
    for (unsigned int i = 0; i < x.size(); ++i)
      {
        double residual = programme.d[i], size = std::abs(programme.d[i]);
        for (unsigned int j = 0; j < x.size(); ++j)
          {
            residual -= programme.W(i, j) * x[j];
            size += std::abs(programme.W(i, j) * x[j]);
          }
        if (x[i] < 0. || std::isnan(residual))
          return 1e300;
        const double violation =
          x[i] > 0. ? std::abs(residual) : std::max(residual, 0.);
        if (violation > 0.)
          error = std::max(error, violation / size);
      }
    return error;
  }

  // The minimum over all faces; nothing if the programme is unbounded. If
  // there is a minimum, there is one with a regular W_FF.
  std::optional<std::vector<double>>
  brute_force(const Programme &programme)
  {
    const unsigned int m = programme.d.size();
    for (unsigned int set = 0; set < (1U << m); ++set)
      {
        std::vector<unsigned int> face;
        for (unsigned int j = 0; j < m; ++j)
          if ((set >> j) & 1U)
            face.push_back(j);
        InterfaceReference::Matrix W(face.size(),
                                     InterfaceReference::Column(face.size()));
        InterfaceReference::Column d(face.size());
        for (unsigned int i = 0; i < face.size(); ++i)
          {
            d[i] = programme.d[face[i]];
            for (unsigned int j = 0; j < face.size(); ++j)
              W[i][j] = programme.W(face[i], face[j]);
          }
        const auto solution = InterfaceReference::solve(W, d);
        if (!solution)
          continue;
        std::vector<double> x(m, 0.);
        bool                feasible = true;
        for (unsigned int i = 0; i < face.size(); ++i)
          {
            x[face[i]] = std::max(0., static_cast<double>((*solution)[i]));
            feasible   = feasible && (*solution)[i] >= -1e-12L;
          }
        if (feasible && optimality_error(programme, x) < 1e-11)
          return x;
      }
    return std::nullopt;
  }

  // W = A A^T of small integers: dependent rows are so exactly. Every third d
  // has a degenerate solution: zero unknowns with a zero residual.
  Programme
  random_programme(const unsigned int m, std::mt19937 &generator)
  {
    std::uniform_int_distribution<int>          entry(-2, 2), kind(0, 2);
    std::uniform_int_distribution<unsigned int> columns(1, 8);
    std::vector<std::vector<int>> A(m, std::vector<int>(columns(generator)));
    for (unsigned int i = 0; i < m; ++i)
      for (unsigned int c = 0; c < A[i].size(); ++c)
        if (i >= 2 && i % 4 == 2) // twice the same
          A[i][c] = A[i - 1][c];
        else if (i >= 2 && i % 4 == 3) // a linear combination
          A[i][c] = A[i - 1][c] - 2 * A[i - 3][c];
        else
          A[i][c] = entry(generator);

    Programme programme{FullMatrix<double>(m, m), std::vector<double>(m)};
    for (unsigned int i = 0; i < m; ++i)
      for (unsigned int j = 0; j < m; ++j)
        for (unsigned int c = 0; c < A[i].size(); ++c)
          programme.W(i, j) += A[i][c] * A[j][c];

    const int choice = kind(generator);
    for (unsigned int i = 0; i < m; ++i)
      if (choice == 0)
        programme.d[i] = entry(generator);
      else
        for (unsigned int j = 0; j < m; ++j)
          if (j % 2 == 0)
            programme.d[i] += programme.W(i, j) * (j % 3);
    if (choice == 2)
      for (unsigned int i = 1; i < m; i += 2)
        programme.d[i] -= i % 3;
    return programme;
  }

  // The same in other units for each unknown: x_i = x_i' D_i.
  Programme
  scaled(const Programme &programme, const std::vector<double> &D)
  {
    Programme result = programme;
    for (unsigned int i = 0; i < D.size(); ++i)
      {
        result.d[i] *= D[i];
        for (unsigned int j = 0; j < D.size(); ++j)
          result.W(i, j) *= D[i] * D[j];
      }
    return result;
  }

  // Compliance of the surface of an elastic half-plane, pressed by a punch
  // with a rough face.
  Programme
  half_plane(const unsigned int m,
             const double       roughness,
             std::mt19937      &generator)
  {
    std::uniform_real_distribution<double> number(-1., 1.);
    Programme programme{FullMatrix<double>(m, m), std::vector<double>(m)};
    for (unsigned int i = 0; i < m; ++i)
      {
        const double s = (i - 0.37 * m) / m;
        programme.d[i] = 0.3 - 2. * s * s + roughness * number(generator);
        for (unsigned int j = 0; j < m; ++j)
          programme.W(i, j) =
            std::log(4. * m / (std::abs(double(i) - double(j)) + 0.2));
      }
    return programme;
  }
} // namespace



BOOST_AUTO_TEST_CASE(equals_brute_force)
{
  std::mt19937 generator(2024);
  unsigned int n_unbounded = 0, n_singular = 0, most_iterations = 0;
  double       worst = 0.;
  for (unsigned int trial = 0; trial < 1000; ++trial)
    {
      const unsigned int m         = 1 + trial % 8;
      const Programme    programme = random_programme(m, generator);
      std::uniform_real_distribution<double> exponent(-6., 6.);
      std::vector<double>                    D(m, 1.);
      if (trial % 2 == 1)
        for (double &factor : D)
          factor = std::pow(10., exponent(generator));
      std::vector<double> start(m, 0.);
      if (trial % 3 == 1)
        for (unsigned int i = 0; i < m; ++i)
          start[i] = exponent(generator) / D[i];

      const auto                     expected = brute_force(programme);
      const BoundConstrainedSolution found =
        solve_bound_constrained_qp(scaled(programme, D).W,
                                   scaled(programme, D).d,
                                   start);
      most_iterations = std::max(most_iterations, found.n_iterations);
      BOOST_TEST_CONTEXT("trial " << trial << ", size " << m)
      {
        if (!expected)
          {
            ++n_unbounded;
            BOOST_TEST((found.outcome == QPOutcome::unbounded));
            BOOST_TEST(!found.suspects.empty());
            continue;
          }
        BOOST_REQUIRE((found.outcome == QPOutcome::solved));
        std::vector<double> x = found.x;
        for (unsigned int i = 0; i < m; ++i)
          x[i] *= D[i];
        n_singular += x != *expected;

        // x need not be unique, but W x and the objective are.
        const double value = objective(programme, *expected);
        BOOST_TEST(std::abs(objective(programme, x) - value) <=
                   1e-10 * (1. + std::abs(value)));
        for (unsigned int i = 0; i < m; ++i)
          {
            double difference = 0., size = 1.;
            for (unsigned int j = 0; j < m; ++j)
              {
                difference += programme.W(i, j) * (x[j] - (*expected)[j]);
                size += std::abs(programme.W(i, j) * x[j]);
              }
            BOOST_TEST(std::abs(difference) <= 1e-9 * size);
          }
        const double error = optimality_error(programme, x);
        worst              = std::max(worst, error);
        BOOST_TEST(error <= 1e-11);
      }
    }
  BOOST_TEST_MESSAGE("unbounded " << n_unbounded << ", another x " << n_singular
                                  << ", most iterations " << most_iterations
                                  << ", optimality error " << worst);
  // All kinds of programmes were among them.
  BOOST_TEST(n_unbounded > 20);
  BOOST_TEST(n_unbounded < 700);
  BOOST_TEST(most_iterations <= 40);
}



BOOST_AUTO_TEST_CASE(large_ones_are_optimal_in_a_handful_of_iterations)
{
  std::mt19937                           generator(7);
  std::uniform_real_distribution<double> number(-1., 1.);
  for (const unsigned int m : {20U, 100U, 300U})
    BOOST_TEST_CONTEXT("size " << m)
    {
      // 1. A punch.
      for (const double roughness : {0., 1e-3, 0.02, 0.2})
        {
          const Programme punch = half_plane(m, roughness, generator);
          const BoundConstrainedSolution pressed =
            solve_bound_constrained_qp(punch.W,
                                       punch.d,
                                       std::vector<double>(m, 0.));
          BOOST_TEST((pressed.outcome == QPOutcome::solved));
          BOOST_TEST(optimality_error(punch, pressed.x) <= 1e-13);
          BOOST_TEST(pressed.n_iterations <= 12);
          BOOST_TEST_MESSAGE("punch of " << m << ", roughness " << roughness
                                         << ": " << pressed.n_iterations
                                         << " iterations");

          // 2. From its own solution: one face.
          const BoundConstrainedSolution again =
            solve_bound_constrained_qp(punch.W, punch.d, pressed.x);
          BOOST_TEST(again.n_iterations == 1);
          BOOST_TEST(optimality_error(punch, again.x) <= 1e-13);
        }

      // 3. Without structure, of rank m / 2, bounded: d is in the range of W.
      Programme          low{FullMatrix<double>(m, m), std::vector<double>(m)};
      FullMatrix<double> A(m, m / 2);
      for (unsigned int i = 0; i < m; ++i)
        for (unsigned int c = 0; c < m / 2; ++c)
          A(i, c) = number(generator);
      A.mTmult(low.W, A);
      for (unsigned int c = 0; c < m / 2; ++c)
        {
          const double coefficient = number(generator);
          for (unsigned int i = 0; i < m; ++i)
            low.d[i] += coefficient * A(i, c);
        }
      const BoundConstrainedSolution found =
        solve_bound_constrained_qp(low.W, low.d, std::vector<double>(m, 1.));
      BOOST_TEST((found.outcome == QPOutcome::solved));
      BOOST_TEST(optimality_error(low, found.x) <= 1e-11);
      BOOST_TEST_MESSAGE("low rank " << m << ": " << found.n_iterations
                                     << " iterations");
    }
}



BOOST_AUTO_TEST_CASE(zero_rows)
{
  // A constraint that nothing moves: redundant if it holds, else a
  // contradiction.
  FullMatrix<double> W(2, 2);
  W(0, 0)              = 2.;
  const auto redundant = solve_bound_constrained_qp(W, {4., -1.}, {0., 3.});
  BOOST_TEST((redundant.outcome == QPOutcome::solved));
  BOOST_TEST(redundant.x[0] == 2.);
  BOOST_TEST(redundant.x[1] == 0.);
  const auto contradiction = solve_bound_constrained_qp(W, {4., 1.}, {0., 0.});
  BOOST_TEST((contradiction.outcome == QPOutcome::unbounded));
  BOOST_REQUIRE(contradiction.suspects.size() == 1);
  BOOST_TEST(contradiction.suspects[0] == 1);
  BOOST_TEST(
    (solve_bound_constrained_qp(FullMatrix<double>(), {}, {}).outcome ==
     QPOutcome::solved));
}



BOOST_AUTO_TEST_CASE(nothing_wrong_is_accepted)
{
  // Not symmetric: no minimum of the face is one. Not a number: no tolerance
  // holds.
  FullMatrix<double> W(2, 2);
  W(0, 0) = W(1, 1)   = 1.;
  W(0, 1)             = 1.1;
  W(1, 0)             = 0.9;
  const auto lopsided = solve_bound_constrained_qp(W, {2.1, 1.9}, {1., 1.});
  BOOST_TEST((lopsided.outcome == QPOutcome::stalled));
  W(0, 1) = W(1, 0) = 0.;
  const double nan  = std::numeric_limits<double>::quiet_NaN();
  for (const double start : {0., 1.})
    {
      const auto broken =
        solve_bound_constrained_qp(W, {nan, 1.}, {start, start});
      BOOST_TEST((broken.outcome == QPOutcome::stalled));
    }
}

BOOST_AUTO_TEST_SUITE_END()
