#ifndef signorini_contact_rigid_surface_h
#define signorini_contact_rigid_surface_h

#include <signorini/input/entry_condition.h>

#include <deal.II/base/point.h>
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
  /** What a surface says of a point near it. */
  template <int dim>
  struct SurfacePoint
  {
    double                          gap;       // g, m; negative inside
    dealii::Tensor<1, dim>          normal;    // grad g, out of the target
    dealii::SymmetricTensor<2, dim> curvature; // grad grad g, 1/m
  };

  /** The surface of a rigid target in the position in which it is described. */
  template <int dim>
  class RigidSurface
  {
  public:
    virtual ~RigidSurface() = default;

    /** Gap, normal and curvature at a point. */
    virtual SurfacePoint<dim>
    closest(const dealii::Point<dim> &point) const = 0;

    /** True if normals are the same everywhere. */
    virtual bool
    is_flat() const = 0;

    /**
     * Points along it, for pictures; the last one is joined to the first if
     * they are equal. Empty: it is not drawn.
     */
    virtual std::vector<dealii::Point<dim>>
    outline() const
    {
      return {};
    }

    /** A length that is typical of it, m; 1 if it has none. */
    virtual double
    reference_length() const
    {
      return 1.;
    }
  };

  /** Declares `Shape` and the subsection of each shape. */
  template <int dim>
  void
  declare_rigid_surface_parameters(dealii::ParameterHandler &prm);

  /** Which entries and subsections are read under which choice. */
  template <int dim>
  EntryConditions
  rigid_surface_conditions();

  /**
   * Reads them.
   * @param section   the path of the current section, for messages
   * @param directory where relative paths of files start; empty: the current
   * one
   * @throws InputError.
   */
  template <int dim>
  std::unique_ptr<RigidSurface<dim>>
  create_rigid_surface(dealii::ParameterHandler &prm,
                       const std::string        &section,
                       const std::string        &directory = "");
} // namespace Signorini

#endif
