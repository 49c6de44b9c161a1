# Copyright (c) 2026 The Inter_angle_remeshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# cmake -DCOMPILER=... -DSTANDARD=... -DFOLDERS=a|b -DDEFINITIONS=a|b -DSOURCE=... -P refused_at_compile_time.cmake
#
# Compiles SOURCE twice, without output: with CASE=0, where there is nothing to complain about, and with all its mistakes, each of
# which must be told in the words that it expects. There must be as many errors as mistakes.

string(REPLACE "|" ";" folders "${FOLDERS}")
string(REPLACE "|" ";" definitions "${DEFINITIONS}")
list(TRANSFORM folders PREPEND "-I")
list(FILTER definitions EXCLUDE REGEX "CGAL_LINKED_WITH_TBB|^$")   # one of the mistakes is to want threads without TBB
list(TRANSFORM definitions PREPEND "-D")
set(command "${COMPILER}" ${STANDARD} -fsyntax-only -w ${folders} ${definitions})

execute_process(COMMAND ${command} -DCASE=0 "${SOURCE}" RESULT_VARIABLE failed ERROR_VARIABLE said)
if(failed)
  message(FATAL_ERROR "Without a mistake it does not compile:\n${said}")
endif()

execute_process(COMMAND ${command} "${SOURCE}" RESULT_VARIABLE failed ERROR_VARIABLE said)
if(NOT failed)
  message(FATAL_ERROR "With the mistakes it compiles.")
endif()
string(REPLACE ";" "," said "${said}")
string(REGEX MATCHALL "error:[^\n]*" errors "${said}")

file(STRINGS "${SOURCE}" cases REGEX "// expect: ")
list(LENGTH cases number_of_cases)
foreach(case IN LISTS cases)
  string(REGEX REPLACE ".*// expect: " "" expected "${case}")
  set(found FALSE)
  foreach(error IN LISTS errors)
    string(FIND "${error}" "${expected}" position)
    if(position GREATER -1)
      set(found TRUE)
    endif()
  endforeach()
  if(NOT found)
    message(SEND_ERROR "No error says: ${expected}")
  endif()
endforeach()

list(LENGTH errors number_of_errors)
list(JOIN errors "\n" errors)
if(number_of_cases LESS 10 OR NOT number_of_errors EQUAL number_of_cases)
  message(SEND_ERROR "${number_of_errors} errors for ${number_of_cases} mistakes:\n${errors}")
endif()
message(STATUS "${number_of_cases} mistakes, ${number_of_errors} errors")
