#ifndef signorini_run_problem_outline_h
#define signorini_run_problem_outline_h

#include <signorini/input/parameter_file.h>
#include <signorini/solid/formulation.h>

#include <string>
#include <vector>

namespace Signorini
{
  /** What decides which sections a .prm has. */
  struct ProblemOutline
  {
    Formulation              formulation;
    std::vector<std::string> bodies;
    std::vector<std::string> rigid_bodies;

    /** Of each body: the regions that have a material of their own. */
    std::vector<std::vector<std::string>> regions;

    /** The contact pairs as written: each may have a section of its own. */
    std::vector<std::string> pairs;

    /** Reads the entries of the top level. @throws InputError. */
    static ProblemOutline
    read(const ParameterFile &file);
  };
} // namespace Signorini

#endif
