#include <signorini/contact/rigid_target.h>

#include <deal.II/base/parameter_handler.h>

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(rigid_target)

using namespace Signorini;
using namespace dealii;

namespace
{
  // The unknowns are a point x and, from number 2 on, those of the body.
  std::unique_ptr<RigidBody<2>>
  rigid_body(const std::string &section)
  {
    ParameterHandler prm;
    RigidBody<2>::declare_parameters(prm);
    prm.parse_input_from_string(section);
    return std::make_unique<RigidBody<2>>("tool", "", Constants(), 2, prm);
  }

  const std::string circle = "set Shape = circle\nsubsection Circle\n"
                             " set Centre = 0.3, 0.1\n set Radius = 0.5\n"
                             "end\n";
  const std::string hole   = circle + "subsection Circle\n"
                                      " set Side = inside\nend\n";
  const std::string profile =
    "set Shape = profile\nsubsection Profile\n set Points = "
    "0.8, 0 ; 0.6, 0.5 ; 0, 0.7 ; -0.6, 0.4 ; -0.7, -0.2 ; 0, -0.6 ; "
    "0.5, -0.4\n set Closed = true\n set Feature angle = 180\n"
    " set Solid side = within\nend\n";
  const std::string free = "set Free = x, y, rotation\nset Mass = 2\n"
                           "set Moment of inertia = 0.3\n"
                           "set Centre of rotation = 0.2, -0.1\n";

  TargetPoint<2>
  target_at(const RigidBody<2> &body, const Vector<double> &q)
  {
    const RigidTarget<2> target(body);
    ContactorPoint<2>    point = {Point<2>(q[0], q[1]), {}, {}, 0};
    return *target.place({q, 0.}, {q, 0.})->closest(point);
  }

  // dg/dq, from the normal and the supporting_dofs.
  Vector<double>
  gradient(const RigidBody<2> &body, const Vector<double> &q)
  {
    const auto     target = target_at(body, q);
    Vector<double> result(q.size());
    for (unsigned int c = 0; c < 2; ++c)
      result[c] = target.normal[c];
    for (const auto &[unknown, motion] : target.supporting_dofs)
      result[unknown] -= target.normal * motion;
    return result;
  }

  Vector<double>
  stepped(const Vector<double> &q, const unsigned int i, const double step)
  {
    Vector<double> result(q);
    result[i] += step;
    return result;
  }
} // namespace



// A circle that turns in its place meets no point beside it; one that goes
// around another centre does, as does a point that flies through.
BOOST_AUTO_TEST_CASE(passages_of_a_turning_body)
{
  const std::string turning =
    circle + "set Rotation = 0.5*t\nset Centre of rotation = ";
  const auto is_passed =
    [](const std::string &section, const Point<2> &start, const Point<2> &end) {
      const auto           body = rigid_body(section);
      const RigidTarget<2> target(*body);
      const Vector<double> q(2);
      return target.place({q, 1.}, {q, 0.})
        ->passed_side(start, end, 1., 0)
        .has_value();
    };
  // On the chord the point would come 15 mm inside.
  const Point<2> beside(0.3 + 0.5 + 1e-4, 0.1);
  BOOST_TEST(!is_passed(turning + "0.3, 0.1\n", beside, beside));
  // The circle sweeps over the point from below and is above it at the end.
  const Point<2>    in_the_way(1.3 + 1.2 * std::cos(0.25),
                            0.1 + 1.2 * std::sin(0.25));
  const std::string small = "set Shape = circle\nsubsection Circle\n"
                            " set Centre = 2.5, 0.1\n set Radius = 0.1\nend\n"
                            "set Rotation = 0.5*t\n"
                            "set Centre of rotation = 1.3, 0.1\n";
  BOOST_TEST(is_passed(small, in_the_way, in_the_way));
  BOOST_TEST(!is_passed(small, Point<2>(2.2, 0.35), Point<2>(2.2, 0.35)));
  BOOST_TEST(
    is_passed(turning + "0.3, 0.1\n", Point<2>(1.3, 0.2), Point<2>(-0.7, 0.2)));
}



// First and second derivatives of the gap over x, u and the arc of rotation
// against central differences, outside and inside.
BOOST_AUTO_TEST_CASE(derivatives_of_a_free_body)
{
  for (const std::string &shape : {circle, hole, profile})
    for (const double distance : {1.1, 0.6})
      BOOST_TEST_CONTEXT(shape << " from " << distance)
      {
        const auto body = rigid_body(shape + free);
        BOOST_TEST(std::abs(body->lever() - std::sqrt(0.15)) < 1e-14);
        Vector<double> q(5);
        q[0]              = 0.3 + 0.6 * distance;
        q[1]              = 0.1 + 0.5 * distance;
        q[2]              = 0.05;
        q[3]              = -0.03;
        q[4]              = 0.2;
        const auto target = target_at(*body, q);
        BOOST_REQUIRE(target.supporting_dofs.size() == 3u);
        BOOST_REQUIRE(target.curvature.m() == 5u);
        const double h = 1e-5;
        for (unsigned int i = 0; i < 5; ++i)
          {
            const auto after = stepped(q, i, h), before = stepped(q, i, -h);
            BOOST_TEST(
              std::abs(gradient(*body, q)[i] - (target_at(*body, after).gap -
                                                target_at(*body, before).gap) /
                                                 (2. * h)) < 1e-8);
            Vector<double> column = gradient(*body, after);
            column -= gradient(*body, before);
            for (unsigned int j = 0; j < 5; ++j)
              {
                BOOST_TEST(std::abs(target.curvature(j, i) -
                                    column[j] / (2. * h)) < 1e-7);
                BOOST_TEST(std::abs(target.curvature(j, i) -
                                    target.curvature(i, j)) < 1e-14);
              }
          }
      }
}



// A body of given motion has no unknowns; the gap is curved in x alone, and
// its motion over the step is that of the material point.
BOOST_AUTO_TEST_CASE(given_motion)
{
  const auto body = rigid_body(circle + "set Motion = 0.2*t ; 0.1*t^2\n"
                                        "set Rotation = 0.3*t\n");
  BOOST_TEST(RigidTarget<2>(*body).unknowns().empty());
  Vector<double> q(2);
  q[0] = 1.2;
  q[1] = 0.4;
  const RigidTarget<2>    target(*body);
  const ContactorPoint<2> point = {Point<2>(q[0], q[1]), {}, {}, 0};
  const auto found = *target.place({q, 2.}, {q, 1.})->closest(point);
  BOOST_TEST(found.supporting_dofs.empty());
  BOOST_TEST(found.curvature.m() == 2u);

  const auto now = body->placement({q, 2.}), before = body->placement({q, 1.});
  const Point<2> centre = now.to_space(Point<2>(0.3, 0.1));
  BOOST_TEST(std::abs(found.gap - point.position.distance(centre) + 0.5) <
             1e-14);
  const Point<2> y = point.position - found.gap * found.normal;
  // The centre moves evenly, and the point goes along its arc.
  const Tensor<1, 2> arm    = y - now.centre - now.translation;
  const Tensor<1, 2> motion = now.translation - before.translation +
                              0.3 * Tensor<1, 2>({-arm[1], arm[0]});
  BOOST_TEST((motion - found.motion).norm() < 1e-14);
}



// A wheel of radius R that turns by an angle phi on a body at rest rubs along
// the arc R phi, also over more than half a turn; if it rolls it does not slip.
BOOST_AUTO_TEST_CASE(rolling)
{
  const auto wheel =
    rigid_body("set Shape = circle\nsubsection Circle\n set Centre = 0, 0.5\n"
               " set Radius = 0.5\nend\nset Free = x, y, rotation\n"
               "set Centre of rotation = 0, 0.5\n");
  const RigidTarget<2> target(*wheel);
  for (const double phi : {0.1, 3., 4., 20.})
    for (const bool rolls : {true, false})
      {
        Vector<double> before(5), now(5);
        if (rolls)
          now[2] = 0.5 * phi;
        now[4]           = -phi * wheel->lever();
        const auto found = *target.place({now, 1.}, {before, 0.})
                              ->closest({Point<2>(now[2], 0.), {}, {}, 0});
        const double motion = rolls ? 0. : -0.5 * phi;
        BOOST_TEST(std::abs(found.gap) < 1e-14);
        BOOST_TEST(std::abs(found.motion[0] - motion) < 1e-14);
        BOOST_TEST(std::abs(found.motion[1]) < 1e-14);
      }
}



// Where a point of the body is, and back; a free body with the unknowns of a
// given motion is where that motion puts it.
BOOST_AUTO_TEST_CASE(placement)
{
  const std::string centre = "set Centre of rotation = 0.2, -0.1\n";
  const auto        given  = rigid_body(circle + centre +
                                "set Motion = 0.2*t ; 0.1*t^2\n"
                                        "set Rotation = 0.3*t\n");
  const auto        moved  = rigid_body(circle + free);
  Vector<double>    q(5);
  q[2]                   = 0.4;
  q[3]                   = 0.4;
  q[4]                   = 0.6 * moved->lever();
  const auto placement   = given->placement({q, 2.});
  const auto of_unknowns = moved->placement({q, 0.});
  for (const Point<2> &X : {Point<2>(0.2, -0.1), Point<2>(1., 2.)})
    {
      const Point<2>     x   = placement.to_space(X);
      const Tensor<1, 2> arm = X - Point<2>(0.2, -0.1);
      const Point<2>     expected(0.6 + std::cos(0.6) * arm[0] -
                                std::sin(0.6) * arm[1],
                              0.3 + std::sin(0.6) * arm[0] +
                                std::cos(0.6) * arm[1]);
      BOOST_TEST(x.distance(expected) < 1e-14);
      BOOST_TEST(placement.to_body(x).distance(X) < 1e-14);
      BOOST_TEST(of_unknowns.to_space(X).distance(expected) < 1e-14);
    }
}

BOOST_AUTO_TEST_SUITE_END()
