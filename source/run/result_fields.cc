#include <signorini/contact/contact_pressures.h>
#include <signorini/input/instantiate.h>
#include <signorini/input/named_list.h>
#include <signorini/output/run_folder.h>
#include <signorini/output/surface_table.h>
#include <signorini/run/result_fields.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    Point<3>
    in_space(const Point<dim> &point)
    {
      Point<3> result;
      for (unsigned int d = 0; d < dim; ++d)
        result[d] = point[d];
      return result;
    }

    // Of the contactor side of a pair.
    template <int dim>
    std::vector<std::string>
    surface_quantities(const ContactPair<dim> &pair)
    {
      std::vector<std::string> list = {
        "pressure", "gap", "shear", "slip", "status"};
      for (const auto &process : pair.law.processes())
        list.push_back(process->quantity().name);
      return list;
    }

    const std::string fringe_order = "fringe_order";

    // (sigma_1 - sigma_2)/f of the stresses in the x-y plane.
    DofVector
    fringe_orders(const std::map<std::string, DofVector> &stresses,
                  const double                            fringe_value)
    {
      const DofVector &xx = stresses.at("stress_xx");
      const DofVector &yy = stresses.at("stress_yy");
      const DofVector &xy = stresses.at("stress_xy");
      DofVector        result(xx.size());
      for (unsigned int n = 0; n < result.size(); ++n)
        result[n] = std::hypot(xx[n] - yy[n], 2. * xy[n]) / fringe_value;
      return result;
    }

    // A rigid body as a line that moves.
    template <int dim>
    SurfaceData<dim>
    outline_data(const RigidBody<dim> &body, const State &state)
    {
      const auto       placement = body.placement(state.configuration());
      SurfaceData<dim> data;
      std::vector<Tensor<1, dim>> displacement;
      data.name  = body.name() + ".outline";
      data.nodes = body.surface().outline();
      for (const auto &point : data.nodes)
        displacement.push_back(placement.to_space(point) - point);
      for (unsigned int n = 1; n < data.nodes.size(); ++n)
        data.faces.push_back({n - 1, n});
      data.vector_fields = {{"displacement", displacement}};
      return data;
    }
  } // namespace



  template <int dim>
  ResultFields<dim>::ResultFields(const Problem<dim> &problem)
    : problem_(problem)
  {
    for (const auto &part : problem.solid->parts())
      stresses_.push_back(std::make_unique<StressRecovery<dim>>(*part.body));
  }



  template <int dim>
  void
  ResultFields<dim>::show(const State &state)
  {
    state_ = &state;
    contact_points_.clear();
  }



  template <int dim>
  std::vector<std::string>
  ResultFields<dim>::stress_names() const
  {
    std::vector<std::string> list = StressRecovery<dim>::names();
    if (problem_.output.fringe_value > 0.)
      list.push_back(fringe_order);
    return list;
  }



  template <int dim>
  std::map<std::string, DofVector>
  ResultFields<dim>::stresses(const unsigned int body) const
  {
    auto result = stresses_[body]->fields(
      state_->displacement, problem_.solid->history_of(body, state_->history));
    if (problem_.output.fringe_value > 0.)
      result[fringe_order] =
        fringe_orders(result, problem_.output.fringe_value);
    return result;
  }



  template <int dim>
  std::vector<std::string>
  ResultFields<dim>::names() const
  {
    std::vector<std::string> quantities;
    for (unsigned int c = 0; c < dim; ++c)
      for (const char *const vector : {"displacement_", "velocity_"})
        quantities.push_back(vector + component_name(c));
    for (const std::string &name : stress_names())
      quantities.push_back(name);

    std::vector<std::string> list;
    for (const auto &part : problem_.solid->parts())
      {
        std::vector<std::string> prefixes = {part.body->name() + "."};
        for (const auto &[boundary, id] : part.body->mesh().boundaries)
          prefixes.push_back(prefixes[0] + boundary + ".");
        for (const std::string &prefix : prefixes)
          for (const std::string &quantity : quantities)
            list.push_back(prefix + quantity);
      }
    for (const auto &pair : problem_.contact->pairs())
      for (const std::string &name : surface_quantities(pair))
        list.push_back(pair.name + "." + name);
    return list;
  }



  template <int dim>
  NodalField
  ResultFields<dim>::field(const std::string &name) const
  {
    Assert(state_ != nullptr, ExcNotInitialized());
    const std::size_t last_dot = name.rfind('.');
    const std::string owner    = name.substr(0, last_dot);
    const std::string quantity = name.substr(last_dot + 1);

    // Names of bodies have no dot.
    const std::size_t dot  = owner.find('.');
    const std::string body = owner.substr(0, dot);
    const std::string boundary =
      dot == std::string::npos ? std::string() : owner.substr(dot + 1);
    for (const auto &pair : problem_.contact->pairs())
      if (pair.name == owner)
        {
          const auto quantities = surface_quantities(pair);
          if (std::count(quantities.begin(), quantities.end(), quantity) > 0)
            return surface_field(pair, quantity);
        }
    for (unsigned int b = 0; b < problem_.solid->parts().size(); ++b)
      if (problem_.solid->parts()[b].body->name() == body)
        return body_field(b, boundary, quantity);
    Assert(false, ExcMessage("There is no field " + name));
    return {};
  }



  template <int dim>
  NodalField
  ResultFields<dim>::body_field(const unsigned int b,
                                const std::string &boundary,
                                const std::string &quantity) const
  {
    NodalField        result;
    const Body<dim>  &body       = *problem_.solid->parts()[b].body;
    const std::size_t underscore = quantity.find('_');
    const std::string vector     = quantity.substr(0, underscore);
    if (vector == "displacement" || vector == "velocity")
      {
        const unsigned int component =
          parse_component<dim>(quantity.substr(underscore + 1),
                               "Expected results");
        const DofVector &values =
          vector == "velocity" ? state_->velocity : state_->displacement;
        for (const auto &node :
             boundary.empty() ? body.nodes() : body.boundary_nodes(boundary))
          {
            result.points.push_back(in_space(node.point));
            result.values.push_back(values[node.dofs[component]]);
          }
        return result;
      }
    const DofVector values = stresses(b).at(quantity);
    const auto      points = stresses_[b]->points();
    for (const unsigned int n : boundary.empty() ?
                                  complete_index_set(values.size()) :
                                  stresses_[b]->boundary_nodes(boundary))
      {
        result.points.push_back(in_space(points[n]));
        result.values.push_back(values[n]);
      }
    return result;
  }



  template <int dim>
  NodalField
  ResultFields<dim>::surface_field(const ContactPair<dim> &pair,
                                   const std::string      &quantity) const
  {
    NodalField             result;
    const SurfaceData<dim> data = surface_data(pair);
    for (const auto &node : data.nodes)
      result.points.push_back(in_space(node));
    for (const auto &[name, values] : data.scalar_fields)
      if (name == quantity)
        result.values = values;
    return result;
  }



  template <int dim>
  const std::vector<ContactPoint<dim>> &
  ResultFields<dim>::contact_points() const
  {
    if (contact_points_.empty())
      contact_points_ = problem_.contact->evaluate(state_->configuration());
    return contact_points_;
  }



  template <int dim>
  SurfaceData<dim>
  ResultFields<dim>::surface_data(const ContactPair<dim> &pair) const
  {
    const auto &points = contact_points();
    const auto  pressures =
      contact_pressures(pair, points, state_->contact.forces.normal);
    SurfaceData<dim>            data;
    std::vector<double>         gap, pressure, shear, slip, status;
    std::vector<Tensor<1, dim>> traction, normal, displacement;
    for (unsigned int n = 0; n < pair.contactor.nodes.size(); ++n)
      {
        const unsigned int k    = pair.first_contact + n;
        const auto        &node = pair.contactor.nodes[n];
        const double       p    = pressures[n];
        data.nodes.push_back(node.point);
        // Out of reach there is no gap to show.
        gap.push_back(std::isfinite(state_->contact.gaps[k]) ?
                        state_->contact.gaps[k] :
                        std::numeric_limits<float>::quiet_NaN());
        pressure.push_back(p);
        status.push_back(p <= 0.                        ? 0. :
                         state_->contact.is_slipping[k] ? 2. :
                                                          1.);
        normal.push_back(points[k].normal);
        Tensor<1, dim> t      = p * points[k].normal;
        const auto    &forces = state_->contact.forces.tangential[k];
        for (unsigned int j = 0; j < dim - 1; ++j)
          t -= points[k].pressure(forces[j]) * points[k].tangents[j];
        traction.push_back(t);

        // In 2-D along the tangent, in 3-D the size.
        shear.push_back(points[k].pressure(
          dim == 2 ? -forces[0] : std::hypot(forces[0], forces[1])));
        slip.push_back(dim == 2 ? state_->contact.slips[k][0] :
                                  std::hypot(state_->contact.slips[k][0],
                                             state_->contact.slips[k][1]));
        Tensor<1, dim> u;
        for (unsigned int c = 0; c < dim; ++c)
          u[c] = state_->displacement[node.dofs[c]];
        displacement.push_back(u);
      }
    data.name          = pair.name;
    data.faces         = pair.contactor.faces;
    data.scalar_fields = {{"gap", gap},
                          {"pressure", pressure},
                          {"shear", shear},
                          {"slip", slip},
                          {"status", status}};
    for (const auto &process : pair.law.processes())
      {
        const std::string &name = process->quantity().name;
        const auto         first =
          state_->contact.quantities.at(name).begin() + pair.first_contact;
        data.scalar_fields.emplace_back(
          name, std::vector<double>(first, first + data.nodes.size()));
      }
    data.vector_fields = {{"displacement", displacement},
                          {"traction", traction},
                          {"normal", normal}};
    return data;
  }



  template <int dim>
  void
  ResultFields<dim>::write(FieldWriter<dim>   &fields,
                           SurfaceWriter<dim> &surfaces) const
  {
    // The writer takes views; what they look at is kept here meanwhile.
    const auto &parts = problem_.solid->parts();
    std::vector<std::map<std::string, DofVector>> all_stresses;
    std::vector<DofVector>                        displacements;
    std::vector<DofVector>                        velocities;
    for (unsigned int b = 0; b < parts.size(); ++b)
      {
        all_stresses.push_back(stresses(b));
        displacements.push_back(parts[b].body->extract(state_->displacement));
        velocities.push_back(parts[b].body->extract(state_->velocity));
      }
    std::vector<BodyFields<dim>> bodies;
    for (unsigned int b = 0; b < parts.size(); ++b)
      {
        BodyFields<dim> body;
        body.name               = parts[b].body->name();
        body.dof_handler        = &parts[b].body->dof_handler();
        body.displacement       = &displacements[b];
        body.velocity           = &velocities[b];
        body.scalar_dof_handler = &stresses_[b]->dof_handler();
        for (const auto &name : stress_names())
          body.nodal_fields.emplace_back(name, &all_stresses[b].at(name));
        bodies.push_back(body);
      }
    fields.write(bodies, state_->time);

    std::vector<SurfaceData<dim>> data;
    for (const auto &pair : problem_.contact->pairs())
      if (!pair.contactor.faces.empty())
        data.push_back(surface_data(pair));
    for (const auto &body : problem_.rigid_bodies)
      if (!body->surface().outline().empty())
        data.push_back(outline_data(*body, *state_));
    if (!data.empty())
      surfaces.write(data, state_->time);
  }



  template <int dim>
  void
  ResultFields<dim>::write(DisplacementWriter<dim> &displacements) const
  {
    const auto                        &parts = problem_.solid->parts();
    std::vector<DofVector>             values;
    std::vector<BodyDisplacement<dim>> bodies;
    for (const auto &part : parts)
      values.push_back(part.body->extract(state_->displacement));
    for (unsigned int b = 0; b < parts.size(); ++b)
      bodies.push_back({parts[b].body->name(),
                        &parts[b].body->dof_handler(),
                        &parts[b].body->mapping(),
                        &values[b]});
    displacements.write(bodies, state_->time);
  }



  template <int dim>
  void
  ResultFields<dim>::write_contact_tables(const std::string &folder) const
  {
    for (const auto &pair : problem_.contact->pairs())
      write_surface_table(surface_data(pair),
                          result_file(folder + "/" + pair.name + ".csv"));
  }



#define INSTANTIATE(dim) template class ResultFields<dim>;
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
