#include <signorini/input/instantiate.h>
#include <signorini/run/unpaired_bodies.h>
#include <signorini/solid/occupied_region.h>

#include <sstream>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    bool
    is_paired(const Problem<dim> &problem,
              const Body<dim>    &first,
              const Body<dim>    &second)
    {
      const auto touches = [](const ContactPair<dim> &pair,
                              const Body<dim>        &contactor,
                              const Body<dim>        &target) {
        return pair.body == &contactor &&
               pair.target->name().rfind(target.name() + ".", 0) == 0;
      };
      for (const auto &pair : problem.contact->pairs())
        if (touches(pair, first, second) || touches(pair, second, first))
          return true;
      return false;
    }

    // The deepest node of a body in the region of another: depth and place.
    template <int dim>
    std::pair<double, Point<dim>>
    deepest(const Body<dim>           &body,
            const DofVector           &displacement,
            const OccupiedRegion<dim> &region)
    {
      std::pair<double, Point<dim>> result(0., Point<dim>());
      for (const Point<dim> &place : node_positions(body.nodes(), displacement))
        if (const auto depth = region.depth(place);
            depth.value_or(0.) > result.first)
          result = {*depth, place};
      return result;
    }
  } // namespace



  template <int dim>
  std::string
  unpaired_overlaps(const Problem<dim> &problem, const DofVector &displacement)
  {
    const auto        &parts = problem.solid->parts();
    std::ostringstream text;
    for (unsigned int a = 0; a < parts.size(); ++a)
      for (unsigned int b = a + 1; b < parts.size(); ++b)
        {
          const Body<dim> &first = *parts[a].body, &second = *parts[b].body;
          if (is_paired(problem, first, second))
            continue;
          const OccupiedRegion<dim> of_first(first, displacement);
          const OccupiedRegion<dim> of_second(second, displacement);
          const auto found = std::max(deepest(first, displacement, of_second),
                                      deepest(second, displacement, of_first),
                                      [](const auto &left, const auto &right) {
                                        return left.first < right.first;
                                      });
          if (found.first < 0.01 * std::max(of_first.largest_cell(),
                                            of_second.largest_cell()))
            continue;
          text << "warning: the bodies " << first.name() << " and "
               << second.name() << " lie in each other at (" << found.second
               << "), by " << found.first
               << " m, and no contact pair keeps them apart. Is one missing in "
                  "Contact / Pairs?\n";
        }
    return text.str();
  }



#define INSTANTIATE(dim)                                       \
  template std::string unpaired_overlaps(const Problem<dim> &, \
                                         const DofVector &);
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
