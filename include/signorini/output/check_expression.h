#ifndef signorini_output_check_expression_h
#define signorini_output_check_expression_h

#include <signorini/input/formula.h>
#include <signorini/output/field_lookup.h>
#include <signorini/output/history.h>
#include <signorini/output/time_series.h>

#include <string>
#include <vector>

namespace Signorini
{
  /**
   * A number that is calculated from the results of a run: a formula of
   * muParser (numbers, constants, + - * / ^, sqrt, sin, ...) in which these
   * calls may stand. C is a column of the history, F a nodal field, N any such
   * formula.
   *
   *   max(C) min(C) max_abs(C) mean(C) final(C)   over the run, or
   *   max(C, N, N) ...                            over a window of time
   *   at(C, N)                     value at a time, linear between the rows
   *   first(C > N)  last(C > N)    time of the first, last row where it holds
   *   switches(C > N)              how often it changes its truth
   *   time(C > N, switch N)        when it does so for the N-th time
   *   field_max(F) field_min(F)    extreme of a nodal field at the end
   *   x_of_max(F) y_of_min(F) ...  where it is, in the reference position
   *   field(F, N, N)  field(F, N, N, N)    its value at the node nearest to
   *                                        this reference position
   *
   * Conditions take >, <, >= or <=. Times are in s, everything else in SI
   * units. The exact meaning of the functions of time is in time_series.h.
   * As max and min want a column, muParser's functions of these names are not
   * available.
   */
  class CheckExpression
  {
  public:
    /** @throws InputError on a mistake in the syntax. */
    explicit CheckExpression(const std::string &text,
                             const Constants   &constants = {
                                 {"pi", dealii::numbers::PI}});

    /** Whether it is a plain formula, the same for every run. */
    bool
    is_constant() const;

    /**
     * Check that all columns and fields exist.
     * @throws InputError that lists the names there are.
     */
    void
    check_names(const History &history, const FieldLookup &fields) const;

    /**
     * The number.
     * @throws NoValue when the run does not have one of the quantities.
     * @throws InputError as check_names().
     */
    double
    evaluate(const History &history, const FieldLookup &fields) const;

  private:
    struct Call
    {
      std::string function;

      /** Column or field. */
      std::string subject;

      /** Of functions of a condition; the threshold is arguments[0]. */
      Condition::Comparison comparison = Condition::Comparison::greater;

      std::vector<CheckExpression> arguments;
    };

    static Call
    parse_call(const std::string &function,
               const std::string &arguments,
               const Constants   &constants);

    static double
    evaluate_call(const Call        &call,
                  const History     &history,
                  const FieldLookup &fields);

    /** What is left for muParser: call number 2 is the variable call_2. */
    std::string       formula;
    std::vector<Call> calls;
  };
} // namespace Signorini

#endif
