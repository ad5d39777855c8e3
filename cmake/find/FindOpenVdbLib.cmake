# SPDX-License-Identifier: Apache-2.0
# Finds OpenVDB by path and library: its own find module trips on Imath and breaks other packages' TBB.
#
# Defines OpenVdbLib_FOUND and the target SolidSubdiv3rd::openvdb.
find_path(OpenVdbLib_INCLUDE_DIR openvdb/openvdb.h)
find_library(OpenVdbLib_LIBRARY openvdb)
find_path(OpenVdbLib_IMATH_INCLUDE_DIR half.h PATH_SUFFIXES Imath)
find_library(OpenVdbLib_IMATH_LIBRARY Imath)
find_path(OpenVdbLib_BOOST_INCLUDE_DIR boost/iostreams/copy.hpp)
find_package(TBB QUIET)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(OpenVdbLib REQUIRED_VARS OpenVdbLib_LIBRARY OpenVdbLib_INCLUDE_DIR
  OpenVdbLib_IMATH_INCLUDE_DIR OpenVdbLib_IMATH_LIBRARY OpenVdbLib_BOOST_INCLUDE_DIR TBB_FOUND)
mark_as_advanced(OpenVdbLib_INCLUDE_DIR OpenVdbLib_LIBRARY OpenVdbLib_IMATH_INCLUDE_DIR OpenVdbLib_IMATH_LIBRARY
  OpenVdbLib_BOOST_INCLUDE_DIR)
if(OpenVdbLib_FOUND AND NOT TARGET SolidSubdiv3rd::openvdb)
  add_library(SolidSubdiv3rd::openvdb UNKNOWN IMPORTED)
  set_target_properties(SolidSubdiv3rd::openvdb PROPERTIES
    IMPORTED_LOCATION ${OpenVdbLib_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES "${OpenVdbLib_INCLUDE_DIR};${OpenVdbLib_IMATH_INCLUDE_DIR}"
    INTERFACE_LINK_LIBRARIES "${OpenVdbLib_IMATH_LIBRARY};TBB::tbb")
endif()
