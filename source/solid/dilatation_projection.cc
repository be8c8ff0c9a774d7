#include "dilatation_projection.h"

#include <signorini/input/instantiate.h>

#include <deal.II/base/polynomial.h>
#include <deal.II/grid/grid_tools.h>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  DilatationProjection<dim>::DilatationProjection(const unsigned int degree,
                                                  const unsigned int n_points)
    : polynomials_(Polynomials::Legendre::generate_complete_basis(degree - 1))
    , at_points_(n_points, polynomials_.n())
    , mass_(at_points_.n(), at_points_.n())
    , coefficients_(at_points_.n(), n_points)
    , matrix_(n_points, n_points)
  {
    // The only polynomial of degree 0.
    for (unsigned int q = 0; q < n_points; ++q)
      at_points_(q, 0) = 1.;
  }



  template <int dim>
  void
  DilatationProjection<dim>::reinit(const FEValues<dim>       &values,
                                    const std::vector<double> &volumes)
  {
    if (polynomials_.n() > 1)
      evaluate_polynomials(values);
    mass_ = 0.;
    for (unsigned int q = 0; q < volumes.size(); ++q)
      for (unsigned int i = 0; i < mass_.m(); ++i)
        for (unsigned int j = 0; j < mass_.n(); ++j)
          mass_(i, j) += volumes[q] * at_points_(q, i) * at_points_(q, j);
    mass_.gauss_jordan();
    mass_.mTmult(coefficients_, at_points_);
    for (unsigned int q = 0; q < volumes.size(); ++q)
      for (unsigned int i = 0; i < coefficients_.m(); ++i)
        coefficients_(i, q) *= volumes[q];
    at_points_.mmult(matrix_, coefficients_);
  }



  template <int dim>
  void
  DilatationProjection<dim>::evaluate_polynomials(const FEValues<dim> &values)
  {
    // x = A xi + b through the vertices at best: turned and stretched like the
    // cell, so that the polynomials are well told apart in a flat one, too.
    const auto              cell = values.get_cell();
    std::vector<Point<dim>> vertices;
    for (const unsigned int v : cell->vertex_indices())
      vertices.push_back(cell->vertex(v));
    const auto [A, b] =
      GridTools::affine_cell_approximation<dim, dim>(vertices);
    const Tensor<2, dim> to_unit(invert(Tensor<2, dim>(A)));
    for (const unsigned int q : values.quadrature_point_indices())
      {
        const Point<dim> place(to_unit * (values.quadrature_point(q) - b));
        for (unsigned int i = 0; i < at_points_.n(); ++i)
          at_points_(q, i) = polynomials_.compute_value(i, place);
      }
  }



#define INSTANTIATE(dim) template class DilatationProjection<dim>;
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
