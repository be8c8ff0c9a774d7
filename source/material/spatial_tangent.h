#ifndef signorini_source_material_spatial_tangent_h
#define signorini_source_material_spatial_tangent_h

#include <signorini/material/material.h>
#include <signorini/material/principal_frame.h>
#include <signorini/material/strain_law.h>

namespace Signorini
{
  /**
   * Kirchhoff stress and spatial tangent from what a strain law answers to a
   * logarithmic strain, in the frame of this strain. The formulas stand at
   * LogarithmicMaterial.
   */
  MaterialResponse
  push_forward(const PrincipalFrame &frame, const StrainResponse &response);

  /** A matrix or tensor in other axes: axes^T tensor axes. */
  dealii::SymmetricTensor<2, 3>
  into_axes(const dealii::SymmetricTensor<2, 3> &tensor,
            const dealii::Tensor<2, 3>          &axes);
} // namespace Signorini

#endif
