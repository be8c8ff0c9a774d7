#include <signorini/solid/strain_range.h>

#include <boost/test/unit_test.hpp>

#include "test_body.h"

BOOST_AUTO_TEST_SUITE(strain_range)

using namespace Signorini;
using namespace dealii;

namespace
{
  const std::string block = "set Mesh = rectangle\nsubsection Rectangle\n"
                            " set Corners = 1, 0 ; 3, 1\n set Cells = 4, 2\n"
                            "end\n";

  // Of u = H X, the same everywhere.
  StrainExtremes<2>
  extremes_of(const Tensor<2, 2> &H,
              const Formulation   formulation = Formulation::plane_strain,
              const std::string  &section     = block)
  {
    const auto model = test_model<2>(section, formulation);
    return StrainRange<2>(*model.parts()[0].body)
      .measure(interpolate(model, [&](const Point<2> &X, unsigned int c) {
        return (H * X)[c];
      }));
  }

  Tensor<2, 2>
  gradient(const double xx, const double xy, const double yx, const double yy)
  {
    return Tensor<2, 2>({{xx, xy}, {yx, yy}});
  }
} // namespace



BOOST_AUTO_TEST_CASE(of_an_even_gradient)
{
  for (const std::string degree : {"1", "2"})
    {
      // Stretch by 0.1 and -0.2 in axes turned by 45 degrees, and a rotation.
      const double rotation = 0.15;
      const auto   found =
        extremes_of(gradient(-0.05, 0.15 - rotation, 0.15 + rotation, -0.05),
                    Formulation::plane_strain,
                    block + "set Element degree = " + degree + "\n");
      BOOST_TEST(std::abs(found.strain.value - 0.2) < 1e-13);
      BOOST_TEST(std::abs(found.rotation.value - rotation) < 1e-13);
      BOOST_TEST(std::abs(found.volume.value - (0.95 * 0.95 - 0.15 * 0.15 +
                                                rotation * rotation)) < 1e-13);
    }
}



BOOST_AUTO_TEST_CASE(hoop_strain_counts)
{
  const auto found =
    extremes_of(gradient(0.3, 0., 0., 0.), Formulation::axisymmetric);
  BOOST_TEST(std::abs(found.strain.value - 0.3) < 1e-13);
  const auto stretched =
    extremes_of(gradient(-0.1, 0., 0., 0.), Formulation::axisymmetric);
  BOOST_TEST(std::abs(stretched.volume.value - 0.81) < 1e-13);
}



BOOST_AUTO_TEST_CASE(a_cell_inside_out_is_named)
{
  const auto model = test_model<2>(block, Formulation::plane_strain);
  auto       u     = interpolate(model, [](const Point<2> &X, unsigned int c) {
    return c == 0 && X[0] > 2.75 ? -0.8 : 0.;
  });
  const auto found = StrainRange<2>(*model.parts()[0].body).measure(u);
  BOOST_TEST(std::abs(found.volume.value + 0.6) < 1e-13);
  BOOST_TEST(found.volume.cell[0] == 2.75);
  // A body that only moves is within the range.
  u = interpolate(model, [](const Point<2> &, unsigned int) { return 1e3; });
  const auto moved = StrainRange<2>(*model.parts()[0].body).measure(u);
  BOOST_TEST(moved.strain.value == 0.);
  BOOST_TEST(moved.volume.value == 1.);
}

BOOST_AUTO_TEST_SUITE_END()
