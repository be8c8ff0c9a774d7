#ifndef signorini_geometry_sketch_canvas_h
#define signorini_geometry_sketch_canvas_h

#include <deal.II/base/point.h>
#include <deal.II/grid/tria.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini
{
  /** To the right, up, and towards who looks: unit vectors. */
  template <int dim>
  struct SketchView;

  template <>
  struct SketchView<2>
  {
    const dealii::Tensor<1, 2> right{{1., 0.}}, up{{0., 1.}}, towards{{0., 0.}};
  };

  /** Orthographic: turned by 30 degrees about y, and looked down upon. */
  template <>
  struct SketchView<3>
  {
    const double s = 0.5, c = std::sqrt(0.75), sp = 0.4, cp = std::sqrt(0.84);
    const dealii::Tensor<1, 3> right{{c, 0., -s}}, up{{-s * sp, cp, -c *sp}},
      towards{{s * cp, sp, c *cp}};
  };

  /** The y axis of a picture goes down. */
  template <int dim>
  dealii::Tensor<1, 2>
  projected(const dealii::Tensor<1, dim> &direction)
  {
    const SketchView<dim> view;
    return dealii::Tensor<1, 2>(
      {direction * view.right, -(direction * view.up)});
  }

  /** Turns points of a mesh into points of a picture. */
  template <int dim>
  class SketchCanvas
  {
  public:
    /**
     * @param width of the drawing or its height, the larger of both
     * @param margin around it
     */
    SketchCanvas(const dealii::Triangulation<dim> &triangulation,
                 const double                      width,
                 const double                      margin)
      : margin({margin, margin})
    {
      constexpr double infinity = std::numeric_limits<double>::max();
      dealii::Point<2> low(infinity, infinity), high(-infinity, -infinity);
      for (const dealii::Point<dim> &vertex : triangulation.get_vertices())
        {
          const dealii::Tensor<1, 2> p = projected<dim>(vertex);
          for (unsigned int c = 0; c < 2; ++c)
            {
              low[c]  = std::min(low[c], p[c]);
              high[c] = std::max(high[c], p[c]);
            }
        }
      scale  = width / std::max(high[0] - low[0], high[1] - low[1]);
      corner = low;
      size   = scale * (high - low);
    }

    dealii::Point<2>
    operator()(const dealii::Point<dim> &p) const
    {
      return dealii::Point<2>(scale * (projected<dim>(p) - corner)) + margin;
    }

    /**
     * From the middle in this direction, a unit vector or zero, to where the
     * drawing ends.
     */
    dealii::Point<2>
    edge(const dealii::Tensor<1, 2> &direction) const
    {
      double factor = 0.5 * size.norm();
      for (unsigned int c = 0; c < 2; ++c)
        if (std::abs(direction[c]) > 1e-6)
          factor = std::min(factor, 0.5 * size[c] / std::abs(direction[c]));
      return dealii::Point<2>(0.5 * size + factor * direction) + margin;
    }

    /** Pixels a metre, and the size of the drawing without its margin. */
    double               scale;
    dealii::Tensor<1, 2> size;

  private:
    dealii::Tensor<1, 2> margin, corner;
  };
} // namespace Signorini

#endif
