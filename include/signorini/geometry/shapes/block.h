#ifndef signorini_geometry_shapes_block_h
#define signorini_geometry_shapes_block_h

#include <signorini/geometry/mesh_generator.h>

#include <deal.II/base/point.h>

#include <vector>

namespace Signorini
{
  /**
   * `rectangle` (2-D) and `box` (3-D), in the subsections `Rectangle` and
   * `Box`: sides parallel to the axes, structured cells.
   *
   * Boundaries: left (smallest x), right (largest x), bottom (smallest y), top
   * (largest y); in 3-D also back (smallest z), front (largest z). They keep
   * their names when the block is turned by `Angle`. Region: body.
   *
   * `Grading` is the ratio of the last to the first cell size in a direction;
   * the sizes in between form a geometric sequence.
   */
  template <int dim>
  class Block : public MeshGenerator<dim>
  {
  public:
    static void
    declare_parameters(dealii::ParameterHandler &prm);

    void
    parse_parameters(const dealii::ParameterHandler &prm) override;

    Mesh<dim>
    create() const override;

  private:
    dealii::Point<dim>        first_corner;  // m
    dealii::Point<dim>        second_corner; // m
    std::vector<unsigned int> n_cells;
    std::vector<double>       grading;
    double                    angle; // degrees, about the z axis
  };

  /**
   * The ends of @p n_cells intervals between @p begin and @p end whose sizes
   * form a geometric sequence, last : first = @p ratio. Both ends are exact.
   */
  std::vector<double>
  graded_points(const double       begin,
                const double       end,
                const unsigned int n_cells,
                const double       ratio);
} // namespace Signorini

#endif
