// What one answer of a material point costs, in all formulations and
// kinematics. Prints, never judges. Run it in Release:
//   build/release/tests/performance/material_responses
#include <signorini/solid/formulation.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>

#include <chrono>
#include <iomanip>
#include <iostream>
#include <limits>
#include <random>

namespace
{
  using namespace Signorini;
  using namespace dealii;

  const std::string plastic = "set Law = elasto-plastic\n"
                              "set Yield stress = 600e6\n"
                              "set Hardening modulus = 1e9\n";
  const std::string voce    = plastic + "set Hardening = Voce\n"
                                        "set Saturation stress = 900e6\n"
                                        "set Saturation exponent = 10\n";
  const std::string all     = voce + "set Rate dependence = Johnson-Cook\n"
                                     "set Kinematic hardening = "
                                     "Armstrong-Frederick\n"
                                     "set Kinematic hardening modulus = 20e9\n"
                                     "set Dynamic recovery = 200\n";

  const std::pair<std::string, std::string> materials[] = {
    {"elastic", "set Law = elastic\n"},
    {"neo-Hooke", "set Law = neo-Hooke\n"},
    {"plastic, but not flowing", plastic + "set Yield stress = 1e15\n"},
    {"plastic, linear hardening", plastic},
    {"plastic, Voce", voce},
    {"plastic, Voce, rates, Armstrong-Frederick", all}};

  std::unique_ptr<Material>
  create(const std::string &entries, const Kinematics kinematics)
  {
    ParameterHandler prm;
    declare_material_parameters("Material", prm);
    prm.parse_input_from_string("subsection Material\n" + entries + "end\n");
    return create_material("Material", kinematics, "", prm);
  }

  // Steps of one or two percent of strain from a state after such a step.
  template <int dim>
  double
  microseconds(const Formulation formulation, const Material &material)
  {
    const unsigned int             n_points = 1000, repetitions = 100;
    std::mt19937                   generator(1);
    std::vector<Tensor<2, dim>>    gradients(n_points);
    std::uniform_real_distribution random(-0.02, 0.02);
    for (auto &gradient : gradients)
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j < dim; ++j)
          gradient[i][j] = random(generator);

    const unsigned int  n = n_history_values(formulation, material);
    std::vector<double> history_n(n * n_points), history(n * n_points);
    const auto          visit = [&](const double factor) {
      double sum = 0.;
      for (unsigned int p = 0; p < n_points; ++p)
        {
          const auto response =
            respond(formulation,
                    material,
                    factor * gradients[p],
                    0.,
                    {1e-6, {}},
                    ArrayView<const double>(history_n.data() + n * p, n),
                    ArrayView<double>(history.data() + n * p, n));
          sum += response.tangent[0][0] + response.stress[0];
        }
      return sum;
    };
    visit(0.7);
    history_n = history;

    volatile double sum   = 0.;
    double          least = std::numeric_limits<double>::max();
    for (unsigned int r = 0; r < repetitions; ++r)
      {
        const auto start = std::chrono::steady_clock::now();
        sum              = sum + visit(1.);
        const std::chrono::duration<double, std::micro> time =
          std::chrono::steady_clock::now() - start;
        least = std::min(least, time.count() / n_points);
      }
    return least;
  }
} // namespace



int
main(int argc, char **argv)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::cout << "Microseconds a response of a point\n"
            << "                                            small strain       "
               "      finite strain\n"
            << "                                            strain stress 3-D  "
               "      strain stress 3-D\n";
  for (const auto &[name, entries] : materials)
    {
      std::cout << std::left << std::setw(43) << name << std::right
                << std::fixed << std::setprecision(2);
      for (const auto kinematics :
           {Kinematics::small_strain, Kinematics::finite_strain})
        {
          const auto material = create(entries, kinematics);
          std::cout << std::setw(7)
                    << microseconds<2>(Formulation::plane_strain, *material)
                    << std::setw(7)
                    << microseconds<2>(Formulation::plane_stress, *material)
                    << std::setw(7)
                    << microseconds<3>(Formulation::three_dimensional,
                                       *material)
                    << "    ";
        }
      std::cout << std::endl;
    }
}
