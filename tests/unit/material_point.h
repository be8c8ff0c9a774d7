#ifndef signorini_tests_material_point_h
#define signorini_tests_material_point_h

#include <signorini/material/material.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/physics/transformations.h>

#include <memory>
#include <random>
#include <string>
#include <vector>

namespace Signorini
{
  /** A material from the text of its section in a .prm. */
  inline std::unique_ptr<Material>
  test_material(const std::string &entries,
                const Kinematics   kinematics,
                const std::string &base_directory = "")
  {
    dealii::ParameterHandler prm;
    declare_material_parameters("Material", prm);
    prm.parse_input_from_string("subsection Material\n" + entries + "end\n");
    return create_material("Material", kinematics, base_directory, prm);
  }

  /** A material with what one of its points remembers. */
  class PointOfMaterial
  {
  public:
    PointOfMaterial(const std::string &entries, const Kinematics kinematics)
      : material(test_material(entries, kinematics))
      , history_n(material->n_history_values())
    {}

    /** A step that is tried. */
    MaterialResponse
    respond(const dealii::Tensor<2, 3> &gradient,
            const double                step_size = 1.) const
    {
      history = history_n;
      return material->respond({gradient,
                                {step_size, {}},
                                dealii::make_array_view(history_n)},
                               dealii::make_array_view(history));
    }

    /** A step that is taken. */
    MaterialResponse
    advance(const dealii::Tensor<2, 3> &gradient, const double step_size = 1.)
    {
      const MaterialResponse response = respond(gradient, step_size);
      history_n                       = history;
      return response;
    }

    double
    equivalent_plastic_strain() const
    {
      return material->equivalent_plastic_strain(
        dealii::make_array_view(std::as_const(history_n)));
    }

    /**
     * Takes a step of uniaxial stress along x: the stretches along y and z are
     * those that have no stress. In small strains a stretch is 1 + strain.
     */
    MaterialResponse
    stretch(const double stretch, const double step_size = 1.)
    {
      const bool is_finite =
        material->kinematics() == Kinematics::finite_strain;
      dealii::Tensor<2, 3> gradient;
      gradient[0][0] = stretch - 1.;
      gradient[1][1] = gradient[2][2] = lateral;
      for (unsigned int iteration = 0; iteration < 60; ++iteration)
        {
          const auto   response = respond(gradient, step_size);
          const double stress   = response.stress[1][1];
          if (std::abs(stress) < 1e-13 * response.stress.norm())
            break;
          const double strain = -stress / (response.tangent[1][1][1][1] +
                                           response.tangent[1][1][2][2] +
                                           (is_finite ? 2. * stress : 0.));
          lateral += is_finite ? (1. + lateral) * std::expm1(strain) : strain;
          gradient[1][1] = gradient[2][2] = lateral;
        }
      return advance(gradient, step_size);
    }

    std::unique_ptr<Material>   material;
    std::vector<double>         history_n;
    mutable std::vector<double> history; // of the last step that was tried
    double                      lateral = 0.;
  };

  /** Random deformations, the same in every run. */
  class RandomDeformations
  {
  public:
    explicit RandomDeformations(const unsigned int seed)
      : generator(seed)
    {}

    double
    number(const double from, const double to)
    {
      return std::uniform_real_distribution<double>(from, to)(generator);
    }

    /** Entries up to a size; planar: without xz and yz. */
    dealii::Tensor<2, 3>
    gradient(const double size, const bool is_planar)
    {
      dealii::Tensor<2, 3> result;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          if (!is_planar || i == j || (i < 2 && j < 2))
            result[i][j] = number(-size, size);
      return result;
    }

    dealii::Tensor<2, 3>
    rotation(const bool is_planar)
    {
      dealii::Tensor<1, 3> axis;
      axis[2] = 1.;
      if (!is_planar)
        for (unsigned int i = 0; i < 3; ++i)
          axis[i] = number(0.1, 1.);
      return dealii::Physics::Transformations::Rotations::rotation_matrix_3d(
        dealii::Point<3>(axis / axis.norm()), number(-3., 3.));
    }

  private:
    std::mt19937 generator;
  };

  inline dealii::Tensor<2, 3>
  unit_tensor()
  {
    return dealii::Tensor<2, 3>(dealii::unit_symmetric_tensor<3>());
  }

  /** Largest entry of a difference over the largest entry. */
  template <int rank>
  double
  relative_difference(const dealii::SymmetricTensor<rank, 3> &found,
                      const dealii::SymmetricTensor<rank, 3> &truth)
  {
    double difference = 0., size = 0.;
    for (unsigned int i = 0; i < truth.n_independent_components; ++i)
      {
        difference = std::max(difference,
                              std::abs(found.access_raw_entry(i) -
                                       truth.access_raw_entry(i)));
        size       = std::max(size, std::abs(truth.access_raw_entry(i)));
      }
    return difference / size;
  }

  /** Q T Q^T. */
  inline dealii::SymmetricTensor<2, 3>
  rotated(const dealii::SymmetricTensor<2, 3> &tensor,
          const dealii::Tensor<2, 3>          &Q)
  {
    return symmetrize(Q * dealii::Tensor<2, 3>(tensor) * transpose(Q));
  }

  /**
   * The tangent by fourth-order central differences; of it the symmetric part.
   * For finite strains the Lie derivative.
   */
  inline dealii::SymmetricTensor<4, 3>
  numerical_tangent(const PointOfMaterial      &point,
                    const dealii::Tensor<2, 3> &gradient,
                    const double                h,
                    const double                step_size = 1.)
  {
    using namespace dealii;
    const bool is_finite =
      point.material->kinematics() == Kinematics::finite_strain;
    const Tensor<2, 3>    stress(point.respond(gradient, step_size).stress);
    SymmetricTensor<4, 3> result;
    for (unsigned int k = 0; k < 3; ++k)
      for (unsigned int l = k; l < 3; ++l)
        {
          Tensor<2, 3> d;
          d[k][l] += 0.5;
          d[l][k] += 0.5;
          const Tensor<2, 3> direction =
            is_finite ? d * (unit_tensor() + gradient) : d;
          const auto at = [&](const double s) {
            return Tensor<2, 3>(
              point.respond(gradient + s * h * direction, step_size).stress);
          };
          Tensor<2, 3> rate =
            (8. * (at(1.) - at(-1.)) - (at(2.) - at(-2.))) / (12. * h);
          if (is_finite)
            rate -= d * stress + stress * d;
          for (unsigned int i = 0; i < 3; ++i)
            for (unsigned int j = i; j < 3; ++j)
              result[i][j][k][l] = rate[i][j];
        }
    SymmetricTensor<4, 3> symmetric;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = i; j < 3; ++j)
        for (unsigned int k = 0; k < 3; ++k)
          for (unsigned int l = k; l < 3; ++l)
            symmetric[i][j][k][l] =
              0.5 * (result[i][j][k][l] + result[k][l][i][j]);
    return symmetric;
  }
} // namespace Signorini

#endif
