#ifndef signorini_geometry_degrees_h
#define signorini_geometry_degrees_h

namespace Signorini
{
  /** Cosine of an angle in degrees; exact at multiples of 90. */
  double
  cos_degrees(const double angle);

  /** Sine of an angle in degrees; exact at multiples of 90. */
  double
  sin_degrees(const double angle);
} // namespace Signorini

#endif
