#!/usr/bin/env bash
# Copyright (c) 2026 The Inter_angle_remeshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_rounding.sh [RUNS] [CTEST_OPTION...]: builds the tests in build/rounding and runs them RUNS times (default: 3), each time with
# mathematical functions that round otherwise, as those of other processors do. No test may depend on the last bit of a sine. The
# first run has the seed FIRST (default: 1). Exit code 1 if a test fails.
set -euo pipefail
# shellcheck source=scripts/build_functions.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/build_functions.sh"

runs=3
if [[ ${1:-} =~ ^[0-9]{1,4}$ ]]; then runs=$1; shift; fi
first=${FIRST:-1}
folder=$root/build/rounding
build "$folder" all -DBUILD_EXAMPLES=OFF -DBUILD_BENCHMARKS=OFF
library=$folder/perturbed_math.so
cc -O2 -Wall -Wextra -Werror -fno-builtin -shared -fPIC "$root/test/Inter_angle_remeshing/perturbed_math.c" -o "$library" -ldl -lm

result=0
for (( seed = first; seed < first + runs; ++seed )); do
  echo "With the seed $seed:"
  MATH_SEED=$seed LD_PRELOAD=$library ctest --test-dir "$folder" --tests-regex '^test_' --output-on-failure --no-tests=error \
    --parallel "$(job_count)" "$@" || result=1
done
exit "$result"
