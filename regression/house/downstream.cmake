# SPDX-License-Identifier: Apache-2.0
# Installs what BUILD holds to a fresh prefix below WORK, then configures, builds and runs SOURCE against it: as a
# downstream user would, with the installed package alone. Also: README's page of C++ and the documentation's example
# compile and run, and what is missing is named, with how to get it.
foreach(name BUILD SOURCE WORK CONFIG GENERATOR CXX FLAGS)
  if(NOT DEFINED ${name})
    message(FATAL_ERROR "downstream.cmake needs -D${name}=")
  endif()
endforeach()
file(REMOVE_RECURSE ${WORK})

# README's page of C++ becomes a program: what follows its `using` line goes into main().
file(READ ${SOURCE}/../../../README.md readme)
if(NOT readme MATCHES "```cpp\n([^`]*using namespace SolidSubdiv;\n)([^`]*)```")
  message(FATAL_ERROR "README.md has no page of C++ with the line 'using namespace SolidSubdiv;'")
endif()
file(WRITE ${WORK}/readme.cpp "#include <vector>\n${CMAKE_MATCH_1}int main() {\n${CMAKE_MATCH_2}}\n")

execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix --config ${CONFIG}
                OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)

set(settings -G ${GENERATOR} -DCMAKE_BUILD_TYPE=${CONFIG} -DCMAKE_CXX_COMPILER=${CXX} -DCMAKE_CXX_FLAGS=${FLAGS}
    -DCMAKE_PREFIX_PATH=${WORK}/prefix)
set(configure ${CMAKE_COMMAND} -S ${SOURCE} ${settings} -DREADME_PAGE=${WORK}/readme.cpp)
execute_process(COMMAND ${configure} -B ${WORK}/build COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${WORK}/build --config ${CONFIG} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_CTEST_COMMAND} --test-dir ${WORK}/build -C ${CONFIG} --verbose COMMAND_ERROR_IS_FATAL ANY)

# docs/examples/deform_loop asks for the rooms that it needs, and finds nothing else.
set(repository ${SOURCE}/../../..)
set(demo ${repository}/regression/shapes/demo)
execute_process(COMMAND ${CMAKE_COMMAND} -S ${repository}/docs/examples/deform_loop ${settings} -B ${WORK}/deform_loop
                COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${WORK}/deform_loop COMMAND_ERROR_IS_FATAL ANY)
set(deform_loop ${WORK}/deform_loop/deform_loop ${demo}/bunny.obj ${demo}/bunny_lattice.vtu)
execute_process(COMMAND ${deform_loop} 500 ${WORK}/last_frame.obj OUTPUT_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
message("${output}")
if(NOT output MATCHES "touches [1-9][0-9]* vertices.*one control point: [0-9]+ frames.*all control points: [0-9]+ frames"
   OR NOT EXISTS ${WORK}/last_frame.obj)
  message(FATAL_ERROR "deform_loop did not deform, or wrote no last frame")
endif()
execute_process(COMMAND ${deform_loop} 695 ${WORK}/no_frame.obj OUTPUT_QUIET RESULT_VARIABLE status ERROR_VARIABLE errors)
if(NOT status EQUAL 1 OR NOT errors MATCHES "control point 695 is not among the 695" OR EXISTS ${WORK}/no_frame.obj)
  message(FATAL_ERROR "a control point that is not there must be refused; status ${status}, it said: ${errors}")
endif()

# expect_refusal(TEXT OPTIONS...): the configuration fails with TEXT in its message.
function(expect_refusal text)
  execute_process(COMMAND ${configure} -B ${WORK}/refused ${ARGN} RESULT_VARIABLE status OUTPUT_QUIET ERROR_VARIABLE errors)
  file(REMOVE_RECURSE ${WORK}/refused)
  string(REGEX REPLACE "[ \n]+" " " errors "${errors}")
  string(FIND "${errors}" "${text}" place)
  if(status EQUAL 0 OR place EQUAL -1)
    message(FATAL_ERROR "with ${ARGN} the package must be refused with '${text}'; status ${status}, it said: ${errors}")
  endif()
endfunction()
expect_refusal("there is no room 'attic' here" -Drooms=attic)
expect_refusal("the room 'io' needs pugixml, which was not found (Debian: libpugixml-dev)"
               -Drooms=io -DCMAKE_DISABLE_FIND_PACKAGE_pugixml=ON)
