#include <signorini/material/material.h>
#include <signorini/material/principal_frame.h>

#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // Closed form. The half angle is taken from the greater of cosine and sine,
    // which keeps both accurate.
    SpectralDecomposition
    decompose_planar(const SymmetricTensor<2, 3> &tensor)
    {
      const double mean   = 0.5 * (tensor[0][0] + tensor[1][1]);
      const double half   = 0.5 * (tensor[0][0] - tensor[1][1]);
      const double shear  = tensor[0][1];
      const double radius = std::sqrt(half * half + shear * shear);

      double cosine = 1., sine = 0.;
      if (radius > 0.)
        {
          const double greater =
            std::sqrt(0.5 * (1. + std::abs(half) / radius));
          const double lesser = 0.5 * shear / (radius * greater);
          cosine              = half > 0. ? greater : lesser;
          sine                = half > 0. ? lesser : greater;
        }
      SpectralDecomposition result;
      result.values     = {{mean + radius, mean - radius, tensor[2][2]}};
      result.axes[0][0] = result.axes[1][1] = cosine;
      result.axes[1][0]                     = sine;
      result.axes[0][1]                     = -sine;
      result.axes[2][2]                     = 1.;
      return result;
    }
  } // namespace



  bool
  is_planar(const Tensor<2, 3> &matrix)
  {
    return matrix[0][2] == 0. && matrix[1][2] == 0. && matrix[2][0] == 0. &&
           matrix[2][1] == 0.;
  }



  SpectralDecomposition
  decompose(const SymmetricTensor<2, 3> &tensor, const bool is_planar)
  {
    if (is_planar)
      return decompose_planar(tensor);
    const auto pairs =
      eigenvectors(tensor, SymmetricTensorEigenvectorMethod::jacobi);
    SpectralDecomposition result;
    for (unsigned int a = 0; a < 3; ++a)
      {
        result.values[a] = pairs[a].first;
        for (unsigned int i = 0; i < 3; ++i)
          result.axes[i][a] = pairs[a].second[i];
      }
    return result;
  }



  PrincipalFrame
  PrincipalFrame::of(const Tensor<2, 3> &gradient)
  {
    SymmetricTensor<2, 3> excess; // C - 1
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = i; j < 3; ++j)
        {
          excess[i][j] = gradient[i][j] + gradient[j][i];
          for (unsigned int k = 0; k < 3; ++k)
            excess[i][j] += gradient[k][i] * gradient[k][j];
        }

    PrincipalFrame frame;
    frame.is_planar           = Signorini::is_planar(gradient);
    const auto [values, axes] = decompose(excess, frame.is_planar);
    frame.material_axes       = axes;
    frame.spatial_axes        = axes + gradient * axes;
    for (unsigned int a = 0; a < 3; ++a)
      {
        if (!(values[a] > -1.))
          throw MaterialFailure("The square of a principal stretch is " +
                                std::to_string(1. + values[a]) +
                                ", but it must be greater than zero.");
        frame.stretch[a]    = std::sqrt(1. + values[a]);
        frame.log_strain[a] = 0.5 * std::log1p(values[a]);
        for (unsigned int i = 0; i < 3; ++i)
          frame.spatial_axes[i][a] /= frame.stretch[a];
      }
    return frame;
  }
} // namespace Signorini
