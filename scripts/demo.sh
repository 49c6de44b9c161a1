#!/usr/bin/env bash
# Copyright (c) 2026 The Inter_angle_remeshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# demo.sh [MESH] [OPTION...]: remeshes a triangle mesh (OFF, OBJ, PLY or STL; CGAL's elephant by default) with CGAL's
# isotropic_remeshing() and with this package's, and prints a table that compares the two. The result is written next to
# MESH (to the current folder where that is read-only; to build/demo for the elephant). The options are those of the
# example comparison_with_pmp, as are the errors: one sentence, and exit code 1.
set -euo pipefail
source "$(dirname -- "${BASH_SOURCE[0]}")/build_functions.sh"

folder=$root/build/demo
mesh=
if (( $# > 0 )) && [[ $1 != -* ]]; then
  mesh=$1
  shift
  # Before the build, which takes a while.
  [[ -f $mesh && -r $mesh ]] || fail "cannot read '$mesh'."
fi

build "$folder" comparison_with_pmp -DBUILD_TESTING=OFF -DBUILD_BENCHMARKS=OFF

if [[ -z $mesh ]]; then
  mesh=${CGAL_DATA_DIR:-$folder/data}/meshes/elephant.off
  output_folder=$folder
else
  output_folder=$(dirname -- "$mesh")
  [[ -w $output_folder ]] || output_folder=$PWD
fi
stem=$(basename -- "$mesh")
exec "$folder/examples/Inter_angle_remeshing/comparison_with_pmp" "$mesh" -o "$output_folder/${stem%.*}_remeshed.off" "$@"
