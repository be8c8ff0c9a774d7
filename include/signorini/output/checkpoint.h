#ifndef signorini_output_checkpoint_h
#define signorini_output_checkpoint_h

#include <signorini/geometry/refinement_passes.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace Signorini
{
  /** An entry of the .prm and its value. */
  struct InputEntry
  {
    std::string path; // `Body beam / Material / Density'
    std::string value;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &path &value;
    }
  };

  /** A run at one time, as it is kept on disk. */
  struct Checkpoint
  {
    double                  time = 0.; // s
    unsigned int            step = 0;
    std::vector<InputEntry> input;
    unsigned int            geometry = 0; // checksum of meshes and outlines
    std::vector<RefinementPasses> passes; // adaptive ones, of each body
    std::string                   run;    // an archive of all the rest

    // While meshes are being found: an archive of what is known of them; there
    // is no run yet.
    std::string meshes = {};

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &time &step &input &geometry &passes &run &meshes;
    }
  };

  /**
   * To be raised whenever the content of a checkpoint changes, in this file or
   * in what it holds: State, History, StepMemory and the like.
   */
  constexpr unsigned int checkpoint_version = 5;

  /** A checkpoint that was read, and what was wrong with newer ones. */
  struct FoundCheckpoint
  {
    Checkpoint               checkpoint;
    std::vector<std::string> warnings;
  };

  /** When the newest checkpoint of a folder was written; nothing without. */
  std::optional<std::filesystem::file_time_type>
  checkpoint_time(const std::string &folder);

  /**
   * Writes a checkpoint into the folder of a run. The file has another name
   * until it is whole and on disk; then it takes the place of the last one,
   * which is kept as the previous one. So there is a whole one at any moment.
   * @throws ComputationError with the reason when it cannot be written; the
   * older ones stay.
   */
  void
  write_checkpoint(const std::string &folder, const Checkpoint &checkpoint);

  /**
   * Reads the last whole checkpoint of a folder.
   * @throws InputError if there is none, each one is damaged, or one is of
   * another version.
   */
  FoundCheckpoint
  read_checkpoint(const std::string &folder);

  /** Tells when a checkpoint is due: by steps, by the clock, or both. */
  class CheckpointClock
  {
  public:
    /** Zero: not by this. */
    CheckpointClock(const unsigned int steps, const double minutes);

    /** True if no checkpoint is ever due. */
    bool
    is_off() const;

    /** To be asked once after every step. */
    bool
    is_due();

  private:
    using Clock = std::chrono::steady_clock;

    const unsigned int    steps_;
    const Clock::duration interval_;
    unsigned int          n_steps_ = 0; // since the last one
    Clock::time_point     last_;
  };
} // namespace Signorini

#endif
