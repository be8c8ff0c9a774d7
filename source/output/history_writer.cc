#include <signorini/input/as_text.h>
#include <signorini/input/input_error.h>
#include <signorini/output/history_writer.h>
#include <signorini/output/pvd_file.h>

#include <deal.II/base/exceptions.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

namespace Signorini
{
  HistoryWriter::HistoryWriter(const std::string &file_name,
                               const History     &history,
                               const double       flush_interval)
    : file_name(file_name)
    , flush_interval(std::chrono::duration_cast<Clock::duration>(
        std::chrono::duration<double>(flush_interval)))
    , last_flush(Clock::now())
  {
    add_head(history);
    add_rows(history);
    if (n_written_rows > 0)
      {
        replace_result_file(file_name, held_back);
        n_safe_bytes = held_back.size();
        held_back.clear();
      }
    file.open(file_name,
              n_written_rows > 0 ? std::ios::binary | std::ios::app :
                                   std::ios::binary | std::ios::out);
    if (!file)
      throw InputError("The history file '" + file_name +
                       "' cannot be created: " + std::strerror(errno) +
                       ". Choose another output folder.");
    flush();
  }



  void
  HistoryWriter::add_head(const History &history)
  {
    for (const History::Column &column : history.columns())
      {
        held_back += held_back.empty() ? "" : ",";
        held_back += column.name;
        if (!column.unit.empty())
          held_back += " [" + column.unit + "]";
      }
    held_back += "\n";
  }



  HistoryWriter::~HistoryWriter()
  {
    try
      {
        flush();
      }
    catch (const std::exception &)
      {
        // A destructor must not throw; whoever wants to know calls flush().
      }
  }



  void
  HistoryWriter::write_new_rows(const History &history)
  {
    Assert(history.n_rows() >= n_written_rows,
           dealii::ExcMessage("Rows that are in the file were taken back."));
    add_rows(history);
    if (Clock::now() - last_flush >= flush_interval)
      flush();
  }



  void
  HistoryWriter::add_rows(const History &history)
  {
    const unsigned int n_columns = history.columns().size();
    for (; n_written_rows < history.n_rows(); ++n_written_rows)
      for (unsigned int column = 0; column < n_columns; ++column)
        {
          held_back += shortest_exact(history.value(n_written_rows, column));
          held_back += column + 1 < n_columns ? ',' : '\n';
        }
  }



  void
  HistoryWriter::flush()
  {
    last_flush = Clock::now();
    if (held_back.empty())
      return;
    file.write(held_back.data(), held_back.size());
    file.flush();
    if (file)
      {
        n_safe_bytes += held_back.size();
        held_back.clear();
        return;
      }

    const std::string reason = std::strerror(errno);
    file.close();
    cut_to_whole_rows();
    held_back.clear();
    throw ComputationError("The history file '" + file_name +
                           "' cannot be written any more: " + reason +
                           ". Free some space on its disk or choose another "
                           "output folder, then repeat the run. The rows "
                           "written so far can be read.");
  }



  void
  HistoryWriter::cut_to_whole_rows()
  {
    // A device instead of a file cannot be cut, and need not be.
    std::error_code error;
    if (!std::filesystem::is_regular_file(file_name, error))
      return;
    const std::size_t n_bytes = std::filesystem::file_size(file_name, error);
    if (error || n_bytes < n_safe_bytes)
      return;
    const std::string written   = held_back.substr(0, n_bytes - n_safe_bytes);
    const std::size_t n_in_rows = written.rfind('\n') + 1; // 0 without any
    std::filesystem::resize_file(file_name, n_safe_bytes + n_in_rows, error);
  }
} // namespace Signorini
