#ifndef signorini_output_expected_results_h
#define signorini_output_expected_results_h

#include <signorini/output/check_expression.h>

#include <string>
#include <vector>

namespace Signorini
{
  /** What became of one check. */
  struct CheckResult
  {
    /** The check as the user wrote it, with name and source. */
    std::string text;
    bool        passed = false;

    /** The two sides, and the largest distance allowed; NaN without. */
    double found;
    double expected;
    double tolerance;

    /** Why there is no number to compare, or empty. */
    std::string reason;
  };

  /**
   * Checks of the results of a run, written in the parameter file and
   * separated by '|':
   *
   *   no penetration: max(floor.penetration) = 0 +- 1e-12
   *
   *   deflection: max_abs(tip.displacement_y) = F*L^3/(3*E*I) +- 0.5 % [theory]
   *
   *   max(floor.pressure) < 300e6
   *
   * In front may stand the name of a check, behind it in brackets where the
   * number comes from; both are for the report. Both sides are a
   * CheckExpression. An equation needs a tolerance: absolute, or in % of the
   * absolute value of the right side. The relations <, <=, > and >= have none.
   * A side that is not finite, or for which the run has no value, is a miss.
   */
  class ExpectedResults
  {
  public:
    /**
     * @throws InputError on a mistake in the syntax, with the check it is in,
     *   and for two checks of one name.
     */
    explicit ExpectedResults(const std::string &checks,
                             const Constants   &constants = {
                                 {"pi", dealii::numbers::PI}});

    /**
     * Check before the run that all names exist; @p history needs columns, but
     * no rows.
     * @throws InputError with the check and the names there are.
     */
    void
    check_names(const History &history, const FieldLookup &fields) const;

    /** Compare the results of a finished run. Throws as check_names(). */
    std::vector<CheckResult>
    evaluate(const History &history, const FieldLookup &fields) const;

    unsigned int
    n_checks() const;

  private:
    enum class Relation
    {
      equal,
      less,
      less_or_equal,
      greater,
      greater_or_equal
    };

    struct Check
    {
      std::string     text;
      CheckExpression left;
      Relation        relation;
      CheckExpression right;

      /** Of equations; in parts of the right side when relative. */
      double tolerance;
      bool   relative;
    };

    static Check
    parse(const std::string &text,
          const std::string &condition,
          const Constants   &constants);

    static CheckResult
    evaluate(const Check       &check,
             const History     &history,
             const FieldLookup &fields);

    std::vector<Check> checks;
  };

  bool
  all_passed(const std::vector<CheckResult> &results);

  /**
   * One line per check: passed or missed, the check, and the two numbers, for
   * equations with their distance and the tolerance.
   */
  std::string
  report(const std::vector<CheckResult> &results);
} // namespace Signorini

#endif
