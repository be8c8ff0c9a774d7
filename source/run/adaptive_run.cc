#include <signorini/input/input_error.h>
#include <signorini/input/instantiate.h>
#include <signorini/output/checkpoint.h>
#include <signorini/output/run_folder.h>
#include <signorini/run/adaptive_run.h>
#include <signorini/run/input_record.h>
#include <signorini/run/interruption.h>
#include <signorini/run/mesh_adaptation.h>
#include <signorini/run/step_driver.h>
#include <signorini/time/step_plan.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>

#include <sstream>

namespace Signorini
{
  namespace
  {
    // The state at the time for which meshes are made.
    template <int dim>
    State
    solve(const Problem<dim> &problem,
          const RunTask      &task,
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
                         task.folder,
                         record,
                         log);
          if (plan.completes_regular_step(record.state.time, record.n_regular))
            ++record.n_regular;
          if (is_interrupted())
            throw Interrupted(
              "Stopped as asked. The meshes found so far are kept. To go on: " +
              task.resume_command);
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

    template <int dim>
    void
    save(const RunTask             &task,
         const Problem<dim>        &problem,
         const MeshAdaptation<dim> &adaptation)
    {
      std::ostringstream              stream;
      boost::archive::binary_oarchive archive(stream);
      archive << adaptation;
      write_checkpoint(task.folder,
                       {0.,
                        0,
                        task.input,
                        geometry_checksum(problem),
                        adaptation.passes(),
                        "",
                        stream.str()});
    }

    template <int dim>
    void
    restore(const Checkpoint    &checkpoint,
            MeshAdaptation<dim> &adaptation,
            Log                 &log)
    {
      std::istringstream              stream(checkpoint.meshes);
      boost::archive::binary_iarchive archive(stream);
      archive >> adaptation;
      log.line("resumed at mesh " +
               std::to_string(adaptation.records().size() + 1));
    }
  } // namespace



  template <int dim>
  void
  adapt_meshes(const ProblemCreator<dim> &create,
               RunTask                   &task,
               Problem<dim>              &problem,
               Timings                   &timings,
               Log                       &log)
  {
    const TimeParameters time  = problem.time;
    const auto           trial = trial_time(time, problem.adaptivity);
    MeshAdaptation<dim>  adaptation(problem);
    if (task.checkpoint)
      restore(*task.checkpoint, adaptation, log);
    for (bool goes_on = true; goes_on;)
      {
        save(task, problem, adaptation);
        problem.time       = trial;
        const State state  = solve(problem, task, timings, log);
        const auto  timing = timings.measure("mesh refinement");
        goes_on            = adaptation.improve(problem, state);
        log.line(adaptation.last_in_words());
        adaptation.write(result_file(task.folder + "/meshes.csv"));
        if (goes_on)
          problem = create(adaptation.passes());
      }
    log.line("adaptive refinement ends: " + adaptation.verdict());
    problem.time = time;
    task.passes  = adaptation.passes();
    task.checkpoint.reset();
  }



#define INSTANTIATE(dim)      \
  template void adapt_meshes( \
    const ProblemCreator<dim> &, RunTask &, Problem<dim> &, Timings &, Log &);
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
