#include "hardening_table.h"

#include <signorini/input/as_text.h>
#include <signorini/input/input_error.h>
#include <signorini/input/named_errors.h>
#include <signorini/input/named_list.h>
#include <signorini/input/regular_file.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    const std::string name = "Hardening table";

    std::vector<YieldCurve::Entry>
    read_file(const std::string &path)
    {
      with_entry(name, [&] { require_regular_file(path, largest_text); });
      std::ifstream file(path);
      std::string   line;
      if (!file || file.peek() == std::ifstream::traits_type::eof())
        throw InputError(name,
                         "the file \"" + path +
                           "\" cannot be read or is empty. It has to be a text "
                           "file with two columns, plastic strain and yield "
                           "stress in Pa.");
      std::vector<YieldCurve::Entry> entries;
      for (unsigned int number = 1; std::getline(file, line); ++number)
        {
          std::string text = line.substr(0, line.find('#'));
          std::replace(text.begin(), text.end(), ',', ' ');
          text = Utilities::trim(text);
          if (text.empty())
            continue;
          std::istringstream stream(text);
          YieldCurve::Entry  entry;
          if (!(stream >> entry.strain >> entry.stress) ||
              !(stream >> std::ws).eof())
            throw InputError(name,
                             path + ":" + std::to_string(number) +
                               ": two numbers are expected, plastic strain and "
                               "yield stress in Pa, found \"" +
                               Utilities::trim(line) + "\".");
          entries.push_back(entry);
        }
      return entries;
    }
  } // namespace



  std::vector<YieldCurve::Entry>
  read_hardening_table(const std::string &text,
                       const std::string &base_directory)
  {
    const std::string keyword = "file ";
    if (text.compare(0, keyword.size(), keyword) == 0)
      {
        const std::string file = Utilities::trim(text.substr(keyword.size()));
        return read_file(
          (std::filesystem::path(base_directory) / file).string());
      }
    std::vector<YieldCurve::Entry> entries;
    for (const auto &[strain, stress] : parse_named_list(text, name))
      entries.push_back(
        {parse_number(strain, name), parse_number(stress, name)});
    return entries;
  }



  void
  check_hardening_table(const std::vector<YieldCurve::Entry> &entries)
  {
    if (entries.empty())
      throw InputError(
        name,
        "is empty, but Hardening = table needs it. Write points `plastic "
        "strain: yield stress', such as 0: 235e6 | 0.1: 360e6.");
    if (entries[0].strain != 0.)
      throw InputError(
        name,
        "the first plastic strain must be zero, where the material begins to "
        "flow, found " +
          as_text(entries[0].strain) + ".");
    for (unsigned int i = 0; i < entries.size(); ++i)
      {
        const auto [strain, stress] = entries[i];
        const std::string where = " at the plastic strain " + as_text(strain);
        if (!(stress > 0.) || !std::isfinite(stress))
          throw InputError(
            name,
            "the yield stress must be greater than zero, in Pa, found " +
              as_text(stress) + where + ".");
        if (i == 0)
          continue;
        if (!(strain > entries[i - 1].strain) || !std::isfinite(strain))
          throw InputError(
            name,
            "the plastic strain must grow from point to point, found " +
              as_text(strain) + " after " + as_text(entries[i - 1].strain) +
              ".");
        if (!(stress >= entries[i - 1].stress))
          throw InputError(
            name,
            "the yield stress must not fall, found " + as_text(stress) + where +
              " after " + as_text(entries[i - 1].stress) +
              ". What softens fails in one layer of elements, and "
              "the result would depend on the mesh.");
      }
  }
} // namespace Signorini
