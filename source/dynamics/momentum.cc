#include <signorini/dynamics/momentum.h>
#include <signorini/input/instantiate.h>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // Place of a node now, and its share of a vector; axisymmetric: only along
    // the axis.
    template <int dim>
    Tensor<1, 3>
    at_node(const Body<dim> &body,
            const Node<dim> &node,
            const DofVector &vector)
    {
      Tensor<1, 3> value;
      for (unsigned int c = 0; c < dim; ++c)
        if (body.formulation() != Formulation::axisymmetric || c == 1)
          value[c] = vector[node.dofs[c]];
      return value;
    }

    void
    add(const Tensor<1, 3> &value, BodyMotion::Vector3 &sum)
    {
      for (unsigned int c = 0; c < 3; ++c)
        sum[c] += value[c];
    }
  } // namespace



  template <int dim>
  std::vector<BodyMotion>
  body_motions(const SolidModel<dim> &solid,
               const DofMatrix       &mass,
               const State           &state)
  {
    DofVector place(state.displacement);
    DofVector one(place.size());
    for (const auto &part : solid.parts())
      for (const auto &node : part.body->nodes())
        for (unsigned int c = 0; c < dim; ++c)
          {
            place[node.dofs[c]] += node.point[c];
            one[node.dofs[c]] = 1.;
          }
    DofVector momentum(place.size()), moment(place.size()),
      weight(place.size());
    mass.vmult(momentum, state.velocity);
    mass.vmult(moment, place);
    mass.vmult(weight, one);

    std::vector<BodyMotion> motions;
    for (const auto &part : solid.parts())
      {
        const Body<dim> &body = *part.body;
        BodyMotion       motion;
        double           total = 0.;
        Tensor<1, 3>     first;
        for (const auto &node : body.nodes())
          {
            const Tensor<1, 3> p = at_node(body, node, momentum);
            add(p, motion.momentum);
            add(cross_product_3d(at_node(body, node, place), p),
                motion.angular_momentum);
            first += at_node(body, node, moment);
            total += weight[node.dofs[dim - 1]];
          }
        add(first / total, motion.centre);
        motions.push_back(motion);
      }
    return motions;
  }



#define INSTANTIATE(dim)                                                 \
  template std::vector<BodyMotion> body_motions(const SolidModel<dim> &, \
                                                const DofMatrix &,       \
                                                const State &);
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
