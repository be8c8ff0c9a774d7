#include <signorini/input/instantiate.h>
#include <signorini/solid/mass_moments.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <limits>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // q below it would take away nearly all mass of a node.
    constexpr double largest_loss = 0.7;

    // One component of the unknowns of a body: the functions 1, X_c and their
    // products at its nodes, in a frame in which they are of order one.
    template <int dim>
    class Component
    {
    public:
      static constexpr unsigned int n_affine  = dim + 1;
      static constexpr unsigned int n_moments = n_affine * (n_affine + 1) / 2;
      using Functions                         = std::array<double, n_affine>;
      using Moments                           = std::array<double, n_moments>;

      Component(const Body<dim> &body, const unsigned int component)
        : first_(body.first_dof())
        , node_(body.n_dofs(), numbers::invalid_unsigned_int)
      {
        Point<dim> centre;
        for (const auto &node : body.nodes())
          centre += node.point / double(body.nodes().size());
        double size = 0.;
        for (const auto &node : body.nodes())
          size = std::max(size, node.point.distance(centre));
        for (const auto &node : body.nodes())
          {
            const Tensor<1, dim> arm = (node.point - centre) / size;
            Functions            values;
            values[0] = 1.;
            for (unsigned int d = 0; d < dim; ++d)
              values[d + 1] = arm[d];
            node_[node.dofs[component] - first_] = affine_.size();
            affine_.push_back(values);
            unknowns_.push_back(node.dofs[component]);
          }
      }

      const std::vector<unsigned int> &
      unknowns() const
      {
        return unknowns_;
      }

      // f(i, j, entry) for all entries within the component.
      template <typename Matrix, typename Function>
      void
      for_each_entry(Matrix &matrix, const Function &f) const
      {
        for (unsigned int i = 0; i < unknowns_.size(); ++i)
          for (auto entry = matrix.begin(unknowns_[i]);
               entry != matrix.end(unknowns_[i]);
               ++entry)
            {
              const unsigned int column = entry->column() - first_;
              if (column < node_.size() &&
                  node_[column] != numbers::invalid_unsigned_int)
                f(i, node_[column], *entry);
            }
      }

      // a(i) b(j) of all pairs of functions, symmetric in them.
      Moments
      products(const unsigned int i, const unsigned int j) const
      {
        Moments      result;
        unsigned int m = 0;
        for (unsigned int a = 0; a < n_affine; ++a)
          for (unsigned int b = a; b < n_affine; ++b, ++m)
            result[m] = 0.5 * (affine_[i][a] * affine_[j][b] +
                               affine_[i][b] * affine_[j][a]);
        return result;
      }

      Moments
      moments(const SparseMatrix<double> &mass) const
      {
        Moments sum{};
        for_each_entry(mass,
                       [&](const unsigned int i,
                           const unsigned int j,
                           const auto        &entry) {
                         const Moments product = products(i, j);
                         for (unsigned int m = 0; m < n_moments; ++m)
                           sum[m] += entry.value() * product[m];
                       });
        return sum;
      }

      // d moments / d coefficients of q.
      FullMatrix<double>
      derivative(const SparseMatrix<double> &mass) const
      {
        std::vector<Moments> monomials;
        for (unsigned int i = 0; i < unknowns_.size(); ++i)
          monomials.push_back(products(i, i));
        FullMatrix<double> result(n_moments);
        for_each_entry(
          mass,
          [&](const unsigned int i, const unsigned int j, const auto &entry) {
            if (entry.value() == 0.)
              return;
            const Moments product = products(i, j);
            for (unsigned int m = 0; m < n_moments; ++m)
              for (unsigned int n = 0; n < n_moments; ++n)
                result(m, n) += 0.5 * entry.value() * product[m] *
                                (monomials[i][n] + monomials[j][n]);
          });
        return result;
      }

      // q at the nodes.
      std::vector<double>
      values(const Vector<double> &coefficients) const
      {
        std::vector<double> result;
        for (unsigned int i = 0; i < unknowns_.size(); ++i)
          {
            const Moments monomials = products(i, i);
            double        sum       = 0.;
            for (unsigned int m = 0; m < n_moments; ++m)
              sum += coefficients[m] * monomials[m];
            result.push_back(sum);
          }
        return result;
      }

    private:
      unsigned int              first_;
      std::vector<unsigned int> node_; // of each unknown of the body
      std::vector<unsigned int> unknowns_;
      std::vector<Functions>    affine_;
    };

    // The shortest solution of least squares; what the matrix cannot reach is
    // left out.
    Vector<double>
    solve(const FullMatrix<double> &matrix, const Vector<double> &right_side)
    {
      LAPACKFullMatrix<double> inverse(matrix.m());
      inverse = matrix;
      inverse.compute_inverse_svd(1e-10);
      Vector<double> solution(right_side.size());
      inverse.vmult(solution, right_side);
      return solution;
    }
  } // namespace



  template <int dim>
  bool
  keep_moments(const Body<dim>            &body,
               const SparseMatrix<double> &original,
               const MassRedistribution   &redistribution,
               SparseMatrix<double>       &mass)
  {
    bool all_kept = true;
    for (unsigned int c = 0; c < dim; ++c)
      {
        const Component<dim> component(body, c);
        const auto          &unknowns = component.unknowns();
        if (std::none_of(unknowns.begin(), unknowns.end(), [&](const auto dof) {
              return redistribution.is_massless(dof);
            }))
          continue;
        const auto     wanted = component.moments(original);
        const auto     found  = component.moments(mass);
        Vector<double> missing(wanted.size());
        for (unsigned int m = 0; m < wanted.size(); ++m)
          missing[m] = (wanted[m] - found[m]) / wanted[0];
        FullMatrix<double> derivative = component.derivative(mass);
        derivative *= 1. / wanted[0];
        const Vector<double> coefficients = solve(derivative, missing);
        std::vector<double>  change       = component.values(coefficients);

        double least = 0.;
        for (unsigned int i = 0; i < unknowns.size(); ++i)
          if (mass.diag_element(unknowns[i]) > 0.)
            least = std::min(least, change[i]);
        Vector<double> reached(missing.size());
        derivative.vmult(reached, coefficients);
        reached -= missing;
        if (least < -largest_loss || reached.linfty_norm() > 1e-10)
          {
            all_kept = false;
            continue;
          }
        component.for_each_entry(
          mass, [&](const unsigned int i, const unsigned int j, auto &&entry) {
            entry.value() *= 1. + 0.5 * (change[i] + change[j]);
          });
      }
    return all_kept;
  }



#define INSTANTIATE(dim)                                   \
  template bool keep_moments(const Body<dim> &,            \
                             const SparseMatrix<double> &, \
                             const MassRedistribution &,   \
                             SparseMatrix<double> &);
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
