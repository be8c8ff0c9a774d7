#include <signorini/input/input_error.h>
#include <signorini/input/instantiate.h>
#include <signorini/solid/mass_redistribution.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <limits>
#include <set>
#include <sstream>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // Which nodes share a cell, by their index in Body::nodes().
    template <int dim>
    class NodeGraph
    {
    public:
      explicit NodeGraph(const Body<dim> &body)
        : node_of_dof_(body.n_dofs())
        , cells_of_node_(body.nodes().size())
      {
        for (unsigned int n = 0; n < body.nodes().size(); ++n)
          for (const unsigned int dof : body.nodes()[n].dofs)
            node_of_dof_[dof - body.first_dof()] = n;
        std::vector<types::global_dof_index> indices(
          body.fe().n_dofs_per_cell());
        for (const auto &cell : body.dof_handler().active_cell_iterators())
          {
            cell->get_dof_indices(indices);
            std::vector<unsigned int> nodes;
            for (unsigned int a = 0; a < body.scalar_fe().n_dofs_per_cell();
                 ++a)
              nodes.push_back(
                node_of_dof_[indices[body.fe().component_to_system_index(0,
                                                                         a)]]);
            for (const unsigned int node : nodes)
              cells_of_node_[node].push_back(nodes_of_cell_.size());
            nodes_of_cell_.push_back(std::move(nodes));
          }
      }

      unsigned int
      node_of_dof(const unsigned int local_dof) const
      {
        return node_of_dof_[local_dof];
      }

      std::set<unsigned int>
      widen(const std::set<unsigned int> &nodes) const
      {
        std::set<unsigned int> result(nodes);
        for (const unsigned int node : nodes)
          for (const unsigned int cell : cells_of_node_[node])
            result.insert(nodes_of_cell_[cell].begin(),
                          nodes_of_cell_[cell].end());
        return result;
      }

    private:
      std::vector<unsigned int>              node_of_dof_;
      std::vector<std::vector<unsigned int>> cells_of_node_;
      std::vector<std::vector<unsigned int>> nodes_of_cell_;
    };

    // Inner nodes and their weights.
    template <int dim>
    struct Weights
    {
      std::vector<Node<dim>> donors;
      std::vector<double>    of_donor;
    };

    // The weights of component c.
    template <int dim>
    MassRedistribution::Row
    row(const Weights<dim> &weights, const unsigned int c)
    {
      MassRedistribution::Row result;
      for (unsigned int j = 0; j < weights.donors.size(); ++j)
        if (std::abs(weights.of_donor[j]) > 1e-14)
          result.emplace_back(weights.donors[j].dofs[c], weights.of_donor[j]);
      return result;
    }

    // Weights that fall so steeply with the distance that on a regular mesh the
    // node across the cell is the only one, while equally near ones share.
    template <int dim>
    std::vector<double>
    nearest_weights(const Point<dim>             &point,
                    const std::vector<Node<dim>> &donors)
    {
      double nearest = std::numeric_limits<double>::max();
      for (const auto &donor : donors)
        nearest = std::min(nearest, donor.point.distance(point));
      std::vector<double> weights;
      double              sum = 0.;
      for (const auto &donor : donors)
        {
          const double weight =
            std::pow(nearest / donor.point.distance(point), 12);
          weights.push_back(weight < 0.05 ? 0. : weight);
          sum += weights.back();
        }
      for (double &weight : weights)
        weight /= sum;
      return weights;
    }

    // The weights w of least sum d_j^4 w_j^2 with sum w_j = 1 and
    // sum w_j (x_j - x) = 0; empty when the points do not span the space. The
    // fourth power makes the nearest nodes carry nearly all.
    template <int dim>
    std::vector<double>
    affine_weights(const Point<dim>             &point,
                   const std::vector<Node<dim>> &donors)
    {
      if (donors.size() < dim + 1)
        return {};
      double scale = 0.;
      for (const auto &donor : donors)
        scale = std::max(scale, donor.point.distance(point));

      // Columns (1, (x_j - x)/scale) times 1/d^4, and their normal matrix.
      constexpr unsigned int m = dim + 1;
      FullMatrix<double>     normal(m, m);
      FullMatrix<double>     columns(donors.size(), m);
      std::vector<double>    importance(donors.size());
      for (unsigned int j = 0; j < donors.size(); ++j)
        {
          const Tensor<1, dim> arm = (donors[j].point - point) / scale;
          importance[j]            = 1. / std::pow(arm.norm(), 4);
          columns(j, 0)            = 1.;
          for (unsigned int d = 0; d < dim; ++d)
            columns(j, d + 1) = arm[d];
          for (unsigned int r = 0; r < m; ++r)
            for (unsigned int s = 0; s < m; ++s)
              normal(r, s) += importance[j] * columns(j, r) * columns(j, s);
        }
      LAPACKFullMatrix<double> spectrum(m);
      spectrum = normal;
      spectrum.compute_svd();
      if (spectrum.singular_value(m - 1) < 1e-10 * spectrum.singular_value(0))
        return {};
      FullMatrix<double> inverse(normal);
      inverse.gauss_jordan();

      std::vector<double> weights(donors.size(), 0.);
      for (unsigned int j = 0; j < donors.size(); ++j)
        for (unsigned int r = 0; r < m; ++r)
          weights[j] += importance[j] * columns(j, r) * inverse(r, 0);
      return weights;
    }

    template <int dim>
    [[noreturn]] void
    throw_too_thin(const Body<dim> &body, const Point<dim> &point)
    {
      std::ostringstream message;
      message << "the contact node at (" << point
              << ") has too few inner nodes around it to carry its mass. "
                 "Contact mass = redistributed needs two layers of cells "
                 "behind a contact boundary: refine the mesh, name fewer "
                 "boundaries in the contact pairs, or set Time / Contact mass "
                 "= consistent.";
      throw InputError("Body " + body.name(), message.str());
    }
  } // namespace



  template <int dim>
  void
  MassRedistribution::add(const Body<dim>              &body,
                          const std::vector<Node<dim>> &contact_nodes,
                          const DofMap                 &dof_map)
  {
    const NodeGraph<dim>   graph(body);
    std::set<unsigned int> massless;
    for (const auto &node : contact_nodes)
      if (!dof_map.is_hanging(node.dofs[0]))
        massless.insert(graph.node_of_dof(node.dofs[0] - body.first_dof()));

    for (const unsigned int contact : massless)
      {
        const Node<dim>       &node       = body.nodes()[contact];
        std::set<unsigned int> neighbours = {contact};
        Weights<dim>           nearest, affine;
        for (unsigned int layer = 1; layer <= 3 && affine.of_donor.empty();
             ++layer)
          {
            neighbours = graph.widen(neighbours);
            Weights<dim> weights;
            for (const unsigned int candidate : neighbours)
              if (massless.count(candidate) == 0 &&
                  !dof_map.is_hanging(body.nodes()[candidate].dofs[0]))
                weights.donors.push_back(body.nodes()[candidate]);
            if (nearest.of_donor.empty())
              nearest = {weights.donors,
                         nearest_weights(node.point, weights.donors)};
            affine = {weights.donors,
                      affine_weights(node.point, weights.donors)};
          }
        if (nearest.of_donor.empty())
          throw_too_thin(body, node.point);
        if (affine.of_donor.empty())
          affine = nearest;
        for (unsigned int c = 0; c < dim; ++c)
          if (!dof_map.is_constrained(node.dofs[c]))
            {
              rows_[node.dofs[c]]      = row(affine, c);
              receivers_[node.dofs[c]] = row(nearest, c);
            }
      }
  }



  void
  MassRedistribution::extend(DynamicSparsityPattern &pattern) const
  {
    SparsityPattern original;
    original.copy_from(pattern);
    for (const auto &[massless, row] : rows_)
      for (unsigned int entry = 0; entry < original.row_length(massless);
           ++entry)
        {
          const unsigned int column = original.column_number(massless, entry);
          const auto         other  = rows_.find(column);
          for (const auto &[i, weight_i] : row)
            if (other == rows_.end())
              {
                pattern.add(i, column);
                pattern.add(column, i);
              }
            else
              for (const auto &[j, weight_j] : other->second)
                pattern.add(i, j);
        }
  }



  void
  MassRedistribution::congruence(const DofMatrix &matrix,
                                 DofMatrix       &result) const
  {
    const auto row_of = [&](const unsigned int dof) -> Row {
      const auto found = rows_.find(dof);
      return found == rows_.end() ? Row{{dof, 1.}} : found->second;
    };
    result = 0.;
    for (unsigned int i = 0; i < matrix.m(); ++i)
      {
        const Row row = row_of(i);
        for (auto entry = matrix.begin(i); entry != matrix.end(i); ++entry)
          if (entry->value() != 0.)
            {
              if (row.size() == 1 && row[0].first == i &&
                  !is_massless(entry->column()))
                result.add(i, entry->column(), entry->value());
              else
                for (const auto &[k, weight_k] : row)
                  for (const auto &[l, weight_l] : row_of(entry->column()))
                    result.add(k, l, weight_k * entry->value() * weight_l);
            }
      }
  }



  void
  MassRedistribution::move_mass(DofMatrix &mass) const
  {
    // What a massless unknown loses: its row and column, where they meet once.
    std::map<unsigned int, double> lost;
    for (const auto &[massless, row] : rows_)
      for (auto entry = mass.begin(massless); entry != mass.end(massless);
           ++entry)
        lost[massless] +=
          is_massless(entry->column()) ? entry->value() : 2. * entry->value();
    for (unsigned int i = 0; i < mass.m(); ++i)
      for (auto entry = mass.begin(i); entry != mass.end(i); ++entry)
        if (is_massless(i) || is_massless(entry->column()))
          entry->value() = 0.;
    for (const auto &[massless, shares] : receivers_)
      for (const auto &[dof, share] : shares)
        mass.diag_element(dof) += share * lost[massless];
  }



  void
  MassRedistribution::hand_over(const unsigned int massless,
                                DofVector         &force) const
  {
    for (const auto &[dof, weight] : rows_.at(massless))
      force[dof] += weight * force[massless];
    force[massless] = 0.;
  }



  void
  MassRedistribution::extrapolate(DofVector &vector) const
  {
    for (const auto &[massless, row] : rows_)
      {
        double value = 0.;
        for (const auto &[dof, weight] : row)
          value += weight * vector[dof];
        vector[massless] = value;
      }
  }



  void
  MassRedistribution::clear_massless(DofVector &vector) const
  {
    for (const auto &[massless, row] : rows_)
      vector[massless] = 0.;
  }



#define INSTANTIATE(dim)                                                \
  template void MassRedistribution::add(const Body<dim> &,              \
                                        const std::vector<Node<dim>> &, \
                                        const DofMap &);
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
