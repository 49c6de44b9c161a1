# Copyright (c) 2026 The Inter_angle_remeshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# What the test, example and benchmark folders share. Each of them can be configured alone, too, as CGAL's are.

if(NOT TARGET CGAL::Inter_angle_remeshing)
  include("${CMAKE_CURRENT_LIST_DIR}/Inter_angle_remeshing_data.cmake")
  add_subdirectory("${CMAKE_CURRENT_LIST_DIR}/.." "${CMAKE_CURRENT_BINARY_DIR}/Inter_angle_remeshing")
endif()

# inter_angle_remeshing_set_options(<target>): its sources are warned about, and find CGAL's meshes.
function(inter_angle_remeshing_set_options target)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-Wall;-Wextra>)
  if(CGAL_DATA_DIR)
    target_compile_definitions(${target} PRIVATE "CGAL_DATA_DIR=\"${CGAL_DATA_DIR}\"")
  endif()
endfunction()

# inter_angle_remeshing_add_program(<name> <source> [<passes>]): a program that uses the package and finds CGAL's meshes. The
# passes are those of another compiled library where one is named.
function(inter_angle_remeshing_add_program name source)
  set(passes CGAL::Inter_angle_remeshing_compiled)
  if(ARGN)
    set(passes ${ARGN})
  endif()
  add_executable(${name} "${source}")
  target_link_libraries(${name} PRIVATE ${passes})
  inter_angle_remeshing_set_options(${name})
endfunction()
