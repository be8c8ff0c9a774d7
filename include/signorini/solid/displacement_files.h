#ifndef signorini_solid_displacement_files_h
#define signorini_solid_displacement_files_h

#include <signorini/solid/nodal_mesh.h>

#include <boost/serialization/string.hpp>

#include <string>
#include <vector>

namespace Signorini
{
  /**
   * A row of displacements.csv: where the displacements of a body at one time
   * are. The index lies beside its files, and is written after them. Of rows
   * with the same time the last one counts.
   */
  struct StoredDisplacement
  {
    double      time; // s
    std::string body;

    /** Names of files in the same folder. */
    std::string mesh_file;
    std::string displacement_file;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &time &body &mesh_file &displacement_file;
    }
  };

  const std::string displacement_index = "displacements.csv";

  /** The text of displacements.csv. */
  std::string
  encode_index(const std::vector<StoredDisplacement> &rows);

  /**
   * Reads displacements.csv in a folder.
   * @throws InputError when it is not there or damaged.
   */
  std::vector<StoredDisplacement>
  read_index(const std::string &folder);

  /**
   * The content of a mesh file: a line of text,
   * `signorini mesh 1 dimension 2 degree 1 nodes 12 cells 6`, then in binary
   * (little endian) the coordinates (double, m) and the nodes of the cells
   * (32 bit).
   */
  template <int dim>
  std::string
  encode_mesh(const NodalMesh<dim> &mesh);

  /**
   * The content of a displacement file: a line of text,
   * `signorini displacement 1 dimension 2 nodes 12`, then in binary the
   * components at the nodes (double, m).
   */
  template <int dim>
  std::string
  encode_displacements(
    const std::vector<dealii::Tensor<1, dim>> &displacements);

  /** @throws InputError when it is missing, damaged, or of another dimension.
   */
  template <int dim>
  NodalMesh<dim>
  read_mesh(const std::string &file_name);

  /** @throws InputError as read_mesh(), also for another number of nodes. */
  template <int dim>
  std::vector<dealii::Tensor<1, dim>>
  read_displacements(const std::string &file_name, const unsigned int n_nodes);
} // namespace Signorini

#endif
