#include <signorini/input/input_error.h>
#include <signorini/input/instantiate.h>
#include <signorini/input/nearest_name.h>
#include <signorini/linear_algebra/sparse_cholesky.h>
#include <signorini/solid/assembler.h>
#include <signorini/solid/solid_model.h>
#include <signorini/time/motion_rates.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <limits>
#include <sstream>

#include "condensed_diagonal.h"
#include "node_constraints.h"

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  SolidModel<dim>::SolidModel(std::vector<Part>         parts,
                              std::vector<RigidBodyDof> rigid_body_dofs)
    : parts_(std::move(parts))
    , rigid_body_dofs_(std::move(rigid_body_dofs))
    , is_linear_(true)
    , first_history_(1, 0)
    , loads_vary_(false)
    , loads_follow_(false)
    , supports_are_fixed_(true)
    , force_time_(std::numeric_limits<double>::quiet_NaN())
  {
    unsigned int n_dofs = 0;
    for (const auto &part : parts_)
      {
        Assert(part.body->first_dof() == n_dofs, ExcInternalError());
        n_dofs += part.body->n_dofs();
        for (const Material *const material : part.body->materials())
          is_linear_ = is_linear_ && material->is_linear();
        first_history_.push_back(first_history_.back() +
                                 n_history_values(*part.body));
        loads_vary_         = loads_vary_ || part.loads.depend_on_time();
        loads_follow_       = loads_follow_ || part.loads.follow();
        supports_are_fixed_ = supports_are_fixed_ && part.supports.are_fixed();
      }
    loads_vary_ = loads_vary_ || !rigid_body_dofs_.empty();
    number_dofs(n_dofs);
    for (const auto &dof : rigid_body_dofs_)
      supports_are_fixed_ = supports_are_fixed_ && !dof.motion;
    force_.reinit(this->n_dofs());
    following_force_.reinit(this->n_dofs());
  }



  template <int dim>
  void
  SolidModel<dim>::number_dofs(const unsigned int n_body_dofs)
  {
    dof_map_ = DofMap(n_body_dofs, rigid_body_dofs_.size());
    for (const auto &part : parts_)
      add_hanging_nodes(*part.body, dof_map_);
    for (const auto &part : parts_)
      part.supports.mark(dof_map_);
    for (unsigned int l = 0; l < rigid_body_dofs_.size(); ++l)
      if (rigid_body_dofs_[l].motion)
        dof_map_.prescribe(n_body_dofs + l);
    for (const auto &part : parts_)
      for (const auto &sliding : part.supports.sliding_nodes())
        hold_in_plane(*part.body, sliding, dof_map_);
    dof_map_.close();
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
    throw InputError(entry,
                     "there is no body \"" + name + "\"." +
                       did_you_mean(name, names) +
                       " The bodies are: " + comma_separated(names) + ".");
  }



  template <int dim>
  void
  SolidModel<dim>::assemble(const Inertia &inertia)
  {
    if (inertia.present && inertia.contact_mass != ContactMass::consistent)
      for (unsigned int b = 0; b < inertia.contact_nodes.size(); ++b)
        undamped_.add(*parts_[b].body, inertia.contact_nodes[b], dof_map_);
    build_sparsity();

    stiffness_.reinit(sparsity_);
    add_initial_stiffness([](const Body<dim> &) { return 1.; }, stiffness_);
    measure_cells();
    if (inertia.present)
      assemble_inertia(inertia);
    else
      refuse_absorbing_boundaries();
  }



  template <int dim>
  void
  SolidModel<dim>::add_initial_stiffness(
    const std::function<double(const Body<dim> &)> &factor,
    DofMatrix                                      &matrix) const
  {
    const DofVector           zero(n_dofs());
    const std::vector<double> history_n = initial_history();
    SolidResponse             response;
    response.internal_force.reinit(n_dofs());
    response.history = history_n;
    for (unsigned int b = 0; b < parts_.size(); ++b)
      if (factor(*parts_[b].body) != 0.)
        add_response(
          *parts_[b].body,
          dof_map_.constraints(),
          {zero},
          history_of(b, history_n),
          make_array_view(response.history.data() + first_history_[b],
                          response.history.data() + first_history_[b + 1]),
          response,
          &matrix,
          factor(*parts_[b].body));
    clear_condensed_diagonal(dof_map_.constraints(), matrix);
  }



  template <int dim>
  std::vector<RigidMode>
  SolidModel<dim>::free_modes(const DofVector &displacement) const
  {
    std::vector<RigidMode> modes;
    for (const auto &part : parts_)
      for (auto &mode : free_rigid_modes(
             *part.body, displacement, dof_map_, part.supports.sliding_nodes()))
        modes.push_back(std::move(mode));
    for (unsigned int i = dof_map_.n_body_dofs(); i < n_dofs(); ++i)
      if (!dof_map_.is_constrained(i))
        {
          RigidMode mode;
          mode.motion.reinit(n_dofs());
          mode.motion[i] = 1.;
          modes.push_back(mode);
        }
    return modes;
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
            dof_map_.constraints().add_entries_local_to_global(dofs, pattern);
          }
      }
    for (unsigned int i = dof_map_.n_body_dofs(); i < n_dofs(); ++i)
      pattern.add(i, i);
    if (has_damping())
      undamped_.extend(pattern);
    sparsity_.copy_from(pattern);
  }



  template <int dim>
  void
  SolidModel<dim>::measure_cells()
  {
    cell_size_.reinit(n_dofs());
    if (is_linear_)
      return;
    for (const auto &part : parts_)
      {
        const Body<dim>                     &body = *part.body;
        std::vector<types::global_dof_index> dofs(body.fe().n_dofs_per_cell());
        for (const auto &cell : body.dof_handler().active_cell_iterators())
          {
            cell->get_dof_indices(dofs);
            for (const auto dof : dofs)
              {
                double &size = cell_size_[body.first_dof() + dof];
                size         = std::max(size, cell->diameter());
              }
          }
      }
  }



  template <int dim>
  DofVector
  SolidModel<dim>::force_rounding(const DofVector &displacement) const
  {
    DofVector rounding(n_dofs());
    for (unsigned int i = 0; i < n_dofs(); ++i)
      {
        double sum = 0.;
        for (auto entry = stiffness_.begin(i); entry != stiffness_.end(i);
             ++entry)
          sum += std::abs(entry->value()) *
                 (std::abs(displacement[entry->column()]) +
                  cell_size_[entry->column()]);
        rounding[i] = std::numeric_limits<double>::epsilon() * sum;
      }
    return rounding;
  }



  template <int dim>
  void
  SolidModel<dim>::refuse_absorbing_boundaries() const
  {
    for (const auto &part : parts_)
      if (!part.supports.absorbing_boundaries().empty())
        throw InputError(
          "Body " + part.body->name() + " / Supports / Absorbing",
          "dashpots resist velocities, and a static run has none. Fix the "
          "boundary, or set Time / Analysis = dynamic.");
  }



  template <int dim>
  std::string
  SolidModel<dim>::unknown_in_words(const unsigned int unknown) const
  {
    for (const auto &part : parts_)
      for (const auto &node : part.body->nodes())
        if (std::find(node.dofs.begin(), node.dofs.end(), unknown) !=
            node.dofs.end())
          {
            std::ostringstream words;
            words << "the node (" << node.point << ") of body "
                  << part.body->name();
            return words.str();
          }
    return "a rigid body";
  }



  template <int dim>
  std::vector<double>
  SolidModel<dim>::initial_history() const
  {
    return std::vector<double>(first_history_.back(), 0.);
  }



  template <int dim>
  ArrayView<const double>
  SolidModel<dim>::history_of(const unsigned int         b,
                              const std::vector<double> &history) const
  {
    return make_array_view(history.data() + first_history_[b],
                           history.data() + first_history_[b + 1]);
  }



  template <int dim>
  SolidResponse
  SolidModel<dim>::respond(const SolidStep           &step,
                           const std::vector<double> &history_n,
                           DofMatrix                 *tangent) const
  {
    SolidResponse response;
    response.internal_force.reinit(n_dofs());
    if (is_linear_)
      {
        stiffness_.vmult(response.internal_force, step.displacement);
        response.stored_energy =
          0.5 * (step.displacement * response.internal_force);
        if (step.displacement_n)
          {
            DofVector mean(step.displacement);
            mean.sadd(0.5, 0.5, *step.displacement_n);
            response.mean_force.reinit(n_dofs());
            stiffness_.vmult(response.mean_force, mean);
          }
        return response;
      }
    if (step.displacement_n)
      response.mean_force.reinit(n_dofs());
    AssertDimension(history_n.size(), first_history_.back());
    response.history = history_n;
    if (tangent)
      {
        if (tangent->empty())
          tangent->reinit(sparsity_);
        *tangent = 0.;
      }
    for (unsigned int b = 0; b < parts_.size(); ++b)
      add_response(*parts_[b].body,
                   dof_map_.constraints(),
                   step,
                   history_of(b, history_n),
                   make_array_view(response.history.data() + first_history_[b],
                                   response.history.data() +
                                     first_history_[b + 1]),
                   response,
                   tangent);
    if (tangent)
      clear_condensed_diagonal(dof_map_.constraints(), *tangent);
    return response;
  }



  template <int dim>
  const DofVector &
  SolidModel<dim>::external_force(const double     time,
                                  const DofVector &displacement) const
  {
    const bool is_known =
      loads_vary_ ? force_time_ == time : !std::isnan(force_time_);
    if (!is_known)
      {
        force_ = 0.;
        for (const auto &part : parts_)
          part.loads.add_forces(time, force_);
        for (unsigned int l = 0; l < rigid_body_dofs_.size(); ++l)
          if (rigid_body_dofs_[l].force)
            force_[dof_map_.n_body_dofs() + l] =
              rigid_body_dofs_[l].force(time);
        dof_map_.constraints().condense(force_);
        force_time_ = time;
      }
    if (!loads_follow_)
      return force_;
    following_force_ = 0.;
    for (const auto &part : parts_)
      part.loads.add_following_forces(time, displacement, following_force_);
    dof_map_.constraints().condense(following_force_);
    following_force_ += force_;
    return following_force_;
  }



  template <int dim>
  void
  SolidModel<dim>::apply_supports(const double time,
                                  DofVector   &displacement) const
  {
    for (const auto &part : parts_)
      part.supports.set_displacements(time, displacement);
    for (unsigned int l = 0; l < rigid_body_dofs_.size(); ++l)
      if (rigid_body_dofs_[l].motion)
        displacement[dof_map_.n_body_dofs() + l] =
          rigid_body_dofs_[l].motion(time);
    dof_map_.constraints().distribute(displacement);
  }



  template <int dim>
  void
  SolidModel<dim>::apply_support_rates(const double time,
                                       const double step_size,
                                       DofVector   &velocity,
                                       DofVector   &acceleration) const
  {
    for (const auto &part : parts_)
      part.supports.set_rates(time, step_size, velocity, acceleration);
    const double difference = 0.01 * step_size;
    for (unsigned int l = 0; l < rigid_body_dofs_.size(); ++l)
      if (const auto &motion = rigid_body_dofs_[l].motion)
        {
          const MotionRates rates = motion_rates(motion, time, difference);
          velocity[dof_map_.n_body_dofs() + l]     = rates.velocity;
          acceleration[dof_map_.n_body_dofs() + l] = rates.acceleration;
        }
    dof_map_.constraints().distribute(velocity);
    dof_map_.constraints().distribute(acceleration);
  }



  template <int dim>
  double
  SolidModel<dim>::stiffness_at_load(const double time) const
  {
    const DofVector &force = external_force(time, DofVector(n_dofs()));
    Tensor<1, dim>   resultant;
    for (const auto &part : parts_)
      for (const auto &node : part.body->nodes())
        for (unsigned int c = 0; c < dim; ++c)
          if (!dof_map_.is_constrained(node.dofs[c]))
            resultant[c] += force[node.dofs[c]];
    if (resultant.norm() == 0.)
      throw InputError(
        "Contact / Relative penalty stiffness",
        "the bodies carry no load whose stiffness could be the measure. Give "
        "the Penalty stiffness in N/m.");
    try
      {
        SparseCholesky cholesky;
        cholesky.analyse(sparsity_, dof_map_.constrained(), {});
        cholesky.factorise(stiffness_);
        DofVector displacement(n_dofs());
        cholesky.solve(displacement, force);
        return resultant.norm_square() / (force * displacement);
      }
    catch (const NotPositiveDefinite &)
      {
        throw InputError(
          "Contact / Relative penalty stiffness",
          "a body can move freely and has no static stiffness. Give the "
          "Penalty stiffness in N/m.");
      }
  }



#define INSTANTIATE(dim) template class SolidModel<dim>;
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
