#include <signorini/contact/contact_model.h>
#include <signorini/contact/rigid_target.h>

#include <boost/test/unit_test.hpp>

#include "test_body.h"

BOOST_AUTO_TEST_SUITE(contact_model)

using namespace Signorini;
using namespace dealii;

namespace
{
  // A block whose lower side touches a circle; one corner is held in x.
  struct Setup
  {
    SolidModel<2>                 solid;
    std::unique_ptr<RigidBody<2>> ball;
    ContactModel<2>               contact;

    Setup()
      : solid(test_model<2>("set Mesh = rectangle\nsubsection Rectangle\n"
                            " set Corners = 0, 0 ; 2, 1\n set Cells = 3, 2\n"
                            "end\nsubsection Supports\n"
                            " set Fixed = point 0, 0: x\nend\n",
                            Formulation::plane_strain))
      , ball(create_ball())
      , contact(create_contact(solid, *ball))
    {}

    static std::unique_ptr<RigidBody<2>>
    create_ball()
    {
      ParameterHandler prm;
      RigidBody<2>::declare_parameters(prm);
      prm.parse_input_from_string("set Shape = circle\nsubsection Circle\n"
                                  " set Centre = 0.8, -1.5\n"
                                  " set Radius = 1.2\nend\n");
      return std::make_unique<RigidBody<2>>("ball", "", Constants(), 0, prm);
    }

    static ContactModel<2>
    create_contact(const SolidModel<2> &solid, const RigidBody<2> &ball)
    {
      std::vector<ContactModel<2>::PairDescription> pairs;
      pairs.push_back({solid.parts()[0].body.get(),
                       "bottom",
                       std::make_unique<RigidTarget<2>>(ball)});
      return ContactModel<2>(std::move(pairs),
                             solid.is_fixed(),
                             solid.constraints());
    }

    // Contact forces at fixed multipliers, on all unknowns.
    Vector<double>
    forces(const Vector<double>      &displacement,
           const std::vector<double> &multipliers) const
    {
      Vector<double> result(solid.n_dofs());
      contact.add_contact_forces(contact.evaluate({displacement, 0.}),
                                 InterfaceForces(multipliers),
                                 1.,
                                 result);
      return result;
    }
  };
} // namespace



// The geometric contact term is minus the derivative of the contact forces at
// fixed multipliers; central differences, their error is of order 1e-10.
BOOST_AUTO_TEST_CASE(geometric_stiffness)
{
  const Setup               setup;
  const auto               &dofs        = setup.contact.interface_dofs();
  const std::vector<double> multipliers = {3., 0., 5., 2.};
  Vector<double>            u(setup.solid.n_dofs());
  for (unsigned int i = 0; i < u.size(); ++i)
    u[i] = 0.01 * std::sin(1. + i);
  BOOST_TEST(setup.contact.n_contacts() == 4u);
  BOOST_TEST(dofs.size() == 7u);

  FullMatrix<double> stiffness(dofs.size(), dofs.size());
  setup.contact.add_geometric_stiffness(setup.contact.evaluate({u, 0.}),
                                        multipliers,
                                        stiffness);
  BOOST_TEST(stiffness.frobenius_norm() > 1.);
  const double h = 1e-5;
  for (unsigned int j = 0; j < dofs.size(); ++j)
    {
      Vector<double> after(u), before(u);
      after[dofs[j]] += h;
      before[dofs[j]] -= h;
      const Vector<double> plus  = setup.forces(after, multipliers);
      const Vector<double> minus = setup.forces(before, multipliers);
      for (unsigned int i = 0; i < dofs.size(); ++i)
        BOOST_TEST(std::abs(stiffness(i, j) + (plus[dofs[i]] - minus[dofs[i]]) /
                                                (2. * h)) < 1e-8);
    }
}



// G - A du is the gap after a small motion, up to second order.
BOOST_AUTO_TEST_CASE(linearised_gaps)
{
  const Setup          setup;
  const auto          &dofs = setup.contact.interface_dofs();
  const Vector<double> u(setup.solid.n_dofs());
  const auto           contacts =
    setup.contact.constraints(setup.contact.evaluate({u, 0.}),
                              std::vector<double>(4, 0.));
  Vector<double> moved(u), motion(dofs.size());
  for (unsigned int i = 0; i < dofs.size(); ++i)
    {
      motion[i] = 1e-5 * std::cos(1. + i);
      moved[dofs[i]] += motion[i];
    }
  const auto after = setup.contact.evaluate({moved, 0.});
  for (unsigned int k = 0; k < contacts.size(); ++k)
    BOOST_TEST(std::abs(contacts[k].gap - contacts[k].normal.dot(motion) -
                        after[k].gap) < 1e-9);
}

BOOST_AUTO_TEST_SUITE_END()
