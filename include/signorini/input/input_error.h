#ifndef signorini_input_input_error_h
#define signorini_input_input_error_h

#include <stdexcept>
#include <string>

namespace Signorini
{
  /**
   * Something the user can mend: a wrong entry, a missing file, a boundary
   * that does not exist. The message says where, what was found, what is
   * allowed, and the remedy, and is printed as it stands: `entry: text'.
   */
  class InputError : public std::runtime_error
  {
  public:
    /** @param text of something that is about no entry */
    explicit InputError(const std::string &text);

    /**
     * @param entry path of the entry or section, such as "Body beam / Material
     *   / Law"; empty where it is not known yet
     * @param text  what is wrong with it
     */
    InputError(const std::string &entry, const std::string &text);

    /** Whose message shows the value, too: `entry = value: text'. */
    static InputError
    of_value(const std::string &entry,
             const std::string &value,
             const std::string &text);

    /** The same of an entry of this section: `section / entry: text'. */
    InputError
    in_section(const std::string &section) const;

    const std::string &
    entry() const
    {
      return entry_;
    }

    /** The message without the entry and its value. */
    const std::string &
    text() const
    {
      return text_;
    }

  private:
    InputError(const std::string &entry,
               const std::string &text,
               const std::string &message);

    std::string entry_;
    std::string text_;
  };

  /**
   * The computation itself failed: a step that does not converge, a matrix
   * that is not positive definite, a disk that is full. What was written so
   * far stays readable.
   */
  class ComputationError : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };

  /**
   * The run ended, but its results miss what the .prm expects of them. The
   * message lists every check that failed with the value found.
   */
  class ExpectedResultsMissed : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };
} // namespace Signorini

#endif
