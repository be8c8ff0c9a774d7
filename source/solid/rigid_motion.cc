#include <signorini/solid/rigid_motion.h>

#include <deal.II/lac/lapack_full_matrix.h>

#include <functional>

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

    // Centre and size of a body, so that arms are of order one.
    template <int dim>
    class Frame
    {
    public:
      explicit Frame(const Body<dim> &body)
      {
        for (const auto &node : body.nodes())
          centre_ += node.point / double(body.nodes().size());
        for (const auto &node : body.nodes())
          scale_ = std::max(scale_, node.point.distance(centre_));
      }

      Tensor<1, 3>
      arm(const Point<dim> &point) const
      {
        Tensor<1, 3> result;
        for (unsigned int d = 0; d < dim; ++d)
          result[d] = (point[d] - centre_[d]) / scale_;
        return result;
      }

    private:
      Point<dim> centre_;
      double     scale_ = 0.;
    };

    // The Gram matrix of the motions at the fixed unknowns: its kernel is what
    // they do not prevent.
    template <int dim>
    FullMatrix<double>
    gram_matrix(const Body<dim>                     &body,
                const std::vector<bool>             &is_fixed,
                const std::vector<SlidingNode<dim>> &sliding_nodes,
                const Frame<dim>                    &frame,
                const std::vector<RigidMotion>      &motions)
    {
      FullMatrix<double> gram(motions.size());
      for (const auto &node : body.nodes())
        for (unsigned int c = 0; c < dim; ++c)
          if (is_fixed[node.dofs[c]])
            for (unsigned int i = 0; i < motions.size(); ++i)
              for (unsigned int j = 0; j < motions.size(); ++j)
                {
                  const auto r = frame.arm(node.point);
                  gram(i, j) += motions[i].value(r, c) * motions[j].value(r, c);
                }
      for (const auto &[node, normal] : sliding_nodes)
        {
          const auto     r = frame.arm(node.point);
          Vector<double> along(motions.size());
          for (unsigned int i = 0; i < motions.size(); ++i)
            for (unsigned int c = 0; c < dim; ++c)
              along[i] += motions[i].value(r, c) * normal[c];
          for (unsigned int i = 0; i < motions.size(); ++i)
            for (unsigned int j = 0; j < motions.size(); ++j)
              gram(i, j) += along[i] * along[j];
        }
      return gram;
    }
  } // namespace



  template <int dim>
  std::string
  free_rigid_motion(const Body<dim>                     &body,
                    const std::vector<bool>             &is_fixed,
                    const std::vector<SlidingNode<dim>> &sliding_nodes)
  {
    const auto               motions = rigid_motions(body.formulation());
    const FullMatrix<double> gram =
      gram_matrix(body, is_fixed, sliding_nodes, Frame<dim>(body), motions);

    // A rotation about a fixed point moves the centre, too: translations count
    // only when they are possible without any rotation.
    const unsigned int n_translations =
      body.formulation() == Formulation::axisymmetric ? 1 : dim;
    const std::vector<bool> translates = free_motions(gram, n_translations);
    const std::vector<bool> moves      = free_motions(gram, motions.size());
    std::string             names;
    for (unsigned int i = 0; i < motions.size(); ++i)
      if (i < n_translations ? translates[i] : moves[i])
        names += (names.empty() ? "" : ", ") + motions[i].name;
    return names;
  }



  template <int dim>
  std::vector<RigidMode>
  free_rigid_modes(const Body<dim>                     &body,
                   const std::vector<bool>             &is_fixed,
                   const std::vector<SlidingNode<dim>> &sliding_nodes)
  {
    const Frame<dim>         frame(body);
    const auto               motions = rigid_motions(body.formulation());
    const FullMatrix<double> gram =
      gram_matrix(body, is_fixed, sliding_nodes, frame, motions);
    LAPACKFullMatrix<double> matrix(motions.size());
    matrix = gram;
    FullMatrix<double> vectors;
    Vector<double>     values;
    matrix.compute_eigenvalues_symmetric(-1., 1e-10, 1e-14, values, vectors);

    // A rotation about a fixed point moves the centre, too: as in
    // free_rigid_motion().
    const unsigned int n_translations =
      body.formulation() == Formulation::axisymmetric ? 1 : dim;
    const std::vector<bool> translates = free_motions(gram, n_translations);

    std::vector<RigidMode> modes;
    for (unsigned int k = 0; k < values.size(); ++k)
      {
        RigidMode mode;
        mode.motion.reinit(is_fixed.size());
        for (unsigned int i = 0; i < motions.size(); ++i)
          {
            if (std::abs(vectors(i, k)) < 1e-6)
              continue;
            if (std::abs(vectors(i, k)) > 0.1 &&
                (i >= n_translations || translates[i]))
              mode.name += (mode.name.empty() ? "" : ", ") + motions[i].name;
            for (const auto &node : body.nodes())
              for (unsigned int c = 0; c < dim; ++c)
                mode.motion[node.dofs[c]] +=
                  vectors(i, k) * motions[i].value(frame.arm(node.point), c);
          }
        modes.push_back(mode);
      }
    return modes;
  }



  template std::string
  free_rigid_motion(const Body<2> &,
                    const std::vector<bool> &,
                    const std::vector<SlidingNode<2>> &);
  template std::string
  free_rigid_motion(const Body<3> &,
                    const std::vector<bool> &,
                    const std::vector<SlidingNode<3>> &);
  template std::vector<RigidMode>
  free_rigid_modes(const Body<2> &,
                   const std::vector<bool> &,
                   const std::vector<SlidingNode<2>> &);
  template std::vector<RigidMode>
  free_rigid_modes(const Body<3> &,
                   const std::vector<bool> &,
                   const std::vector<SlidingNode<3>> &);
} // namespace Signorini
