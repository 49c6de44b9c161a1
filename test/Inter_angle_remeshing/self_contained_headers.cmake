# Copyright (c) 2026 The Inter_angle_remeshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# cmake -DCOMPILER=... -DSTANDARD=... -DFOLDERS=a|b -DDEFINITIONS=a|b -DPACKAGE=<folder of the headers> -P self_contained_headers.cmake
#
# Each public header compiles when it is all that a program includes, twice over, without a warning; and with the macros of headers
# that many programs include before, Qt's and those of Windows.

string(REPLACE "|" ";" folders "${FOLDERS}")
string(REPLACE "|" ";" definitions "${DEFINITIONS}")
list(FILTER definitions EXCLUDE REGEX "^$")
list(APPEND definitions "slots=" "signals=public" "near=" "far=" "small=char" "NEAR=near" "FAR=far" "interface=struct" "DIFFERENCE=11"
  "ABSOLUTE=1" "RELATIVE=2" "OPAQUE=2" "IGNORE=0" "DELETE=65536" "INFINITE=0xFFFFFFFF")
list(TRANSFORM definitions PREPEND "-D")
# The compiler's own folder would come before those of its library.
list(FILTER folders EXCLUDE REGEX "^(${PACKAGE}|/usr/include|)$")
list(TRANSFORM folders PREPEND "-isystem;")

file(GLOB_RECURSE headers RELATIVE "${PACKAGE}" "${PACKAGE}/CGAL/*.h")
list(FILTER headers EXCLUDE REGEX "/internal/")
set(source "${CMAKE_CURRENT_BINARY_DIR}/self_contained_header.cpp")
foreach(header IN LISTS headers)
  file(WRITE "${source}" "#include <${header}>\n#include <${header}>\n")
  execute_process(COMMAND "${COMPILER}" ${STANDARD} -fsyntax-only -Wall -Wextra -Wpedantic -Werror "-I${PACKAGE}" ${folders} ${definitions}
                          "${source}" RESULT_VARIABLE failed ERROR_VARIABLE said)
  if(failed)
    message(SEND_ERROR "${header} is not self-contained:\n${said}")
  endif()
endforeach()
list(LENGTH headers number)
if(number LESS 15)
  message(SEND_ERROR "Only ${number} headers were found in ${PACKAGE}.")
endif()
message(STATUS "${number} headers")
