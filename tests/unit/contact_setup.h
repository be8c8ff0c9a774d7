#ifndef signorini_tests_contact_setup_h
#define signorini_tests_contact_setup_h

#include <signorini/contact/contact_model.h>
#include <signorini/contact/deforming_curve.h>
#include <signorini/contact/rigid_target.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "test_body.h"

namespace Signorini
{
  /** The text of a section of a rectangular body. */
  inline std::string
  rectangle(const std::string &corners,
            const std::string &cells,
            const unsigned int degree = 1,
            const std::string &more   = "")
  {
    return "set Mesh = rectangle\nsubsection Rectangle\n set Corners = " +
           corners + "\n set Cells = " + cells +
           "\nend\nset Element degree = " + std::to_string(degree) + "\n" +
           more;
  }

  /** The same, turned by an angle in degrees about the origin. */
  inline std::string
  turned_rectangle(const std::string &corners,
                   const std::string &cells,
                   const unsigned int degree,
                   const double       angle)
  {
    return rectangle(corners,
                     cells,
                     degree,
                     "subsection Rectangle\n set Angle = " +
                       std::to_string(angle) + "\nend\n");
  }

  /** One pair. */
  inline ContactModel<2>
  create_contact(ContactPairDescription<2> &&pair, const SolidModel<2> &solid)
  {
    std::vector<ContactPairDescription<2>> pairs;
    pairs.push_back(std::move(pair));
    return ContactModel<2>(std::move(pairs), solid.dof_map());
  }

  /** The plane body "a", whose boundary touches that of the body "b". */
  struct TwoBodies
  {
    SolidModel<2>   solid;
    ContactModel<2> contact;

    TwoBodies(const std::string           &contactor,
              const std::string           &contactor_boundary,
              const std::string           &target,
              const std::string           &target_boundary,
              const SurfaceInterpolation  &interpolation,
              const ContactConstraint      constraint,
              const std::array<double, 2> &motion_of_contactor = {{0., 0.}})
      : solid(test_bodies<2>({contactor, target}, Formulation::plane_strain))
      , contact(create(solid,
                       contactor_boundary,
                       target_boundary,
                       interpolation,
                       constraint))
      , shift(solid.n_dofs())
    {
      for (const auto &node : solid.parts()[0].body->nodes())
        for (unsigned int c = 0; c < 2; ++c)
          shift[node.dofs[c]] = motion_of_contactor[c];
    }

    static ContactModel<2>
    create(const SolidModel<2>        &solid,
           const std::string          &contactor_boundary,
           const std::string          &target_boundary,
           const SurfaceInterpolation &interpolation,
           const ContactConstraint     constraint)
    {
      return create_contact(
        {solid.parts()[0].body.get(),
         contactor_boundary,
         std::make_unique<DeformingCurve>(*solid.parts().back().body,
                                          target_boundary,
                                          solid.dof_map(),
                                          interpolation),
         FrictionLaw(),
         constraint},
        solid);
    }

    dealii::Vector<double> shift; // of the contactor's body, m
  };

  /** The plane body "a", whose boundary touches the rigid body "tool". */
  struct BodyOnTool
  {
    std::vector<std::unique_ptr<RigidBody<2>>> tools; // one
    SolidModel<2>                              solid;
    ContactModel<2>                            contact;

    /** @param tool the text of its section */
    BodyOnTool(
      const std::string      &body,
      const std::string      &boundary,
      const std::string      &tool,
      const FrictionLaw      &friction   = FrictionLaw(),
      const ContactConstraint constraint = ContactConstraint::node_to_surface)
      : BodyOnTool(test_part<2>("a", body, Formulation::plane_strain, 0),
                   boundary,
                   tool,
                   friction,
                   constraint)
    {}

  private:
    BodyOnTool(SolidModel<2>::Part   &&part,
               const std::string      &boundary,
               const std::string      &tool,
               const FrictionLaw      &friction,
               const ContactConstraint constraint)
      : tools(create_tools(tool, part.body->n_dofs()))
      , solid(create_solid(std::move(part), *tools[0]))
      , contact(create_contact({solid.parts()[0].body.get(),
                                boundary,
                                std::make_unique<RigidTarget<2>>(*tools[0]),
                                friction,
                                constraint},
                               solid))
    {}

    static std::vector<std::unique_ptr<RigidBody<2>>>
    create_tools(const std::string &section, const unsigned int first_unknown)
    {
      dealii::ParameterHandler prm;
      RigidBody<2>::declare_parameters(prm);
      prm.parse_input_from_string(section);
      std::vector<std::unique_ptr<RigidBody<2>>> tools;
      tools.push_back(std::make_unique<RigidBody<2>>(
        "tool", "", Constants(), first_unknown, prm));
      return tools;
    }

    static SolidModel<2>
    create_solid(SolidModel<2>::Part &&part, const RigidBody<2> &tool)
    {
      std::vector<SolidModel<2>::Part> parts;
      parts.push_back(std::move(part));
      return SolidModel<2>(std::move(parts), tool.unknowns());
    }
  };

  /** Contact forces of given multipliers on all unknowns. */
  template <int dim>
  dealii::Vector<double>
  contact_forces(const ContactModel<dim>              &contact,
                 const std::vector<ContactPoint<dim>> &points,
                 const InterfaceForces                &multipliers,
                 const unsigned int                    n_unknowns)
  {
    dealii::Vector<double> forces(n_unknowns);
    contact.add_contact_forces(points, multipliers, 1., forces);
    return forces;
  }

  /**
   * The largest |G - A du - gap(u + du)| for a motion du of this size of all
   * unknowns of the interface, m.
   */
  template <int dim>
  double
  linearisation_error(const ContactModel<dim>                 &contact,
                      const dealii::AffineConstraints<double> &hanging_nodes,
                      const dealii::Vector<double>            &u,
                      const double                             size)
  {
    const auto &dofs = contact.interface_dofs();
    const auto  contacts =
      contact.constraints(contact.evaluate({u, 0.}), contact.initial_state());
    dealii::Vector<double> moved(u), motion(dofs.size());
    for (unsigned int i = 0; i < dofs.size(); ++i)
      {
        motion[i] = size * std::cos(1. + 3. * i);
        moved[dofs[i]] += motion[i];
      }
    hanging_nodes.distribute(moved);
    const auto after = contact.evaluate({moved, 0.});
    double     error = 0.;
    for (unsigned int k = 0; k < contacts.size(); ++k)
      if (after[k].is_in_reach())
        error =
          std::max(error,
                   std::abs(contacts[k].gap - contacts[k].normal.dot(motion) -
                            after[k].gap));
    return error;
  }

  /**
   * The geometric stiffness against central differences of the contact forces
   * at fixed multipliers: the largest difference in parts of the largest
   * entry. Of facets (dim = 3) it is the symmetric part.
   */
  template <int dim>
  double
  stiffness_error(const ContactModel<dim>                 &contact,
                  const dealii::AffineConstraints<double> &hanging_nodes,
                  const dealii::Vector<double>            &u,
                  const std::vector<double>               &multipliers)
  {
    const auto                &dofs = contact.interface_dofs();
    const unsigned int         n    = dofs.size();
    dealii::FullMatrix<double> stiffness(n, n), differences(n, n);
    for (const auto &block :
         contact.geometric_stiffness(contact.evaluate({u, 0.}), multipliers))
      block.add_to(stiffness);
    const double h = 1e-6;
    for (unsigned int j = 0; j < n; ++j)
      {
        const auto forces_at = [&](const double step) {
          dealii::Vector<double> moved(u);
          moved[dofs[j]] += step;
          hanging_nodes.distribute(moved);
          return contact_forces(contact,
                                contact.evaluate({moved, 0.}),
                                InterfaceForces(multipliers),
                                u.size());
        };
        const auto plus = forces_at(h), minus = forces_at(-h);
        for (unsigned int i = 0; i < n; ++i)
          differences(i, j) = (minus[dofs[i]] - plus[dofs[i]]) / (2. * h);
      }
    double largest = stiffness.linfty_norm() / n, error = 0.;
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        {
          const double difference =
            dim == 2 ? differences(i, j) :
                       0.5 * (differences(i, j) + differences(j, i));
          largest = std::max(largest, std::abs(difference));
          error   = std::max(error, std::abs(stiffness(i, j) - difference));
        }
    return error / largest;
  }

  /** Forces that do not vanish and are not alike, N. */
  inline std::vector<double>
  some_multipliers(const unsigned int n)
  {
    std::vector<double> multipliers;
    for (unsigned int k = 0; k < n; ++k)
      multipliers.push_back(2. + std::sin(5. * k));
    return multipliers;
  }
} // namespace Signorini

#endif
