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

  // Calls check(case, dimension).
  template <typename Check>
  void
  for_all_cases(const Check &check)
  {
    for (const Case &test : cases())
      BOOST_TEST_CONTEXT(test.name)
      {
        if (test.formulation == Formulation::three_dimensional)
          check(test, std::integral_constant<int, 3>());
        else
          check(test, std::integral_constant<int, 2>());
      }
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
  for_all_cases([](const Case &test, const auto dim) {
    check_tangents<decltype(dim)::value>(test);
  });
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
      const auto   after = model.respond({turned, 1.}, before.history);
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



namespace
{
  // Work of the mean force of a step beside the change of the stored energy,
  // and its resultants, which are zero, relative to the size of its terms.
  template <int dim>
  void
  check_mean_force(const SolidModel<dim> &model,
                   const Vector<double>  &u_n,
                   const Vector<double>  &u)
  {
    const auto history = model.initial_history();
    const auto before  = model.respond({u_n, 1.}, history);
    const auto after   = model.respond({u, 1., &u_n}, history);
    double     work = 0., terms = 0.;
    for (unsigned int i = 0; i < u.size(); ++i)
      {
        work += after.mean_force[i] * (u[i] - u_n[i]);
        terms += std::abs(after.mean_force[i] * (u[i] - u_n[i]));
      }
    BOOST_TEST(std::abs(work - (after.stored_energy - before.stored_energy)) <
               1e-9 * terms + 1e-14 * after.stored_energy);

    Tensor<1, dim> sum;
    Tensor<2, dim> moments;
    for (const auto &node : model.parts()[0].body->nodes())
      {
        Tensor<1, dim> force, middle(node.point);
        for (unsigned int c = 0; c < dim; ++c)
          {
            force[c] = after.mean_force[node.dofs[c]];
            middle[c] += 0.5 * (u_n[node.dofs[c]] + u[node.dofs[c]]);
          }
        sum += force;
        moments += outer_product(middle, force);
      }
    const double scale = after.mean_force.linfty_norm();
    if (model.parts()[0].body->formulation() == Formulation::axisymmetric)
      {
        BOOST_TEST(std::abs(sum[1]) < 1e-12 * scale);
        return;
      }
    BOOST_TEST(sum.norm() < 1e-12 * scale);
    if (model.parts()[0].body->kinematics() == Kinematics::finite_strain)
      BOOST_TEST((moments - transpose(moments)).norm() < 1e-12 * scale);
  }

  template <int dim>
  void
  check_mean_forces(const Case &test)
  {
    for (const std::string law :
         {" set Law = elastic\n", " set Law = neo-Hooke\n"})
      {
        const auto           model = make_model<dim>(test, law);
        const Vector<double> u_n   = random_motion(model, 0.05);
        for (const double size : {1e-6, 1e-3, 0.3, 1.})
          {
            Vector<double> u = random_motion(model, 0.1);
            for (unsigned int i = 0; i < u.size(); ++i)
              u[i] = u_n[i] + size * (i % 3 == 0 ? u[i] : -u_n[i]);
            check_mean_force(model, u_n, u);
          }
      }
  }
} // namespace



BOOST_AUTO_TEST_CASE(mean_force_does_the_work_of_the_energy_and_no_more)
{
  for_all_cases([](const Case &test, const auto dim) {
    check_mean_forces<decltype(dim)::value>(test);
  });
}



namespace
{
  // The displacement after a turn about the origin.
  Vector<double>
  turned(const SolidModel<2>  &model,
         const Vector<double> &u,
         const double          angle)
  {
    Vector<double> result(u.size());
    for (const auto &node : model.parts()[0].body->nodes())
      {
        const double x = node.point[0] + u[node.dofs[0]];
        const double y = node.point[1] + u[node.dofs[1]];
        result[node.dofs[0]] =
          x * std::cos(angle) - y * std::sin(angle) - node.point[0];
        result[node.dofs[1]] =
          x * std::sin(angle) + y * std::cos(angle) - node.point[1];
      }
    return result;
  }

  SolidModel<2>
  rubber(const std::string &dilatation)
  {
    return make_model<2>(
      {"", Formulation::plane_strain, Kinematics::finite_strain, dilatation},
      " set Law = neo-Hooke\n");
  }

  // Largest difference of the tangent of a step from the symmetric part of
  // twice the derivative of its mean force, relative to its largest entry.
  double
  step_tangent_error(const SolidModel<2>  &model,
                     const Vector<double> &u_n,
                     const Vector<double> &u)
  {
    const auto           history = model.initial_history();
    const unsigned int   n       = model.n_dofs();
    constexpr double     step    = 1e-6;
    SparseMatrix<double> tangent;
    model.respond({u, 1., &u_n}, history, &tangent);
    FullMatrix<double> derivative(n);
    for (unsigned int j = 0; j < n; ++j)
      {
        Vector<double> shifted(u);
        shifted[j] += step;
        Vector<double> change =
          model.respond({shifted, 1., &u_n}, history).mean_force;
        shifted[j] -= 2. * step;
        change -= model.respond({shifted, 1., &u_n}, history).mean_force;
        for (unsigned int i = 0; i < n; ++i)
          derivative(i, j) = change[i] / step;
      }
    double error = 0., largest = 0.;
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        {
          const double entry = tangent.el(i, j);
          const double mean  = 0.5 * (derivative(i, j) + derivative(j, i));
          largest            = std::max(largest, std::abs(entry));
          error              = std::max(error, std::abs(entry - mean));
        }
    return error / largest;
  }
} // namespace



BOOST_AUTO_TEST_CASE(mean_force_of_a_rotation_does_no_work)
{
  for (const std::string &dilatation :
       {std::string("pointwise"), std::string("mean"), quadratic})
    for (const double angle : {1e-4, 0.03, 1.})
      {
        const auto           model = rubber(dilatation);
        const Vector<double> u     = random_motion(model, 0.05);
        check_mean_force(model, u, turned(model, u, angle));
      }
}



BOOST_AUTO_TEST_CASE(tangent_of_a_rotation_is_of_second_order)
{
  for (const std::string &dilatation :
       {std::string("pointwise"), std::string("mean"), quadratic})
    BOOST_TEST_CONTEXT(dilatation)
    {
      const auto           model = rubber(dilatation);
      const Vector<double> u     = random_motion(model, 0.05);
      const double error = step_tangent_error(model, u, turned(model, u, 0.2));
      BOOST_TEST(error < 0.01);
      BOOST_TEST(step_tangent_error(model, u, turned(model, u, 0.1)) <
                 0.3 * error);
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
