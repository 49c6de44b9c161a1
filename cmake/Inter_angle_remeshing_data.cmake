# Copyright (c) 2026 The Inter_angle_remeshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# Sets CGAL_DATA_DIR, the folder that CGAL::data_file_path() looks into: what the user gave (variable or environment),
# else the meshes of Debian's package libcgal-demo, unpacked once into the build directory, else nothing.

if(NOT CGAL_DATA_DIR AND DEFINED ENV{CGAL_DATA_DIR})
  set(CGAL_DATA_DIR "$ENV{CGAL_DATA_DIR}")
endif()

if(NOT CGAL_DATA_DIR)
  find_file(CGAL_DATA_ARCHIVE data.tar.gz PATHS /usr/share/doc/libcgal-dev NO_DEFAULT_PATH
    DOC "archive of the meshes that come with CGAL")
  mark_as_advanced(CGAL_DATA_ARCHIVE)
  set(data_dir "${CMAKE_BINARY_DIR}/data")
  if(CGAL_DATA_ARCHIVE AND NOT EXISTS "${data_dir}/meshes")
    # Renamed in one step at the end, so that an interrupted run leaves nothing half unpacked.
    file(ARCHIVE_EXTRACT INPUT "${CGAL_DATA_ARCHIVE}" DESTINATION "${data_dir}.part" PATTERNS "data/meshes/*")
    file(MAKE_DIRECTORY "${data_dir}")
    file(RENAME "${data_dir}.part/data/meshes" "${data_dir}/meshes")
    file(REMOVE_RECURSE "${data_dir}.part")
  endif()
  if(EXISTS "${data_dir}/meshes")
    set(CGAL_DATA_DIR "${data_dir}")
  else()
    message(STATUS "No meshes found: set CGAL_DATA_DIR to CGAL's folder data before the tests and examples are run.")
  endif()
endif()
