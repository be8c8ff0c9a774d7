#include <signorini/input/input_error.h>
#include <signorini/input/instantiate.h>
#include <signorini/run/small_strain_watch.h>

#include <sstream>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // The errors are of about their size: 5 % in the stress, and a strain of
    // 0.5 % that is not there.
    constexpr double largest_strain   = 0.05;
    constexpr double largest_rotation = 0.1; // rad

    const std::string remedy =
      "Kinematics = small strain leaves out products of displacement "
      "gradients; set Kinematics = finite strain";
  } // namespace



  template <int dim>
  SmallStrainWatch<dim>::SmallStrainWatch(const SolidModel<dim> &solid)
  {
    for (const auto &part : solid.parts())
      if (part.body->kinematics() == Kinematics::small_strain)
        {
          ranges_.emplace_back(*part.body);
          names_.push_back(part.body->name());
        }
  }



  template <int dim>
  std::string
  SmallStrainWatch<dim>::look(const DofVector &displacement, const double time)
  {
    for (unsigned int b = 0; b < ranges_.size(); ++b)
      {
        const StrainExtremes<dim> extremes = ranges_[b].measure(displacement);
        if (!(extremes.volume.value > 0.))
          {
            std::ostringstream message;
            message << "At t = " << time << " s, body " << names_[b]
                    << ", cell with the centre (" << extremes.volume.cell
                    << "): it is turned inside out, its volume is "
                    << extremes.volume.value << " times that at the start. "
                    << remedy
                    << ", and take steps in which no body goes through "
                       "another.";
            throw ComputationError(message.str());
          }
        if (extremes.strain.value > strain_.value)
          strain_ = {extremes.strain.value, extremes.strain.cell, names_[b]};
        if (extremes.rotation.value > rotation_.value)
          rotation_ = {extremes.rotation.value,
                       extremes.rotation.cell,
                       names_[b]};
      }
    if (has_warned_ || summary().empty())
      return "";
    has_warned_ = true;
    std::ostringstream message;
    message << "t = " << time << " s: " << summary();
    return message.str();
  }



  template <int dim>
  std::string
  SmallStrainWatch<dim>::summary() const
  {
    std::ostringstream message;
    message.precision(3);
    if (strain_.value > (1. + 1e-9) * largest_strain)
      message << "a strain of " << 100. * strain_.value << " % in body "
              << strain_.body << ", cell with the centre (" << strain_.cell
              << ")";
    if (rotation_.value > largest_rotation)
      message << (message.str().empty() ? "" : " and ") << "a rotation by "
              << rotation_.value << " rad in body " << rotation_.body
              << ", cell with the centre (" << rotation_.cell << ")";
    if (message.str().empty())
      return "";
    return "warning: " + message.str() + ": too much for small strains. " +
           remedy + ".";
  }



#define INSTANTIATE(dim) template class SmallStrainWatch<dim>;
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
