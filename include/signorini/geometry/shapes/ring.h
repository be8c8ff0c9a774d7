#ifndef signorini_geometry_shapes_ring_h
#define signorini_geometry_shapes_ring_h

#include <signorini/geometry/mesh_generator.h>

#include <deal.II/base/point.h>

namespace Signorini
{
  class Entries;

  /** A ring or a part of it: the domain between two circles and two angles. */
  struct RingShape
  {
    dealii::Point<2> center;       // m
    double           inner_radius; // m
    double           outer_radius; // m
    double           start_angle;  // degrees, counter-clockwise from the x axis
    double           end_angle;    // degrees
    unsigned int     n_around;     // cells along the circles
    unsigned int     n_radial;     // cells from the inner to the outer circle

    bool
    is_full() const;

    /** Declares Inner radius, Outer radius and Angles. */
    static void
    declare_parameters(dealii::ParameterHandler &prm);

    /**
     * Reads these entries, and `Cells` (around, radial, perhaps more), but not
     * the centre. @throws InputError
     */
    void
    parse_parameters(const Entries &entries);
  };

  /**
   * The structured mesh of a ring. Boundary ids: 0 inner, 1 outer, and for a
   * part of the ring 2 start, 3 end (the cuts at the two angles).
   */
  Mesh<2>
  ring_mesh(const RingShape &shape);

  /**
   * `ring` (2-D, subsection `Ring`): a full ring (`Angles = 0, 360`), or any
   * part of it, such as the half `-90, 90` or the quarter `0, 90`.
   * Boundaries: inner, outer, and the cuts start and end. Region: body.
   */
  class Ring : public MeshGenerator<2>
  {
  public:
    static void
    declare_parameters(dealii::ParameterHandler &prm);

    void
    parse_parameters(const dealii::ParameterHandler &prm) override;

    Mesh<2>
    create() const override;

  private:
    RingShape shape;
  };
} // namespace Signorini

#endif
