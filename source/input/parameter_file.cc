#include <signorini/input/as_text.h>
#include <signorini/input/declared_parameters.h>
#include <signorini/input/input_error.h>
#include <signorini/input/named_list.h>
#include <signorini/input/nearest_name.h>
#include <signorini/input/number_text.h>
#include <signorini/input/parameter_file.h>
#include <signorini/input/pattern_in_words.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    std::string
    joined_path(const ParameterStatement &statement)
    {
      std::string path;
      for (const std::string &name : statement.section)
        path += (path.empty() ? "" : "/") + name;
      if (!statement.entry.empty())
        path += (path.empty() ? "" : "/") + statement.entry;
      return path;
    }



    /** "file:12: in "Body beam / Material": ", or without the section. */
    std::string
    place_of(const std::string &origin, const std::vector<std::string> &section)
    {
      return origin + ": " +
             (section.empty() ? "" :
                                "in \"" + section_in_words(section) + "\": ");
    }



    std::string
    allowed(const std::string &what, const std::vector<std::string> &names)
    {
      return names.empty() ?
               " There are no " + what + " here." :
               " Allowed " + what + " here: " + comma_separated(names) + ".";
    }



    /** The first section, from the top down, that has such an entry. */
    std::string
    home_of_entry(const DeclaredSection &section, const std::string &entry)
    {
      for (const auto &[name, subsection] : section.sections)
        {
          if (subsection.find_entry(entry) != nullptr)
            return name;
          const std::string deeper = home_of_entry(subsection, entry);
          if (!deeper.empty())
            return name + " / " + deeper;
        }
      return "";
    }



    std::string
    unknown_section(const ParameterStatement &statement,
                    const DeclaredSection    &parent)
    {
      const std::vector<std::string> around(statement.section.begin(),
                                            statement.section.end() - 1);
      const std::string             &name  = statement.section.back();
      const std::vector<std::string> names = parent.section_names();
      const std::string              hint =
        parent.find_entry(name) != nullptr ?
                       " It is an entry: write \"set " + name + " = ...\"." :
                       did_you_mean(name, names);
      return place_of(statement.origin, around) + "unknown subsection \"" +
             name + "\"." + hint + allowed("subsections", names);
    }



    std::string
    unknown_entry(const ParameterStatement &statement,
                  const DeclaredSection    &section,
                  const DeclaredSection    &top)
    {
      const std::vector<std::string> names = section.entry_names();
      std::string       hint = did_you_mean(statement.entry, names);
      const std::string home = home_of_entry(top, statement.entry);
      if (section.find_section(statement.entry) != nullptr)
        hint = " It is a subsection: write \"subsection " + statement.entry +
               "\", its entries, and \"end\".";
      else if (!home.empty())
        hint = " It belongs to \"" + home + "\".";
      else if (top.find_entry(statement.entry) != nullptr)
        hint = " It belongs to the top of the file, outside any subsection.";
      return place_of(statement.origin, statement.section) +
             "unknown entry \"" + statement.entry + "\"." + hint +
             allowed("entries", names);
    }



    std::string
    wrong_value(const ParameterStatement &statement, const std::string &pattern)
    {
      const std::string problem =
        statement.value.empty() ?
          "entry \"" + statement.entry + "\" has no value." :
          "entry \"" + statement.entry + "\" cannot be \"" + statement.value +
            "\".";
      return place_of(statement.origin, statement.section) + problem +
             did_you_mean(statement.value, names_in_pattern(pattern)) +
             " Allowed: " + pattern_in_words(pattern) + ".";
    }



    /** Of the numbers in a value; what is no number is left to the pattern. */
    bool
    are_sane(const std::string &value)
    {
      const char *at = value.c_str();
      while (*at != '\0')
        {
          char *end           = nullptr;
          errno               = 0; // of what vanishes, such as 1e-9999
          const double number = std::strtod(at, &end);
          if (end != at && (errno == ERANGE || !is_sane(number)))
            return false;
          at = end == at ? at + 1 : end;
        }
      return true;
    }



    /** Sets one entry at a time and gathers what is wrong. */
    class Application
    {
    public:
      Application(const Constants &constants, ParameterHandler &prm)
        : constants(constants)
        , prm(prm)
        , top(declared_parameters(prm))
      {}

      void
      apply(const ParameterStatement &statement);

      std::vector<std::string> problems;

    private:
      void
      set(const ParameterStatement &statement, const std::string &pattern);

      void
      set_value(const ParameterStatement &statement,
                const std::string        &pattern,
                const std::string        &value);

      const Constants       constants;
      ParameterHandler     &prm;
      const DeclaredSection top;

      /** Reported already; their entries are passed over. */
      std::set<std::vector<std::string>> unknown_sections;
    };



    void
    Application::apply(const ParameterStatement &statement)
    {
      const DeclaredSection   *section = &top;
      std::vector<std::string> path;
      for (const std::string &name : statement.section)
        {
          const DeclaredSection *const parent = section;
          path.push_back(name);
          section = parent->find_section(name);
          if (section == nullptr)
            {
              if (unknown_sections.insert(path).second)
                problems.push_back(
                  unknown_section({path, "", "", statement.origin}, *parent));
              return;
            }
        }
      if (statement.entry.empty())
        return;
      const DeclaredSection::Entry *entry =
        section->find_entry(statement.entry);
      if (entry == nullptr)
        problems.push_back(unknown_entry(statement, *section, top));
      else
        set(statement, entry->pattern);
    }



    void
    Application::set(const ParameterStatement &statement,
                     const std::string        &pattern)
    {
      try
        {
          set_value(statement,
                    pattern,
                    evaluate_numbers(statement.value, pattern, constants));
        }
      catch (const InputError &error)
        {
          problems.push_back(wrong_value(statement, pattern) + " " +
                             as_sentence(error.text()));
        }
    }



    void
    Application::set_value(const ParameterStatement &statement,
                           const std::string        &pattern,
                           const std::string        &value)
    {
      if (pattern.find("[Double") != std::string::npos && !are_sane(value))
        {
          problems.push_back(place_of(statement.origin, statement.section) +
                             "entry \"" + statement.entry + "\": found \"" +
                             value + "\"; " + sane_magnitudes + ".");
          return;
        }
      for (const std::string &name : statement.section)
        prm.enter_subsection(name);
      try
        {
          prm.set(statement.entry, value);
        }
      catch (const ParameterHandler::ExcValueDoesNotMatchPattern &)
        {
          problems.push_back(
            wrong_value(statement, pattern) +
            (value == statement.value ? "" : " Its value is " + value + "."));
        }
      for (std::size_t i = 0; i < statement.section.size(); ++i)
        prm.leave_subsection();
    }
  } // namespace



  ParameterFile
  ParameterFile::read(const std::string &path)
  {
    ParameterFile file;
    file.file_path  = path;
    file.statements = read_parameter_statements(path);
    return file;
  }



  void
  ParameterFile::override_entry(const std::string &assignment)
  {
    const std::size_t equals = assignment.find('=');
    const std::string usage  = " Write: --set \"Section/Entry=value\".";
    if (equals == std::string::npos)
      throw InputError("--set: \"" + assignment + "\" has no \"=\"." + usage);

    std::vector<std::string> names;
    for (const std::string &name :
         split_list(assignment.substr(0, equals), '/'))
      names.push_back(without_extra_blanks(name));
    if (names.empty() || std::count(names.begin(), names.end(), "") > 0)
      throw InputError("--set: \"" + assignment +
                       "\" has an empty name before the \"=\"." + usage);

    const std::string entry = names.back();
    names.pop_back();
    statements.push_back({names,
                          entry,
                          without_extra_blanks(assignment.substr(equals + 1)),
                          "--set"});
  }



  std::string
  ParameterFile::get(const std::string &path,
                     const std::string &default_value) const
  {
    const auto last = std::find_if(statements.rbegin(),
                                   statements.rend(),
                                   [&](const ParameterStatement &statement) {
                                     return !statement.entry.empty() &&
                                            joined_path(statement) == path;
                                   });
    return last == statements.rend() ? default_value : last->value;
  }



  Constants
  ParameterFile::constants() const
  {
    const std::string entry = "Constants";
    try
      {
        return parse_constants(get(entry, ""), entry);
      }
    catch (const InputError &error)
      {
        throw InputError(where(entry) + ": " + error.what());
      }
  }



  void
  ParameterFile::apply(ParameterHandler &prm) const
  {
    Application application(constants(), prm);
    for (const ParameterStatement &statement : statements)
      application.apply(statement);

    std::string           message;
    constexpr std::size_t most    = 20; // nobody reads more at a time
    const std::size_t     n_shown = std::min(most, application.problems.size());
    for (std::size_t i = 0; i < n_shown; ++i)
      message += (i == 0 ? "" : "\n") + application.problems[i];
    if (application.problems.size() > n_shown)
      message += "\nand " +
                 std::to_string(application.problems.size() - n_shown) +
                 " more like these.";
    if (!message.empty())
      throw InputError(message);
  }



  std::string
  ParameterFile::where(const std::string &path) const
  {
    const auto last = std::find_if(statements.rbegin(),
                                   statements.rend(),
                                   [&](const ParameterStatement &statement) {
                                     return joined_path(statement) == path;
                                   });
    return last == statements.rend() ? "default" : last->origin;
  }



  std::vector<ParameterStatement>
  ParameterFile::assignments() const
  {
    std::map<std::string, ParameterStatement> last;
    for (const ParameterStatement &statement : statements)
      if (!statement.entry.empty())
        last[joined_path(statement)] = statement;
    std::vector<ParameterStatement> list;
    for (const auto &[path, statement] : last)
      list.push_back(statement);
    return list;
  }



  const std::string &
  ParameterFile::path() const
  {
    return file_path;
  }



  std::string
  ParameterFile::directory() const
  {
    const std::filesystem::path folder =
      std::filesystem::path(file_path).parent_path();
    return folder.empty() ? "." : folder.string();
  }
} // namespace Signorini
