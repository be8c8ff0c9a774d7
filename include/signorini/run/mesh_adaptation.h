#ifndef signorini_run_mesh_adaptation_h
#define signorini_run_mesh_adaptation_h

#include <signorini/dynamics/state.h>
#include <signorini/output/check_expression.h>
#include <signorini/run/problem.h>

#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include <string>
#include <utility>
#include <vector>

namespace Signorini
{
  /** What one mesh of an adaptive run gave. */
  struct MeshRecord
  {
    unsigned int        n_cells    = 0;
    unsigned int        n_unknowns = 0;
    double              error      = 0.; // of the energy norm, estimated, 1
    std::vector<double> quantities;      // that have to settle

    // Largest relative change of them since the meshes up to the last one with
    // at most half of the unknowns and 1.2 times the error; infinite without
    // such a mesh. 1
    double change = 0.;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &n_cells &n_unknowns &error &quantities &change;
    }
  };

  /**
   * Finds meshes for a problem, one after the other, each from the solution on
   * the last one:
   *  - around what is in contact, cells are cut until `Cells across contact' of
   *    them go into its width; and where the gap is so small that the chords of
   *    curved surfaces may hide a contact;
   *  - the cells with the greatest estimated errors that together make up the
   *    `Error share' are cut [Doerfler1996].
   * It ends when contact is fine enough and the quantities have settled.
   */
  template <int dim>
  class MeshAdaptation
  {
  public:
    /**
     * Looks at the problem on its first mesh.
     * @throws InputError when a quantity is no formula, or not of this problem.
     */
    explicit MeshAdaptation(const Problem<dim> &problem);

    /** Refinements of each body up to now. */
    const std::vector<RefinementPasses> &
    passes() const
    {
      return passes_;
    }

    /** One a mesh. */
    const std::vector<MeshRecord> &
    records() const
    {
      return records_;
    }

    /** Of the quantities, as in the .prm. */
    const std::vector<std::string> &
    quantities() const
    {
      return names_;
    }

    /**
     * Judges the solution on a mesh, and adds a pass for each body unless it is
     * good enough. @return whether there is to be another mesh.
     */
    bool
    improve(const Problem<dim> &problem, const State &state);

    /** Why there is no other mesh, in words. */
    const std::string &
    verdict() const
    {
      return verdict_;
    }

    /** One line about the last mesh. */
    std::string
    last_in_words() const;

    /** The records as a table. @throws ComputationError. */
    void
    write(const std::string &path) const;

    /** For checkpoints through Boost.Serialization: what was found so far. */
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &passes_ &records_;
    }

  private:
    using Flags = std::vector<std::vector<bool>>; // of the cells of each body

    MeshRecord
    measure(const Problem<dim>                     &problem,
            const State                            &state,
            const std::vector<std::vector<double>> &errors) const;

    double
    change_since_coarser(const MeshRecord &now) const;

    // @return whether cells around a contact are too large
    bool
    flag_contact(const Problem<dim> &problem,
                 const State        &state,
                 Flags              &flags) const;

    void
    flag_errors(const Problem<dim>                     &problem,
                const std::vector<std::vector<double>> &errors,
                Flags                                  &flags) const;

    AdaptivityParameters          parameters_;
    std::vector<std::string>      names_;
    std::vector<CheckExpression>  expressions_;
    std::vector<RefinementPasses> passes_;
    std::vector<MeshRecord>       records_;
    std::string                   verdict_;
  };
} // namespace Signorini

#endif
