#ifndef signorini_solid_dilatation_projection_h
#define signorini_solid_dilatation_projection_h

#include <deal.II/base/polynomial_space.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/full_matrix.h>

#include <vector>

namespace Signorini
{
  /**
   * The projection in L2, cell by cell, on the complete polynomials of one
   * degree less than the displacements: with bilinear elements the mean over
   * the cell. A change of volume of these polynomials is what the displacements
   * can follow without locking, Q_k/P_(k-1) [BoffiGastaldi2002: polynomials
   * in the coordinates of space, not of the unit cell].
   *
   * Used again from cell to cell.
   */
  template <int dim>
  class DilatationProjection
  {
  public:
    /** @param degree of the displacements */
    DilatationProjection(const unsigned int degree,
                         const unsigned int n_points);

    /** @param volumes of the points of the cell, m^3 */
    void
    reinit(const dealii::FEValues<dim> &values,
           const std::vector<double>   &volumes);

    /** What a value at a point adds to the projection at another. */
    double
    operator()(const unsigned int at, const unsigned int of) const
    {
      return matrix_(at, of);
    }

  private:
    // The polynomials at the points, a row for each point.
    void
    evaluate_polynomials(const dealii::FEValues<dim> &values);

    dealii::PolynomialSpace<dim> polynomials_;
    dealii::FullMatrix<double>   at_points_;
    dealii::FullMatrix<double>   mass_;
    dealii::FullMatrix<double>   coefficients_; // of a unit value at each point
    dealii::FullMatrix<double>   matrix_;
  };
} // namespace Signorini

#endif
