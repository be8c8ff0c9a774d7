#ifndef signorini_variational_inequality_coulomb_system_h
#define signorini_variational_inequality_coulomb_system_h


#include <signorini/variational_inequality/interface_types.h>

#include <array>
#include <limits>
#include <vector>

namespace Signorini
{
  /** A contact in the dual of an interface problem. */
  struct DualContact
  {
    unsigned int row                  = 0; // of its normal; its tangents follow
    unsigned int n_tangents           = 0; // none without friction
    double       friction_coefficient = 0.;                            // 1
    double largest_friction = std::numeric_limits<double>::infinity(); // N

    /** f = min(mu lambda, largest friction), N. */
    double
    bound(const double lambda) const;
  };

  /**
   * Contact with Coulomb's friction as a dense system for the forces
   * x = (lambda_1, tau_1, lambda_2, ...) of a set of contacts, all rows of a
   * contact together. With y = d - (W + C) x, where y = (e_1, v_1, e_2, ...),
   *
   *   lambda >= 0,  e <= 0,  lambda e = 0,
   *   |tau| <= f(lambda),  and tau = f v / |v| unless v = 0.
   *
   * W is symmetric, positive semidefinite, the compliance of the interface
   * between the rows; C >= 0 is diagonal and makes contacts soft. e is the
   * penetration and v the slip that is left. Forces in N, y in m, W in m/N.
   */
  class CoulombSystem
  {
  public:
    /**
     * @param W must outlive the object.
     * @param compliance C, one number for each row.
     * @param length_scale the size of the numbers that cancelled in d.
     */
    CoulombSystem(const InterfaceMatrix   &W,
                  std::vector<DualContact> contacts,
                  std::vector<double>      compliance,
                  std::vector<double>      d,
                  const double             length_scale);

    unsigned int
    size() const
    {
      return d.size();
    }

    unsigned int
    n_contacts() const
    {
      return contacts.size();
    }

    const DualContact &
    contact(const unsigned int k) const
    {
      return contacts[k];
    }

    /** (W + C)_ij. */
    double
    operator()(const unsigned int i, const unsigned int j) const
    {
      return i == j ? diagonal[i] : W(i, j);
    }

    /** Writes row @p i of W + C. */
    void
    copy_row(const unsigned int i, double *entries) const;

    /** C. */
    const std::vector<double> &
    soft() const
    {
      return compliance;
    }

    /** d. */
    const std::vector<double> &
    constant() const
    {
      return d;
    }

    /** y = d - (W + C) x. */
    std::vector<double>
    residual(const std::vector<double> &x) const;

    /** w of the normal of contact @p k: (W + C) on the diagonal, m/N. */
    double
    normal_weight(const unsigned int k) const;

    /** w of the tangents of contact @p k: the mean on the diagonal, m/N. */
    double
    tangential_weight(const unsigned int k) const;

    /**
     * How far contact @p k is from its law, in m: the larger of
     * |w lambda - (w lambda + e)+| and |w tau - P(w tau + v)|, where P projects
     * on the disc of radius w f(lambda).
     */
    double
    error(const unsigned int         k,
          const std::vector<double> &x,
          const std::vector<double> &y) const;

    /** The largest error of all contacts, m; infinite if it is not a number. */
    double
    error(const std::vector<double> &x, const std::vector<double> &y) const;

    /** The size of the numbers that cancel in y, m. */
    double
    scale() const
    {
      return length_scale;
    }

    /** What an error may be by rounding, m. */
    double
    rounding(const std::vector<double> &x) const;

    /** The contacts that are further from their law than @p tolerance. */
    std::vector<unsigned int>
    wrong_contacts(const std::vector<double> &x, const double tolerance) const;

  private:
    const InterfaceMatrix   &W;
    std::vector<DualContact> contacts;
    std::vector<double>      compliance;
    std::vector<double>      diagonal;
    std::vector<double>      d;
    double                   length_scale;
  };

  /** What a method finds for a CoulombSystem. */
  struct CoulombSolution
  {
    bool                solved = false;
    std::vector<double> x; // the solution, or the best point found

    unsigned int n_iterations = 0; // linear systems, or faces of a programme

    // How far from the law the method leaves it by design, m.
    double law_tolerance = 0.;

    // Positions of the contacts that a fallback had to solve, or that are
    // still wrong if it is not solved.
    bool                      fell_back = false;
    std::vector<unsigned int> suspects  = {};
  };
} // namespace Signorini

#endif
