#include <signorini/run/command_line.h>
#include <signorini/run/error_report.h>
#include <signorini/run/interruption.h>
#include <signorini/run/platform.h>
#include <signorini/run/reference.h>
#include <signorini/run/run.h>
#include <signorini/run/threads.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/multithread_info.h>

#include <algorithm>
#include <iostream>
#include <string>
#include <vector>

namespace
{
  using namespace Signorini;

  /** Every file is run; the largest exit code is that of the program. */
  int
  run_all(const CommandLine &command_line)
  {
    int                      exit_code = done;
    std::vector<std::string> files     = command_line.prm_files;
    files.insert(files.end(),
                 command_line.interface_files.begin(),
                 command_line.interface_files.end());
    for (const std::string &file : files)
      try
        {
          if (command_line.interface_files.empty())
            run_problem(file, command_line.run_options);
          else
            solve_interface(file, std::cout);
        }
      catch (...)
        {
          const int code = report_error(file, std::cerr);
          exit_code      = std::max(exit_code, code);
          if (code == interrupted)
            break;
        }
    return exit_code;
  }



  int
  run(int argc, char **argv)
  {
    const CommandLine command_line = CommandLine::parse(argc, argv);
    if (command_line.help || command_line.version)
      {
        std::cout << (command_line.help ? help_text() : versions());
        return done;
      }

    // Trilinos needs MPI, even for one process.
    const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
    limit_threads(
      command_line.threads.value_or(dealii::MultithreadInfo::n_cores()));
    if (dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1)
      throw CommandLineError("The program runs in one process and uses "
                             "threads: start it without mpirun.");
    if (command_line.print_parameters)
      {
        auto files = command_line.prm_files;
        if (files.empty())
          files.emplace_back();
        for (const auto &file : files)
          print_parameters(file,
                           command_line.run_options.overrides,
                           command_line.parameter_format,
                           std::cout);
        return done;
      }
    if (command_line.reference_folder)
      {
        write_reference(*command_line.reference_folder);
        return done;
      }
    catch_interruptions();
    return run_all(command_line);
  }
} // namespace



int
main(int argc, char **argv)
{
  try
    {
      return run(argc, argv);
    }
  catch (...)
    {
      return report_error("", std::cerr);
    }
}
