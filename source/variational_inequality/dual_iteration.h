#ifndef signorini_variational_inequality_dual_iteration_h
#define signorini_variational_inequality_dual_iteration_h

#include <signorini/variational_inequality/dual_solver.h>

#include <string>
#include <vector>

namespace Signorini
{
  /** The state of solve_dual() and solve_dual_with_friction(): forces on a
   * growing working set, the displacement that follows, and what is left of
   * gaps and slips. Used once. */
  class DualIteration
  {
  public:
    /** Without friction if @p method is empty. */
    DualIteration(const InterfaceProblem &problem,
                  const InterfaceForces  &starting_forces,
                  const CoulombMethod    &method,
                  const bool              exact,
                  const DualTerms        &terms);

    InterfaceSolution
    run();

  private:
    bool
    has_friction(const unsigned int k) const
    {
      return method && problem.contact(k).has_friction();
    }

    double
    offset(const unsigned int k) const
    {
      return terms.offsets.empty() ? 0. : terms.offsets[k];
    }

    double
    slip_offset(const unsigned int k, const unsigned int j) const
    {
      return terms.slip_offsets.empty() ? 0. : terms.slip_offsets[k][j];
    }

    // du, and for every contact e_k = A_k du - G_k + o_k - c lambda_k and
    // v_k = s_k + T_k du + o_k - c_T tau_k.
    void
    update();

    void
    add_to_working_set(const unsigned int k);

    // Adds every other contact with e_k > 0; false if there is none.
    bool
    add_violated();

    // Adds every contact within reach, without forces; false if there is none.
    bool
    add_all();

    // New forces on the working set, from gaps and slips as they are.
    void
    correct_forces();

    // By the quadratic programme, with friction forces as they are.
    void
    correct_normal_forces();

    // By the method for Coulomb's law.
    void
    correct_all_forces();

    // The rows of the working set, and what is left in them.
    CoulombSystem
    coulomb_system(std::vector<double> &x) const;

    // The size of the numbers that cancel in e_k and v_k.
    double
    length(const unsigned int k) const;

    // How far the working set is from its law, m: of gaps, and of friction
    // unless it is taken as it is.
    double
    working_set_error() const;

    // The same with friction in any case.
    double
    coulomb_error() const;

    // Which contacts slip, at the end.
    void
    mark_slipping();

    // That friction taken as it is still fits normal forces corrected after it.
    void
    check_friction() const;

    bool
    working_set_has_friction() const;

    // The contacts at the given positions of the working set.
    std::vector<unsigned int>
    contacts_at(const std::vector<unsigned int> &positions) const;

    /** @throws InterfaceError, always. */
    [[noreturn]] static void
    fail(const std::string &message, std::vector<unsigned int> contacts);

    const InterfaceProblem &problem;
    const CoulombMethod    &method;
    const bool              exact;
    const DualTerms        &terms;

    InterfaceSolution                  solution;
    std::vector<double>                excess;
    std::vector<std::array<double, 2>> slip_left;
    std::vector<char>                  in_working_set;
    std::vector<unsigned int>          working_set;
    bool                               friction_is_settled = false;
    bool                               is_first_correction = true;
    double                             law_tolerance       = 0.;
    double                             length_scale        = 0.;
  };
} // namespace Signorini

#endif
