#include <signorini/solid/assembler.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/work_stream.h>
#include <deal.II/fe/fe_values.h>

#include <map>

#include "strain_operator.h"

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    struct ScratchData
    {
      ScratchData(const Body<dim> &body, const UpdateFlags flags)
        : values(body.mapping(),
                 body.scalar_fe(),
                 QGauss<dim>(body.scalar_fe().degree + 1),
                 flags)
        , indices(body.fe().n_dofs_per_cell())
      {}

      ScratchData(const ScratchData &other)
        : values(other.values.get_mapping(),
                 other.values.get_fe(),
                 other.values.get_quadrature(),
                 other.values.get_update_flags())
        , indices(other.indices)
      {}

      FEValues<dim>                        values;
      std::vector<types::global_dof_index> indices;
    };

    struct CopyData
    {
      explicit CopyData(const unsigned int n_dofs)
        : matrix(n_dofs, n_dofs)
        , vector(n_dofs)
        , dofs(n_dofs)
      {}

      FullMatrix<double>                   matrix;
      Vector<double>                       vector;
      std::vector<types::global_dof_index> dofs; // node by node
    };

    // Prepares both for a cell: shape functions, and the global unknowns
    // counted node by node whatever the element's own order is.
    template <int dim>
    void
    visit(const Body<dim>                                      &body,
          const typename DoFHandler<dim>::active_cell_iterator &cell,
          ScratchData<dim>                                     &scratch,
          CopyData                                             &copy)
    {
      scratch.values.reinit(
        static_cast<typename Triangulation<dim>::cell_iterator>(cell));
      cell->get_dof_indices(scratch.indices);
      for (unsigned int a = 0; a < body.scalar_fe().n_dofs_per_cell(); ++a)
        for (unsigned int c = 0; c < dim; ++c)
          copy.dofs[a * dim + c] =
            body.first_dof() +
            scratch.indices[body.fe().component_to_system_index(c, a)];
      copy.matrix = 0.;
      copy.vector = 0.;
    }

    template <int dim>
    Tensor<2, dim>
    displacement_gradient(const FEValues<dim>  &values,
                          const unsigned int    q,
                          const CopyData       &copy,
                          const Vector<double> &displacement)
    {
      Tensor<2, dim> gradient;
      for (const unsigned int a : values.dof_indices())
        for (unsigned int c = 0; c < dim; ++c)
          gradient[c] +=
            displacement[copy.dofs[a * dim + c]] * values.shape_grad(a, q);
      return gradient;
    }

    template <int dim, int n_strains>
    void
    cell_stiffness(const Body<dim>      &body,
                   const Vector<double> &displacement,
                   const double          factor,
                   const Material       &material,
                   const PointResponse  *constant_response,
                   ScratchData<dim>     &scratch,
                   CopyData             &copy)
    {
      const auto                                 &values = scratch.values;
      std::vector<StrainOperator<dim, n_strains>> B(values.dofs_per_cell);
      for (const unsigned int q : values.quadrature_point_indices())
        {
          const Point<dim> &point = values.quadrature_point(q);
          double            hoop  = 0.;
          for (const unsigned int a : values.dof_indices())
            {
              const double over_r =
                n_strains == 4 ? values.shape_value(a, q) / point[0] : 0.;
              B[a] = strain_operator<dim, n_strains>(values.shape_grad(a, q),
                                                     over_r);
              if (n_strains == 4)
                hoop += over_r * displacement[copy.dofs[a * dim]];
            }
          const double weight =
            factor * values.JxW(q) * body.volume_factor(point);
          if (constant_response)
            {
              add_lower_blocks<dim, n_strains>(B,
                                               constant_response->tangent,
                                               weight,
                                               copy.matrix);
              continue;
            }
          const PointResponse response =
            respond(body.formulation(),
                    material,
                    displacement_gradient(values, q, copy, displacement),
                    hoop,
                    {});
          add_lower_blocks<dim, n_strains>(B,
                                           response.tangent,
                                           weight,
                                           copy.matrix);
          for (const unsigned int a : values.dof_indices())
            for (unsigned int c = 0; c < dim; ++c)
              for (unsigned int s = 0; s < n_strains; ++s)
                copy.vector[a * dim + c] +=
                  weight * B[a][s][c] * response.stress[s];
        }
      for (unsigned int i = 0; i < copy.matrix.m(); ++i)
        for (unsigned int j = i + 1; j < copy.matrix.n(); ++j)
          copy.matrix(i, j) = copy.matrix(j, i);
    }

    template <int dim, int n_strains>
    void
    add_stiffness(const Body<dim>                 &body,
                  const AffineConstraints<double> &constraints,
                  const Vector<double>            &displacement,
                  const double                     factor,
                  SparseMatrix<double>            &stiffness,
                  Vector<double>                  &internal_force)
    {
      // A linear law answers the same at every point and displacement: its
      // tangent is asked for once, and the force is K times displacement.
      std::map<const Material *, PointResponse> constant_responses;
      for (const Material *const material : body.materials())
        if (material->is_linear())
          constant_responses[material] =
            respond(body.formulation(), *material, Tensor<2, dim>(), 0., {});

      const auto worker = [&](const auto       &cell,
                              ScratchData<dim> &scratch,
                              CopyData         &copy) {
        visit(body, cell, scratch, copy);
        const Material &material = body.material(cell->material_id());
        const auto      known    = constant_responses.find(&material);
        const PointResponse *const linear =
          known == constant_responses.end() ? nullptr : &known->second;
        cell_stiffness<dim, n_strains>(
          body, displacement, factor, material, linear, scratch, copy);
        if (linear)
          for (unsigned int i = 0; i < copy.dofs.size(); ++i)
            for (unsigned int j = 0; j < copy.dofs.size(); ++j)
              copy.vector[i] += copy.matrix(i, j) * displacement[copy.dofs[j]];
      };
      const auto copier = [&](const CopyData &copy) {
        constraints.distribute_local_to_global(
          copy.matrix, copy.vector, copy.dofs, stiffness, internal_force);
      };
      WorkStream::run(body.dof_handler().begin_active(),
                      body.dof_handler().end(),
                      worker,
                      copier,
                      ScratchData<dim>(body,
                                       update_values | update_gradients |
                                         update_quadrature_points |
                                         update_JxW_values),
                      CopyData(body.fe().n_dofs_per_cell()));
    }

    template <int dim>
    void
    cell_mass(const Body<dim>  &body,
              const double      density,
              const bool        lump,
              const double      factor,
              ScratchData<dim> &scratch,
              CopyData         &copy)
    {
      const auto &values = scratch.values;
      for (const unsigned int q : values.quadrature_point_indices())
        {
          const double weight = factor * density * values.JxW(q) *
                                body.volume_factor(values.quadrature_point(q));
          for (const unsigned int a : values.dof_indices())
            for (const unsigned int b : values.dof_indices())
              {
                const double mass =
                  weight * values.shape_value(a, q) * values.shape_value(b, q);
                for (unsigned int c = 0; c < dim; ++c)
                  copy.matrix(a * dim + c, (lump ? a : b) * dim + c) += mass;
              }
        }
    }
  } // namespace



  template <int dim>
  void
  add_stiffness(const Body<dim>                 &body,
                const AffineConstraints<double> &constraints,
                const Vector<double>            &displacement,
                const double                     factor,
                SparseMatrix<double>            &stiffness,
                Vector<double>                  &internal_force)
  {
    if constexpr (dim == 3)
      add_stiffness<3, 6>(
        body, constraints, displacement, factor, stiffness, internal_force);
    else if (body.formulation() == Formulation::axisymmetric)
      add_stiffness<2, 4>(
        body, constraints, displacement, factor, stiffness, internal_force);
    else
      add_stiffness<2, 3>(
        body, constraints, displacement, factor, stiffness, internal_force);
  }



  template <int dim>
  void
  add_mass(const Body<dim>                 &body,
           const AffineConstraints<double> &constraints,
           const bool                       lump,
           const double                     factor,
           SparseMatrix<double>            &mass)
  {
    WorkStream::run(
      body.dof_handler().begin_active(),
      body.dof_handler().end(),
      [&](const auto &cell, ScratchData<dim> &scratch, CopyData &copy) {
        visit(body, cell, scratch, copy);
        cell_mass(body,
                  body.material(cell->material_id()).density(),
                  lump,
                  factor,
                  scratch,
                  copy);
      },
      [&](const CopyData &copy) {
        constraints.distribute_local_to_global(copy.matrix, copy.dofs, mass);
      },
      ScratchData<dim>(body,
                       update_values | update_quadrature_points |
                         update_JxW_values),
      CopyData(body.fe().n_dofs_per_cell()));
  }



  template void
  add_stiffness<2>(const Body<2> &,
                   const AffineConstraints<double> &,
                   const Vector<double> &,
                   const double,
                   SparseMatrix<double> &,
                   Vector<double> &);
  template void
  add_stiffness<3>(const Body<3> &,
                   const AffineConstraints<double> &,
                   const Vector<double> &,
                   const double,
                   SparseMatrix<double> &,
                   Vector<double> &);
  template void
  add_mass<2>(const Body<2> &,
              const AffineConstraints<double> &,
              const bool,
              const double,
              SparseMatrix<double> &);
  template void
  add_mass<3>(const Body<3> &,
              const AffineConstraints<double> &,
              const bool,
              const double,
              SparseMatrix<double> &);
} // namespace Signorini
