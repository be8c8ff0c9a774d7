#include <signorini/contact/contact_zone.h>
#include <signorini/input/instantiate.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // Length of a piece of a line, area of a bilinear piece through its
    // diagonals.
    double
    size_of_face(const std::vector<Point<2>>     &positions,
                 const std::vector<unsigned int> &face)
    {
      return positions[face[0]].distance(positions[face[1]]);
    }

    double
    size_of_face(const std::vector<Point<3>>     &positions,
                 const std::vector<unsigned int> &face)
    {
      return 0.5 * cross_product_3d(positions[face[3]] - positions[face[0]],
                                    positions[face[2]] - positions[face[1]])
                     .norm();
    }
  } // namespace



  template <int dim>
  ContactZone<dim>
  contact_zone(const ContactPair<dim>    &pair,
               const std::vector<double> &normal_forces,
               const DofVector           &displacement)
  {
    const ContactorSurface<dim> &surface = pair.contactor;
    const auto positions = node_positions(surface.nodes, displacement);
    const auto is_closed = [&](const unsigned int node) {
      return normal_forces[pair.first_contact + node] > 0.;
    };
    ContactZone<dim> zone;
    for (unsigned int n = 0; n < positions.size(); ++n)
      if (is_closed(n))
        zone.points.push_back(positions[n]);
    double size = 0.;
    for (const auto &face : surface.faces)
      size += size_of_face(positions, face) *
              std::count_if(face.begin(), face.end(), is_closed) / face.size();
    zone.width = dim == 2 ? size : std::sqrt(size);
    return zone;
  }



  template <int dim>
  std::vector<NearMiss<dim>>
  near_misses(const ContactPair<dim>    &pair,
              const std::vector<double> &normal_forces,
              const std::vector<double> &gaps,
              const DofVector           &displacement)
  {
    const auto &nodes     = pair.contactor.nodes;
    const auto  positions = node_positions(nodes, displacement);
    const auto  gap       = [&](const unsigned int node) {
      return gaps[pair.first_contact + node];
    };
    std::vector<double> largest_gap_around(nodes.size(), 0.);
    for (const auto &face : pair.contactor.faces)
      for (const unsigned int node : face)
        for (const unsigned int other : face)
          if (std::isfinite(gap(other)))
            largest_gap_around[node] =
              std::max(largest_gap_around[node], gap(other));

    std::vector<NearMiss<dim>> result;
    for (unsigned int n = 0; n < nodes.size(); ++n)
      if (normal_forces[pair.first_contact + n] <= 0. && std::isfinite(gap(n)))
        result.push_back(
          {positions[n], gap(n), 5. * gap(n) < largest_gap_around[n]});
    return result;
  }



#define INSTANTIATE(dim)                                                        \
  template ContactZone<dim>           contact_zone(const ContactPair<dim> &,    \
                                                   const std::vector<double> &, \
                                                   const DofVector &);          \
  template std::vector<NearMiss<dim>> near_misses(const ContactPair<dim> &,     \
                                                  const std::vector<double> &,  \
                                                  const std::vector<double> &,  \
                                                  const DofVector &);
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
