#ifndef signorini_run_run_h
#define signorini_run_run_h

#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace Signorini
{
  /** What the command line asks of a run beside its .prm. */
  struct RunOptions
  {
    /** Read and check everything, compute and write nothing. */
    bool check_only = false;

    /** Base folder of the results; empty: as the .prm says. */
    std::string output_directory;

    /** Results of an earlier run in the same folder may be replaced. */
    bool overwrite = false;

    /**
     * Go on from the last checkpoint of an earlier run: of the one in this
     * folder, or of the newest one of the file if it is empty.
     */
    std::optional<std::string> resume;

    /** The program and the options to give once more to go on with a run. */
    std::string program = "signorini";
    std::string repeated_options;

    /** "Section/Entry=value", set on top of the .prm in this order. */
    std::vector<std::string> overrides;

    /**
     * Stop after so many time steps. A run that is cut short does not check
     * its expected results.
     */
    std::optional<unsigned int> max_steps;
  };

  /**
   * Run one problem from its .prm to its results, or only check it.
   * @throws InputError, ComputationError, ExpectedResultsMissed, Interrupted.
   */
  void
  run_problem(const std::string &prm_file, const RunOptions &options);

  /** How entries are printed; xml and json are those of a ParameterHandler. */
  enum class ParameterFormat
  {
    prm,
    xml,
    json
  };

  /**
   * Print every entry of a problem with its value and documentation.
   * @param prm_file empty: a problem with one body and one rigid body, in 3-D
   *                 if @p overrides set the Formulation to it
   * @throws InputError.
   */
  void
  print_parameters(const std::string              &prm_file,
                   const std::vector<std::string> &overrides,
                   const ParameterFormat           format,
                   std::ostream                   &stream);

  /**
   * Print how the exact algorithms solve the interface problem in a file.
   * @throws InputError if the file cannot be read or is no interface problem.
   */
  void
  solve_interface(const std::string &file, std::ostream &stream);
} // namespace Signorini

#endif
