# SPDX-License-Identifier: Apache-2.0
# Rooms: one static library a room, headers seen as <solidsubdiv/ROOM/...> in the tree and after installation.

# The tree is seen under build/include/solidsubdiv through links, so that both spellings are one.
set(SOLIDSUBDIV_INCLUDE_DIR ${PROJECT_BINARY_DIR}/include)
file(MAKE_DIRECTORY ${SOLIDSUBDIV_INCLUDE_DIR}/solidsubdiv)
foreach(top sdc vtr far osd kit apps)
  file(CREATE_LINK ${PROJECT_SOURCE_DIR}/${top} ${SOLIDSUBDIV_INCLUDE_DIR}/solidsubdiv/${top} SYMBOLIC)
endforeach()

# Flags of everything that is built here; downstream targets see none of them.
add_library(solidsubdiv_flags INTERFACE)
# GCC 12 warns of overlaps in std::string's own operator+ (its bug 105651).
target_compile_options(solidsubdiv_flags INTERFACE -Wall -Wextra -Wshadow -Wpedantic $<$<BOOL:${SOLIDSUBDIV_WERROR}>:-Werror>)
target_compile_options(solidsubdiv_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
if(SOLIDSUBDIV_SANITIZE)
  target_compile_options(solidsubdiv_flags INTERFACE -fsanitize=${SOLIDSUBDIV_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(solidsubdiv_flags INTERFACE -fsanitize=${SOLIDSUBDIV_SANITIZE})
endif()

# What stands on the rooms mostly waits for them: optimizing it takes longer than it saves.
function(solidsubdiv_compile_quickly target)
  if(SOLIDSUBDIV_SANITIZE)
    target_compile_options(${target} PRIVATE -O0)
  else()
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
  endif()
endfunction()

# Sources that include OpenVDB, under UBSan: oneTBB's hash map, in which it keeps its accessors, marks buckets to be
# rehashed with the pointer 3, and is stopped for it.
function(solidsubdiv_spare_openvdb)
  if(SOLIDSUBDIV_SANITIZE)
    set_source_files_properties(${ARGN} PROPERTIES COMPILE_OPTIONS -fno-sanitize=alignment)
  endif()
endfunction()

# solidsubdiv_room(NAME [PUBLIC targets...] [PRIVATE targets...])
# A room is every .cpp below the calling folder; one without any is header-only. NAME becomes SolidSubdiv::NAME.
function(solidsubdiv_room name)
  cmake_parse_arguments(ARG "" "" "PUBLIC;PRIVATE" ${ARGN})
  set(target solidsubdiv_${name})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS *.cpp)
  if(sources)
    set(visible PUBLIC)
    add_library(${target} STATIC ${sources})
    set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    target_link_libraries(${target} PRIVATE ${ARG_PRIVATE} $<BUILD_INTERFACE:solidsubdiv_flags>)
  else()
    set(visible INTERFACE)
    add_library(${target} INTERFACE)
  endif()
  add_library(SolidSubdiv::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  target_compile_features(${target} ${visible} cxx_std_20)
  target_include_directories(${target} ${visible}
    $<BUILD_INTERFACE:${SOLIDSUBDIV_INCLUDE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_link_libraries(${target} ${visible} ${ARG_PUBLIC})
  set_property(GLOBAL APPEND PROPERTY SOLIDSUBDIV_ROOMS ${name})
  file(RELATIVE_PATH room_path ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR})
  set_property(GLOBAL PROPERTY SOLIDSUBDIV_ROOM_PATH_${name} ${room_path})
endfunction()
