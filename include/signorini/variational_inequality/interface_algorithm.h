#ifndef signorini_variational_inequality_interface_algorithm_h
#define signorini_variational_inequality_interface_algorithm_h

#include <signorini/variational_inequality/algorithm_parameters.h>
#include <signorini/variational_inequality/interface_problem.h>

#include <memory>
#include <string>
#include <vector>

namespace Signorini
{
  /** A way to solve an InterfaceProblem. Keeps nothing between two calls. */
  class InterfaceAlgorithm
  {
  public:
    virtual ~InterfaceAlgorithm() = default;

    /**
     * Displacements and contact forces. If all contacts stay open without
     * contact forces, that is the answer, whatever the algorithm.
     *
     * @param starting_forces of the last step or iteration, from which the
     *   search starts, N; or empty.
     * @throws InterfaceError if there is no solution or it is not found.
     */
    InterfaceSolution
    solve(const InterfaceProblem &problem,
          const InterfaceForces  &starting_forces) const;

    /** The name in the .prm. */
    virtual std::string
    name() const = 0;

    /** Do the gap constraints hold to rounding? If not, closed contacts
     * penetrate. */
    virtual bool
    enforces_exactly() const = 0;

    /** Does the solution obey the law of the problem, friction included, so
     * that its KKT residual is that of the algorithm? */
    virtual bool
    satisfies_coulomb() const
    {
      return enforces_exactly();
    }

  private:
    /** Solves a problem in which at least one contact closes. */
    virtual InterfaceSolution
    solve_closed(const InterfaceProblem &problem,
                 const InterfaceForces  &starting_forces) const = 0;
  };

  /** @throws InputError if a contact of @p problem has friction and two
   * tangents, which the algorithm @p name does not know. */
  void
  refuse_three_dimensional_friction(const InterfaceProblem &problem,
                                    const std::string      &name);

  /** The names of all algorithms, separated by `|'. */
  std::string
  interface_algorithm_names();

  /**
   * The algorithm that the parameters name.
   * @throws InputError if there is none of this name, or it lacks a number
   *   that it needs.
   */
  std::unique_ptr<InterfaceAlgorithm>
  make_interface_algorithm(const AlgorithmParameters &parameters);
} // namespace Signorini

#endif
