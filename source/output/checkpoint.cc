#include <signorini/input/input_error.h>
#include <signorini/input/regular_file.h>
#include <signorini/output/checkpoint.h>
#include <signorini/output/run_folder.h>
#include <signorini/output/whole_file.h>
#include <signorini/version.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/crc.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include <array>
#include <fstream>
#include <sstream>

namespace Signorini
{
  namespace
  {
    namespace fs = std::filesystem;

    // From the newest to the oldest. The first one takes the place of the
    // second in two renamings, between which there is no second one.
    constexpr const char *new_name      = "new.checkpoint";
    constexpr const char *last_name     = "last.checkpoint";
    constexpr const char *previous_name = "previous.checkpoint";

    constexpr const char *magic = "Signorini checkpoint";

    /** A file that is cut short or was changed. */
    class Damaged : public std::runtime_error
    {
    public:
      using std::runtime_error::runtime_error;
    };

    unsigned int
    checksum(const std::string &text)
    {
      boost::crc_32_type crc;
      crc.process_bytes(text.data(), text.size());
      return crc.checksum();
    }

    std::string
    file_content(const Checkpoint &checkpoint)
    {
      std::ostringstream              stream;
      boost::archive::binary_oarchive archive(stream);
      archive << checkpoint;
      const std::string data = stream.str();

      std::ostringstream header;
      header << magic << ", version " << checkpoint_version
             << ", written by Signorini " << SIGNORINI_VERSION << "\nbytes "
             << data.size() << " checksum " << checksum(data) << '\n';
      return header.str() + data;
    }

    std::string
    content_of(const std::string &path)
    {
      require_regular_file(path, largest_data);
      std::ifstream      file(path, std::ios::binary);
      std::ostringstream text;
      text << file.rdbuf();
      if (!file)
        throw Damaged("it cannot be read");
      return text.str();
    }

    // The text behind `word' in a line.
    std::string
    after(const std::string &word, const std::string &line)
    {
      const std::size_t position = line.find(word);
      return position == std::string::npos ?
               "" :
               line.substr(position + word.size());
    }

    void
    refuse_other_version(const std::string &path, const std::string &header)
    {
      std::istringstream text(after(", version ", header));
      unsigned int       version = 0;
      text >> version;
      if (version != checkpoint_version)
        throw InputError("The checkpoint '" + path + "' is of version " +
                         std::to_string(version) + " (" +
                         after(", ", after(", version ", header)) +
                         "); this program, Signorini " SIGNORINI_VERSION
                         ", reads version " +
                         std::to_string(checkpoint_version) +
                         ". Go on with the program that wrote it, or start "
                         "the run anew without --resume.");
    }

    Checkpoint
    read_file(const std::string &path)
    {
      const std::string content    = content_of(path);
      const std::size_t first_end  = content.find('\n');
      const std::size_t second_end = content.find('\n', first_end + 1);
      const std::string begin      = magic;
      if (content.substr(0, begin.size()) != begin.substr(0, content.size()))
        throw Damaged("it does not begin like a checkpoint");
      if (second_end == std::string::npos)
        throw Damaged("it is cut short");
      refuse_other_version(path, content.substr(0, first_end));
      std::istringstream sizes(
        content.substr(first_end + 1, second_end - first_end));
      std::string       word;
      std::size_t       n_bytes = 0;
      unsigned int      crc     = 0;
      const std::string data    = content.substr(second_end + 1);
      sizes >> word >> n_bytes >> word >> crc;
      if (data.size() < n_bytes)
        throw Damaged("it is cut short");
      if (!sizes || data.size() > n_bytes || checksum(data) != crc)
        throw Damaged("it was changed after it was written");

      std::istringstream              stream(data);
      boost::archive::binary_iarchive archive(stream);
      Checkpoint                      checkpoint;
      try
        {
          archive >> checkpoint;
        }
      catch (const std::exception &)
        {
          throw Damaged("its content does not fit this program");
        }
      return checkpoint;
    }
  } // namespace



  std::optional<fs::file_time_type>
  checkpoint_time(const std::string &folder)
  {
    std::optional<fs::file_time_type> newest;
    for (const char *const name : {new_name, last_name, previous_name})
      {
        std::error_code error;
        const auto time = fs::last_write_time(fs::path(folder) / name, error);
        if (!error && (!newest || time > *newest))
          newest = time;
      }
    return newest;
  }



  void
  write_checkpoint(const std::string &folder, const Checkpoint &checkpoint)
  {
    const fs::path    path     = folder;
    const std::string new_file = (path / new_name).string();
    try
      {
        for (const char *const name : {new_name, last_name, previous_name})
          result_file((path / name).string());
        write_to_disk(new_file, file_content(checkpoint));
        if (fs::exists(path / last_name))
          fs::rename(path / last_name, path / previous_name);
        fs::rename(new_file, path / last_name);
      }
    catch (const std::system_error &error)
      {
        std::error_code ignored;
        fs::remove(new_file, ignored);
        throw ComputationError(
          "The checkpoint '" + (path / last_name).string() +
          "' cannot be written: " + error.code().message() + ".");
      }
  }



  FoundCheckpoint
  read_checkpoint(const std::string &folder)
  {
    FoundCheckpoint found;
    for (const char *const name : {last_name, new_name, previous_name})
      {
        const std::string path = (fs::path(folder) / name).string();
        if (!fs::exists(path))
          continue;
        try
          {
            found.checkpoint = read_file(path);
            return found;
          }
        catch (const Damaged &error)
          {
            found.warnings.push_back("The checkpoint '" + path +
                                     "' is damaged: " + error.what() + ".");
          }
      }
    if (found.warnings.empty())
      throw InputError("There is no checkpoint in '" + folder +
                       "'. Start the run anew without --resume; Output / "
                       "Minutes between checkpoints tells how often one is "
                       "written.");
    std::string text;
    for (const std::string &warning : found.warnings)
      text += warning + " ";
    throw InputError(text + "There is no other one. Start the run anew "
                            "without --resume.");
  }



  CheckpointClock::CheckpointClock(const unsigned int steps,
                                   const double       minutes)
    : steps_(steps)
    , interval_(std::chrono::duration_cast<Clock::duration>(
        std::chrono::duration<double>(60. * minutes)))
    , last_(Clock::now())
  {}



  bool
  CheckpointClock::is_off() const
  {
    return steps_ == 0 && interval_ == Clock::duration::zero();
  }



  bool
  CheckpointClock::is_due()
  {
    ++n_steps_;
    const bool by_steps = steps_ > 0 && n_steps_ >= steps_;
    const bool by_clock =
      interval_ > Clock::duration::zero() && Clock::now() - last_ >= interval_;
    if (!by_steps && !by_clock)
      return false;
    n_steps_ = 0;
    last_    = Clock::now();
    return true;
  }
} // namespace Signorini
