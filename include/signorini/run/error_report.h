#ifndef signorini_run_error_report_h
#define signorini_run_error_report_h

#include <iosfwd>
#include <string>

namespace Signorini
{
  /** What the program returns to the shell. */
  enum ExitCode
  {
    done                    = 0,
    wrong_input             = 1,
    wrong_command_line      = 2,
    computation_failed      = 3,
    expected_results_missed = 4,
    interrupted             = 130
  };

  /**
   * Prints the error that is being handled, of whatever kind, and returns its
   * exit code.
   * @param file that was worked on, or nothing
   */
  ExitCode
  report_error(const std::string &file, std::ostream &stream);
} // namespace Signorini

#endif
