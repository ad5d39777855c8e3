# SPDX-License-Identifier: Apache-2.0
# OpenSubdiv's CPU library by path and library (Debian's own config aborts): defines SolidSubdiv3rd::osd.
find_path(OpenSubdivLib_INCLUDE_DIR opensubdiv/far/topologyRefiner.h)
find_library(OpenSubdivLib_LIBRARY osdCPU)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(OpenSubdivLib DEFAULT_MSG OpenSubdivLib_LIBRARY OpenSubdivLib_INCLUDE_DIR)
if(OpenSubdivLib_FOUND AND NOT TARGET SolidSubdiv3rd::osd)
  add_library(SolidSubdiv3rd::osd UNKNOWN IMPORTED)
  set_target_properties(SolidSubdiv3rd::osd PROPERTIES
    IMPORTED_LOCATION ${OpenSubdivLib_LIBRARY} INTERFACE_INCLUDE_DIRECTORIES ${OpenSubdivLib_INCLUDE_DIR})
endif()
