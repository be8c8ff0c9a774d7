#ifndef signorini_solid_formulation_h
#define signorini_solid_formulation_h

#include <signorini/material/material.h>

#include <deal.II/base/point.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace Signorini
{
  /** How a body of two or three coordinates stands for a solid in space. */
  enum class Formulation
  {
    plane_strain,
    plane_stress,
    axisymmetric, // x is the radius r, y the axis
    three_dimensional
  };

  /** The .prm names, separated by `|`. */
  std::string
  formulation_names();

  Formulation
  formulation_from_name(const std::string &name);

  /** Number of coordinates: 2 or 3. */
  unsigned int
  space_dimension(const Formulation formulation);

  /**
   * The pairs (i,j) of the strains that do virtual work, in the order of the
   * reduced vectors: xx, yy, xy; axisymmetric xx, yy, zz (hoop), xy;
   * three-dimensional xx, yy, zz, xy, yz, xz. Shear strains are engineering
   * strains.
   */
  const std::vector<std::pair<unsigned int, unsigned int>> &
  strain_components(const Formulation formulation);

  /** Entries of the reduced vectors are at most this many. */
  constexpr unsigned int max_strain_components = 6;

  using ReducedStress  = std::array<double, max_strain_components>;
  using ReducedTangent = std::array<std::array<double, max_strain_components>,
                                    max_strain_components>;

  /** The answer of a material point as the element needs it. */
  struct PointResponse
  {
    ReducedStress                 stress;  // Pa
    ReducedTangent                tangent; // Pa
    dealii::SymmetricTensor<2, 3> full_stress;
    double                        energy_density; // J/m^3
    MaterialHistory               history;
  };

  /**
   * Completes the displacement gradient du_i/dx_j of the plane with what the
   * formulation says of the third direction and asks the material.
   *
   * @param plane_gradient the gradient in the body's coordinates, rows i
   * @param hoop_strain    u_r/r, read when axisymmetric only
   *
   * Plane stress solves stress_zz = 0 for the strain across the thickness by
   * Newton's method and condenses the tangent.
   * @throws ComputationError when that does not converge.
   */
  template <int dim>
  PointResponse
  respond(const Formulation             formulation,
          const Material               &material,
          const dealii::Tensor<2, dim> &plane_gradient,
          const double                  hoop_strain,
          const MaterialHistory        &history_n);

  /**
   * What an area of the mesh counts: the thickness, 2 pi r, or 1.
   * @param thickness m, read in plane formulations only
   */
  template <int dim>
  double
  volume_factor(const Formulation         formulation,
                const dealii::Point<dim> &point,
                const double              thickness);
} // namespace Signorini

#endif
