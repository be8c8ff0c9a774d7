#include <signorini/input/input_error.h>
#include <signorini/input/named_errors.h>
#include <signorini/input/nearest_name.h>
#include <signorini/input/parameter_statements.h>
#include <signorini/input/regular_file.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <utility>

namespace Signorini
{
  namespace
  {
    // More of them are no work of a pen; each would fill memory or stack.
    constexpr std::size_t  longest_line    = 100000;
    constexpr std::size_t  deepest_section = 50;
    constexpr unsigned int most_files      = 1000;
    constexpr std::size_t  deepest_include = 50;
    constexpr std::size_t  most_statements = 100000;

    /** A line with its continuations joined and its comments removed. */
    struct Line
    {
      std::string  text;
      unsigned int number;
    };



    std::string
    without_comment(const std::string &line)
    {
      return line.substr(0, line.find('#'));
    }



    /** What is printed of a line: not all of a long one, nor what is no text.
     */
    std::string
    excerpt(const std::string &line)
    {
      constexpr std::size_t longest = 200;
      std::string           text    = line.substr(0, longest);
      for (char &c : text)
        if (std::iscntrl(static_cast<unsigned char>(c)))
          c = '?';
      return text + (line.size() > longest ? "..." : "");
    }



    /** A control character that is no blank. */
    bool
    is_no_text(const unsigned char c)
    {
      return std::iscntrl(c) && !std::isspace(c);
    }



    std::string
    place(const std::string &file, const unsigned int line)
    {
      return file + ":" + std::to_string(line);
    }



    /**
     * The comment goes first, line by line, so that each line of a long list
     * can carry its own comment and a comment cannot swallow the next line.
     */
    std::vector<Line>
    joined_lines(std::istream &stream, const std::string &file)
    {
      std::vector<Line> lines;
      std::string       physical_line;
      bool              continued = false;
      for (unsigned int number = 1; std::getline(stream, physical_line);
           ++number)
        {
          std::string text = without_comment(physical_line);
          text.erase(text.find_last_not_of(" \t\r") + 1);
          if (std::any_of(text.begin(), text.end(), is_no_text))
            throw InputError(place(file, number) +
                             ": the line has a character that is no text. Is "
                             "this a .prm file?");
          const bool continues = !text.empty() && text.back() == '\\';
          if (continues)
            text.pop_back();

          if (number == 1 && text.rfind("\xEF\xBB\xBF", 0) == 0)
            text.erase(0, 3); // the mark that some editors put in front
          if (continued)
            lines.back().text +=
              text.substr(std::min(text.find_first_not_of(" \t"), text.size()));
          else
            lines.push_back({text, number});
          continued = continues;
          if (lines.back().text.size() > longest_line)
            throw InputError(place(file, lines.back().number) +
                             ": the line has more than " +
                             std::to_string(longest_line) +
                             " characters. Is this a .prm file?");
        }
      if (continued)
        throw InputError(place(file, lines.back().number) +
                         ": the backslash promises another line, but the file "
                         "ends. Remove the backslash.");
      for (Line &line : lines)
        line.text = without_extra_blanks(line.text);
      return lines;
    }



    /** "set A = b" -> {"set", "A = b"}; keywords count in either case. */
    std::pair<std::string, std::string>
    split_keyword(const std::string &line)
    {
      const std::size_t blank   = line.find(' ');
      std::string       keyword = line.substr(0, blank);
      std::transform(keyword.begin(),
                     keyword.end(),
                     keyword.begin(),
                     [](const unsigned char c) { return std::tolower(c); });
      return {keyword,
              blank == std::string::npos ? "" : line.substr(blank + 1)};
    }



    /** " Did you mean "x.prm"?" for a file of the same folder, or nothing. */
    std::string
    suggested_file(const std::filesystem::path &missing)
    {
      const std::filesystem::path folder =
        missing.has_parent_path() ? missing.parent_path() : ".";
      std::vector<std::string> names;
      std::error_code          ignored;
      for (const auto &item :
           std::filesystem::directory_iterator(folder, ignored))
        names.push_back(item.path().filename().string());
      const std::string nearest =
        nearest_name(missing.filename().string(), names);
      return nearest.empty() ?
               "" :
               " Did you mean \"" + (missing.parent_path() / nearest).string() +
                 "\"?";
    }



    /** Follows the lines through all included files. */
    class StatementReader
    {
    public:
      /** @param asked_by "file:line: " of the include, or nothing. */
      void
      read(const std::filesystem::path &path, const std::string &asked_by);

      std::vector<ParameterStatement> statements;

    private:
      void
      interpret(const std::string &line, const std::string &origin);

      void
      open_section(const std::string &name, const std::string &origin);

      void
      set(const std::string &assignment, const std::string &origin);

      void
      add(const ParameterStatement &statement);

      void
      include(const std::string &file, const std::string &origin);

      void
      guard_against_recursion(const std::filesystem::path &path,
                              const std::string           &asked_by) const;

      std::vector<std::string> section;

      /** Where each of the open sections begins. */
      std::vector<std::string> section_origins;

      /** The file and those that include it, the first one read first. */
      std::vector<std::filesystem::path> files_being_read;

      unsigned int n_files = 0;

      /** Number of sections that were open when the file began. */
      std::size_t depth_at_start = 0;
    };



    std::ifstream
    open_file(const std::filesystem::path &path, const std::string &asked_by)
    {
      const std::string name = "\"" + path.string() + "\"";
      std::error_code   ignored;
      if (!std::filesystem::exists(path, ignored))
        throw InputError(asked_by + name + " does not exist." +
                         suggested_file(path));
      with_prefix(asked_by, [&] { require_regular_file(path, largest_text); });
      std::ifstream stream(path);
      if (!stream)
        throw InputError(asked_by + name +
                         " cannot be read. Check its permissions.");
      return stream;
    }



    void
    StatementReader::read(const std::filesystem::path &path,
                          const std::string           &asked_by)
    {
      std::ifstream stream = open_file(path, asked_by);
      guard_against_recursion(path, asked_by);
      if (++n_files > most_files || files_being_read.size() > deepest_include)
        throw InputError(asked_by + "more than " + std::to_string(most_files) +
                         " files are included, or more than " +
                         std::to_string(deepest_include) +
                         " in each other. Put them together.");

      const std::size_t depth_around = depth_at_start;
      depth_at_start                 = section.size();
      files_being_read.push_back(path);
      const std::string file = path.string();
      for (const Line &line : joined_lines(stream, file))
        if (!line.text.empty())
          interpret(line.text, place(file, line.number));

      if (section.size() > depth_at_start)
        throw InputError(section_origins[depth_at_start] + ": subsection \"" +
                         section[depth_at_start] +
                         "\" is not closed. An \"end\" is missing, in it or "
                         "in a subsection inside it.");
      files_being_read.pop_back();
      depth_at_start = depth_around;
    }



    void
    StatementReader::interpret(const std::string &line,
                               const std::string &origin)
    {
      const auto [keyword, rest] = split_keyword(line);
      if (keyword == "set")
        set(rest, origin);
      else if (keyword == "subsection")
        open_section(rest, origin);
      else if (keyword == "end" && rest.empty())
        {
          if (section.size() == depth_at_start)
            throw InputError(origin +
                             ": \"end\" without a subsection to close. "
                             "Remove it, or add the \"subsection\" line.");
          section.pop_back();
          section_origins.pop_back();
        }
      else if (keyword == "include")
        include(rest, origin);
      else
        throw InputError(origin + ": cannot understand \"" + excerpt(line) +
                         "\". A line is one of: set NAME = VALUE, subsection "
                         "NAME, end, include FILE, # comment.");
    }



    void
    StatementReader::open_section(const std::string &name,
                                  const std::string &origin)
    {
      if (name.empty())
        throw InputError(origin + ": \"subsection\" without a name.");
      if (section.size() == deepest_section)
        throw InputError(origin + ": more than " +
                         std::to_string(deepest_section) +
                         " subsections inside of each other. Is an \"end\" "
                         "missing?");
      section.push_back(name);
      section_origins.push_back(origin);
      add({section, "", "", origin});
    }



    void
    StatementReader::set(const std::string &assignment,
                         const std::string &origin)
    {
      const std::size_t equals = assignment.find('=');
      if (equals == std::string::npos)
        throw InputError(origin + ": \"set " + excerpt(assignment) +
                         "\" has no \"=\". Write: set NAME = VALUE.");
      const std::string name =
        without_extra_blanks(assignment.substr(0, equals));
      if (name.empty())
        throw InputError(origin + ": \"set\" without a name before the \"=\". "
                                  "Write: set NAME = VALUE.");
      add({section,
           name,
           without_extra_blanks(assignment.substr(equals + 1)),
           origin});
    }



    void
    StatementReader::add(const ParameterStatement &statement)
    {
      if (statements.size() == most_statements)
        throw InputError(statement.origin + ": more than " +
                         std::to_string(most_statements) +
                         " lines, those of included files counted. Is this a "
                         ".prm file?");
      statements.push_back(statement);
    }



    void
    StatementReader::include(const std::string &file, const std::string &origin)
    {
      if (file.empty())
        throw InputError(origin + ": \"include\" without a file name.");
      const std::filesystem::path folder =
        files_being_read.back().parent_path();
      read((folder / file).lexically_normal(), origin + ": ");
    }



    void
    StatementReader::guard_against_recursion(const std::filesystem::path &path,
                                             const std::string &asked_by) const
    {
      for (auto file = files_being_read.begin(); file != files_being_read.end();
           ++file)
        if (std::filesystem::equivalent(*file, path))
          {
            std::string chain;
            for (auto link = file; link != files_being_read.end(); ++link)
              chain += link->string() + " -> ";
            throw InputError(asked_by + "the file includes itself: " + chain +
                             path.string() + ".");
          }
    }
  } // namespace



  std::vector<ParameterStatement>
  read_parameter_statements(const std::string &path)
  {
    StatementReader reader;
    reader.read(path, "");
    return reader.statements;
  }



  std::string
  section_in_words(const std::vector<std::string> &section)
  {
    std::string words;
    for (const std::string &name : section)
      words += (words.empty() ? "" : " / ") + name;
    return words;
  }



  std::string
  without_extra_blanks(const std::string &text)
  {
    std::istringstream words(text);
    std::string        word;
    std::string        result;
    while (words >> word)
      result += (result.empty() ? "" : " ") + word;
    return result;
  }
} // namespace Signorini
