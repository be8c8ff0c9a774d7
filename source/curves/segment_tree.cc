#include <signorini/curves/segment_tree.h>

#include <boost/function_output_iterator.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/geometry/strategies/strategies.hpp>

#include <utility>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    namespace bg  = boost::geometry;
    using Corner  = bg::model::point<double, 2, bg::cs::cartesian>;
    using Box     = bg::model::box<Corner>;
    using Indexed = std::pair<Box, unsigned int>;

    std::vector<Indexed>
    indexed(const std::vector<BoundingBox<2>> &boxes)
    {
      std::vector<Indexed> result;
      result.reserve(boxes.size());
      for (const auto &box : boxes)
        {
          const auto &[lower, upper] = box.get_boundary_points();
          result.emplace_back(Box(Corner(lower[0], lower[1]),
                                  Corner(upper[0], upper[1])),
                              result.size());
        }
      return result;
    }

    auto
    append_index_to(std::vector<unsigned int> &found)
    {
      return boost::make_function_output_iterator(
        [&found](const Indexed &item) { found.push_back(item.second); });
    }
  } // namespace



  struct SegmentTree::Tree
  {
    bg::index::rtree<Indexed, bg::index::rstar<16>> boxes;
  };



  SegmentTree::SegmentTree(const std::vector<BoundingBox<2>> &boxes)
    : tree_(std::make_unique<Tree>())
  {
    tree_->boxes = decltype(tree_->boxes)(indexed(boxes));
  }



  SegmentTree::~SegmentTree()                       = default;
  SegmentTree::SegmentTree(SegmentTree &&) noexcept = default;
  SegmentTree &
  SegmentTree::operator=(SegmentTree &&) noexcept = default;



  void
  SegmentTree::find(const Point<2>            &lower,
                    const Point<2>            &upper,
                    std::vector<unsigned int> &found) const
  {
    tree_->boxes.query(bg::index::intersects(Box(Corner(lower[0], lower[1]),
                                                 Corner(upper[0], upper[1]))),
                       append_index_to(found));
  }



  void
  SegmentTree::find_nearest(const Point<2>            &point,
                            const unsigned int         n,
                            std::vector<unsigned int> &found) const
  {
    tree_->boxes.query(bg::index::nearest(Corner(point[0], point[1]), n),
                       append_index_to(found));
  }
} // namespace Signorini
