// The part of SolidModel that assembles mass and damping.
#include <signorini/input/input_error.h>
#include <signorini/input/instantiate.h>
#include <signorini/linear_algebra/types.h>
#include <signorini/solid/mass_matrix.h>
#include <signorini/solid/mass_moments.h>
#include <signorini/solid/solid_model.h>

#include <algorithm>

#include "absorbing_boundary.h"
#include "condensed_diagonal.h"

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  bool
  SolidModel<dim>::has_damping() const
  {
    return std::any_of(parts_.begin(), parts_.end(), [](const Part &part) {
      return part.body->mass_damping() > 0. ||
             part.body->stiffness_damping() > 0. ||
             !part.supports.absorbing_boundaries().empty();
    });
  }



  template <int dim>
  void
  SolidModel<dim>::assemble_inertia(const Inertia &inertia)
  {
    DofMatrix damping(sparsity_);
    mass_.reinit(sparsity_);
    for (const auto &part : parts_)
      {
        const Body<dim> &body = *part.body;
        for (const Material *const material : body.materials())
          if (material->density() <= 0.)
            throw InputError(
              "Body " + body.name() + " / Material / Density",
              "must be greater than zero in a dynamic run, in kg/m^3. Without "
              "inertia set Time / Analysis = static.");
        add_mass(body, dof_map_.constraints(), inertia.lumped, 1., mass_);
        if (body.mass_damping() > 0.)
          add_mass(body,
                   dof_map_.constraints(),
                   inertia.lumped,
                   body.mass_damping(),
                   damping);
        add_absorbing_boundaries(body,
                                 part.supports.absorbing_boundaries(),
                                 dof_map_.constraints(),
                                 damping);
      }
    add_initial_stiffness(
      [](const Body<dim> &body) { return body.stiffness_damping(); }, damping);
    clear_condensed_diagonal(dof_map_.constraints(), mass_);
    for (unsigned int l = 0; l < rigid_body_dofs_.size(); ++l)
      mass_.set(dof_map_.n_body_dofs() + l,
                dof_map_.n_body_dofs() + l,
                rigid_body_dofs_[l].mass);
    if (has_damping())
      {
        damping_.reinit(sparsity_);
        undamped_.congruence(damping, damping_);
      }
  }



  template <int dim>
  std::unique_ptr<const typename SolidModel<dim>::RedistributedMass>
  SolidModel<dim>::redistribute_mass(
    const std::vector<unsigned int> &massless_nodes) const
  {
    auto result = std::make_unique<RedistributedMass>();
    for (const auto &part : parts_)
      {
        std::vector<Node<dim>> nodes;
        for (const auto &node : part.body->nodes())
          if (std::binary_search(massless_nodes.begin(),
                                 massless_nodes.end(),
                                 node.dofs[0]))
            nodes.push_back(node);
        result->redistribution.add(*part.body, nodes, dof_map_);
      }
    result->matrix.reinit(sparsity_);
    result->matrix.copy_from(mass_);
    result->redistribution.move_mass(result->matrix);
    // What supports hold has no momentum of its own.
    const DofVector at_start(n_dofs());
    for (const auto &part : parts_)
      if (!free_rigid_modes(
             *part.body, at_start, dof_map_, part.supports.sliding_nodes())
             .empty() &&
          !keep_moments(
            *part.body, mass_, result->redistribution, result->matrix))
        result->changed_bodies.push_back(part.body->name());
    return result;
  }



#define INSTANTIATE(dim)                                             \
  template bool SolidModel<dim>::has_damping() const;                \
  template void SolidModel<dim>::assemble_inertia(const Inertia &);  \
  template std::unique_ptr<const SolidModel<dim>::RedistributedMass> \
  SolidModel<dim>::redistribute_mass(const std::vector<unsigned int> &) const;
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
