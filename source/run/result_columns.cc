#include <signorini/contact/contact_pressures.h>
#include <signorini/input/instantiate.h>
#include <signorini/input/named_list.h>
#include <signorini/run/result_columns.h>

#include <algorithm>
#include <limits>
#include <numeric>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // On the contactor, N.
    template <int dim>
    Tensor<1, dim>
    contact_force(const ContactPoint<dim> &point,
                  const InterfaceForces   &forces,
                  const unsigned int       k)
    {
      Tensor<1, dim> force = forces.normal[k] * point.normal;
      for (unsigned int j = 0; j < dim - 1; ++j)
        force -= forces.tangential[k][j] * point.tangents[j];
      return force;
    }

    template <int dim>
    void
    measure_processes(const ContactPair<dim>               &pair,
                      const std::vector<ContactPoint<dim>> &points,
                      const ContactState                   &state,
                      PairResult<dim>                      &result)
    {
      for (const auto &process : pair.law.processes())
        {
          const auto &values  = state.quantities.at(process->quantity().name);
          double      largest = 0., integral = 0.;
          for (unsigned int n = 0; n < pair.contactor.nodes.size(); ++n)
            {
              const unsigned int k = pair.first_contact + n;
              largest              = std::max(largest, values[k]);
              integral += values[k] * points[k].area;
            }
          result.maxima.push_back(largest);
          result.integrals.push_back(integral);
        }
    }

    template <int dim>
    PairResult<dim>
    pair_result(const ContactPair<dim>               &pair,
                const std::vector<ContactPoint<dim>> &points,
                const ContactState                   &state)
    {
      PairResult<dim> result;
      result.gap_min         = std::numeric_limits<double>::max();
      double     total_force = 0., total_area = 0.;
      const auto pressures =
        contact_pressures(pair, points, state.forces.normal);
      for (unsigned int n = 0; n < pair.contactor.nodes.size(); ++n)
        {
          const unsigned int k     = pair.first_contact + n;
          const double       force = state.forces.normal[k];
          result.gap_min           = std::min(result.gap_min, state.gaps[k]);
          result.pressure_max = std::max(result.pressure_max, pressures[n]);
          if (force <= 0.)
            continue;
          ++result.n_contacts;
          result.n_slipping += state.is_slipping[k];
          result.force += contact_force(points[k], state.forces, k);
          total_force += force;
          total_area += points[k].area;
        }
      if (total_area > 0.)
        result.pressure_mean = total_force / total_area;
      measure_processes(pair, points, state, result);
      return result;
    }

    template <int dim>
    using Table = std::vector<ResultColumn<dim>>;

    // A component of a vector over all unknowns.
    template <int dim>
    std::function<double(const ResultState<dim> &)>
    entry_of(DofVector State::*const vector, const unsigned int dof)
    {
      return [=](const ResultState<dim> &s) { return (s.state.*vector)[dof]; };
    }

    template <int dim>
    void
    add_step(Table<dim> &table)
    {
      table.push_back({"iterations", "", [](const ResultState<dim> &s) {
                         return double(s.state.n_iterations);
                       }});
      table.push_back({"residual", "", [](const ResultState<dim> &s) {
                         return s.state.residual;
                       }});
      table.push_back({"kkt_residual", "", [](const ResultState<dim> &s) {
                         return s.state.kkt_residual;
                       }});
    }

    // Displacement and velocity of these unknowns, x, y, ...
    template <int dim, typename Dofs>
    void
    add_motion(const std::string &name, const Dofs &dofs, Table<dim> &table)
    {
      for (unsigned int c = 0; c < dim; ++c)
        table.push_back({name + ".displacement_" + component_name(c),
                         "m",
                         entry_of<dim>(&State::displacement, dofs[c])});
      for (unsigned int c = 0; c < dim; ++c)
        table.push_back({name + ".velocity_" + component_name(c),
                         "m/s",
                         entry_of<dim>(&State::velocity, dofs[c])});
    }

    template <int dim>
    void
    add_pair(const ContactPair<dim> &pair,
             const unsigned int      p,
             Table<dim>             &table)
    {
      using Result   = PairResult<dim>;
      const auto add = [&](const std::string                           &name,
                           const std::string                           &unit,
                           const std::function<double(const Result &)> &value) {
        table.push_back(
          {pair.name + "." + name, unit, [=](const ResultState<dim> &s) {
             return value(s.pairs[p]);
           }});
      };
      add("contacts", "", [](const Result &r) { return r.n_contacts; });
      if (!pair.law.friction().is_frictionless())
        add("slipping", "", [](const Result &r) { return r.n_slipping; });
      for (unsigned int c = 0; c < dim; ++c)
        add("force_" + component_name(c), "N", [c](const Result &r) {
          return r.force[c];
        });
      add("pressure_max", "Pa", [](const Result &r) { return r.pressure_max; });
      add("pressure_mean", "Pa", [](const Result &r) {
        return r.pressure_mean;
      });
      add("gap_min", "m", [](const Result &r) { return r.gap_min; });
      add("penetration", "m", [](const Result &r) {
        return std::max(0., -r.gap_min);
      });
      for (unsigned int i = 0; i < pair.law.processes().size(); ++i)
        {
          const auto &quantity = pair.law.processes()[i]->quantity();
          add(quantity.name, quantity.unit, [i](const Result &r) {
            return r.maxima[i];
          });
          add(quantity.integral, quantity.integral_unit, [i](const Result &r) {
            return r.integrals[i];
          });
        }
    }

    // Momentum of a free rigid body; angular momentum about the origin.
    template <int dim>
    void
    add_rigid_momentum(const RigidBody<dim> &body, Table<dim> &table)
    {
      const auto         dofs     = body.unknowns();
      const unsigned int first    = body.first_unknown();
      const auto         momentum = [=](const State &state) {
        Tensor<1, dim> result;
        for (unsigned int c = 0; c < dim; ++c)
          result[c] = dofs[c].mass * state.velocity[first + c];
        return result;
      };
      for (unsigned int c = 0; c < dim; ++c)
        table.push_back(
          {body.name() + ".momentum_" + component_name(c),
           "kg m/s",
           [=](const ResultState<dim> &s) { return momentum(s.state)[c]; }});
      if (dim == 3)
        return;
      table.push_back(
        {body.name() + ".angular_momentum",
         "kg m^2/s",
         [=, &body](const ResultState<dim> &s) {
           const RigidPlacement<dim> placement =
             body.placement(s.state.configuration());
           const Tensor<1, dim> place =
             Tensor<1, dim>(placement.centre) + placement.translation;
           // The unknown of rotation is an arc, and its mass
           // that on the lever.
           return quarter_turn<dim>(place) * momentum(s.state) +
                  body.lever() * dofs[2].mass * s.state.velocity[first + 2];
         }});
    }

    template <int dim>
    void
    add_rigid_body(const RigidBody<dim> &body,
                   const bool            is_dynamic,
                   Table<dim>           &table)
    {
      const unsigned int            first = body.first_unknown();
      std::array<unsigned int, dim> dofs;
      std::iota(dofs.begin(), dofs.end(), first);
      add_motion(body.name(), dofs, table);
      if (dim == 2)
        {
          const double lever = body.lever();
          table.push_back(
            {body.name() + ".angle", "rad", [=](const ResultState<dim> &s) {
               return s.state.displacement[first + 2] / lever;
             }});
          table.push_back({body.name() + ".angular_velocity",
                           "rad/s",
                           [=](const ResultState<dim> &s) {
                             return s.state.velocity[first + 2] / lever;
                           }});
        }
      if (is_dynamic)
        add_rigid_momentum(body, table);
    }

    // Momentum, angular momentum and centre of body b.
    template <int dim>
    void
    add_body_motion(const Body<dim>   &body,
                    const unsigned int b,
                    Table<dim>        &table)
    {
      const bool is_axisymmetric =
        body.formulation() == Formulation::axisymmetric;
      const auto add = [&](const std::string  &name,
                           const std::string  &unit,
                           BodyMotion::Vector3 BodyMotion::*const vector,
                           const unsigned int                     c) {
        table.push_back(
          {body.name() + "." + name, unit, [=](const ResultState<dim> &s) {
             return (s.state.motions[b].*vector)[c];
           }});
      };
      const unsigned int first = is_axisymmetric ? 1 : 0;
      for (unsigned int c = first; c < dim; ++c)
        add("momentum_" + component_name(c),
            "kg m/s",
            &BodyMotion::momentum,
            c);
      if (dim == 3)
        for (unsigned int c = 0; c < dim; ++c)
          add("angular_momentum_" + component_name(c),
              "kg m^2/s",
              &BodyMotion::angular_momentum,
              c);
      else if (!is_axisymmetric)
        add("angular_momentum", "kg m^2/s", &BodyMotion::angular_momentum, 2);
      for (unsigned int c = first; c < dim; ++c)
        add("centre_" + component_name(c), "m", &BodyMotion::centre, c);
    }

    template <int dim>
    void
    add_ledger(Table<dim> &table)
    {
      using Kind     = EnergyLedger::Kind;
      const auto add = [&](const Kind kind, const std::string &prefix) {
        for (const auto &entry : EnergyLedger::entries())
          if (entry.kind == kind && entry.name != "initial")
            table.push_back({prefix + entry.name,
                             "J",
                             [value = entry.value](const ResultState<dim> &s) {
                               return s.state.energy.*value;
                             }});
      };
      add(Kind::kept, "energy.");
      add(Kind::taken, "energy.");
      table.push_back(
        {"energy.scheme_loss", "J", [](const ResultState<dim> &s) {
           return s.state.energy.scheme_loss();
         }});
      add(Kind::input, "work.");
    }
  } // namespace



  unsigned int
  n_active_contacts(const State &state)
  {
    return std::count_if(state.contact.forces.normal.begin(),
                         state.contact.forces.normal.end(),
                         [](const double force) { return force > 0.; });
  }



  template <int dim>
  ResultState<dim>::ResultState(const Problem<dim> &problem, const State &state)
    : state(state)
  {
    const auto points = problem.contact->evaluate(state.configuration());
    for (const auto &pair : problem.contact->pairs())
      pairs.push_back(pair_result(pair, points, state.contact));
  }



  template <int dim>
  std::vector<ResultColumn<dim>>
  result_columns(const Problem<dim> &problem)
  {
    Table<dim> table;
    add_step(table);
    for (const auto &monitor : problem.output.monitors)
      add_motion(monitor.name, monitor.node.dofs, table);
    for (unsigned int p = 0; p < problem.contact->pairs().size(); ++p)
      add_pair(problem.contact->pairs()[p], p, table);
    for (const auto &body : problem.rigid_bodies)
      if (body->is_free())
        add_rigid_body(*body, problem.time.dynamic, table);
    if (problem.time.dynamic)
      for (unsigned int b = 0; b < problem.solid->parts().size(); ++b)
        add_body_motion(*problem.solid->parts()[b].body, b, table);
    add_ledger(table);
    return table;
  }



  template <int dim>
  void
  add_columns(const std::vector<ResultColumn<dim>> &table, History &history)
  {
    for (const auto &column : table)
      history.add_column(column.name, column.unit);
  }



  template <int dim>
  void
  append_row(const std::vector<ResultColumn<dim>> &table,
             const Problem<dim>                   &problem,
             const State                          &state,
             History                              &history)
  {
    const ResultState<dim> result(problem, state);
    std::vector<double>    row = {state.time};
    for (const auto &column : table)
      row.push_back(column.value(result));
    history.append_row(row);
  }



#define INSTANTIATE(dim)                                            \
  template std::vector<ResultColumn<dim>> result_columns(           \
    const Problem<dim> &);                                          \
  template void add_columns(const std::vector<ResultColumn<dim>> &, \
                            History &);                             \
  template void append_row(const std::vector<ResultColumn<dim>> &,  \
                           const Problem<dim> &,                    \
                           const State &,                           \
                           History &);
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
