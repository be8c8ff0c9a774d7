#ifndef signorini_output_history_writer_h
#define signorini_output_history_writer_h

#include <signorini/output/history.h>

#include <chrono>
#include <fstream>
#include <string>

namespace Signorini
{
  /**
   * Streams the rows of a History to a file of comma-separated values. The
   * first line holds the names with units as `name [unit]`; numbers are
   * written with the fewest digits that give the same number back. In gnuplot:
   *
   *   set datafile separator comma
   *   set key autotitle columnhead
   *   plot 'history.csv' using 1:2
   *
   * Rows reach the disk in whole lines, so that a run that is killed leaves a
   * file that can be read.
   */
  class HistoryWriter
  {
  public:
    /**
     * Create the file and write its first line. A history that has rows
     * already, because a run is resumed, takes the place of the old file as a
     * whole, so that nothing is lost if that fails.
     * @param flush_interval Longest time that rows are held back; 0 writes
     * every row at once. Unit: s.
     * @throws InputError when the file cannot be created.
     * @throws ComputationError as write_new_rows().
     */
    HistoryWriter(const std::string &file_name,
                  const History     &history,
                  const double       flush_interval = 0.5);

    /** Writes what is held back, but tells nobody when that fails. */
    ~HistoryWriter();

    /**
     * Write the rows that came since the last call. Rows that are in the file
     * cannot be taken back: add a step to the history when it is accepted.
     * @throws ComputationError when the disk is full or gone. The file then
     * ends with the last whole row that fitted.
     */
    void
    write_new_rows(const History &history);

    /** Put what is held back on disk now. Throws as write_new_rows(). */
    void
    flush();

  private:
    // The first line, and all rows there are.
    void
    add_head(const History &history);

    void
    add_rows(const History &history);

    using Clock = std::chrono::steady_clock;

    // Half a row at the end would make the table unreadable.
    void
    cut_to_whole_rows();

    const std::string     file_name;
    const Clock::duration flush_interval;
    std::ofstream         file;
    std::string           held_back;
    unsigned int          n_written_rows = 0;
    std::size_t           n_safe_bytes   = 0;
    Clock::time_point     last_flush;
  };
} // namespace Signorini

#endif
