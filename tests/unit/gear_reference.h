#ifndef tests_unit_gear_reference_h
#define tests_unit_gear_reference_h

#include <signorini/geometry/gears/rack_tooth.h>

#include <cmath>
#include <functional>
#include <random>
#include <vector>

/** Gears in other words than the program's: textbook formulas and searches. */
namespace GearReference
{
  constexpr double pi = 3.14159265358979323846;

  inline double
  inv(const double angle)
  {
    return std::tan(angle) - angle;
  }

  /** The smallest value of a function with one minimum between the bounds. */
  inline double
  smallest(const std::function<double(double)> &function,
           double                               low,
           double                               high)
  {
    const double golden = (std::sqrt(5.) - 1.) / 2.;
    for (unsigned int i = 0; i < 80; ++i)
      {
        const double left  = high - golden * (high - low);
        const double right = low + golden * (high - low);
        if (function(left) < function(right))
          high = right;
        else
          low = left;
      }
    return function((low + high) / 2.);
  }

  /** Turned clockwise about the origin. */
  inline dealii::Point<2>
  turned(const dealii::Point<2> &p, const double angle)
  {
    return {std::cos(angle) * p[0] + std::sin(angle) * p[1],
            -std::sin(angle) * p[0] + std::cos(angle) * p[1]};
  }

  struct Gear
  {
    unsigned int               n_teeth;
    Signorini::ToothParameters tooth;

    double
    alpha() const
    {
      return tooth.pressure_angle * pi / 180.;
    }

    double
    pitch_radius() const
    {
      return tooth.module * n_teeth / 2.;
    }

    double
    base_radius() const
    {
      return pitch_radius() * std::cos(alpha());
    }

    double
    thickness() const
    {
      return tooth.module *
               (pi / 2. + 2. * tooth.profile_shift * std::tan(alpha())) -
             tooth.thinning;
    }

    /** Half the angle of the tooth at a radius, by the involute function. */
    double
    half_angle(const double radius) const
    {
      return thickness() / (2. * pitch_radius()) + inv(alpha()) -
             inv(std::acos(base_radius() / radius));
    }

    /** How far a point is beside the involute, along the circle. */
    double
    beside_involute(const dealii::Point<2> &p) const
    {
      return p.norm() *
             (std::abs(std::atan2(p[0], p[1])) - half_angle(p.norm()));
    }

    /**
     * The centre of the cutter's rounding, seen from the tooth whose right
     * flank it cuts, when the gear has rolled by an angle from the place where
     * the cutter stands in the middle of the space.
     */
    dealii::Point<2>
    cutter(const double roll) const
    {
      const double radius = tooth.fillet_radius * tooth.module;
      const double depth =
        (tooth.dedendum - tooth.profile_shift) * tooth.module - radius;
      const double offset = (pi * tooth.module - thickness()) / 2. -
                            depth * std::tan(alpha()) -
                            radius / std::cos(alpha());
      const double r = pitch_radius();
      return turned({-offset - r * roll, r - depth}, roll + pi / n_teeth);
    }

    /** Distance from the rounding over all rolls, 0 on the fillet. */
    double
    outside_cutter(const dealii::Point<2> &p) const
    {
      const double depth =
        tooth.dedendum - tooth.profile_shift + tooth.fillet_radius;
      const double range =
        (1. + depth / std::tan(alpha())) * tooth.module / pitch_radius();
      const auto distance = [&](const double roll) {
        return p.distance(cutter(roll));
      };
      return smallest(distance, -range, range) -
             tooth.fillet_radius * tooth.module;
    }
  };

  /** Ordinary and extreme ones, in units of about a millimetre. */
  inline std::vector<Gear>
  sample_gears()
  {
    std::vector<Gear> list(6);
    list[0]                      = {20, {}};
    list[1]                      = {12, {}};
    list[2]                      = {60, {}};
    list[3]                      = {7, {}};
    list[4]                      = {150, {}};
    list[5]                      = {20, {}};
    list[0].tooth.module         = 5.;
    list[1].tooth.profile_shift  = 0.4;
    list[2].tooth.profile_shift  = -0.5;
    list[2].tooth.thinning       = 0.1;
    list[3].tooth.profile_shift  = 0.62;
    list[3].tooth.addendum       = 0.8;
    list[4].tooth.pressure_angle = 14.5;
    list[4].tooth.fillet_radius  = 0.2;
    list[5].tooth.pressure_angle = 25.;
    list[5].tooth.profile_shift =
      1.; // the rounding is outside the pitch circle
    list[5].tooth.addendum      = 0.5;
    list[5].tooth.fillet_radius = 0.3;
    return list;
  }

  /** Repeatable numbers between two bounds. */
  class Random
  {
  public:
    double
    between(const double low, const double high)
    {
      return low + (high - low) * (engine() / 4294967296.);
    }

    unsigned int
    integer(const unsigned int low, const unsigned int high)
    {
      return low + engine() % (high - low + 1);
    }

  private:
    std::mt19937 engine{20};
  };
} // namespace GearReference

#endif
