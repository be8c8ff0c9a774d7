#include <signorini/contact/facet_stiffness.h>

#include <algorithm>

#include "bilinear_shape.h"

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // Derivatives of a vector and of a number with respect to each point: x
    // and the nodes.
    using VectorDerivative = std::vector<Tensor<2, 3>>;
    using ScalarDerivative = std::vector<Tensor<1, 3>>;

    // w -> v x w
    Tensor<2, 3>
    cross_matrix(const Tensor<1, 3> &v)
    {
      Tensor<2, 3> matrix;
      matrix[0][1] = -v[2];
      matrix[0][2] = v[1];
      matrix[1][0] = v[2];
      matrix[1][2] = -v[0];
      matrix[2][0] = -v[1];
      matrix[2][1] = v[0];
      return matrix;
    }

    // I - n n
    Tensor<2, 3>
    tangential_projection(const Tensor<1, 3> &normal)
    {
      return Tensor<2, 3>(unit_symmetric_tensor<3>()) -
             outer_product(normal, normal);
    }

    void
    add(VectorDerivative       &sum,
        const double            factor,
        const VectorDerivative &other)
    {
      for (unsigned int i = 0; i < sum.size(); ++i)
        sum[i] += factor * other[i];
    }

    // The nodes of all facets around the corners of one, these first; a point's
    // number in a derivative is 0 for x and one more than that here for a node.
    class Patch
    {
    public:
      Patch(const ContactorSurface<3>                    &surface,
            const std::vector<std::vector<unsigned int>> &facets_of_nodes,
            const std::vector<Point<3>>                  &positions,
            const unsigned int                            facet);

      unsigned int
      n_points() const
      {
        return 1 + nodes.size();
      }

      unsigned int
      point(const unsigned int node) const
      {
        return 1 +
               (std::find(nodes.begin(), nodes.end(), node) - nodes.begin());
      }

      struct NodeNormal
      {
        Tensor<1, 3>     value;
        VectorDerivative derivative;
      };

      NodeNormal
      normal(const unsigned int node) const;

      std::vector<unsigned int> nodes;

    private:
      const ContactorSurface<3>                    &surface;
      const std::vector<std::vector<unsigned int>> &facets_of_nodes;
      const std::vector<Point<3>>                  &positions;
    };



    Patch::Patch(const ContactorSurface<3>                    &surface,
                 const std::vector<std::vector<unsigned int>> &facets_of_nodes,
                 const std::vector<Point<3>>                  &positions,
                 const unsigned int                            facet)
      : nodes(surface.faces[facet])
      , surface(surface)
      , facets_of_nodes(facets_of_nodes)
      , positions(positions)
    {
      for (const unsigned int corner : surface.faces[facet])
        for (const unsigned int around : facets_of_nodes[corner])
          for (const unsigned int node : surface.faces[around])
            if (std::find(nodes.begin(), nodes.end(), node) == nodes.end())
              nodes.push_back(node);
    }



    Patch::NodeNormal
    Patch::normal(const unsigned int node) const
    {
      Tensor<1, 3>     area;
      VectorDerivative derivative(n_points());
      for (const unsigned int around : facets_of_nodes[node])
        {
          const auto        &facet  = surface.faces[around];
          const Tensor<1, 3> first  = positions[facet[3]] - positions[facet[0]];
          const Tensor<1, 3> second = positions[facet[2]] - positions[facet[1]];
          area += cross_product_3d(first, second);
          derivative[point(facet[3])] -= cross_matrix(second);
          derivative[point(facet[0])] += cross_matrix(second);
          derivative[point(facet[2])] += cross_matrix(first);
          derivative[point(facet[1])] -= cross_matrix(first);
        }
      const double       size   = area.norm();
      const Tensor<1, 3> normal = area / size;
      const Tensor<2, 3> turn   = tangential_projection(normal) / size;
      for (auto &block : derivative)
        block = turn * block;
      return {normal, derivative};
    }
  } // namespace



  std::vector<std::vector<unsigned int>>
  facets_of_nodes(const ContactorSurface<3> &surface)
  {
    std::vector<std::vector<unsigned int>> facets(surface.nodes.size());
    for (unsigned int f = 0; f < surface.faces.size(); ++f)
      for (const unsigned int node : surface.faces[f])
        facets[node].push_back(f);
    return facets;
  }



  FacetStiffness
  facet_stiffness(const ContactorSurface<3>                    &surface,
                  const std::vector<std::vector<unsigned int>> &facets_of_nodes,
                  const std::vector<Point<3>>                  &positions,
                  const FacetPlace                             &place)
  {
    const Patch  patch(surface, facets_of_nodes, positions, place.facet);
    const auto  &corners = surface.faces[place.facet];
    const auto   shape   = bilinear_shape(place.xi, place.eta);
    const auto   by_xi   = bilinear_by_xi(place.eta);
    const auto   by_eta  = bilinear_by_eta(place.xi);
    Tensor<1, 3> y_xi, y_eta, m, m_xi, m_eta;

    // sum_a N_a dn_a, the turn of m in a fixed place
    VectorDerivative turn(patch.n_points());
    for (unsigned int a = 0; a < 4; ++a)
      {
        const Patch::NodeNormal normal = patch.normal(corners[a]);
        add(turn, shape[a], normal.derivative);
        y_xi += by_xi[a] * Tensor<1, 3>(positions[corners[a]]);
        y_eta += by_eta[a] * Tensor<1, 3>(positions[corners[a]]);
        m += shape[a] * normal.value;
        m_xi += by_xi[a] * normal.value;
        m_eta += by_eta[a] * normal.value;
      }
    const double       length = m.norm();
    const Tensor<1, 3> n      = m / length;
    const double       s      = place.gap / length;

    // What moves the point: dx - sum_a N_a dy_a - s sum_a N_a dn_a
    VectorDerivative drive(patch.n_points());
    add(drive, -s, turn);
    const Tensor<2, 3> identity(unit_symmetric_tensor<3>());
    drive[0] += identity;
    for (unsigned int a = 0; a < 4; ++a)
      drive[patch.point(corners[a])] -= shape[a] * identity;

    // dxi and deta, by Cramer's rule
    const Tensor<1, 3> along_xi    = y_xi + s * m_xi;
    const Tensor<1, 3> along_eta   = y_eta + s * m_eta;
    const double       determinant = cross_product_3d(along_xi, along_eta) * m;
    const Tensor<1, 3> to_xi       = place.slides[0] ?
                                       cross_product_3d(along_eta, m) / determinant :
                                       Tensor<1, 3>();
    const Tensor<1, 3> to_eta      = place.slides[1] ?
                                       cross_product_3d(m, along_xi) / determinant :
                                       Tensor<1, 3>();
    ScalarDerivative   dxi, deta;
    for (const auto &block : drive)
      {
        dxi.push_back(to_xi * block);
        deta.push_back(to_eta * block);
      }

    VectorDerivative   dn         = turn;
    const Tensor<2, 3> projection = tangential_projection(n) / length;
    for (unsigned int j = 0; j < dn.size(); ++j)
      dn[j] = projection * (dn[j] + outer_product(m_xi, dxi[j]) +
                            outer_product(m_eta, deta[j]));

    FacetStiffness stiffness;
    stiffness.nodes = patch.nodes;
    stiffness.matrix.reinit(3 * patch.n_points(), 3 * patch.n_points());
    const auto add_row = [&](const unsigned int point, const auto &block_of) {
      for (unsigned int j = 0; j < patch.n_points(); ++j)
        {
          const Tensor<2, 3> block = block_of(j);
          for (unsigned int c = 0; c < 3; ++c)
            for (unsigned int d = 0; d < 3; ++d)
              {
                const double half = 0.5 * block[c][d];
                stiffness.matrix(3 * point + c, 3 * j + d) += half;
                stiffness.matrix(3 * j + d, 3 * point + c) += half;
              }
        }
    };
    add_row(0, [&](const unsigned int j) { return dn[j]; });
    for (unsigned int a = 0; a < 4; ++a)
      add_row(patch.point(corners[a]), [&](const unsigned int j) {
        return -shape[a] * dn[j] -
               outer_product(n, by_xi[a] * dxi[j] + by_eta[a] * deta[j]);
      });
    return stiffness;
  }
} // namespace Signorini
