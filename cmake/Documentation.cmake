# `doc` makes HTML of the comments in the headers, in doc/html/ of the build folder. A comment that
# names a parameter or a class that does not exist is an error; a missing comment is none.
find_package(Doxygen QUIET)
if(NOT DOXYGEN_FOUND)
  return()
endif()

set(DOXYGEN_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/doc)
file(MAKE_DIRECTORY ${DOXYGEN_OUTPUT_DIRECTORY})
set(DOXYGEN_PROJECT_BRIEF "Dynamic frictional contact as a variational inequality")
set(DOXYGEN_STRIP_FROM_PATH ${PROJECT_SOURCE_DIR}/include)
set(DOXYGEN_JAVADOC_AUTOBRIEF YES)
set(DOXYGEN_EXTRACT_ALL YES)
set(DOXYGEN_SORT_MEMBER_DOCS NO)
set(DOXYGEN_HAVE_DOT NO)
set(DOXYGEN_WARN_IF_INCOMPLETE_DOC NO)
set(DOXYGEN_QUIET YES)
set(DOXYGEN_WARN_AS_ERROR FAIL_ON_WARNINGS)
doxygen_add_docs(doc ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/cmake/mainpage.dox)
