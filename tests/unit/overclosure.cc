#include <signorini/input/input_error.h>
#include <signorini/run/overclosure.h>

#include <boost/test/unit_test.hpp>

#include "contact_setup.h"

BOOST_AUTO_TEST_SUITE(overclosure)

using namespace Signorini;
using namespace dealii;

namespace
{
  // A block that is inside of a sloping floor by 0.01 at x = 2, by nothing at
  // x = 0 to 1: y = 0.01 (x - 1).
  struct Setup : BodyOnTool
  {
    Vector<double> u;

    explicit Setup(const std::string &supports = "")
      : BodyOnTool(rectangle("0, 0 ; 2, 1",
                             "4, 1",
                             1,
                             "subsection Supports\n set Fixed = " + supports +
                               "\nend\n"),
                   "bottom",
                   "set Shape = plane\nsubsection Plane\n set Point = 1, 0\n"
                   " set Normal = -0.01, 1\nend\n")
      , u(solid.n_dofs())
    {}

    void
    treat(const Overclosure overclosure)
    {
      PairParameters parameters;
      parameters.overclosure   = overclosure;
      parameters.press_fit_end = 2.;
      treat_overclosure<2>({parameters}, u, contact);
    }

    // The gap counted from the overclosure allowed against the bare one.
    void
    check_gaps(const double time, const double share) const
    {
      const auto points = contact.evaluate({u, time});
      for (unsigned int k = 0; k < points.size(); ++k)
        {
          const double x    = contact.pairs()[0].contactor.nodes[k].point[0];
          const double bare = 0.01 * (1. - x) / std::sqrt(1.0001);
          BOOST_TEST(std::abs(points[k].gap - bare -
                              share * std::max(0., -bare)) < 1e-15);
        }
    }
  };

  std::string
  message(Setup &setup, const Overclosure overclosure)
  {
    try
      {
        setup.treat(overclosure);
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "";
  }
} // namespace



// The deepest node is named, with its depth and the remedy.
BOOST_AUTO_TEST_CASE(refused)
{
  Setup             setup;
  const std::string text = message(setup, Overclosure::refuse);
  BOOST_TEST(text.find("body a at (2 0) lies 0.00999") != std::string::npos);
  BOOST_TEST(text.find("\"tool\"") != std::string::npos);
  BOOST_TEST(text.find("Overclosure = press fit or adjust") !=
             std::string::npos);
}



// Resolved linearly until the end of the press fit.
BOOST_AUTO_TEST_CASE(press_fit)
{
  Setup setup;
  setup.check_gaps(0., 0.);
  setup.treat(Overclosure::press_fit);
  setup.check_gaps(0., 1.);
  setup.check_gaps(0.5, 0.75);
  setup.check_gaps(2., 0.);
  setup.check_gaps(3., 0.);
}



BOOST_AUTO_TEST_CASE(adjusted)
{
  Setup setup;
  setup.treat(Overclosure::adjust);
  setup.check_gaps(0., 1.);
  setup.check_gaps(1e6, 1.);
}



// A held node inside of its target cannot make room, whatever is allowed.
BOOST_AUTO_TEST_CASE(held)
{
  Setup setup("right: x, y");
  BOOST_TEST(message(setup, Overclosure::press_fit).find("held by Supports") !=
             std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
