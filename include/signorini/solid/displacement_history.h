#ifndef signorini_solid_displacement_history_h
#define signorini_solid_displacement_history_h

#include <signorini/solid/displacement_files.h>
#include <signorini/solid/nodal_interpolation.h>

#include <map>

namespace Signorini
{
  /** How a displacement goes on between the times at which it is known. */
  enum class TimeInterpolation
  {
    /** On straight lines: for static runs. */
    linear,

    /**
     * On cubic polynomials whose slopes at the stored times are those of the
     * parabola through the time and its two neighbours (at the ends: through
     * the first or last three). Velocities are continuous; motions with a
     * constant acceleration are exact.
     */
    cubic
  };

  /**
   * The displacement of points of a body in a run that is over, the global run
   * of a submodel. Each point is found once a mesh, so that it costs little to
   * ask at many times.
   *
   * Files are read when they are needed, and of each only the values at the
   * points are kept, for a few times. Not for several threads at once.
   */
  template <int dim>
  class DisplacementHistory
  {
  public:
    /**
     * @param folder of the global run, with displacements.csv
     * @param body   its name in the global run
     * @param points in the reference position, m
     * @throws InputError when there are no displacements of this body, when a
     * file is damaged, or when a point is outside of the body (farther than
     * NodalInterpolation allows).
     */
    DisplacementHistory(const std::string              &folder,
                        const std::string              &body,
                        std::vector<dealii::Point<dim>> points,
                        const TimeInterpolation         interpolation);

    /** The stored times (s), in ascending order. */
    const std::vector<double> &
    times() const
    {
      return times_;
    }

    /**
     * Displacements (m) of the points, or, with @p derivative = 1 or 2, their
     * velocities (m/s) or accelerations (m/s^2). A derivative that jumps at a
     * stored time has the mean of both sides there.
     * @param time in s. Beyond the first and the last stored time only
     * rounding errors are allowed, 1e-9 of the time between.
     * @throws InputError for other times, and as the constructor.
     */
    std::vector<dealii::Tensor<1, dim>>
    values(const double time, const unsigned int derivative = 0) const;

  private:
    using Values = std::vector<dealii::Tensor<1, dim>>;

    // Number of a stored time -> its factor in a sum.
    using TimeWeights = std::map<unsigned int, double>;

    // Where the time lies between the stored ones; checks the range.
    double
    checked(const double time) const;

    // The slope at a stored time.
    TimeWeights
    slope(const unsigned int i) const;

    // Between the stored times i and i + 1.
    TimeWeights
    weights_between(const unsigned int i,
                    const double       time,
                    const unsigned int derivative) const;

    // Displacements of the points at a stored time.
    const Values &
    values_at(const unsigned int i) const;

    // For each point the weights in this mesh.
    const std::vector<InterpolationWeights> &
    weights_in(const std::string &mesh_file) const;

    std::string
    path(const std::string &file) const;

    std::string                     folder_;
    std::string                     body_;
    std::vector<dealii::Point<dim>> points_;
    TimeInterpolation               interpolation_;
    std::vector<double>             times_;
    std::vector<StoredDisplacement> rows_; // one a time

    mutable std::map<std::string, std::vector<InterpolationWeights>> weights_;
    mutable std::map<std::string, unsigned int>                      n_nodes_;
    mutable std::map<unsigned int, Values> known_values_;
  };
} // namespace Signorini

#endif
