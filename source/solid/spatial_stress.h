#ifndef signorini_solid_spatial_stress_h
#define signorini_solid_spatial_stress_h

#include <signorini/solid/formulation.h>

#include <deal.II/base/tensor.h>

namespace Signorini
{
  /**
   * A stress as a tensor: between the coordinates of the body, and across the
   * plane or around the axis. In three dimensions there is nothing across.
   */
  template <int dim, int n_strains>
  struct SpatialStress
  {
    explicit SpatialStress(const ReducedStress &reduced)
      : across(dim == 2 && n_strains == 4 ? reduced[3] : 0.)
    {
      for (unsigned int i = 0; i < dim; ++i)
        between[i][i] = reduced[i];
      for (unsigned int k = 0; k < n_shear; ++k)
        between[pairs[k][0]][pairs[k][1]] = between[pairs[k][1]][pairs[k][0]] =
          reduced[dim + k];
    }

    SpatialStress(const dealii::Tensor<2, dim> &between, const double across)
      : between(between)
      , across(across)
    {}

    ReducedStress
    reduced() const
    {
      ReducedStress result = {};
      for (unsigned int i = 0; i < dim; ++i)
        result[i] = between[i][i];
      for (unsigned int k = 0; k < n_shear; ++k)
        result[dim + k] = between[pairs[k][0]][pairs[k][1]];
      if (dim == 2 && n_strains == 4)
        result[3] = across;
      return result;
    }

    /**
     * grad v : stress of the shape function with this gradient, for each
     * component of v.
     */
    dealii::Tensor<1, dim>
    power(const dealii::Tensor<1, dim> &gradient, const double over_r) const
    {
      dealii::Tensor<1, dim> result = between * gradient;
      result[0] += across * over_r;
      return result;
    }

    dealii::Tensor<2, dim> between;
    double                 across;

  private:
    static constexpr unsigned int n_shear     = dim == 2 ? 1 : 3;
    static constexpr unsigned int pairs[3][2] = {{0, 1}, {1, 2}, {0, 2}};
  };

  /**
   * tr(grad v grad w) of the component i of one shape function and j of
   * another.
   */
  template <int dim>
  inline double
  trace_of_product(const dealii::Tensor<1, dim> &g_a,
                   const double                  over_r_a,
                   const unsigned int            i,
                   const dealii::Tensor<1, dim> &g_b,
                   const double                  over_r_b,
                   const unsigned int            j)
  {
    return g_a[j] * g_b[i] + (i == 0 && j == 0 ? over_r_a * over_r_b : 0.);
  }
} // namespace Signorini

#endif
