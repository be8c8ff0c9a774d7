#include <signorini/input_error.h>
#include <signorini/simulation/command_line.h>
#include <signorini/simulation/interruption.h>
#include <signorini/simulation/parameter_statements.h>
#include <signorini/simulation/platform.h>
#include <signorini/simulation/run.h>
#include <signorini/simulation/threads.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/multithread_info.h>

#include <algorithm>
#include <iostream>
#include <sstream>

namespace
{
  using namespace Signorini;

  enum ExitCode
  {
    done                    = 0,
    wrong_input             = 1,
    wrong_command_line      = 2,
    computation_failed      = 3,
    expected_results_missed = 4,
    interrupted             = 130
  };



  /** deal.II frames its messages for developers; only the reason is kept. */
  std::string
  reason(const dealii::ExceptionBase &error)
  {
    std::ostringstream text;
    error.print_info(text);
    return without_extra_blanks(text.str());
  }



  /** Print the error that is being handled and return its exit code. */
  int
  report(const std::string &file)
  {
    const std::string during = file.empty() ? "" : " (" + file + ")";
    try
      {
        throw;
      }
    catch (const InputError &error)
      {
        std::cerr << error.what() << std::endl;
        return wrong_input;
      }
    catch (const CommandLineError &error)
      {
        std::cerr << error.what() << " See signorini --help." << std::endl;
        return wrong_command_line;
      }
    catch (const ExpectedResultsMissed &error)
      {
        std::cerr << error.what() << std::endl;
        return expected_results_missed;
      }
    catch (const Interrupted &error)
      {
        std::cerr << error.what() << std::endl;
        return interrupted;
      }
    catch (const dealii::ExceptionBase &error)
      {
        std::cerr << "Computation failed" << during << ": " << reason(error)
                  << std::endl;
      }
    catch (const std::bad_alloc &)
      {
        std::cerr << "Out of memory" << during
                  << ". Coarsen the mesh or use a machine with more."
                  << std::endl;
      }
    catch (const std::exception &error)
      {
        std::cerr << "Computation failed" << during << ": " << error.what()
                  << std::endl;
      }
    return computation_failed;
  }



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
          const int code = report(file);
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
        print_parameters(std::cout);
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
      return report("");
    }
}
