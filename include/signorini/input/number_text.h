#ifndef signorini_input_number_text_h
#define signorini_input_number_text_h

#include <signorini/input/formula.h>

#include <deal.II/base/patterns.h>

#include <memory>
#include <string>
#include <vector>

namespace Signorini
{
  /**
   * Pattern of a text of numbers for which deal.II has none: points, tables,
   * lists that may be empty. It allows any text, since who reads the entry
   * knows how many numbers there have to be. What it tells is where numbers
   * stand, so that evaluate_numbers() can find them: between , ; : and |, and
   * between the words given here. A text `file NAME' has none.
   */
  class NumberText : public dealii::Patterns::PatternBase
  {
  public:
    /** @param words that stand among the numbers, as in `arc 1, 0 to 2, 1' */
    explicit NumberText(const std::vector<std::string> &words = {});

    /** Of `name : number : number ; ...'. */
    static NumberText
    behind_names();

    bool
    match(const std::string &text) const override;

    std::string
    description(const OutputStyle style = Machine) const override;

    std::unique_ptr<PatternBase>
    clone() const override;

  private:
    std::string description_;
  };

  /**
   * The value of an entry with a number in place of each expression in
   * constants, `0, h/2' as `0, 0.01'. Numbers stay as they are written, and
   * expressions become the shortest text that gives the same number. Where a
   * pattern wants whole numbers, a result within 1e-9 (relative) of one is
   * meant to be it. What parts numbers (, ; : |) may stand within parentheses.
   *
   * @param pattern machine description of the pattern of the entry: Double,
   *   Integer, a list of these, or NumberText; other entries have no numbers
   * @throws InputError that tells what is wrong with an expression, but not
   *   in which entry.
   */
  std::string
  evaluate_numbers(const std::string &value,
                   const std::string &pattern,
                   const Constants   &constants);
} // namespace Signorini

#endif
