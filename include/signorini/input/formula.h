#ifndef signorini_input_formula_h
#define signorini_input_formula_h

#include <deal.II/base/function_parser.h>
#include <deal.II/base/numbers.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace Signorini
{
  /** Constants of the .prm, which every number and expression may use. */
  using Constants = std::map<std::string, double>;

  /** The one that is always there. */
  inline Constants
  only_pi()
  {
    return {{"pi", dealii::numbers::PI}};
  }

  /**
   * Reads `h = 0.02, b = 2*h': a number may be an expression in the constants
   * before it. pi is always there.
   * @throws InputError for a name that no expression could contain, that of a
   *   variable or a function, and for a name without a number.
   */
  Constants
  parse_constants(const std::string &text, const std::string &entry);

  /**
   * One expression of the .prm in named variables, with muParser's operators
   * and functions. Whoever evaluates it gets a finite number or an InputError
   * that tells where the expression has none.
   */
  class Formula
  {
  public:
    /** What expressions in space and time may depend on, at most. */
    static const std::vector<std::string> space_and_time;

    /**
     * @param text      the expression
     * @param variables their names, at most four
     * @param entry     the path of the entry, for messages
     * @throws InputError when the expression cannot be read, or has a name
     *   that is neither of a variable, a constant, nor a function.
     */
    Formula(const std::string              &text,
            const std::vector<std::string> &variables,
            const Constants                &constants,
            const std::string              &entry);

    /**
     * @param values of the variables, in their order
     * @throws InputError when the result is infinite or no number.
     */
    double
    value(const std::vector<double> &values) const;

    /** Whether the variable occurs in the expression. */
    bool
    depends_on(const std::string &variable) const;

  private:
    void
    check_names(const Constants &constants) const;

    [[noreturn]] void
    throw_no_number(const std::vector<double> &values,
                    const double               result) const;

    std::string                                text_;
    std::vector<std::string>                   variables_;
    std::string                                entry_;
    std::vector<std::string>                   names_; // that occur in it
    std::shared_ptr<dealii::FunctionParser<3>> parser_;
  };
} // namespace Signorini

#endif
