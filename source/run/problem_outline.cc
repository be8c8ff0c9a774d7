#include <signorini/input/input_error.h>
#include <signorini/input/named_list.h>
#include <signorini/input/nearest_name.h>
#include <signorini/run/problem_outline.h>

#include <set>

namespace Signorini
{
  namespace
  {
    // Files of the results are called after bodies and the targets of pairs;
    // these names are those of other files.
    const std::set<std::string> names_of_files = {"contact",
                                                  "displacements",
                                                  "history",
                                                  "last",
                                                  "meshes",
                                                  "parameters",
                                                  "previous",
                                                  "results",
                                                  "run"};

    // One list of names at the top of the file, of which `used` knows those
    // that came before.
    void
    check_names(const std::vector<std::string> &names,
                const std::string              &place,
                std::set<std::string>          &used)
    {
      for (const auto &name : names)
        {
          if (name.empty())
            throw InputError(place + "a name is empty. Remove a comma, or "
                                     "write the name that is missing.");
          if (name.find_first_of(".|:/ \t") != std::string::npos)
            throw InputError(place + "the name \"" + name +
                             "\" has one of the characters . | : / or a "
                             "blank, which part names in other entries. Use "
                             "letters, digits, - and _.");
          if (names_of_files.count(name) > 0)
            throw InputError(place + "the name \"" + name +
                             "\" is that of a file of the results. Give the "
                             "body another one.");
          if (!used.insert(name).second)
            throw InputError(place + "two bodies have the name \"" + name +
                             "\". Give each, rigid or not, a name of its "
                             "own.");
        }
    }
  } // namespace



  ProblemOutline
  ProblemOutline::read(const ParameterFile &file)
  {
    ProblemOutline outline;
    try
      {
        outline.formulation =
          formulation_from_name(file.get("Formulation", "plane strain"));
      }
    catch (const InputError &error)
      {
        throw InputError(file.where("Formulation") + ": " + error.what() +
                         did_you_mean(file.get("Formulation", ""),
                                      split_list(formulation_names(), '|')));
      }
    outline.bodies       = split_list(file.get("Bodies", ""), ',');
    outline.rigid_bodies = split_list(file.get("Rigid bodies", ""), ',');
    if (outline.bodies.empty())
      throw InputError(file.path() +
                       ": the entry Bodies names no body. Write \"set Bodies "
                       "= NAME\" and a section \"Body NAME\".");
    std::set<std::string> names;
    check_names(outline.bodies, file.where("Bodies") + ": Bodies: ", names);
    check_names(outline.rigid_bodies,
                file.where("Rigid bodies") + ": Rigid bodies: ",
                names);
    for (const auto &name : outline.bodies)
      outline.regions.push_back(
        split_list(file.get("Body " + name + "/Regions", ""), ','));
    outline.pairs = split_list(file.get("Contact/Pairs", ""), ',');
    return outline;
  }
} // namespace Signorini
