#ifndef signorini_material_principal_frame_h
#define signorini_material_principal_frame_h

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <array>

namespace Signorini
{
  /**
   * The principal stretches and axes of a deformation,
   *   F = sum_a lambda_a n_a N_a^T,   C = F^T F = sum_a lambda_a^2 N_a N_a^T,
   * with everything that small strains ask for: lambda^2 - 1 comes from F - 1
   * and ln(lambda) from log1p, so that no digit is lost.
   */
  struct PrincipalFrame
  {
    bool is_planar; // N_3 = n_3 = z: no shear xz, yz

    std::array<double, 3> stretch;    // lambda
    std::array<double, 3> log_strain; // ln(lambda)

    dealii::Tensor<2, 3> material_axes; // column a: N_a
    dealii::Tensor<2, 3> spatial_axes;  // column a: n_a

    /**
     * @param gradient F - 1
     * @throws MaterialFailure unless all stretches are positive.
     */
    static PrincipalFrame
    of(const dealii::Tensor<2, 3> &gradient);
  };

  /** Eigenvalues, and eigenvectors as columns, in no particular order. */
  struct SpectralDecomposition
  {
    std::array<double, 3> values;
    dealii::Tensor<2, 3>  axes;
  };

  /** @param is_planar xz and yz vanish: the third axis is z */
  SpectralDecomposition
  decompose(const dealii::SymmetricTensor<2, 3> &tensor, const bool is_planar);

  /** A matrix without xz and yz, to the digit. */
  bool
  is_planar(const dealii::Tensor<2, 3> &matrix);
} // namespace Signorini

#endif
