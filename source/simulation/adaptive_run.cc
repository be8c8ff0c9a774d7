#include <signorini/input_error.h>
#include <signorini/output/run_folder.h>
#include <signorini/simulation/adaptive_run.h>
#include <signorini/simulation/interruption.h>
#include <signorini/simulation/mesh_adaptation.h>
#include <signorini/simulation/step_driver.h>
#include <signorini/time/step_plan.h>

namespace Signorini
{
  namespace
  {
    // The state at the time for which meshes are made.
    template <int dim>
    State
    solve(const Problem<dim> &problem,
          const std::string  &folder,
          Timings            &timings,
          Log                &log)
    {
      const StepControl &control = problem.time.step_control;
      StepDriver<dim>    driver(problem, timings);
      const StepPlan     plan(control, problem.time.end_time);
      RunRecord          record;
      record.step_memory     = StepMemory(control.initial_size);
      record.state           = driver.initial_state();
      record.largest_kinetic = record.state.energy.kinetic;
      while (!plan.is_end(record.state.time))
        {
          driver.advance(plan.target(record.state.time, record.n_regular),
                         folder,
                         record,
                         log);
          if (plan.completes_regular_step(record.state.time, record.n_regular))
            ++record.n_regular;
          if (is_interrupted())
            throw Interrupted("Stopped as asked, while the mesh was being "
                              "refined. The meshes up to now are in \"" +
                              folder + "/meshes.csv\".");
        }
      return record.state;
    }

    // Steps to the time of the adaptivity instead of the end.
    TimeParameters
    trial_time(const TimeParameters       &time,
               const AdaptivityParameters &adaptivity)
    {
      TimeParameters result = time;
      result.end_time       = adaptivity.time;
      if (adaptivity.step_size > 0.)
        result.step_control.initial_size = adaptivity.step_size;
      return result;
    }
  } // namespace



  template <int dim>
  std::vector<RefinementPasses>
  adapt_meshes(const ProblemCreator<dim> &create,
               const std::string         &folder,
               Problem<dim>              &problem,
               Timings                   &timings,
               Log                       &log)
  {
    const TimeParameters time  = problem.time;
    const auto           trial = trial_time(time, problem.adaptivity);
    MeshAdaptation<dim>  adaptation(problem);
    for (bool goes_on = true; goes_on;)
      {
        problem.time       = trial;
        const State state  = solve(problem, folder, timings, log);
        const auto  timing = timings.measure("mesh refinement");
        goes_on            = adaptation.improve(problem, state);
        log.line(adaptation.last_in_words());
        adaptation.write(result_file(folder + "/meshes.csv"));
        if (goes_on)
          problem = create(adaptation.passes());
      }
    log.line("adaptive refinement ends: " + adaptation.verdict());
    problem.time = time;
    return adaptation.passes();
  }



  template std::vector<RefinementPasses>
  adapt_meshes(const ProblemCreator<2> &,
               const std::string &,
               Problem<2> &,
               Timings &,
               Log &);
  template std::vector<RefinementPasses>
  adapt_meshes(const ProblemCreator<3> &,
               const std::string &,
               Problem<3> &,
               Timings &,
               Log &);
} // namespace Signorini
