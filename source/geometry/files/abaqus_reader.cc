#include <signorini/geometry/files/abaqus_keyword.h>
#include <signorini/geometry/files/abaqus_reader.h>
#include <signorini/geometry/files/word_reader.h>

#include <deal.II/base/utilities.h>

#include <map>
#include <utility>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    using Words = std::vector<std::string>;

    class AbaqusReader
    {
    public:
      AbaqusReader(const std::string &file_name, const std::string &text);

      MeshData
      read();

    private:
      // A set of elements or a surface, with the name as it was written.
      struct Set
      {
        std::string               name;
        bool                      is_automatic;
        std::vector<unsigned int> elements;
      };

      using Sets = std::map<std::string, Set>;

      void
      begin(const AbaqusKeyword &new_keyword);
      void
      read_data(const std::string &line);
      void
      read_node(const Words &words);
      void
      read_element(const Words &words);
      void
      read_set(const Words &words);
      void
      read_surface(const Words &words);
      void
      add_face(const unsigned int element,
               const unsigned int face,
               Set               &surface);
      std::vector<unsigned int>
      elements_named(const std::string &word) const;
      Set &
      set_named(const std::string &name, const bool is_automatic, Sets &sets);
      void
      add_groups(const Sets &sets);

      WordReader                   lines;
      AbaqusKeyword                keyword;
      ElementKind                  kind    = ElementKind::higher_order;
      unsigned int                 n_nodes = 0; // of the present elements
      Words                        pending;     // an element over several lines
      MeshData                     data;
      std::map<long, unsigned int> node_of_label;
      std::map<long, unsigned int> element_of_label;
      Sets                         sets;     // by name in upper case
      Sets                         surfaces; // the same
    };



    AbaqusReader::AbaqusReader(const std::string &file_name,
                               const std::string &text)
      : lines(file_name, text)
    {
      data.file_name = file_name;
    }



    MeshData
    AbaqusReader::read()
    {
      while (lines.has_word())
        {
          std::string line = lines.line();
          if (line.rfind("**", 0) == 0)
            continue;
          if (line[0] == '*')
            {
              // A keyword goes on in the next line after a comma.
              while (line.back() == ',' && lines.has_word())
                line += lines.line();
              begin(parse_abaqus_keyword(line));
            }
          else if (keyword.name.empty())
            lines.fail("an Abaqus file begins with a keyword such as *NODE.");
          else
            read_data(line);
        }
      if (!pending.empty())
        lines.fail("the file ends within an element; it is not complete.");
      if (data.nodes.empty() || data.elements.empty())
        lines.fail("the file has no *NODE or no *ELEMENT; it is not complete, "
                   "or was saved before the mesh was made.");
      add_groups(sets);
      add_groups(surfaces);
      return std::move(data);
    }



    void
    AbaqusReader::begin(const AbaqusKeyword &new_keyword)
    {
      if (!pending.empty())
        lines.fail("a keyword within an element of " + std::to_string(n_nodes) +
                   " nodes.");
      keyword = new_keyword;
      if (keyword.name == "INCLUDE" || keyword.options.count("INPUT") > 0)
        lines.fail("parts in other files cannot be read. Put everything into "
                   "one file.");
      if (keyword.name == "ELEMENT")
        {
          const std::string type =
            keyword.options.count("TYPE") > 0 ? keyword.options["TYPE"] : "";
          const auto found = abaqus_element(type);
          if (!found)
            lines.fail("the element type \"" + type +
                       "\" is unknown. Cells must be of the types CPS4, CPE4, "
                       "CAX4, S4 (2-D) or C3D8 (3-D), or variants of them.");
          kind    = found->kind;
          n_nodes = found->n_nodes;
        }
      if (keyword.name == "ELSET" && keyword.options.count("ELSET") == 0)
        lines.fail("*ELSET without ELSET=name.");
      if (keyword.name == "SURFACE" && keyword.options.count("NAME") == 0)
        lines.fail("*SURFACE without NAME=name.");
    }



    void
    AbaqusReader::read_data(const std::string &line)
    {
      // A comma at the end of a line only announces the next one.
      const Words words = Utilities::split_string_list(line, ',');
      if (keyword.name == "NODE")
        read_node(words);
      else if (keyword.name == "ELEMENT")
        read_element(words);
      else if (keyword.name == "ELSET")
        read_set(words);
      else if (keyword.name == "SURFACE" &&
               (keyword.options.count("TYPE") == 0 ||
                upper_case(keyword.options["TYPE"]) == "ELEMENT"))
        read_surface(words);
      else if (keyword.name == "INSTANCE")
        lines.fail("an instance that is moved or turned cannot be read. Save "
                   "the part in its place.");
    }



    void
    AbaqusReader::read_node(const Words &words)
    {
      if (words.size() < 3 || words.size() > 4)
        lines.fail("a node needs its number and two or three coordinates.");
      Point<3> node;
      for (unsigned int d = 0; d + 1 < words.size(); ++d)
        node[d] = lines.to_number(words[d + 1], "a coordinate");
      const long label = lines.to_integer(words[0], "the number of a node");
      if (!node_of_label.insert({label, data.nodes.size()}).second)
        lines.fail("the node " + words[0] +
                   " appears twice. Only one part can be read.");
      data.nodes.push_back(node);
    }



    void
    AbaqusReader::read_element(const Words &words)
    {
      pending.insert(pending.end(), words.begin(), words.end());
      if (pending.size() < n_nodes + 1)
        return;
      if (pending.size() > n_nodes + 1)
        lines.fail("an element of this type has a number and " +
                   std::to_string(n_nodes) + " nodes, but here are " +
                   std::to_string(pending.size()) + " numbers.");

      MeshData::Element element;
      element.kind = kind;
      element.nodes.fill(0);
      for (unsigned int i = 0; i < n_nodes; ++i)
        {
          const auto node = node_of_label.find(
            lines.to_integer(pending[i + 1], "the number of a node"));
          if (node == node_of_label.end())
            lines.fail("there is no node " + pending[i + 1] +
                       ". Save the mesh again, with all its nodes.");
          if (i < element.nodes.size())
            element.nodes[i] = node->second;
        }
      const unsigned int index = data.elements.size();
      const long         label =
        lines.to_integer(pending[0], "the number of an element");
      if (!element_of_label.insert({label, index}).second)
        lines.fail("the element " + pending[0] +
                   " appears twice. Only one part can be read.");
      data.elements.push_back(element);
      if (keyword.options.count("ELSET") > 0)
        set_named(keyword.options["ELSET"], true, sets)
          .elements.push_back(index);
      pending.clear();
    }



    void
    AbaqusReader::read_set(const Words &words)
    {
      Set &set = set_named(keyword.options["ELSET"], false, sets);
      if (keyword.options.count("GENERATE") == 0)
        {
          for (const std::string &word : words)
            for (const unsigned int element : elements_named(word))
              set.elements.push_back(element);
          return;
        }

      if (words.size() < 2 || words.size() > 3)
        lines.fail("GENERATE needs the first and the last element, and perhaps "
                   "an increment.");
      const std::string what  = "the number of an element";
      const long        first = lines.to_integer(words[0], what);
      const long        last  = lines.to_integer(words[1], what);
      const long        increment =
        words.size() == 3 ? lines.to_integer(words[2], "an increment") : 1;
      if (increment < 1)
        lines.fail("the increment must be at least 1.");
      // Not label by label: a wrong last one could be far away.
      for (auto label = element_of_label.lower_bound(first);
           label != element_of_label.end() && label->first <= last;
           ++label)
        if ((label->first - first) % increment == 0)
          set.elements.push_back(label->second);
    }



    void
    AbaqusReader::read_surface(const Words &words)
    {
      Set &surface = set_named(keyword.options["NAME"], false, surfaces);
      const std::string side    = words.size() == 2 ? upper_case(words[1]) : "";
      const bool        is_face = side.size() == 2 &&
                           (side[0] == 'S' || side[0] == 'E') &&
                           side[1] >= '1' && side[1] <= '6';
      if (!is_face)
        lines.fail("a line of a surface is an element, or a set of elements, "
                   "and one of its faces S1 to S6.");
      for (const unsigned int element : elements_named(words[0]))
        add_face(element, side[1] - '1', surface);
    }



    void
    AbaqusReader::add_face(const unsigned int element,
                           const unsigned int face,
                           Set               &surface)
    {
      // A copy, because the list of elements grows.
      const MeshData::Element         cell = data.elements[element];
      const std::vector<unsigned int> corners =
        abaqus_face_corners(cell.kind, face);
      if (corners.empty())
        lines.fail("this element has no face " + std::to_string(face + 1) +
                   ".");

      MeshData::Element side;
      side.kind =
        corners.size() == 2 ? ElementKind::line : ElementKind::quadrilateral;
      side.nodes.fill(0);
      for (unsigned int i = 0; i < corners.size(); ++i)
        side.nodes[i] = cell.nodes[corners[i]];
      surface.elements.push_back(data.elements.size());
      data.elements.push_back(side);
    }



    std::vector<unsigned int>
    AbaqusReader::elements_named(const std::string &word) const
    {
      const auto set = sets.find(upper_case(word));
      if (set != sets.end())
        return set->second.elements;
      if (word.find_first_not_of("0123456789") != std::string::npos)
        lines.fail("there is no element or set of elements \"" + word +
                   "\" before this line.");
      const auto element = element_of_label.find(
        lines.to_integer(word, "the number of an element"));
      if (element == element_of_label.end())
        lines.fail("there is no element " + word + ".");
      return {element->second};
    }



    AbaqusReader::Set &
    AbaqusReader::set_named(const std::string &name,
                            const bool         is_automatic,
                            Sets              &where)
    {
      Set &set = where.insert({upper_case(name), {name, is_automatic, {}}})
                   .first->second;
      set.is_automatic = set.is_automatic && is_automatic;
      return set;
    }



    void
    AbaqusReader::add_groups(const Sets &named_sets)
    {
      // A set may hold cells and elements on the surface.
      for (const auto &[key, set] : named_sets)
        for (unsigned int d = 1; d <= 3; ++d)
          {
            MeshData::Group group = {set.name, d, set.is_automatic, {}};
            for (const unsigned int element : set.elements)
              if (dimension(data.elements[element].kind) == d)
                group.elements.push_back(element);
            if (!group.elements.empty())
              data.groups.push_back(group);
          }
    }
  } // namespace



  MeshData
  read_abaqus(const std::string &file_name, const std::string &text)
  {
    return AbaqusReader(file_name, text).read();
  }
} // namespace Signorini
