// One executable for all unit tests: starting a program that links deal.II
// costs more than most of its tests.
#define BOOST_TEST_MODULE Signorini
#include <signorini/run/threads.h>

#include <deal.II/base/mpi.h>

#include <boost/test/included/unit_test.hpp>

namespace
{
  /** Trilinos needs MPI; one thread keeps the tests repeatable. */
  struct MPIEnvironment
  {
    MPIEnvironment()
      : argc(boost::unit_test::framework::master_test_suite().argc)
      , argv(boost::unit_test::framework::master_test_suite().argv)
      , initialization(argc, argv, 1)
    {
      Signorini::limit_threads(1);
    }

    int                                      argc;
    char                                   **argv;
    dealii::Utilities::MPI::MPI_InitFinalize initialization;
  };
} // namespace

BOOST_TEST_GLOBAL_FIXTURE(MPIEnvironment);
