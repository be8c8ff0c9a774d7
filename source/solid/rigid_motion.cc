#include <signorini/input/instantiate.h>
#include <signorini/solid/connected_parts.h>
#include <signorini/solid/rigid_motion.h>

#include <deal.II/lac/lapack_full_matrix.h>

#include <functional>
#include <map>
#include <sstream>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    struct RigidMotion
    {
      std::string name;
      // Component c of the motion of a point, both in the centre's frame.
      std::function<double(const Tensor<1, 3> &, const unsigned int)> value;
    };

    RigidMotion
    translation(const unsigned int direction)
    {
      return {std::string("translation along ") +
                static_cast<char>('x' + direction),
              [direction](const Tensor<1, 3> &, const unsigned int c) {
                return c == direction ? 1. : 0.;
              }};
    }

    RigidMotion
    rotation(const unsigned int axis)
    {
      return {std::string("rotation about ") + static_cast<char>('x' + axis),
              [axis](const Tensor<1, 3> &arm, const unsigned int c) {
                Tensor<1, 3> omega;
                omega[axis] = 1.;
                return cross_product_3d(omega, arm)[c];
              }};
    }

    std::vector<RigidMotion>
    rigid_motions(const Formulation formulation)
    {
      switch (formulation)
        {
          case Formulation::axisymmetric:
            return {translation(1)};
          case Formulation::three_dimensional:
            return {translation(0),
                    translation(1),
                    translation(2),
                    rotation(0),
                    rotation(1),
                    rotation(2)};
          default:
            return {translation(0), translation(1), rotation(2)};
        }
    }

    // Which of the first n motions take part in one that the fixed unknowns
    // leave free, when the others are forbidden: the kernel of a Gram matrix.
    std::vector<bool>
    free_motions(const FullMatrix<double> &gram, const unsigned int n)
    {
      LAPACKFullMatrix<double> matrix(n);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          matrix(i, j) = gram(i, j);
      FullMatrix<double> vectors;
      Vector<double>     values;
      matrix.compute_eigenvalues_symmetric(-1., 1e-10, 1e-14, values, vectors);
      std::vector<bool> is_free(n);
      for (unsigned int k = 0; k < values.size(); ++k)
        for (unsigned int i = 0; i < n; ++i)
          is_free[i] = is_free[i] || std::abs(vectors(i, k)) > 0.1;
      return is_free;
    }

    // The nodes of one part where they are now, in a frame in which arms are of
    // order one.
    template <int dim>
    struct PlacedPart
    {
      PlacedPart(const std::vector<Node<dim>> &part_nodes,
                 const DofVector              &displacement)
        : nodes(part_nodes)
      {
        for (Node<dim> &node : nodes)
          {
            for (unsigned int c = 0; c < dim; ++c)
              node.point[c] += displacement[node.dofs[c]];
            centre += node.point / double(nodes.size());
          }
        for (const auto &node : nodes)
          size = std::max(size, node.point.distance(centre));
      }

      Tensor<1, 3>
      arm(const Point<dim> &point) const
      {
        Tensor<1, 3> result;
        for (unsigned int d = 0; d < dim; ++d)
          result[d] = (point[d] - centre[d]) / size;
        return result;
      }

      std::vector<Node<dim>> nodes;
      Point<dim>             centre;
      double                 size = 0.; // m
    };

    // gram += v v^T for the values v of all motions along a direction.
    void
    add_to_gram(const std::vector<double> &values, FullMatrix<double> &gram)
    {
      for (unsigned int i = 0; i < values.size(); ++i)
        for (unsigned int j = 0; j < values.size(); ++j)
          gram(i, j) += values[i] * values[j];
    }

    // The Gram matrix of the motions at the fixed unknowns: its kernel is what
    // they do not prevent.
    template <int dim>
    FullMatrix<double>
    gram_matrix(const PlacedPart<dim>               &part,
                const DofMap                        &dof_map,
                const std::vector<SlidingNode<dim>> &sliding_nodes,
                const std::vector<RigidMotion>      &motions)
    {
      FullMatrix<double> gram(motions.size());
      const auto         values_along = [&](const Node<dim>      &node,
                                    const Tensor<1, dim> &direction) {
        const auto          arm = part.arm(node.point);
        std::vector<double> values(motions.size(), 0.);
        for (unsigned int i = 0; i < motions.size(); ++i)
          for (unsigned int c = 0; c < dim; ++c)
            values[i] += motions[i].value(arm, c) * direction[c];
        return values;
      };
      std::map<unsigned int, Tensor<1, dim>> normals; // by the first unknown
      for (const auto &[node, normal] : sliding_nodes)
        normals[node.dofs[0]] = normal;
      for (const auto &node : part.nodes)
        {
          for (unsigned int c = 0; c < dim; ++c)
            if (dof_map.is_prescribed(node.dofs[c]))
              {
                Tensor<1, dim> direction;
                direction[c] = 1.;
                add_to_gram(values_along(node, direction), gram);
              }
          const auto sliding = normals.find(node.dofs[0]);
          if (sliding != normals.end())
            add_to_gram(values_along(node, sliding->second), gram);
        }
      return gram;
    }

    template <int dim>
    void
    add_free_modes(const PlacedPart<dim>               &part,
                   const Formulation                    formulation,
                   const DofMap                        &dof_map,
                   const std::vector<SlidingNode<dim>> &sliding_nodes,
                   const std::string                   &where,
                   std::vector<RigidMode>              &modes)
    {
      const auto               motions = rigid_motions(formulation);
      const FullMatrix<double> gram =
        gram_matrix(part, dof_map, sliding_nodes, motions);
      LAPACKFullMatrix<double> matrix(motions.size());
      matrix = gram;
      FullMatrix<double> vectors;
      Vector<double>     values;
      matrix.compute_eigenvalues_symmetric(-1., 1e-10, 1e-14, values, vectors);

      // A rotation about a fixed point moves the centre, too: translations
      // count only when they are possible without any rotation.
      const unsigned int n_translations =
        formulation == Formulation::axisymmetric ? 1 : dim;
      const std::vector<bool> translates = free_motions(gram, n_translations);

      for (unsigned int k = 0; k < values.size(); ++k)
        {
          RigidMode mode;
          mode.motion.reinit(dof_map.size());
          for (unsigned int i = 0; i < motions.size(); ++i)
            {
              if (std::abs(vectors(i, k)) < 1e-6)
                continue;
              if (std::abs(vectors(i, k)) > 0.1 &&
                  (i >= n_translations || translates[i]))
                mode.name += (mode.name.empty() ? "" : ", ") + motions[i].name;
              for (const auto &node : part.nodes)
                for (unsigned int c = 0; c < dim; ++c)
                  mode.motion[node.dofs[c]] +=
                    vectors(i, k) * motions[i].value(part.arm(node.point), c);
            }
          mode.name += where;
          modes.push_back(mode);
        }
    }
  } // namespace



  template <int dim>
  std::vector<RigidMode>
  free_rigid_modes(const Body<dim>                     &body,
                   const DofVector                     &displacement,
                   const DofMap                        &dof_map,
                   const std::vector<SlidingNode<dim>> &sliding_nodes)
  {
    const auto             parts = connected_parts(body);
    std::vector<RigidMode> modes;
    for (const auto &nodes : parts)
      {
        const PlacedPart<dim> part(nodes, displacement);
        std::ostringstream    where;
        if (parts.size() > 1)
          where << " of its part around (" << part.centre << ")";
        add_free_modes(
          part, body.formulation(), dof_map, sliding_nodes, where.str(), modes);
      }
    return modes;
  }



#define INSTANTIATE(dim)                            \
  template std::vector<RigidMode> free_rigid_modes( \
    const Body<dim> &,                              \
    const DofVector &,                              \
    const DofMap &,                                 \
    const std::vector<SlidingNode<dim>> &);
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
