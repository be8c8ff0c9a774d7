// The part of SolidModel that assembles mass and damping.
#include <signorini/input_error.h>
#include <signorini/solid/solid_model.h>

#include "absorbing_boundary.h"
#include "condensed_diagonal.h"

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  void
  SolidModel<dim>::assemble_inertia(const Inertia &inertia)
  {
    SparseMatrix<double> mass(sparsity_), damping(sparsity_);
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
        const auto &absorbing = part.supports.absorbing_boundaries();
        add_absorbing_boundaries(body, absorbing, constraints_, damping);
        is_damped = is_damped || body.mass_damping() > 0. ||
                    body.stiffness_damping() > 0. || !absorbing.empty();
      }
    add_initial_stiffness(
      [](const Body<dim> &body) { return body.stiffness_damping(); }, damping);
    clear_condensed_diagonal(constraints_, mass);
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



  template void
  SolidModel<2>::assemble_inertia(const Inertia &);
  template void
  SolidModel<3>::assemble_inertia(const Inertia &);
} // namespace Signorini
