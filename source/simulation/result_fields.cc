#include <signorini/named_list.h>
#include <signorini/output/surface_table.h>
#include <signorini/simulation/result_fields.h>

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

    template <int dim>
    const std::vector<std::string> &
    stress_names()
    {
      static const std::vector<std::string> plane = {"stress_xx",
                                                     "stress_yy",
                                                     "stress_zz",
                                                     "stress_xy",
                                                     "von_mises",
                                                     "maximum_shear",
                                                     "plastic_strain"};
      static const std::vector<std::string> solid = {"stress_xx",
                                                     "stress_yy",
                                                     "stress_zz",
                                                     "stress_xy",
                                                     "stress_yz",
                                                     "stress_xz",
                                                     "von_mises",
                                                     "maximum_shear",
                                                     "plastic_strain"};
      return dim == 2 ? plane : solid;
    }

    // A rigid body as a line that moves.
    template <int dim>
    SurfaceData<dim>
    outline_data(const RigidBody<dim> &body, const State &state)
    {
      const auto placement = body.placement({state.displacement, state.time});
      SurfaceData<dim>            data;
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
  }



  template <int dim>
  std::vector<std::string>
  ResultFields<dim>::names() const
  {
    std::vector<std::string> list;
    for (const auto &part : problem_.solid->parts())
      {
        const std::string prefix = part.body->name() + ".";
        for (unsigned int c = 0; c < dim; ++c)
          for (const char *const vector : {"displacement_", "velocity_"})
            list.push_back(prefix + vector + component_name(c));
        for (const auto &name : stress_names<dim>())
          list.push_back(prefix + name);
      }
    for (const auto &pair : problem_.contact->pairs())
      for (const char *const name :
           {".pressure", ".gap", ".shear", ".slip", ".status"})
        list.push_back(pair.name + name);
    return list;
  }



  template <int dim>
  NodalField
  ResultFields<dim>::field(const std::string &name) const
  {
    Assert(state_ != nullptr, ExcNotInitialized());
    NodalField        result;
    const std::size_t dot      = name.rfind('.');
    const std::string owner    = name.substr(0, dot);
    const std::string quantity = name.substr(dot + 1);

    for (unsigned int b = 0; b < problem_.solid->parts().size(); ++b)
      {
        const Body<dim> &body = *problem_.solid->parts()[b].body;
        if (body.name() != owner)
          continue;
        const std::size_t underscore = quantity.find('_');
        const std::string vector     = quantity.substr(0, underscore);
        if (vector == "displacement" || vector == "velocity")
          {
            const unsigned int component =
              parse_component<dim>(quantity.substr(underscore + 1),
                                   "Expected results");
            const Vector<double> &values =
              vector == "velocity" ? state_->velocity : state_->displacement;
            for (const auto &node : body.nodes())
              {
                result.points.push_back(in_space(node.point));
                result.values.push_back(values[node.dofs[component]]);
              }
            return result;
          }
        const auto values =
          stresses_[b]
            ->fields(state_->displacement,
                     problem_.solid->history_of(b, state_->history))
            .at(quantity);
        for (const auto &point : stresses_[b]->points())
          result.points.push_back(in_space(point));
        result.values.assign(values.begin(), values.end());
        return result;
      }

    for (const auto &pair : problem_.contact->pairs())
      if (pair.name == owner)
        {
          const SurfaceData<dim> data = surface_data(pair);
          for (const auto &node : data.nodes)
            result.points.push_back(in_space(node));
          for (const auto &[field_name, values] : data.scalar_fields)
            if (field_name == quantity)
              result.values = values;
        }
    return result;
  }



  template <int dim>
  SurfaceData<dim>
  ResultFields<dim>::surface_data(const ContactPair<dim> &pair) const
  {
    const auto points =
      problem_.contact->evaluate({state_->displacement, state_->time});
    SurfaceData<dim>            data;
    std::vector<double>         gap, pressure, shear, slip, status;
    std::vector<Tensor<1, dim>> traction, normal, displacement;
    for (unsigned int n = 0; n < pair.contactor.nodes.size(); ++n)
      {
        const unsigned int k    = pair.first_contact + n;
        const auto        &node = pair.contactor.nodes[n];
        const double p = points[k].pressure(state_->contact_forces.normal[k]);
        data.nodes.push_back(node.point);
        // Out of reach there is no gap to show.
        gap.push_back(std::isfinite(state_->gaps[k]) ?
                        state_->gaps[k] :
                        std::numeric_limits<float>::quiet_NaN());
        pressure.push_back(p);
        status.push_back(p <= 0. ? 0. : state_->is_slipping[k] ? 2. : 1.);
        normal.push_back(points[k].normal);
        Tensor<1, dim> t      = p * points[k].normal;
        const auto    &forces = state_->contact_forces.tangential[k];
        for (unsigned int j = 0; j < dim - 1; ++j)
          t -= points[k].pressure(forces[j]) * points[k].tangents[j];
        traction.push_back(t);

        // In 2-D along the tangent, in 3-D the size.
        shear.push_back(points[k].pressure(
          dim == 2 ? -forces[0] : std::hypot(forces[0], forces[1])));
        slip.push_back(dim == 2 ?
                         state_->slips[k][0] :
                         std::hypot(state_->slips[k][0], state_->slips[k][1]));
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
    std::vector<std::map<std::string, Vector<double>>> stresses;
    std::vector<Vector<double>>                        displacements;
    std::vector<Vector<double>>                        velocities;
    for (unsigned int b = 0; b < parts.size(); ++b)
      {
        stresses.push_back(
          stresses_[b]->fields(state_->displacement,
                               problem_.solid->history_of(b, state_->history)));
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
        for (const auto &name : stress_names<dim>())
          body.nodal_fields.emplace_back(name, &stresses[b].at(name));
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
  ResultFields<dim>::write_contact_tables(const std::string &folder) const
  {
    for (const auto &pair : problem_.contact->pairs())
      write_surface_table(surface_data(pair),
                          folder + "/" + pair.name + ".csv");
  }



  template class ResultFields<2>;
  template class ResultFields<3>;
} // namespace Signorini
