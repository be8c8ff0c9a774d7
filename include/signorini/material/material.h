#ifndef signorini_material_material_h
#define signorini_material_material_h

#include <signorini/input/entry_condition.h>
#include <signorini/input/input_error.h>

#include <deal.II/base/array_view.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <memory>
#include <optional>
#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace Signorini
{
  /** How strains are measured, in all bodies alike. */
  enum class Kinematics
  {
    small_strain, // products of displacement gradients are neglected
    finite_strain
  };

  /** The step that leads to a deformation, as a law sees it. */
  struct MaterialStep
  {
    // s, read by laws that depend on the rate. 0: at once, so that nothing
    // flows; the stress is that of a body at rest.
    double size = 0.;

    // At the end of the step, in the unit of its reference. None: as at its
    // start.
    std::optional<double> temperature = std::nullopt;
  };

  /** What a law is asked about. */
  struct MaterialPoint
  {
    dealii::Tensor<2, 3>            gradient; // du_i/dX_j at the end, 1
    MaterialStep                    step;
    dealii::ArrayView<const double> history_n; // of the start of the step
  };

  /** What a material answers to a deformation. */
  struct MaterialResponse
  {
    // Kirchhoff stress J sigma, in space; for small strains sigma. Pa
    dealii::SymmetricTensor<2, 3> stress;

    // Symmetric. Finite strain: the Lie derivative of the stress,
    //   d tau/dt - l tau - tau l^T = tangent : d,   l = d + w = dF/dt F^-1;
    // small strain: d stress / d strain. Pa
    dealii::SymmetricTensor<4, 3> tangent;

    // Stored elastically, per volume before the deformation. J/m^3
    double energy_density;

    // Integral of the stress over the plastic strain since the start, J/m^3.
    // Together with the energy this is the work of the stress.
    double plastic_work_density;

    // Work of the stress against thermal strain since the start, J/m^3; it
    // goes into the body.
    double heating_density = 0.;
  };

  /**
   * A deformation for which a law has no answer. The message gives the value
   * found; the caller adds where.
   */
  class MaterialFailure : public ComputationError
  {
  public:
    using ComputationError::ComputationError;
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

    /**
     * Allocates nothing.
     *
     * @param point   with n_history_values() numbers of the start of the step;
     *                without a past they are zeros
     * @param history gets those of its end; must not overlap the old ones
     * @throws MaterialFailure when there is no answer.
     */
    virtual MaterialResponse
    respond(const MaterialPoint            &point,
            const dealii::ArrayView<double> history) const = 0;

    /**
     * The same for a sheet: the strain across it, entry zz of the gradient, is
     * the one without stress zz. The other entries with a z must vanish.
     *
     * Stress zz is zero to 1e-12 of the stress. The tangent is that of
     * respond(); it still has to be condensed.
     *
     * @param point comes with a guess of zz, and gets its value
     * @throws MaterialFailure also when the strain is not found.
     */
    virtual MaterialResponse
    respond_in_plane_stress(MaterialPoint                  &point,
                            const dealii::ArrayView<double> history) const;

    /** Numbers that a point remembers between two steps. */
    virtual unsigned int
    n_history_values() const = 0;

    /** True if the tangent never changes and there is no history. */
    virtual bool
    is_linear() const = 0;

    /** Can it flow plastically, without change of volume? */
    virtual bool
    flows() const
    {
      return false;
    }

    /** Does it have a thermal strain? */
    virtual bool
    expands() const
    {
      return false;
    }

    /**
     * Integral of sqrt(2/3) |rate of plastic strain|, from a history; zero for
     * elastic laws. The history may be followed by values of others.
     */
    virtual double
    equivalent_plastic_strain(
      const dealii::ArrayView<const double> /*history*/) const
    {
      return 0.;
    }

    Kinematics
    kinematics() const
    {
      return kinematics_;
    }

    /** Mass density before the deformation, kg/m^3. */
    double
    density() const
    {
      return density_;
    }

  protected:
    Material(const Kinematics kinematics, const double density)
      : kinematics_(kinematics)
      , density_(density)
    {}

  private:
    Kinematics kinematics_;
    double     density_;
  };

  /** Declares a section of this name with the entries of all laws. */
  void
  declare_material_parameters(const std::string        &section,
                              dealii::ParameterHandler &prm);

  /** Which entries and subsections are read under which choice. */
  EntryConditions
  material_conditions();

  /**
   * Reads the section of this name.
   * @param base_directory to which names of files are relative
   * @throws InputError for constants that no material can have.
   */
  std::unique_ptr<Material>
  create_material(const std::string        &section,
                  const Kinematics          kinematics,
                  const std::string        &base_directory,
                  dealii::ParameterHandler &prm);
} // namespace Signorini

#endif
