#include <signorini/contact/contact_pressures.h>
#include <signorini/input/instantiate.h>

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // At r = 0, from values at the radii of the other nodes of an element.
    template <int dim>
    double
    pressure_on_axis(const ContactPair<dim>          &pair,
                     const unsigned int               node,
                     const std::vector<unsigned int> &element,
                     const std::vector<double>       &pressures)
    {
      double sum = 0.;
      for (const unsigned int a : element)
        {
          const unsigned int candidate = pair.candidate_of_node[a];
          if (a == node || candidate == numbers::invalid_unsigned_int)
            continue;
          const auto square = [&](const unsigned int of) {
            return Utilities::fixed_power<2>(pair.surface.nodes[of].point[0]);
          };
          double weight = 1.;
          for (const unsigned int b : element)
            if (b != node && b != a)
              weight *= square(b) / (square(b) - square(a));
          sum += weight * pressures[candidate];
        }
      return std::max(sum, 0.);
    }
  } // namespace



  template <int dim>
  std::vector<double>
  contact_pressures(const ContactPair<dim>               &pair,
                    const std::vector<ContactPoint<dim>> &points,
                    const std::vector<double>            &normal_forces)
  {
    std::vector<double> pressures;
    for (unsigned int n = 0; n < pair.contactor.nodes.size(); ++n)
      pressures.push_back(points[pair.first_contact + n].pressure(
        normal_forces[pair.first_contact + n]));
    if (pair.body->formulation() != Formulation::axisymmetric)
      return pressures;
    for (unsigned int n = 0; n < pressures.size(); ++n)
      {
        const unsigned int node = pair.node_of_candidate[n];
        if (pair.surface.areas[node] > 0. ||
            points[pair.first_contact + n].area > 0.)
          continue;
        for (const auto &element : pair.surface.elements)
          if (std::count(element.begin(), element.end(), node) > 0)
            pressures[n] = pressure_on_axis(pair, node, element, pressures);
      }
    return pressures;
  }



#define INSTANTIATE(dim)                          \
  template std::vector<double> contact_pressures( \
    const ContactPair<dim> &,                     \
    const std::vector<ContactPoint<dim>> &,       \
    const std::vector<double> &);
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
