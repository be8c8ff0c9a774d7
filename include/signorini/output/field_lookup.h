#ifndef signorini_output_field_lookup_h
#define signorini_output_field_lookup_h

#include <deal.II/base/exceptions.h>
#include <deal.II/base/point.h>

#include <string>
#include <vector>

namespace Signorini
{
  /** A scalar field by its values at nodes. In 2-D the z of the points is 0. */
  struct NodalField
  {
    std::vector<dealii::Point<3>> points;
    std::vector<double>           values;
  };

  /**
   * Fields by name, such as "beam.von_mises": what a check of the final fields
   * needs to know of the bodies.
   */
  class FieldLookup
  {
  public:
    virtual ~FieldLookup() = default;

    /** All names there are; known before the run. */
    virtual std::vector<std::string>
    names() const = 0;

    /** The field of this name, one of names(), as it is now. */
    virtual NodalField
    field(const std::string &name) const = 0;
  };

  /** A lookup without fields, for runs and tests that have none. */
  class NoFields : public FieldLookup
  {
  public:
    std::vector<std::string>
    names() const override
    {
      return {};
    }

    NodalField
    field(const std::string &name) const override
    {
      (void)name;
      Assert(false, dealii::ExcMessage("There is no field " + name));
      return {};
    }
  };
} // namespace Signorini

#endif
