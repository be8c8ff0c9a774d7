#ifndef signorini_contact_contact_target_h
#define signorini_contact_contact_target_h

#include <signorini/linear_algebra/types.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>
#include <deal.II/lac/full_matrix.h>

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace Signorini
{
  struct ContactState;

  /** Where all unknowns are at a time. A view: what it sees must outlive it. */
  struct Configuration
  {
    const DofVector    &displacement;      // m
    double              time;              // s
    const ContactState *contact = nullptr; // null: nothing happened yet
  };

  /** A point on the contactor, looking for its target. */
  template <int dim>
  struct ContactorPoint
  {
    dealii::Point<dim>     position; // x, m
    dealii::Tensor<1, dim> motion;   // x - x_n over the step, m

    // Out of the contactor's body; zero: unknown, every side is taken.
    dealii::Tensor<1, dim> normal;

    // An unknown of the contactor point itself: what contains it is no target.
    unsigned int unknown;

    // A node beside an open end of the target, by so little that strain or
    // rounding explains it, still meets the target; a point between nodes does
    // not, since it would make the area of contact larger.
    bool is_node = true;
  };

  /**
   * The point y of a target that is closest to a contactor point x, and how it
   * depends on the unknowns q of the target.
   */
  template <int dim>
  struct TargetPoint
  {
    double                                      gap;    // g = (x - y).n, m
    dealii::Tensor<1, dim>                      normal; // n, out of the target
    std::array<dealii::Tensor<1, dim>, dim - 1> tangents; // orthonormal
    dealii::Tensor<1, dim>                      motion;   // y - y_n, m

    /** dy/dq for each unknown q that carries the point. */
    std::vector<std::pair<unsigned int, dealii::Tensor<1, dim>>>
      supporting_dofs;

    /**
     * grad grad g over x and the unknowns of `supporting_dofs', in this order,
     * 1/m. Empty: zero.
     */
    dealii::FullMatrix<double> curvature;
  };

  /**
   * A point that comes less deep into a target on its way is not said to pass
   * it: paths are straight and surfaces are not, and both are known to
   * rounding only. Unit: m.
   * @param position of the point
   * @param way of point and target together within the step, m
   */
  template <int dim>
  double
  tunnelling_depth(const dealii::Point<dim> &position, const double way)
  {
    return 1e-6 * way + 1e-14 * position.norm();
  }

  /** A target in a configuration, ready to be asked for closest points. */
  template <int dim>
  class PlacedTarget
  {
  public:
    virtual ~PlacedTarget() = default;

    /** None if the target is out of reach. */
    virtual std::optional<TargetPoint<dim>>
    closest(const ContactorPoint<dim> &point) const = 0;

    /**
     * Where a point that is outside at both ends of the step goes through the
     * target in between, deeper than tunnelling_depth(): the outward normal of
     * the target where the point went in, as it is now; none if it does not.
     * What comes out on the same side has grazed a curved surface, not passed
     * it: that is for the caller to tell. Positions are those of the start and
     * the end; the point and the target move evenly.
     * @param start_gap m, infinite if the target was out of reach
     * @param unknown   of the point itself: what contains it is not passed
     */
    virtual std::optional<dealii::Tensor<1, dim>>
    passed_side(const dealii::Point<dim> &start,
                const dealii::Point<dim> &end,
                const double              start_gap,
                const unsigned int        unknown) const = 0;

    /** Where the interpolation of the surface changes: its nodes, m. */
    virtual std::vector<dealii::Point<dim>>
    joints() const
    {
      return {};
    }
  };

  /** The side of a contact pair that is interpolated. */
  template <int dim>
  class ContactTarget
  {
  public:
    virtual ~ContactTarget() = default;

    /** The name that follows `on' in the .prm. */
    virtual std::string
    name() const = 0;

    /** True if gaps are linear in the unknowns. */
    virtual bool
    is_flat() const = 0;

    /** The unknowns that a contact may push. */
    virtual std::vector<unsigned int>
    unknowns() const = 0;

    /** The target now, knowing where it was at the start of the step. */
    virtual std::unique_ptr<PlacedTarget<dim>>
    place(const Configuration &now, const Configuration &before) const = 0;
  };
} // namespace Signorini

#endif
