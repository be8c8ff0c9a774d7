#ifndef signorini_material_material_h
#define signorini_material_material_h

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <memory>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace Signorini
{
  /** What a material point remembers between two steps. */
  using MaterialHistory = std::vector<double>;

  /** What a material answers to a deformation. */
  struct MaterialResponse
  {
    dealii::SymmetricTensor<2, 3> stress;         // Cauchy, Pa
    dealii::SymmetricTensor<4, 3> tangent;        // d stress / d strain, Pa
    double                        energy_density; // stored, J/m^3
    MaterialHistory               history;        // at the end of the step
  };

  /**
   * A constitutive law as a pure function: old history in, stress, tangent and
   * new history out. Nothing is stored here; the time step keeps the new
   * history only when the step is accepted.
   *
   * Laws are always written in three dimensions; plane stress, plane strain and
   * axial symmetry are the business of the formulation. The argument is the
   * displacement gradient du_i/dX_j rather than F = 1 + du/dX, because for
   * small strains the sum would cut off ten of its sixteen digits.
   */
  class Material
  {
  public:
    virtual ~Material() = default;

    virtual MaterialResponse
    respond(const dealii::Tensor<2, 3> &displacement_gradient,
            const MaterialHistory      &history_n) const = 0;

    /** Number of values in a MaterialHistory of this law. */
    virtual unsigned int
    n_history_values() const = 0;

    /** True if the tangent never changes and there is no history. */
    virtual bool
    is_linear() const = 0;

    /** Mass density, kg/m^3. */
    double
    density() const
    {
      return density_;
    }

  protected:
    explicit Material(const double density)
      : density_(density)
    {}

  private:
    double density_;
  };

  /** Declares a section of this name with the entries of all laws. */
  void
  declare_material_parameters(const std::string        &section,
                              dealii::ParameterHandler &prm);

  /**
   * Reads the section of this name.
   * @throws InputError for constants that no material can have.
   */
  std::unique_ptr<Material>
  create_material(const std::string &section, dealii::ParameterHandler &prm);
} // namespace Signorini

#endif
