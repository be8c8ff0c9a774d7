#include <signorini/input/as_text.h>
#include <signorini/input/input_error.h>
#include <signorini/output/pvd_file.h>
#include <signorini/output/run_folder.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace Signorini
{
  namespace
  {
    [[noreturn]] void
    fail(const std::string &file_name, const std::string &reason)
    {
      throw ComputationError("The result file '" + file_name +
                             "' cannot be written: " + reason +
                             ". Free some space on its disk or choose another "
                             "output folder, then repeat the run. The earlier "
                             "results can be read.");
    }

    std::string
    escape_xml(const std::string &text)
    {
      std::string result;
      for (const char c : text)
        switch (c)
          {
            case '&':
              result += "&amp;";
              break;
            case '<':
              result += "&lt;";
              break;
            case '>':
              result += "&gt;";
              break;
            case '"':
              result += "&quot;";
              break;
            default:
              result += c;
          }
      return result;
    }

    void
    write(const std::string &file_name, const std::string &content)
    {
      std::ofstream file(file_name, std::ios::binary);
      file.write(content.data(), content.size());
      file.close();
      if (!file)
        fail(file_name, std::strerror(errno));
    }
  } // namespace



  void
  write_result_file(const std::string &file_name, const std::string &content)
  {
    write(result_file(file_name), content);
  }



  void
  replace_result_file(const std::string &file_name, const std::string &content)
  {
    const std::string new_file = result_file(file_name) + being_written;
    write(new_file, content);
    std::error_code error;
    std::filesystem::rename(new_file, file_name, error);
    if (error)
      fail(file_name, error.message());
  }



  std::vector<std::string>
  file_names_of_parts(const std::vector<std::string> &parts)
  {
    std::vector<std::string> names;
    for (const std::string &part : parts)
      {
        std::string name = part;
        for (char &c : name)
          if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '.' &&
              c != '-' && c != '_')
            c = '_';
        const auto same = std::find(names.begin(), names.end(), name);
        if (same != names.end())
          throw InputError("The results of '" + parts[same - names.begin()] +
                           "' and '" + part +
                           "' would be written to the same "
                           "files, '" +
                           name + "_*.vtu'. Give one of them another name.");
        names.push_back(name);
      }
    return names;
  }



  std::string
  vtu_file_name(const std::string &name, const unsigned int number)
  {
    char text[16];
    std::snprintf(text, sizeof(text), "_%05u.vtu", number);
    return name + text;
  }



  PvdFile::PvdFile(const std::string &file_name)
    : file_name(file_name)
  {}



  void
  PvdFile::write(const std::vector<std::string> &parts,
                 const double                    time,
                 const VtuText                  &vtu_text)
  {
    const std::vector<std::string> names = file_names_of_parts(parts);
    const auto         folder = std::filesystem::path(file_name).parent_path();
    std::vector<Entry> new_entries;
    for (unsigned int i = 0; i < parts.size(); ++i)
      {
        const std::string vtu_file = vtu_file_name(names[i], number);
        write_result_file(folder / vtu_file, vtu_text(i, number));
        new_entries.push_back({time, parts[i], vtu_file});
      }
    for (const Entry &entry : new_entries)
      {
        entries.push_back(entry);
        if (std::find(known_parts.begin(), known_parts.end(), entry.part) ==
            known_parts.end())
          known_parts.push_back(entry.part);
      }
    ++number;
    write_list();
  }



  void
  PvdFile::cut_back() const
  {
    const auto folder = std::filesystem::path(file_name).parent_path();
    if (!entries.empty())
      write_list();
    for (const std::string &name : file_names_of_parts(known_parts))
      for (unsigned int beyond = number;; ++beyond)
        {
          std::error_code error;
          if (!std::filesystem::remove(folder / vtu_file_name(name, beyond),
                                       error))
            break;
        }
  }



  void
  PvdFile::write_list() const
  {
    std::string text = "<?xml version=\"1.0\"?>\n"
                       "<VTKFile type=\"Collection\" version=\"0.1\" "
                       "byte_order=\"LittleEndian\">\n"
                       "  <Collection>\n";
    for (const Entry &entry : entries)
      {
        const auto part =
          std::find(known_parts.begin(), known_parts.end(), entry.part);
        text += "    <DataSet timestep=\"" + shortest_exact(entry.time) +
                "\" part=\"" + std::to_string(part - known_parts.begin()) +
                "\" name=\"" + escape_xml(entry.part) + "\" file=\"" +
                escape_xml(entry.vtu_file) + "\"/>\n";
      }
    text += "  </Collection>\n"
            "</VTKFile>\n";

    replace_result_file(file_name, text);
  }
} // namespace Signorini
