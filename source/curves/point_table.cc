#include <signorini/curves/point_table.h>
#include <signorini/input/input_error.h>
#include <signorini/input/named_errors.h>
#include <signorini/input/regular_file.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    bool
    read_number(const std::string &word, double &number)
    {
      std::size_t used = 0;
      try
        {
          number = std::stod(word, &used);
        }
      catch (const std::exception &)
        {
          return false;
        }
      return used == word.size() && std::isfinite(number);
    }
  } // namespace



  std::vector<Point<2>>
  read_point_table(const std::string &path, const std::string &entry)
  {
    with_entry(entry, [&] { require_regular_file(path, largest_text); });
    std::ifstream file(path);
    std::string   line;
    if (!file || file.peek() == std::ifstream::traits_type::eof())
      throw InputError(entry,
                       "the file \"" + path +
                         "\" cannot be read or is empty. It has to be a text "
                         "file with two columns, x and y in m.");
    std::vector<Point<2>> points;
    for (unsigned int number = 1; std::getline(file, line); ++number)
      {
        std::string text = line.substr(0, line.find('#'));
        std::replace(text.begin(), text.end(), ',', ' ');
        std::istringstream       stream(text);
        std::vector<std::string> words;
        for (std::string word; stream >> word;)
          words.push_back(word);
        if (words.empty())
          continue;
        Point<2> point;
        if (words.size() != 2 || !read_number(words[0], point[0]) ||
            !read_number(words[1], point[1]))
          throw InputError(
            entry,
            path + ":" + std::to_string(number) +
              ": two numbers are expected, x and y in m, found \"" +
              Utilities::trim(line) + "\".");
        points.push_back(point);
      }
    return points;
  }
} // namespace Signorini
