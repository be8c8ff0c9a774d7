#include "absorbing_boundary.h"

#include <signorini/input/instantiate.h>
#include <signorini/linear_algebra/types.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include "cell_dofs.h"

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // Resistance of a boundary to a velocity, Pa s/m.
    struct Impedance
    {
      double compression; // sqrt(rho M)
      double shear;       // sqrt(rho G)
    };

    template <int dim>
    Impedance
    impedance(const Formulation formulation, const Material &material)
    {
      const std::vector<double> history_n(
        n_history_values(formulation, material));
      std::vector<double> history(history_n);
      const auto          tangent = respond(formulation,
                                   material,
                                   Tensor<2, dim>(),
                                   0.,
                                   {},
                                   make_array_view(history_n),
                                   make_array_view(history))
                             .tangent;
      const auto        &components = strain_components(formulation);
      const unsigned int shear =
        std::find(components.begin(),
                  components.end(),
                  std::pair<unsigned int, unsigned int>(0, 1)) -
        components.begin();
      return {std::sqrt(material.density() * tangent[0][0]),
              std::sqrt(material.density() * tangent[shear][shear])};
    }

    template <int dim>
    void
    add_face(const Body<dim>         &body,
             const Impedance         &impedance,
             const FEFaceValues<dim> &values,
             FullMatrix<double>      &damping)
    {
      for (const unsigned int q : values.quadrature_point_indices())
        {
          const Tensor<1, dim> normal = values.normal_vector(q);
          const double         weight =
            values.JxW(q) * body.volume_factor(values.quadrature_point(q));
          Tensor<2, dim> resistance =
            (impedance.compression - impedance.shear) *
            outer_product(normal, normal);
          for (unsigned int c = 0; c < dim; ++c)
            resistance[c][c] += impedance.shear;
          for (const unsigned int a : values.dof_indices())
            for (const unsigned int b : values.dof_indices())
              for (unsigned int c = 0; c < dim; ++c)
                for (unsigned int d = 0; d < dim; ++d)
                  damping(a * dim + c, b * dim + d) +=
                    weight * values.shape_value(a, q) *
                    values.shape_value(b, q) * resistance[c][d];
        }
    }
  } // namespace



  template <int dim>
  void
  add_absorbing_boundaries(const Body<dim>                    &body,
                           const std::set<types::boundary_id> &boundaries,
                           const AffineConstraints<double>    &constraints,
                           DofMatrix                          &damping)
  {
    FEFaceValues<dim>  values(body.mapping(),
                             body.scalar_fe(),
                             QGauss<dim - 1>(body.scalar_fe().degree + 1),
                             update_values | update_quadrature_points |
                               update_JxW_values | update_normal_vectors);
    CellDofs<dim>      dofs(body);
    FullMatrix<double> face_damping(body.fe().n_dofs_per_cell());
    for (const auto &cell : body.dof_handler().active_cell_iterators())
      for (const unsigned int face : cell->face_indices())
        {
          if (!cell->face(face)->at_boundary() ||
              boundaries.count(cell->face(face)->boundary_id()) == 0)
            continue;
          values.reinit(static_cast<typename Triangulation<dim>::cell_iterator>(
                          cell),
                        face);
          dofs.reinit(cell);
          face_damping = 0.;
          add_face(body,
                   impedance<dim>(body.formulation(),
                                  body.material(cell->material_id())),
                   values,
                   face_damping);
          constraints.distribute_local_to_global(face_damping,
                                                 dofs.all(),
                                                 damping);
        }
  }



#define INSTANTIATE(dim)                       \
  template void add_absorbing_boundaries<dim>( \
    const Body<dim> &,                         \
    const std::set<types::boundary_id> &,      \
    const AffineConstraints<double> &,         \
    DofMatrix &);
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
