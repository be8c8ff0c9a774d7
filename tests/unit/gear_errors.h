#ifndef tests_unit_gear_errors_h
#define tests_unit_gear_errors_h

#include "gear_lines.h"

namespace GearReference
{
  /**
   * A point in the frame of tooth k, from 1, whose axis follows from the pitch
   * point by the thickness of the tooth there.
   */
  inline dealii::Point<2>
  in_pinion_tooth(const dealii::Point<2> &p,
                  const unsigned int      k,
                  const Gear             &gear,
                  const Place            &place)
  {
    const double r    = gear.pitch_radius();
    const double half = gear.thickness() / (2. * r);
    const double axis = pi + (place.right ? -half : half) - place.roll -
                        (k - 1. * place.at_pitch) * 2. * pi / gear.n_teeth;
    return GearReference::turned(dealii::Point<2>(p - place.pitch_point -
                                                  dealii::Point<2>(0., r)),
                                 -axis);
  }

  inline dealii::Point<2>
  in_rack_tooth(const dealii::Point<2> &p,
                const unsigned int      k,
                const Gear             &gear,
                const Place            &place)
  {
    const double m    = gear.tooth.module;
    const double half = Signorini::RackTooth(gear.tooth).pitch_thickness() / 2.;
    const double axis = (place.right ? -half : half) +
                        gear.pitch_radius() * place.roll +
                        (k - 1. * place.at_pitch) * pi * m;
    return dealii::Point<2>(p - place.pitch_point - dealii::Point<2>(axis, 0.));
  }

  /**
   * The largest distance of a vertex of the boundary from the curve it belongs
   * on, in modules.
   */
  inline double
  error_of_pinion(const Signorini::Mesh<2> &mesh,
                  const Gear               &gear,
                  const Place              &place)
  {
    const Signorini::GearTooth tooth(gear.n_teeth, gear.tooth);
    const double limit = tooth.end_of_involute() - gear.tooth.relief_length;
    const double rb    = gear.base_radius();
    double       error = 0.;
    for (unsigned int k = 1; k <= place.n_modelled; ++k)
      for (const std::string side : {"right_", "left_"})
        for (const dealii::Point<2> &p :
             vertices_on(mesh, side + std::to_string(k)))
          {
            const dealii::Point<2> local = in_pinion_tooth(p, k, gear, place);
            BOOST_TEST((local[0] > 0.) == (side == "right_"));
            if (gear.tooth.relief == 0. ||
                local.norm_square() < limit * limit + rb * rb)
              error = std::max(error, std::abs(gear.beside_involute(local)));
          }
    const dealii::Point<2> center =
      place.pitch_point + dealii::Point<2>(0., gear.pitch_radius());
    for (const dealii::Point<2> &p : vertices_on(mesh, "tips"))
      error =
        std::max(error, std::abs(p.distance(center) - tooth.tip_radius()));
    for (const dealii::Point<2> &p : vertices_on(mesh, "bore"))
      error = std::max(error,
                       std::abs(p.distance(center) -
                                place.bore * gear.pitch_radius()));
    for (const dealii::Point<2> &p : vertices_on(mesh, "roots"))
      {
        double nearest = std::abs(p.distance(center) - tooth.root_radius());
        for (unsigned int k = 1; k <= place.n_modelled; ++k)
          {
            dealii::Point<2> local = in_pinion_tooth(p, k, gear, place);
            local[0]               = std::abs(local[0]);
            if (std::atan2(local[0], local[1]) < 1.1 * pi / gear.n_teeth)
              nearest = std::min(nearest, std::abs(gear.outside_cutter(local)));
          }
        error = std::max(error, nearest);
      }
    return error / gear.tooth.module;
  }

  inline double
  error_of_rack(const Signorini::Mesh<2> &mesh,
                const Gear               &gear,
                const Place              &place)
  {
    const Signorini::RackTooth tooth(gear.tooth);
    const double               alpha = gear.alpha();
    const double radius = gear.tooth.fillet_radius * gear.tooth.module;
    const double limit =
      tooth.tip_height() - gear.tooth.relief_length * std::cos(alpha);
    double error = 0.;
    for (unsigned int k = 1; k <= place.n_modelled; ++k)
      for (const std::string side : {"right_", "left_"})
        for (const dealii::Point<2> &p :
             vertices_on(mesh, side + std::to_string(k)))
          {
            const dealii::Point<2> local = in_rack_tooth(p, k, gear, place);
            if (local[1] < limit)
              error = std::max(error,
                               std::abs(std::abs(local[0]) +
                                        local[1] * std::tan(alpha) -
                                        tooth.pitch_thickness() / 2.));
          }
    const double root = tooth.root_height() + place.pitch_point[1];
    for (const dealii::Point<2> &p : vertices_on(mesh, "roots"))
      {
        // The centre of the fillet, half a land from the middle of the space.
        double nearest = std::abs(p[1] - root);
        for (unsigned int k = 1; k <= place.n_modelled; ++k)
          {
            const dealii::Point<2> local = in_rack_tooth(p, k, gear, place);
            const dealii::Point<2> center(pi * gear.tooth.module / 2. -
                                            tooth.half_land_of_root(),
                                          tooth.root_height() + radius);
            nearest = std::min(nearest,
                               std::abs(center.distance(
                                          {std::abs(local[0]), local[1]}) -
                                        radius));
          }
        error = std::max(error, nearest);
      }
    return error / gear.tooth.module;
  }
} // namespace GearReference

#endif
