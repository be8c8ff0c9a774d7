#ifndef signorini_output_pvd_file_h
#define signorini_output_pvd_file_h

#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include <string>
#include <vector>

namespace Signorini
{
  /**
   * A ParaView collection: which VTU file shows which part at which time.
   * Opened in ParaView it is one source with a block per part, named as the
   * part, and a time axis. The file is replaced as a whole at every change, so
   * that it can be read at any moment, also after a run that was stopped.
   */
  class PvdFile
  {
  public:
    struct Entry
    {
      /** Unit: s. */
      double time;

      /** Name of the body or contact pair. */
      std::string part;

      /** Name of the VTU file, relative to the folder of this file. */
      std::string vtu_file;

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int /*version*/)
      {
        archive &time &part &vtu_file;
      }
    };

    explicit PvdFile(const std::string &file_name);

    /**
     * Append entries and write the file.
     * @throws ComputationError when it cannot be written.
     */
    void
    add(const std::vector<Entry> &entries);

    /**
     * Writes the file as it stands, and removes the VTU files of its parts
     * whose number is not below @p n_outputs: those of a run that went on
     * after the checkpoint from which it is resumed.
     * @throws ComputationError as add().
     */
    void
    cut_back(const unsigned int n_outputs) const;

    /** For checkpoints through Boost.Serialization. */
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &entries &parts;
    }

  private:
    void
    write() const;

    const std::string  file_name;
    std::vector<Entry> entries;

    // The position of a name is the number of the part.
    std::vector<std::string> parts;
  };

  /**
   * Names of files for these names of parts: everything but letters, digits,
   * '.', '-' and '_' becomes '_'.
   * @throws InputError when two parts would share a file.
   */
  std::vector<std::string>
  file_names_of_parts(const std::vector<std::string> &parts);

  /** The name of an output: NAME_00012.vtu. */
  std::string
  vtu_file_name(const std::string &name, const unsigned int number);

  /**
   * Write a whole file.
   * @throws ComputationError with the reason when it cannot be written.
   */
  void
  write_result_file(const std::string &file_name, const std::string &content);

  /** The same in place of an old file, of which a reader never sees half. */
  void
  replace_result_file(const std::string &file_name, const std::string &content);
} // namespace Signorini

#endif
