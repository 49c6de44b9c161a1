# Copyright (c) 2026 The Inter_angle_remeshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# What the headers need, for the build tree and for an installed package alike. CGAL has been found before.

if(CGAL_VERSION VERSION_LESS 5.5)
  message(FATAL_ERROR "Inter_angle_remeshing needs CGAL 5.5 or later; this is ${CGAL_VERSION}.")
endif()

# Makes an imported target that was just created here visible to a project that only adds this folder.
function(inter_angle_remeshing_link_support target support)
  if(TARGET CGAL::${support})
    set(is_new FALSE)
  else()
    set(is_new TRUE)
    include("${CGAL_MODULES_DIR}/CGAL_${support}.cmake")
  endif()
  if(TARGET CGAL::${support})
    if(is_new)
      set_target_properties(CGAL::${support} PROPERTIES IMPORTED_GLOBAL TRUE)
    endif()
    target_link_libraries(${target} INTERFACE CGAL::${support})
  endif()
endfunction()

function(inter_angle_remeshing_link_dependencies target)
  set(CMAKE_FIND_PACKAGE_TARGETS_GLOBAL TRUE)
  list(APPEND CMAKE_MODULE_PATH "${CGAL_MODULES_DIR}")
  target_compile_features(${target} INTERFACE cxx_std_17) # CGAL 5.5's own target says 14
  target_link_libraries(${target} INTERFACE CGAL::CGAL)

  find_package(Eigen3 3.3 QUIET)
  inter_angle_remeshing_link_support(${target} Eigen3_support)

  if(NOT DEFINED CGAL_INTER_ANGLE_REMESHING_USE_TBB OR CGAL_INTER_ANGLE_REMESHING_USE_TBB)
    find_package(TBB QUIET)
    inter_angle_remeshing_link_support(${target} TBB_support)
  endif()
endfunction()

# inter_angle_remeshing_add_compiled(<name> <interface target>): the passes as a static library, see compiled_passes.h, compiled
# where it is linked to, with the compiler and the options of that project.
function(inter_angle_remeshing_add_compiled name interface)
  set(source "${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp")
  file(CONFIGURE OUTPUT "${source}" CONTENT "#include <CGAL/Inter_angle_remeshing/compiled_passes.h>\n")
  add_library(${name} STATIC EXCLUDE_FROM_ALL "${source}")
  target_link_libraries(${name} PUBLIC ${interface})
  target_compile_definitions(${name} PUBLIC CGAL_INTER_ANGLE_REMESHING_COMPILED)
  set_target_properties(${name} PROPERTIES CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON)
endfunction()
