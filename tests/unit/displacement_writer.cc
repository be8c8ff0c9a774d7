#include <signorini/input/input_error.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/test/unit_test.hpp>

#include <cstring>

#include "contains.h"
#include "stored_run.h"

BOOST_AUTO_TEST_SUITE(displacement_writer)

using namespace dealii;
using namespace Signorini;

namespace
{
  // Two bodies; the displacement is `factor` times the position.
  struct Run
  {
    Run()
      : a(test_body<2>(""))
      , b(test_body<2>("set Element degree = 2\n"))
      , writer(folder.path.string())
    {}

    void
    write(const double time, const double factor)
    {
      const auto field = [factor](const Point<2> &x, const unsigned int c) {
        return factor * x[c];
      };
      const Vector<double> of_a = at_nodes(*a, field);
      const Vector<double> of_b = at_nodes(*b, field);
      writer.write({{"gear 1", &a->dof_handler(), &a->mapping(), &of_a},
                    {"b", &b->dof_handler(), &b->mapping(), &of_b}},
                   time);
    }

    std::string
    index() const
    {
      return read_file(folder.file("displacements.csv"));
    }

    double
    at(const double time, const std::string &body = "gear 1") const
    {
      return DisplacementHistory<2>(folder.path.string(),
                                    body,
                                    {Point<2>(0.5, 0.25)},
                                    TimeInterpolation::linear)
        .values(time)[0][1];
    }

    // The message of the reader, or nothing.
    template <int dim = 2>
    std::string
    error(const std::string &body = "gear 1", const double time = 0.) const
    {
      try
        {
          DisplacementHistory<dim>(folder.path.string(),
                                   body,
                                   {Point<dim>()},
                                   TimeInterpolation::linear)
            .values(time);
        }
      catch (const InputError &error)
        {
          return error.what();
        }
      return "";
    }

    TemporaryFolder          folder;
    std::unique_ptr<Body<2>> a, b;
    DisplacementWriter<2>    writer;
  };

  std::set<std::string>
  files_in(const TemporaryFolder &folder)
  {
    std::set<std::string> names;
    for (const auto &entry : std::filesystem::directory_iterator(folder.path))
      names.insert(entry.path().filename().string());
    return names;
  }

  const std::string head  = "time [s],body,mesh,displacement\n";
  const std::string row_a = "0,gear 1,gear_1_00000_mesh.displacement,"
                            "gear_1_00000.displacement\n";
  const std::string row_b =
    "0,b,b_00000_mesh.displacement,b_00000.displacement\n";
} // namespace



BOOST_AUTO_TEST_CASE(files)
{
  Run run;
  run.write(0., 1.);
  BOOST_TEST(run.index() == head + row_a + row_b);
  run.write(0.1, 2.);
  BOOST_TEST(run.index() ==
             head + row_a + row_b +
               "0.1,gear 1,gear_1_00000_mesh.displacement,"
               "gear_1_00001.displacement\n"
               "0.1,b,b_00000_mesh.displacement,b_00001.displacement\n");
  BOOST_TEST(files_in(run.folder) ==
               (std::set<std::string>{".signorini-files",
                                      "b_00000.displacement",
                                      "b_00000_mesh.displacement",
                                      "b_00001.displacement",
                                      "displacements.csv",
                                      "gear_1_00000.displacement",
                                      "gear_1_00000_mesh.displacement",
                                      "gear_1_00001.displacement"}),
             boost::test_tools::per_element());
  BOOST_TEST(run.at(0.1) == 0.5);
  BOOST_TEST(run.at(0.05, "b") == 0.375);

  // Full precision: pi comes back as it is.
  run.write(0.2, numbers::PI);
  BOOST_TEST(run.at(0.2, "b") == 0.25 * numbers::PI);
  const std::string content =
    read_file(run.folder.file("b_00002.displacement"));
  const std::string line = "signorini displacement 1 dimension 2 nodes 9\n";
  BOOST_TEST(content.substr(0, line.size()) == line);
  BOOST_TEST(content.size() == line.size() + 9 * 2 * 8);

  // Another mesh gets a file, the other body none.
  run.a = test_body<2>("set Global refinements = 1\n");
  run.write(0.3, 4.);
  BOOST_TEST(files_in(run.folder).count("gear_1_00003_mesh.displacement") ==
             1u);
  BOOST_TEST(files_in(run.folder).count("b_00003_mesh.displacement") == 0u);
  BOOST_TEST(run.at(0.3) == 1.);
  BOOST_TEST(run.at(0.1) == 0.5);
}

BOOST_AUTO_TEST_CASE(after_a_checkpoint)
{
  Run run;
  run.write(0., 1.);
  std::stringstream checkpoint;
  {
    boost::archive::binary_oarchive archive(checkpoint);
    archive                        &run.writer;
  }
  const std::set<std::string> before = files_in(run.folder);
  run.a = test_body<2>("set Global refinements = 1\n");
  run.write(0.1, 7.);
  run.write(0.2, 8.);

  DisplacementWriter<2> resumed(run.folder.path.string());
  {
    boost::archive::binary_iarchive archive(checkpoint);
    archive                        &resumed;
  }
  resumed.cut_back();
  BOOST_TEST(files_in(run.folder) == before, boost::test_tools::per_element());
  BOOST_TEST(run.index() == head + row_a + row_b);

  const Vector<double> u =
    at_nodes(*run.b,
             [](const Point<2> &x, const unsigned int c) { return 3. * x[c]; });
  resumed.write({{"b", &run.b->dof_handler(), &run.b->mapping(), &u}}, 0.1);
  BOOST_TEST(run.at(0.1, "b") == 0.75);
  BOOST_TEST(run.at(0., "b") == 0.25);
  BOOST_TEST(run.at(0.) == 0.25);
}

BOOST_AUTO_TEST_CASE(no_place_to_write)
{
  Run run;
  run.write(0., 1.);
  // Where a file should be there is a folder.
  std::filesystem::create_directory(run.folder.file("b_00001.displacement"));
  try
    {
      run.write(0.1, 2.);
      BOOST_ERROR("nothing was thrown");
    }
  catch (const ComputationError &error)
    {
      BOOST_TEST(contains(error.what(), "b_00001.displacement"), error.what());
    }
  // The list names only what is there.
  BOOST_TEST(run.index() == head + row_a + row_b);

  const Vector<double> u(run.a->n_dofs());
  const auto named = [&](const std::string &name) -> BodyDisplacement<2> {
    return {name, &run.a->dof_handler(), &run.a->mapping(), &u};
  };
  BOOST_CHECK_THROW(run.writer.write({named("a b"), named("a_b")}, 1.),
                    InputError);
}

BOOST_AUTO_TEST_CASE(what_a_reader_refuses)
{
  Run               run;
  const std::string folder = run.folder.path.string();
  const auto holds = [&](const std::string &error, const std::string &part) {
    BOOST_TEST(contains(error, folder), error);
    BOOST_TEST(contains(error, part), error);
  };
  holds(run.error(), "has no file 'displacements.csv'");
  run.write(0., 1.);
  BOOST_TEST(run.error() == "");

  holds(run.error("gaer 1"), "no displacements of a body \"gaer 1\"");
  holds(run.error("gaer 1"), "those of: gear 1, b. Did you mean \"gear 1\"?");
  holds(run.error<3>(),
        "comes from a run of dimension 2, but this one has "
        "dimension 3");

  const std::string index = run.folder.file("displacements.csv");
  const std::string good  = run.index();
  write_file(index, "time,x\n");
  holds(run.error(), "is no list of displacements");
  for (const std::string line : {"zero,gear 1,m,d",
                                 "0 s,gear 1,m,d",
                                 "nan,gear 1,m,d",
                                 "0,gear 1,m",
                                 "0"})
    {
      write_file(index, good + line + "\n");
      holds(run.error(), "cannot understand the line \"" + line + "\"");
    }
  write_file(index, good + "-1" + row_a.substr(1));
  holds(run.error(), "the times of body \"gear 1\" do not ascend");
  write_file(index, head);
  holds(run.error(), "It has those of: none.");
  write_file(index, good);

  for (const std::string name :
       {"gear_1_00000.displacement", "gear_1_00000_mesh.displacement"})
    {
      const std::string file    = run.folder.file(name);
      const std::string content = read_file(file);
      for (const std::string &wrong :
           {content.substr(0, content.size() - 1), content + "x"})
        {
          write_file(file, wrong);
          holds(run.error(), name + "' is damaged, or not complete");
        }
      write_file(file, "");
      holds(run.error(), name + "' is no file of this kind");
      std::string later              = content;
      later[content.find(" 1 ") + 1] = '2';
      write_file(file, later);
      holds(run.error(), name + "' is no file of this kind");
      std::filesystem::remove(file);
      holds(run.error(), name + "' cannot be read");
      write_file(file, content);
      BOOST_TEST(run.error() == "");
    }

  // A cell whose nodes do not exist; the displacements of another mesh.
  const std::string mesh = run.folder.file("gear_1_00000_mesh.displacement");
  const std::string mesh_content = read_file(mesh);
  std::string       wild         = mesh_content;
  wild.replace(wild.size() - 4, 4, "\xff\xff\xff\x00", 4);
  write_file(mesh, wild);
  holds(run.error(), "is damaged");
  write_file(mesh, read_file(run.folder.file("b_00000_mesh.displacement")));
  holds(run.error(), "does not fit to the mesh");
}

BOOST_AUTO_TEST_SUITE_END()
