#ifndef signorini_input_space_time_function_h
#define signorini_input_space_time_function_h

#include <signorini/input/formula.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <string>
#include <vector>

namespace Signorini
{
  /** What the expressions of an entry may depend on. */
  enum class Dependence
  {
    none,
    time,
    space,
    space_and_time
  };

  /**
   * One or more expressions in x, y (, z) and t, or in some of them, with
   * muParser's syntax.
   */
  template <int dim>
  class SpaceTimeFunction
  {
  public:
    /**
     * @param text         expressions separated by semicolons
     * @param n_components how many there must be
     * @param entry        the path of the entry, for messages
     * @param dependence   the variables that have a meaning there
     * @throws InputError when the number or an expression is wrong.
     */
    SpaceTimeFunction(const std::string &text,
                      const unsigned int n_components,
                      const Constants   &constants,
                      const std::string &entry,
                      const Dependence   dependence);

    /**
     * @param time in s.
     * @throws InputError when the value is infinite or no number.
     */
    double
    value(const dealii::Point<dim> &point,
          const double              time,
          const unsigned int        component = 0) const;

    /** All components, for functions that have dim of them. */
    dealii::Tensor<1, dim>
    vector_value(const dealii::Point<dim> &point, const double time) const;

    /** False if t does not occur in any expression. */
    bool
    depends_on_time() const;

  private:
    Dependence           dependence_;
    std::vector<Formula> components_;
  };
} // namespace Signorini

#endif
