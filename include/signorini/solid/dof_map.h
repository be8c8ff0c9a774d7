#ifndef signorini_solid_dof_map_h
#define signorini_solid_dof_map_h

#include <deal.II/lac/affine_constraints.h>

#include <vector>

namespace Signorini
{
  /**
   * What each unknown of a problem is. Those of the deformable bodies come
   * first, body by body, then those of the rigid bodies. An unknown is
   *
   * - prescribed, if a support or a given rigid motion says what it is;
   * - hanging, if its node follows its neighbours;
   * - constrained, if it is not solved for: prescribed, hanging, or the one
   *   component of a sliding node that follows the others.
   */
  class DofMap
  {
  public:
    DofMap() = default;

    DofMap(const unsigned int n_body_dofs, const unsigned int n_rigid_body_dofs)
      : n_body_dofs_(n_body_dofs)
      , is_prescribed_(n_body_dofs + n_rigid_body_dofs)
      , is_hanging_(is_prescribed_.size())
      , is_constrained_(is_prescribed_.size())
    {}

    /** Unknowns of all bodies. */
    unsigned int
    size() const
    {
      return is_prescribed_.size();
    }

    /** How many belong to deformable bodies: the number of the first unknown
     * of a rigid body. */
    unsigned int
    n_body_dofs() const
    {
      return n_body_dofs_;
    }

    bool
    is_prescribed(const unsigned int dof) const
    {
      return is_prescribed_[dof];
    }

    bool
    is_hanging(const unsigned int dof) const
    {
      return is_hanging_[dof];
    }

    bool
    is_constrained(const unsigned int dof) const
    {
      return is_constrained_[dof];
    }

    /** is_constrained() of all unknowns. */
    const std::vector<bool> &
    constrained() const
    {
      return is_constrained_;
    }

    /** How hanging and sliding nodes follow others. */
    const dealii::AffineConstraints<double> &
    constraints() const
    {
      return constraints_;
    }

    void
    prescribe(const unsigned int dof)
    {
      is_prescribed_[dof]  = true;
      is_constrained_[dof] = true;
    }

    /** The unknown is sum of weight times others, as a hanging node is. */
    void
    hang(const unsigned int                                  dof,
         const std::vector<std::pair<unsigned int, double>> &others)
    {
      is_hanging_[dof] = true;
      follow(dof, others);
    }

    /** The unknown is sum of weight times others. */
    void
    follow(const unsigned int                                  dof,
           const std::vector<std::pair<unsigned int, double>> &others)
    {
      is_constrained_[dof] = true;
      constraints_.add_line(dof);
      for (const auto &[other, weight] : others)
        constraints_.add_entry(dof, other, weight);
    }

    /** No more unknowns will follow others. */
    void
    close()
    {
      constraints_.close();
    }

  private:
    unsigned int                      n_body_dofs_ = 0;
    std::vector<bool>                 is_prescribed_;
    std::vector<bool>                 is_hanging_;
    std::vector<bool>                 is_constrained_;
    dealii::AffineConstraints<double> constraints_;
  };
} // namespace Signorini

#endif
