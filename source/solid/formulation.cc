#include <signorini/input_error.h>
#include <signorini/solid/formulation.h>

#include <deal.II/base/numbers.h>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    const std::array<std::pair<const char *, Formulation>, 4> names = {
      {{"plane strain", Formulation::plane_strain},
       {"plane stress", Formulation::plane_stress},
       {"axisymmetric", Formulation::axisymmetric},
       {"three dimensional", Formulation::three_dimensional}}};

    // Newton's method for the strain across the thickness that makes
    // stress_zz vanish. A linear law needs one correction.
    MaterialResponse
    plane_stress_response(const Material        &material,
                          Tensor<2, 3>          &gradient,
                          const MaterialHistory &history_n)
    {
      for (unsigned int iteration = 0; iteration < 50; ++iteration)
        {
          const MaterialResponse response =
            material.respond(gradient, history_n);
          const double stiffness = response.tangent[2][2][2][2];
          const double stress    = response.stress[2][2];
          if (std::abs(stress) <= 1e-12 * response.stress.norm() ||
              std::abs(stress) <= 1e-300)
            return response;
          const double correction = -stress / stiffness;
          if (std::abs(correction) <= 1e-16 * gradient.norm())
            return response;
          gradient[2][2] += correction;
        }
      throw ComputationError("Plane stress: the strain across the thickness "
                             "was not found in 50 iterations. Take smaller "
                             "steps.");
    }

    // Eliminates the strain zz, whose stress is zero.
    void
    condense_thickness_strain(
      ReducedTangent                                           &tangent,
      const SymmetricTensor<4, 3>                              &full,
      const std::vector<std::pair<unsigned int, unsigned int>> &components)
    {
      for (unsigned int i = 0; i < components.size(); ++i)
        for (unsigned int j = 0; j < components.size(); ++j)
          {
            const auto [a, b] = components[i];
            const auto [c, d] = components[j];
            tangent[i][j] -=
              full[a][b][2][2] * full[2][2][c][d] / full[2][2][2][2];
          }
    }
  } // namespace



  std::string
  formulation_names()
  {
    std::string list;
    for (const auto &[name, formulation] : names)
      list += (list.empty() ? "" : "|") + std::string(name);
    return list;
  }



  Formulation
  formulation_from_name(const std::string &text)
  {
    for (const auto &[name, formulation] : names)
      if (text == name)
        return formulation;
    throw InputError("Formulation: found \"" + text + "\", allowed are " +
                     formulation_names() + ".");
  }



  unsigned int
  space_dimension(const Formulation formulation)
  {
    return formulation == Formulation::three_dimensional ? 3 : 2;
  }



  const std::vector<std::pair<unsigned int, unsigned int>> &
  strain_components(const Formulation formulation)
  {
    using List = std::vector<std::pair<unsigned int, unsigned int>>;
    static const List plane        = {{0, 0}, {1, 1}, {0, 1}};
    static const List axisymmetric = {{0, 0}, {1, 1}, {2, 2}, {0, 1}};
    static const List solid = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {0, 2}};
    switch (formulation)
      {
        case Formulation::plane_strain:
        case Formulation::plane_stress:
          return plane;
        case Formulation::axisymmetric:
          return axisymmetric;
        default:
          return solid;
      }
  }



  template <int dim>
  PointResponse
  respond(const Formulation      formulation,
          const Material        &material,
          const Tensor<2, dim>  &plane_gradient,
          const double           hoop_strain,
          const MaterialHistory &history_n)
  {
    Tensor<2, 3> gradient;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j < dim; ++j)
        gradient[i][j] = plane_gradient[i][j];
    if (formulation == Formulation::axisymmetric)
      gradient[2][2] = hoop_strain;

    const MaterialResponse full =
      formulation == Formulation::plane_stress ?
        plane_stress_response(material, gradient, history_n) :
        material.respond(gradient, history_n);

    const auto   &components = strain_components(formulation);
    PointResponse reduced;
    for (unsigned int i = 0; i < components.size(); ++i)
      {
        const auto [a, b] = components[i];
        reduced.stress[i] = full.stress[a][b];
        for (unsigned int j = 0; j < components.size(); ++j)
          reduced.tangent[i][j] =
            full.tangent[a][b][components[j].first][components[j].second];
      }
    if (formulation == Formulation::plane_stress)
      condense_thickness_strain(reduced.tangent, full.tangent, components);
    reduced.full_stress    = full.stress;
    reduced.energy_density = full.energy_density;
    reduced.history        = full.history;
    return reduced;
  }



  template <int dim>
  double
  volume_factor(const Formulation formulation,
                const Point<dim> &point,
                const double      thickness)
  {
    switch (formulation)
      {
        case Formulation::axisymmetric:
          return 2. * numbers::PI * point[0];
        case Formulation::three_dimensional:
          return 1.;
        default:
          return thickness;
      }
  }



  template PointResponse
  respond<2>(const Formulation,
             const Material &,
             const Tensor<2, 2> &,
             const double,
             const MaterialHistory &);
  template PointResponse
  respond<3>(const Formulation,
             const Material &,
             const Tensor<2, 3> &,
             const double,
             const MaterialHistory &);
  template double
  volume_factor<2>(const Formulation, const Point<2> &, const double);
  template double
  volume_factor<3>(const Formulation, const Point<3> &, const double);
} // namespace Signorini
