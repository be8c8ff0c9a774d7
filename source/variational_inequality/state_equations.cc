#include "state_equations.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace Signorini
{
  namespace
  {
    // More than rounding asks for, in case the matrix had to be regularised.
    constexpr unsigned int most_solves = 6;

    /** B of the projection of t = tau + v / w on the disc of radius f, and the
     * force f: with n = t / |t| and tau = f n,
     *   d(f n) = f' n dlambda + B dt,  B = f / |t| (I - n tau^T / max(f,
     * |tau|)).
     */
    struct ProjectionDerivative
    {
      ProjectionDerivative(const CoulombSystem       &system,
                           const ContactState        &state,
                           const unsigned int         k,
                           const unsigned int         component,
                           const std::vector<double> &x,
                           const std::vector<double> &y)
      {
        const DualContact &contact = system.contact(k);
        const unsigned int row     = contact.row;
        weight                     = system.tangential_weight(k);
        direction                  = state.direction[component - 1];
        slope               = state.capped ? 0. : contact.friction_coefficient;
        const double lambda = x[row] + y[row] / system.normal_weight(k);
        const double f      = contact.bound(lambda);
        const double t_length = std::hypot(x[row + 1] + y[row + 1] / weight,
                                           x[row + 2] + y[row + 2] / weight);
        const double largest  = std::max(f, std::hypot(x[row + 1], x[row + 2]));
        const double share    = t_length > 0. ? std::min(f / t_length, 1.) : 1.;
        for (unsigned int b = 0; b < 2; ++b)
          B[b] = share *
                 ((b + 1 == component ? 1. : 0.) -
                  (largest > 0. ? direction * x[row + 1 + b] / largest : 0.));
      }

      std::array<double, 2> B;
      double                weight, direction, slope;
    };
  } // namespace



  StateEquations::StateEquations(const CoulombSystem             &system,
                                 const std::vector<ContactState> &states,
                                 const std::vector<double>       &x,
                                 const std::vector<double>       &y)
    : system(system)
    , states(states)
    , x(x)
    , y(y)
    , equations(system.size())
    , scaling(system.size(), 1.)
    , base(system.size(), 0.)
  {
    for (unsigned int i = 0; i < system.size(); ++i)
      if (system(i, i) > 0.)
        scaling[i] = 1. / std::sqrt(system(i, i));
    for (unsigned int k = 0; k < states.size(); ++k)
      if (states[k].kind != ContactState::open)
        add_contact(k);
    base_residual = system.residual(base);
  }



  void
  StateEquations::add_contact(const unsigned int k)
  {
    const DualContact  &contact = system.contact(k);
    const ContactState &state   = states[k];
    const unsigned int  row     = contact.row;
    base[row]                   = x[row];
    equations[row].kind         = Kind::vanishing;
    for (unsigned int a = 1; a <= contact.n_tangents; ++a)
      {
        Equation &equation = equations[row + a];
        base[row + a]      = x[row + a];
        equation           = {Kind::vanishing, 0., row, k, a};
        if (state.kind != ContactState::slip)
          continue;
        if (contact.n_tangents > 1)
          {
            equation.kind = Kind::projection;
            linear        = false;
          }
        else if (state.capped)
          {
            equation.kind = Kind::given;
            base[row + a] = state.direction[0] * contact.largest_friction;
          }
        else
          {
            equation.kind  = Kind::bound;
            equation.slope = state.direction[0] * contact.friction_coefficient;
            base[row + a]  = equation.slope * base[row];
          }
      }
  }



  std::vector<DenseFactor::RowKey>
  StateEquations::keys() const
  {
    // A projection depends on the point: such a matrix does not come back.
    if (!linear)
      return {};
    std::vector<DenseFactor::RowKey> list;
    for (unsigned int i = 0; i < equations.size(); ++i)
      list.emplace_back(static_cast<int>(equations[i].kind),
                        equations[i].kind == Kind::vanishing ?
                          system.soft()[i] :
                          equations[i].slope);
    return list;
  }



  void
  StateEquations::write_row(const unsigned int i, double *entries) const
  {
    const Equation &equation = equations[i];
    if (equation.kind == Kind::projection)
      {
        write_projection(i, entries);
        return;
      }
    if (equation.kind == Kind::vanishing)
      {
        system.copy_row(i, entries);
        for (unsigned int j = 0; j < equations.size(); ++j)
          entries[j] *= scaling[i] * scaling[j];
        return;
      }
    std::fill(entries, entries + equations.size(), 0.);
    entries[i] = 1.;
    if (equation.kind == Kind::bound)
      entries[equation.normal] =
        -equation.slope * scaling[equation.normal] / scaling[i];
  }



  void
  StateEquations::write_projection(const unsigned int i, double *entries) const
  {
    const Equation            &equation = equations[i];
    const ProjectionDerivative derivative(system,
                                          states[equation.contact],
                                          equation.contact,
                                          equation.component,
                                          x,
                                          y);
    const unsigned int         row = equation.normal;
    for (unsigned int j = 0; j < equations.size(); ++j)
      {
        double entry = 0.;
        for (unsigned int b = 0; b < 2; ++b)
          entry += derivative.B[b] / derivative.weight * system(row + 1 + b, j);
        entries[j] = entry;
      }
    for (unsigned int b = 0; b < 2; ++b)
      entries[row + 1 + b] +=
        (b + 1 == equation.component ? 1. : 0.) - derivative.B[b];
    entries[row] -= derivative.slope * derivative.direction;
    for (unsigned int j = 0; j < equations.size(); ++j)
      entries[j] *= scaling[j] / scaling[i];
  }



  double
  StateEquations::projection_remainder(const unsigned int i) const
  {
    const Equation            &equation = equations[i];
    const ContactState        &state    = states[equation.contact];
    const ProjectionDerivative derivative(
      system, state, equation.contact, equation.component, x, y);
    const unsigned int row       = equation.normal;
    const double       bound     = state.capped ?
                                     system.contact(equation.contact).largest_friction :
                                     derivative.slope * x[row];
    double             remainder = bound * derivative.direction - x[i];
    for (unsigned int b = 0; b < 2; ++b)
      remainder += derivative.B[b] / derivative.weight *
                   (base_residual[row + 1 + b] - y[row + 1 + b]);
    return remainder / scaling[i];
  }



  std::vector<double>
  StateEquations::solve(DenseFactor &factor) const
  {
    const unsigned int n = equations.size();
    if (!factor.prepare(n, keys(), [this](const unsigned int i, double *row) {
          write_row(i, row);
        }))
      return {};

    // The first step solves; the others are iterative refinement, and what a
    // regularised matrix needs. A projection is improved by the next Newton
    // step instead.
    std::vector<double> point = base, left = base_residual, z(n);
    double              last = std::numeric_limits<double>::max();
    const unsigned int  n_steps =
      !linear ? 1 : (factor.is_regularised() ? most_solves : 2);
    for (unsigned int step = 0; step < n_steps; ++step)
      {
        double size = 0.;
        for (unsigned int i = 0; i < n; ++i)
          {
            z[i] =
              equations[i].kind == Kind::vanishing  ? scaling[i] * left[i] :
              equations[i].kind == Kind::projection ? projection_remainder(i) :
                                                      0.;
            if (equations[i].kind == Kind::vanishing)
              size = std::max(size, std::abs(z[i]));
          }
        if (step > 0 && !(size < last))
          break;
        last = size;
        factor.solve(z);
        for (unsigned int i = 0; i < n; ++i)
          if (equations[i].kind != Kind::given)
            point[i] += scaling[i] * z[i];
        for (unsigned int i = 0; i < n; ++i)
          if (equations[i].kind == Kind::bound)
            point[i] = equations[i].slope * point[equations[i].normal];
        left = system.residual(point);
      }
    return point;
  }
} // namespace Signorini
