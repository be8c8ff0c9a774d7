#include <signorini/input_error.h>
#include <signorini/linear_algebra/sparse_cholesky.h>
#include <signorini/nearest_name.h>
#include <signorini/solid/assembler.h>
#include <signorini/solid/rigid_motion.h>
#include <signorini/solid/solid_model.h>

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <limits>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // deal.II leaves a number on the diagonal of condensed unknowns. They are
    // never solved for, and the number would count in U.K U.
    void
    clear_condensed_diagonal(const AffineConstraints<double> &constraints,
                             SparseMatrix<double>            &matrix)
    {
      for (const auto &line : constraints.get_lines())
        matrix.set(line.index, line.index, 0.);
    }

    template <int dim>
    void
    add_hanging_nodes(const Body<dim>           &body,
                      AffineConstraints<double> &constraints)
    {
      AffineConstraints<double> local;
      DoFTools::make_hanging_node_constraints(body.dof_handler(), local);
      local.close();
      const unsigned int shift = body.first_dof();
      for (const auto &line : local.get_lines())
        {
          constraints.add_line(line.index + shift);
          for (const auto &[dof, weight] : line.entries)
            constraints.add_entry(line.index + shift, dof + shift, weight);
        }
    }
  } // namespace



  template <int dim>
  SolidModel<dim>::SolidModel(std::vector<Part>          parts,
                              std::vector<LumpedUnknown> lumped)
    : parts_(std::move(parts))
    , lumped_(std::move(lumped))
    , loads_vary_(false)
    , supports_are_fixed_(true)
    , force_time_(std::numeric_limits<double>::quiet_NaN())
  {
    unsigned int n_dofs = 0;
    for (const auto &part : parts_)
      {
        Assert(part.body->first_dof() == n_dofs, ExcInternalError());
        n_dofs += part.body->n_dofs();
        add_hanging_nodes(*part.body, constraints_);
        loads_vary_         = loads_vary_ || part.loads.depend_on_time();
        supports_are_fixed_ = supports_are_fixed_ && part.supports.are_fixed();
      }
    constraints_.close();
    n_dofs += lumped_.size();
    loads_vary_ = loads_vary_ || !lumped_.empty();

    is_hanging_.resize(n_dofs);
    for (const auto &line : constraints_.get_lines())
      is_hanging_[line.index] = true;
    is_fixed_ = is_hanging_;
    for (const auto &part : parts_)
      part.supports.mark(is_fixed_);
    for (unsigned int l = 0; l < lumped_.size(); ++l)
      if (lumped_[l].motion)
        {
          is_fixed_[first_lumped() + l] = true;
          supports_are_fixed_           = false;
        }
    force_.reinit(n_dofs);
  }



  template <int dim>
  const Body<dim> &
  SolidModel<dim>::body(const std::string &name, const std::string &entry) const
  {
    std::vector<std::string> names;
    for (const auto &part : parts_)
      {
        if (part.body->name() == name)
          return *part.body;
        names.push_back(part.body->name());
      }
    std::string list;
    for (const auto &known : names)
      list += (list.empty() ? "" : ", ") + known;
    const std::string nearest = nearest_name(name, names);
    throw InputError(
      entry + ": there is no body \"" + name + "\"." +
      (nearest.empty() ? "" : " Did you mean \"" + nearest + "\"?") +
      " The bodies are: " + list + ".");
  }



  template <int dim>
  void
  SolidModel<dim>::assemble(const Inertia &inertia)
  {
    if (inertia.present && inertia.contact_mass != ContactMass::consistent)
      for (unsigned int b = 0; b < inertia.contact_nodes.size(); ++b)
        redistribution_.add(inertia.contact_mass,
                            *parts_[b].body,
                            inertia.contact_nodes[b],
                            is_fixed_,
                            is_hanging_);
    build_sparsity();

    stiffness_.reinit(sparsity_);
    Vector<double> internal_force(n_dofs());
    for (const auto &part : parts_)
      add_stiffness(*part.body,
                    constraints_,
                    Vector<double>(n_dofs()),
                    1.,
                    stiffness_,
                    internal_force);
    clear_condensed_diagonal(constraints_, stiffness_);
    if (inertia.present)
      assemble_inertia(inertia);
    else
      hold_free_bodies();
  }



  template <int dim>
  void
  SolidModel<dim>::hold_free_bodies()
  {
    // Soft against the bodies, so that one or two corrections are enough, but
    // far above rounding.
    double mean = 0.;
    for (unsigned int i = 0; i < first_lumped(); ++i)
      mean += stiffness_.diag_element(i) / first_lumped();
    const double   softness = 1e-3 * mean;
    Vector<double> springs(n_dofs());
    for (const auto &part : parts_)
      if (!free_rigid_motion(*part.body, is_fixed_).empty())
        for (const auto &node : part.body->nodes())
          for (const unsigned int dof : node.dofs)
            springs[dof] = softness / part.body->nodes().size();
    for (unsigned int l = 0; l < lumped_.size(); ++l)
      springs[first_lumped() + l] = softness;
    if (springs.linfty_norm() > 0.)
      proximal_stiffness_ = springs;
  }



  template <int dim>
  void
  SolidModel<dim>::build_sparsity()
  {
    DynamicSparsityPattern pattern(n_dofs());
    for (const auto &part : parts_)
      {
        const Body<dim>                     &body = *part.body;
        std::vector<types::global_dof_index> dofs(body.fe().n_dofs_per_cell());
        for (const auto &cell : body.dof_handler().active_cell_iterators())
          {
            cell->get_dof_indices(dofs);
            for (auto &dof : dofs)
              dof += body.first_dof();
            constraints_.add_entries_local_to_global(dofs, pattern);
          }
      }
    for (unsigned int i = first_lumped(); i < n_dofs(); ++i)
      pattern.add(i, i);
    redistribution_.extend(pattern);
    sparsity_.copy_from(pattern);
  }



  template <int dim>
  void
  SolidModel<dim>::assemble_inertia(const Inertia &inertia)
  {
    SparseMatrix<double> mass(sparsity_), damping(sparsity_);
    Vector<double>       internal_force(n_dofs());
    const Vector<double> zero(n_dofs());
    bool                 is_damped = false;
    for (const auto &part : parts_)
      {
        const Body<dim> &body = *part.body;
        for (const Material *const material : body.materials())
          if (material->density() <= 0.)
            throw InputError("Body " + body.name() +
                             " / Material / Density: must be greater than zero "
                             "in a dynamic run, in kg/m^3. Without inertia set "
                             "Time / Analysis = static.");
        add_mass(body, constraints_, inertia.lumped, 1., mass);
        if (body.mass_damping() > 0.)
          add_mass(
            body, constraints_, inertia.lumped, body.mass_damping(), damping);
        if (body.stiffness_damping() > 0.)
          add_stiffness(body,
                        constraints_,
                        zero,
                        body.stiffness_damping(),
                        damping,
                        internal_force);
        is_damped = is_damped || body.mass_damping() > 0. ||
                    body.stiffness_damping() > 0.;
      }
    clear_condensed_diagonal(constraints_, mass);
    clear_condensed_diagonal(constraints_, damping);
    for (unsigned int l = 0; l < lumped_.size(); ++l)
      mass.set(first_lumped() + l, first_lumped() + l, lumped_[l].mass);
    mass_.reinit(sparsity_);
    redistribution_.congruence(mass, mass_);
    if (is_damped)
      {
        damping_.reinit(sparsity_);
        redistribution_.congruence(damping, damping_);
      }
  }



  template <int dim>
  Vector<double>
  SolidModel<dim>::internal_force(const Vector<double> &displacement) const
  {
    Vector<double> force(n_dofs());
    stiffness_.vmult(force, displacement);
    return force;
  }



  template <int dim>
  const Vector<double> &
  SolidModel<dim>::external_force(const double time) const
  {
    const bool is_known =
      loads_vary_ ? force_time_ == time : !std::isnan(force_time_);
    if (!is_known)
      {
        force_ = 0.;
        for (const auto &part : parts_)
          part.loads.add_forces(time, force_);
        for (unsigned int l = 0; l < lumped_.size(); ++l)
          if (lumped_[l].force)
            force_[first_lumped() + l] = lumped_[l].force(time);
        constraints_.condense(force_);
        force_time_ = time;
      }
    return force_;
  }



  template <int dim>
  void
  SolidModel<dim>::apply_supports(const double    time,
                                  Vector<double> &displacement) const
  {
    for (const auto &part : parts_)
      part.supports.set_displacements(time, displacement);
    for (unsigned int l = 0; l < lumped_.size(); ++l)
      if (lumped_[l].motion)
        displacement[first_lumped() + l] = lumped_[l].motion(time);
    constraints_.distribute(displacement);
  }



  template <int dim>
  void
  SolidModel<dim>::apply_support_rates(const double    time,
                                       const double    step_size,
                                       Vector<double> &velocity,
                                       Vector<double> &acceleration) const
  {
    for (const auto &part : parts_)
      part.supports.set_rates(time, step_size, velocity, acceleration);
    const double difference = 0.01 * step_size;
    for (unsigned int l = 0; l < lumped_.size(); ++l)
      if (const auto &motion = lumped_[l].motion)
        {
          const double before          = motion(time - difference);
          const double now             = motion(time);
          const double after           = motion(time + difference);
          velocity[first_lumped() + l] = (after - before) / (2. * difference);
          acceleration[first_lumped() + l] =
            (after - 2. * now + before) / (difference * difference);
        }
    constraints_.distribute(velocity);
    constraints_.distribute(acceleration);
  }



  template <int dim>
  double
  SolidModel<dim>::stiffness_at_load(const double time) const
  {
    const Vector<double> &force = external_force(time);
    Tensor<1, dim>        resultant;
    for (const auto &part : parts_)
      for (const auto &node : part.body->nodes())
        for (unsigned int c = 0; c < dim; ++c)
          if (!is_fixed_[node.dofs[c]])
            resultant[c] += force[node.dofs[c]];
    if (resultant.norm() == 0.)
      throw InputError("Contact / Relative penalty stiffness: the bodies carry "
                       "no load whose stiffness could be the measure. Give "
                       "the Penalty stiffness in N/m.");
    try
      {
        SparseCholesky cholesky;
        cholesky.analyse(sparsity_, is_fixed_, {});
        cholesky.factorise(stiffness_);
        Vector<double> displacement(n_dofs());
        cholesky.solve(displacement, force);
        return resultant.norm_square() / (force * displacement);
      }
    catch (const NotPositiveDefinite &)
      {
        throw InputError("Contact / Relative penalty stiffness: a body can "
                         "move freely and has no static stiffness. Give the "
                         "Penalty stiffness in N/m.");
      }
  }



  template class SolidModel<2>;
  template class SolidModel<3>;
} // namespace Signorini
