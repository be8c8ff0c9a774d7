#ifndef signorini_output_field_writer_h
#define signorini_output_field_writer_h

#include <signorini/linear_algebra/types.h>
#include <signorini/output/pvd_file.h>

#include <deal.II/dofs/dof_handler.h>

#include <string>
#include <utility>
#include <vector>

namespace Signorini
{
  /** The fields of one body, as views: everything is owned by the caller. */
  template <int dim>
  struct BodyFields
  {
    std::string name;

    /** Of an FESystem with dim components. */
    const dealii::DoFHandler<dim> *dof_handler = nullptr;

    /** Unit: m, and m/s. The velocity is left out when it is null. */
    const DofVector *displacement = nullptr;
    const DofVector *velocity     = nullptr;

    /** Of the nodal fields, on the same mesh; unused when there are none. */
    const dealii::DoFHandler<dim> *scalar_dof_handler = nullptr;

    /** Name and nodal values, for instance "von_mises". */
    std::vector<std::pair<std::string, const DofVector *>> nodal_fields;
  };

  /**
   * Writes the bodies for ParaView: per output one compressed binary file
   * BODY_00012.vtu for each body, and one results.pvd that shows all bodies
   * together, as blocks named after them, over time.
   *
   * The geometry is the reference configuration; the filter "Warp By Vector"
   * with the field "displacement" shows the deformed one at any scale. In 2-D
   * vectors get a third component 0. Cells of a higher degree p are cut in
   * p^dim linear ones, so that every node of the element is a point of the
   * file and any version of ParaView can read it. Values and coordinates are
   * single precision (7 digits), which is what deal.II writes.
   */
  template <int dim>
  class FieldWriter
  {
  public:
    /** @param folder An existing folder. */
    explicit FieldWriter(const std::string &folder);

    /**
     * Write one output of all bodies.
     * @param time Unit: s.
     * @throws ComputationError when a file cannot be written; everything
     * listed in results.pvd stays readable.
     * @throws InputError when the names of two bodies give the same file name.
     */
    void
    write(const std::vector<BodyFields<dim>> &bodies, const double time);

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
