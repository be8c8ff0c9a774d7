#ifndef signorini_solid_cell_response_h
#define signorini_solid_cell_response_h

#include <signorini/solid/body.h>

#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <vector>

#include "dilatation_projection.h"
#include "strain_operator.h"

namespace Signorini
{
  /**
   * What a cell answers to the displacements of its nodes, integrated over its
   * present position (finite strain) or its first one (small strain):
   *
   *   f_a  = int B_a^T stress dV,
   *   K_ab = int B_a^T tangent B_b dV + geometric part.
   *
   * With mean dilatation the volume changes by theta, the projection of J
   * (DilatationProjection; with bilinear elements theta = int J dV / int dV):
   * F_bar = (theta / J)^(1/3) F, and B follows from it, so that f is the
   * derivative of int psi(F_bar) dV and K is symmetric [Simo, Taylor & Pister
   * 1985; Hughes 1980 for small strain].
   *
   * Unknowns are counted node by node. Used again from cell to cell.
   */
  template <int dim, int n_strains>
  class CellResponse
  {
  public:
    /** The constant answer of a linear law, or the histories of the points of
     * the cell, one after the other. */
    struct Point
    {
      const Material                 *material;
      const PointResponse            *constant; // or null
      double                          step_size;
      dealii::ArrayView<const double> history_n;
      dealii::ArrayView<double>       history;
      unsigned int                    n_history_values;
    };

    CellResponse(const Body<dim> &body, const unsigned int n_points);

    /**
     * @param values of the cell, before the deformation
     * @param displacement of its nodes, m
     * @throws MaterialFailure
     */
    void
    evaluate(const dealii::FEValues<dim> &values,
             const std::vector<double>   &displacement,
             const Point                 &point,
             const bool                   with_stiffness);

    dealii::FullMatrix<double> stiffness;     // N/m
    dealii::Vector<double>     force;         // N
    double                     stored_energy; // J
    double                     plastic_work;  // J

    // Cauchy, at each point; not for a linear law with a constant answer. Pa
    std::vector<dealii::SymmetricTensor<2, 3>> stresses;

  private:
    using Operator = StrainOperator<dim, n_strains>;

    // At one point of the cell.
    struct DeformedPoint
    {
      dealii::Tensor<2, dim>              gradient;        // du/dX
      double                              hoop = 0.;       // u_r/R
      double                              dilatation;      // J - 1 or div u
      double                              mean_dilatation; // theta - 1
      double                              volume;          // before
      std::vector<dealii::Tensor<1, dim>> shape_gradients;
      std::vector<double>                 over_r; // N_a/r, axisymmetric

      // d ln theta for each shape function and component.
      std::vector<dealii::Tensor<1, dim>> mean_divergence;
    };

    void
    find_kinematics(const dealii::FEValues<dim> &values,
                    const std::vector<double>   &displacement,
                    const unsigned int           q);

    // Mean dilatation, and the mean of the divergences of the shape functions.
    void
    find_means(const dealii::FEValues<dim> &values);

    // Scales the gradient at a point to the mean dilatation.
    void
    set_mean_dilatation(const DeformedPoint    &kinematics,
                        dealii::Tensor<2, dim> &gradient,
                        double                 &thickness_strain) const;

    void
    set_strain_operators(const DeformedPoint &kinematics);

    void
    add_force(const PointResponse &response, const double volume);

    void
    add_geometric_stiffness(const DeformedPoint &kinematics,
                            const PointResponse &response);

    // Of the mean dilatation: the second derivative of F_bar.
    void
    add_dilatation_stiffness(const unsigned int   q,
                             const PointResponse &response);

    void
    add_mean_divergence_stiffness();

    // Volume now by that before, at a point and in the projection.
    double
    volume_ratio(const DeformedPoint &kinematics) const
    {
      return is_finite_ ? 1. + kinematics.dilatation : 1.;
    }

    double
    mean_volume_ratio(const DeformedPoint &kinematics) const
    {
      return is_finite_ ? 1. + kinematics.mean_dilatation : 1.;
    }

    double
    divergence(const DeformedPoint &kinematics,
               const unsigned int   a,
               const unsigned int   c) const
    {
      return kinematics.shape_gradients[a][c] +
             (c == 0 ? kinematics.over_r[a] : 0.);
    }

    const Body<dim>           *body_;
    const bool                 is_finite_;
    const bool                 is_axisymmetric_;
    const bool                 has_mean_dilatation_;
    std::vector<DeformedPoint> points_;
    std::vector<Operator>      strain_operators_;
    DilatationProjection<dim>  projection_;
    std::vector<double>        volumes_;   // of the points, before
    std::vector<double>        pressures_; // tr(stress)/3 dV
  };
} // namespace Signorini

#endif
