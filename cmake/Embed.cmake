# SPDX-License-Identifier: Apache-2.0
# Text files compiled into a room. Each becomes a `const std::span<const std::string_view>`: pieces, as compilers need
# not take strings of any length. ASCII only: a piece could end in the middle of another character.
#
# solidsubdiv_embed(ROOM HEADER NAMESPACE NAME FILE [NAME FILE...]); HEADER declares the names.
# While the room is built this file runs as a script (cmake -P), which does the work.
if(CMAKE_SCRIPT_MODE_FILE)
  set(source "// Made by cmake/Embed.cmake.\n#include <${HEADER}>\n\n")
  string(APPEND source "using namespace std::string_view_literals;\n\nnamespace ${NAMESPACE} {\n")
  string(REPLACE "|" ";" FILES "${FILES}")
  while(FILES)
    list(POP_FRONT FILES name file)
    file(READ ${file} text)
    if(text MATCHES "[^\t\n -~]")
      message(FATAL_ERROR "${file}: not ASCII, near '${CMAKE_MATCH_0}'")
    endif()
    string(LENGTH "${text}" length)
    string(APPEND source "\nstatic constexpr std::string_view ${name}Pieces[] = {\n")
    set(place 0)
    while(place LESS length)
      string(SUBSTRING "${text}" ${place} 16000 piece)
      string(APPEND source "R\"embedded(${piece})embedded\"sv,\n")
      math(EXPR place "${place} + 16000")
    endwhile()
    string(APPEND source "};\nconst std::span<const std::string_view> ${name} = ${name}Pieces;\n")
  endwhile()
  file(WRITE ${OUTPUT} "${source}\n}\n")
  return()
endif()

function(solidsubdiv_embed room header namespace)
  set(files "")
  set(inputs "")
  set(arguments ${ARGN})
  while(arguments)
    list(POP_FRONT arguments name file)
    list(APPEND files ${name} ${CMAKE_CURRENT_SOURCE_DIR}/${file})
    list(APPEND inputs ${CMAKE_CURRENT_SOURCE_DIR}/${file})
  endwhile()
  list(JOIN files "|" files)
  set(output ${CMAKE_CURRENT_BINARY_DIR}/${room}_assets.cpp)
  set(script ${PROJECT_SOURCE_DIR}/cmake/Embed.cmake)
  add_custom_command(OUTPUT ${output} DEPENDS ${inputs} ${script} VERBATIM
    COMMAND ${CMAKE_COMMAND} -DHEADER=${header} -DNAMESPACE=${namespace} -DFILES=${files} -DOUTPUT=${output}
            -P ${script})
  target_sources(solidsubdiv_${room} PRIVATE ${output})
endfunction()
