#include <boost/test/unit_test.hpp>

#include <cmath>
#include <random>

#include "test_body.h"

// Forces, tangents and energies of bodies with large strains and with plastic
// flow, cell by cell.
BOOST_AUTO_TEST_SUITE(solid_response)

using namespace Signorini;
using namespace dealii;

namespace
{
  struct Case
  {
    std::string name;
    Formulation formulation;
    Kinematics  kinematics;
    std::string dilatation; // and further entries of the body
  };

  // Polynomials of degree 1 take the place of the mean.
  const std::string quadratic = "mean\nset Element degree = 2";

  std::vector<Case>
  cases()
  {
    std::vector<Case> list;
    for (const auto kinematics :
         {Kinematics::small_strain, Kinematics::finite_strain})
      for (const auto &dilatation : {"pointwise", "mean"})
        {
          const std::string name =
            std::string(kinematics == Kinematics::small_strain ? "small" :
                                                                 "finite") +
            " strain, " + dilatation + ", ";
          list.push_back({name + "plane strain",
                          Formulation::plane_strain,
                          kinematics,
                          dilatation});
          list.push_back({name + "axisymmetric",
                          Formulation::axisymmetric,
                          kinematics,
                          dilatation});
          list.push_back({name + "three dimensional",
                          Formulation::three_dimensional,
                          kinematics,
                          dilatation});
        }
    // In three dimensions nothing else would be tested, for much longer.
    for (const auto formulation :
         {Formulation::plane_strain, Formulation::axisymmetric})
      list.push_back(
        {"quadratic", formulation, Kinematics::finite_strain, quadratic});
    for (const auto kinematics :
         {Kinematics::small_strain, Kinematics::finite_strain})
      list.push_back(
        {"plane stress", Formulation::plane_stress, kinematics, "pointwise"});
    return list;
  }

  template <int dim>
  std::string
  section(const std::string &dilatation, const std::string &law)
  {
    const std::string mesh =
      dim == 2 ?
        "set Mesh = rectangle\nsubsection Rectangle\n"
        " set Corners = 1, 0 ; 3, 1\n set Cells = 2, 1\nend\n" :
        "set Mesh = box\nsubsection Box\n"
        " set Corners = 1, 0, 0 ; 3, 1, 1\n set Cells = 2, 1, 1\nend\n";
    return mesh + "set Dilatation = " + dilatation +
           "\nsubsection Material\n set Young's modulus = 1000\n"
           " set Poisson's ratio = 0.3\n" +
           law + "end\n";
  }

  const std::string plastic = " set Law = elasto-plastic\n"
                              " set Yield stress = 10\n"
                              " set Hardening modulus = 50\n";

  template <int dim>
  SolidModel<dim>
  make_model(const Case &test, const std::string &law)
  {
    auto model = test_model<dim>(section<dim>(test.dilatation, law),
                                 test.formulation,
                                 test.kinematics);
    model.assemble({false, false, ContactMass::consistent, {}});
    return model;
  }

  template <int dim>
  Vector<double>
  random_motion(const SolidModel<dim> &model, const double size)
  {
    std::mt19937                           random(7);
    std::uniform_real_distribution<double> between(-size, size);
    Vector<double>                         u(model.n_dofs());
    for (double &component : u)
      component = between(random);
    return u;
  }

  // Largest difference of the tangent from central differences of the forces,
  // relative to its largest entry.
  template <int dim>
  double
  tangent_error(const SolidModel<dim>     &model,
                const Vector<double>      &u,
                const std::vector<double> &history)
  {
    SparseMatrix<double> tangent;
    model.respond({u, 1.}, history, &tangent);
    const double step  = 1e-6;
    double       error = 0., largest = 0.;
    for (unsigned int j = 0; j < model.n_dofs(); ++j)
      {
        Vector<double> shifted(u);
        shifted[j] += step;
        Vector<double> difference =
          model.respond({shifted, 1.}, history).internal_force;
        shifted[j] -= 2. * step;
        difference -= model.respond({shifted, 1.}, history).internal_force;
        for (unsigned int i = 0; i < model.n_dofs(); ++i)
          {
            const double entry = tangent.el(i, j);
            largest            = std::max(largest, std::abs(entry));
            error =
              std::max(error, std::abs(entry - difference[i] / (2. * step)));
          }
      }
    return error / largest;
  }

  template <int dim>
  void
  check_tangents(const Case &test)
  {
    // 1. Elastic, far from the start; neo-Hooke is the same law as elastic when
    // strains are small, and then linear, without a tangent of its own.
    if (test.kinematics == Kinematics::finite_strain)
      for (const std::string law :
           {" set Law = elastic\n", " set Law = neo-Hooke\n"})
        {
          const auto model = make_model<dim>(test, law);
          BOOST_TEST(tangent_error(model,
                                   random_motion(model, 0.1),
                                   model.initial_history()) < 1e-8);
        }

    // 2. While everything flows, after a first plastic step.
    const auto model   = make_model<dim>(test, plastic);
    const auto u       = random_motion(model, 0.1);
    const auto flowing = model.respond({u, 1.}, model.initial_history());
    BOOST_TEST(flowing.plastic_work > 0.);
    Vector<double> further(u);
    further *= 1.3;
    BOOST_TEST(tangent_error(model, further, flowing.history) < 1e-6);
  }
} // namespace



BOOST_AUTO_TEST_CASE(tangent_is_the_derivative_of_the_forces)
{
  for (const Case &test : cases())
    BOOST_TEST_CONTEXT(test.name)
    {
      if (test.formulation == Formulation::three_dimensional)
        check_tangents<3>(test);
      else
        check_tangents<2>(test);
    }
}



BOOST_AUTO_TEST_CASE(forces_are_the_derivative_of_the_energy)
{
  for (const Case &test : cases())
    if (test.formulation != Formulation::three_dimensional)
      BOOST_TEST_CONTEXT(test.name)
      {
        const auto     model   = make_model<2>(test, " set Law = elastic\n");
        const auto     history = model.initial_history();
        Vector<double> u       = random_motion(model, 0.1);
        const auto     here    = model.respond({u, 1.}, history);
        const double   step    = 1e-5;
        for (unsigned int i = 0; i < model.n_dofs(); ++i)
          {
            u[i] += step;
            const double more = model.respond({u, 1.}, history).stored_energy;
            u[i] -= 2. * step;
            const double less = model.respond({u, 1.}, history).stored_energy;
            u[i] += step;
            BOOST_TEST(
              std::abs((more - less) / (2. * step) - here.internal_force[i]) <
              1e-8 * here.internal_force.linfty_norm());
          }
      }
}



BOOST_AUTO_TEST_CASE(rigid_rotation_leaves_forces_turned_and_no_flow)
{
  for (const std::string &dilatation :
       {std::string("pointwise"), std::string("mean"), quadratic})
    {
      const auto model = make_model<2>(
        {"", Formulation::plane_strain, Kinematics::finite_strain, dilatation},
        plastic);
      const Vector<double> u = random_motion(model, 0.05);
      const auto before      = model.respond({u, 1.}, model.initial_history());

      // By 90 degrees about the origin in one step: (x, y) to (-y, x).
      Vector<double> turned(model.n_dofs());
      for (const auto &node : model.parts()[0].body->nodes())
        {
          const double x       = node.point[0] + u[node.dofs[0]];
          const double y       = node.point[1] + u[node.dofs[1]];
          turned[node.dofs[0]] = -y - node.point[0];
          turned[node.dofs[1]] = x - node.point[1];
        }
      const auto   after = model.respond(turned, 1., before.history);
      const double scale = before.internal_force.linfty_norm();
      for (const auto &node : model.parts()[0].body->nodes())
        {
          BOOST_TEST(std::abs(after.internal_force[node.dofs[0]] +
                              before.internal_force[node.dofs[1]]) <
                     1e-11 * scale);
          BOOST_TEST(std::abs(after.internal_force[node.dofs[1]] -
                              before.internal_force[node.dofs[0]]) <
                     1e-11 * scale);
        }
      BOOST_TEST(std::abs(after.plastic_work - before.plastic_work) <
                 1e-11 * before.plastic_work);
    }
}



BOOST_AUTO_TEST_CASE(a_cell_inside_out_is_named)
{
  const auto model = make_model<2>(
    {"", Formulation::plane_strain, Kinematics::finite_strain, "mean"},
    plastic);
  Vector<double> u(model.n_dofs());
  for (const auto &node : model.parts()[0].body->nodes())
    if (node.point[0] > 2.5)
      u[node.dofs[0]] = -1.5;
  try
    {
      model.respond({u, 1.}, model.initial_history());
      BOOST_ERROR("nothing thrown");
    }
  catch (const MaterialFailure &failure)
    {
      const std::string message = failure.what();
      BOOST_TEST_CONTEXT(message)
      {
        BOOST_TEST(message.find("body b") != std::string::npos);
        BOOST_TEST(message.find("(2.5 0.5)") != std::string::npos);
        BOOST_TEST(message.find("inside out") != std::string::npos);
      }
    }
}

BOOST_AUTO_TEST_SUITE_END()
