#ifndef signorini_space_time_function_h
#define signorini_space_time_function_h

#include <deal.II/base/function_parser.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <map>
#include <memory>
#include <string>

namespace Signorini
{
  /** Constants of the .prm that may be used in every expression. */
  using Constants = std::map<std::string, double>;

  /**
   * Reads `F = 1e3, h = 0.02`; pi is always there.
   * @throws InputError for a name without a value and the like.
   */
  Constants
  parse_constants(const std::string &text, const std::string &entry);

  /**
   * One or more expressions in x, y (, z) and t, with muParser's syntax.
   */
  template <int dim>
  class SpaceTimeFunction
  {
  public:
    /**
     * @param text         expressions separated by semicolons
     * @param n_components how many there must be
     * @param entry        the path of the entry, for messages
     * @throws InputError when the number or an expression is wrong.
     */
    SpaceTimeFunction(const std::string &text,
                      const unsigned int n_components,
                      const Constants   &constants,
                      const std::string &entry);

    /** @param time in s. */
    double
    value(const dealii::Point<dim> &point,
          const double              time,
          const unsigned int        component = 0) const;

    /** All components, for functions that have dim of them. */
    dealii::Tensor<1, dim>
    vector_value(const dealii::Point<dim> &point, const double time) const;

    /** False if t does not occur in any expression. */
    bool
    depends_on_time() const
    {
      return depends_on_time_;
    }

  private:
    std::unique_ptr<dealii::FunctionParser<dim>> function_;
    bool                                         depends_on_time_;
  };
} // namespace Signorini

#endif
