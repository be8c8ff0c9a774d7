#include <signorini/geometry/files/gmsh_reader.h>
#include <signorini/geometry/files/word_reader.h>

#include <cmath>
#include <map>
#include <utility>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // Dimension and number, of a physical group or of an entity.
    using Tag = std::pair<unsigned int, long>;

    struct ElementType
    {
      ElementKind  kind;
      unsigned int n_nodes;
    };

    // Gmsh's numbers of the types of elements.
    const std::map<long, ElementType> &
    element_types()
    {
      const auto higher_order = ElementKind::higher_order;

      static const std::map<long, ElementType> list = {
        {1, {ElementKind::line, 2}},
        {2, {ElementKind::triangle, 3}},
        {3, {ElementKind::quadrilateral, 4}},
        {4, {ElementKind::tetrahedron, 4}},
        {5, {ElementKind::hexahedron, 8}},
        {6, {ElementKind::prism, 6}},
        {7, {ElementKind::pyramid, 5}},
        {8, {higher_order, 3}},
        {9, {higher_order, 6}},
        {10, {higher_order, 9}},
        {11, {higher_order, 10}},
        {12, {higher_order, 27}},
        {13, {higher_order, 18}},
        {14, {higher_order, 14}},
        {15, {ElementKind::point, 1}},
        {16, {higher_order, 8}},
        {17, {higher_order, 20}},
        {18, {higher_order, 15}},
        {19, {higher_order, 13}}};
      return list;
    }

    class GmshReader
    {
    public:
      GmshReader(const std::string &file_name, const std::string &text);

      MeshData
      read();

    private:
      void
      read_format();
      void
      read_names();
      void
      read_entities();
      void
      read_nodes_2();
      void
      read_nodes_4();
      void
      read_elements_2();
      void
      read_elements_4();
      void
      read_node(const long label);
      void
      read_element(const long type, const std::vector<Tag> &groups);
      void
      read_section(const std::string &name);
      void
      skip_section(const std::string &name);
      void
      expect(const std::string &word);

      WordReader                      words;
      MeshData                        data;
      bool                            is_format_4 = false;
      std::map<Tag, std::string>      names;
      std::map<Tag, std::vector<Tag>> groups_of_entity;
      std::map<long, unsigned int>    node_of_label;
      std::map<Tag, MeshData::Group>  groups;
    };



    GmshReader::GmshReader(const std::string &file_name,
                           const std::string &text)
      : words(file_name, text)
    {
      data.file_name = file_name;
    }



    MeshData
    GmshReader::read()
    {
      if (!words.has_word() || words.word("$MeshFormat") != "$MeshFormat")
        words.fail("a Gmsh file begins with $MeshFormat. In Gmsh save the mesh "
                   "as \"Version 4.1 ASCII\" or \"Version 2 ASCII\".");
      read_section("$MeshFormat");
      while (words.has_word())
        read_section(words.word("a section"));

      if (node_of_label.empty() || data.elements.empty())
        words.fail("the file has no $Nodes or no $Elements; it is not "
                   "complete, or was saved before the mesh was made.");
      for (auto &[tag, group] : groups)
        {
          const auto name = names.find(tag);
          group.name =
            name != names.end() ? name->second : std::to_string(tag.second);
          data.groups.push_back(group);
        }
      return std::move(data);
    }



    void
    GmshReader::read_section(const std::string &name)
    {
      if (name == "$MeshFormat")
        read_format();
      else if (name == "$PhysicalNames")
        read_names();
      else if (name == "$Entities")
        read_entities();
      else if (name == "$Nodes")
        is_format_4 ? read_nodes_4() : read_nodes_2();
      else if (name == "$Elements")
        is_format_4 ? read_elements_4() : read_elements_2();
      else if (name == "$PartitionedEntities")
        words.fail("the mesh is partitioned. Save it without partitions.");
      else if (name[0] == '$')
        return skip_section(name);
      else
        words.fail("found \"" + name + "\" where a section should begin.");
      expect("$End" + name.substr(1));
    }



    void
    GmshReader::skip_section(const std::string &name)
    {
      const std::string end = "$End" + name.substr(1);
      while (words.word(end) != end)
        ;
    }



    void
    GmshReader::expect(const std::string &word)
    {
      const std::string found = words.word(word);
      if (found != word)
        words.fail("found \"" + found + "\" instead of " + word +
                   "; the numbers in this section do not fit together.");
    }



    void
    GmshReader::read_format()
    {
      const double version   = words.number("the version of the format");
      const long   file_type = words.integer("the type of the file");
      words.integer("the size of a number");
      is_format_4 = version == 4.1;
      if (!is_format_4 && !(version >= 2. && version < 3.))
        words.fail("this is a file in Gmsh's format " +
                   std::to_string(version).substr(0, 3) +
                   "; 2.2 and 4.1 can be read. In Gmsh set "
                   "Mesh.MshFileVersion=4.1 and save again.");
      if (file_type != 0)
        words.fail("this is a binary file. In Gmsh set Mesh.Binary=0 and save "
                   "again.");
    }



    void
    GmshReader::read_names()
    {
      const unsigned int n_names = words.count("the number of names");
      for (unsigned int i = 0; i < n_names; ++i)
        {
          const unsigned int dimension = words.count("a dimension");
          const long         number    = words.integer("a physical tag");
          names[{dimension, number}]   = words.quoted("name");
        }
    }



    void
    GmshReader::read_entities()
    {
      std::array<unsigned int, 4> n_entities;
      for (unsigned int &n : n_entities)
        n = words.count("the number of entities");
      for (unsigned int dimension = 0; dimension < 4; ++dimension)
        for (unsigned int i = 0; i < n_entities[dimension]; ++i)
          {
            const long tag = words.integer("the tag of an entity");
            for (unsigned int k = 0; k < (dimension == 0 ? 3 : 6); ++k)
              words.number("a corner of a bounding box");
            const unsigned int n_groups = words.count("a number of groups");
            for (unsigned int k = 0; k < n_groups; ++k)
              groups_of_entity[{dimension, tag}].push_back(
                {dimension, std::abs(words.integer("a physical tag"))});
            const unsigned int n_parts =
              dimension == 0 ? 0 : words.count("a number of entities");
            for (unsigned int k = 0; k < n_parts; ++k)
              words.integer("the tag of an entity");
          }
    }



    void
    GmshReader::read_node(const long label)
    {
      Point<3> node;
      for (unsigned int d = 0; d < 3; ++d)
        node[d] = words.number("a coordinate");
      if (!node_of_label.insert({label, data.nodes.size()}).second)
        words.fail("the node " + std::to_string(label) + " appears twice.");
      data.nodes.push_back(node);
    }



    void
    GmshReader::read_nodes_2()
    {
      const unsigned int n_nodes = words.count("the number of nodes");
      for (unsigned int i = 0; i < n_nodes; ++i)
        read_node(words.integer("the number of a node"));
    }



    void
    GmshReader::read_nodes_4()
    {
      const unsigned int n_blocks = words.count("the number of blocks");
      for (unsigned int i = 0; i < 3; ++i)
        words.count("a number of nodes");
      for (unsigned int block = 0; block < n_blocks; ++block)
        {
          const unsigned int dimension = words.count("a dimension");
          words.integer("the tag of an entity");
          const bool         is_parametric = words.integer("0 or 1") != 0;
          const unsigned int n_nodes       = words.count("a number of nodes");
          std::vector<long>  labels;
          for (unsigned int i = 0; i < n_nodes; ++i)
            labels.push_back(words.integer("the number of a node"));
          for (const long label : labels)
            {
              read_node(label);
              for (unsigned int k = 0; is_parametric && k < dimension; ++k)
                words.number("a coordinate");
            }
        }
    }



    void
    GmshReader::read_element(const long              type,
                             const std::vector<Tag> &its_groups)
    {
      const auto found = element_types().find(type);
      if (found == element_types().end())
        words.fail("there is an element of Gmsh's type " +
                   std::to_string(type) +
                   ", which cannot be used; cells must be quadrilaterals or "
                   "hexahedra with nodes in their corners.");

      MeshData::Element element;
      element.kind = found->second.kind;
      element.nodes.fill(0);
      for (unsigned int i = 0; i < found->second.n_nodes; ++i)
        {
          const long label = words.integer("the number of a node");
          const auto node  = node_of_label.find(label);
          if (node == node_of_label.end())
            words.fail("there is no node " + std::to_string(label) +
                       ". Save the mesh again, with all its nodes.");
          if (i < element.nodes.size())
            element.nodes[i] = node->second;
        }
      for (const Tag &tag : its_groups)
        {
          if (element.kind != ElementKind::higher_order &&
              tag.first != Signorini::dimension(element.kind))
            words.fail("the type " + std::to_string(type) +
                       " of this element does not fit the dimension " +
                       std::to_string(tag.first) + " of its group.");
          MeshData::Group &group = groups[tag];
          group.dimension        = tag.first;
          group.is_automatic     = false;
          group.elements.push_back(data.elements.size());
        }
      data.elements.push_back(element);
    }



    void
    GmshReader::read_elements_2()
    {
      const unsigned int n_elements = words.count("the number of elements");
      for (unsigned int i = 0; i < n_elements; ++i)
        {
          words.integer("the number of an element");
          const long         type   = words.integer("the type of an element");
          const unsigned int n_tags = words.count("a number of tags");
          long               group  = 0;
          for (unsigned int k = 0; k < n_tags; ++k)
            {
              const long tag = words.integer("a tag");
              if (k == 0)
                group = std::abs(tag);
            }
          const auto         known = element_types().find(type);
          const unsigned int dimension_of_group =
            known == element_types().end() ? 0 : dimension(known->second.kind);
          read_element(type,
                       group == 0 ?
                         std::vector<Tag>() :
                         std::vector<Tag>{{dimension_of_group, group}});
        }
    }



    void
    GmshReader::read_elements_4()
    {
      const unsigned int n_blocks = words.count("the number of blocks");
      for (unsigned int i = 0; i < 3; ++i)
        words.count("a number of elements");
      for (unsigned int block = 0; block < n_blocks; ++block)
        {
          const unsigned int dimension  = words.count("a dimension");
          const long         entity     = words.integer("the tag of an entity");
          const long         type       = words.integer("a type of elements");
          const unsigned int n_elements = words.count("a number of elements");
          const auto         found = groups_of_entity.find({dimension, entity});
          const std::vector<Tag> its_groups = found != groups_of_entity.end() ?
                                                found->second :
                                                std::vector<Tag>();
          for (unsigned int i = 0; i < n_elements; ++i)
            {
              words.integer("the number of an element");
              read_element(type, its_groups);
            }
        }
    }
  } // namespace



  MeshData
  read_gmsh(const std::string &file_name, const std::string &text)
  {
    return GmshReader(file_name, text).read();
  }
} // namespace Signorini
