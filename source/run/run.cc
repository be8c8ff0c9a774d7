#include <signorini/input/as_text.h>
#include <signorini/input/input_error.h>
#include <signorini/input/parameter_file.h>
#include <signorini/input/parameter_json.h>
#include <signorini/input/shell_word.h>
#include <signorini/input/unread_entries.h>
#include <signorini/output/history_writer.h>
#include <signorini/output/log.h>
#include <signorini/output/run_folder.h>
#include <signorini/output/timings.h>
#include <signorini/run/adaptive_run.h>
#include <signorini/run/input_record.h>
#include <signorini/run/mesh_adaptation.h>
#include <signorini/run/mesh_warnings.h>
#include <signorini/run/overclosure.h>
#include <signorini/run/problem.h>
#include <signorini/run/run.h>
#include <signorini/run/simulation.h>
#include <signorini/run/threads.h>
#include <signorini/run/unpaired_bodies.h>
#include <signorini/variational_inequality/algorithm_comparison.h>
#include <signorini/version.h>

#include <deal.II/base/multithread_info.h>
#include <deal.II/base/parameter_handler.h>

#include <fstream>
#include <memory>
#include <sstream>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // What is printed about a problem before the first step.
    template <int dim>
    std::string
    description(const Problem<dim> &problem)
    {
      std::ostringstream text;
      text << (problem.title.empty() ? "(no title)" : problem.title) << '\n';
      for (const auto &part : problem.solid->parts())
        text << "body " << part.body->name() << ": "
             << part.body->mesh().triangulation->n_active_cells() << " cells, "
             << part.body->n_dofs() << " unknowns\n";
      text << describe_pairs(*problem.contact, problem.initial_displacement)
           << unpaired_overlaps(problem, problem.initial_displacement)
           << mesh_warnings(problem);
      if (problem.time.dynamic)
        text << "time integration: alpha_B " << problem.time.scheme.alpha_B
             << ", alpha_H " << problem.time.scheme.alpha_H << ", beta "
             << problem.time.scheme.beta << ", gamma "
             << problem.time.scheme.gamma
             << (problem.time.conserves_energy ?
                   "; forces that keep energy and momenta" :
                   "")
             << '\n';
      if (problem.contact_parameters.algorithm.penalty_stiffness > 0.)
        text << "penalty stiffness "
             << problem.contact_parameters.algorithm.penalty_stiffness
             << " N/m\n";
      text << "threads: " << MultithreadInfo::n_threads();
      return text.str();
    }

    // The message with the place in front where the entry of the error, or
    // else the nearest section around it, stands; without any, the file.
    std::string
    with_place(const ParameterFile &file, const InputError &error)
    {
      std::string path = error.entry();
      for (std::size_t slash = path.find(" / "); slash != std::string::npos;
           slash             = path.find(" / "))
        path.replace(slash, 3, "/");
      while (!path.empty())
        {
          const std::string place = file.where(path);
          if (place != "default")
            return place + ": " + error.what();
          const std::size_t slash = path.rfind('/');
          path = slash == std::string::npos ? "" : path.substr(0, slash);
        }
      return file.path() + ": " + error.what();
    }

    // What the action returns; wrong input is reported with its place.
    template <typename Action>
    auto
    with_places(const ParameterFile &file, const Action &action)
    {
      try
        {
          return action();
        }
      catch (const InputError &error)
        {
          throw InputError(with_place(file, error));
        }
    }

    void
    write_parameters(const ParameterHandler &prm, const std::string &path)
    {
      std::ofstream file(path);
      prm.print_parameters(file, ParameterHandler::ShortText);
      file.flush();
      if (!file)
        throw ComputationError("Cannot write \"" + path +
                               "\": is the disk full?");
    }

    // Fills in folder, checkpoint and refinements, and returns what is wrong
    // with newer ones.
    std::vector<std::string>
    find_checkpoint(const std::string &base,
                    const std::string &parameter_file,
                    const std::string &folder,
                    RunTask           &task)
    {
      task.folder =
        folder.empty() ? find_run_folder(base, parameter_file) : folder;
      FoundCheckpoint found = read_checkpoint(task.folder);
      refuse_changed_input(found.checkpoint.input, task.input);
      task.passes     = found.checkpoint.passes;
      task.checkpoint = std::move(found.checkpoint);
      return found.warnings;
    }

    template <int dim>
    void
    refuse_other_problem(const Problem<dim> &problem,
                         const Checkpoint   &checkpoint)
    {
      if (checkpoint.geometry != geometry_checksum(problem))
        throw InputError("--resume: the meshes or profiles are not those of "
                         "the checkpoint: a file with a mesh or with points "
                         "was changed. Start the run anew without --resume.");
      if (!StepPlan::is_met(problem.time.end_time, checkpoint.time))
        throw InputError("--resume: the End time lies before the checkpoint, "
                         "which is of t = " +
                         shortest_exact(checkpoint.time) + " s.");
    }

    // As one types it, with the folder, so that it is the right run.
    std::string
    resume_command(const RunOptions  &options,
                   const std::string &parameter_file,
                   const std::string &folder)
    {
      return quoted(options.program) + " " + quoted(parameter_file) +
             options.repeated_options + " --resume-from " + quoted(folder);
    }

    // In the .prm, or on the command line.
    std::string
    output_base(const RunOptions &options, ParameterHandler &prm)
    {
      if (!options.output_directory.empty())
        return options.output_directory;
      prm.enter_subsection("Output");
      const std::string directory = prm.get("Directory");
      prm.leave_subsection();
      return directory;
    }

    template <int dim>
    void
    run_problem(const ParameterFile  &file,
                const ProblemOutline &outline,
                const RunOptions     &options)
    {
      Timings          timings;
      ParameterHandler prm;
      declare_problem_parameters<dim>(outline, prm);
      ParameterHandler defaults;
      declare_problem_parameters<dim>(outline, defaults);
      file.apply(prm);
      const std::vector<std::string> notes = warnings_of_unread_entries(
        file, problem_conditions<dim>(outline), prm, defaults);
      const ProblemCreator<dim> create =
        [&](const std::vector<RefinementPasses> &passes) {
          const auto   timing = timings.measure("set-up");
          Problem<dim> problem =
            Problem<dim>::create(outline, file.directory(), passes, prm);
          choose_blas_threads(problem.solid->n_dofs());
          return problem;
        };
      const std::string base = output_base(options, prm);
      RunTask           task;
      task.max_steps = options.max_steps;
      task.input     = input_entries(prm);
      std::vector<std::string> warnings;
      if (options.resume)
        warnings = find_checkpoint(base, file.path(), *options.resume, task);

      Problem<dim> problem =
        with_places(file, [&] { return create(task.passes); });
      // What is wrong in the checks, the algorithm or the quantities is found
      // before anything is written.
      auto simulation = with_places(file, [&] {
        MeshAdaptation<dim>{problem};
        return std::make_unique<Simulation<dim>>(problem, timings);
      });
      if (options.check_only)
        {
          Log log("");
          for (const std::string &note : notes)
            log.line("warning: " + note);
          log.line(file.path() + ": the input is fine\n" +
                   description(problem));
          return;
        }
      if (task.checkpoint)
        refuse_other_problem(problem, *task.checkpoint);
      const RunFolder    run_folder = task.checkpoint ?
                                        RunFolder::open(task.folder) :
                                        RunFolder::create(base,
                                                       file.path(),
                                                       options.overwrite,
                                                       prm.get("Submodel of"));
      const std::string &folder     = run_folder.path();
      task.folder                   = folder;
      task.resume_command = resume_command(options, file.path(), folder);

      Log::Settings log_settings = Log::default_settings();
      log_settings.append        = options.resume.has_value();
      Log log(result_file(folder + "/run.log"), log_settings);
      for (const std::string &warning : warnings)
        log.line(warning + " An older one is taken.");
      log.line("Signorini " SIGNORINI_VERSION ": " + file.path());
      log.line("results in " + folder);
      for (const std::string &note : notes)
        log.line("warning: " + note);
      write_parameters(prm, result_file(folder + "/parameters.prm"));
      try
        {
          if (problem.adaptivity.maximal_meshes > 1 &&
              (!task.checkpoint || !task.checkpoint->meshes.empty()))
            {
              simulation.reset();
              with_places(file, [&] {
                adapt_meshes(create, task, problem, timings, log);
              });
              simulation = std::make_unique<Simulation<dim>>(problem, timings);
            }
          log.line(description(problem));
          task.geometry = geometry_checksum(problem);
          // A formula may have no value at a time that was not tried.
          with_places(file, [&] { simulation->run(task, log); });
        }
      catch (const ComputationError &error)
        {
          log.detail(error.what());
          if (checkpoint_time(folder))
            log.line("to go on from the last checkpoint: " +
                     task.resume_command);
          throw;
        }
      catch (const std::exception &error)
        {
          log.detail(error.what());
          throw;
        }
    }
    ParameterFile
    read_with_overrides(const std::string              &prm_file,
                        const std::vector<std::string> &overrides)
    {
      ParameterFile file = ParameterFile::read(prm_file);
      for (const auto &assignment : overrides)
        file.override_entry(assignment);
      return file;
    }

    // All entries of a problem that is described by this outline.
    void
    declare_problem(const ProblemOutline &outline, ParameterHandler &prm)
    {
      if (space_dimension(outline.formulation) == 2)
        declare_problem_parameters<2>(outline, prm);
      else
        declare_problem_parameters<3>(outline, prm);
    }

    // What --set says of the formulation.
    std::string
    formulation_of(const std::vector<std::string> &overrides)
    {
      const std::string entry = "Formulation=";
      std::string       name  = "plane strain";
      for (const auto &assignment : overrides)
        if (assignment.compare(0, entry.size(), entry) == 0)
          name = assignment.substr(entry.size());
      return name;
    }
  } // namespace



  void
  run_problem(const std::string &prm_file, const RunOptions &options)
  {
    ParameterFile file = read_with_overrides(prm_file, options.overrides);
    const ProblemOutline outline = ProblemOutline::read(file);
    if (space_dimension(outline.formulation) == 2)
      run_problem<2>(file, outline, options);
    else
      run_problem<3>(file, outline, options);
  }



  void
  solve_interface(const std::string &file, std::ostream &stream)
  {
    stream << compare_algorithms_on_file(file) << std::flush;
  }



  void
  print_parameters(const std::string              &prm_file,
                   const std::vector<std::string> &overrides,
                   const ParameterFormat           format,
                   std::ostream                   &stream)
  {
    ParameterHandler prm;
    if (prm_file.empty())
      {
        const std::string formulation = formulation_of(overrides);
        declare_problem(
          {formulation_from_name(formulation), {"beam"}, {"floor"}, {{}}, {}},
          prm);
        prm.set("Formulation", formulation);
        prm.set("Bodies", std::string("beam"));
        prm.set("Rigid bodies", std::string("floor"));
      }
    else
      {
        ParameterFile file = read_with_overrides(prm_file, overrides);
        declare_problem(ProblemOutline::read(file), prm);
        file.apply(prm);
      }
    switch (format)
      {
        case ParameterFormat::prm:
          prm.print_parameters(stream, ParameterHandler::Text);
          break;
        case ParameterFormat::xml:
          prm.print_parameters(stream,
                               ParameterHandler::XML |
                                 ParameterHandler::KeepDeclarationOrder);
          break;
        case ParameterFormat::json:
          stream << parameter_json(declared_parameters(prm));
          break;
      }
  }
} // namespace Signorini
