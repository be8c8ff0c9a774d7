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
   * reduced vectors: plane stress xx, yy, xy; plane strain and axisymmetric
   * also zz, across the plane or around the axis, last, where plane strain
   * without mean dilatation leaves it out; three-dimensional xx, yy, zz, xy,
   * yz, xz. Shear strains are engineering strains.
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
    ReducedStress  stress;  // Kirchhoff stress, see MaterialResponse; Pa
    ReducedTangent tangent; // symmetric, Pa

    dealii::SymmetricTensor<2, 3> cauchy_stress; // all components, Pa

    double energy_density;       // J/m^3
    double plastic_work_density; // J/m^3
    double heating_density = 0.; // J/m^3
  };

  /**
   * Numbers that a material point remembers between two steps: those of the
   * material, and in plane stress behind them the change of volume of a
   * non-linear law, with which the next search for the thickness starts. Zeros
   * at first.
   */
  unsigned int
  n_history_values(const Formulation formulation, const Material &material);

  /**
   * Completes the displacement gradient du_i/dX_j of the plane with what the
   * formulation says of the third direction and asks the material. For both
   * kinematics; the material knows its own.
   *
   * @param plane_gradient the gradient in the body's coordinates, rows i
   * @param thickness_strain du_z/dZ in plane strain, where mean dilatation may
   *                       ask for it, and u_r/R around an axis; else not read
   * @param step           see Material::respond()
   * @param history_n      n_history_values() numbers, of the start of the step
   * @param history        gets those of its end
   *
   * Plane stress solves stress_zz = 0 for the strain across the thickness by
   * Newton's method and condenses the tangent. The change of the thickness
   * needs no other care: the Kirchhoff stress is meant per volume before the
   * deformation.
   * @throws MaterialFailure when that does not converge, or from the material.
   */
  template <int dim>
  PointResponse
  respond(const Formulation                     formulation,
          const Material                       &material,
          const dealii::Tensor<2, dim>         &plane_gradient,
          const double                          thickness_strain,
          const MaterialStep                   &step,
          const dealii::ArrayView<const double> history_n,
          const dealii::ArrayView<double>       history);

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
