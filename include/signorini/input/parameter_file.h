#ifndef signorini_input_parameter_file_h
#define signorini_input_parameter_file_h

#include <signorini/input/formula.h>
#include <signorini/input/parameter_statements.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace Signorini
{
  /**
   * A .prm file as a list of statements that know where they stand. It is
   * read once; names it contains (the bodies) may decide what is declared
   * before its entries are applied.
   *
   * A path names an entry by its sections: "Body beam/Material/Law". Where an
   * entry is set more than once the last statement counts, so that a short
   * file can include a long one and change some of it.
   */
  class ParameterFile
  {
  public:
    /** @throws InputError, see read_parameter_statements(). */
    static ParameterFile
    read(const std::string &path);

    /**
     * Set one entry on top of the file.
     * @param assignment "Section/Sub/Entry=value"; the path ends at the first
     * "=", and a section cannot have "/" in its name.
     * @throws InputError when the assignment has no "=" or an empty name.
     */
    void
    override_entry(const std::string &assignment);

    /** The value of an entry as it stands, or the default. */
    std::string
    get(const std::string &path, const std::string &default_value) const;

    /**
     * Those of the entry `Constants', which any number of the file may use.
     * @throws InputError with the place.
     */
    Constants
    constants() const;

    /**
     * Set every entry of the handler, in which everything is declared, with
     * its numbers evaluated: see evaluate_numbers().
     * @throws InputError as constants(), or one that names all sections and
     * entries that are not declared and all values that do not match their
     * pattern, each with its place, what is allowed and the nearest right name,
     * one per line.
     */
    void
    apply(dealii::ParameterHandler &prm) const;

    /**
     * Where an entry is set for the last time, or a section opened:
     * "prm/beam.prm:12", "--set", or "default" for what is nowhere mentioned.
     */
    std::string
    where(const std::string &path) const;

    /** The last statement of each entry, in the order of the sections. */
    std::vector<ParameterStatement>
    assignments() const;

    /** The path the file was read from. */
    const std::string &
    path() const;

    /** The folder of the file, "." for the current one. */
    std::string
    directory() const;

  private:
    std::string                     file_path;
    std::vector<ParameterStatement> statements;
  };
} // namespace Signorini

#endif
