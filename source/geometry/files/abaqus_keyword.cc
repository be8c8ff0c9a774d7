#include <signorini/geometry/files/abaqus_keyword.h>

#include <deal.II/base/utilities.h>

#include <cctype>

namespace Signorini
{
  using namespace dealii;

  AbaqusKeyword
  parse_abaqus_keyword(const std::string &line)
  {
    const std::vector<std::string> words =
      Utilities::split_string_list(line.substr(1), ',');

    AbaqusKeyword keyword;
    keyword.name = upper_case(words.empty() ? "" : words[0]);
    for (unsigned int i = 1; i < words.size(); ++i)
      {
        const std::size_t equal = words[i].find('=');
        const std::string name =
          upper_case(Utilities::trim(words[i].substr(0, equal)));
        std::string value;
        if (equal != std::string::npos)
          value = Utilities::trim(words[i].substr(equal + 1));
        if (value.size() > 1 && value.front() == '"' && value.back() == '"')
          value = value.substr(1, value.size() - 2);
        keyword.options[name] = value;
      }
    return keyword;
  }



  std::optional<AbaqusElement>
  abaqus_element(const std::string &type)
  {
    // A type is a family, the number of nodes, and letters for the variant.
    // Longer families come first: CPEG4 is not CPE followed by something.
    const std::vector<std::pair<std::string, bool>> families = {{"SFM3D",
                                                                 false},
                                                                {"CPEG", false},
                                                                {"CGAX", false},
                                                                {"STRI", false},
                                                                {"C3D", true},
                                                                {"CPS", false},
                                                                {"CPE", false},
                                                                {"CAX", false},
                                                                {"M3D", false},
                                                                {"R3D", false},
                                                                {"S", false}};
    const std::string                               name     = upper_case(type);

    if (name.rfind("T2D2", 0) == 0 || name.rfind("T3D2", 0) == 0 ||
        name.rfind("B21", 0) == 0 || name.rfind("B31", 0) == 0)
      return AbaqusElement{ElementKind::line, 2};
    if (name.rfind("T2D3", 0) == 0 || name.rfind("T3D3", 0) == 0 ||
        name.rfind("B22", 0) == 0 || name.rfind("B32", 0) == 0)
      return AbaqusElement{ElementKind::higher_order, 3};

    for (const auto &[family, is_solid] : families)
      {
        std::size_t end = family.size();
        while (end < name.size() && std::isdigit(name[end]) != 0)
          ++end;
        if (name.rfind(family, 0) != 0 || end == family.size() ||
            end > family.size() + 2)
          continue;

        const unsigned int n = std::stoi(name.substr(family.size()));
        if (is_solid)
          switch (n)
            {
              case 4:
                return AbaqusElement{ElementKind::tetrahedron, n};
              case 5:
                return AbaqusElement{ElementKind::pyramid, n};
              case 6:
                return AbaqusElement{ElementKind::prism, n};
              case 8:
                return AbaqusElement{ElementKind::hexahedron, n};
              default:
                return AbaqusElement{ElementKind::higher_order, n};
            }
        return AbaqusElement{n == 3 ? ElementKind::triangle :
                             n == 4 ? ElementKind::quadrilateral :
                                      ElementKind::higher_order,
                             n};
      }
    return std::nullopt;
  }



  std::vector<unsigned int>
  abaqus_face_corners(const ElementKind kind, const unsigned int face)
  {
    const std::vector<std::vector<unsigned int>> hexahedron = {{0, 1, 2, 3},
                                                               {4, 7, 6, 5},
                                                               {0, 4, 5, 1},
                                                               {1, 5, 6, 2},
                                                               {2, 6, 7, 3},
                                                               {3, 7, 4, 0}};
    if (kind == ElementKind::quadrilateral && face < 4)
      return {face, (face + 1) % 4};
    if (kind == ElementKind::hexahedron && face < 6)
      return hexahedron[face];
    return {};
  }



  std::string
  upper_case(const std::string &text)
  {
    std::string result = text;
    for (char &letter : result)
      letter =
        static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
    return result;
  }
} // namespace Signorini
