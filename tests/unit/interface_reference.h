#ifndef signorini_tests_unit_interface_reference_h
#define signorini_tests_unit_interface_reference_h

#include <signorini/variational_inequality/interface_problem.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <cmath>
#include <optional>
#include <random>
#include <utility>
#include <vector>

// Slow and simple: what the algorithms of variational_inequality/ are compared
// with.
namespace InterfaceReference
{
  using Matrix = std::vector<std::vector<long double>>;
  using Column = std::vector<long double>;

  /** Gauss with complete pivoting; nothing if the matrix is singular. */
  inline std::optional<Column>
  solve(Matrix A, Column b)
  {
    const std::size_t        n = b.size();
    std::vector<std::size_t> unknown(n);
    for (std::size_t i = 0; i < n; ++i)
      unknown[i] = i;
    long double first_pivot = 0;
    for (std::size_t step = 0; step < n; ++step)
      {
        std::size_t row = step, column = step;
        for (std::size_t i = step; i < n; ++i)
          for (std::size_t j = step; j < n; ++j)
            if (std::abs(A[i][j]) > std::abs(A[row][column]))
              {
                row    = i;
                column = j;
              }
        const long double pivot = std::abs(A[row][column]);
        if (step == 0)
          first_pivot = pivot;
        if (pivot <= 1e-11L * first_pivot)
          return std::nullopt;
        std::swap(A[row], A[step]);
        std::swap(b[row], b[step]);
        for (auto &line : A)
          std::swap(line[column], line[step]);
        std::swap(unknown[column], unknown[step]);
        for (std::size_t i = step + 1; i < n; ++i)
          {
            const long double factor = A[i][step] / A[step][step];
            for (std::size_t j = step; j < n; ++j)
              A[i][j] -= factor * A[step][j];
            b[i] -= factor * b[step];
          }
      }
    Column x(n);
    for (std::size_t i = n; i-- > 0;)
      {
        long double sum = b[i];
        for (std::size_t j = i + 1; j < n; ++j)
          sum -= A[i][j] * x[unknown[j]];
        x[unknown[i]] = sum / A[i][i];
      }
    return x;
  }

  /** An interface problem as plain numbers. */
  struct Data
  {
    dealii::FullMatrix<double>               stiffness;
    dealii::Vector<double>                   force;
    std::vector<Signorini::InterfaceContact> contacts;
  };

  inline Signorini::InterfaceProblem
  make_problem(const Data &data)
  {
    Signorini::InterfaceProblem problem;
    problem.set_stiffness(
      Signorini::InterfaceStiffness::from_matrix(data.stiffness));
    problem.set_force(data.force);
    problem.set_contacts(data.contacts);
    return problem;
  }

  inline double
  objective(const Data &data, const dealii::Vector<double> &du)
  {
    return 0.5 * data.stiffness.matrix_norm_square(du) - du * data.force;
  }

  /** B B^T + I / 10 with random B of small integers. */
  inline dealii::FullMatrix<double>
  random_stiffness(const unsigned int n, std::mt19937 &generator)
  {
    std::uniform_int_distribution<int> entry(-2, 2);
    dealii::FullMatrix<double>         B(n, n), S(n, n);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        B(i, j) = entry(generator);
    B.mTmult(S, B);
    S.diagadd(0.1);
    return S;
  }

  /** Small random problem; rows repeat, depend on others, or oppose them. */
  inline Data
  random_problem(const unsigned int n,
                 const unsigned int n_contacts,
                 std::mt19937      &generator)
  {
    std::uniform_int_distribution<int> entry(-2, 2), kind(0, 5);
    Data data{random_stiffness(n, generator), dealii::Vector<double>(n), {}};
    for (double &force : data.force)
      force = 3. * entry(generator);
    for (unsigned int k = 0; k < n_contacts; ++k)
      {
        Signorini::InterfaceContact contact;
        const int                   choice  = k < 2 ? 0 : kind(generator);
        const auto                  combine = [&](const unsigned int other,
                                 const double       factor) {
          for (const auto &[dof, coefficient] : data.contacts[other].normal)
            contact.normal.add(dof, factor * coefficient);
          contact.gap += factor * data.contacts[other].gap;
        };
        if (choice == 3)
          combine(k - 1, 1.);
        else if (choice == 4)
          {
            combine(k - 1, 1.);
            combine(k - 2, 1.);
          }
        else if (choice == 5)
          {
            combine(k - 1, -1.);
            contact.gap += 0.5;
          }
        else
          {
            for (unsigned int i = 0; i < n; ++i)
              contact.normal.add(i, entry(generator));
            contact.gap = 0.5 * entry(generator) + 0.5;
          }
        data.contacts.push_back(contact);
      }
    return data;
  }

  /** du from the optimality conditions of every set of closed contacts; nothing
   * if the constraints contradict each other. Sets with dependent rows can be
   * left out: one of their independent subsets carries the same forces. */
  inline std::optional<dealii::Vector<double>>
  brute_force(const Data &data)
  {
    const unsigned int n = data.force.size(), m = data.contacts.size();
    Matrix             A(m, Column(n, 0.L));
    for (unsigned int k = 0; k < m; ++k)
      for (const auto &[dof, coefficient] : data.contacts[k].normal)
        A[k][dof] += coefficient;

    for (unsigned int set = 0; set < (1U << m); ++set)
      {
        std::vector<unsigned int> active;
        for (unsigned int k = 0; k < m; ++k)
          if ((set >> k) & 1U)
            active.push_back(k);
        const unsigned int size = n + active.size();
        Matrix             K(size, Column(size, 0.L));
        Column             b(size);
        for (unsigned int i = 0; i < n; ++i)
          {
            b[i] = data.force(i);
            for (unsigned int j = 0; j < n; ++j)
              K[i][j] = data.stiffness(i, j);
          }
        for (unsigned int a = 0; a < active.size(); ++a)
          {
            b[n + a] = data.contacts[active[a]].gap;
            for (unsigned int i = 0; i < n; ++i)
              K[n + a][i] = K[i][n + a] = A[active[a]][i];
          }
        const std::optional<Column> x = solve(K, b);
        if (!x)
          continue;
        bool optimal = true;
        for (unsigned int a = 0; a < active.size(); ++a)
          optimal = optimal && (*x)[n + a] >= -1e-10L;
        for (unsigned int k = 0; k < m; ++k)
          {
            long double gap = data.contacts[k].gap;
            for (unsigned int i = 0; i < n; ++i)
              gap -= A[k][i] * (*x)[i];
            optimal = optimal && gap >= -1e-10L;
          }
        if (optimal)
          {
            dealii::Vector<double> du(n);
            for (unsigned int i = 0; i < n; ++i)
              du(i) = static_cast<double>((*x)[i]);
            return du;
          }
      }
    return std::nullopt;
  }

  /** A row of springs between neighbours and to the ground, pressed over
   * @p n_contacts nodes onto a flat floor below: n = 2 n_contacts DoFs, x and y
   * by turns. Displacements of the order of @p gap, in m. */
  inline Data
  springs_over_floor(const unsigned int n_contacts, const double gap)
  {
    const unsigned int n = 2 * n_contacts;
    Data data{dealii::FullMatrix<double>(n, n), dealii::Vector<double>(n), {}};
    const double spring = 3.7e8;
    for (unsigned int i = 0; i < n; ++i)
      {
        data.stiffness(i, i) += 0.05 * spring * (1. + 0.1 * (i % 7));
        if (i + 2 < n)
          {
            data.stiffness(i, i) += spring;
            data.stiffness(i + 2, i + 2) += spring;
            data.stiffness(i, i + 2) -= spring;
            data.stiffness(i + 2, i) -= spring;
          }
        if (i % 2 == 0)
          {
            data.stiffness(i, i + 1) += 0.01 * spring;
            data.stiffness(i + 1, i) += 0.01 * spring;
          }
      }
    for (unsigned int k = 0; k < n_contacts; ++k)
      {
        const double x = (k + 0.5) / n_contacts;
        data.force(2 * k + 1) =
          -0.05 * spring * gap * (0.4 + 5. * std::sin(9. * x) * x);
        data.contacts.push_back({{{2 * k + 1, -1.}}, gap});
      }
    return data;
  }
} // namespace InterfaceReference

#endif
