#ifndef tests_unit_fir_tree_sets_h
#define tests_unit_fir_tree_sets_h

#include <signorini/geometry/entries.h>
#include <signorini/geometry/fir_tree/fir_tree_joint.h>
#include <signorini/input/input_error.h>

#include <deal.II/base/parameter_handler.h>

#include <cmath>
#include <random>
#include <sstream>
#include <string>
#include <vector>

/** The joint that these lines describe. */
inline Signorini::FirTreeJoint
joint_from(const std::string &lines)
{
  dealii::ParameterHandler prm;
  Signorini::FirTreeJoint::declare_parameters(prm);
  prm.parse_input_from_string(lines);
  Signorini::FirTreeJoint joint;
  joint.parse_parameters(Signorini::Entries(prm, ""));
  return joint;
}

/**
 * Lines for @p n joints with measures drawn at random, of sizes from a tenth of
 * to ten times the default. Sets that make no joint are drawn again.
 */
inline std::vector<std::string>
random_joint_lines(const unsigned int n, const unsigned int seed)
{
  std::mt19937 generator(seed);
  const auto   draw = [&](const double low, const double high) {
    // The standard fixes the numbers of the generator, not of distributions.
    return low + (high - low) * (generator() / 4294967296.);
  };

  std::vector<std::string> result;
  while (result.size() < n)
    {
      const double       size = std::pow(10., draw(-1., 1.));
      const double       root = size * draw(0.5e-3, 2e-3);
      std::ostringstream lines;
      lines.precision(17);
      lines << "set Teeth = " << 1 + generator() % 6 << "\n"
            << "set Flank length = " << size * draw(1e-3, 5e-3) << "\n"
            << "set Contact angle = " << draw(10., 55.) << "\n"
            << "set Back flank angle = " << draw(10., 60.) << "\n"
            << "set Taper angle = " << draw(0., 20.) << "\n"
            << "set Root radius = " << root << "\n"
            << "set Tip radius = " << size * draw(0.4e-3, 2e-3) << "\n"
            << "set Bottom radius = " << size * draw(3e-3, 20e-3) << "\n"
            << "set Bottom neck width = " << size * draw(6e-3, 20e-3) << "\n"
            << "set Clearance = " << size * draw(0., 0.2e-3) << "\n"
            << "set Mouth depth = " << size * draw(1.5e-3, 6e-3) << "\n"
            << "set Rim radius = " << size * draw(0.25, 0.4) << "\n"
            << "set Blades = " << 20 + generator() % 50 << "\n";
      try
        {
          joint_from(lines.str());
          result.push_back(lines.str());
        }
      catch (const Signorini::InputError &)
        {}
    }
  return result;
}

#endif
