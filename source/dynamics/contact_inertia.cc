#include <signorini/dynamics/contact_inertia.h>
#include <signorini/input/instantiate.h>
#include <signorini/solid/nodal_acceleration.h>

#include <deal.II/lac/full_matrix.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    constexpr double steps_ahead = 2.;

    // The rigid motions of a body where it is now, as far as its supports do
    // not prevent them component by component.
    template <int dim>
    std::vector<DofVector>
    rigid_motions(const SolidModel<dim>                &solid,
                  const typename SolidModel<dim>::Part &part,
                  const DofVector                      &displacement)
    {
      const Body<dim>      &body = *part.body;
      std::array<bool, dim> is_free;
      is_free.fill(part.supports.sliding_nodes().empty());
      for (const auto &node : body.nodes())
        for (unsigned int c = 0; c < dim; ++c)
          is_free[c] =
            is_free[c] && !solid.dof_map().is_prescribed(node.dofs[c]);
      const bool is_round = body.formulation() == Formulation::axisymmetric;
      if (is_round)
        is_free[0] = false;

      std::vector<DofVector> motions;
      const auto             add = [&](const auto &value) {
        motions.emplace_back(displacement.size());
        for (const auto &node : body.nodes())
          for (unsigned int c = 0; c < dim; ++c)
            motions.back()[node.dofs[c]] = value(node, c);
      };
      for (unsigned int d = 0; d < dim; ++d)
        if (is_free[d])
          add([&](const Node<dim> &, const unsigned int c) {
            return c == d ? 1. : 0.;
          });
      // About the middle, so that the motions are nearly independent
      Point<dim> middle;
      for (const auto &node : body.nodes())
        middle += node.point / double(body.nodes().size());
      for (unsigned int a = 0; a < dim; ++a)
        for (unsigned int b = a + 1; b < dim; ++b)
          if (is_free[a] && is_free[b])
            add([&](const Node<dim> &node, const unsigned int c) {
              const unsigned int from = c == a ? b : a;
              if (c != a && c != b)
                return 0.;
              const double arm =
                node.point[from] - middle[from] + displacement[node.dofs[from]];
              return c == a ? -arm : arm;
            });
      return motions;
    }

    // Coefficients a with R^T M R a = right side.
    DofVector
    coefficients(const std::vector<DofVector> &motions,
                 const DofMatrix              &mass,
                 const DofVector              &right_side)
    {
      FullMatrix<double> gram(motions.size());
      for (unsigned int i = 0; i < motions.size(); ++i)
        for (unsigned int j = 0; j < motions.size(); ++j)
          gram(i, j) = mass.matrix_scalar_product(motions[i], motions[j]);
      gram.gauss_jordan();
      DofVector result(motions.size());
      gram.vmult(result, right_side);
      return result;
    }

    // R^T M v.
    DofVector
    momenta(const std::vector<DofVector> &motions,
            const DofMatrix              &mass,
            const DofVector              &velocity)
    {
      DofVector product(velocity.size()), result(motions.size());
      mass.vmult(product, velocity);
      for (unsigned int i = 0; i < motions.size(); ++i)
        result[i] = motions[i] * product;
      return result;
    }

    // v += R x.
    void
    add(const std::vector<DofVector> &motions,
        const DofVector              &coefficients,
        const double                  factor,
        DofVector                    &velocity)
    {
      for (unsigned int i = 0; i < motions.size(); ++i)
        velocity.add(factor * coefficients[i], motions[i]);
    }

    // Changes the rigid part of v such that R^T M' v' = R^T M v.
    void
    keep_momenta(const std::vector<DofVector> &motions,
                 const DofMatrix              &old_mass,
                 const DofMatrix              &mass,
                 const DofVector              &old_velocity,
                 DofVector                    &velocity)
    {
      if (motions.empty())
        return;
      DofVector change = momenta(motions, old_mass, old_velocity);
      change -= momenta(motions, mass, velocity);
      add(motions, coefficients(motions, mass, change), 1., velocity);
    }

    // v' = g + s f with the energy 1/2 v'.M v' and s near 1; s = 1 if there is
    // none.
    void
    keep_energy(const DofMatrix &mass,
                const double     energy,
                const DofVector &moving,
                DofVector       &velocity)
    {
      DofVector rest(velocity);
      rest -= moving;
      const double a = 0.5 * mass.matrix_norm_square(moving);
      const double b = mass.matrix_scalar_product(rest, moving);
      const double c = 0.5 * mass.matrix_norm_square(rest) - energy;
      // Rounding is no motion.
      if (a <= 1e-14 * energy)
        return;
      const double discriminant = b * b - 4. * a * c;
      if (discriminant < 0.)
        return;
      const double middle = -0.5 * b / a,
                   half   = 0.5 * std::sqrt(discriminant) / a;
      const double s =
        std::abs(middle + half - 1.) < std::abs(middle - half - 1.) ?
          middle + half :
          middle - half;
      if (std::abs(s - 1.) < 0.5)
        velocity.add(s - 1., moving);
    }

    // The part of a vector that belongs to the unknowns of a body, or to those
    // of them that the solution moves.
    template <int dim, typename Predicate>
    DofVector
    part_of(const Body<dim> &body,
            const DofVector &vector,
            const Predicate &belongs)
    {
      DofVector result(vector.size());
      for (unsigned int i = body.first_dof();
           i < body.first_dof() + body.n_dofs();
           ++i)
        if (belongs(i))
          result[i] = vector[i];
      return result;
    }
  } // namespace



  template <int dim>
  ContactInertia<dim>::ContactInertia(const SolidModel<dim>   &solid,
                                      const ContactModel<dim> &contact,
                                      const bool               redistributes)
    : solid_(solid)
    , contact_(contact)
    , redistributes_(redistributes)
    , node_of_unknown_(solid.n_dofs(), numbers::invalid_unsigned_int)
  {
    for (const auto &part : solid.parts())
      for (const auto &node : part.body->nodes())
        for (const unsigned int dof : node.dofs)
          node_of_unknown_[dof] = node.dofs[0];
  }



  template <int dim>
  const typename ContactInertia<dim>::Mass &
  ContactInertia<dim>::mass(const State &state)
  {
    if (!mass_ || massless_nodes_ != state.massless_nodes)
      {
        mass_           = solid_.redistribute_mass(state.massless_nodes);
        massless_nodes_ = state.massless_nodes;
      }
    return *mass_;
  }



  template <int dim>
  void
  ContactInertia<dim>::add_massive(const ContactPair<dim>    &pair,
                                   const State               &state,
                                   std::vector<unsigned int> &nodes) const
  {
    const auto add = [&](const unsigned int unknown) {
      const unsigned int node = node_of_unknown_[unknown];
      if (node != numbers::invalid_unsigned_int &&
          !std::binary_search(state.massless_nodes.begin(),
                              state.massless_nodes.end(),
                              node))
        nodes.push_back(node);
    };
    for (const auto &node : pair.contactor.nodes)
      add(node.dofs[0]);
    for (const unsigned int unknown : pair.target->unknowns())
      add(unknown);
  }



  template <int dim>
  std::vector<unsigned int>
  ContactInertia<dim>::near(const std::vector<ContactPoint<dim>> &points,
                            const State                          &state,
                            const double distance) const
  {
    return of_pairs(state, [&](const unsigned int k) {
      return points[k].is_in_reach() && points[k].gap <= distance;
    });
  }



  template <int dim>
  std::vector<unsigned int>
  ContactInertia<dim>::approaching(const std::vector<ContactPoint<dim>> &points,
                                   const State                          &state,
                                   const double step_size) const
  {
    const double smallest_gap = 1e-12 * contact_.extent();
    return of_pairs(state, [&](const unsigned int k) {
      const auto &point = points[k];
      return point.is_in_reach() &&
             point.gap + std::min(0.,
                                  steps_ahead * step_size *
                                    point.gap_gradient.dot(state.velocity)) <=
               smallest_gap;
    });
  }



  template <int dim>
  std::vector<unsigned int>
  ContactInertia<dim>::pressed(const InterfaceForces &forces,
                               const State           &state) const
  {
    return of_pairs(state, [&](const unsigned int k) {
      return forces.normal[k] > 0.;
    });
  }



  template <int dim>
  std::vector<unsigned int>
  ContactInertia<dim>::of_pairs(
    const State                                   &state,
    const std::function<bool(const unsigned int)> &is_close) const
  {
    std::vector<unsigned int> nodes;
    if (!redistributes_ || state.keeps_mass)
      return nodes;
    for (const auto &pair : contact_.pairs())
      for (unsigned int n = 0; n < pair.contactor.nodes.size(); ++n)
        if (is_close(pair.first_contact + n))
          {
            add_massive(pair, state, nodes);
            break;
          }
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
  }



  template <int dim>
  State
  ContactInertia<dim>::take_mass(const State                     &state,
                                 const std::vector<unsigned int> &nodes)
  {
    // Kept, since mass() makes a new one.
    DofMatrix old_mass(solid_.sparsity());
    old_mass.copy_from(mass(state).matrix);

    State result = state;
    auto &all    = result.massless_nodes;
    all.insert(all.end(), nodes.begin(), nodes.end());
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    const Mass      &new_mass = mass(result);
    const DofMatrix &matrix   = new_mass.matrix;

    const std::set<unsigned int> new_nodes(nodes.begin(), nodes.end());
    if (result.handed_over.size() == 0)
      result.handed_over.reinit(solid_.n_dofs());
    for (unsigned int i = 0; i < solid_.dof_map().n_body_dofs(); ++i)
      if (new_nodes.count(node_of_unknown_[i]) > 0 &&
          new_mass.redistribution.is_massless(i))
        {
          result.handed_over[i] +=
            result.external_force[i] - result.internal_force[i];
          result.internal_force[i] -= result.external_force[i];
          new_mass.redistribution.hand_over(i, result.internal_force);
          result.internal_force[i] = result.external_force[i];
        }
    // So do the forces of inertia.
    DofVector inertia(solid_.n_dofs());
    old_mass.vmult(inertia, state.acceleration);
    for (unsigned int i = 0; i < solid_.dof_map().n_body_dofs(); ++i)
      if (new_nodes.count(node_of_unknown_[i]) > 0 &&
          new_mass.redistribution.is_massless(i))
        new_mass.redistribution.hand_over(i, inertia);
    accelerate(matrix, solid_.dof_map(), inertia, result.acceleration);
    solid_.dof_map().constraints().distribute(result.acceleration);
    new_mass.redistribution.extrapolate(result.acceleration);

    new_mass.redistribution.extrapolate(result.velocity);
    keep_motion(old_mass, matrix, nodes, state.velocity, result);
    solid_.dof_map().constraints().distribute(result.velocity);
    new_mass.redistribution.extrapolate(result.velocity);
    return result;
  }



  template <int dim>
  State
  ContactInertia<dim>::give_mass(const State &state)
  {
    DofMatrix old_mass(solid_.sparsity());
    old_mass.copy_from(mass(state).matrix);
    State result = state;
    result.massless_nodes.clear();
    result.keeps_mass       = true;
    const DofMatrix &matrix = mass(result).matrix;

    // What had no mass was in balance: the forces of inertia stay.
    DofVector inertia(solid_.n_dofs());
    old_mass.vmult(inertia, state.acceleration);
    accelerate(matrix, solid_.dof_map(), inertia, result.acceleration);
    solid_.dof_map().constraints().distribute(result.acceleration);
    keep_motion(old_mass, matrix, state.massless_nodes, state.velocity, result);
    solid_.dof_map().constraints().distribute(result.velocity);
    return result;
  }



  template <int dim>
  void
  ContactInertia<dim>::keep_motion(const DofMatrix                 &old_mass,
                                   const DofMatrix                 &mass,
                                   const std::vector<unsigned int> &nodes,
                                   const DofVector &old_velocity,
                                   State           &result) const
  {
    for (const auto &part : solid_.parts())
      {
        const Body<dim> &body    = *part.body;
        const auto       all_of  = [](const unsigned int) { return true; };
        const auto       free_of = [&](const unsigned int i) {
          return !solid_.dof_map().is_constrained(i);
        };
        if (std::none_of(nodes.begin(), nodes.end(), [&](const auto node) {
              return node >= body.first_dof() &&
                     node < body.first_dof() + body.n_dofs();
            }))
          continue;
        const auto motions = rigid_motions(solid_, part, result.displacement);
        keep_momenta(motions, old_mass, mass, old_velocity, result.velocity);

        const DofVector before = part_of(body, old_velocity, all_of);
        DofVector       now    = part_of(body, result.velocity, all_of);
        const DofVector others = [&] {
          DofVector rest(result.velocity);
          rest -= now;
          return rest;
        }();
        DofVector moving = part_of(body, now, free_of);
        if (!motions.empty())
          add(motions,
              coefficients(motions, mass, momenta(motions, mass, moving)),
              -1.,
              moving);
        keep_energy(mass,
                    0.5 * old_mass.matrix_norm_square(before),
                    moving,
                    now);
        result.velocity = now;
        result.velocity += others;
      }
  }



#define INSTANTIATE(dim) template class ContactInertia<dim>;
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
