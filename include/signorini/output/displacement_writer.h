#ifndef signorini_output_displacement_writer_h
#define signorini_output_displacement_writer_h

#include <signorini/linear_algebra/types.h>
#include <signorini/solid/displacement_files.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/mapping.h>

#include <boost/serialization/vector.hpp>

#include <map>
#include <string>
#include <vector>

namespace Signorini
{
  /** The displacement of one body, as views: the caller owns everything. */
  template <int dim>
  struct BodyDisplacement
  {
    std::string name;

    /** Of an FESystem of dim FE_Q, and the mapping of its body. */
    const dealii::DoFHandler<dim> *dof_handler = nullptr;
    const dealii::Mapping<dim>    *mapping     = nullptr;

    /** Unit: m. */
    const DofVector *displacement = nullptr;
  };

  /**
   * Keeps the displacements of a run for its submodels, in full precision: per
   * output a file BODY_00012.displacement for each body, a file
   * BODY_00012_mesh.displacement where its mesh is another one than before, and
   * the list of them, displacements.csv. DisplacementHistory reads them. The
   * list is replaced as a whole after the files it names, so that all can be
   * read at any moment, also after a run that was stopped.
   */
  template <int dim>
  class DisplacementWriter
  {
  public:
    /** @param folder An existing folder. */
    explicit DisplacementWriter(const std::string &folder);

    /**
     * Write one output of all bodies.
     * @param time Unit: s. After an output of the same time the new one counts.
     * @throws ComputationError when a file cannot be written; everything in
     * the list stays readable.
     * @throws InputError when the names of two bodies give the same file name.
     */
    void
    write(const std::vector<BodyDisplacement<dim>> &bodies, const double time);

    /**
     * After a checkpoint was read: writes the list as it stands, and removes
     * the files of its bodies that a run wrote after the checkpoint.
     * @throws ComputationError as write().
     */
    void
    cut_back() const;

    /** For checkpoints through Boost.Serialization. */
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &number &rows;
    }

  private:
    std::string
    path(const std::string &file) const;

    // The last mesh file of a body, and what is in it.
    struct MeshFile
    {
      std::string name;
      std::string content;
    };

    const std::string               folder;
    unsigned int                    number = 0; // of the next output
    std::vector<StoredDisplacement> rows;
    std::map<std::string, MeshFile> mesh_files; // of the bodies
  };
} // namespace Signorini

#endif
