#include <signorini/contact/deforming_target.h>
#include <signorini/input/instantiate.h>

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // The longest edge of the pieces of a surface in its reference position.
    template <int dim>
    double
    longest_edge(const ContactorSurface<dim> &surface)
    {
      using Edges = std::vector<std::pair<unsigned int, unsigned int>>;
      const Edges edges =
        dim == 2 ? Edges{{0, 1}} : Edges{{0, 1}, {1, 3}, {3, 2}, {2, 0}};
      double longest = 0.;
      for (const auto &piece : surface.faces)
        for (const auto &[a, b] : edges)
          longest = std::max(longest,
                             surface.nodes[piece[a]].point.distance(
                               surface.nodes[piece[b]].point));
      return longest;
    }
  } // namespace



  template <int dim>
  DeformingTarget<dim>::DeformingTarget(
    const Body<dim>            &body,
    const std::string          &boundary,
    const SurfaceInterpolation &interpolation)
    : name_(body.name() + "." + boundary)
    , surface_(contactor_surface(body, boundary))
  {
    const double longest = longest_edge(surface_);
    reach_               = interpolation.reach * longest;
    penetration_limit_   = interpolation.depth * longest;
  }



  template <int dim>
  std::string
  DeformingTarget<dim>::name() const
  {
    return name_;
  }



  template <int dim>
  bool
  DeformingTarget<dim>::is_flat() const
  {
    return false;
  }



  template <int dim>
  std::vector<unsigned int>
  DeformingTarget<dim>::unknowns() const
  {
    std::vector<unsigned int> list;
    for (const auto &node : surface_.nodes)
      list.insert(list.end(), node.dofs.begin(), node.dofs.end());
    return list;
  }



#define INSTANTIATE(dim) template class DeformingTarget<dim>;
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
