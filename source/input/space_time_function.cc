#include <signorini/input/input_error.h>
#include <signorini/input/instantiate.h>
#include <signorini/input/named_list.h>
#include <signorini/input/space_time_function.h>

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    std::vector<std::string>
    variables(const Dependence dependence)
    {
      std::vector<std::string> names;
      if (dependence == Dependence::space ||
          dependence == Dependence::space_and_time)
        for (unsigned int d = 0; d < dim; ++d)
          names.push_back(component_name(d));
      if (dependence == Dependence::time ||
          dependence == Dependence::space_and_time)
        names.push_back("t");
      return names;
    }

    template <int dim>
    std::vector<double>
    values(const Dependence  dependence,
           const Point<dim> &point,
           const double      time)
    {
      std::vector<double> values;
      if (dependence == Dependence::space ||
          dependence == Dependence::space_and_time)
        for (unsigned int d = 0; d < dim; ++d)
          values.push_back(point[d]);
      if (dependence == Dependence::time ||
          dependence == Dependence::space_and_time)
        values.push_back(time);
      return values;
    }
  } // namespace



  template <int dim>
  SpaceTimeFunction<dim>::SpaceTimeFunction(const std::string &text,
                                            const unsigned int n_components,
                                            const Constants   &constants,
                                            const std::string &entry,
                                            const Dependence   dependence)
    : dependence_(dependence)
  {
    const auto expressions = split_list(text, ';');
    if (expressions.size() != n_components)
      throw InputError(entry,
                       "found " + std::to_string(expressions.size()) +
                         " expression(s) in \"" + text + "\", expected " +
                         std::to_string(n_components) +
                         ", separated by semicolons.");
    for (const std::string &expression : expressions)
      components_.emplace_back(expression,
                               variables<dim>(dependence),
                               constants,
                               entry);
  }



  template <int dim>
  double
  SpaceTimeFunction<dim>::value(const Point<dim>  &point,
                                const double       time,
                                const unsigned int component) const
  {
    return components_[component].value(values(dependence_, point, time));
  }



  template <int dim>
  Tensor<1, dim>
  SpaceTimeFunction<dim>::vector_value(const Point<dim> &point,
                                       const double      time) const
  {
    Tensor<1, dim> result;
    for (unsigned int c = 0; c < dim; ++c)
      result[c] = value(point, time, c);
    return result;
  }



  template <int dim>
  bool
  SpaceTimeFunction<dim>::depends_on_time() const
  {
    return std::any_of(components_.begin(),
                       components_.end(),
                       [](const Formula &formula) {
                         return formula.depends_on("t");
                       });
  }



#define INSTANTIATE(dim) template class SpaceTimeFunction<dim>;
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
