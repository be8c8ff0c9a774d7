#ifndef signorini_solid_strain_range_h
#define signorini_solid_strain_range_h

#include <signorini/linear_algebra/types.h>
#include <signorini/solid/body.h>

#include <vector>

namespace Signorini
{
  /** How far from the start a body is deformed, and where. */
  template <int dim>
  struct StrainExtremes
  {
    struct Value
    {
      double             value;
      dealii::Point<dim> cell; // centre of the cell before the deformation, m
    };

    // Largest principal strain of sym grad u, by its size. 1
    Value strain = {0., {}};

    // Largest angle of skew grad u. rad
    Value rotation = {0., {}};

    // Smallest det(1 + grad u), the volume by that at the start. 1
    Value volume = {1., {}};
  };

  /**
   * Tells whether the displacements of a body are within the range of small
   * strains. A cell whose nodes moved against each other by less than a 50th of
   * its shortest edge is within it, and is passed over: this costs less than a
   * product with the stiffness.
   */
  template <int dim>
  class StrainRange
  {
  public:
    /** The body must outlive the object. */
    explicit StrainRange(const Body<dim> &body);

    StrainExtremes<dim>
    measure(const DofVector &displacement) const;

  private:
    bool
    is_moved(const unsigned int cell, const DofVector &displacement) const;

    const Body<dim>          *body_;
    std::vector<double>       shortest_edges_; // of the cells, m
    std::vector<unsigned int> dofs_;           // cell by cell, node by node
  };
} // namespace Signorini

#endif
