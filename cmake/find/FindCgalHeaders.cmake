# SPDX-License-Identifier: Apache-2.0
# CGAL's headers by path (its own config sets flags for all): defines SolidSubdiv3rd::cgal.
# GPL: for benchmarks and validators only.
find_path(CgalHeaders_INCLUDE_DIR CGAL/subdivision_method_3.h)
find_path(CgalHeaders_BOOST_INCLUDE_DIR boost/graph/graph_traits.hpp)
find_library(CgalHeaders_GMP_LIBRARY gmp)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(CgalHeaders DEFAULT_MSG
  CgalHeaders_INCLUDE_DIR CgalHeaders_BOOST_INCLUDE_DIR CgalHeaders_GMP_LIBRARY)
if(CgalHeaders_FOUND AND NOT TARGET SolidSubdiv3rd::cgal)
  add_library(SolidSubdiv3rd::cgal INTERFACE IMPORTED)
  set_target_properties(SolidSubdiv3rd::cgal PROPERTIES
    INTERFACE_INCLUDE_DIRECTORIES "${CgalHeaders_INCLUDE_DIR};${CgalHeaders_BOOST_INCLUDE_DIR}"
    INTERFACE_LINK_LIBRARIES ${CgalHeaders_GMP_LIBRARY})
endif()
