#ifndef signorini_run_command_line_h
#define signorini_run_command_line_h

#include <signorini/run/run.h>

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace Signorini
{
  /** The command line cannot be understood; the message says why. */
  class CommandLineError : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };

  /** The options of the program, as they were given. */
  struct CommandLine
  {
    /** At least one, unless something below is asked for. */
    std::vector<std::string> prm_files;

    /** The files of the command solve-interface. */
    std::vector<std::string> interface_files;

    bool help             = false;
    bool version          = false;
    bool print_parameters = false;

    /** That of the printed parameters. */
    ParameterFormat parameter_format = ParameterFormat::prm;

    /** Where the reference of all entries is to go. */
    std::optional<std::string> reference_folder;

    /** Upper limit of threads; without it all cores are used. */
    std::optional<unsigned int> threads;

    RunOptions run_options;

    /**
     * @throws CommandLineError for an unknown option, a missing or wrong
     * value, or no file.
     */
    static CommandLine
    parse(const int argc, const char *const *argv);
  };

  /** The text of --help. */
  std::string
  help_text();
} // namespace Signorini

#endif
