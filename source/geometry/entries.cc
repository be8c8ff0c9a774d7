#include <signorini/geometry/empty_mesh.h>
#include <signorini/geometry/entries.h>
#include <signorini/geometry/memory_estimate.h>
#include <signorini/input/input_error.h>
#include <signorini/input/instantiate.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <utility>

namespace Signorini
{
  using namespace dealii;

  Entries::Entries(const ParameterHandler &prm, std::string section)
    : prm(prm)
    , section(std::move(section))
  {}



  std::string
  Entries::text(const std::string &entry) const
  {
    return section.empty() ? prm.get(entry) : prm.get({section}, entry);
  }



  double
  Entries::number(const std::string &entry) const
  {
    return numbers(entry).front();
  }



  double
  Entries::positive(const std::string &entry) const
  {
    const double value = number(entry);
    if (!(value > 0.))
      refuse(entry, "must be greater than zero.");
    return value;
  }



  unsigned int
  Entries::count(const std::string &entry, const unsigned int minimum) const
  {
    return counts(entry, minimum).front();
  }



  std::vector<double>
  Entries::numbers(const std::string &entry) const
  {
    return Utilities::string_to_double(
      Utilities::split_string_list(text(entry), ','));
  }



  std::vector<unsigned int>
  Entries::counts(const std::string &entry, const unsigned int minimum) const
  {
    std::vector<unsigned int> result;
    double                    product = 1.;
    for (const double value : numbers(entry))
      {
        if (value < minimum)
          refuse(entry,
                 "must not be less than " + std::to_string(minimum) + ".");
        product *= std::max(value, 1.);
        if (product > maximal_n_cells)
          refuse(entry, "makes more than 20 million cells.");
        result.push_back(static_cast<unsigned int>(value));
      }
    try
      {
        require_memory(product, result.size() == 3 ? 3 : 2);
      }
    catch (const InputError &error)
      {
        refuse(entry, error.what());
      }
    return result;
  }



  template <int dim>
  Point<dim>
  Entries::point(const std::string &entry) const
  {
    const std::vector<double> coordinates = numbers(entry);
    AssertDimension(coordinates.size(), dim);
    Point<dim> result;
    for (unsigned int d = 0; d < dim; ++d)
      result[d] = coordinates[d];
    return result;
  }



  void
  Entries::refuse(const std::string &entry, const std::string &rule) const
  {
    throw InputError::of_value((section.empty() ? "" : section + " / ") + entry,
                               text(entry),
                               rule);
  }

#define INSTANTIATE(dim) \
  template Point<dim> Entries::point<dim>(const std::string &) const;
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
