#include <signorini/linear_algebra/sparse_cholesky.h>
#include <signorini/solid/stress_recovery.h>

#include <deal.II/base/numbers.h>

#include <boost/test/unit_test.hpp>

#include "test_body.h"

BOOST_AUTO_TEST_SUITE(solid_model)

using namespace Signorini;
using namespace dealii;

namespace
{
  // Static solution under the loads and supports of the model.
  template <int dim>
  Vector<double>
  solve(const SolidModel<dim> &model)
  {
    Vector<double> u(model.n_dofs()), motion(model.n_dofs());
    model.apply_supports(1., u);
    Vector<double> r(model.external_force(1., u));
    r -= model.respond({u}, {}).internal_force;
    SparseCholesky cholesky;
    cholesky.analyse(model.sparsity(), model.dof_map().constrained(), {});
    cholesky.factorise(model.stiffness());
    cholesky.solve(motion, r);
    u += motion;
    model.dof_map().constraints().distribute(u);
    return u;
  }

  template <int dim>
  SolidModel<dim>
  static_model(const std::string &section, const Formulation formulation)
  {
    auto model = test_model<dim>(section, formulation);
    model.assemble({false, false, ContactMass::consistent, {}});
    return model;
  }

  double
  relative(const double found, const double truth)
  {
    return std::abs(found / truth - 1.);
  }

  const std::string block = "set Mesh = rectangle\n"
                            "subsection Rectangle\n"
                            " set Corners = 1, 0 ; 3, 1\n set Cells = 3, 2\n"
                            "end\n"
                            "set Refinements near = 1, 0 : 0.5 : 1\n"
                            "subsection Material\n"
                            " set Young's modulus = 1000\n"
                            " set Poisson's ratio = 0.3\nend\n";
} // namespace



// Uniform tension of a block with hanging nodes: u is linear, exactly.
BOOST_AUTO_TEST_CASE(uniform_tension)
{
  const std::string pulled = block + "subsection Supports\n"
                                     " set Fixed = left: x | bottom: y\nend\n"
                                     "subsection Loads\n"
                                     " set Traction = right: 10 ; 0\nend\n";
  const double      E = 1000., nu = 0.3, p = 10.;
  for (const unsigned int degree : {1u, 2u, 3u})
    {
      const std::string section =
        pulled + "set Element degree = " + std::to_string(degree) + "\n";
      for (const auto formulation :
           {Formulation::plane_stress, Formulation::plane_strain})
        {
          const auto     model = static_model<2>(section, formulation);
          const auto     u     = solve(model);
          const bool     thin  = formulation == Formulation::plane_stress;
          const double   ex    = (thin ? 1. : 1. - nu * nu) * p / E;
          const double   ey    = -(thin ? nu : nu * (1. + nu)) * p / E;
          Vector<double> difference =
            interpolate(model, [&](const Point<2> &x, const unsigned int c) {
              return c == 0 ? ex * (x[0] - 1.) : ey * x[1];
            });
          difference -= u;
          BOOST_TEST(difference.linfty_norm() < 1e-13);

          const StressRecovery<2> recovery(*model.parts()[0].body);
          const auto              fields = recovery.fields(u, {});
          const double            zz     = thin ? 0. : nu * p;
          const double            mises  = std::sqrt(p * p + zz * zz - p * zz);
          for (unsigned int n = 0; n < fields.at("stress_xx").size(); ++n)
            {
              BOOST_TEST(relative(fields.at("stress_xx")[n], p) < 1e-11);
              BOOST_TEST(std::abs(fields.at("stress_yy")[n]) < 1e-10);
              BOOST_TEST(std::abs(fields.at("stress_zz")[n] - zz) < 1e-10);
              BOOST_TEST(relative(fields.at("von_mises")[n], mises) < 1e-11);
              // deal.II's closed formula of the eigenvalues loses half the
              // digits where two of them are equal
              BOOST_TEST(relative(fields.at("maximum_shear")[n], p / 2.) <
                         1e-7);
            }
        }
    }
}



// The same in three dimensions, by prescribed motion.
BOOST_AUTO_TEST_CASE(uniform_tension_in_space)
{
  const auto model = static_model<3>(
    "set Mesh = box\nsubsection Box\n set Corners = 0, 0, 0 ; 2, 1, 1\n"
    " set Cells = 2, 2, 1\nend\n"
    "subsection Material\n set Young's modulus = 1000\n"
    " set Poisson's ratio = 0.3\nend\n"
    "subsection Supports\n"
    " set Fixed = left: x | bottom: y | back: z\n"
    " set Prescribed motion = right: x = 0.02*t\nend\n",
    Formulation::three_dimensional);
  Vector<double> difference =
    interpolate(model, [&](const Point<3> &x, const unsigned int c) {
      return c == 0 ? 0.01 * x[0] : -0.003 * x[c];
    });
  difference -= solve(model);
  BOOST_TEST(difference.linfty_norm() < 1e-13);
}



// Lame's thick cylinder in the axisymmetric formulation: second order in h.
BOOST_AUTO_TEST_CASE(thick_cylinder)
{
  const double E = 1000., nu = 0.3, p = 10., a = 1., b = 3.;
  // plane strain between two frictionless plates
  const double factor = p * a * a / (b * b - a * a);
  const double truth =
    (1. + nu) / E * factor * ((1. - 2. * nu) * a + b * b / a);
  double errors[2];
  for (const unsigned int refinement : {1u, 2u})
    {
      const auto model = static_model<2>(
        "set Mesh = rectangle\nsubsection Rectangle\n"
        " set Corners = 1, 0 ; 3, 1\n set Cells = 8, 2\nend\n"
        "set Global refinements = " +
          std::to_string(refinement) +
          "\nsubsection Material\n set Young's modulus = 1000\n"
          " set Poisson's ratio = 0.3\nend\n"
          "subsection Supports\n set Fixed = bottom: y | top: y\nend\n"
          "subsection Loads\n set Pressure = left: 10\nend\n",
        Formulation::axisymmetric);
      const auto  u    = solve(model);
      const auto &node = model.parts()[0].body->node_near(Point<2>(1., 0.), "");
      errors[refinement - 1] = relative(u[node.dofs[0]], truth);
    }
  BOOST_TEST(errors[1] < 1e-3);
  BOOST_TEST(std::abs(std::log2(errors[0] / errors[1]) - 2.) < 0.2);
}



// Resultants of every kind of load.
BOOST_AUTO_TEST_CASE(resultants)
{
  const auto model =
    static_model<2>(block + "set Thickness = 0.5\n"
                            "subsection Loads\n"
                            " set Traction = right: 3*y ; 7\n"
                            " set Pressure = top: 4*t\n"
                            " set Body force = 0 ; 5*x\n"
                            " set Gravity = 2 ; 0\n"
                            " set Point force = 3, 1: 11 ; 13\n"
                            " set Angular velocity = 2\nend\n",
                    Formulation::plane_strain);
  const Vector<double> &F =
    model.external_force(1., Vector<double>(model.n_dofs()));
  double x = 0., y = 0.;
  for (const auto &node : model.parts()[0].body->nodes())
    {
      x += F[node.dofs[0]];
      y += F[node.dofs[1]];
    }
  // int x dV = 0.5 * 4 = 2, int y dV = 0.5 * 1 = 0.5 (thickness 0.5), V = 1
  const double rho = 7800., w2 = 4.;
  BOOST_TEST(relative(x, 0.5 * 1.5 + rho * 2. * 1. + 11. + rho * w2 * 2.) <
             1e-13);
  BOOST_TEST(
    relative(y, 0.5 * 7. - 0.5 * 4. * 2. + 5. * 2. + 13. + rho * w2 * 0.5) <
    1e-13);
}



// A centrifugal load on an axisymmetric body: the force of the full circle.
BOOST_AUTO_TEST_CASE(axisymmetric_centrifugal_load)
{
  const auto model =
    static_model<2>(block +
                      "subsection Loads\n set Angular velocity = 3\nend\n",
                    Formulation::axisymmetric);
  const Vector<double> &force =
    model.external_force(0., Vector<double>(model.n_dofs()));
  double radial = 0., axial = 0.;
  for (const auto &node : model.parts()[0].body->nodes())
    {
      radial += force[node.dofs[0]];
      axial += force[node.dofs[1]];
    }
  // int rho w^2 r 2 pi r dr dz, r = 1..3, z = 0..1
  const double truth = 7800. * 9. * 2. * numbers::PI * 26. / 3.;
  BOOST_TEST(relative(radial, truth) < 1e-13);
  BOOST_TEST(std::abs(axial) < 1e-9 * truth);
}



// Lumping keeps the mass and leaves a diagonal matrix.
BOOST_AUTO_TEST_CASE(lumped_mass)
{
  for (const unsigned int degree : {1u, 2u})
    {
      auto model =
        test_model<2>(block + "set Element degree = " + std::to_string(degree) +
                        "\n",
                      Formulation::plane_stress);
      model.assemble({true, true, ContactMass::consistent, {}});
      double total = 0.;
      for (unsigned int i = 0; i < model.n_dofs(); ++i)
        {
          total += model.mass().diag_element(i);
          if (!model.dof_map().is_constrained(i))
            BOOST_TEST(model.mass().diag_element(i) > 0.);
        }
      // condensing hanging nodes spreads their part over off-diagonals
      const auto moving =
        interpolate(model, [](const Point<2> &, const unsigned int c) {
          return c == 0 ? 1. : 0.;
        });
      BOOST_TEST(relative(model.mass().matrix_norm_square(moving), 7800. * 2.) <
                 1e-12);
      BOOST_TEST(total <= 2. * 7800. * 2. * (1. + 1e-12));
    }
}

// With finite strains pressure and centrifugal load follow the body: turned by
// 90 degrees about the origin, made twice as long and moved by (0.5, 0).
BOOST_AUTO_TEST_CASE(loads_follow_large_motions)
{
  const auto turned = [](const Point<2> &point, const unsigned int c) {
    return c == 0 ? -point[1] - point[0] + 0.5 : 2. * point[0] - point[1];
  };
  const std::string loads = "set Thickness = 0.5\nsubsection Loads\n"
                            " set Pressure = right: 4 | top: 3\n"
                            " set Angular velocity = 2\nend\n";
  auto              model = test_model<2>(block + loads,
                             Formulation::plane_strain,
                             Kinematics::finite_strain);
  model.assemble({false, false, ContactMass::consistent, {}});
  const Vector<double>  u = interpolate(model, turned);
  const Vector<double> &F = model.external_force(1., u);
  double                x = 0., y = 0.;
  for (const auto &node : model.parts()[0].body->nodes())
    {
      x += F[node.dofs[0]];
      y += F[node.dofs[1]];
    }
  // The right side looks up now and is as long as before; the top looks to the
  // left and is 4 m long. The centre of the mass is at (0, 4).
  const double mass = 7800. * 2. * 0.5;
  BOOST_TEST(std::abs(x - 0.5 * 3. * 4.) < 1e-11 * mass);
  BOOST_TEST(relative(y, -0.5 * 4. * 1. + mass * 4. * 4.) < 1e-13);

  // Around an axis the area grows with the radius as well.
  auto ring = test_model<2>(block + "subsection Loads\n"
                                    " set Pressure = left: 4\nend\n",
                            Formulation::axisymmetric,
                            Kinematics::finite_strain);
  ring.assemble({false, false, ContactMass::consistent, {}});
  const Vector<double> wide =
    interpolate(ring, [](const Point<2> &, const unsigned int c) {
      return c == 0 ? 0.5 : 0.;
    });
  double radial = 0.;
  for (const auto &node : ring.parts()[0].body->nodes())
    radial += ring.external_force(1., wide)[node.dofs[0]];
  BOOST_TEST(relative(radial, 4. * 2. * numbers::PI * 1.5) < 1e-13);
}

BOOST_AUTO_TEST_SUITE_END()
