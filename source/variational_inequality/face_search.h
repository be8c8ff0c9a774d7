#ifndef signorini_variational_inequality_face_search_h
#define signorini_variational_inequality_face_search_h

#include <signorini/variational_inequality/bound_constrained_qp.h>
#include <signorini/variational_inequality/interface_types.h>
#include <signorini/variational_inequality/semidefinite_cholesky.h>

#include <limits>
#include <set>
#include <vector>

namespace Signorini
{
  /**
   * The state of solve_bound_constrained_qp(): a point x >= 0, the residual
   * d - W x, and the faces seen so far. Used once.
   */
  class FaceSearch
  {
  public:
    FaceSearch(const InterfaceMatrix     &W,
               const std::vector<double> &d,
               const std::vector<double> &start,
               const double               resolution);

    BoundConstrainedSolution
    run();

  private:
    static constexpr double epsilon = std::numeric_limits<double>::epsilon();

    // Block principal pivoting [JudicePires1994]: solves on a face without
    // bounds and exchanges all wrong unknowns at once, until none is left.
    // Mostly there in a few faces, but nothing forces it to end: false if it
    // makes no progress or a face is singular. Then x is the best point seen,
    // cut off at the bounds.
    bool
    pivot_blocks();

    // Falls to the minimum on the face of the present x or on one of its
    // own faces, unless too many were tried. False if the objective falls
    // without end.
    bool
    minimise_on_face();

    // Projected gradient step from the minimum of a face.
    void
    release(const std::vector<unsigned int> &violated);

    void
    projected_search(const std::vector<double> &p);

    // False if no bound is met.
    bool
    step_to_first_bound(const std::vector<double> &direction,
                        const double               longest_step);

    void
    add_and_project(const std::vector<double> &p, const double factor);

    // Empty if the objective has a minimum on the face.
    std::vector<double>
    descent_without_curvature(const SemidefiniteCholesky &factor,
                              const std::vector<double>  &p) const;

    void
    collect_free()
    {
      free.clear();
      for (unsigned int j = 0; j < x.size(); ++j)
        if (x[j] > 0.)
          free.push_back(j);
    }

    // r = d - W x from scratch, and the size of the numbers that cancel.
    void
    update_residual();

    std::vector<double>
    residual_on_face() const
    {
      std::vector<double> values;
      values.reserve(free.size());
      for (const unsigned int j : free)
        values.push_back(residual[j]);
      return values;
    }

    // W_FF p.
    std::vector<double>
    multiply_on_face(const std::vector<double> &p) const;

    // Does the residual vanish on the face? Not if W is not symmetric or
    // anything is not a number.
    bool
    is_minimum_on_face() const;

    // Bounds x_j = 0 where the objective falls as x_j grows.
    std::vector<unsigned int>
    violated_bounds() const;

    // What counts as zero in entry j of the residual.
    double
    tolerance(const unsigned int j, const double additional = 0.) const
    {
      return widening * (epsilon * (magnitude[j] + additional) + resolution);
    }

    bool
    widen_tolerance();

    BoundConstrainedSolution
    finish(const QPOutcome outcome, const std::vector<unsigned int> &violated);

    const InterfaceMatrix     &W;
    const std::vector<double> &d;
    const double               resolution;

    std::vector<double>         x;
    std::vector<double>         residual;
    std::vector<double>         magnitude;
    std::vector<unsigned int>   free;
    std::vector<unsigned int>   growing;
    std::set<std::vector<bool>> faces_seen;
    double                      widening;
    double                      widest;
    unsigned int                most_faces;
    unsigned int                n_faces = 0;
  };
} // namespace Signorini

#endif
