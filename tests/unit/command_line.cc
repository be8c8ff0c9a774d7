#include <signorini/input/shell_word.h>
#include <signorini/run/command_line.h>

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(command_line)

namespace
{
  using Signorini::CommandLine;

  CommandLine
  parse(std::vector<const char *> arguments)
  {
    arguments.insert(arguments.begin(), "signorini");
    return CommandLine::parse(static_cast<int>(arguments.size()),
                              arguments.data());
  }



  std::string
  message_of(const std::vector<const char *> &arguments)
  {
    try
      {
        parse(arguments);
      }
    catch (const Signorini::CommandLineError &error)
      {
        return error.what();
      }
    return "";
  }
} // namespace



BOOST_AUTO_TEST_CASE(defaults)
{
  const CommandLine line = parse({"a.prm"});
  BOOST_TEST(line.prm_files == std::vector<std::string>{"a.prm"},
             boost::test_tools::per_element());
  BOOST_TEST(!line.help);
  BOOST_TEST(!line.version);
  BOOST_TEST(!line.print_parameters);
  BOOST_TEST(!line.threads.has_value());
  BOOST_TEST(!line.run_options.check_only);
  BOOST_TEST(!line.run_options.overwrite);
  BOOST_TEST(line.run_options.output_directory.empty());
  BOOST_TEST(line.run_options.overrides.empty());
  BOOST_TEST(!line.run_options.max_steps.has_value());
  BOOST_TEST(!line.run_options.resume.has_value());
  BOOST_TEST(line.run_options.repeated_options == "");
}

BOOST_AUTO_TEST_CASE(all_options)
{
  const CommandLine              line  = parse({"a.prm",
                                                "--set",
                                                "Time/End time=-1",
                                                "b.prm",
                                                "--check",
                                                "--overwrite",
                                                "--output-directory=out put",
                                                "--set=Title=x = y",
                                                "--threads",
                                                "2",
                                                "--steps",
                                                "3",
                                                "c.prm"});
  const std::vector<std::string> files = {"a.prm", "b.prm", "c.prm"};
  BOOST_TEST(line.prm_files == files, boost::test_tools::per_element());
  const std::vector<std::string> overrides = {"Time/End time=-1",
                                              "Title=x = y"};
  BOOST_TEST(line.run_options.overrides == overrides,
             boost::test_tools::per_element());
  BOOST_TEST(line.run_options.check_only);
  BOOST_TEST(line.run_options.overwrite);
  BOOST_TEST(line.run_options.output_directory == "out put");
  BOOST_TEST(line.threads.value() == 2);
  BOOST_TEST(line.run_options.max_steps.value() == 3);
  BOOST_TEST(parse({"--help"}).help);
  BOOST_TEST(parse({"--version"}).version);
  BOOST_TEST(parse({"--print-parameters"}).print_parameters);
  BOOST_TEST(parse({"--write-reference=doc"}).reference_folder.value() ==
             "doc");
  BOOST_TEST((parse({"--print-parameters", "--format=json"}).parameter_format ==
              Signorini::ParameterFormat::json));
}

BOOST_AUTO_TEST_CASE(resume)
{
  const CommandLine newest = parse({"--resume", "a.prm"});
  BOOST_TEST(newest.prm_files == std::vector<std::string>{"a.prm"},
             boost::test_tools::per_element());
  BOOST_TEST(newest.run_options.resume.value() == "");

  const CommandLine line = parse({"a.prm",
                                  "--resume-from=output/a-2",
                                  "--threads=1",
                                  "--steps=3",
                                  "--set",
                                  "Time/End time=2"});
  BOOST_TEST(line.run_options.resume.value() == "output/a-2");
  BOOST_TEST(line.run_options.program == "signorini");
  // To go on once more: all that changes the run, but not where it stops.
  BOOST_TEST(line.run_options.repeated_options ==
             " --set 'Time/End time=2' --threads 1");
}

BOOST_AUTO_TEST_CASE(words_of_a_shell)
{
  using Signorini::quoted;
  BOOST_TEST(quoted("prm/a-1.prm") == "prm/a-1.prm");
  BOOST_TEST(quoted("my file") == "'my file'");
  BOOST_TEST(quoted("a=$x") == "'a=$x'");
  BOOST_TEST(quoted("Young's") == "'Young'\\''s'");
  BOOST_TEST(quoted("") == "''");
}

BOOST_AUTO_TEST_CASE(interface_problems)
{
  const CommandLine line = parse({"solve-interface", "a", "b", "--threads=1"});
  const std::vector<std::string> files = {"a", "b"};
  BOOST_TEST(line.interface_files == files, boost::test_tools::per_element());
  BOOST_TEST(line.prm_files.empty());
  BOOST_TEST(parse({"a.prm", "solve-interface"}).interface_files.empty());
  BOOST_TEST(Signorini::help_text().find("solve-interface FILE") !=
             std::string::npos);
}

BOOST_AUTO_TEST_CASE(messages)
{
  BOOST_TEST(message_of({}) == "No .prm file is given.");
  BOOST_TEST(message_of({"solve-interface"}) ==
             "solve-interface: no file is given.");
  BOOST_TEST(message_of({"a.prm", "--chek"}) ==
             "Unknown option --chek. Did you mean \"--check\"?");
  BOOST_TEST(message_of({"a.prm", "--over"}) == "Unknown option --over.");
  BOOST_TEST(message_of({"a.prm", "--threads", "0"}) ==
             "--threads: \"0\" is not a whole number from 1 to 999999999.");
  BOOST_TEST(message_of({"a.prm", "--steps", "2.5"}) ==
             "--steps: \"2.5\" is not a whole number from 1 to 999999999.");
  BOOST_TEST(message_of({"a.prm", "--steps", "10000000000"}) ==
             "--steps: \"10000000000\" is not a whole number from 1 to "
             "999999999.");
  BOOST_TEST(message_of({"a.prm", "--set"}) ==
             "Command line: the required argument for option '--set' is "
             "missing.");
  BOOST_TEST(message_of({"a.prm", "--resume", "--overwrite"}) ==
             "--resume goes on with a run, --overwrite starts it anew: give "
             "one of them.");
  BOOST_TEST(message_of({"a.prm", "--resume", "--check"}) ==
             "--resume computes, --check does not: give one of them.");
  BOOST_TEST(message_of({"a.prm", "b.prm", "--resume-from=output/a"}) ==
             "--resume-from is for a single .prm file.");
  BOOST_TEST(message_of({"a.prm", "--format=xml"}) ==
             "--format is for --print-parameters: give both of them.");
  BOOST_TEST(message_of({"--print-parameters", "--format", "yaml"}) ==
             "--format: \"yaml\" is none of prm, xml, json.");
  BOOST_TEST(message_of({"--write-reference=doc", "a.prm"}) ==
             "--write-reference is of all problems: give no .prm file.");
  BOOST_TEST(message_of({"a.prm", "--check=yes"}) ==
             "Command line: option '--check' does not take any arguments.");
}

BOOST_AUTO_TEST_CASE(help_names_every_option)
{
  for (const std::string option : {"--check",
                                   "--print-parameters",
                                   "--format FORMAT",
                                   "--write-reference DIR",
                                   "--output-directory DIR",
                                   "--overwrite",
                                   "--resume",
                                   "--resume-from DIR",
                                   "--set ENTRY",
                                   "--steps N",
                                   "--threads N",
                                   "--help",
                                   "--version"})
    BOOST_TEST(Signorini::help_text().find(option) != std::string::npos,
               option);
}

BOOST_AUTO_TEST_SUITE_END()
