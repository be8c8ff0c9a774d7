#ifndef signorini_tests_test_body_h
#define signorini_tests_test_body_h

#include <signorini/solid/solid_model.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace Signorini
{
  /** A body with its loads and supports, from the text of its section. */
  template <int dim>
  typename SolidModel<dim>::Part
  test_part(const std::string &name,
            const std::string &section,
            const Formulation  formulation,
            const unsigned int first_dof,
            const Kinematics   kinematics = Kinematics::small_strain)
  {
    dealii::ParameterHandler prm;
    Body<dim>::declare_parameters({}, prm);
    Loads<dim>::declare_parameters(prm);
    Supports<dim>::declare_parameters(prm);
    prm.parse_input_from_string(section);
    auto body = std::make_unique<Body<dim>>(
      name, formulation, kinematics, "", first_dof, RefinementPasses(), prm);
    Loads<dim>    loads(*body, {}, prm);
    Supports<dim> supports(*body, {}, {}, prm);
    return {std::move(body), std::move(loads), std::move(supports)};
  }

  /** A model of the bodies "a", "b", ..., from the text of their sections. */
  template <int dim>
  SolidModel<dim>
  test_bodies(const std::vector<std::string> &sections,
              const Formulation               formulation)
  {
    std::vector<typename SolidModel<dim>::Part> parts;
    unsigned int                                n_dofs = 0;
    for (const std::string &section : sections)
      {
        const std::string name(1, 'a' + parts.size());
        parts.push_back(test_part<dim>(name, section, formulation, n_dofs));
        n_dofs += parts.back().body->n_dofs();
      }
    return SolidModel<dim>(std::move(parts));
  }

  /** A model of one body "b", from the text of its section in a .prm. */
  template <int dim>
  SolidModel<dim>
  test_model(const std::string &section,
             const Formulation  formulation,
             const Kinematics   kinematics = Kinematics::small_strain)
  {
    std::vector<typename SolidModel<dim>::Part> parts;
    parts.push_back(test_part<dim>("b", section, formulation, 0, kinematics));
    return SolidModel<dim>(std::move(parts));
  }

  /** A vector over all unknowns from a function of point and component. */
  template <int dim, typename Field>
  dealii::Vector<double>
  interpolate(const SolidModel<dim> &model, const Field &field)
  {
    dealii::Vector<double> v(model.n_dofs());
    for (const auto &part : model.parts())
      for (const auto &node : part.body->nodes())
        for (unsigned int c = 0; c < dim; ++c)
          v[node.dofs[c]] = field(node.point, c);
    model.dof_map().constraints().distribute(v);
    return v;
  }
} // namespace Signorini

#endif
