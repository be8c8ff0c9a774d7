#ifndef signorini_output_surface_writer_h
#define signorini_output_surface_writer_h

#include <signorini/output/pvd_file.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <string>
#include <utility>
#include <vector>

namespace Signorini
{
  /**
   * A surface with fields at its nodes: the contactor side of a contact pair
   * with gap, pressure, traction, status and normal, or a rigid surface
   * without any.
   */
  template <int dim>
  struct SurfaceData
  {
    std::string name;

    /** Unit: m. */
    std::vector<dealii::Point<dim>> nodes;

    /**
     * The nodes of each face: 2 of a line, 4 of a quadrilateral in deal.II's
     * lexicographic order.
     */
    std::vector<std::vector<unsigned int>> faces;

    /** Name and one value per node. */
    std::vector<std::pair<std::string, std::vector<double>>> scalar_fields;
    std::vector<std::pair<std::string, std::vector<dealii::Tensor<1, dim>>>>
      vector_fields;
  };

  /**
   * Writes surfaces for ParaView: per output one compressed binary file
   * NAME_00012.vtu for each surface, and one contact.pvd that shows all of
   * them, as blocks named after them, over time. They are a collection of
   * their own beside results.pvd, because their fields and their dimension are
   * not those of the bodies. Single precision, as the fields of the bodies.
   */
  template <int dim>
  class SurfaceWriter
  {
  public:
    /** @param folder An existing folder. */
    explicit SurfaceWriter(const std::string &folder);

    /**
     * Write one output of all surfaces; each needs at least one face.
     * @param time Unit: s.
     * @throws ComputationError when a file cannot be written; everything
     * listed in contact.pvd stays readable.
     * @throws InputError when two names give the same file name.
     */
    void
    write(const std::vector<SurfaceData<dim>> &surfaces, const double time);

    /** The files written so far; for checkpoints. */
    PvdFile &
    collection()
    {
      return collection_;
    }

    const PvdFile &
    collection() const
    {
      return collection_;
    }

  private:
    PvdFile collection_;
  };
} // namespace Signorini

#endif
