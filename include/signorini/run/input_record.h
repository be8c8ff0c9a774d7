#ifndef signorini_run_input_record_h
#define signorini_run_input_record_h

#include <signorini/output/checkpoint.h>
#include <signorini/run/problem.h>

#include <string>
#include <vector>

namespace Signorini
{
  /** Every entry of a handler with its value, in the order of declaration. */
  std::vector<InputEntry>
  input_entries(const dealii::ParameterHandler &prm);

  /**
   * True if a run may go on from a checkpoint with another value of this
   * entry: the end, limits of the steps, what is written, what is expected.
   */
  bool
  may_change_on_resume(const std::string &path);

  /**
   * @throws InputError that names each entry which differs from that of a
   * checkpoint, with both values.
   */
  void
  refuse_changed_input(const std::vector<InputEntry> &old_entries,
                       const std::vector<InputEntry> &entries);

  /**
   * A checksum of what comes from files and is no entry: nodes of the bodies
   * and outlines of the rigid bodies.
   */
  template <int dim>
  unsigned int
  geometry_checksum(const Problem<dim> &problem);
} // namespace Signorini

#endif
