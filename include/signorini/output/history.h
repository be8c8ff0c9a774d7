#ifndef signorini_output_history_h
#define signorini_output_history_h

#include <boost/serialization/vector.hpp>

#include <string>
#include <vector>

namespace Signorini
{
  /**
   * Quantities over the course of a run: one row of numbers per accepted step,
   * in named columns with units. The first column is always "time" in s. A
   * value: it can be copied (checkpoints) and cut back.
   */
  class History
  {
  public:
    struct Column
    {
      std::string name;

      /** Empty for a number without unit. */
      std::string unit;
    };

    /** One column, the time, and no rows. */
    History();

    /**
     * Append a column and return its index. Possible only before the first
     * row.
     * @throws InputError unless the name is new and free of commas, brackets
     * and quotes, which would break the table on disk.
     */
    unsigned int
    add_column(const std::string &name, const std::string &unit);

    const std::vector<Column> &
    columns() const;

    /** The names alone, the time first. */
    std::vector<std::string>
    names() const;

    bool
    has_column(const std::string &name) const;

    /**
     * @throws InputError when there is none; the message lists the names that
     * exist, the nearest one first.
     */
    unsigned int
    column_index(const std::string &name) const;

    /** Append a row, one value per column. Times must not decrease. */
    void
    append_row(const std::vector<double> &row);

    unsigned int
    n_rows() const;

    double
    value(const unsigned int row, const unsigned int column) const;

    /** All values of one column. @throws InputError as column_index(). */
    std::vector<double>
    values(const std::string &name) const;

    /** The first column. Unit: s. */
    std::vector<double>
    times() const;

    /** Forget all rows but the first @p n_rows. */
    void
    truncate(const unsigned int n_rows);

    /** For checkpoints through Boost.Serialization. */
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int version);

  private:
    std::vector<Column> column_list;

    // Row by row.
    std::vector<double> data;
  };

  /**
   * The sentence that helps with a name that does not exist: the nearest name
   * as a guess, if there is one, then all @p names.
   */
  std::string
  list_of_names(const std::string              &wrong,
                const std::vector<std::string> &names);



  template <class Archive>
  void
  History::serialize(Archive &archive, const unsigned int /*version*/)
  {
    // The columns follow from the parameter file; only the rows are state.
    archive &data;
  }
} // namespace Signorini

#endif
