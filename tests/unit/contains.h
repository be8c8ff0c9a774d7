#ifndef signorini_tests_contains_h
#define signorini_tests_contains_h

#include <string>

inline bool
contains(const std::string &text, const std::string &part)
{
  return text.find(part) != std::string::npos;
}

#endif
