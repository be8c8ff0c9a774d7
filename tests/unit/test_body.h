#ifndef signorini_tests_test_body_h
#define signorini_tests_test_body_h

#include <signorini/solid/solid_model.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace Signorini
{
  /** A model of one body "b", from the text of its section in a .prm. */
  template <int dim>
  SolidModel<dim>
  test_model(const std::string &section, const Formulation formulation)
  {
    dealii::ParameterHandler prm;
    Body<dim>::declare_parameters({}, prm);
    Loads<dim>::declare_parameters(prm);
    Supports<dim>::declare_parameters(prm);
    prm.parse_input_from_string(section);
    auto       body = std::make_unique<Body<dim>>("b", formulation, "", 0, prm);
    Loads<dim> loads(*body, {}, prm);
    Supports<dim>                               supports(*body, {}, prm);
    std::vector<typename SolidModel<dim>::Part> parts;
    parts.push_back({std::move(body), std::move(loads), std::move(supports)});
    return SolidModel<dim>(std::move(parts));
  }

  /** A vector over all unknowns from a function of point and component. */
  template <int dim, typename Field>
  dealii::Vector<double>
  interpolate(const SolidModel<dim> &model, const Field &field)
  {
    dealii::Vector<double> v(model.n_dofs());
    for (const auto &node : model.parts()[0].body->nodes())
      for (unsigned int c = 0; c < dim; ++c)
        v[node.dofs[c]] = field(node.point, c);
    model.constraints().distribute(v);
    return v;
  }
} // namespace Signorini

#endif
