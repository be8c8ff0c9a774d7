#ifndef signorini_solid_supports_h
#define signorini_solid_supports_h

#include <signorini/input/space_time_function.h>
#include <signorini/linear_algebra/types.h>
#include <signorini/solid/body.h>
#include <signorini/solid/displacement_history.h>
#include <signorini/solid/dof_map.h>

#include <memory>
#include <set>
#include <string>
#include <vector>

namespace Signorini
{
  /** The run from which a submodel takes the motion of its boundaries. */
  struct GlobalRun
  {
    std::string       folder; // of its results; empty: none
    TimeInterpolation interpolation = TimeInterpolation::linear;
    double            end_time      = 0.; // of the submodel, s
  };

  /** A node that cannot move along a direction, that of its boundary. */
  template <int dim>
  struct SlidingNode
  {
    Node<dim>              node;
    dealii::Tensor<1, dim> normal; // unit vector
  };

  /**
   * The unknowns of a body whose motion is given: fixed ones and those that
   * follow a function of place and time. Nodes that slide along a
   * boundary, and the boundaries at which waves leave the body.
   */
  template <int dim>
  class Supports
  {
  public:
    /** Declares the section `Supports`. */
    static void
    declare_parameters(dealii::ParameterHandler &prm);

    /** Reads the section `Supports` of this body. @throws InputError. */
    Supports(const Body<dim>          &body,
             const Constants          &constants,
             const GlobalRun          &global_run,
             dealii::ParameterHandler &prm);

    /** Marks the unknowns that are given. */
    void
    mark(DofMap &dof_map) const;

    /** Writes the given displacements (m) at this time into a vector. */
    void
    set_displacements(const double time, DofVector &displacement) const;

    /**
     * Writes the velocities and accelerations of the given motion, by
     * motion_rates() over a hundredth of the step size. Newmark's formulas
     * would let them ring, since nothing follows from these values.
     */
    void
    set_rates(const double time,
              const double step_size,
              DofVector   &velocity,
              DofVector   &acceleration) const;

    /** True if every node stays where it is for all times. */
    bool
    are_fixed() const;

    /** Nodes that slide along their boundary. */
    const std::vector<SlidingNode<dim>> &
    sliding_nodes() const
    {
      return sliding_nodes_;
    }

    /** Boundaries on dashpots, see add_absorbing_boundaries(). */
    const std::set<dealii::types::boundary_id> &
    absorbing_boundaries() const
    {
      return absorbing_boundaries_;
    }

  private:
    struct Prescribed
    {
      unsigned int                  dof;
      dealii::Point<dim>            point;
      const SpaceTimeFunction<dim> *motion; // none: fixed
    };

    void
    add(const std::vector<Node<dim>> &nodes,
        const unsigned int            component,
        const SpaceTimeFunction<dim> *motion);

    // Reads `From global run'.
    void
    follow_global_run(const Body<dim>   &body,
                      const std::string &boundaries,
                      const GlobalRun   &global_run);

    // Displacement, velocity or acceleration of the global run.
    void
    set_global(const double       time,
               const unsigned int derivative,
               DofVector         &vector) const;

    // Reads `Sliding'.
    void
    add_sliding_nodes(const Body<dim> &body, const std::string &boundary);

    std::vector<Prescribed>                   prescribed_;
    std::vector<Node<dim>>                    global_nodes_; // that follow it
    std::unique_ptr<DisplacementHistory<dim>> global_run_;
    std::vector<SlidingNode<dim>>             sliding_nodes_;
    std::vector<std::unique_ptr<SpaceTimeFunction<dim>>> motions_;
    std::set<dealii::types::boundary_id>                 absorbing_boundaries_;
  };
} // namespace Signorini

#endif
