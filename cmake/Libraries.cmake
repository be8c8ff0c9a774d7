# The libraries beside deal.II, gathered in the target `signorini_dependencies`.
# Each one that is missing gets one sentence with its remedy.

if(NOT DEAL_II_WITH_LAPACK OR NOT DEAL_II_WITH_MUPARSER OR NOT DEAL_II_WITH_TRILINOS)
  message(FATAL_ERROR "deal.II in ${DEAL_II_PATH} was built without LAPACK, muParser or Trilinos; "
    "Debian's package libdeal.ii-dev has all three.")
endif()

find_library(CHOLMOD_LIBRARY cholmod)
find_path(CHOLMOD_INCLUDE_DIR cholmod.h PATH_SUFFIXES suitesparse)
if(NOT CHOLMOD_LIBRARY OR NOT CHOLMOD_INCLUDE_DIR)
  message(FATAL_ERROR "CHOLMOD (SuiteSparse) was not found. On Debian 12: apt-get install libsuitesparse-dev")
endif()

find_library(METIS_LIBRARY metis)
if(NOT METIS_LIBRARY)
  message(FATAL_ERROR "METIS was not found. On Debian 12: apt-get install libmetis-dev")
endif()

# CHOLMOD takes whichever BLAS the system resolves libblas.so.3 to. With the
# reference BLAS it is eight times slower, so OpenBLAS is asked for by name.
find_library(OPENBLAS_LIBRARY NAMES openblas libopenblas.so.0)
if(NOT OPENBLAS_LIBRARY)
  message(FATAL_ERROR "OpenBLAS was not found; with the reference BLAS the sparse factorisation is eight "
    "times slower. On Debian 12: apt-get install libopenblas0-pthread")
endif()

# CHOLMOD's loops run on its threads, which have to be told how many they are.
find_library(OPENMP_LIBRARY NAMES gomp libgomp.so.1)
if(NOT OPENMP_LIBRARY)
  message(FATAL_ERROR "GNU's OpenMP, which CHOLMOD uses, was not found. On Debian 12: apt-get install libgomp1")
endif()

find_package(Boost 1.74 REQUIRED COMPONENTS program_options serialization)

add_library(signorini_dependencies INTERFACE)
target_include_directories(signorini_dependencies SYSTEM INTERFACE ${CHOLMOD_INCLUDE_DIR})
target_link_libraries(signorini_dependencies INTERFACE
  ${CHOLMOD_LIBRARY} ${OPENBLAS_LIBRARY} ${OPENMP_LIBRARY} Boost::program_options Boost::serialization)
