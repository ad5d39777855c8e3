# SPDX-License-Identifier: Apache-2.0
# OpenMesh's libraries by path and library: defines SolidSubdiv3rd::openmesh.
find_path(OpenMeshLib_INCLUDE_DIR OpenMesh/Tools/Subdivider/Uniform/ModifiedButterFlyT.hh)
find_library(OpenMeshLib_LIBRARY OpenMeshCore)
find_library(OpenMeshLib_TOOLS_LIBRARY OpenMeshTools)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(OpenMeshLib DEFAULT_MSG OpenMeshLib_LIBRARY OpenMeshLib_TOOLS_LIBRARY
                                  OpenMeshLib_INCLUDE_DIR)
if(OpenMeshLib_FOUND AND NOT TARGET SolidSubdiv3rd::openmesh)
  add_library(SolidSubdiv3rd::openmesh UNKNOWN IMPORTED)
  set_target_properties(SolidSubdiv3rd::openmesh PROPERTIES
    IMPORTED_LOCATION ${OpenMeshLib_TOOLS_LIBRARY} INTERFACE_LINK_LIBRARIES ${OpenMeshLib_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${OpenMeshLib_INCLUDE_DIR})
endif()
