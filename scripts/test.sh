#!/usr/bin/env bash
# Copyright (c) 2026 The Inter_angle_remeshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test.sh [CTEST_OPTION...]: builds everything in build/test and runs the tests, as built for users and under the
# sanitizers. Its exit code is ctest's.
set -euo pipefail
source "$(dirname -- "${BASH_SOURCE[0]}")/build_functions.sh"

folder=$root/build/test
build "$folder" all -DWITH_SANITIZER_TESTS=ON
exec ctest --test-dir "$folder" --output-on-failure --no-tests=error --parallel "$(job_count)" "$@"
