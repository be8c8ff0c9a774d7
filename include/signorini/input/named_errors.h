#ifndef signorini_input_named_errors_h
#define signorini_input_named_errors_h

#include <signorini/input/input_error.h>

#include <string>

namespace Signorini
{
  /**
   * What an action returns. Its InputError gets a path in front, such as
   * `Body beam / ' or `Expected results / Checks: ', since who is asked does
   * not know for which entry.
   */
  template <typename Action>
  auto
  with_path(const std::string &path, const Action &action)
  {
    try
      {
        return action();
      }
    catch (const InputError &error)
      {
        throw InputError(path + error.what());
      }
  }
} // namespace Signorini

#endif
