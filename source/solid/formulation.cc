#include <signorini/input/input_error.h>
#include <signorini/input/instantiate.h>
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

    // tr(H) of the plane, or det(1 + H) - 1.
    double
    plane_volume_change(const Tensor<2, 3> &gradient,
                        const Kinematics    kinematics)
    {
      const double trace = gradient[0][0] + gradient[1][1];
      return kinematics == Kinematics::small_strain ?
               trace :
               trace + gradient[0][0] * gradient[1][1] -
                 gradient[0][1] * gradient[1][0];
    }

    // The thickness with which the volume has this change. Flow keeps the
    // volume, and an elastic law answers to any strain nearly linearly: this is
    // where the search starts.
    double
    thickness_of_volume(const double        volume_change,
                        const Tensor<2, 3> &gradient,
                        const Kinematics    kinematics)
    {
      const double plane = plane_volume_change(gradient, kinematics);
      if (kinematics == Kinematics::small_strain)
        return volume_change - plane;
      // An inverted plane is refused by the material.
      return plane > -1. ? (volume_change - plane) / (1. + plane) : 0.;
    }

    double
    volume_change(const Tensor<2, 3> &gradient, const Kinematics kinematics)
    {
      const double plane     = plane_volume_change(gradient, kinematics);
      const double thickness = gradient[2][2];
      return kinematics == Kinematics::small_strain ?
               plane + thickness :
               plane + thickness + plane * thickness;
    }

    MaterialResponse
    plane_stress_response(const Material         &material,
                          MaterialPoint          &point,
                          const ArrayView<double> history)
    {
      const Kinematics   kinematics = material.kinematics();
      const unsigned int n          = material.n_history_values();
      const bool         remembers  = history.size() > n;
      Tensor<2, 3>      &gradient   = point.gradient;
      if (remembers)
        gradient[2][2] =
          thickness_of_volume(point.history_n[n], gradient, kinematics);
      const MaterialResponse response =
        material.respond_in_plane_stress(point, history);
      if (remembers)
        history[n] = volume_change(gradient, kinematics);
      return response;
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
    throw InputError("Formulation",
                     "found \"" + text + "\", allowed are " +
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
    static const List plane            = {{0, 0}, {1, 1}, {0, 1}};
    static const List plane_and_across = {{0, 0}, {1, 1}, {0, 1}, {2, 2}};
    static const List solid = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {0, 2}};
    switch (formulation)
      {
        case Formulation::plane_stress:
          return plane;
        case Formulation::plane_strain:
        case Formulation::axisymmetric:
          return plane_and_across;
        default:
          return solid;
      }
  }



  unsigned int
  n_history_values(const Formulation formulation, const Material &material)
  {
    const bool searches_thickness =
      formulation == Formulation::plane_stress && !material.is_linear();
    return material.n_history_values() + searches_thickness;
  }



  template <int dim>
  PointResponse
  respond(const Formulation             formulation,
          const Material               &material,
          const Tensor<2, dim>         &plane_gradient,
          const double                  thickness_strain,
          const MaterialStep           &step,
          const ArrayView<const double> history_n,
          const ArrayView<double>       history)
  {
    MaterialPoint point    = {Tensor<2, 3>(), step, history_n};
    Tensor<2, 3> &gradient = point.gradient;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j < dim; ++j)
        gradient[i][j] = plane_gradient[i][j];
    if (formulation == Formulation::axisymmetric ||
        formulation == Formulation::plane_strain)
      gradient[2][2] = thickness_strain;
    const bool is_finite = material.kinematics() == Kinematics::finite_strain;
    if (is_finite && !(thickness_strain > -1.))
      throw MaterialFailure("a point has crossed the axis: its radius became " +
                            std::to_string(1. + thickness_strain) +
                            " of what it was.");

    const MaterialResponse full =
      formulation == Formulation::plane_stress ?
        plane_stress_response(material, point, history) :
        material.respond(point, history);

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
    reduced.cauchy_stress = full.stress;
    if (is_finite)
      reduced.cauchy_stress /=
        determinant(gradient + unit_symmetric_tensor<3>());
    reduced.energy_density       = full.energy_density;
    reduced.plastic_work_density = full.plastic_work_density;
    reduced.heating_density      = full.heating_density;
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



#define INSTANTIATE(dim)                                             \
  template PointResponse respond<dim>(const Formulation,             \
                                      const Material &,              \
                                      const Tensor<2, dim> &,        \
                                      const double,                  \
                                      const MaterialStep &,          \
                                      const ArrayView<const double>, \
                                      const ArrayView<double>);      \
  template double        volume_factor<dim>(const Formulation,       \
                                     const Point<dim> &,      \
                                     const double);
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
