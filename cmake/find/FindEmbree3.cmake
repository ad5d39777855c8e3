# SPDX-License-Identifier: Apache-2.0
# Embree 3 by path and library: defines SolidSubdiv3rd::embree.
find_path(Embree3_INCLUDE_DIR embree3/rtcore.h)
find_library(Embree3_LIBRARY embree3)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Embree3 DEFAULT_MSG Embree3_LIBRARY Embree3_INCLUDE_DIR)
if(Embree3_FOUND AND NOT TARGET SolidSubdiv3rd::embree)
  add_library(SolidSubdiv3rd::embree UNKNOWN IMPORTED)
  set_target_properties(SolidSubdiv3rd::embree PROPERTIES
    IMPORTED_LOCATION ${Embree3_LIBRARY} INTERFACE_INCLUDE_DIRECTORIES ${Embree3_INCLUDE_DIR})
endif()
