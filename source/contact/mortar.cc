#include <signorini/contact/mortar.h>

#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // A quadrature point that has a target in reach.
    struct CoveredPoint
    {
      std::vector<double> shape;  // N_a, 1
      double              weight; // dA, m^2
      TargetPoint<2>      target;
    };

    class MortarIntegration
    {
    public:
      explicit MortarIntegration(const PlacedPair<2> &placed);

      std::vector<ContactPoint<2>>
      candidates();

    private:
      // Where the element is cut, 0 and 1 included.
      std::vector<double>
      cuts(const std::vector<unsigned int> &element) const;

      std::vector<CoveredPoint>
      covered_points(const std::vector<unsigned int> &element) const;

      // psi_k = sum_a A(k, a) N_a: A = D M^-1 from the covered part, or the
      // identity where that part is too small for M.
      FullMatrix<double>
      dual_coefficients(const std::vector<CoveredPoint> &points) const;

      WeightedNodes
      weighted_nodes(const std::vector<unsigned int> &element,
                     const std::vector<double>       &shape) const;

      const PlacedPair<2>                               &placed;
      const ContactorSurface<2>                         &surface;
      const std::vector<Point<2>>                        joints;
      const std::vector<Polynomials::Polynomial<double>> shapes;
      const QGauss<1>                                    quadrature;
    };



    MortarIntegration::MortarIntegration(const PlacedPair<2> &placed)
      : placed(placed)
      , surface(placed.pair.surface)
      , joints(placed.target->joints())
      , shapes(Polynomials::generate_complete_Lagrange_basis(
          QGaussLobatto<1>(surface.degree + 1).get_points()))
      , quadrature(surface.degree + 2)
    {}



    std::vector<double>
    MortarIntegration::cuts(const std::vector<unsigned int> &element) const
    {
      const Point<2>      start  = placed.positions[element.front()];
      const Tensor<1, 2>  edge   = placed.positions[element.back()] - start;
      const double        square = edge.norm_square();
      std::vector<double> places = {0., 1.};
      for (const Point<2> &joint : joints)
        {
          const Tensor<1, 2> arm = joint - start;
          const double       xi  = arm * edge / square;
          // Only what lies opposite can cut.
          if (xi > 0. && xi < 1. && (arm - xi * edge).norm_square() < square)
            places.push_back(xi);
        }
      std::sort(places.begin(), places.end());
      return places;
    }



    WeightedNodes
    MortarIntegration::weighted_nodes(const std::vector<unsigned int> &element,
                                      const std::vector<double> &shape) const
    {
      WeightedNodes nodes;
      for (unsigned int a = 0; a < element.size(); ++a)
        nodes.emplace_back(element[a], shape[a]);
      return nodes;
    }



    std::vector<CoveredPoint>
    MortarIntegration::covered_points(
      const std::vector<unsigned int> &element) const
    {
      std::vector<CoveredPoint> points;
      const auto                places = cuts(element);
      for (unsigned int s = 1; s < places.size(); ++s)
        {
          const double length = places[s] - places[s - 1];
          if (length < 1e-12)
            continue;
          for (unsigned int q = 0; q < quadrature.size(); ++q)
            {
              const double xi = places[s - 1] + length * quadrature.point(q)[0];
              CoveredPoint point;
              Point<2>     reference;
              Tensor<1, 2> tangent;
              for (unsigned int a = 0; a < element.size(); ++a)
                {
                  std::vector<double> values(2);
                  shapes[a].value(xi, values);
                  point.shape.push_back(values[0]);
                  reference += values[0] * surface.nodes[element[a]].point;
                  tangent += values[1] * surface.nodes[element[a]].point;
                }
              const auto target =
                closest_to(placed, weighted_nodes(element, point.shape));
              if (!target)
                continue;
              point.weight = quadrature.weight(q) * length * tangent.norm() *
                             placed.pair.body->volume_factor(reference);
              point.target = *target;
              points.push_back(point);
            }
        }
      return points;
    }



    FullMatrix<double>
    MortarIntegration::dual_coefficients(
      const std::vector<CoveredPoint> &points) const
    {
      const unsigned int n = surface.degree + 1;
      FullMatrix<double> mass(n);
      Vector<double>     size(n);
      double             covered = 0.;
      for (const CoveredPoint &point : points)
        {
          covered += point.weight;
          for (unsigned int a = 0; a < n; ++a)
            {
              size[a] += point.weight * point.shape[a];
              for (unsigned int b = 0; b < n; ++b)
                mass(a, b) += point.weight * point.shape[a] * point.shape[b];
            }
        }
      FullMatrix<double> coefficients = IdentityMatrix(n);
      double             smallest     = covered;
      for (unsigned int a = 0; a < n; ++a)
        smallest = std::min(smallest, mass(a, a));
      if (points.size() < n || smallest < 1e-3 * covered)
        return coefficients;
      mass.gauss_jordan();
      for (unsigned int k = 0; k < n; ++k)
        for (unsigned int a = 0; a < n; ++a)
          coefficients(k, a) = size[k] * mass(k, a);
      return coefficients;
    }



    std::vector<ContactPoint<2>>
    MortarIntegration::candidates()
    {
      // 1. Dual functions of all elements, and the covered area of each node
      std::vector<std::vector<CoveredPoint>> covered;
      std::vector<FullMatrix<double>>        dual;
      std::vector<double>                    areas(surface.nodes.size());
      const auto value = [&](const FullMatrix<double> &coefficients,
                             const unsigned int        k,
                             const CoveredPoint       &point) {
        double psi = 0.;
        for (unsigned int a = 0; a < point.shape.size(); ++a)
          psi += coefficients(k, a) * point.shape[a];
        return psi;
      };
      for (const auto &element : surface.elements)
        {
          covered.push_back(covered_points(element));
          dual.push_back(dual_coefficients(covered.back()));
          for (const CoveredPoint &point : covered.back())
            for (unsigned int k = 0; k < element.size(); ++k)
              areas[element[k]] += point.weight * value(dual.back(), k, point);
        }

      // 2. Weighted means
      std::vector<ContactPoint<2>> candidates(
        placed.pair.node_of_candidate.size());
      double largest = 0.;
      for (const double area : areas)
        largest = std::max(largest, area);
      for (unsigned int e = 0; e < surface.elements.size(); ++e)
        {
          const auto &element = surface.elements[e];
          for (unsigned int k = 0; k < element.size(); ++k)
            {
              const unsigned int candidate =
                placed.pair.candidate_of_node[element[k]];
              // A node that is held has no candidate; a sliver has no pressure.
              if (candidate == numbers::invalid_unsigned_int ||
                  areas[element[k]] <= 1e-6 * largest)
                continue;
              for (const CoveredPoint &point : covered[e])
                add_to_candidate(placed,
                                 weighted_nodes(element, point.shape),
                                 point.target,
                                 point.weight * value(dual[e], k, point) /
                                   areas[element[k]],
                                 candidates[candidate]);
            }
        }
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
