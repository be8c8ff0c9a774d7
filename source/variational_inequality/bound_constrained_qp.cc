#include <signorini/variational_inequality/bound_constrained_qp.h>

#include "face_search.h"

namespace Signorini
{
  using namespace dealii;

  BoundConstrainedSolution
  solve_bound_constrained_qp(const InterfaceMatrix     &W,
                             const std::vector<double> &d,
                             const std::vector<double> &start,
                             const double               resolution)
  {
    AssertDimension(W.m(), d.size());
    AssertDimension(W.n(), d.size());
    AssertDimension(start.size(), d.size());
    Assert(resolution >= 0., ExcMessage("A resolution is not negative."));
    return FaceSearch(W, d, start, resolution).run();
  }
} // namespace Signorini
