#ifndef signorini_curves_segment_tree_h
#define signorini_curves_segment_tree_h

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/point.h>

#include <memory>
#include <vector>

namespace Signorini
{
  /** A tree of boxes (R-tree): which of many boxes are near. */
  class SegmentTree
  {
  public:
    /** Packs the boxes, which are known by their index. Cost: n log n. */
    explicit SegmentTree(const std::vector<dealii::BoundingBox<2>> &boxes);

    ~SegmentTree();
    SegmentTree(SegmentTree &&) noexcept;
    SegmentTree &
    operator=(SegmentTree &&) noexcept;

    /** Appends the boxes that this box touches. */
    void
    find(const dealii::Point<2>    &lower,
         const dealii::Point<2>    &upper,
         std::vector<unsigned int> &found) const;

    /** Appends the n boxes that are nearest to a point. */
    void
    find_nearest(const dealii::Point<2>    &point,
                 const unsigned int         n,
                 std::vector<unsigned int> &found) const;

  private:
    // Boost's header costs every file that sees it seconds.
    struct Tree;
    std::unique_ptr<Tree> tree_;
  };
} // namespace Signorini

#endif
