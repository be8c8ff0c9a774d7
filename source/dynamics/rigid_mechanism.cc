#include <signorini/dynamics/rigid_mechanism.h>
#include <signorini/input/instantiate.h>
#include <signorini/variational_inequality/bound_constrained_qp.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    constexpr double anywhere = std::numeric_limits<double>::infinity();

    // lambda >= 0 that makes |f + W lambda|^2/2 + g lambda smallest.
    std::vector<double>
    least_imbalance(const std::vector<double>              &load,
                    const std::vector<std::vector<double>> &columns,
                    const std::vector<double>              &gaps)
    {
      const unsigned int  n = columns.size();
      FullMatrix<double>  gram(n, n);
      std::vector<double> right(n, 0.);
      for (unsigned int j = 0; j < n; ++j)
        {
          right[j] = -gaps[j];
          for (unsigned int i = 0; i < load.size(); ++i)
            {
              right[j] -= columns[j][i] * load[i];
              for (unsigned int k = 0; k < n; ++k)
                gram(j, k) += columns[j][i] * columns[k][i];
            }
        }
      if (n == 0)
        return {};
      return solve_bound_constrained_qp(gram, right, std::vector<double>(n, 0.))
        .x;
    }

    // f + W lambda: without gaps, what no contact can balance; as a motion, f
    // as far as gaps allow.
    std::vector<double>
    rest(const std::vector<double>              &load,
         const std::vector<std::vector<double>> &columns,
         const std::vector<double>              &lambda)
    {
      std::vector<double> result(load);
      for (unsigned int j = 0; j < columns.size(); ++j)
        for (unsigned int i = 0; i < load.size(); ++i)
          result[i] += lambda[j] * columns[j][i];
      return result;
    }

    double
    largest(const std::vector<double> &values)
    {
      double result = 0.;
      for (const double value : values)
        result = std::max(result, std::abs(value));
      return result;
    }

    // The first motion along which something is left of a load.
    std::optional<unsigned int>
    first_of(const std::vector<double> &rest, const std::vector<double> &load)
    {
      for (unsigned int i = 0; i < load.size(); ++i)
        if (std::abs(rest[i]) > 1e-6 * largest(load))
          return i;
      return {};
    }

    template <int dim>
    double
    size_of_contactors(const ContactModel<dim> &contact)
    {
      double size = 0.;
      for (const auto &pair : contact.pairs())
        for (const auto &node : pair.contactor.nodes)
          size =
            std::max(size, node.point.distance(pair.contactor.nodes[0].point));
      return size;
    }

    template <int dim>
    double
    smallest_gap(const std::vector<ContactPoint<dim>> &points)
    {
      double smallest = anywhere;
      for (const auto &point : points)
        if (point.is_in_reach())
          smallest = std::min(smallest, point.gap);
      return smallest;
    }
  } // namespace



  template <int dim>
  RigidMechanism<dim>::RigidMechanism(const ContactModel<dim>      &contact,
                                      const std::vector<DofVector> &modes,
                                      const DofVector              &force)
    : contact_(contact)
    , modes_(modes)
  {
    for (const auto &mode : modes_)
      {
        // Loads of a body that is in balance by itself are rounding.
        double power = 0., terms = 0.;
        for (unsigned int i = 0; i < mode.size(); ++i)
          {
            power += mode[i] * force[i];
            terms += std::abs(mode[i] * force[i]);
          }
        load_.push_back(std::abs(power) > 1e-12 * terms ? power : 0.);
      }
  }



  template <int dim>
  typename RigidMechanism<dim>::Columns
  RigidMechanism<dim>::columns(const Points &points,
                               const double  largest_gap,
                               const bool    with_friction) const
  {
    const auto powers = [&](const SparseRow &row) {
      std::vector<double> result;
      for (const auto &mode : modes_)
        result.push_back(row.dot(mode));
      return result;
    };
    Columns    result;
    const auto add = [&](const unsigned int         k,
                         const std::vector<double> &power,
                         const double               friction) {
      result.powers.push_back(power);
      result.contact.push_back(k);
      result.friction.push_back(friction);
      result.gaps.push_back(std::max(points[k].gap, 0.));
    };
    for (const auto &pair : contact_.pairs())
      for (unsigned int n = 0; n < pair.contactor.nodes.size(); ++n)
        {
          const unsigned int k     = pair.first_contact + n;
          const auto        &point = points[k];
          if (!point.is_in_reach() || point.gap > largest_gap)
            continue;
          const auto   normal = powers(point.gap_gradient);
          const double mu =
            with_friction ? pair.law.friction().coefficient(true, 0., 0.) : 0.;
          if (mu == 0.)
            add(k, normal, 0.);
          else
            for (const auto &row : point.slip_gradients)
              for (const double sign : {-1., 1.})
                {
                  const auto tangential = powers(row);
                  auto       edge       = normal;
                  for (unsigned int i = 0; i < edge.size(); ++i)
                    edge[i] += sign * mu * tangential[i];
                  add(k, edge, sign * mu);
                }
        }
    return result;
  }



  template <int dim>
  DofVector
  RigidMechanism<dim>::motion(const std::vector<double> &shares) const
  {
    DofVector result(modes_.front().size());
    for (unsigned int i = 0; i < modes_.size(); ++i)
      result.add(shares[i], modes_[i]);
    return result;
  }



  template <int dim>
  std::optional<unsigned int>
  RigidMechanism<dim>::find_unbalanced(const Points &points) const
  {
    const auto powers = columns(points, anywhere, true).powers;
    const auto lambda =
      least_imbalance(load_, powers, std::vector<double>(powers.size(), 0.));
    return first_of(rest(load_, powers, lambda), load_);
  }



  template <int dim>
  typename RigidMechanism<dim>::Approach
  RigidMechanism<dim>::approach(const Configuration &start) const
  {
    constexpr unsigned int most_moves = 200; // then it is too slow to tell
    const double           size       = size_of_contactors(contact_);
    const double           closed     = 1e-7 * size;
    double                 far        = 2. * size;

    Approach                    result;
    std::optional<unsigned int> first;
    result.forces = InterfaceForces(contact_.n_contacts());
    result.way.reinit(start.displacement.size());
    for (unsigned int move = 0; move < most_moves; ++move)
      {
        DofVector displacement(start.displacement);
        displacement += result.way;
        auto points =
          contact_.evaluate({displacement, start.time, start.contact});
        // What wore in the last step recedes within this one: until then
        // contacts are closed.
        for (unsigned int k = 0; k < points.size() && start.contact; ++k)
          points[k].gap -= points[k].recession - start.contact->recessions[k];

        // 1. Can the contacts that are closed balance the loads?
        const auto cones   = columns(points, closed, true);
        const auto no_gaps = std::vector<double>(cones.gaps.size(), 0.);
        const auto lambda  = least_imbalance(load_, cones.powers, no_gaps);
        const auto free    = first_of(rest(load_, cones.powers, lambda), load_);
        if (!free)
          {
            result.is_balanced = true;
            for (unsigned int j = 0; j < lambda.size(); ++j)
              result.forces.normal[cones.contact[j]] += lambda[j];
            return result;
          }
        const double distance = smallest_gap(points);
        if (move == 0)
          {
            first = free;
            if (std::isfinite(distance))
              far += 2. * std::max(distance, 0.);
          }

        // 2. How fast closed contacts let the loads move the bodies
        const auto normals = columns(points, closed, false);
        const auto pushed =
          least_imbalance(load_,
                          normals.powers,
                          std::vector<double>(normals.gaps.size(), 0.));
        const double speed =
          motion(rest(load_, normals.powers, pushed)).linfty_norm();
        if (speed == 0.)
          return result;

        // 3. A step that closes gaps, but no further: short, so that normals
        // turn little, or as long as nothing can be met on it
        const double        step = std::isfinite(distance) ?
                                     std::max(0.05 * size, 0.5 * distance) :
                                     0.05 * size;
        std::vector<double> pace(load_);
        for (double &share : pace)
          share *= step / speed;
        const auto all   = columns(points, anywhere, false);
        const auto stops = least_imbalance(pace, all.powers, all.gaps);
        result.way += motion(rest(pace, all.powers, stops));
        if (result.way.linfty_norm() > far)
          {
            result.endless = first;
            return result;
          }
      }
    return result;
  }



#define INSTANTIATE(dim) template class RigidMechanism<dim>;
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
