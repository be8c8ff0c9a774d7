#ifndef signorini_run_overlap_watch_h
#define signorini_run_overlap_watch_h

#include <signorini/contact/overlap.h>
#include <signorini/linear_algebra/types.h>
#include <signorini/run/problem.h>

#include <optional>
#include <string>
#include <vector>

namespace Signorini
{
  /**
   * Looks for bodies of a pair that lie in each other although no candidate
   * sees it: a target between two nodes, bodies that cross, or one that went
   * through the other. Measured without the constraint.
   *
   * Where nothing presses nearby, an overlap is refused that is deeper than the
   * sagitta of curved surfaces, a thousandth of the element, what the
   * constraint itself leaves (penalty), and what was there at t = 0 on purpose
   * (press fit, adjust). Where contact forces act, one of two elements or
   * half the radius of a rigid target.
   */
  template <int dim>
  class OverlapWatch
  {
  public:
    /**
     * The problem must outlive the object.
     * @throws InputError if there is an overlap at t = 0 that is not on
     * purpose.
     */
    explicit OverlapWatch(const Problem<dim> &problem);

    /**
     * Has something moved by more than a quarter of the shortest piece of a
     * contactor since it was last looked? So nothing passes in between.
     */
    bool
    is_due(const Configuration &configuration) const;

    /**
     * @param configuration with the state of its contacts
     * @throws ComputationError with the place, the names and the remedy.
     */
    void
    refuse(const Configuration &configuration);

    /** A warning if somewhere between nodes that carry forces the two sides lay
     * in each other by more than a 20th of an element, or empty. */
    std::string
    summary() const;

  private:
    // A deformable target: its body and its boundary.
    struct Target
    {
      unsigned int          body;
      ContactorSurface<dim> surface;
    };

    // The worst that is not allowed, by pair.
    std::vector<std::optional<Overlap<dim>>>
    find(const Configuration       &configuration,
         const std::vector<double> &normal_forces,
         const std::vector<double> &allowed);

    void
    note_pressed(const unsigned int  pair,
                 const Overlap<dim> &overlap,
                 const double        allowed,
                 const double        time);

    std::string
    in_words(const ContactPair<dim> &pair,
             const Overlap<dim>     &overlap,
             const double            time) const;

    void
    remember(const Configuration &configuration);

    struct PressedOverlap
    {
      unsigned int       pair;
      double             share; // of an element, 1
      dealii::Point<dim> place; // m
      double             time;  // s
    };

    const Problem<dim>                &problem_;
    std::optional<PressedOverlap>      deepest_;
    std::vector<std::optional<Target>> targets_; // none: rigid
    std::vector<double>                allowed_; // on purpose, m

    // Where all were when it was last looked.
    DofVector                        displacement_;
    std::vector<RigidPlacement<dim>> placements_;
    const double                     shortest_piece_; // m
  };
} // namespace Signorini

#endif
