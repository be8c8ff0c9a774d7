#ifndef signorini_tests_unit_friction_reference_h
#define signorini_tests_unit_friction_reference_h

#include <signorini/variational_inequality/interface_problem.h>

#include <cmath>
#include <random>
#include <vector>

#include "interface_reference.h"

// Problems with friction in two dimensions and all their solutions, by trying
// every state of every contact.
namespace FrictionReference
{
  using InterfaceReference::Column;
  using InterfaceReference::Data;
  using InterfaceReference::Matrix;

  /** Tries each combination of open, stick, slip to either side, and slip under
   * the largest friction, on the dual W x + y = d of all rows. */
  class StateSearch
  {
  public:
    explicit StateSearch(const Data &data)
      : data(data)
      , m(data.contacts.size())
      , n(data.force.size())
      , states(m)
    {
      // 1. Rows: the normals, then the tangents.
      rows.assign(2 * m, Column(n, 0.L));
      for (unsigned int k = 0; k < m; ++k)
        {
          for (const auto &[dof, coefficient] : data.contacts[k].normal)
            rows[k][dof] += coefficient;
          for (const auto &[dof, coefficient] : data.contacts[k].tangents[0])
            rows[m + k][dof] += coefficient;
        }
      // 2. S^-1 of the force and of every row.
      Matrix S(n, Column(n));
      Column r(n);
      for (unsigned int i = 0; i < n; ++i)
        {
          r[i] = data.force(i);
          for (unsigned int j = 0; j < n; ++j)
            S[i][j] = data.stiffness(i, j);
        }
      free = *InterfaceReference::solve(S, r);
      for (const Column &row : rows)
        responses.push_back(*InterfaceReference::solve(S, row));
      W.assign(2 * m, Column(2 * m));
      d.assign(2 * m, 0.L);
      for (unsigned int i = 0; i < 2 * m; ++i)
        {
          for (unsigned int j = 0; j < 2 * m; ++j)
            W[i][j] = dot(rows[i], responses[j]);
          d[i] = dot(rows[i], free) +
                 (i < m ? -data.contacts[i].gap : data.contacts[i - m].slip[0]);
        }
    }

    /** The displacements of all solutions that differ. */
    std::vector<Column>
    run()
    {
      choose(0);
      return solutions;
    }

  private:
    enum State
    {
      open,
      stick,
      forwards,
      backwards,
      forwards_capped,
      backwards_capped,
      n_states
    };

    static long double
    dot(const Column &a, const Column &b)
    {
      long double sum = 0;
      for (std::size_t i = 0; i < a.size(); ++i)
        sum += a[i] * b[i];
      return sum;
    }

    static int
    sign(const State state)
    {
      return state == forwards || state == forwards_capped ? 1 : -1;
    }

    void
    choose(const unsigned int k)
    {
      if (k == m)
        {
          try_states();
          return;
        }
      for (int state = open; state < n_states; ++state)
        {
          if (state >= forwards_capped &&
              std::isinf(data.contacts[k].largest_friction))
            continue;
          states[k] = State(state);
          choose(k + 1);
        }
    }

    void
    try_states()
    {
      // 1. Unknown: lambda where closed, tau where stuck.
      std::vector<unsigned int> unknown;
      for (unsigned int k = 0; k < m; ++k)
        if (states[k] != open)
          unknown.push_back(k);
      for (unsigned int k = 0; k < m; ++k)
        if (states[k] == stick)
          unknown.push_back(m + k);
      if (unknown.size() > n)
        return; // dependent rows: contradictory, or never alone
      Matrix A(unknown.size(), Column(unknown.size()));
      Column b(unknown.size());
      for (unsigned int i = 0; i < unknown.size(); ++i)
        {
          b[i] = d[unknown[i]];
          for (unsigned int j = 0; j < unknown.size(); ++j)
            A[i][j] = W[unknown[i]][unknown[j]];
          for (unsigned int j = 0; j < unknown.size(); ++j)
            {
              const unsigned int k = unknown[j];
              if (k < m && (states[k] == forwards || states[k] == backwards))
                A[i][j] += sign(states[k]) *
                           data.contacts[k].friction_coefficient *
                           W[unknown[i]][m + k];
            }
          for (unsigned int k = 0; k < m; ++k)
            if (states[k] >= forwards_capped)
              b[i] -= sign(states[k]) * data.contacts[k].largest_friction *
                      W[unknown[i]][m + k];
        }
      const auto z = InterfaceReference::solve(A, b);
      if (!z)
        return;
      Column x(2 * m, 0.L);
      for (unsigned int i = 0; i < unknown.size(); ++i)
        x[unknown[i]] = (*z)[i];
      for (unsigned int k = 0; k < m; ++k)
        if (states[k] >= forwards_capped)
          x[m + k] = sign(states[k]) * data.contacts[k].largest_friction;
        else if (states[k] >= forwards)
          x[m + k] =
            sign(states[k]) * data.contacts[k].friction_coefficient * x[k];
      if (satisfies_coulomb(x))
        keep(x);
    }

    bool
    satisfies_coulomb(const Column &x) const
    {
      constexpr long double tolerance = 1e-10L;
      for (unsigned int k = 0; k < m; ++k)
        {
          const long double e    = d[k] - dot(W[k], x);
          const long double v    = d[m + k] - dot(W[m + k], x);
          const long double cap  = data.contacts[k].largest_friction;
          const long double cone = data.contacts[k].friction_coefficient * x[k];
          if (states[k] == open && e > tolerance)
            return false;
          if (x[k] < -tolerance)
            return false;
          if (states[k] == stick &&
              std::abs(x[m + k]) > std::min(cone, cap) + tolerance)
            return false;
          if (states[k] >= forwards && sign(states[k]) * v < -tolerance)
            return false;
          if ((states[k] == forwards || states[k] == backwards) &&
              cone > cap + tolerance)
            return false;
          if (states[k] >= forwards_capped && cone < cap - tolerance)
            return false;
        }
      return true;
    }

    void
    keep(const Column &x)
    {
      Column du = free;
      for (unsigned int i = 0; i < 2 * m; ++i)
        for (unsigned int j = 0; j < n; ++j)
          du[j] -= x[i] * responses[i][j];
      for (const Column &other : solutions)
        {
          long double difference = 0;
          for (unsigned int j = 0; j < n; ++j)
            difference = std::max(difference, std::abs(du[j] - other[j]));
          if (difference < 1e-7L)
            return;
        }
      solutions.push_back(du);
    }

    const Data         &data;
    unsigned int        m, n;
    std::vector<State>  states;
    Matrix              rows, responses, W;
    Column              free, d;
    std::vector<Column> solutions;
  };

  /** A stiffness, positive definite, and a force, without contacts. */
  inline Data
  random_system(const unsigned int n, std::mt19937 &generator)
  {
    std::uniform_real_distribution<double> real(-1., 1.);
    Data data{dealii::FullMatrix<double>(n, n), dealii::Vector<double>(n), {}};
    dealii::FullMatrix<double> B(n, n);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        B(i, j) = real(generator);
    B.mTmult(data.stiffness, B);
    data.stiffness.diagadd(0.3);
    for (double &force : data.force)
      force = 3. * real(generator);
    return data;
  }

  /** Contacts at nodes of two DoFs, with rotated axes; sometimes two at one
   * node, sometimes against another node. One in four problems has rows of all
   * DoFs. Every friction coefficient from 0.05 to 1.5. */
  inline Data
  random_problem(const unsigned int n_nodes,
                 const unsigned int n_contacts,
                 std::mt19937      &generator)
  {
    const unsigned int                     n = 2 * n_nodes;
    std::uniform_real_distribution<double> real(-1., 1.), angle(0., 6.2831853);
    std::uniform_int_distribution<int>     dice(0, 3);
    Data                                   data = random_system(n, generator);

    const bool dense = dice(generator) == 0;
    for (unsigned int k = 0; k < n_contacts; ++k)
      {
        Signorini::InterfaceContact contact;
        contact.tangents.resize(1);
        if (dense)
          for (unsigned int i = 0; i < n; ++i)
            {
              contact.normal.add(i, real(generator));
              contact.tangents[0].add(i, real(generator));
            }
        else
          {
            const unsigned int node =
              dice(generator) == 0 ? k / 2 % n_nodes : k % n_nodes;
            const double phi = angle(generator);
            const double c = std::cos(phi), s = std::sin(phi);
            contact.normal           = {{2 * node, c}, {2 * node + 1, s}};
            contact.tangents[0]      = {{2 * node, -s}, {2 * node + 1, c}};
            const unsigned int other = (node + 1) % n_nodes;
            if (other != node && dice(generator) == 0)
              {
                contact.normal.add(2 * other, -c);
                contact.normal.add(2 * other + 1, -s);
                contact.tangents[0].add(2 * other, s);
                contact.tangents[0].add(2 * other + 1, -c);
              }
          }
        contact.gap     = 0.4 * real(generator);
        contact.slip[0] = dice(generator) == 0 ? 0. : 0.3 * real(generator);
        contact.friction_coefficient = 0.775 + 0.725 * real(generator);
        if (dice(generator) == 0)
          contact.largest_friction = 0.5 + 0.5 * real(generator);
        data.contacts.push_back(contact);
      }
    return data;
  }

  /** Contacts with two tangents at nodes of three DoFs, with rotated axes; now
   * and then two @p at_one_node, which may jam: then there is no solution. */
  inline Data
  random_spatial_problem(const unsigned int n_nodes,
                         const unsigned int n_contacts,
                         const bool         at_one_node,
                         std::mt19937      &generator)
  {
    const unsigned int                     n = 3 * n_nodes;
    std::uniform_real_distribution<double> real(-1., 1.);
    std::uniform_int_distribution<int>     dice(0, 5);
    Data                                   data = random_system(n, generator);

    for (unsigned int k = 0; k < n_contacts; ++k)
      {
        // 1. A frame: a unit normal and two directions across.
        std::array<std::array<double, 3>, 3> frame;
        for (unsigned int a = 0; a < 3; ++a)
          {
            for (double &entry : frame[a])
              entry = real(generator);
            for (unsigned int repetition = 0; repetition < 2; ++repetition)
              for (unsigned int b = 0; b < a; ++b)
                {
                  double product = 0.;
                  for (unsigned int i = 0; i < 3; ++i)
                    product += frame[a][i] * frame[b][i];
                  for (unsigned int i = 0; i < 3; ++i)
                    frame[a][i] -= product * frame[b][i];
                }
            const double length =
              std::hypot(frame[a][0], frame[a][1], frame[a][2]);
            for (double &entry : frame[a])
              entry /= length;
          }
        // 2. The contact.
        const unsigned int node =
          at_one_node && dice(generator) == 0 ? k / 2 % n_nodes : k % n_nodes;
        Signorini::InterfaceContact contact;
        contact.tangents.resize(2);
        for (unsigned int i = 0; i < 3; ++i)
          {
            contact.normal.add(3 * node + i, frame[0][i]);
            contact.tangents[0].add(3 * node + i, frame[1][i]);
            contact.tangents[1].add(3 * node + i, frame[2][i]);
          }
        contact.gap = 0.4 * real(generator);
        if (dice(generator) > 1)
          contact.slip = {{0.3 * real(generator), 0.3 * real(generator)}};
        contact.friction_coefficient = 0.775 + 0.725 * real(generator);
        if (dice(generator) == 0)
          contact.largest_friction = 0.5 + 0.5 * real(generator);
        data.contacts.push_back(contact);
      }
    return data;
  }

  /** The same problem where a metre reads @p length and a newton @p force. */
  inline Data
  in_units(Data data, const double length, const double force)
  {
    data.stiffness *= force / length;
    data.force *= force;
    for (Signorini::InterfaceContact &contact : data.contacts)
      {
        contact.gap *= length;
        contact.slip[0] *= length;
        contact.slip[1] *= length;
        contact.largest_friction *= force;
      }
    return data;
  }
} // namespace FrictionReference

#endif
