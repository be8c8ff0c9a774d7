#ifndef signorini_solid_cell_response_h
#define signorini_solid_cell_response_h

#include <signorini/solid/body.h>

#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <vector>

#include "dilatation_projection.h"
#include "spatial_stress.h"
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
   * derivative of int psi(F_bar) dV and K is symmetric
   * [SimoTaylorPister1985; Hughes1980 for small strain].
   *
   * The mean force over a step does as much work as the energy W of the cell
   * takes up in it, and leaves momentum and angular momentum alone,
   *
   *   f_a = int F_m (S_m + lambda (E_np - E_n)) grad N_a dV,
   *
   * F_m and S_m the means of the deformation gradient and of the second
   * Piola-Kirchhoff stress at both ends, E Green's strain, and lambda such that
   * sum_a f_a.(U_np - U_n)_a = W_np - W_n [SimoTarnow1992; Gonzalez2000].
   * Its derivative is not symmetric; the stiffness is twice the symmetric part
   * of it but for lambda, with F taken at three quarters of the way.
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
      const Material      *material;
      const PointResponse *constant; // or null
      MaterialStep         step;
      std::vector<double>  temperatures; // at its points; empty: as before
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

    /**
     * The same at the end of a step, and the mean force over it.
     * @param displacement_n at the start of the step, m
     */
    void
    evaluate_step(const dealii::FEValues<dim> &values,
                  const std::vector<double>   &displacement_n,
                  const std::vector<double>   &displacement,
                  const Point                 &point,
                  const bool                   with_stiffness);

    dealii::FullMatrix<double> stiffness;     // N/m
    dealii::Vector<double>     force;         // N
    dealii::Vector<double>     mean_force;    // N
    double                     stored_energy; // J
    double                     plastic_work;  // J
    double                     heating;       // J

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

      // d ln J and d ln theta for each shape function and component.
      std::vector<dealii::Tensor<1, dim>> divergence;
      std::vector<dealii::Tensor<1, dim>> mean_divergence;

      // From the motion of the nodes to that which the strains are taken of.
      dealii::Tensor<2, dim> turn;
      double                 hoop_turn;
    };

    // A symmetric tensor before the deformation: the second Piola-Kirchhoff
    // stress, in small strain the stress; or a strain.
    struct ReferenceTensor
    {
      dealii::Tensor<2, dim> between;
      double                 across = 0.;
    };

    // At one point of the cell, at the start of a step.
    struct StartPoint
    {
      dealii::Tensor<2, dim> gradient;
      double                 hoop;
      ReferenceTensor        stress;      // of the material
      ReferenceTensor        work_stress; // which does work on du/dX
    };

    // At one point of the cell, over the step.
    struct MeanPoint
    {
      dealii::Tensor<2, dim> F;
      double                 hoop_ratio;
      ReferenceTensor        stress;        // mean of both ends
      ReferenceTensor        middle_stress; // half way in strain
      ReferenceTensor        strain_change; // of Green's strain, 1
    };

    // Kinematics, and what the material says to them unless it is constant.
    void
    find_responses(const dealii::FEValues<dim> &values,
                   const std::vector<double>   &displacement,
                   const Point                 &point);

    // The same for points that are in place.
    void
    respond_to_kinematics(const dealii::FEValues<dim> &values,
                          const Point                 &point);

    void
    set_constant_response(const std::vector<double> &displacement,
                          const Point               &point);

    void
    add_forces();

    void
    add_stiffness();

    void
    mirror_lower_blocks();

    // tr(stress)/3 dV of each point, and what it makes of each volume.
    void
    find_pressures();

    void
    turn(const DeformedPoint &kinematics, Operator &B) const;

    void
    keep_start();

    // The stress that does work on the gradient at the point itself: with mean
    // dilatation the pressures of all points work on the volume at this one.
    SpatialStress<dim, n_strains>
    work_stress(const unsigned int q) const;

    ReferenceTensor
    pull_back(const SpatialStress<dim, n_strains> &stress,
              const DeformedPoint                 &at) const;

    // Means of the step, and changes of strain.
    void
    set_means();

    void
    set_mean_force(const dealii::FEValues<dim> &values,
                   const double                 missing_work);

    // Integral of a tensor over the change of strain: of a stress its work, J.
    double
    work_of(const ReferenceTensor MeanPoint::*const tensor) const;

    // Half way of the step in strain.
    void
    set_middle_kinematics(const dealii::FEValues<dim> &values,
                          const unsigned int           q);

    // What the mean stresses lack beside the change of the stored energy, J.
    double
    missing_work(const double change_of_energy) const;

    // Of the step instead of its end: mean stresses, and F between.
    void
    set_mean_tangent();

    void
    find_kinematics(const dealii::FEValues<dim> &values,
                    const std::vector<double>   &displacement,
                    const unsigned int           q);

    // What follows from the gradient at a point.
    void
    set_kinematics(const dealii::FEValues<dim> &values, const unsigned int q);

    // Mean dilatation.
    void
    find_means(const dealii::FEValues<dim> &values);

    // The divergences of the shape functions and their means.
    void
    find_divergences();

    // Scales the gradient at a point to the mean dilatation.
    void
    set_mean_dilatation(const DeformedPoint    &kinematics,
                        dealii::Tensor<2, dim> &gradient,
                        double                 &thickness_strain) const;

    void
    set_strain_operators(const DeformedPoint &kinematics);

    void
    add_geometric_stiffness(const DeformedPoint &kinematics,
                            const PointResponse &response);

    // Of the mean dilatation: the second derivative of F_bar.
    void
    add_dilatation_stiffness(const DeformedPoint &kinematics,
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

    // Length of a circle around the axis now by that before.
    double
    hoop_ratio(const double hoop) const
    {
      return is_finite_ && is_axisymmetric_ ? 1. + hoop : 1.;
    }

    dealii::Tensor<2, dim>
    deformation_gradient(const dealii::Tensor<2, dim> &gradient) const;

    const Body<dim>           *body_;
    const bool                 is_finite_;
    const bool                 is_axisymmetric_;
    const bool                 has_mean_dilatation_;
    bool                       is_mean_; // strains are those of a step
    std::vector<DeformedPoint> points_;
    std::vector<PointResponse> responses_;
    std::vector<StartPoint>    start_;
    std::vector<MeanPoint>     means_;
    std::vector<double>        unused_history_;
    std::vector<Operator>      strain_operators_;
    DilatationProjection<dim>  projection_;
    std::vector<double>        volumes_;   // of the points, before
    std::vector<double>        pressures_; // tr(stress)/3 dV
    std::vector<double>        weights_;   // d energy / d ln J, J
  };
} // namespace Signorini

#endif
