# SPDX-License-Identifier: Apache-2.0
# Installs every room: its headers, its library in the export set, and the package that find_package(SolidSubdiv) reads.
if(NOT SOLIDSUBDIV_INSTALL)
  return()
endif()
include(CMakePackageConfigHelpers)
set(SOLIDSUBDIV_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/SolidSubdiv)

# The package that a third-party target comes from, and how a person on Debian gets it. A room that links a target which
# is not listed here stops the configuration: the installed package could not find it.
set(package_of_TBB::tbb TBB)
set(package_of_Threads::Threads Threads)
set(package_of_pugixml::pugixml pugixml)
set(package_of_ZLIB::ZLIB ZLIB)
set(package_of_PNG::PNG PNG)
set(package_of_Eigen3::Eigen Eigen3)
set(package_of_SolidSubdiv3rd::embree Embree3)
set(package_of_SolidSubdiv3rd::openvdb OpenVdbLib)
set(package_of_SolidSubdiv3rd::openmesh OpenMeshLib)
set(package_of_Ceres::ceres Ceres)

# Writes into RESULT what a room links: rooms (SolidSubdiv::x) and third-party targets, public and private.
function(solidsubdiv_links_of room result)
  get_target_property(type solidsubdiv_${room} TYPE)
  if(type STREQUAL "INTERFACE_LIBRARY")
    get_target_property(links solidsubdiv_${room} INTERFACE_LINK_LIBRARIES)
  else()
    get_target_property(links solidsubdiv_${room} LINK_LIBRARIES)
  endif()
  list(FILTER links INCLUDE REGEX "^[A-Za-z0-9_]+::[A-Za-z0-9_]+$")
  set(${result} ${links} PARENT_SCOPE)
endfunction()

# Rooms come in the order in which they were made, so what a room needs is known before the rooms above it are seen.
get_property(rooms GLOBAL PROPERTY SOLIDSUBDIV_ROOMS)
set(SOLIDSUBDIV_ROOM_NEEDS "")
foreach(room ${rooms})
  get_property(room_path GLOBAL PROPERTY SOLIDSUBDIV_ROOM_PATH_${room})
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${room_path}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/solidsubdiv/${room_path}
          FILES_MATCHING PATTERN "*.h" PATTERN "internal" EXCLUDE)
  install(TARGETS solidsubdiv_${room} EXPORT SolidSubdivTargets)

  solidsubdiv_links_of(${room} links)
  set(needs_${room} "")
  foreach(link ${links})
    if(link MATCHES "^SolidSubdiv::(.*)$")
      list(APPEND needs_${room} ${needs_${CMAKE_MATCH_1}})
    elseif(package_of_${link})
      list(APPEND needs_${room} ${package_of_${link}})
    else()
      message(FATAL_ERROR "cmake/Install.cmake: the room ${room} links ${link}; add the package that it comes from")
    endif()
  endforeach()
  list(REMOVE_DUPLICATES needs_${room})
  string(APPEND SOLIDSUBDIV_ROOM_NEEDS "set(_solidsubdiv_needs_${room} ${needs_${room}})\n")
endforeach()
list(JOIN rooms " " SOLIDSUBDIV_ROOM_NAMES)

if(TARGET solidsubdiv)
  install(TARGETS solidsubdiv)
endif()

install(EXPORT SolidSubdivTargets NAMESPACE SolidSubdiv:: DESTINATION ${SOLIDSUBDIV_CMAKE_DIR})
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/SolidSubdivConfig.cmake.in
  ${PROJECT_BINARY_DIR}/SolidSubdivConfig.cmake INSTALL_DESTINATION ${SOLIDSUBDIV_CMAKE_DIR})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/SolidSubdivConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/SolidSubdivConfig.cmake ${PROJECT_BINARY_DIR}/SolidSubdivConfigVersion.cmake
        DESTINATION ${SOLIDSUBDIV_CMAKE_DIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/cmake/find DESTINATION ${SOLIDSUBDIV_CMAKE_DIR})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
