#include <deal.II/base/exceptions.h>

#include <boost/test/unit_test.hpp>

#include "mesh_measures.h"
#include "temporary_folder.h"

BOOST_AUTO_TEST_SUITE(mesh_file_errors)

namespace
{
  const std::string folder =
    (std::filesystem::path(__FILE__).parent_path() / "meshes").string();

  std::string
  file_lines(const std::string &name)
  {
    return "set Mesh = file\nsubsection File\n set Name = " + name + "\nend\n";
  }

  std::string
  sample(const std::string &name)
  {
    return read_file(folder + "/" + name);
  }

  // The message for a file with this content.
  template <int dim>
  std::string
  error_of_content(const std::string &content, const std::string &ending)
  {
    const TemporaryFolder temporary;
    write_file(temporary.file("mesh" + ending), content);
    const std::string error =
      error_from<dim>(file_lines("mesh" + ending), temporary.path.string());
    // Every message begins with the file.
    BOOST_TEST((error.empty() || contains(error, "mesh" + ending)));
    return error;
  }

  std::string
  replaced(std::string text, const std::string &from, const std::string &to)
  {
    const std::size_t position = text.find(from);
    BOOST_REQUIRE(position != std::string::npos);
    return text.replace(position, from.size(), to);
  }

  struct NoAbort
  {
    NoAbort()
    {
      dealii::deal_II_exceptions::disable_abort_on_exception();
    }
    ~NoAbort()
    {
      dealii::deal_II_exceptions::enable_abort_on_exception();
    }
  };
} // namespace



BOOST_AUTO_TEST_CASE(wrong_files)
{
  const auto lines = [](const std::string &name) {
    return error_from<2>(file_lines(name), folder);
  };
  BOOST_TEST(contains(lines("plate41.msh"), "there is no file"));
  BOOST_TEST(contains(lines("plate41.msh"), "Did you mean \"plate_41.msh\"?"));
  BOOST_TEST(contains(lines("no_such_folder/a.msh"), "there is no file"));
  BOOST_TEST(contains(lines(""), "File / Name = : the name of a mesh file"));
  BOOST_TEST(contains(lines("plate.geo"), "must end with .msh (Gmsh) or .inp"));
  BOOST_TEST(contains(error_from<2>("set Mesh = file\nsubsection File\n"
                                    "set Name = a.msh\nset Scale = 0\nend\n"),
                      "File / Scale = 0: must be greater than zero"));

  const std::string triangles = lines("triangles.msh");
  BOOST_TEST(contains(triangles, "has triangles"));
  BOOST_TEST(contains(triangles,
                      "Mesh.Algorithm=6; Mesh.RecombineAll=1; "
                      "Mesh.SubdivisionAlgorithm=1"));
  BOOST_TEST(contains(lines("brick.msh"), "is a 3-D mesh"));
  BOOST_TEST(contains(error_from<3>(file_lines("plate_41.msh"), folder),
                      "is a 2-D mesh, but the Formulation needs a 3-D one"));
}

BOOST_AUTO_TEST_CASE(wrong_gmsh_content)
{
  const std::string good  = sample("plate_22.msh");
  const auto        error = [](const std::string &text) {
    return error_of_content<2>(text, ".msh");
  };
  BOOST_TEST(error(good) == "");
  BOOST_TEST(contains(error(""), "is empty"));
  BOOST_TEST(contains(error("some text\n"), "begins with $MeshFormat"));
  BOOST_TEST(
    contains(error(replaced(good, "2.2 0 8", "4.0 0 8")), "format 4.0"));
  BOOST_TEST(contains(error(replaced(good, "2.2 0 8", "2.2 1 8")), "binary"));
  BOOST_TEST(contains(error(replaced(good, "\n3 2 0 0", "\n3 2 O 0")),
                      "found \"O\" instead of a coordinate"));
  BOOST_TEST(contains(error(replaced(good, "\n3 2 0 0", "\n2 2 0 0")),
                      "node 2 appears twice"));
  BOOST_TEST(contains(error(replaced(good, "\n3 2 0 0", "\n3 2 0 0.1")),
                      "must lie in the plane z = 0, but has a corner at (2 0 "
                      "0.1)"));
  BOOST_TEST(contains(error(replaced(good, "\n3 2 0 0", "\n33 2 0 0")),
                      "there is no node 3."));
  BOOST_TEST(contains(error(replaced(good, "$Nodes\n15", "$Nodes\n14")),
                      "instead of $EndNodes"));
  BOOST_TEST(contains(error(replaced(good, "$Nodes\n15", "$Nodes\n16")),
                      "found \"$EndNodes\" instead of the number of a node"));
  BOOST_TEST(contains(error(replaced(good, "$Nodes\n15", "$Nodes\n-1")),
                      "found \"-1\" instead of the number of nodes"));
  // A vertex far beyond its neighbours turns a cell over.
  BOOST_TEST(contains(error(replaced(good, "\n3 2 0 0", "\n3 1.6 0.4 0")),
                      "are twisted or have a corner of 180 degrees"));

  // Line numbers count from 1.
  BOOST_TEST(contains(error("$MeshFormat\n2.2 0\neight\n"), "line 3: found"));
}

BOOST_AUTO_TEST_CASE(wrong_groups)
{
  // The same square with other groups: node 1 to 4 go around.
  const std::string begin = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
                            "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n"
                            "$EndNodes\n$Elements\n";
  const std::string end   = "$EndElements\n";
  const auto        error = [&](const std::string &elements) {
    return error_of_content<2>(begin + elements + end, ".msh");
  };
  BOOST_TEST(error("2\n1 1 2 1 1 1 2\n2 3 2 5 1 1 2 3 4\n") == "");
  BOOST_TEST(contains(error("1\n2 3 2 5 1 1 2 3 4\n"),
                      "no part of the boundary has a name"));
  BOOST_TEST(contains(error("3\n1 1 2 1 1 1 2\n2 1 2 2 1 2 1\n"
                            "3 1 2 2 1 2 3\n"),
                      "is a 1-D mesh"));
  BOOST_TEST(contains(error("4\n1 1 2 1 1 1 2\n2 1 2 2 1 2 1\n"
                            "3 1 2 2 1 2 3\n4 3 2 5 1 1 2 3 4\n"),
                      "\"1\" and \"2\" have a face in common"));
  BOOST_TEST(contains(error("2\n1 1 2 1 1 1 2\n2 3 2 5 1 1 2 2 4\n"),
                      "two corners in the same node, at (1 0 0)"));
  BOOST_TEST(contains(error("2\n1 8 2 1 1 1 2 3\n2 3 2 5 1 1 2 3 4\n"),
                      "Mesh.ElementOrder=1"));
  BOOST_TEST(contains(error("1\n1 93 0 1\n"), "Gmsh's type 93"));
  BOOST_TEST(contains(error("0\n"), "has no $Nodes or no $Elements"));
  // The same cell for each of its groups, as the format 2.2 has it.
  BOOST_TEST(error("3\n1 1 2 1 1 1 2\n2 3 2 5 1 1 2 3 4\n"
                   "3 3 2 6 1 1 2 3 4\n") == "");
  // Three cells on one edge.
  BOOST_TEST(contains(
    error_of_content<2>(
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n8\n1 0 0 0\n2 1 0 0\n"
      "3 1 1 0\n4 0 1 0\n5 1 -1 0\n6 0 -1 0\n7 2 0 0\n8 2 1 0\n$EndNodes\n"
      "$Elements\n3\n1 3 1 1 1 2 3 4\n2 3 1 1 6 5 2 1\n3 3 1 1 1 2 8 7\n" +
        end,
      ".msh"),
    "3 cells share one face"));
}

BOOST_AUTO_TEST_CASE(wrong_abaqus_content)
{
  const std::string good  = sample("square.inp");
  const auto        error = [](const std::string &text) {
    return error_of_content<2>(text, ".inp");
  };
  BOOST_TEST(error(good) == "");
  BOOST_TEST(contains(error("4 1 0 0 0\n"), "begins with a keyword"));
  BOOST_TEST(contains(error(replaced(good, "CPE4R", "CPE3")),
                      "and 3 nodes, but here are 5 numbers"));
  BOOST_TEST(contains(error(replaced(good, "CPE4R", "DASHPOT")),
                      "type \"DASHPOT\" is unknown"));
  BOOST_TEST(contains(error(replaced(good, "101, 1, 2, 5, 4", "101, 1, 2, 5")),
                      "but here are 9 numbers"));
  BOOST_TEST(contains(error(replaced(good, "102, 2,", "102, 22,")),
                      "line 18: there is no node 22."));
  BOOST_TEST(contains(error(replaced(good, "102, 2,", "101, 2,")),
                      "element 101 appears twice"));
  BOOST_TEST(contains(error(replaced(good, "\n 3,  2., 0.", "\n 2,  2., 0.")),
                      "node 2 appears twice"));
  BOOST_TEST(contains(error(replaced(good, "LOWER, S1", "BELOW, S1")),
                      "no element or set of elements \"BELOW\""));
  BOOST_TEST(
    contains(error(replaced(good, "103, S2", "103, S5")), "has no face 5"));
  BOOST_TEST(contains(error(replaced(good, "103, S2", "103")), "S1 to S6"));
  BOOST_TEST(contains(error(replaced(good, "103, S2", "99, S2")),
                      "there is no element 99."));
  BOOST_TEST(contains(
    error(replaced(good, "*Part, name=Square", "*Include, input=a.inp")),
    "parts in other files"));
  BOOST_TEST(contains(error(good.substr(0, good.find("*Element"))),
                      "no *NODE or no *ELEMENT"));
  BOOST_TEST(contains(error(good.substr(0, good.find("*Surface"))),
                      "no part of the boundary has a name"));
  BOOST_TEST(contains(error_of_content<3>(good, ".inp"), "is a 2-D mesh"));
}

BOOST_AUTO_TEST_CASE(files_cut_off_or_spoilt)
{
  // A file that ends too early, at any character, and one with any word
  // replaced, gives a message or, where it does not matter, a mesh; never
  // anything else. Not even in deal.II's own checks, which may stop a program.
  const NoAbort     no_abort;
  const std::string words[] = {"x", "-3", "99999999999", "2"};
  for (const std::string name : {"plate_22.msh", "plate_41.msh", "square.inp"})
    {
      const std::string     ending = name.substr(name.size() - 4);
      const std::string     text   = sample(name);
      const TemporaryFolder temporary;
      const auto            error = [&](const std::string &content) {
        write_file(temporary.file("a" + ending), content);
        return error_from<2>(file_lines("a" + ending), temporary.path.string());
      };
      const std::size_t end =
        ending == ".msh" ? text.find("$EndElements") : text.find("*Surface");
      for (std::size_t n = 0; n < end; n += 3)
        BOOST_TEST(error(text.substr(0, n)) != "", name << " " << n);

      unsigned int n_errors = 0, n_words = 0;
      for (std::size_t begin = 0, stop; begin < text.size(); begin = stop + 1)
        {
          stop = std::min(text.find_first_of(" ,\n", begin), text.size());
          if (stop == begin)
            continue;
          const std::string &word = words[n_words++ % 4];
          n_errors +=
            error(text.substr(0, begin) + word + text.substr(stop)) != "";
        }
      BOOST_TEST(n_errors > n_words / 2);
    }
}

BOOST_AUTO_TEST_SUITE_END()
