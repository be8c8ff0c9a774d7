#include "face_search.h"

#include <signorini/variational_inequality/interface_types.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  FaceSearch::FaceSearch(const InterfaceMatrix     &W,
                         const std::vector<double> &d,
                         const std::vector<double> &start,
                         const double               resolution)
    : W(W)
    , d(d)
    , resolution(resolution)
    , x(start)
    , residual(d.size())
    , magnitude(d.size())
    , widening(16. + 2. * d.size())
    , widest(std::max(1e-10 / epsilon, widening))
    , most_faces(100 + 20 * d.size())
  {
    for (double &entry : x)
      entry = entry > 0. ? entry : 0.;
    collect_free();
    update_residual();
  }



  BoundConstrainedSolution
  FaceSearch::run()
  {
    if (pivot_blocks() && is_minimum_on_face())
      return finish(QPOutcome::solved, {});

    std::vector<unsigned int> violated;
    while (n_faces <= most_faces)
      {
        if (!minimise_on_face())
          {
            // Constraints that contradict each other by rounding only are
            // redundant, not contradictory.
            if (widen_tolerance())
              continue;
            return finish(QPOutcome::unbounded, {});
          }
        if (!is_minimum_on_face())
          break;
        violated = violated_bounds();
        if (violated.empty())
          return finish(QPOutcome::solved, {});

        std::vector<bool> face(x.size());
        for (unsigned int j = 0; j < x.size(); ++j)
          face[j] = x[j] > 0.;
        if (!faces_seen.insert(face).second)
          {
            if (widen_tolerance())
              continue;
            break;
          }
        release(violated);
      }
    return finish(QPOutcome::stalled, violated);
  }



  bool
  FaceSearch::pivot_blocks()
  {
    std::vector<double> best   = x;
    std::size_t         fewest = std::numeric_limits<std::size_t>::max();
    collect_free();
    std::vector<unsigned int> face = free.empty() ? violated_bounds() : free;
    for (unsigned int attempts = 3; attempts > 0;)
      {
        // 1. Stationary on the face, with one step of iterative refinement.
        std::fill(x.begin(), x.end(), 0.);
        free = face;
        ++n_faces;
        const SemidefiniteCholesky factor(W, face);
        if (factor.rank() < factor.size())
          break;
        for (unsigned int step = 0; step < 2; ++step)
          {
            update_residual();
            const std::vector<double> p = factor.solve(residual_on_face());
            for (unsigned int i = 0; i < face.size(); ++i)
              x[face[i]] += p[i];
          }
        update_residual();

        // 2. Negative ones leave, violated bounds are released.
        const std::vector<unsigned int> violated = violated_bounds();
        collect_free();
        const std::size_t n_wrong = face.size() - free.size() + violated.size();
        if (n_wrong == 0)
          return true;
        face = free;
        face.insert(face.end(), violated.begin(), violated.end());
        attempts = n_wrong < fewest ? 3 : attempts - 1;
        if (n_wrong < fewest)
          {
            fewest = n_wrong;
            best   = x;
          }
      }

    x = best;
    for (double &entry : x)
      entry = entry > 0. ? entry : 0.;
    collect_free();
    update_residual();
    return false;
  }



  bool
  FaceSearch::minimise_on_face()
  {
    while (n_faces <= most_faces)
      {
        collect_free();
        if (free.empty())
          return true;
        ++n_faces;
        const SemidefiniteCholesky factor(W, free);
        const std::vector<double>  p = factor.solve(residual_on_face());
        const std::vector<double>  z = descent_without_curvature(factor, p);

        bool inside = true;
        for (unsigned int i = 0; i < free.size(); ++i)
          inside = inside && x[free[i]] + p[i] >= 0.;

        // Every branch that does not return leaves the face for a smaller
        // one, which ends this loop.
        if (!z.empty())
          {
            if (!step_to_first_bound(z, std::numeric_limits<double>::max()))
              return false;
          }
        else if (inside)
          {
            // The second step is iterative refinement.
            add_and_project(p, 1.);
            update_residual();
            add_and_project(factor.solve(residual_on_face()), 1.);
            update_residual();
            return true;
          }
        else
          projected_search(p);
        update_residual();
      }
    return true;
  }



  void
  FaceSearch::release(const std::vector<unsigned int> &violated)
  {
    // On the face the residual vanishes, and all other bounds hold: the
    // projected gradient, scaled by the diagonal, has these entries only,
    // and no bound is ahead.
    std::vector<double> step;
    double              slope = 0., curvature = 0., largest_curvature = 0.;
    for (const unsigned int j : violated)
      {
        const double scale = W(j, j) > 0. ? W(j, j) : 1.;
        step.push_back(residual[j] / scale);
        slope += step.back() * residual[j];
        largest_curvature += step.back() * step.back() * scale;
      }
    free                         = violated;
    const std::vector<double> Wg = multiply_on_face(step);
    for (unsigned int i = 0; i < step.size(); ++i)
      curvature += step[i] * Wg[i];
    // Where there is hardly any curvature a moderate step will do, for the
    // face decides next; a huge one would drown the residual in rounding.
    curvature = std::max(curvature, 1e-3 * largest_curvature);
    add_and_project(step, slope / curvature);
    collect_free();
    update_residual();
  }



  void
  FaceSearch::projected_search(const std::vector<double> &p)
  {
    double first_bound = 1.;
    for (unsigned int i = 0; i < free.size(); ++i)
      if (x[free[i]] + p[i] < 0.)
        first_bound = std::min(first_bound, -x[free[i]] / p[i]);

    const std::vector<double> start = x;
    std::vector<double>       step(free.size());
    for (double factor = 1.; factor > std::max(first_bound, 0.05);
         factor *= 0.5)
      {
        add_and_project(p, factor);
        for (unsigned int i = 0; i < free.size(); ++i)
          step[i] = x[free[i]] - start[free[i]];
        const std::vector<double> Ws    = multiply_on_face(step);
        double                    slope = 0., curvature = 0.;
        for (unsigned int i = 0; i < free.size(); ++i)
          {
            slope += step[i] * residual[free[i]];
            curvature += step[i] * Ws[i];
          }
        // Sufficient decrease.
        if (slope > 0. && slope - 0.5 * curvature >= 0.1 * slope)
          return;
        x = start;
      }
    // Up to the first bound the objective falls along p.
    step_to_first_bound(p, 1.);
  }



  bool
  FaceSearch::step_to_first_bound(const std::vector<double> &direction,
                                  const double               longest_step)
  {
    double factor   = longest_step;
    int    blocking = -1;
    growing.clear();
    for (unsigned int i = 0; i < free.size(); ++i)
      {
        if (direction[i] > 0.)
          growing.push_back(free[i]);
        else if (direction[i] < 0. && x[free[i]] <= -factor * direction[i])
          {
            factor   = -x[free[i]] / direction[i];
            blocking = i;
          }
      }
    if (blocking < 0)
      return false;
    add_and_project(direction, factor);
    x[free[blocking]] = 0.;
    return true;
  }



  void
  FaceSearch::add_and_project(const std::vector<double> &p, const double factor)
  {
    for (unsigned int i = 0; i < free.size(); ++i)
      {
        // What is left of a sum that cancels is rounding. Kept, it would count
        // as positive, with a residual as large as itself. If it was more, its
        // bound is violated, and it comes back.
        const double old = x[free[i]];
        const double sum = old + factor * p[i];
        x[free[i]]       = sum > 1e-10 * old ? sum : 0.;
      }
  }



  std::vector<double>
  FaceSearch::descent_without_curvature(const SemidefiniteCholesky &factor,
                                        const std::vector<double>  &p) const
  {
    if (factor.rank() == factor.size())
      return {};
    std::vector<double> remainder(free.size(), 0.);
    bool                consistent = true;
    for (const unsigned int i : factor.dependent())
      {
        double sum = residual[free[i]], size = 0.;
        for (unsigned int k = 0; k < free.size(); ++k)
          {
            const double term = W(free[i], free[k]) * p[k];
            sum -= term;
            size += std::abs(term);
          }
        if (std::abs(sum) <= tolerance(free[i], size))
          continue;
        remainder[i] = sum;
        consistent   = false;
      }
    return consistent ? std::vector<double>() :
                        factor.null_direction(remainder);
  }



  void
  FaceSearch::update_residual()
  {
    for (unsigned int j = 0; j < x.size(); ++j)
      {
        double sum = 0., size = 0.;
        for (const unsigned int k : free)
          {
            const double term = W(j, k) * x[k];
            sum += term;
            size += std::abs(term);
          }
        residual[j]  = d[j] - sum;
        magnitude[j] = std::abs(d[j]) + size;
      }
  }



  std::vector<double>
  FaceSearch::multiply_on_face(const std::vector<double> &p) const
  {
    std::vector<double> product(free.size(), 0.);
    for (unsigned int i = 0; i < free.size(); ++i)
      for (unsigned int k = 0; k < free.size(); ++k)
        product[i] += W(free[i], free[k]) * p[k];
    return product;
  }



  bool
  FaceSearch::is_minimum_on_face() const
  {
    for (const unsigned int j : free)
      if (!(std::abs(residual[j]) <=
            widest * (epsilon * magnitude[j] + resolution)))
        return false;
    return true;
  }



  std::vector<unsigned int>
  FaceSearch::violated_bounds() const
  {
    std::vector<unsigned int> violated;
    for (unsigned int j = 0; j < x.size(); ++j)
      if (x[j] == 0. && !(residual[j] <= tolerance(j)))
        violated.push_back(j);
    return violated;
  }



  bool
  FaceSearch::widen_tolerance()
  {
    if (widening >= widest)
      return false;
    widening = std::min(8. * widening, widest);
    faces_seen.clear();
    return true;
  }



  BoundConstrainedSolution
  FaceSearch::finish(const QPOutcome                  outcome,
                     const std::vector<unsigned int> &violated)
  {
    BoundConstrainedSolution solution;
    solution.outcome      = outcome;
    solution.n_iterations = n_faces;
    if (outcome == QPOutcome::unbounded)
      solution.suspects = growing;
    else if (outcome == QPOutcome::stalled)
      {
        collect_free();
        solution.suspects = free;
        solution.suspects.insert(solution.suspects.end(),
                                 violated.begin(),
                                 violated.end());
        std::sort(solution.suspects.begin(), solution.suspects.end());
      }
    solution.x = std::move(x);
    return solution;
  }
} // namespace Signorini
