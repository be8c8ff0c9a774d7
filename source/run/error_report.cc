#include <signorini/input/input_error.h>
#include <signorini/input/parameter_statements.h>
#include <signorini/run/command_line.h>
#include <signorini/run/error_report.h>
#include <signorini/run/interruption.h>

#include <deal.II/base/exceptions.h>

#include <new>
#include <ostream>
#include <sstream>
#include <stdexcept>

namespace Signorini
{
  namespace
  {
    /** deal.II frames its messages for developers; only the reason is kept. */
    std::string
    reason(const dealii::ExceptionBase &error)
    {
      std::ostringstream text;
      error.print_info(text);
      return without_extra_blanks(text.str());
    }
  } // namespace



  ExitCode
  report_error(const std::string &file, std::ostream &stream)
  {
    const std::string during = file.empty() ? "" : " (" + file + ")";
    try
      {
        throw;
      }
    catch (const InputError &error)
      {
        stream << error.what() << std::endl;
        return wrong_input;
      }
    catch (const CommandLineError &error)
      {
        stream << error.what() << " See signorini --help." << std::endl;
        return wrong_command_line;
      }
    catch (const ExpectedResultsMissed &error)
      {
        stream << error.what() << std::endl;
        return expected_results_missed;
      }
    catch (const Interrupted &error)
      {
        stream << error.what() << std::endl;
        return interrupted;
      }
    catch (const dealii::ExceptionBase &error)
      {
        stream << "Computation failed" << during << ": " << reason(error)
               << std::endl;
      }
    catch (const std::bad_alloc &)
      {
        stream << "Out of memory" << during
               << ". Coarsen the mesh or use a machine with more." << std::endl;
      }
    catch (const std::length_error &)
      {
        stream << "Out of memory" << during
               << ": a size in the input or in one of its files is too large."
               << std::endl;
      }
    catch (const std::exception &error)
      {
        stream << "Computation failed" << during << ": " << error.what()
               << std::endl;
      }
    catch (...) // a library may throw what is no std::exception
      {
        stream << "Computation failed" << during
               << ": an error of a library that does not say what is wrong."
               << std::endl;
      }
    return computation_failed;
  }
} // namespace Signorini
