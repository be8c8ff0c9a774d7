#ifndef signorini_contact_contact_state_h
#define signorini_contact_contact_state_h

#include <signorini/variational_inequality/interface_problem.h>

#include <boost/serialization/array.hpp>
#include <boost/serialization/map.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include <array>
#include <map>
#include <string>
#include <vector>

namespace Signorini
{
  /**
   * What the candidates of all pairs know at the end of a step, and remember in
   * the next: a value for each in every list.
   */
  struct ContactState
  {
    explicit ContactState(const unsigned int n_contacts = 0)
      : forces(n_contacts)
      , gaps(n_contacts)
      , recessions(n_contacts)
      , slips(n_contacts)
      , slip_rates(n_contacts)
      , slip_ways(n_contacts)
      , is_slipping(n_contacts)
    {}

    InterfaceForces     forces;     // N
    std::vector<double> gaps;       // g_k, m
    std::vector<double> recessions; // of worn surfaces, in the gaps, m

    std::vector<std::array<double, 2>> slips;       // since it closed, m
    std::vector<double>                slip_rates;  // over the last step, m/s
    std::vector<double>                slip_ways;   // since it stuck, m
    std::vector<char>                  is_slipping; // in the last step

    // Of the contact processes, by their names: worn depth, ...
    std::map<std::string, std::vector<double>> quantities;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &forces.normal &forces.tangential &gaps    &recessions;
      archive &slips &slip_rates &slip_ways &is_slipping &quantities;
    }
  };
} // namespace Signorini

#endif
