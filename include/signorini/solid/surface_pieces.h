#ifndef signorini_solid_surface_pieces_h
#define signorini_solid_surface_pieces_h

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/point.h>
#include <deal.II/numerics/rtree.h>

#include <utility>
#include <vector>

namespace Signorini
{
  /**
   * A surface as pieces between its nodes: straight ones of 2 points, or
   * bilinear ones of 4 in lexicographic order. Finds the nearest one.
   */
  template <int dim>
  class SurfacePieces
  {
  public:
    using Piece = std::vector<dealii::Point<dim>>; // m

    explicit SurfacePieces(std::vector<Piece> pieces);

    const Piece &
    operator[](const unsigned int piece) const
    {
      return pieces_[piece];
    }

    unsigned int
    size() const
    {
      return pieces_.size();
    }

    /** The nearest piece and its distance, m. There has to be one. */
    std::pair<unsigned int, double>
    nearest(const dealii::Point<dim> &point) const;

    /** The longest edge of a piece, m. */
    double
    length(const unsigned int piece) const;

  private:
    double
    distance(const dealii::Point<dim> &point, const Piece &piece) const;

    std::vector<Piece>                                               pieces_;
    dealii::RTree<std::pair<dealii::BoundingBox<dim>, unsigned int>> tree_;
  };
} // namespace Signorini

#endif
