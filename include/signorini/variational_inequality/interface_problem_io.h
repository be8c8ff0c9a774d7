#ifndef signorini_variational_inequality_interface_problem_io_h
#define signorini_variational_inequality_interface_problem_io_h

#include <signorini/variational_inequality/interface_problem.h>

#include <iosfwd>
#include <string>

namespace Signorini
{
  /**
   * Writes a problem as text, so that a step that failed becomes a test:
   *
   *   Signorini interface problem 2
   *   size n
   *   contacts m
   *   factor                   L, row by row up to the diagonal
   *   L_00
   *   L_10 L_11
   *   ...
   *   force                    r, one number a line
   *   r_0
   *   ...
   *   rows                     for each contact one line of its normal:
   *   G_0 2 dof a dof a        gap, number of entries, (DoF, coefficient);
   *   mu_0 c_0 1               one of its friction: coefficient, largest
   *   s_0 2 dof a dof a        friction, number of tangents; and one for each
   *                            tangent: slip, number of entries, entries
   *   ...
   *   end
   *
   * All numbers have 17 digits, so that reading returns the same bits. The gap
   * of a contact out of reach, and a largest friction that does not exist, are
   * written `inf'.
   * @throws ComputationError if the stream fails.
   */
  void
  write_interface_problem(const InterfaceProblem &problem, std::ostream &out);

  /**
   * Reads what write_interface_problem() wrote.
   * @param name what the stream is called in error messages.
   * @throws InputError naming the part of the file that is wrong.
   */
  InterfaceProblem
  read_interface_problem(std::istream &in, const std::string &name);
} // namespace Signorini

#endif
