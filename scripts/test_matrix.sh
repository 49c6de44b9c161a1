#!/usr/bin/env bash
# Copyright (c) 2026 The Inter_angle_remeshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_matrix.sh [--all] [CGAL_INCLUDE_DIR...]: compiles and runs tests, in their short form, with each of the given versions
# of CGAL (default: the installed one), with g++ and clang++ where they are installed, as C++17 and as C++20. Warnings in the
# package and in the tests are errors. Without --all, two of the tests. COMPILERS, STANDARDS and TESTS, lists of words, say
# otherwise, and FOLDER where to compile:
#   STANDARDS=20 TESTS=test_exchange scripts/test_matrix.sh /opt/CGAL-6.2/include
# Prints a row for each combination. Exit code 1 if one fails; logs are in FOLDER, by default build/matrix.
set -euo pipefail
# shellcheck source=scripts/build_functions.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/build_functions.sh"

usage() { sed -n '/^# test_matrix.sh/,/^[^#]/ s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"; }

tests_folder=$root/test/Inter_angle_remeshing
folder=${FOLDER:-$root/build/matrix}
tests=${TESTS:-test_mesh_types test_as_in_pmp}
includes=()
for argument in "$@"; do
  case $argument in
    --all) tests=$(cd "$tests_folder" && echo test_*.cpp); tests=${tests//.cpp/} ;;
    -h | --help) usage; exit 0 ;;
    -*) usage >&2; fail "there is no option $argument." ;;
    *) includes+=("$argument") ;;
  esac
done
if (( ${#includes[@]} == 0 )); then includes=(/usr/include); fi

version_of() { awk '$2 == "CGAL_VERSION" {print $3}' "$1/CGAL/version.h"; }
for include in "${includes[@]}"; do
  [[ -f $include/CGAL/version.h ]] || fail "there is no CGAL/version.h in '$include'."
done

compilers=()
for compiler in ${COMPILERS:-g++ clang++}; do
  if command -v "$compiler" >/dev/null; then
    compilers+=("$compiler")
  else
    echo "$compiler is not installed: skipped."
  fi
done
(( ${#compilers[@]} > 0 )) || fail "there is no compiler."

# CMake would find these by itself; asking the compiler saves a configuration for each combination.
has_header() {
  printf '#if !__has_include(<%s>)\n#error\n#endif\n' "$2" | "$1" -std=c++17 -E -isystem /usr/include/eigen3 -xc++ - >/dev/null 2>&1
}

options_for() {
  local compiler=$1 test=$2
  echo "-Wall -Wextra -Wpedantic -Werror -O1 -DNDEBUG"
  if [[ $compiler == g++* ]]; then echo "-frounding-math"; fi   # as CGAL's CMake target does
  if has_header "$compiler" Eigen/Core; then echo "-DCGAL_EIGEN3_ENABLED -isystem /usr/include/eigen3"; fi
  if has_header "$compiler" tbb/tbb.h; then echo "-DCGAL_LINKED_WITH_TBB -DCGAL_HAS_TBB"; fi
  if [[ $test == test_mesh_types ]] && has_header "$compiler" OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh; then
    echo "-DTEST_WITH_OPENMESH"
    # OpenMesh leaves new points uninitialized.
    if [[ $compiler == g++* ]]; then echo "-Wno-maybe-uninitialized"; fi
  fi
}

libraries_for() {
  local compiler=$1 test=$2
  echo "-lgmp -lmpfr"
  if has_header "$compiler" tbb/tbb.h; then echo "-ltbb -ltbbmalloc -pthread"; fi
  if [[ $test == test_mesh_types ]] && has_header "$compiler" OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh; then
    echo "-lOpenMeshCore"
  fi
}

# CGAL's meshes, which some tests read.
data=${CGAL_DATA_DIR:-$folder/data}
unpack_data() {
  local archive=/usr/share/doc/libcgal-dev/data.tar.gz
  [[ -d $data/meshes || ! -f $archive ]] || tar -xzf "$archive" -C "$folder" data/meshes
}

# name_of COMPILER STANDARD INCLUDE PROGRAM: of a file in the folder.
name_of() { echo "$folder/$1-$2-$(version_of "$3")-$4"; }

# compile COMPILER STANDARD INCLUDE PROGRAM ARGUMENT...
compile() {
  local compiler=$1 standard=$2 include=$3 program=$4
  shift 4
  local options system=()
  read -r -d '' -a options < <(options_for "$compiler" "$program") || true
  # A folder that the compiler searches by itself stays where it is: libraries' own headers rely on the order.
  [[ $include -ef /usr/include ]] || system=(-isystem "$include")
  "$compiler" "-std=c++$standard" "${options[@]}" "-DCGAL_DATA_DIR=\"$data\"" -I "$root/include" "${system[@]}" "$@"
}

# compile_models COMPILER STANDARD INCLUDE: what some tests share, as objects; a test that needs one that is missing does not link.
compile_models() {
  local sources=()
  read -r -d '' -a sources < <(for test in $tests; do echo "$tests_folder/$test.cpp"; done) || true
  grep -q -e invariants.h -e models.h "${sources[@]}" || return 0
  local model object
  for model in invariants models; do
    object=$(name_of "$@" "$model").o
    rm -f "$object"
    compile "$@" "$model" -c "$tests_folder/$model.cpp" -o "$object" >"${object%.o}.log" 2>&1 || true
  done
}

# check COMPILER STANDARD INCLUDE TEST: the word for the table.
check() {
  local compiler=$1 test=$4 program libraries model object models=()
  program=$(name_of "$@")
  read -r -d '' -a libraries < <(libraries_for "$compiler" "$test") || true
  for model in invariants models; do
    object=$(name_of "$1" "$2" "$3" "$model").o
    [[ ! -f $object ]] || models+=("$object")
  done
  compile "$@" "$tests_folder/$test.cpp" "${models[@]}" -o "$program" "${libraries[@]}" >"$program.log" 2>&1 ||
    { echo "not compiled"; return; }
  CGAL_DATA_DIR=$data INTER_ANGLE_TEST_SMALL=1 "$program" >>"$program.log" 2>&1 || { echo failed; return; }
  rm -f "$program"
  echo passed
}

mkdir -p "$folder"
unpack_data
exit_code=0
printf '%-10s %-10s %-9s %-24s %s\n' CGAL compiler standard test result
for include in "${includes[@]}"; do
  for compiler in "${compilers[@]}"; do
    for standard in ${STANDARDS:-17 20}; do
      compile_models "$compiler" "$standard" "$include"
      for test in $tests; do
        result=$(check "$compiler" "$standard" "$include" "$test")
        [[ $result == passed ]] || exit_code=1
        printf '%-10s %-10s %-9s %-24s %s\n' "$(version_of "$include")" "$compiler" "C++$standard" "$test" "$result"
      done
    done
  done
done
(( exit_code == 0 )) || echo "The logs of what failed are in $folder." >&2
exit "$exit_code"
