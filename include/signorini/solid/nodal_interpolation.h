#ifndef signorini_solid_nodal_interpolation_h
#define signorini_solid_nodal_interpolation_h

#include <signorini/solid/nodal_mesh.h>

#include <deal.II/base/tensor_product_polynomials.h>
#include <deal.II/numerics/rtree.h>

#include <optional>

namespace Signorini
{
  /** The value at a point: sum_a weights[a] u(nodes[a]). */
  struct InterpolationWeights
  {
    std::vector<unsigned int> nodes;
    std::vector<double>       weights; // they add up to 1
  };

  /**
   * Finds the cell of a NodalMesh in which a point lies, and the weights of
   * its nodes.
   *
   * A point outside of the mesh belongs to the nearest cell as long as it is
   * not farther from it than 0.2 of the size of the cell (the mean extent of
   * its bounding box in each direction): the meshes of a curved boundary differ
   * by the sagitta of their edges. The weights are those of the point, so that
   * polynomials go on beyond the cell, but not farther than 0.2 of the cell.
   */
  template <int dim>
  class NodalInterpolation
  {
  public:
    explicit NodalInterpolation(NodalMesh<dim> mesh);

    /** Nothing if the point is outside and too far away. */
    std::optional<InterpolationWeights>
    weights(const dealii::Point<dim> &point) const;

    /** Does the point lie in one of the cells? */
    bool
    contains(const dealii::Point<dim> &point) const;

    /** For messages. */
    const dealii::Point<dim> &
    node_near(const dealii::Point<dim> &point) const;

  private:
    // The point in unit coordinates, and its distance (m) from the cell.
    struct Place
    {
      unsigned int       cell;
      dealii::Point<dim> unit_point;
      double             distance;
    };

    Place
    place_in(const unsigned int cell, const dealii::Point<dim> &point) const;

    // The point at unit coordinates; fills in d point / d unit coordinates.
    dealii::Point<dim>
    point_at(const unsigned int        cell,
             const dealii::Point<dim> &unit_point,
             dealii::Tensor<2, dim>   &gradient) const;

    // Unit coordinates, as near as Newton's method comes to the point.
    dealii::Point<dim>
    invert(const unsigned int cell, const dealii::Point<dim> &point) const;

    const unsigned int *
    nodes_of(const unsigned int cell) const
    {
      return &mesh_.cells[cell * shapes_.n()];
    }

    NodalMesh<dim>                        mesh_;
    dealii::TensorProductPolynomials<dim> shapes_;
    std::vector<double>                   sizes_; // of the cells, m

    // Cells by their bounding box with the tolerance around it.
    dealii::RTree<std::pair<dealii::BoundingBox<dim>, unsigned int>> tree_;
  };
} // namespace Signorini

#endif
