#ifndef signorini_geometry_fir_tree_fir_tree_band_h
#define signorini_geometry_fir_tree_fir_tree_band_h

#include <signorini/geometry/fir_tree/fir_tree_cells.h>
#include <signorini/geometry/fir_tree/fir_tree_profile.h>
#include <signorini/geometry/patchwork.h>

#include <string>

namespace Signorini
{
  /** Boundary ids of both bodies of a fir-tree joint. */
  namespace FirTreeBoundary
  {
    constexpr dealii::types::boundary_id free       = 0;
    constexpr dealii::types::boundary_id symmetry   = 1;
    constexpr dealii::types::boundary_id end        = 2; // top, or bore
    constexpr dealii::types::boundary_id side       = 3;
    constexpr dealii::types::boundary_id side_left  = 4;
    constexpr dealii::types::boundary_id first      = 10; // contact_1
    constexpr dealii::types::boundary_id first_left = 20; // contact_1_left
  } // namespace FirTreeBoundary

  /**
   * A layer of cells along a profile. Piece i begins at the vertex i and ends
   * at the vertex i + 1; from each vertex a line leads across the layer.
   */
  class FirTreeBand
  {
  public:
    struct Piece
    {
      ProfilePiece        profile;
      std::vector<double> fractions; // where its vertices are
      bool                is_round;  // the inner line is an arc, too
    };

    /**
     * @param across lines from each vertex of the surface to its inner point,
     * one more than pieces
     */
    FirTreeBand(const std::vector<Piece>    &pieces,
                const std::vector<Polyline> &across);

    const Polyline &
    inner(const unsigned int piece) const;

    const Polyline &
    across(const unsigned int vertex) const;

    /** Adds the layer; marks arcs and the boundaries of the working flanks. */
    void
    add_to(Patchwork &patchwork, const bool contact_has_arcs) const;

    /**
     * Adds the inside of a tooth whose tip is the piece @p tip, between two
     * straight ones. Returns its base from the first to the second of them.
     */
    Polyline
    add_tooth_to(Patchwork &patchwork, const unsigned int tip) const;

  private:
    std::vector<Piece>    pieces;
    std::vector<Polyline> outer_lines, inner_lines, across_lines;
  };

  /** The straight line through the origin where the mesh of a half ends. */
  struct FirTreeSpine
  {
    dealii::Tensor<1, 2> direction; // unit vector

    /** The point nearest to @p p, moved outwards along the line by @p shift. */
    dealii::Point<2>
    foot(const dealii::Point<2> &p, const double shift = 0.) const;
  };

  /**
   * The line from an inner point to the spine. It leaves in a direction (in
   * degrees from the x axis) that parts the angle at the point evenly.
   * @param reach how far it keeps the direction, m
   * @param first_size size of the first cell, m
   */
  Polyline
  line_to_spine(const dealii::Point<2> &start,
                const dealii::Point<2> &end,
                const double            direction,
                const double            reach,
                const double            first_size,
                const unsigned int      n_cells);

  /** Names the boundaries; @p end_name is that of the id `end`. */
  void
  name_fir_tree_boundaries(const FirTreeJoint &joint,
                           const bool          is_full,
                           const std::string  &end_name,
                           Mesh<2>            &mesh);

  /** Adds the left half. */
  void
  mirror_fir_tree(Patchwork &patchwork);
} // namespace Signorini

#endif
