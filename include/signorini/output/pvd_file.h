#ifndef signorini_output_pvd_file_h
#define signorini_output_pvd_file_h

#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include <functional>
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

    /** The content of the VTU file of a part, and of this output. */
    using VtuText = std::function<std::string(const unsigned int part,
                                              const unsigned int number)>;

    /**
     * Write a VTU file for each part, and list them.
     * @throws ComputationError when a file cannot be written; everything
     * listed before stays readable.
     * @throws InputError when the names of two parts give the same file name.
     */
    void
    write(const std::vector<std::string> &parts,
          const double                    time,
          const VtuText                  &vtu_text);

    unsigned int
    n_outputs() const
    {
      return number;
    }

    /**
     * After a checkpoint was read: writes the file as it stands, and removes
     * the VTU files of its parts that a run wrote after the checkpoint.
     * @throws ComputationError as write().
     */
    void
    cut_back() const;

    /** For checkpoints through Boost.Serialization. */
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &number &entries &known_parts;
    }

  private:
    void
    write_list() const;

    const std::string  file_name;
    unsigned int       number = 0; // of the next output
    std::vector<Entry> entries;

    // The position of a name is the number of the part.
    std::vector<std::string> known_parts;
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
