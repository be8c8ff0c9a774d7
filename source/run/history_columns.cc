#include <signorini/contact/contact_pressures.h>
#include <signorini/input/instantiate.h>
#include <signorini/input/named_list.h>
#include <signorini/run/history_columns.h>

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

    // What happens on one pair.
    template <int dim>
    struct PairResult
    {
      unsigned int   n_contacts = 0;
      unsigned int   n_slipping = 0;
      Tensor<1, dim> force;
      double         pressure_max  = 0.;
      double         pressure_mean = 0.;
      double         gap_min       = std::numeric_limits<double>::max();
    };

    template <int dim>
    PairResult<dim>
    pair_result(const ContactPair<dim>               &pair,
                const std::vector<ContactPoint<dim>> &points,
                const State                          &state)
    {
      PairResult<dim> result;
      double          total_force = 0., total_area = 0.;
      const auto      pressures =
        contact_pressures(pair, points, state.contact_forces.normal);
      for (unsigned int n = 0; n < pair.contactor.nodes.size(); ++n)
        {
          const unsigned int k     = pair.first_contact + n;
          const double       force = state.contact_forces.normal[k];
          result.gap_min           = std::min(result.gap_min, state.gaps[k]);
          result.pressure_max = std::max(result.pressure_max, pressures[n]);
          if (force <= 0.)
            continue;
          ++result.n_contacts;
          result.n_slipping += state.is_slipping[k];
          result.force += contact_force(points[k], state.contact_forces, k);
          total_force += force;
          total_area += points[k].area;
        }
      if (total_area > 0.)
        result.pressure_mean = total_force / total_area;
      return result;
    }

    template <int dim>
    void
    add_rigid_body_columns(const RigidBody<dim> &body, History &history)
    {
      for (unsigned int c = 0; c < dim; ++c)
        history.add_column(body.name() + ".displacement_" + component_name(c),
                           "m");
      for (unsigned int c = 0; c < dim; ++c)
        history.add_column(body.name() + ".velocity_" + component_name(c),
                           "m/s");
      if (dim == 3)
        return;
      history.add_column(body.name() + ".angle", "rad");
      history.add_column(body.name() + ".angular_velocity", "rad/s");
    }

    template <int dim>
    void
    append_rigid_body(const RigidBody<dim> &body,
                      const State          &state,
                      std::vector<double>  &row)
    {
      const unsigned int first = body.first_unknown();
      for (unsigned int c = 0; c < dim; ++c)
        row.push_back(state.displacement[first + c]);
      for (unsigned int c = 0; c < dim; ++c)
        row.push_back(state.velocity[first + c]);
      if (dim == 3)
        return;
      row.push_back(state.displacement[first + 2] / body.lever());
      row.push_back(state.velocity[first + 2] / body.lever());
    }
    // The components of momentum and centre of a body.
    template <int dim>
    std::vector<unsigned int>
    directions(const Body<dim> &body)
    {
      if (body.formulation() == Formulation::axisymmetric)
        return {1};
      std::vector<unsigned int> result(dim);
      std::iota(result.begin(), result.end(), 0u);
      return result;
    }

    template <int dim>
    void
    add_motion_columns(const Body<dim> &body, History &history)
    {
      const std::string name = body.name() + ".";
      for (const unsigned int c : directions(body))
        history.add_column(name + "momentum_" + component_name(c), "kg m/s");
      if (dim == 3)
        for (unsigned int c = 0; c < dim; ++c)
          history.add_column(name + "angular_momentum_" + component_name(c),
                             "kg m^2/s");
      else if (body.formulation() != Formulation::axisymmetric)
        history.add_column(name + "angular_momentum", "kg m^2/s");
      for (const unsigned int c : directions(body))
        history.add_column(name + "centre_" + component_name(c), "m");
    }

    template <int dim>
    void
    append_motion(const Body<dim>     &body,
                  const BodyMotion    &motion,
                  std::vector<double> &row)
    {
      for (const unsigned int c : directions(body))
        row.push_back(motion.momentum[c]);
      if (dim == 3)
        row.insert(row.end(),
                   motion.angular_momentum.begin(),
                   motion.angular_momentum.end());
      else if (body.formulation() != Formulation::axisymmetric)
        row.push_back(motion.angular_momentum[2]);
      for (const unsigned int c : directions(body))
        row.push_back(motion.centre[c]);
    }

    // Momentum of a free rigid body; angular momentum about the origin.
    template <int dim>
    void
    add_rigid_motion_columns(const RigidBody<dim> &body, History &history)
    {
      const std::string name = body.name() + ".";
      for (unsigned int c = 0; c < dim; ++c)
        history.add_column(name + "momentum_" + component_name(c), "kg m/s");
      if (dim == 2)
        history.add_column(name + "angular_momentum", "kg m^2/s");
    }

    template <int dim>
    void
    append_rigid_motion(const RigidBody<dim> &body,
                        const State          &state,
                        std::vector<double>  &row)
    {
      const auto         unknowns = body.unknowns();
      const unsigned int first    = body.first_unknown();
      Tensor<1, dim>     momentum;
      for (unsigned int c = 0; c < dim; ++c)
        {
          momentum[c] = unknowns[c].mass * state.velocity[first + c];
          row.push_back(momentum[c]);
        }
      if (dim == 3)
        return;
      const RigidPlacement<dim> placement =
        body.placement({state.displacement, state.time});
      const Tensor<1, dim> place =
        Tensor<1, dim>(placement.centre) + placement.translation;
      // The unknown of rotation is an arc, and its mass that on the lever.
      row.push_back(quarter_turn<dim>(place) * momentum +
                    body.lever() * unknowns[2].mass *
                      state.velocity[first + 2]);
    }
  } // namespace



  unsigned int
  n_active_contacts(const State &state)
  {
    return std::count_if(state.contact_forces.normal.begin(),
                         state.contact_forces.normal.end(),
                         [](const double force) { return force > 0.; });
  }



  template <int dim>
  void
  add_history_columns(const Problem<dim> &problem, History &history)
  {
    history.add_column("iterations", "");
    history.add_column("residual", "");
    history.add_column("kkt_residual", "");
    for (const auto &monitor : problem.output.monitors)
      {
        for (unsigned int c = 0; c < dim; ++c)
          history.add_column(monitor.name + ".displacement_" +
                               component_name(c),
                             "m");
        for (unsigned int c = 0; c < dim; ++c)
          history.add_column(monitor.name + ".velocity_" + component_name(c),
                             "m/s");
      }
    for (const auto &pair : problem.contact->pairs())
      {
        history.add_column(pair.name + ".contacts", "");
        if (!pair.friction.is_frictionless())
          history.add_column(pair.name + ".slipping", "");
        for (unsigned int c = 0; c < dim; ++c)
          history.add_column(pair.name + ".force_" + component_name(c), "N");
        history.add_column(pair.name + ".pressure_max", "Pa");
        history.add_column(pair.name + ".pressure_mean", "Pa");
        history.add_column(pair.name + ".gap_min", "m");
        history.add_column(pair.name + ".penetration", "m");
      }
    for (const auto &body : problem.rigid_bodies)
      if (body->is_free())
        {
          add_rigid_body_columns(*body, history);
          if (problem.time.dynamic)
            add_rigid_motion_columns(*body, history);
        }
    if (problem.time.dynamic)
      for (const auto &part : problem.solid->parts())
        add_motion_columns(*part.body, history);
    for (const char *const name : {"energy.kinetic",
                                   "energy.stored",
                                   "energy.plastic",
                                   "energy.damping",
                                   "energy.friction",
                                   "energy.scheme_loss",
                                   "work.loads",
                                   "work.supports",
                                   "work.contact",
                                   "work.returned"})
      history.add_column(name, "J");
  }



  template <int dim>
  void
  append_history_row(const Problem<dim> &problem,
                     const State        &state,
                     History            &history)
  {
    std::vector<double> row = {state.time,
                               double(state.n_iterations),
                               state.residual,
                               state.kkt_residual};
    for (const auto &monitor : problem.output.monitors)
      {
        for (const unsigned int dof : monitor.node.dofs)
          row.push_back(state.displacement[dof]);
        for (const unsigned int dof : monitor.node.dofs)
          row.push_back(state.velocity[dof]);
      }
    const auto points =
      problem.contact->evaluate({state.displacement, state.time});
    for (const auto &pair : problem.contact->pairs())
      {
        const PairResult<dim> result = pair_result(pair, points, state);
        row.push_back(result.n_contacts);
        if (!pair.friction.is_frictionless())
          row.push_back(result.n_slipping);
        for (unsigned int c = 0; c < dim; ++c)
          row.push_back(result.force[c]);
        row.push_back(result.pressure_max);
        row.push_back(result.pressure_mean);
        row.push_back(result.gap_min);
        row.push_back(std::max(0., -result.gap_min));
      }
    for (const auto &body : problem.rigid_bodies)
      if (body->is_free())
        {
          append_rigid_body(*body, state, row);
          if (problem.time.dynamic)
            append_rigid_motion(*body, state, row);
        }
    for (unsigned int b = 0; b < state.motions.size(); ++b)
      append_motion(*problem.solid->parts()[b].body, state.motions[b], row);
    const EnergyLedger &energy = state.energy;
    for (const double value : {energy.kinetic,
                               energy.stored,
                               energy.plastic,
                               energy.damping,
                               energy.friction,
                               energy.scheme_loss(),
                               energy.loads,
                               energy.supports,
                               energy.contact,
                               energy.returned})
      row.push_back(value);
    history.append_row(row);
  }



#define INSTANTIATE(dim)                                                   \
  template void add_history_columns<dim>(const Problem<dim> &, History &); \
  template void append_history_row<dim>(const Problem<dim> &,              \
                                        const State &,                     \
                                        History &);
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
