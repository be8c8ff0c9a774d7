#ifndef signorini_curves_point_table_h
#define signorini_curves_point_table_h

#include <deal.II/base/point.h>

#include <string>
#include <vector>

namespace Signorini
{
  /**
   * Reads a text file with two columns, x and y in m, separated by blanks, a
   * tabulator or a comma. What follows a # and empty lines do not count.
   * @param entry the path of the entry that names the file, for messages
   * @throws InputError if the file cannot be read, or for a line with other
   * than two numbers: with file and line.
   */
  std::vector<dealii::Point<2>>
  read_point_table(const std::string &path, const std::string &entry);
} // namespace Signorini

#endif
