#ifndef signorini_run_small_strain_watch_h
#define signorini_run_small_strain_watch_h

#include <signorini/linear_algebra/types.h>
#include <signorini/solid/solid_model.h>
#include <signorini/solid/strain_range.h>

#include <string>
#include <vector>

namespace Signorini
{
  /**
   * Bodies computed with small strains that deform so much that they are not:
   * tells once when, and at the end how far. With finite strains there is
   * nothing to watch.
   *
   * The strain that a rotation by an angle t makes is 1 - cos t: 0.5 % at 0.1.
   */
  template <int dim>
  class SmallStrainWatch
  {
  public:
    explicit SmallStrainWatch(const SolidModel<dim> &solid);

    /**
     * @return a warning, the first time that a limit is passed; else empty
     * @throws ComputationError with the cell where one is turned inside out.
     */
    std::string
    look(const DofVector &displacement, const double time);

    /** The largest that was seen in words, if it was too much; else empty. */
    std::string
    summary() const;

  private:
    // The largest of all steps, and of what body.
    struct Largest
    {
      double             value = 0.;
      dealii::Point<dim> cell;
      std::string        body;
    };

    std::vector<StrainRange<dim>> ranges_; // of bodies with small strains
    std::vector<std::string>      names_;  // of these bodies
    Largest                       strain_;
    Largest                       rotation_;
    bool                          has_warned_ = false;
  };
} // namespace Signorini

#endif
