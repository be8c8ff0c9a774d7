#ifndef signorini_source_material_hardening_table_h
#define signorini_source_material_hardening_table_h

#include <signorini/material/yield_curve.h>

namespace Signorini
{
  /**
   * The entry `Hardening table': points `strain: stress | ...', or `file NAME'.
   * @throws InputError when it cannot be read.
   */
  std::vector<YieldCurve::Entry>
  read_hardening_table(const std::string &text,
                       const std::string &base_directory);

  /**
   * @throws InputError unless the strain grows from zero and the stress is
   * positive and does not fall.
   */
  void
  check_hardening_table(const std::vector<YieldCurve::Entry> &entries);
} // namespace Signorini

#endif
