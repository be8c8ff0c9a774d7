#include <boost/test/unit_test.hpp>

#include "contact_setup.h"

BOOST_AUTO_TEST_SUITE(contact_model)

using namespace Signorini;
using namespace dealii;

namespace
{
  // A block whose lower side touches a circle; one corner is held in x.
  BodyOnTool
  block_on_ball()
  {
    return {rectangle("0, 0 ; 2, 1",
                      "3, 2",
                      1,
                      "subsection Supports\n set Fixed = point 0, 0: x\nend\n"),
            "bottom",
            "set Shape = circle\nsubsection Circle\n"
            " set Centre = 0.8, -1.5\n set Radius = 1.2\nend\n"};
  }
} // namespace



// The geometric contact term is minus the derivative of the contact forces at
// fixed multipliers; central differences, their error is of order 1e-9.
BOOST_AUTO_TEST_CASE(geometric_stiffness)
{
  const auto                setup       = block_on_ball();
  const std::vector<double> multipliers = {3., 0., 5., 2.};
  Vector<double>            u(setup.solid.n_dofs());
  for (unsigned int i = 0; i < u.size(); ++i)
    u[i] = 0.01 * std::sin(1. + i);
  const unsigned int n = setup.contact.interface_dofs().size();
  BOOST_TEST(setup.contact.n_contacts() == 4u);
  BOOST_TEST(n == 7u);

  FullMatrix<double> stiffness(n, n);
  for (const auto &block :
       setup.contact.geometric_stiffness(setup.contact.evaluate({u, 0.}),
                                         multipliers))
    block.add_to(stiffness);
  BOOST_TEST(stiffness.frobenius_norm() > 1.);
  BOOST_TEST(stiffness_error(setup.contact,
                             setup.solid.dof_map().constraints(),
                             u,
                             multipliers) < 1e-8);
}



// G - A du is the gap after a small motion, up to second order.
BOOST_AUTO_TEST_CASE(linearised_gaps)
{
  const auto setup = block_on_ball();
  BOOST_TEST(linearisation_error(setup.contact,
                                 setup.solid.dof_map().constraints(),
                                 Vector<double>(setup.solid.n_dofs()),
                                 1e-5) < 1e-9);
}

BOOST_AUTO_TEST_SUITE_END()
