#include <signorini/input/parameter_json.h>

#include <iomanip>
#include <sstream>
#include <vector>

namespace Signorini
{
  namespace
  {
    std::string
    json_text(const std::string &text)
    {
      std::ostringstream quoted;
      quoted << '"';
      for (const char c : text)
        if (c == '"' || c == '\\')
          quoted << '\\' << c;
        else if (static_cast<unsigned char>(c) < 0x20)
          quoted << "\\u" << std::hex << std::setw(4) << std::setfill('0')
                 << int(c);
        else
          quoted << c;
      quoted << '"';
      return quoted.str();
    }

    std::string
    json_entry(const DeclaredSection::Entry &entry)
    {
      return json_text(entry.name) + ": {\"value\": " + json_text(entry.value) +
             ", \"default_value\": " + json_text(entry.default_value) +
             ", \"documentation\": " + json_text(entry.documentation) +
             ", \"pattern_description\": " + json_text(entry.pattern) + "}";
    }

    std::string
    json_section(const DeclaredSection &section, const std::string &indentation)
    {
      std::vector<std::string> members;
      const std::string        inner = indentation + " ";
      for (const DeclaredSection::Entry &entry : section.entries)
        members.push_back(json_entry(entry));
      for (const auto &[name, subsection] : section.sections)
        members.push_back(json_text(name) + ": " +
                          json_section(subsection, inner));
      std::string text = "{";
      for (const std::string &member : members)
        text += (text == "{" ? "\n" : ",\n") + inner + member;
      return text + "\n" + indentation + "}";
    }
  } // namespace



  std::string
  parameter_json(const DeclaredSection &section)
  {
    return json_section(section, "") + "\n";
  }
} // namespace Signorini
