// The part of SolidModel that assembles mass and damping.
#include <signorini/input/input_error.h>
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
    SparseMatrix<double> damping(sparsity_);
    mass_.reinit(sparsity_);
    for (const auto &part : parts_)
      {
        const Body<dim> &body = *part.body;
        for (const Material *const material : body.materials())
          if (material->density() <= 0.)
            throw InputError("Body " + body.name() +
                             " / Material / Density: must be greater than zero "
                             "in a dynamic run, in kg/m^3. Without inertia set "
                             "Time / Analysis = static.");
        add_mass(body, constraints_, inertia.lumped, 1., mass_);
        if (body.mass_damping() > 0.)
          add_mass(
            body, constraints_, inertia.lumped, body.mass_damping(), damping);
        add_absorbing_boundaries(body,
                                 part.supports.absorbing_boundaries(),
                                 constraints_,
                                 damping);
      }
    add_initial_stiffness(
      [](const Body<dim> &body) { return body.stiffness_damping(); }, damping);
    clear_condensed_diagonal(constraints_, mass_);
    for (unsigned int l = 0; l < lumped_.size(); ++l)
      mass_.set(first_lumped() + l, first_lumped() + l, lumped_[l].mass);
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
        result->redistribution.add(*part.body, nodes, is_fixed_, is_hanging_);
      }
    result->matrix.reinit(sparsity_);
    result->matrix.copy_from(mass_);
    result->redistribution.move_mass(result->matrix);
    // What supports hold has no momentum of its own.
    const Vector<double> at_start(n_dofs());
    for (const auto &part : parts_)
      if (!free_rigid_modes(
             *part.body, at_start, is_given_, part.supports.sliding_nodes())
             .empty() &&
          !keep_moments(
            *part.body, mass_, result->redistribution, result->matrix))
        result->changed_bodies.push_back(part.body->name());
    return result;
  }



  template bool
  SolidModel<2>::has_damping() const;
  template bool
  SolidModel<3>::has_damping() const;
  template void
  SolidModel<2>::assemble_inertia(const Inertia &);
  template void
  SolidModel<3>::assemble_inertia(const Inertia &);
  template std::unique_ptr<const SolidModel<2>::RedistributedMass>
  SolidModel<2>::redistribute_mass(const std::vector<unsigned int> &) const;
  template std::unique_ptr<const SolidModel<3>::RedistributedMass>
  SolidModel<3>::redistribute_mass(const std::vector<unsigned int> &) const;
} // namespace Signorini
