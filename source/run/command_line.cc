#include <signorini/input/nearest_name.h>
#include <signorini/input/shell_word.h>
#include <signorini/run/command_line.h>

#include <boost/program_options.hpp>

#include <algorithm>
#include <sstream>

namespace Signorini
{
  namespace
  {
    namespace po = boost::program_options;

    using Texts = std::vector<std::string>;

    po::options_description
    visible_options()
    {
      po::options_description options("Options");
      options.add_options()("check",
                            "read and check the files, compute nothing");
      options.add_options()("print-parameters",
                            "print all entries with default and meaning, of "
                            "the files with their values");
      options.add_options()("format",
                            po::value<std::string>()->value_name("FORMAT"),
                            "of --print-parameters: prm (default), xml for "
                            "deal.II's parameter_gui, or json");
      options.add_options()("write-reference",
                            po::value<std::string>()->value_name("DIR"),
                            "write the reference of all entries to DIR, as "
                            "HTML, Markdown, XML and JSON");
      options.add_options()("output-directory",
                            po::value<std::string>()->value_name("DIR"),
                            "folder for the results, instead of the one in "
                            "the .prm; every run gets its own folder inside");
      options.add_options()("overwrite",
                            "replace the results of an earlier run");
      options.add_options()("resume",
                            "go on from the last checkpoint of the newest "
                            "earlier run");
      options.add_options()("resume-from",
                            po::value<std::string>()->value_name("DIR"),
                            "the same for the run whose results are in DIR");
      options.add_options()("set",
                            po::value<Texts>()->value_name("ENTRY"),
                            "set an entry on top of the file, as in "
                            "--set \"Section/Entry=value\"; may be repeated");
      options.add_options()("steps",
                            po::value<std::string>()->value_name("N"),
                            "stop after N time steps, without checking the "
                            "expected results");
      options.add_options()("threads",
                            po::value<std::string>()->value_name("N"),
                            "use at most N threads (default: all cores)");
      options.add_options()("help", "print this text");
      options.add_options()("version", "print the versions in use");
      return options;
    }



    po::variables_map
    parsed_options(const int argc, const char *const *argv)
    {
      po::options_description all = visible_options();
      all.add_options()("prm", po::value<Texts>());
      po::positional_options_description positional;
      positional.add("prm", -1);

      // Abbreviated options would break when a new option is added.
      using namespace po::command_line_style;
      const auto        style = unix_style & ~allow_guessing & ~allow_short;
      po::variables_map values;
      po::store(po::command_line_parser(argc, argv)
                  .options(all)
                  .positional(positional)
                  .style(style)
                  .run(),
                values);
      return values;
    }



    std::string
    suggested_option(const std::string &wrong)
    {
      const po::options_description options = visible_options();
      Texts                         names;
      for (const auto &option : options.options())
        names.push_back("--" + option->long_name());
      return did_you_mean(wrong, names);
    }



    /** A whole number of at least one, or nothing without the option. */
    std::optional<unsigned int>
    count(const po::variables_map &values, const std::string &option)
    {
      if (values.count(option) == 0)
        return {};
      const std::string text = values[option].as<std::string>();
      // Nine digits at most, so that the number fits.
      if (text.empty() || text.size() > 9 ||
          text.find_first_not_of("0123456789") != std::string::npos ||
          std::stoul(text) == 0)
        throw CommandLineError("--" + option + ": \"" + text +
                               "\" is not a whole number from 1 to "
                               "999999999.");
      return static_cast<unsigned int>(std::stoul(text));
    }



    Texts
    texts(const po::variables_map &values, const std::string &option)
    {
      return values.count(option) == 0 ? Texts() : values[option].as<Texts>();
    }



    /** What a second call needs to do the same. */
    std::string
    repeated_options(const po::variables_map &values)
    {
      std::string text;
      for (const std::string &assignment : texts(values, "set"))
        text += " --set " + quoted(assignment);
      if (values.count("threads") > 0)
        text += " --threads " + values["threads"].as<std::string>();
      return text;
    }



    ParameterFormat
    parameter_format(const po::variables_map &values)
    {
      if (values.count("format") == 0)
        return ParameterFormat::prm;
      if (values.count("print-parameters") == 0)
        throw CommandLineError("--format is for --print-parameters: give both "
                               "of them.");
      const std::string name  = values["format"].as<std::string>();
      const Texts       names = {"prm", "xml", "json"};
      const auto        found = std::find(names.begin(), names.end(), name);
      if (found == names.end())
        throw CommandLineError("--format: \"" + name + "\" is none of " +
                               comma_separated(names) + ".");
      return ParameterFormat(found - names.begin());
    }



    void
    refuse_contradictions(const CommandLine &line)
    {
      const RunOptions &options = line.run_options;
      if (line.reference_folder && !line.prm_files.empty())
        throw CommandLineError("--write-reference is of all problems: give no "
                               ".prm file.");
      if (!options.resume)
        return;
      if (options.overwrite)
        throw CommandLineError("--resume goes on with a run, --overwrite "
                               "starts it anew: give one of them.");
      if (options.check_only)
        throw CommandLineError("--resume computes, --check does not: give one "
                               "of them.");
      if (!options.resume->empty() && line.prm_files.size() > 1)
        throw CommandLineError("--resume-from is for a single .prm file.");
    }



    // A first word instead of a .prm file.
    const std::string solve_interface = "solve-interface";

    CommandLine
    command_line(const po::variables_map &values)
    {
      CommandLine result;
      result.prm_files = texts(values, "prm");
      if (!result.prm_files.empty() &&
          result.prm_files.front() == solve_interface)
        {
          result.interface_files.assign(result.prm_files.begin() + 1,
                                        result.prm_files.end());
          result.prm_files.clear();
          if (result.interface_files.empty())
            throw CommandLineError(solve_interface + ": no file is given.");
        }
      result.help                   = values.count("help") > 0;
      result.version                = values.count("version") > 0;
      result.print_parameters       = values.count("print-parameters") > 0;
      result.parameter_format       = parameter_format(values);
      result.threads                = count(values, "threads");
      result.run_options.check_only = values.count("check") > 0;
      result.run_options.overwrite  = values.count("overwrite") > 0;
      result.run_options.overrides  = texts(values, "set");
      result.run_options.max_steps  = count(values, "steps");
      result.run_options.repeated_options = repeated_options(values);
      if (values.count("resume") > 0)
        result.run_options.resume = "";
      if (values.count("resume-from") > 0)
        result.run_options.resume = values["resume-from"].as<std::string>();
      if (values.count("output-directory") > 0)
        result.run_options.output_directory =
          values["output-directory"].as<std::string>();
      if (values.count("write-reference") > 0)
        result.reference_folder = values["write-reference"].as<std::string>();
      refuse_contradictions(result);
      return result;
    }
  } // namespace



  CommandLine
  CommandLine::parse(const int argc, const char *const *argv)
  {
    CommandLine result;
    try
      {
        result                     = command_line(parsed_options(argc, argv));
        result.run_options.program = argv[0];
      }
    catch (const po::unknown_option &error)
      {
        throw CommandLineError("Unknown option " + error.get_option_name() +
                               "." + suggested_option(error.get_option_name()));
      }
    catch (const po::error &error)
      {
        throw CommandLineError(std::string("Command line: ") + error.what() +
                               ".");
      }
    if (result.prm_files.empty() && result.interface_files.empty() &&
        !result.help && !result.version && !result.print_parameters &&
        !result.reference_folder)
      throw CommandLineError("No .prm file is given.");
    return result;
  }



  std::string
  help_text()
  {
    std::ostringstream text;
    text << "Signorini: dynamic contact by variational inequalities.\n\n"
         << "Usage: signorini [options] FILE.prm [FILE.prm ...]\n"
         << "       signorini solve-interface FILE [FILE ...]\n\n"
         << "solve-interface solves interface problems that were written to "
            "files by every\nexact algorithm and compares them.\n\n"
         << visible_options()
         << "\nExit codes: 0 done, 1 wrong input, 2 wrong command line, 3 the "
            "computation failed,\n4 expected results missed, 130 "
            "interrupted.\n";
    return text.str();
  }
} // namespace Signorini
