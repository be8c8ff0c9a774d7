#ifndef signorini_variational_inequality_interface_error_h
#define signorini_variational_inequality_interface_error_h

#include <signorini/input/input_error.h>

#include <string>
#include <vector>

namespace Signorini
{
  /**
   * An interface problem that has no solution or was not solved. Knows the
   * contacts concerned, so that whoever knows their nodes can name them.
   */
  class InterfaceError : public ComputationError
  {
  public:
    /** Appends the numbers of the first few contacts to @p message, which
     * needs no full stop. */
    InterfaceError(const std::string               &message,
                   const std::vector<unsigned int> &contacts);

    const std::vector<unsigned int> &
    contacts() const
    {
      return contact_numbers;
    }

  private:
    std::vector<unsigned int> contact_numbers;
  };
} // namespace Signorini

#endif
