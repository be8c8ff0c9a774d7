#ifndef signorini_variational_inequality_interface_problem_h
#define signorini_variational_inequality_interface_problem_h

#include <signorini/variational_inequality/compliance_matrix.h>
#include <signorini/variational_inequality/interface_stiffness.h>
#include <signorini/variational_inequality/interface_types.h>
#include <signorini/variational_inequality/row_responses.h>
#include <signorini/variational_inequality/sparse_row.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace Signorini
{
  /**
   * One candidate contact: the gap after the step is gap - normal . du, its
   * slip over the step slip + tangents . du. A contact whose target is out of
   * reach has an empty normal row and an infinite gap, and stays open.
   */
  struct InterfaceContact
  {
    SparseRow normal;   // A_k, 1
    double    gap = 0.; // G_k, m

    // T_k: none without friction, one row in 2-D, two in 3-D; and the slip
    // s_k along each so far in this step, m.
    std::vector<SparseRow> tangents = {};
    std::array<double, 2>  slip     = {{0., 0.}};

    // |tau_k| <= min(mu_k lambda_k, largest friction).
    double friction_coefficient = 0.;                                      // 1
    double largest_friction     = std::numeric_limits<double>::infinity(); // N

    // To what gap and slip are known at all, as differences of coordinates, m.
    double rounding = 0.;

    bool
    has_friction() const
    {
      return !tangents.empty() && friction_coefficient > 0.;
    }

    /** Out of reach of its target: it stays open whatever happens. */
    bool
    is_out_of_reach() const
    {
      return normal.size() == 0;
    }

    /** f = min(mu lambda, largest friction) under the normal force lambda,
     * N. */
    double
    friction_bound(const double normal_force) const
    {
      return has_friction() && normal_force > 0. ?
               std::min(friction_coefficient * normal_force, largest_friction) :
               0.;
    }
  };

  /** The forces of all contacts of a problem; both lists may be empty. */
  struct InterfaceForces
  {
    InterfaceForces() = default;

    explicit InterfaceForces(const unsigned int n_contacts)
      : normal(n_contacts, 0.)
      , tangential(n_contacts, {{0., 0.}})
    {}

    explicit InterfaceForces(const std::vector<double> &normal_forces)
      : normal(normal_forces)
      , tangential(normal_forces.size(), {{0., 0.}})
    {}

    std::vector<double>                normal;     // lambda_k >= 0, N
    std::vector<std::array<double, 2>> tangential; // tau_k, along slip, N
  };

  /**
   * The contact problem of one iteration, condensed on the interface:
   *
   *   min 1/2 du^T S du - du^T r + sum_k f_k |s_k + T_k du|
   *   subject to   A du <= G,
   *
   * with the friction bound f_k = min(mu_k lambda_k, largest friction) of the
   * solution itself (Coulomb). With the multipliers of both this is
   *
   *   S du - r + A^T lambda + T^T tau = 0,
   *   lambda >= 0, A du <= G, lambda^T (A du - G) = 0,
   *   |tau_k| <= f_k, and tau_k = f_k slip_k / |slip_k| unless slip_k = 0.
   *
   * du in m, r in N, S in N/m. In 2-D, forces are per thickness.
   *
   * Data and what follows from it, no state of an algorithm. Derived values
   * are computed on first use and kept while what they depend on stays the
   * same; above all the responses S^-1 A_k^T, which cost two triangular
   * solves each. Not safe to share between threads.
   */
  class InterfaceProblem
  {
  public:
    /** Takes the stiffness over. Responses are forgotten, and the force, which
     * may be given in terms of the factor, has to be set again. */
    void
    set_stiffness(InterfaceStiffness &&new_stiffness);

    /** The force @p r on the condensed interface, without contact forces. */
    void
    set_force(const InterfaceVector &r);

    /** The same, given as y = L^-1 r: the trailing part of the forward
     * substitution of the sparse factor. Saves two triangular products. */
    void
    set_reduced_force(const InterfaceVector &y);

    /** A response is kept if its row is the same as before under the same
     * index: list the contacts in the same order in every step. */
    void
    set_contacts(std::vector<InterfaceContact> new_contacts);

    /** Changes a gap only, e.g. over a flat rigid target. */
    void
    set_gap(const unsigned int k, const double gap);

    /** Changes a slip only. */
    void
    set_slip(const unsigned int k, const std::array<double, 2> &slip);

    /** n, the number of interface DoFs. */
    unsigned int
    size() const
    {
      return interface_stiffness.size();
    }

    unsigned int
    n_contacts() const
    {
      return contacts.size();
    }

    const InterfaceStiffness &
    stiffness() const
    {
      return interface_stiffness;
    }

    const InterfaceContact &
    contact(const unsigned int k) const
    {
      AssertIndexRange(k, contacts.size());
      return contacts[k];
    }

    /** r, N. */
    const InterfaceVector &
    force() const;

    /** S^-1 r, m: the displacement if no contact force acted. */
    const InterfaceVector &
    free_displacement() const;

    /** G - A S^-1 r, m: the gaps if no contact force acted. */
    const std::vector<double> &
    free_gaps() const;

    /** Gap of contact @p k after the displacement @p du, m. */
    double
    gap_after(const unsigned int k, const InterfaceVector &du) const
    {
      return contacts[k].gap - contacts[k].normal.dot(du);
    }

    /** Slip of contact @p k along its tangent @p j after the displacement
     * @p du, m. */
    double
    slip_after(const unsigned int     k,
               const unsigned int     j,
               const InterfaceVector &du) const
    {
      return contacts[k].slip[j] + contacts[k].tangents[j].dot(du);
    }

    /** S^-1 A_k^T, m/N: n numbers. A reference stays valid until the stiffness
     * or the contacts are set. */
    const InterfaceVector &
    response(const unsigned int k) const
    {
      return row_response(row_number(k, 0));
    }

    /** S^-1 T_kj^T, m/N, of the tangent @p j of contact @p k. */
    const InterfaceVector &
    tangent_response(const unsigned int k, const unsigned int j) const
    {
      return row_response(row_number(k, j + 1));
    }

    /** Computes the missing responses of several contacts in one block: of
     * their normals, and of their tangents @p with_friction. */
    void
    prepare_responses(const std::vector<unsigned int> &wanted,
                      const bool with_friction = true) const;

    /** Is the response of the normal of contact @p k at hand without
     * computing? */
    bool
    knows_response(const unsigned int k) const
    {
      return responses.is_known(row_number(k, 0));
    }

    bool
    knows_tangent_response(const unsigned int k, const unsigned int j) const
    {
      return responses.is_known(row_number(k, j + 1));
    }

    /** A_j S^-1 A_k^T, m/N. */
    double
    compliance(const unsigned int j, const unsigned int k) const
    {
      return contacts[j].normal.dot(response(k));
    }

    /**
     * The compliance b_i S^-1 b_j^T, m/N, between all rows b of the contacts
     * @p list: contact by contact the normal and, @p with_friction, the
     * tangents of those that have friction. Kept, with what was factorised of
     * it, while the list, the rows and the stiffness are the same; a reference
     * stays valid until another list is asked for or one of them is set.
     */
    ComplianceMatrix &
    compliance_matrix(const std::vector<unsigned int> &list,
                      const bool                       with_friction) const;

  private:
    // A normal and two tangents for each contact, so that numbers do not
    // depend on which of them exist.
    static unsigned int
    row_number(const unsigned int k, const unsigned int direction)
    {
      return 3 * k + direction;
    }

    const SparseRow &
    row(const unsigned int number) const
    {
      const InterfaceContact &contact = contacts[number / 3];
      return number % 3 == 0 ? contact.normal :
                               contact.tangents[number % 3 - 1];
    }

    const InterfaceVector &
    row_response(const unsigned int number) const;

    // The rows of the contacts @p list, as compliance_matrix() orders them.
    std::vector<unsigned int>
    rows_of(const std::vector<unsigned int> &list,
            const bool                       with_friction) const;

    InterfaceStiffness            interface_stiffness;
    std::vector<InterfaceContact> contacts;

    // Which of r, y was given or is computed already.
    mutable bool            force_known         = false;
    mutable bool            reduced_force_known = false;
    mutable InterfaceVector condensed_force;
    mutable InterfaceVector reduced_force;

    mutable bool            free_displacement_known = false;
    mutable InterfaceVector displacement_without_contact;

    mutable bool                free_gaps_known = false;
    mutable std::vector<double> gaps_without_contact;

    mutable RowResponses     responses;
    mutable ComplianceMatrix kept_compliance;
  };

  /** What an algorithm finds. */
  struct InterfaceSolution
  {
    InterfaceVector displacement; // du, m
    InterfaceForces forces;

    // Whether each contact slips: its friction is at the bound and its slip is
    // more than the algorithm leaves to one that sticks.
    std::vector<char> is_slipping;

    // Faces minimised on, Newton steps, or updates of the multipliers; 0 if
    // all is open.
    unsigned int n_iterations = 0;

    // How often the algorithm itself did not find the state and a globally
    // convergent method took its place, and for which contacts.
    unsigned int              n_fallbacks = 0;
    std::vector<unsigned int> fallback_contacts;
  };
} // namespace Signorini

#endif
