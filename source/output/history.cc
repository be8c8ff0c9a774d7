#include <signorini/input/input_error.h>
#include <signorini/input/nearest_name.h>
#include <signorini/output/history.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>

namespace Signorini
{
  std::string
  list_of_names(const std::string &wrong, const std::vector<std::string> &names)
  {
    if (names.empty())
      return "There are none.";
    const std::string nearest = nearest_name(wrong, names);
    std::string       text;
    if (!nearest.empty())
      text = "Did you mean '" + nearest + "'? ";
    return text + "There are: " + comma_separated(names) + ".";
  }



  History::History()
    : column_list({{"time", "s"}})
  {}



  unsigned int
  History::add_column(const std::string &name, const std::string &unit)
  {
    Assert(n_rows() == 0,
           dealii::ExcMessage("Columns have to be added before the rows."));
    // No two pairs or bodies have one name; monitors have whichever they got.
    if (has_column(name))
      throw InputError("Output / Monitor",
                       "two columns of the history would have the name \"" +
                         name +
                         "\". Give one of the monitors, or the body, another "
                         "name.");
    if ((name + unit).find_first_of(",[]\"\n") != std::string::npos)
      throw InputError(
        "Output",
        "a column of the history would have the name '" + name +
          "', with one of the characters , [ ] or \", which part "
          "columns and units. Give the monitor, or the boundary, "
          "another name.");
    column_list.push_back({name, unit});
    return column_list.size() - 1;
  }



  const std::vector<History::Column> &
  History::columns() const
  {
    return column_list;
  }



  std::vector<std::string>
  History::names() const
  {
    std::vector<std::string> result;
    for (const Column &column : column_list)
      result.push_back(column.name);
    return result;
  }



  bool
  History::has_column(const std::string &name) const
  {
    return std::any_of(column_list.begin(),
                       column_list.end(),
                       [&](const Column &column) {
                         return column.name == name;
                       });
  }



  unsigned int
  History::column_index(const std::string &name) const
  {
    for (unsigned int i = 0; i < column_list.size(); ++i)
      if (column_list[i].name == name)
        return i;
    throw InputError("There is no column '" + name + "' in the history. " +
                     list_of_names(name, names()));
  }



  void
  History::append_row(const std::vector<double> &row)
  {
    AssertDimension(row.size(), column_list.size());
    Assert(n_rows() == 0 || row[0] >= value(n_rows() - 1, 0),
           dealii::ExcMessage("The times of the history must not decrease."));
    data.insert(data.end(), row.begin(), row.end());
  }



  unsigned int
  History::n_rows() const
  {
    return data.size() / column_list.size();
  }



  double
  History::value(const unsigned int row, const unsigned int column) const
  {
    AssertIndexRange(row, n_rows());
    AssertIndexRange(column, column_list.size());
    return data[row * column_list.size() + column];
  }



  std::vector<double>
  History::values(const std::string &name) const
  {
    const unsigned int  column = column_index(name);
    std::vector<double> result(n_rows());
    for (unsigned int row = 0; row < result.size(); ++row)
      result[row] = value(row, column);
    return result;
  }



  std::vector<double>
  History::times() const
  {
    return values("time");
  }



  void
  History::truncate(const unsigned int n_rows)
  {
    AssertIndexRange(n_rows, this->n_rows() + 1);
    data.resize(n_rows * column_list.size());
  }
} // namespace Signorini
