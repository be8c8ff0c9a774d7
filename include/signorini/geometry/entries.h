#ifndef signorini_geometry_entries_h
#define signorini_geometry_entries_h

#include <deal.II/base/point.h>

#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace Signorini
{
  /**
   * Reads the entries of one subsection and checks their values. Every error
   * names the subsection, the entry and the text that was found.
   *
   * The patterns of the declarations only demand numbers; what the numbers
   * have to be is checked here, because the answer to a wrong one should be a
   * sentence.
   */
  class Entries
  {
  public:
    /** @p section may be empty: the entries of the current section itself. */
    Entries(const dealii::ParameterHandler &prm, std::string section);

    std::string
    text(const std::string &entry) const;

    /** A number. */
    double
    number(const std::string &entry) const;

    /** A number greater than zero. @throws InputError otherwise. */
    double
    positive(const std::string &entry) const;

    /** An integer not below @p minimum. @throws InputError otherwise. */
    unsigned int
    count(const std::string &entry, const unsigned int minimum) const;

    /** Comma-separated numbers. */
    std::vector<double>
    numbers(const std::string &entry) const;

    /**
     * Comma-separated integers, none below @p minimum, the numbers of cells in
     * each direction. @throws InputError also if their product is too large.
     */
    std::vector<unsigned int>
    counts(const std::string &entry, const unsigned int minimum) const;

    /** `dim` comma-separated coordinates in m. */
    template <int dim>
    dealii::Point<dim>
    point(const std::string &entry) const;

    /** Throws InputError: section, entry, what was found, and @p rule. */
    [[noreturn]] void
    refuse(const std::string &entry, const std::string &rule) const;

  private:
    const dealii::ParameterHandler &prm;
    const std::string               section;
  };
} // namespace Signorini

#endif
