#include <signorini/input/input_error.h>
#include <signorini/input/instantiate.h>
#include <signorini/input/named_list.h>
#include <signorini/input/number_text.h>
#include <signorini/solid/loads.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>

#include "cell_dofs.h"

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    std::string
    section(const Body<dim> &body)
    {
      return "Body " + body.name() + " / Loads / ";
    }

    // J F^-T n: the normal times the present area over that at first. The
    // hoop's stretch counts, a change of thickness does not.
    template <int dim>
    Tensor<1, dim>
    deformed_area(const Formulation        formulation,
                  const FEFaceValues<dim> &values,
                  const unsigned int       q,
                  const CellDofs<dim>     &dofs,
                  const DofVector         &displacement)
    {
      Tensor<2, dim> F;
      for (unsigned int i = 0; i < dim; ++i)
        F[i][i] = 1.;
      Tensor<1, dim> u;
      for (const unsigned int a : values.dof_indices())
        {
          const Tensor<1, dim> u_a = dofs.at_node(a, displacement);
          F += outer_product(u_a, values.shape_grad(a, q));
          u += values.shape_value(a, q) * u_a;
        }
      const double radius = values.quadrature_point(q)[0];
      const double around =
        formulation == Formulation::axisymmetric && radius > 0. ?
          1. + u[0] / radius :
          1.;
      return around * determinant(F) * transpose(invert(F)) *
             values.normal_vector(q);
    }
  } // namespace



  template <int dim>
  void
  Loads<dim>::declare_parameters(ParameterHandler &prm)
  {
    const auto text = Patterns::Anything();
    prm.enter_subsection("Loads");
    prm.declare_entry("Traction",
                      "",
                      text,
                      "Force per area of named boundaries, components "
                      "separated by `;': `right: 0 ; -5e4 | top: 1e3*t ; 0'. "
                      "Keeps its direction. Unit: Pa.");
    prm.declare_entry("Pressure",
                      "",
                      text,
                      "Pressure against named boundaries, positive into the "
                      "body: `inner: 100e6'. With Kinematics = finite strain "
                      "it follows the surface. Unit: Pa.");
    prm.declare_entry("Body force",
                      "",
                      text,
                      "Force per volume, components separated by `;'. Unit: "
                      "N/m^3.");
    prm.declare_entry("Gravity",
                      "",
                      text,
                      "Acceleration that acts on the mass, components "
                      "separated by `;': `0 ; -9.81'. Unit: m/s^2.");
    prm.declare_entry("Point force",
                      "",
                      text,
                      "Forces at the nodes next to points: `0.2, 0.02: 0 ; "
                      "-1e3'. Unit: N.");
    prm.declare_entry("Angular velocity",
                      "",
                      text,
                      "Centrifugal load density omega^2 r, as a function of "
                      "t. Unit: rad/s.");
    prm.declare_entry("Rotation centre",
                      "",
                      NumberText(),
                      "A point on the axis of rotation; empty: the origin. "
                      "Axisymmetric bodies turn about their axis. Unit: m.");
    prm.declare_entry("Rotation axis",
                      "0, 0, 1",
                      NumberText(),
                      "Direction of the axis, read in three dimensions only.");
    prm.leave_subsection();
  }



  template <int dim>
  EntryConditions
  Loads<dim>::conditions()
  {
    return {read_if_set({"Rotation centre", "Rotation axis"},
                        "Angular velocity"),
            read_with({"Rotation axis"}, "Formulation", {"three dimensional"}),
            read_with({"Rotation centre"},
                      "Formulation",
                      {"plane strain", "plane stress", "three dimensional"})};
  }



  template <int dim>
  Loads<dim>::Loads(const Body<dim>  &body,
                    const Constants  &constants,
                    ParameterHandler &prm)
    : body_(&body)
  {
    prm.enter_subsection("Loads");
    parse_boundary_loads("Traction", false, constants, prm);
    parse_boundary_loads("Pressure", true, constants, prm);
    if (!prm.get("Body force").empty())
      body_forces_.emplace_back(prm.get("Body force"),
                                dim,
                                constants,
                                section(body) + "Body force",
                                Dependence::space_and_time);
    if (!prm.get("Gravity").empty())
      accelerations_.emplace_back(prm.get("Gravity"),
                                  dim,
                                  constants,
                                  section(body) + "Gravity",
                                  Dependence::space_and_time);
    parse_point_forces(constants, prm);
    parse_rotation(constants, prm);
    prm.leave_subsection();
  }



  template <int dim>
  void
  Loads<dim>::parse_boundary_loads(const std::string &entry_name,
                                   const bool         is_pressure,
                                   const Constants   &constants,
                                   ParameterHandler  &prm)
  {
    const std::string entry = section(*body_) + entry_name;
    for (const auto &[name, value] :
         parse_named_list(prm.get(entry_name), entry))
      try
        {
          boundary_loads_.push_back({body_->mesh().boundary(name),
                                     is_pressure,
                                     Function(value,
                                              is_pressure ? 1 : dim,
                                              constants,
                                              entry,
                                              Dependence::space_and_time)});
        }
      catch (const InputError &error)
        {
          throw error.entry().empty() ? InputError(entry, error.text()) : error;
        }
  }



  template <int dim>
  void
  Loads<dim>::parse_point_forces(const Constants  &constants,
                                 ParameterHandler &prm)
  {
    const std::string entry = section(*body_) + "Point force";
    for (const auto &[point, value] :
         parse_named_list(prm.get("Point force"), entry))
      point_forces_.push_back(
        {body_->node_near(parse_point<dim>(point, entry, constants), entry),
         Function(value, dim, constants, entry, Dependence::space_and_time)});
  }



  template <int dim>
  void
  Loads<dim>::parse_rotation(const Constants &constants, ParameterHandler &prm)
  {
    if (prm.get("Angular velocity").empty())
      return;
    rotation_.emplace_back(prm.get("Angular velocity"),
                           1,
                           constants,
                           section(*body_) + "Angular velocity",
                           Dependence::time);
    if (!prm.get("Rotation centre").empty())
      rotation_centre_ = parse_point<dim>(prm.get("Rotation centre"),
                                          section(*body_) + "Rotation centre");
    if (body_->formulation() == Formulation::axisymmetric)
      {
        rotation_centre_  = Point<dim>();
        rotation_axis_[1] = 1.;
      }
    if constexpr (dim == 3)
      {
        rotation_axis_ = parse_point<3>(prm.get("Rotation axis"),
                                        section(*body_) + "Rotation axis");
        if (rotation_axis_.norm() == 0.)
          throw InputError(
            section(*body_) + "Rotation axis",
            "has length zero; give a direction, such as 0, 0, 1.");
        rotation_axis_ /= rotation_axis_.norm();
      }
  }



  template <int dim>
  bool
  Loads<dim>::depend_on_time() const
  {
    const auto varies = [](const Function &f) { return f.depends_on_time(); };
    const auto value_varies = [](const auto &load) {
      return load.value.depends_on_time();
    };
    return std::any_of(body_forces_.begin(), body_forces_.end(), varies) ||
           std::any_of(accelerations_.begin(), accelerations_.end(), varies) ||
           std::any_of(rotation_.begin(), rotation_.end(), varies) ||
           std::any_of(boundary_loads_.begin(),
                       boundary_loads_.end(),
                       value_varies) ||
           std::any_of(point_forces_.begin(),
                       point_forces_.end(),
                       value_varies);
  }



  template <int dim>
  Tensor<1, dim>
  Loads<dim>::force_density(const Point<dim> &point,
                            const double      density,
                            const double      time) const
  {
    Tensor<1, dim> force;
    for (const auto &function : body_forces_)
      force += function.vector_value(point, time);
    for (const auto &function : accelerations_)
      force += density * function.vector_value(point, time);
    if (!is_finite())
      force += density * centrifugal_acceleration(point, point, time);
    return force;
  }



  template <int dim>
  Tensor<1, dim>
  Loads<dim>::centrifugal_acceleration(const Point<dim> &now,
                                       const Point<dim> &at_first,
                                       const double      time) const
  {
    Tensor<1, dim> acceleration;
    for (const auto &function : rotation_)
      {
        const double   omega = function.value(at_first, time);
        Tensor<1, dim> arm   = now - rotation_centre_;
        arm -= (arm * rotation_axis_) * rotation_axis_;
        acceleration += omega * omega * arm;
      }
    return acceleration;
  }



  template <int dim>
  bool
  Loads<dim>::follow() const
  {
    return is_finite() &&
           (!rotation_.empty() || std::any_of(boundary_loads_.begin(),
                                              boundary_loads_.end(),
                                              [](const BoundaryLoad &load) {
                                                return load.is_pressure;
                                              }));
  }



  template <int dim>
  void
  Loads<dim>::add_forces(const double time, DofVector &forces) const
  {
    add_volume_forces(time, nullptr, forces);
    add_boundary_forces(time, nullptr, forces);
    for (const auto &[node, value] : point_forces_)
      for (unsigned int c = 0; c < dim; ++c)
        forces[node.dofs[c]] += value.value(node.point, time, c);
  }



  template <int dim>
  void
  Loads<dim>::add_following_forces(const double     time,
                                   const DofVector &displacement,
                                   DofVector       &forces) const
  {
    add_volume_forces(time, &displacement, forces);
    add_boundary_forces(time, &displacement, forces);
  }



  template <int dim>
  void
  Loads<dim>::add_volume_forces(const double     time,
                                const DofVector *displacement,
                                DofVector       &forces) const
  {
    const bool is_loaded = displacement ?
                             is_finite() && !rotation_.empty() :
                             !body_forces_.empty() || !accelerations_.empty() ||
                               (!is_finite() && !rotation_.empty());
    if (!is_loaded)
      return;
    // One point more than for the stiffness: the loads may be curved.
    const QGauss<dim> quadrature(body_->scalar_fe().degree + 2);
    FEValues<dim>     values(body_->mapping(),
                         body_->scalar_fe(),
                         quadrature,
                         update_values | update_quadrature_points |
                           update_JxW_values);
    CellDofs<dim>     dofs(*body_);
    for (const auto &cell : body_->dof_handler().active_cell_iterators())
      {
        values.reinit(
          static_cast<typename Triangulation<dim>::cell_iterator>(cell));
        dofs.reinit(cell);
        const double density = body_->material(cell->material_id()).density();
        for (const unsigned int q : values.quadrature_point_indices())
          {
            const Point<dim> &point = values.quadrature_point(q);
            Tensor<1, dim>    force;
            if (displacement)
              {
                Point<dim> now = point;
                for (const unsigned int a : values.dof_indices())
                  now +=
                    values.shape_value(a, q) * dofs.at_node(a, *displacement);
                force = density * centrifugal_acceleration(now, point, time);
              }
            else
              force = force_density(point, density, time);
            force *= values.JxW(q) * body_->volume_factor(point);
            for (const unsigned int a : values.dof_indices())
              dofs.add(a, values.shape_value(a, q) * force, forces);
          }
      }
  }



  template <int dim>
  void
  Loads<dim>::add_boundary_forces(const double     time,
                                  const DofVector *displacement,
                                  DofVector       &forces) const
  {
    const auto is_due = [&](const BoundaryLoad &load) {
      return (load.is_pressure && is_finite()) == (displacement != nullptr);
    };
    if (std::none_of(boundary_loads_.begin(), boundary_loads_.end(), is_due))
      return;
    const QGauss<dim - 1> quadrature(body_->scalar_fe().degree + 2);
    FEFaceValues<dim>     values(body_->mapping(),
                             body_->scalar_fe(),
                             quadrature,
                             update_values | update_gradients |
                               update_quadrature_points | update_JxW_values |
                               update_normal_vectors);
    CellDofs<dim>         dofs(*body_);
    for (const auto &cell : body_->dof_handler().active_cell_iterators())
      for (const unsigned int face : cell->face_indices())
        for (const auto &load : boundary_loads_)
          {
            if (!is_due(load) || !cell->face(face)->at_boundary() ||
                cell->face(face)->boundary_id() != load.boundary)
              continue;
            values.reinit(
              static_cast<typename Triangulation<dim>::cell_iterator>(cell),
              face);
            dofs.reinit(cell);
            for (const unsigned int q : values.quadrature_point_indices())
              {
                const Point<dim> &point  = values.quadrature_point(q);
                Tensor<1, dim>    normal = values.normal_vector(q);
                if (displacement)
                  normal = deformed_area(
                    body_->formulation(), values, q, dofs, *displacement);
                const Tensor<1, dim> traction =
                  load.is_pressure ? -load.value.value(point, time) * normal :
                                     load.value.vector_value(point, time);
                const double weight =
                  values.JxW(q) * body_->volume_factor(point);
                for (const unsigned int a : values.dof_indices())
                  dofs.add(a,
                           weight * values.shape_value(a, q) * traction,
                           forces);
              }
          }
  }



#define INSTANTIATE(dim) template class Loads<dim>;
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
