#include <signorini/variational_inequality/kkt_residual.h>
#include <signorini/variational_inequality/solution_refinement.h>

#include <boost/test/unit_test.hpp>

#include <cmath>

BOOST_AUTO_TEST_SUITE(solution_refinement)

using namespace Signorini;
using dealii::FullMatrix;
using dealii::Vector;

namespace
{
  // Two unknowns, the motion across a floor and along it: S = diag(k, k), the
  // floor right below, pressed with 10 N and pulled along with a force. mu =
  // 0.5.
  InterfaceProblem
  pressed_block(const double k, const double pull)
  {
    FullMatrix<double> stiffness(2, 2);
    stiffness(0, 0) = stiffness(1, 1) = k;
    InterfaceProblem problem;
    problem.set_stiffness(InterfaceStiffness::from_matrix(stiffness));
    Vector<double> force(2);
    force[0] = -10.;
    force[1] = pull;
    InterfaceContact contact;
    contact.normal.add(0, -1.);
    contact.tangents.resize(1);
    contact.tangents[0].add(1, 1.);
    contact.friction_coefficient = 0.5;
    problem.set_contacts({contact});
    problem.set_force(force);
    return problem;
  }

  InterfaceSolution
  solution(const double along, const double normal, const double tangential)
  {
    InterfaceSolution result;
    result.displacement.reinit(2);
    result.displacement[1]         = along;
    result.forces                  = InterfaceForces(1);
    result.forces.normal[0]        = normal;
    result.forces.tangential[0][0] = tangential;
    return result;
  }
} // namespace



BOOST_AUTO_TEST_CASE(digits_come_back_where_it_sticks)
{
  const auto problem = pressed_block(1e8, 3.);
  auto       rounded = solution(1e-15, 10. + 1e-6, 3. - 1e-6);
  BOOST_TEST(kkt_residual(problem, rounded).norm() > 1e-9);
  BOOST_TEST(refine(problem, rounded));
  BOOST_TEST(kkt_residual(problem, rounded).norm() < 1e-15);
  BOOST_TEST(std::abs(rounded.forces.normal[0] - 10.) < 1e-14);
  BOOST_TEST(std::abs(rounded.forces.tangential[0][0] - 3.) < 1e-14);
  BOOST_TEST(std::abs(rounded.displacement[1]) < 1e-24);
}



BOOST_AUTO_TEST_CASE(friction_follows_where_it_slips)
{
  const auto problem = pressed_block(1e8, 8.);
  auto       rounded = solution(3e-8 + 1e-15, 10. + 1e-6, 0.5 * (10. + 1e-6));
  BOOST_TEST(kkt_residual(problem, rounded).norm() > 1e-9);
  BOOST_TEST(refine(problem, rounded));
  BOOST_TEST(kkt_residual(problem, rounded).norm() < 1e-15);
  BOOST_TEST(std::abs(rounded.forces.normal[0] - 10.) < 1e-14);
  BOOST_TEST(std::abs(rounded.forces.tangential[0][0] - 5.) < 1e-14);
  BOOST_TEST(std::abs(rounded.displacement[1] - 3e-8) < 1e-22);
}



BOOST_AUTO_TEST_CASE(what_is_open_is_left_alone)
{
  const auto problem = pressed_block(1e8, 3.);
  auto       open    = solution(1e-8, 0., 0.);
  BOOST_TEST(refine(problem, open));
  BOOST_TEST(open.forces.normal[0] == 0.);
  BOOST_TEST(std::abs(open.displacement[0] + 1e-7) < 1e-21);
  BOOST_TEST(std::abs(open.displacement[1] - 3e-8) < 1e-21);
}

BOOST_AUTO_TEST_SUITE_END()
