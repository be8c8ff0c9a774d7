#ifndef signorini_input_named_errors_h
#define signorini_input_named_errors_h

#include <signorini/input/input_error.h>

#include <string>

namespace Signorini
{
  // What an action returns. Who is asked does not know for which entry, and
  // its InputError learns it here.

  /** The error is about this entry, such as "Expected results / Checks". */
  template <typename Action>
  auto
  with_entry(const std::string &entry, const Action &action)
  {
    try
      {
        return action();
      }
    catch (const InputError &error)
      {
        throw InputError(entry, error.what());
      }
  }



  /** Its entry is one of this section, such as "Body beam". */
  template <typename Action>
  auto
  with_section(const std::string &section, const Action &action)
  {
    try
      {
        return action();
      }
    catch (const InputError &error)
      {
        throw error.in_section(section);
      }
  }



  /** The message, which is about no entry, begins with this text. */
  template <typename Action>
  auto
  with_prefix(const std::string &prefix, const Action &action)
  {
    try
      {
        return action();
      }
    catch (const InputError &error)
      {
        throw InputError(prefix + error.what());
      }
  }
} // namespace Signorini

#endif
