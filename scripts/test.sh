#!/usr/bin/env bash
# Copyright (c) 2026 The Inter_angle_remeshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test.sh [CTEST_OPTION...]: builds everything in build/test and runs the tests, as built for users and under the
# sanitizers. Its exit code is ctest's.
set -euo pipefail
source "$(dirname -- "${BASH_SOURCE[0]}")/build_functions.sh"

folder=$root/build/test
# Examples and benchmarks are run, not measured, here: a low level saves the compiler a third of its time.
build "$folder" all -DWITH_SANITIZER_TESTS=ON "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG"
exec ctest --test-dir "$folder" --output-on-failure --no-tests=error --parallel "$(job_count)" "$@"
