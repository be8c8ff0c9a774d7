#ifndef signorini_run_result_fields_h
#define signorini_run_result_fields_h

#include <signorini/dynamics/state.h>
#include <signorini/linear_algebra/types.h>
#include <signorini/output/displacement_writer.h>
#include <signorini/output/field_lookup.h>
#include <signorini/output/field_writer.h>
#include <signorini/output/surface_writer.h>
#include <signorini/run/problem.h>
#include <signorini/solid/stress_recovery.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace Signorini
{
  /**
   * The fields of a state: written for ParaView, and looked up by name for the
   * expected results (BODY.displacement_x, BODY.stress_xx, BODY.von_mises, all
   * of them also on a boundary, BODY.BOUNDARY.von_mises, and PAIR.pressure,
   * gap, shear (Pa, on the contactor, along the target's tangent), slip (m,
   * since it closed) and status (0 open, 1 stick, 2 slip) on contact surfaces).
   */
  template <int dim>
  class ResultFields : public FieldLookup
  {
  public:
    /** The problem must outlive the object. */
    explicit ResultFields(const Problem<dim> &problem);

    /** The fields are those of this state from now on; it must stay alive, and
     * as it is. */
    void
    show(const State &state);

    std::vector<std::string>
    names() const override;

    NodalField
    field(const std::string &name) const override;

    void
    write(FieldWriter<dim> &fields, SurfaceWriter<dim> &surfaces) const;

    void
    write(DisplacementWriter<dim> &displacements) const;

    /** Writes PAIR.csv for each pair into a folder: the values at the nodes. */
    void
    write_contact_tables(const std::string &folder) const;

  private:
    std::vector<std::string>
    stress_names() const;

    std::map<std::string, DofVector>
    stresses(const unsigned int body) const;

    // Of the whole body if the boundary is empty.
    NodalField
    body_field(const unsigned int body,
               const std::string &boundary,
               const std::string &quantity) const;

    NodalField
    surface_field(const ContactPair<dim> &pair,
                  const std::string      &quantity) const;

    SurfaceData<dim>
    surface_data(const ContactPair<dim> &pair) const;

    // Of all pairs, evaluated when they are first asked for.
    const std::vector<ContactPoint<dim>> &
    contact_points() const;

    const Problem<dim>                               &problem_;
    const State                                      *state_ = nullptr;
    mutable std::vector<ContactPoint<dim>>            contact_points_;
    std::vector<std::unique_ptr<StressRecovery<dim>>> stresses_; // a body each
  };
} // namespace Signorini

#endif
