#include "state_equations.h"

#include <algorithm>
#include <cmath>

namespace Signorini
{
  namespace
  {
    // More than rounding asks for, in case the matrix had to be regularised.
    constexpr unsigned int most_corrections = 6;
  } // namespace



  StateEquations::StateEquations(const CoulombSystem             &system,
                                 const std::vector<ContactState> &states,
                                 const std::vector<double>       &x,
                                 const std::vector<double>       &y)
    : system(system)
    , states(states)
    , x(x)
    , y(y)
    , base(system.size(), 0.)
  {
    for (unsigned int k = 0; k < states.size(); ++k)
      if (states[k].kind != ContactState::open)
        add_contact(k, x);
    base_residual = system.residual(base);
  }



  void
  StateEquations::add_contact(const unsigned int         k,
                              const std::vector<double> &x)
  {
    const DualContact  &contact = system.contact(k);
    const ContactState &state   = states[k];
    const unsigned int  row     = contact.row;
    const double slope = state.capped ? 0. : contact.friction_coefficient;
    base[row]          = x[row];
    if (state.kind == ContactState::slip && contact.n_tangents == 1)
      {
        const double sign = state.direction[0];
        base[row + 1] =
          sign * (state.capped ? contact.largest_friction : slope * base[row]);
        unknowns.push_back({row, row + 1, sign * slope});
        return;
      }
    unknowns.push_back({row, row, 0.});
    for (unsigned int a = 1; a <= contact.n_tangents; ++a)
      {
        base[row + a] = x[row + a];
        if (state.kind == ContactState::slip)
          {
            linear = false;
            projections.push_back(
              {static_cast<unsigned int>(unknowns.size()), k, a});
          }
        unknowns.push_back({row + a, row + a, 0.});
      }
  }



  double
  StateEquations::scaling(const unsigned int row) const
  {
    const double diagonal = system(row, row);
    return diagonal > 0. ? 1. / std::sqrt(diagonal) : 1.;
  }



  DenseFactor::Key
  StateEquations::key() const
  {
    // A projection depends on the point: such a matrix does not come back.
    if (!linear)
      return {};
    DenseFactor::Key numbers = system.soft();
    for (const Unknown &unknown : unknowns)
      {
        numbers.push_back(unknown.row);
        numbers.push_back(unknown.slope);
      }
    return numbers;
  }



  std::vector<double>
  StateEquations::matrix() const
  {
    const unsigned int  n = unknowns.size();
    std::vector<double> scale(n), matrix(std::size_t(n) * n);
    for (unsigned int i = 0; i < n; ++i)
      scale[i] = scaling(unknowns[i].row);
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < n; ++i)
        {
          double entry = system(unknowns[i].row, unknowns[j].row);
          if (unknowns[j].slope != 0.)
            entry +=
              unknowns[j].slope * system(unknowns[i].row, unknowns[j].follower);
          matrix[i + std::size_t(j) * n] = scale[i] * scale[j] * entry;
        }
    for (const Projection &projection : projections)
      linearise_projection(projection, matrix, nullptr);
    return matrix;
  }



  void
  StateEquations::linearise_projection(const Projection    &projection,
                                       std::vector<double> &matrix,
                                       double *right_hand_side) const
  {
    // With t = tau + v / w, n = t / |t|: tau = f n, and
    // d(f n) = f' n dlambda + B dt, B = f / |t| (I - n tau^T / max(f, |tau|)).
    const DualContact  &contact = system.contact(projection.contact);
    const ContactState &state   = states[projection.contact];
    const unsigned int  row = contact.row, a = projection.component;
    const double        weight = system.tangential_weight(projection.contact);
    const double        lambda =
      x[row] + y[row] / system.normal_weight(projection.contact);
    const double f        = contact.bound(lambda);
    const double n[2]     = {state.direction[0], state.direction[1]};
    const double t_length = std::hypot(x[row + 1] + y[row + 1] / weight,
                                       x[row + 2] + y[row + 2] / weight);
    const double largest  = std::max(f, std::hypot(x[row + 1], x[row + 2]));
    const double share    = t_length > 0. ? std::min(f / t_length, 1.) : 1.;
    double       B[2];
    for (unsigned int b = 0; b < 2; ++b)
      B[b] =
        share * ((b + 1 == a ? 1. : 0.) -
                 (largest > 0. ? n[a - 1] * x[row + 1 + b] / largest : 0.));
    const double slope = state.capped ? 0. : contact.friction_coefficient;
    const double scale = 1. / scaling(row + a);

    if (right_hand_side != nullptr)
      {
        double value = -(x[row + a] - (state.capped ? contact.largest_friction :
                                                      slope * x[row]) *
                                        n[a - 1]);
        for (unsigned int b = 0; b < 2; ++b)
          value +=
            B[b] / weight * (base_residual[row + 1 + b] - y[row + 1 + b]);
        // In the units of the other rows.
        *right_hand_side = value / (scaling(row + a) * scaling(row + a));
        return;
      }
    const unsigned int size = unknowns.size(), i = projection.unknown;
    for (unsigned int j = 0; j < size; ++j)
      {
        const Unknown &unknown = unknowns[j];
        double         entry   = 0.;
        for (unsigned int b = 0; b < 2; ++b)
          {
            double compliance = system(row + 1 + b, unknown.row);
            if (unknown.slope != 0.)
              compliance +=
                unknown.slope * system(row + 1 + b, unknown.follower);
            entry += B[b] / weight * compliance;
            if (unknown.row == row + 1 + b)
              entry += (b + 1 == a ? 1. : 0.) - B[b];
          }
        if (unknown.row == row)
          entry -= slope * n[a - 1];
        matrix[i + std::size_t(j) * size] =
          scale * scaling(unknown.row) * entry;
      }
  }



  void
  StateEquations::add_step(std::vector<double> &z,
                           std::vector<double> &point) const
  {
    for (unsigned int i = 0; i < unknowns.size(); ++i)
      {
        const Unknown &unknown = unknowns[i];
        const double   step    = scaling(unknown.row) * z[i];
        point[unknown.row] += step;
        if (unknown.slope != 0.)
          point[unknown.follower] += unknown.slope * step;
      }
  }



  std::vector<double>
  StateEquations::solve(DenseFactor &factor) const
  {
    const DenseFactor::Key this_key = key();
    if (this_key.empty() || !factor.has_key(this_key))
      if (!factor.factorise(unknowns.size(), matrix(), this_key))
        return {};

    // The first step solves; the others are iterative refinement, and what a
    // regularised matrix needs. A projection is improved by the next Newton
    // step instead.
    std::vector<double> point = base, left = base_residual, z(unknowns.size());
    double              last = std::numeric_limits<double>::max();
    const unsigned int  n_steps =
      !linear ? 1 : (factor.is_regularised() ? most_corrections : 2);
    for (unsigned int step = 0; step < n_steps; ++step)
      {
        double size = 0.;
        for (unsigned int i = 0; i < unknowns.size(); ++i)
          {
            z[i] = scaling(unknowns[i].row) * left[unknowns[i].row];
            size = std::max(size, std::abs(z[i]));
          }
        if (step > 0 && !(size < last))
          break;
        last = size;
        for (const Projection &projection : projections)
          {
            std::vector<double> none;
            double              value = 0.;
            linearise_projection(projection, none, &value);
            z[projection.unknown] =
              scaling(unknowns[projection.unknown].row) * value;
          }
        factor.solve(z);
        add_step(z, point);
        left = system.residual(point);
      }
    return point;
  }
} // namespace Signorini
