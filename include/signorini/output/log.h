#ifndef signorini_output_log_h
#define signorini_output_log_h

#include <chrono>
#include <fstream>
#include <iosfwd>
#include <string>

namespace Signorini
{
  /**
   * What the program says while it runs, on the console and in a log file.
   *
   *  - line():     an ordinary line, in both, at once on disk;
   *  - detail():   a line for the log file alone;
   *  - progress(): a line about the state of the run. On a terminal it
   *    overwrites itself, otherwise and in the file it is an ordinary line
   *    every few seconds. Calls in between cost one reading of the clock.
   *
   * A log file that can no longer be written to does not stop the run: this is
   * said once on the console.
   */
  class Log
  {
  public:
    struct Settings
    {
      /** Overwrite the progress line in place. */
      bool is_terminal = false;

      /** Least time between two states of the line on a terminal. Unit: s. */
      double refresh_interval = 0.1;

      /** Least time between two progress lines elsewhere. Unit: s. */
      double line_interval = 5.;

      /** Go on at the end of a file that exists. */
      bool append = false;
    };

    /** Whether the standard output is a terminal, and the default times. */
    static Settings
    default_settings();

    /**
     * Write to standard output and to the file @p file_name, which is created
     * anew; with an empty name to standard output alone.
     * @throws InputError when the file cannot be created.
     */
    explicit Log(const std::string &file_name);

    /** The same with other settings. */
    Log(const std::string &file_name, const Settings &settings);

    /** The same for another console, which has to outlive this object. */
    Log(const std::string &file_name,
        std::ostream      &console,
        const Settings    &settings);

    /** Ends a progress line that still stands on the terminal. */
    ~Log();

    Log(const Log &) = delete;
    Log &
    operator=(const Log &) = delete;

    void
    line(const std::string &text);

    void
    detail(const std::string &text);

    /** Whether progress() would write anything now; saves the formatting. */
    bool
    progress_is_due() const;

    /** Show @p text as the state of the run, if it is time to. */
    void
    progress(const std::string &text);

    /** Show @p text as the last state of the run, an ordinary line. */
    void
    final_progress(const std::string &text);

  private:
    using Clock = std::chrono::steady_clock;

    void
    write_to_file(const std::string &text);

    void
    clear_progress();

    const Settings    settings;
    std::ostream     &console;
    const std::string file_name;
    std::ofstream     file;
    bool              file_works;
    bool              progress_stands = false;
    Clock::time_point next_refresh;
    Clock::time_point next_line;
  };
} // namespace Signorini

#endif
