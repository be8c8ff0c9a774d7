#ifndef signorini_input_silenced_errors_h
#define signorini_input_silenced_errors_h

#include <iostream>
#include <sstream>

namespace Signorini
{
  /**
   * While such an object lives, nothing that goes to std::cerr is printed.
   * For deal.II's FunctionParser, which prints five lines about a wrong
   * expression before it throws an exception that says the same.
   */
  class SilencedErrors
  {
  public:
    SilencedErrors()
      : original(std::cerr.rdbuf(dropped.rdbuf()))
    {}

    ~SilencedErrors()
    {
      std::cerr.rdbuf(original);
    }

    SilencedErrors(const SilencedErrors &) = delete;
    SilencedErrors &
    operator=(const SilencedErrors &) = delete;

  private:
    std::ostringstream dropped;
    std::streambuf    *original;
  };
} // namespace Signorini

#endif
