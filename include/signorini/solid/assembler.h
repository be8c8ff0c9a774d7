#ifndef signorini_solid_assembler_h
#define signorini_solid_assembler_h

#include <signorini/linear_algebra/types.h>
#include <signorini/solid/body.h>

#include <deal.II/base/array_view.h>
#include <deal.II/lac/affine_constraints.h>

#include <optional>
#include <vector>

namespace Signorini
{
  /** What the bodies answer to a displacement. */
  struct SolidResponse
  {
    DofVector           internal_force;     // of all unknowns, N
    DofVector           mean_force;         // over the step, N, if wanted
    std::vector<double> history;            // of the points of all bodies
    double              stored_energy = 0.; // J
    double              plastic_work  = 0.; // since the start, J
    double              heating       = 0.; // since the start, J
  };

  /** A step of the bodies to a displacement. */
  struct SolidStep
  {
    const DofVector &displacement;             // of all unknowns, m
    double           size           = 0.;      // s
    const DofVector *displacement_n = nullptr; // at its start, m

    // At its end, s. None: temperatures are those of its start.
    std::optional<double> time = std::nullopt;
  };

  /** Numbers that the points of a body remember between two steps. */
  template <int dim>
  unsigned int
  n_history_values(const Body<dim> &body);

  /**
   * Adds the internal forces of a body at a displacement, its energy and, when
   * given, its tangent stiffness,
   *   f_a += int B_a^T stress dV,
   *   K_ab += factor (int B_a^T D B_b dV + geometric part).
   *
   * @param constraints  hanging nodes, in the counting of all unknowns; their
   *                     rows and columns are condensed
   * @param step         its size is for laws that depend on the rate. With a
   *                     start the mean force over it is added, too, that does
   * as much work as the energy of the body takes up; the tangent is then twice
   * the derivative of that (see CellResponse)
   * @param history_n    of the points of this body
   * @param history      gets those of the end of the step
   * @throws MaterialFailure with the cell where a law has no answer.
   */
  template <int dim>
  void
  add_response(const Body<dim>                         &body,
               const dealii::AffineConstraints<double> &constraints,
               const SolidStep                         &step,
               const dealii::ArrayView<const double>    history_n,
               const dealii::ArrayView<double>          history,
               SolidResponse                           &response,
               DofMatrix                               *stiffness = nullptr,
               const double                             factor    = 1.);

  /** What is at the points of all cells of a body, cell after cell. */
  struct PointValues
  {
    std::vector<dealii::SymmetricTensor<2, 3>> stresses;        // Cauchy, Pa
    std::vector<double>                        plastic_strains; // equivalent, 1
  };

  /**
   * Stresses and plastic strains of a body at rest in this displacement.
   * @param history of the points of the body, that led to the displacement
   */
  template <int dim>
  PointValues
  point_values(const Body<dim>                      &body,
               const DofVector                      &displacement,
               const dealii::ArrayView<const double> history);
} // namespace Signorini

#endif
