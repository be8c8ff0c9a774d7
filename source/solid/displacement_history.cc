#include <signorini/input/input_error.h>
#include <signorini/input/instantiate.h>
#include <signorini/input/nearest_name.h>
#include <signorini/solid/displacement_history.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <sstream>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // Times whose values are kept; a cubic polynomial needs four.
    const unsigned int n_known = 8;

    // Fourfold: h00, h10 / h, h01, h11 / h of Hermite's polynomials in s, or
    // their derivatives with respect to s.
    std::array<double, 4>
    hermite(const double s, const unsigned int derivative)
    {
      if (derivative == 0)
        return {{(1. + 2. * s) * (1. - s) * (1. - s),
                 s * (1. - s) * (1. - s),
                 s * s * (3. - 2. * s),
                 s * s * (s - 1.)}};
      if (derivative == 1)
        return {{6. * s * (s - 1.),
                 (1. - s) * (1. - 3. * s),
                 6. * s * (1. - s),
                 s * (3. * s - 2.)}};
      return {{12. * s - 6., 6. * s - 4., 6. - 12. * s, 6. * s - 2.}};
    }

    // The same for straight lines.
    std::array<double, 2>
    hat(const double s, const unsigned int derivative)
    {
      if (derivative == 0)
        return {{1. - s, s}};
      if (derivative == 1)
        return {{-1., 1.}};
      return {{0., 0.}};
    }

    // The names of the bodies that are stored.
    std::vector<std::string>
    bodies_of(const std::vector<StoredDisplacement> &rows)
    {
      std::vector<std::string> names;
      for (const StoredDisplacement &row : rows)
        if (std::find(names.begin(), names.end(), row.body) == names.end())
          names.push_back(row.body);
      return names;
    }
  } // namespace



  template <int dim>
  DisplacementHistory<dim>::DisplacementHistory(
    const std::string      &folder,
    const std::string      &body,
    std::vector<Point<dim>> points,
    const TimeInterpolation interpolation)
    : folder_(folder)
    , body_(body)
    , points_(std::move(points))
    , interpolation_(interpolation)
  {
    const std::vector<StoredDisplacement> rows = read_index(folder);
    for (const StoredDisplacement &row : rows)
      {
        if (row.body != body)
          continue;
        if (!times_.empty() && row.time < times_.back())
          throw InputError("The file '" + path(displacement_index) +
                           "' is damaged: the times of body \"" + body +
                           "\" do not ascend. Repeat the global run.");
        if (!times_.empty() && row.time == times_.back())
          rows_.back() = row;
        else
          {
            times_.push_back(row.time);
            rows_.push_back(row);
          }
      }
    if (rows_.empty())
      throw InputError(
        "The global run in '" + folder + "' has no displacements of a body \"" +
        body + "\". It has those of: " + comma_separated(bodies_of(rows)) +
        "." + did_you_mean(body, bodies_of(rows)));
    weights_in(rows_.front().mesh_file);
  }



  template <int dim>
  std::vector<Tensor<1, dim>>
  DisplacementHistory<dim>::values(const double       time,
                                   const unsigned int derivative) const
  {
    Assert(derivative <= 2, ExcMessage("Only up to accelerations."));
    const double       t    = checked(time);
    const unsigned int last = times_.size() - 1;
    TimeWeights        weights;
    if (last == 0)
      weights[0] = derivative == 0 ? 1. : 0.;
    else
      {
        const unsigned int next =
          std::upper_bound(times_.begin(), times_.end(), t) - times_.begin();
        const unsigned int i = std::min(next, last) - 1;
        weights              = weights_between(i, t, derivative);
        if (derivative > 0 && t == times_[i] && i > 0)
          {
            for (auto &weight : weights)
              weight.second *= 0.5;
            for (const auto &[j, w] : weights_between(i - 1, t, derivative))
              weights[j] += 0.5 * w;
          }
      }

    Values result(points_.size());
    for (const auto &[j, weight] : weights)
      if (weight != 0.)
        {
          const Values &known = values_at(j);
          for (unsigned int p = 0; p < points_.size(); ++p)
            result[p] += weight * known[p];
        }
    return result;
  }



  template <int dim>
  double
  DisplacementHistory<dim>::checked(const double time) const
  {
    const double first = times_.front(), last = times_.back();
    const double tolerance =
      1e-9 * (times_.size() > 1 ? last - first : std::abs(first));
    if (!(time >= first - tolerance && time <= last + tolerance))
      {
        std::ostringstream message;
        message << "At the time " << time << " s the displacement of body \""
                << body_ << "\" is not known: the global run in '" << folder_
                << "' stored it from " << first << " to " << last
                << " s. Let the submodel begin and end within this time, or "
                   "continue the global run.";
        throw InputError(message.str());
      }
    // Steps that add up to a stored time miss it by rounding errors.
    const auto next = std::lower_bound(times_.begin(), times_.end(), time);
    for (const auto stored : {next == times_.begin() ? next : std::prev(next),
                              next == times_.end() ? std::prev(next) : next})
      if (std::abs(*stored - time) <= tolerance)
        return *stored;
    return time;
  }



  template <int dim>
  typename DisplacementHistory<dim>::TimeWeights
  DisplacementHistory<dim>::slope(const unsigned int i) const
  {
    const unsigned int last = times_.size() - 1;
    if (last == 1)
      {
        const double h = times_[1] - times_[0];
        return {{0, -1. / h}, {1, 1. / h}};
      }
    // d / dt at times_[i] of the parabola through m - 1, m, m + 1.
    const unsigned int m = std::clamp(i, 1u, last - 1);
    TimeWeights        weights;
    for (unsigned int a = m - 1; a <= m + 1; ++a)
      {
        double product = 1., derivative = 0.;
        for (unsigned int b = m - 1; b <= m + 1; ++b)
          if (b != a)
            {
              const unsigned int c = 3 * m - a - b; // the third one
              product *= times_[a] - times_[b];
              derivative += times_[i] - times_[c];
            }
        weights[a] = derivative / product;
      }
    return weights;
  }



  template <int dim>
  typename DisplacementHistory<dim>::TimeWeights
  DisplacementHistory<dim>::weights_between(const unsigned int i,
                                            const double       time,
                                            const unsigned int derivative) const
  {
    const double h       = times_[i + 1] - times_[i];
    const double s       = (time - times_[i]) / h;
    const double scaling = std::pow(h, -static_cast<double>(derivative));
    TimeWeights  weights;
    if (interpolation_ == TimeInterpolation::linear)
      {
        const auto n = hat(s, derivative);
        return {{i, scaling * n[0]}, {i + 1, scaling * n[1]}};
      }
    const auto n   = hermite(s, derivative);
    weights[i]     = scaling * n[0];
    weights[i + 1] = scaling * n[2];
    for (unsigned int end = 0; end < 2; ++end)
      for (const auto &[j, w] : slope(i + end))
        weights[j] += scaling * h * n[1 + 2 * end] * w;
    return weights;
  }



  template <int dim>
  const typename DisplacementHistory<dim>::Values &
  DisplacementHistory<dim>::values_at(const unsigned int i) const
  {
    const auto known = known_values_.find(i);
    if (known != known_values_.end())
      return known->second;
    if (known_values_.size() >= n_known)
      {
        // Time mostly goes on: the farthest one is not needed any more.
        const auto first = known_values_.begin();
        const auto last  = std::prev(known_values_.end());
        known_values_.erase(std::abs(double(first->first) - i) >
                                std::abs(double(last->first) - i) ?
                              first :
                              last);
      }

    const std::vector<InterpolationWeights> &weights =
      weights_in(rows_[i].mesh_file);
    const auto at_nodes =
      read_displacements<dim>(path(rows_[i].displacement_file),
                              n_nodes_.at(rows_[i].mesh_file));
    Values values(points_.size());
    for (unsigned int p = 0; p < points_.size(); ++p)
      for (unsigned int a = 0; a < weights[p].nodes.size(); ++a)
        values[p] += weights[p].weights[a] * at_nodes[weights[p].nodes[a]];
    return known_values_[i] = std::move(values);
  }



  template <int dim>
  const std::vector<InterpolationWeights> &
  DisplacementHistory<dim>::weights_in(const std::string &mesh_file) const
  {
    const auto known = weights_.find(mesh_file);
    if (known != weights_.end())
      return known->second;

    NodalMesh<dim> mesh = read_mesh<dim>(path(mesh_file));
    n_nodes_[mesh_file] = mesh.nodes.size();
    const NodalInterpolation<dim>     interpolation(std::move(mesh));
    std::vector<InterpolationWeights> weights;
    for (const Point<dim> &point : points_)
      {
        const auto found = interpolation.weights(point);
        if (!found)
          {
            std::ostringstream message;
            message << "The point (" << point << ") lies outside of body \""
                    << body_ << "\" of the global run in '" << folder_
                    << "', whose nearest node is at ("
                    << interpolation.node_near(point)
                    << "), in m. The submodel has to be a part of this body, "
                       "in the same place.";
            throw InputError(message.str());
          }
        weights.push_back(*found);
      }
    return weights_[mesh_file] = std::move(weights);
  }



  template <int dim>
  std::string
  DisplacementHistory<dim>::path(const std::string &file) const
  {
    return (std::filesystem::path(folder_) / file).string();
  }



#define INSTANTIATE(dim) template class DisplacementHistory<dim>;
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
