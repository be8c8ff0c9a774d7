#include <signorini/output/surface_table.h>

#include <boost/test/unit_test.hpp>

#include <fstream>
#include <limits>
#include <sstream>

#include "temporary_folder.h"

BOOST_AUTO_TEST_SUITE(surface_table)

using namespace Signorini;

// Nodes come in the order of x, values that are no numbers stay empty.
BOOST_AUTO_TEST_CASE(sorted_with_gaps)
{
  SurfaceData<2> surface;
  surface.nodes         = {{2., 0.5}, {1., 0.25}};
  surface.scalar_fields = {{"gap",
                            {std::numeric_limits<double>::quiet_NaN(), 1e-6}},
                           {"pressure", {3., 4.}}};
  const TemporaryFolder folder;
  const std::string     path = folder.file("floor.csv");
  write_surface_table(surface, path);
  std::ifstream     file(path);
  std::stringstream text;
  text << file.rdbuf();
  BOOST_TEST(text.str() == "x,y,gap,pressure\n1,0.25,1e-06,4\n2,0.5,,3\n");
}

BOOST_AUTO_TEST_SUITE_END()
