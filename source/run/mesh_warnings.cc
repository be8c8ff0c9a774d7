#include <signorini/geometry/chords.h>
#include <signorini/input/instantiate.h>
#include <signorini/run/mesh_warnings.h>

#include <sstream>
#include <vector>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // BODY.BOUNDARY of the deformable sides of a pair as it is written.
    std::vector<std::string>
    sides_of(const std::string &pair)
    {
      std::vector<std::string> sides = {pair};
      for (const std::string word : {" on ", " with "})
        {
          const std::size_t at = pair.find(word);
          if (at != std::string::npos)
            sides = {pair.substr(0, at), pair.substr(at + word.size())};
        }
      std::vector<std::string> deformable;
      for (const std::string &side : sides)
        if (side.find('.') != std::string::npos)
          deformable.push_back(Utilities::trim(side));
      return deformable;
    }

    template <int dim>
    std::string
    warning(const Body<dim>    &body,
            const std::string  &boundary,
            const Chords       &chords,
            const Problem<dim> &problem)
    {
      const unsigned int degree = body.scalar_fe().degree;
      std::string        cause;
      if (degree > 1)
        cause = "Element degree = " + std::to_string(degree);
      else if (chords.are_cut)
        cause = "refinements";
      else if (problem.adaptivity.maximal_meshes > 1)
        cause = "Adaptivity";
      if (chords.turn == 0. || cause.empty())
        return "";
      std::ostringstream text;
      text.precision(3);
      text << "warning: body " << body.name() << ", boundary \"" << boundary
           << "\": its faces turn by up to " << chords.turn
           << " degrees from one to the next, like chords of a curve that the "
           << "mesh file does not tell. New nodes (" << cause
           << ") lie on the chords, and the contact pressure shows it (7 % in "
           << "a case). Make the mesh finer where it comes from, with Element "
           << "degree = 1, or take a mesh of the program, whose curves stay "
           << "round.\n";
      return text.str();
    }
  } // namespace



  template <int dim>
  std::string
  mesh_warnings(const Problem<dim> &problem)
  {
    const auto &contact = problem.contact_parameters;
    std::string text;
    for (unsigned int p = 0; p < contact.pairs.size(); ++p)
      for (const std::string &side : sides_of(contact.pairs[p]))
        {
          const std::size_t dot = side.find('.');
          const Body<dim>  &body =
            problem.solid->body(Utilities::trim(side.substr(0, dot)),
                                "Contact / Pairs");
          const std::string boundary = Utilities::trim(side.substr(dot + 1));
          const std::string found =
            warning(body,
                    boundary,
                    find_chords(body.mesh(),
                                boundary,
                                contact.of_pairs[p].surface.feature_angle),
                    problem);
          if (text.find(found) == std::string::npos)
            text += found;
        }
    return text;
  }



#define INSTANTIATE(dim) \
  template std::string mesh_warnings(const Problem<dim> &);
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
