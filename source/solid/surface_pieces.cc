#include <signorini/input/instantiate.h>
#include <signorini/solid/surface_pieces.h>

#include <deal.II/boost_adaptors/bounding_box.h>

#include <algorithm>
#include <limits>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  SurfacePieces<dim>::SurfacePieces(std::vector<Piece> pieces)
    : pieces_(std::move(pieces))
  {
    std::vector<std::pair<BoundingBox<dim>, unsigned int>> boxes;
    for (unsigned int i = 0; i < pieces_.size(); ++i)
      boxes.emplace_back(BoundingBox<dim>(pieces_[i]), i);
    tree_ = pack_rtree(boxes);
  }



  template <int dim>
  std::pair<unsigned int, double>
  SurfacePieces<dim>::nearest(const Point<dim> &point) const
  {
    namespace index = boost::geometry::index;
    std::pair<unsigned int, double> best(
      0, std::numeric_limits<double>::infinity());
    // Box by box, until even the next box is farther away.
    for (auto box = tree_.qbegin(index::nearest(point, pieces_.size()));
         box != tree_.qend();
         ++box)
      {
        if (boost::geometry::distance(point, box->first) > best.second)
          break;
        const double found = distance(point, pieces_[box->second]);
        if (found < best.second)
          best = {box->second, found};
      }
    return best;
  }



  template <int dim>
  double
  SurfacePieces<dim>::length(const unsigned int piece) const
  {
    using Edges = std::vector<std::pair<unsigned int, unsigned int>>;
    const Edges edges =
      dim == 2 ? Edges{{0, 1}} : Edges{{0, 1}, {1, 3}, {3, 2}, {2, 0}};
    double longest = 0.;
    for (const auto &[a, b] : edges)
      longest =
        std::max(longest, pieces_[piece][a].distance(pieces_[piece][b]));
    return longest;
  }



  template <int dim>
  double
  SurfacePieces<dim>::distance(const Point<dim> &point,
                               const Piece      &piece) const
  {
    // The place on the piece by projections on its two directions in turn:
    // exact for straight pieces and rectangles, near enough for others.
    const auto between =
      [&](const unsigned int a, const unsigned int b, const double share) {
        return Point<dim>(piece[a] + share * (piece[b] - piece[a]));
      };
    double         at[2] = {0.5, 0.5};
    Tensor<1, dim> rest;
    for (unsigned int i = 0; i < (dim == 2 ? 1 : 4); ++i)
      {
        const bool           is_second = i % 2 == 1;
        const Point<dim>     start     = dim == 2  ? piece[0] :
                                         is_second ? between(0, 1, at[0]) :
                                                     between(0, 2, at[1]);
        const Point<dim>     end       = dim == 2  ? piece[1] :
                                         is_second ? between(2, 3, at[0]) :
                                                     between(1, 3, at[1]);
        const Tensor<1, dim> edge      = end - start;
        const double         square    = edge.norm_square();
        double              &share     = at[is_second];
        share                          = square > 0. ?
                                           std::clamp(((point - start) * edge) / square, 0., 1.) :
                                           0.;
        rest                           = point - (start + share * edge);
      }
    return rest.norm();
  }



#define INSTANTIATE(dim) template class SurfacePieces<dim>;
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
