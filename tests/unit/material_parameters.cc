#include <boost/test/unit_test.hpp>

#include "material_point.h"
#include "temporary_folder.h"

BOOST_AUTO_TEST_SUITE(material_parameters)

using namespace Signorini;

namespace
{
  const std::string plastic = "set Law = elasto-plastic\n";

  std::string
  message(const std::string &entries, const std::string &base_directory = "")
  {
    try
      {
        test_material(entries, Kinematics::finite_strain, base_directory);
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "";
  }

  bool
  refused(const std::string &entries, const std::string &beginning)
  {
    return message(entries).find("Material / " + beginning) == 0;
  }

  bool
  table_refused(const std::string &table, const std::string &part)
  {
    const std::string text = message(plastic +
                                     "set Hardening = table\n"
                                     "set Hardening table = " +
                                     table + "\n");
    return text.find("Material / Hardening table: ") == 0 &&
           text.find(part) != std::string::npos;
  }
} // namespace



BOOST_AUTO_TEST_CASE(accepted)
{
  for (const std::string law : {"elastic", "neo-Hooke", "elasto-plastic"})
    for (const auto kinematics :
         {Kinematics::small_strain, Kinematics::finite_strain})
      {
        const auto material =
          test_material("set Law = " + law + "\nset Density = 1234\n",
                        kinematics);
        BOOST_TEST((material->kinematics() == kinematics));
        BOOST_TEST(material->density() == 1234.);
        BOOST_TEST(
          material->is_linear() ==
          (kinematics == Kinematics::small_strain && law != "elasto-plastic"));
        BOOST_TEST((material->n_history_values() > 0) ==
                   (law == "elasto-plastic"));
      }
}



BOOST_AUTO_TEST_CASE(constants)
{
  BOOST_TEST(refused("set Young's modulus = 0\n", "Young's modulus: must"));
  BOOST_TEST(refused("set Poisson's ratio = 0.5\n", "Poisson's ratio: must"));
  BOOST_TEST(refused("set Density = -1\n", "Density: must not"));
  BOOST_TEST(
    refused(plastic + "set Yield stress = 0\n", "Yield stress: must be"));
  BOOST_TEST(refused(plastic + "set Hardening modulus = -1\n",
                     "Hardening modulus: must not"));
  const std::string voce = plastic + "set Hardening = Voce\n";
  BOOST_TEST(refused(voce,
                     "Saturation stress: must not be less than the "
                     "Yield stress, 235e6 Pa, found 0"));
  BOOST_TEST(refused(voce + "set Saturation stress = 300e6\n",
                     "Saturation exponent: must be"));
  const std::string rates = plastic + "set Rate dependence = Johnson-Cook\n";
  BOOST_TEST(
    refused(rates + "set Rate coefficient = -1\n", "Rate coefficient: must"));
  BOOST_TEST(
    refused(rates + "set Reference rate = 0\n", "Reference rate: must be"));
  BOOST_TEST(refused(plastic + "set Kinematic hardening = linear\n",
                     "Kinematic hardening modulus: must be"));
  BOOST_TEST(refused(plastic + "set Kinematic hardening = Armstrong-Frederick\n"
                               "set Kinematic hardening modulus = 1e9\n",
                     "Dynamic recovery: must be"));
}



BOOST_AUTO_TEST_CASE(tables)
{
  BOOST_TEST(table_refused("", "is empty"));
  BOOST_TEST(table_refused("0.1: 200e6", "must be zero"));
  BOOST_TEST(table_refused("0: 200e6 | 0.1", "no colon"));
  BOOST_TEST(table_refused("0: many", "many"));
  BOOST_TEST(table_refused("0: 0", "greater than zero"));
  BOOST_TEST(table_refused("0: 2e8 | 0.2: 3e8 | 0.2: 4e8", "0.2 after 0.2"));
  BOOST_TEST(table_refused("0: 2e8 | 0.2: 1e8", "must not fall"));
  BOOST_TEST(table_refused("file no/such.txt", "no/such.txt"));
}



BOOST_AUTO_TEST_CASE(table_from_a_file)
{
  const TemporaryFolder folder;
  const auto            write = [&](const std::string &text) {
    write_file(folder.file("steel.txt"), text);
  };
  const std::string entries = plastic +
                              "set Hardening = table\n"
                              "set Hardening table = file steel.txt\n";
  const auto read = [&] { return message(entries, folder.path.string()); };

  write("# strain, Pa\n0, 200e6\n\n0.1 300e6 # last\n");
  BOOST_TEST(read() == "");
  write("0 200e6\n0.1 300e6 7\n");
  BOOST_TEST(read().find("steel.txt:2: two numbers are expected") !=
             std::string::npos);
  write("0 200e6\n0.1 x\n");
  BOOST_TEST(read().find("steel.txt:2: two numbers are expected") !=
             std::string::npos);
  write("0 200e6\n0.1 100e6\n");
  BOOST_TEST(read().find("must not fall") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
