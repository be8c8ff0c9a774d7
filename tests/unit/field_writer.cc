#include <signorini/input/input_error.h>
#include <signorini/output/field_writer.h>

#include <deal.II/base/function_parser.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/tria.h>
#include <deal.II/numerics/vector_tools.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/test/unit_test.hpp>

#include "temporary_folder.h"
#include "vtu_reader.h"

BOOST_AUTO_TEST_SUITE(field_writer)

using namespace dealii;
using namespace Signorini;

namespace
{
  // Polynomials of degree 2 in each coordinate: Q2 has them exactly, Q1 at
  // its nodes, and only nodes are in the file.
  template <int dim>
  double
  exact_displacement(const Point<dim> &x, const unsigned int component)
  {
    return component == 0 ? 1e-3 * x[0] * x[0] + x[1] : x[dim - 1] - x[0];
  }

  template <int dim>
  class Displacement : public Function<dim>
  {
  public:
    Displacement()
      : Function<dim>(dim)
    {}

    double
    value(const Point<dim> &x, const unsigned int component) const override
    {
      return exact_displacement(x, component);
    }
  };

  template <int dim>
  class VonMises : public Function<dim>
  {
  public:
    double
    value(const Point<dim> &x, const unsigned int = 0) const override
    {
      return 3e8 * (1. + x[0] * x[1]);
    }
  };

  template <int dim>
  struct Body
  {
    Body(const std::string &name, const unsigned int degree)
      : fe(FE_Q<dim>(degree), dim)
      , scalar_fe(degree)
      , dof_handler(triangulation)
      , scalar_dof_handler(triangulation)
    {
      std::vector<unsigned int> n_cells(dim, 1);
      n_cells[0] = 3;
      n_cells[1] = 2;
      Point<dim> corner;
      corner[0] = 3.;
      for (unsigned int d = 1; d < dim; ++d)
        corner[d] = d == 1 ? 2. : 1.;
      GridGenerator::subdivided_hyper_rectangle(triangulation,
                                                n_cells,
                                                Point<dim>(),
                                                corner);
      dof_handler.distribute_dofs(fe);
      scalar_dof_handler.distribute_dofs(scalar_fe);
      displacement.reinit(dof_handler.n_dofs());
      von_mises.reinit(scalar_dof_handler.n_dofs());
      VectorTools::interpolate(dof_handler, Displacement<dim>(), displacement);
      VectorTools::interpolate(scalar_dof_handler, VonMises<dim>(), von_mises);
      velocity = displacement;
      velocity *= -2.;
      fields.name               = name;
      fields.dof_handler        = &dof_handler;
      fields.displacement       = &displacement;
      fields.velocity           = &velocity;
      fields.scalar_dof_handler = &scalar_dof_handler;
      fields.nodal_fields       = {{"von_mises", &von_mises}};
    }

    Triangulation<dim> triangulation;
    FESystem<dim>      fe;
    FE_Q<dim>          scalar_fe;
    DoFHandler<dim>    dof_handler;
    DoFHandler<dim>    scalar_dof_handler;
    Vector<double>     displacement;
    Vector<double>     velocity;
    Vector<double>     von_mises;
    BodyFields<dim>    fields;
  };

  // Single precision: 1e-6 of the largest value, which is 10 and 2.1e9.
  template <int dim>
  void
  check_values(const VtuReader &vtu)
  {
    const std::vector<double> points       = vtu.array("Points");
    const std::vector<double> displacement = vtu.array("displacement");
    const std::vector<double> velocity     = vtu.array("velocity");
    const std::vector<double> von_mises    = vtu.array("von_mises");
    const unsigned int        n            = vtu.number("NumberOfPoints");
    BOOST_REQUIRE(points.size() == 3 * n);
    BOOST_REQUIRE(displacement.size() == 3 * n);
    BOOST_REQUIRE(velocity.size() == 3 * n);
    BOOST_REQUIRE(von_mises.size() == n);

    double largest_error = 0.;
    for (unsigned int i = 0; i < n; ++i)
      {
        Point<dim> x;
        for (unsigned int d = 0; d < dim; ++d)
          x[d] = points[3 * i + d];
        for (unsigned int d = 0; d < 3; ++d)
          {
            const double u = d < dim ? exact_displacement(x, d) : 0.;
            largest_error =
              std::max({largest_error,
                        std::abs(displacement[3 * i + d] - u) / 10.,
                        std::abs(velocity[3 * i + d] + 2. * u) / 10.});
          }
        largest_error =
          std::max(largest_error,
                   std::abs(von_mises[i] - VonMises<dim>().value(x)) / 2.1e9);
      }
    BOOST_TEST(largest_error < 1e-6);
    BOOST_TEST(*std::max_element(points.begin(), points.end()) == 3.);
    BOOST_TEST(*std::min_element(points.begin(), points.end()) == 0.);
  }

  template <int dim>
  void
  check_body(const unsigned int degree, const unsigned int n_cells)
  {
    const TemporaryFolder folder;
    const Body<dim>       body("beam", degree);
    FieldWriter<dim>      writer(folder.path.string());
    writer.write({body.fields}, 0.25);

    const std::string text = read_file(folder.file("beam_00000.vtu"));
    const VtuReader   vtu(text);
    BOOST_TEST(vtu.number("NumberOfCells") == n_cells);
    BOOST_TEST(vtu.n_components("displacement") == 3u);
    BOOST_TEST(vtu.n_components("von_mises") == 1u);
    BOOST_TEST(vtu.array("TIME") == std::vector<double>{0.25});
    check_values<dim>(vtu);
  }
} // namespace



BOOST_AUTO_TEST_CASE(linear_elements)
{
  check_body<2>(1, 6);
  check_body<3>(1, 6);
}

BOOST_AUTO_TEST_CASE(quadratic_elements_show_all_nodes)
{
  check_body<2>(2, 24);
  check_body<3>(2, 48);
}

BOOST_AUTO_TEST_CASE(a_collection_of_bodies_over_time)
{
  const TemporaryFolder folder;
  const Body<2>         beam("thin beam", 1);
  const Body<2>         block("block", 1);
  FieldWriter<2>        writer(folder.path.string());

  const auto line = [](const std::string &time,
                       const std::string &part,
                       const std::string &name,
                       const std::string &file) {
    return "    <DataSet timestep=\"" + time + "\" part=\"" + part +
           "\" name=\"" + name + "\" file=\"" + file + "\"/>\n";
  };
  const std::string begin =
    "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" "
    "byte_order=\"LittleEndian\">\n  <Collection>\n";
  const std::string end   = "  </Collection>\n</VTKFile>\n";
  const std::string first = line("0", "0", "thin beam", "thin_beam_00000.vtu") +
                            line("0", "1", "block", "block_00000.vtu");
  const std::string second =
    line("0.1", "0", "thin beam", "thin_beam_00001.vtu") +
    line("0.1", "1", "block", "block_00001.vtu");

  // Complete after every output.
  writer.write({beam.fields, block.fields}, 0.);
  BOOST_TEST(read_file(folder.file("results.pvd")) == begin + first + end);
  writer.write({beam.fields, block.fields}, 0.1);
  BOOST_TEST(read_file(folder.file("results.pvd")) ==
             begin + first + second + end);
  BOOST_TEST(writer.collection().n_outputs() == 2u);
  // Four VTU files, one collection and the list of them, nothing else.
  const auto n_files =
    std::distance(std::filesystem::directory_iterator(folder.path),
                  std::filesystem::directory_iterator());
  BOOST_TEST(n_files == 6);
}

// Saved after one output, resumed after three: the later two are gone.
BOOST_AUTO_TEST_CASE(going_on_from_a_checkpoint)
{
  const TemporaryFolder folder;
  const Body<2>         body("thin beam", 1);
  std::stringstream     stream;
  FieldWriter<2>        writer(folder.path.string());
  writer.write({body.fields}, 0.);
  {
    boost::archive::binary_oarchive archive(stream);
    archive << std::as_const(writer).collection();
  }
  const std::string saved = read_file(folder.file("results.pvd"));
  writer.write({body.fields}, 0.1);
  writer.write({body.fields}, 0.2);
  const std::string whole = read_file(folder.file("results.pvd"));

  FieldWriter<2> resumed(folder.path.string());
  boost::archive::binary_iarchive(stream) >> resumed.collection();
  resumed.collection().cut_back();
  BOOST_TEST(resumed.collection().n_outputs() == 1u);
  BOOST_TEST(read_file(folder.file("results.pvd")) == saved);
  BOOST_TEST(std::filesystem::exists(folder.file("thin_beam_00000.vtu")));
  BOOST_TEST(!std::filesystem::exists(folder.file("thin_beam_00001.vtu")));
  BOOST_TEST(!std::filesystem::exists(folder.file("thin_beam_00002.vtu")));
  resumed.write({body.fields}, 0.1);
  resumed.write({body.fields}, 0.2);
  BOOST_TEST(read_file(folder.file("results.pvd")) == whole);
}

BOOST_AUTO_TEST_CASE(velocity_and_nodal_fields_may_be_missing)
{
  const TemporaryFolder folder;
  const Body<2>         body("beam", 1);
  BodyFields<2>         fields = body.fields;
  fields.velocity              = nullptr;
  fields.scalar_dof_handler    = nullptr;
  fields.nodal_fields.clear();
  FieldWriter<2>(folder.path.string()).write({fields}, 0.);
  const VtuReader vtu(read_file(folder.file("beam_00000.vtu")));
  BOOST_TEST(vtu.has_array("displacement"));
  BOOST_TEST(!vtu.has_array("velocity"));
  BOOST_TEST(!vtu.has_array("von_mises"));
}

BOOST_AUTO_TEST_CASE(errors)
{
  const TemporaryFolder folder;
  const Body<2>         body("a b", 1);
  const Body<2>         twin("a_b", 1);
  FieldWriter<2>        writer(folder.path.string());
  BOOST_CHECK_THROW(writer.write({body.fields, twin.fields}, 0.), InputError);
  FieldWriter<2> lost(folder.file("nowhere"));
  BOOST_CHECK_THROW(lost.write({body.fields}, 0.), InputError);
  BOOST_CHECK_THROW(write_result_file("/dev/full", "text"), ComputationError);
}

BOOST_AUTO_TEST_SUITE_END()
