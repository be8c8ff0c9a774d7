#ifndef signorini_tests_test_laws_h
#define signorini_tests_test_laws_h

#include <string>

// Sections `Material' of a steel. Later entries count: each may be varied by
// adding some.
namespace Signorini
{
  namespace TestLaws
  {
    inline const std::string hencky    = "set Law = elastic\n"
                                         "set Young's modulus = 200e9\n"
                                         "set Poisson's ratio = 0.3\n";
    inline const std::string neo_hooke = hencky + "set Law = neo-Hooke\n";
    inline const std::string linear    = hencky +
                                      "set Law = elasto-plastic\n"
                                      "set Yield stress = 200e6\n"
                                      "set Hardening modulus = 1000e6\n";
    inline const std::string voce   = linear + "set Hardening = Voce\n"
                                               "set Saturation stress = 350e6\n"
                                               "set Saturation exponent = 12\n";
    inline const std::string prager = linear +
                                      "set Kinematic hardening = linear\n"
                                      "set Kinematic hardening modulus = 5e9\n";
    inline const std::string armstrong_frederick =
      voce + "set Kinematic hardening = Armstrong-Frederick\n"
             "set Kinematic hardening modulus = 20e9\n"
             "set Dynamic recovery = 200\n";
  } // namespace TestLaws
} // namespace Signorini

#endif
