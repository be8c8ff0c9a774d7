#include <signorini/contact/mortar.h>

#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    constexpr unsigned int nobody = numbers::invalid_unsigned_int;

    // So small a part of a share is opposite to the target by chance.
    constexpr double sliver = 1e-6;

    // A quadrature point that has a target in reach.
    struct CoveredPoint
    {
      WeightedNodes  nodes;     // N_a, 1
      unsigned int   nearest;   // the node whose share it is in,
      unsigned int   neighbour; // and that on its other side
      double         weight;    // dA, m^2
      TargetPoint<2> target;
    };

    class MortarIntegration
    {
    public:
      explicit MortarIntegration(const PlacedPair<2> &placed);

      std::vector<ContactPoint<2>>
      candidates() const;

    private:
      // Where an element is cut: into the shares of its nodes, and by the
      // nodes of the target.
      std::vector<double>
      cuts(const std::vector<unsigned int> &element) const;

      // Integrates over an element between two cuts.
      void
      add_points(const std::vector<unsigned int> &element,
                 const double                     begin,
                 const double                     end);

      // The node's own, or that of the neighbour if it is held or has but a
      // sliver.
      unsigned int
      candidate_of(const CoveredPoint &point) const;

      const PlacedPair<2>                               &placed;
      const ContactorSurface<2>                         &surface;
      const std::vector<Point<2>>                        joints;
      const std::vector<Point<1>>                        element_nodes;
      const std::vector<Polynomials::Polynomial<double>> shapes;
      const QGauss<1>                                    quadrature;

      std::vector<CoveredPoint> points;
      std::vector<double>       whole;   // the share of each node, m^2
      std::vector<double>       covered; // opposite to the target, m^2
    };



    MortarIntegration::MortarIntegration(const PlacedPair<2> &placed)
      : placed(placed)
      , surface(placed.pair.surface)
      , joints(placed.target->joints())
      , element_nodes(QGaussLobatto<1>(surface.degree + 1).get_points())
      , shapes(Polynomials::generate_complete_Lagrange_basis(element_nodes))
      // N_a times a shape function of the target and the circumference
      , quadrature(surface.degree + 1)
      , whole(surface.nodes.size())
      , covered(surface.nodes.size())
    {
      for (const auto &element : surface.elements)
        {
          const auto places = cuts(element);
          for (unsigned int s = 1; s < places.size(); ++s)
            if (places[s] - places[s - 1] > 1e-12)
              add_points(element, places[s - 1], places[s]);
        }
    }



    std::vector<double>
    MortarIntegration::cuts(const std::vector<unsigned int> &element) const
    {
      const Point<2>     start  = placed.positions[element.front()];
      const Tensor<1, 2> chord  = placed.positions[element.back()] - start;
      const double       square = chord.norm_square();
      const auto         along  = [&](const Point<2> &x) {
        return (x - start) * chord / square;
      };
      // x(xi) lies at (1 - b) xi + b xi^2 along the chord.
      Assert(surface.degree <= 2, ExcNotImplemented());
      const double b = surface.degree == 2 ?
                         2. - 4. * along(placed.positions[element[1]]) :
                         0.;

      std::vector<double> places = {0., 1.};
      for (unsigned int i = 0; i < surface.degree; ++i)
        places.push_back(0.5 * (element_nodes[i][0] + element_nodes[i + 1][0]));
      for (const Point<2> &joint : joints)
        {
          const double s = along(joint);
          // Only what lies opposite can cut.
          if (s <= 0. || s >= 1. ||
              (joint - start - s * chord).norm_square() >= square)
            continue;
          const double root =
            std::sqrt(std::max(0., (1. - b) * (1. - b) + 4. * b * s));
          places.push_back(std::min(1., 2. * s / (1. - b + root)));
        }
      std::sort(places.begin(), places.end());
      return places;
    }



    void
    MortarIntegration::add_points(const std::vector<unsigned int> &element,
                                  const double                     begin,
                                  const double                     end)
    {
      const double middle = 0.5 * (begin + end);
      unsigned int left   = 0; // of the two nodes around
      while (element_nodes[left + 1][0] < middle)
        ++left;
      const bool is_left_nearer =
        middle - element_nodes[left][0] < element_nodes[left + 1][0] - middle;

      CoveredPoint point;
      point.nearest   = element[is_left_nearer ? left : left + 1];
      point.neighbour = element[is_left_nearer ? left + 1 : left];
      for (unsigned int q = 0; q < quadrature.size(); ++q)
        {
          const double xi = begin + (end - begin) * quadrature.point(q)[0];
          Point<2>     reference;
          Tensor<1, 2> tangent;
          point.nodes.clear();
          for (unsigned int a = 0; a < element.size(); ++a)
            {
              std::vector<double> values(2);
              shapes[a].value(xi, values);
              point.nodes.emplace_back(element[a], values[0]);
              reference += values[0] * surface.nodes[element[a]].point;
              tangent += values[1] * surface.nodes[element[a]].point;
            }
          point.weight = quadrature.weight(q) * (end - begin) * tangent.norm() *
                         placed.pair.body->volume_factor(reference);
          whole[point.nearest] += point.weight;
          const auto target = closest_to(placed, point.nodes);
          if (!target)
            continue;
          covered[point.nearest] += point.weight;
          point.target = *target;
          points.push_back(point);
        }
    }



    unsigned int
    MortarIntegration::candidate_of(const CoveredPoint &point) const
    {
      const auto &of_node = placed.pair.candidate_of_node;
      const auto  counts  = [&](const unsigned int node) {
        return covered[node] > sliver * whole[node];
      };
      if (counts(point.nearest) && of_node[point.nearest] != nobody)
        return of_node[point.nearest];
      return counts(point.nearest) || counts(point.neighbour) ?
               of_node[point.neighbour] :
               nobody;
    }



    std::vector<ContactPoint<2>>
    MortarIntegration::candidates() const
    {
      std::vector<ContactPoint<2>> candidates(
        placed.pair.node_of_candidate.size());
      for (const CoveredPoint &point : points)
        if (const unsigned int k = candidate_of(point); k != nobody)
          candidates[k].area += point.weight;
      for (const CoveredPoint &point : points)
        if (const unsigned int k = candidate_of(point); k != nobody)
          add_to_candidate(placed,
                           point.nodes,
                           point.target,
                           point.weight / candidates[k].area,
                           candidates[k]);
      for (auto &candidate : candidates)
        candidate.merge_rows();
      return candidates;
    }
  } // namespace



  std::vector<ContactPoint<2>>
  mortar_points(const PlacedPair<2> &placed)
  {
    return MortarIntegration(placed).candidates();
  }



  std::vector<ContactPoint<3>>
  mortar_points(const PlacedPair<3> &)
  {
    AssertThrow(false, ExcNotImplemented());
    return {};
  }
} // namespace Signorini
