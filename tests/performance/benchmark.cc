// What a step costs, as ratios of times measured in this one run. Prints, never
// judges: a busy machine is no mistake of the program. Run it in Release:
//   build/release/tests/performance/benchmark [number of threads]
#include <signorini/curves/curve_search.h>
#include <signorini/curves/curve_weights.h>
#include <signorini/dynamics/time_step.h>
#include <signorini/input/parameter_file.h>
#include <signorini/linear_algebra/sparse_cholesky.h>
#include <signorini/run/problem.h>
#include <signorini/run/threads.h>
#include <signorini/solid/assembler.h>
#include <signorini/variational_inequality/interface_algorithm.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>

#include <chrono>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <limits>
#include <utility>

namespace
{
  using namespace Signorini;
  using namespace dealii;

  Problem<2>
  read(const std::string &path)
  {
    const ParameterFile  file    = ParameterFile::read(path);
    const ProblemOutline outline = ProblemOutline::read(file);
    ParameterHandler     prm;
    declare_problem_parameters<2>(outline, prm);
    file.apply(prm);
    return Problem<2>::create(outline, file.directory(), {}, prm);
  }



  template <typename Function>
  double
  seconds(const Function &function)
  {
    const auto start = std::chrono::steady_clock::now();
    function();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() -
                                         start)
      .count();
  }



  // The least of several repetitions: what else the machine did only adds.
  template <typename Function>
  double
  least_seconds(const unsigned int n, const Function &function)
  {
    double least = std::numeric_limits<double>::max();
    for (unsigned int i = 0; i < n; ++i)
      least = std::min(least, seconds(function));
    return least;
  }



  void
  print(const std::string &name, const double value, const std::string &unit)
  {
    std::cout << std::left << std::setw(58) << name << std::right
              << std::setw(10) << std::setprecision(4) << value << ' ' << unit
              << std::endl;
  }



  TimeStep<2>::Settings
  settings(const Problem<2> &problem)
  {
    return {problem.time,
            problem.contact_parameters.algorithm,
            problem.contact_parameters.force_tolerance};
  }



  // K^ of a step, on the pattern of the model.
  SparseMatrix<double>
  effective_stiffness(const Problem<2> &problem)
  {
    const GeneralizedAlpha &scheme = problem.time.scheme;
    SparseMatrix<double>    matrix(problem.solid->sparsity());
    matrix.copy_from(problem.solid->stiffness());
    matrix *= 1. - scheme.alpha_H;
    matrix.add((1. - scheme.alpha_B) *
                 scheme.acceleration_factor(problem.time.step_size),
               problem.solid->mass());
    return matrix;
  }



  // The time loop of the beam against the substitutions that it cannot avoid.
  void
  measure_linear_steps()
  {
    const Problem<2>   problem = read("prm/cantilever_beam.prm");
    const unsigned int n_steps = 2400;

    SparseCholesky cholesky;
    cholesky.analyse(problem.solid->sparsity(),
                     problem.solid->dof_map().constrained(),
                     {});
    cholesky.factorise(effective_stiffness(problem));
    Vector<double> x(cholesky.order().size());
    const double   substitutions = least_seconds(3, [&] {
      x = 1.;
      for (unsigned int n = 0; n < n_steps; ++n)
        {
          cholesky.forward_substitution(x);
          cholesky.backward_substitution(x);
        }
    });

    Timings     timings;
    TimeStep<2> time_step(*problem.solid,
                          *problem.contact,
                          settings(problem),
                          timings);
    const State start =
      time_step.initial_state(problem.initial_displacement,
                              problem.initial_velocity,
                              problem.solid->initial_history());
    const auto next = [&](const State &state) {
      return Step{state.step + 1, state.time, problem.time.step_size};
    };
    time_step.advance(start, next(start)); // factorises
    const double loop = least_seconds(3, [&] {
      State state = start;
      for (unsigned int n = 0; n < n_steps; ++n)
        state = time_step.advance(state, next(state));
    });

    std::cout << "Beam, 80 x 8 cells, 2400 steps\n";
    print("bare substitutions", 1e6 * substitutions / n_steps, "us a step");
    print("time loop", 1e6 * loop / n_steps, "us a step");
    print("time loop / substitutions (asked: < 6)", loop / substitutions, "");
    std::cout << timings.table() << '\n';
  }



  // Steps of ever new size, each of which needs a new factor.
  class RefactorisingStep
  {
  public:
    explicit RefactorisingStep(const Problem<2> &problem)
      : time_step(*problem.solid, *problem.contact, settings(problem), timings)
      , start(time_step.initial_state(problem.initial_displacement,
                                      problem.initial_velocity,
                                      problem.solid->initial_history()))
      , step_size(problem.time.step_size)
    {}

    double
    measure()
    {
      step_size *= 0.99;
      return seconds([&] { time_step.advance(start, {1, 0., step_size}); });
    }

  private:
    Timings     timings;
    TimeStep<2> time_step;
    const State start;
    double      step_size;
  };



  void
  measure_large_block()
  {
    const Problem<2> block = read("tests/performance/block.prm");
    const Problem<2> alone = read("tests/performance/block_alone.prm");
    std::cout << "Block, " << block.solid->n_dofs() << " unknowns, "
              << block.contact->interface_dofs().size()
              << " of them on the interface\n";

    SparseCholesky             cholesky;
    const SparseMatrix<double> matrix   = effective_stiffness(alone);
    const double               ordering = seconds([&] {
      cholesky.analyse(alone.solid->sparsity(),
                       alone.solid->dof_map().constrained(),
                       {});
    });
    const double               factorisation =
      least_seconds(3, [&] { cholesky.factorise(matrix); });
    SparseMatrix<double> stiffness(alone.solid->sparsity());
    SolidResponse        response;
    response.internal_force.reinit(alone.solid->n_dofs());
    const Vector<double> zero(alone.solid->n_dofs());
    const double         assembly = least_seconds(3, [&] {
      stiffness = 0.;
      add_response(*alone.solid->parts()[0].body,
                   alone.solid->dof_map().constraints(),
                   {zero},
                   {},
                   {},
                   response,
                   &stiffness);
    });
    print("ordering, once", 1e3 * ordering, "ms");
    print("factorisation", 1e3 * factorisation, "ms");
    print("assembly of the stiffness", 1e3 * assembly, "ms");
    print("assembly / factorisation (asked: < 0.333, one thread)",
          assembly / factorisation,
          "");
    // In turns, so that both see the same machine.
    RefactorisingStep step_with(block), step_without(alone);
    double            with    = std::numeric_limits<double>::max();
    double            without = std::numeric_limits<double>::max();
    for (unsigned int i = 0; i < 10; ++i)
      {
        with    = std::min(with, step_with.measure());
        without = std::min(without, step_without.measure());
      }
    print("step with contact, refactorised", 1e3 * with, "ms");
    print("step without contact, refactorised", 1e3 * without, "ms");
    print("with / without contact (asked: < 1.15)", with / without, "");
  }



  // A target that is curved may cost more than a plane where it is touched,
  // not where it is not. Steps of one size: nothing is factorised again.
  void
  measure_curved_target()
  {
    const Problem<2> disc  = read("tests/performance/strip_on_disc.prm");
    const Problem<2> plane = read("tests/performance/strip_on_plane.prm");
    std::cout << "Strip, " << disc.solid->n_dofs() << " unknowns, "
              << disc.contact->interface_dofs().size()
              << " of them on the interface\n";
    double times[2][2] = {};
    for (const bool is_curved : {false, true})
      {
        const Problem<2> &problem = is_curved ? disc : plane;
        Timings           timings;
        TimeStep<2>       time_step(*problem.solid,
                              *problem.contact,
                              settings(problem),
                              timings);
        for (const bool touches : {false, true})
          {
            // Upwards, or downwards onto the target.
            Vector<double> velocity(problem.initial_velocity);
            if (!touches)
              velocity *= -1.;
            const State start =
              time_step.initial_state(problem.initial_displacement,
                                      velocity,
                                      problem.solid->initial_history());
            const auto step = [&](const State &state) {
              return time_step.advance(
                state, {state.step + 1, state.time, problem.time.step_size});
            };
            const State  second = step(start); // factorises
            unsigned int n      = 1;
            times[is_curved][touches] =
              least_seconds(3, [&] { n = step(second).n_iterations; }) / n;
          }
      }
    print("iteration on a plane, apart", 1e3 * times[0][0], "ms");
    print("iteration on a plane, in touch", 1e3 * times[0][1], "ms");
    print("on a disc / on a plane, apart (asked: < 1.2)",
          times[1][0] / times[0][0],
          "");
    print("on a disc / on a plane, in touch", times[1][1] / times[0][1], "");
    std::cout << '\n';
  }



  // Forces, histories and tangent of a body with large strains.
  void
  measure_plastic_assembly()
  {
    const Problem<2>     block = read("tests/performance/block_plastic.prm");
    const SolidModel<2> &solid = *block.solid;
    const std::vector<double>  history = solid.initial_history();
    SparseMatrix<double>       tangent;
    SparseCholesky             cholesky;
    const SparseMatrix<double> matrix = effective_stiffness(block);
    cholesky.analyse(solid.sparsity(), solid.dof_map().constrained(), {});
    const double factorisation =
      least_seconds(3, [&] { cholesky.factorise(matrix); });
    std::cout << "Elasto-plastic block, finite strain, " << solid.n_dofs()
              << " unknowns\n";
    print("factorisation", 1e3 * factorisation, "ms");
    for (const auto &[name, strain] :
         {std::make_pair("elastic", 1e-4), std::make_pair("flowing", 0.02)})
      {
        Vector<double> u(solid.n_dofs());
        for (const auto &node : solid.parts()[0].body->nodes())
          u[node.dofs[1]] = -strain * node.point[1];
        const double assembly = least_seconds(3, [&] {
          solid.respond({u, 1.}, history, &tangent);
        });
        print(std::string("assembly, all points ") + name,
              1e3 * assembly,
              "ms");
        print("assembly / factorisation (asked: < 1.5, one thread)",
              assembly / factorisation,
              "");
      }
  }



  // A row of springs on a floor, 200 contacts with and without friction: the
  // dense part of a step alone.
  InterfaceProblem
  springs_on_floor(const double friction_coefficient)
  {
    const unsigned int n_contacts = 200, n = 2 * n_contacts;
    const double       spring = 3.7e8, gap = -1e-4;
    FullMatrix<double> stiffness(n, n);
    for (unsigned int i = 0; i < n; ++i)
      {
        stiffness(i, i) += 0.05 * spring * (1. + 0.1 * (i % 7));
        if (i + 2 < n)
          {
            stiffness(i, i) += spring;
            stiffness(i + 2, i + 2) += spring;
            stiffness(i, i + 2) -= spring;
            stiffness(i + 2, i) -= spring;
          }
        if (i % 2 == 0)
          {
            stiffness(i, i + 1) += 0.01 * spring;
            stiffness(i + 1, i) += 0.01 * spring;
          }
      }
    std::vector<InterfaceContact> contacts(n_contacts);
    for (unsigned int k = 0; k < n_contacts; ++k)
      {
        contacts[k].normal               = {{2 * k + 1, -1.}};
        contacts[k].gap                  = gap;
        contacts[k].tangents             = {{{2 * k, 1.}}};
        contacts[k].slip[0]              = -3e-3 * gap * std::sin(0.3 * k);
        contacts[k].friction_coefficient = friction_coefficient;
      }
    InterfaceProblem problem;
    problem.set_stiffness(InterfaceStiffness::from_matrix(stiffness));
    problem.set_contacts(std::move(contacts));
    return problem;
  }



  // Seconds of the first solve, and of one in a series of slowly changing
  // forces.
  std::pair<double, double>
  interface_seconds(const std::string &name, const double friction_coefficient)
  {
    AlgorithmParameters parameters;
    parameters.algorithm   = name;
    const auto   algorithm = make_interface_algorithm(parameters);
    const double load      = 1e3;
    double       cold      = std::numeric_limits<double>::max();
    double       warm      = cold;
    for (unsigned int repetition = 0; repetition < 5; ++repetition)
      {
        InterfaceProblem  problem = springs_on_floor(friction_coefficient);
        Vector<double>    force(problem.size());
        InterfaceSolution solution;
        for (unsigned int step = 0; step < 20; ++step)
          {
            for (unsigned int i = 0; i < force.size(); ++i)
              force(i) = load * std::sin(0.1 * i + 0.01 * step);
            problem.set_force(force);
            const double time = seconds(
              [&] { solution = algorithm->solve(problem, solution.forces); });
            (step == 0 ? cold : warm) = std::min(step == 0 ? cold : warm, time);
          }
      }
    return {cold, warm};
  }



  void
  measure_friction()
  {
    std::cout << "Interface of 200 contacts, 400 unknowns\n";
    const auto smooth = interface_seconds("ando", 0.);
    print("without friction, first solve", 1e3 * smooth.first, "ms");
    print("without friction, next step", 1e3 * smooth.second, "ms");
    for (const std::string name : {"ando", "semismooth Newton", "two step"})
      {
        const auto rough = interface_seconds(name, 0.3);
        print(name + ", next step", 1e3 * rough.second, "ms");
        print(name + ", first solve, with / without friction",
              rough.first / smooth.first,
              "");
        print(name + ", next step, with / without friction",
              rough.second / smooth.second,
              "");
      }
    std::cout << '\n';
  }



  // A wavy ring of n nodes, and as many contactor points just outside of it:
  // the tree is built and every point projected.
  struct SearchTimes
  {
    double tree, projections; // s
  };

  SearchTimes
  search_times(const unsigned int n)
  {
    std::vector<Point<2>> nodes, points;
    const auto            at = [&](const double s, const double offset) {
      const double angle  = 2. * numbers::PI * s / n;
      const double radius = 1. + 0.1 * std::sin(7. * angle) + offset;
      return Point<2>(radius * std::cos(angle), radius * std::sin(angle));
    };
    for (unsigned int i = 0; i < n; ++i)
      {
        nodes.push_back(at(i, 0.));
        points.push_back(at(i + 0.3, 0.2 / n));
      }
    const CurveWeights weights = CurveWeights::overhauser(
      nodes, true, CurveWeights::Knots::centripetal, 60.);
    const Curve        curve = weights.curve(nodes);
    CurveSearch        search(curve);
    CurveQuery         query;
    const unsigned int repetitions = 3 + 20000 / n;
    query.search_distance          = 5. / n;
    double      sum                = 0.;
    SearchTimes times;
    times.tree        = least_seconds(repetitions, [&] { search.update(); });
    times.projections = least_seconds(repetitions, [&] {
      for (const auto &x : points)
        sum += search.project(x, query)->gap;
    });
    if (!(sum > 0.))
      std::cout << "The points are not outside.\n";
    return times;
  }



  void
  measure_search()
  {
    std::cout << "\nSearch of n points on a curve of n segments, per point\n"
              << "      n     tree     projections (us)   all, over n = 100"
              << "   log n / log 100\n";
    double first = 0.;
    for (const unsigned int n : {100u, 1000u, 10000u, 100000u})
      {
        const SearchTimes times = search_times(n);
        const double      all   = (times.tree + times.projections) / n;
        if (n == 100)
          first = all;
        std::cout << std::setw(7) << n << std::fixed << std::setprecision(3)
                  << std::setw(9) << 1e6 * times.tree / n << std::setw(16)
                  << 1e6 * times.projections / n << std::setw(20) << all / first
                  << std::setw(18) << std::log(n) / std::log(100.)
                  << std::defaultfloat << std::endl;
      }
  }
} // namespace



int
main(int argc, char **argv)
{
  const unsigned int n_threads = argc > 1 ? std::stoi(argv[1]) : 1;
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  limit_threads(n_threads);
  std::cout << "Threads: " << n_threads << '\n';
  measure_plastic_assembly();
  measure_friction();
  measure_linear_steps();
  measure_large_block();
  measure_curved_target();
  measure_search();
}
