#ifndef signorini_tests_contains_h
#define signorini_tests_contains_h

#include <string>

namespace Signorini
{
  inline bool
  contains(const std::string &text, const std::string &part)
  {
    return text.find(part) != std::string::npos;
  }
} // namespace Signorini

#endif
