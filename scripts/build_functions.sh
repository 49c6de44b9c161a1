# shellcheck shell=bash
# Copyright (c) 2026 The Inter_angle_remeshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Sourced by test.sh and demo.sh.

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)

fail() { echo "${0##*/}: $*" >&2; exit 1; }

# Prints the smallest of the machine's free memory and the limit of its container, in MiB.
available_memory() {
  local mib limit file
  mib=$(awk '/^MemAvailable:/ {print int($2 / 1024)}' /proc/meminfo)
  for file in /sys/fs/cgroup/memory.max /sys/fs/cgroup/memory/memory.limit_in_bytes; do
    limit=$(cat "$file" 2>/dev/null || echo max)
    if [[ $limit =~ ^[0-9]{1,15}$ ]] && (( limit >> 20 < mib )); then mib=$(( limit >> 20 )); fi
  done
  echo "$mib"
}

# Prints how many compilers to run: one a core, as long as each has the 3 GiB that a test under the sanitizers may take.
job_count() {
  local jobs by_memory
  jobs=$(nproc)
  by_memory=$(( $(available_memory) / 3000 ))
  if (( by_memory < jobs )); then jobs=$by_memory; fi
  if (( jobs < 1 )); then jobs=1; fi
  echo "$jobs"
}

# run_quietly LOG COMMAND...: shows the end of the log only where the command fails.
run_quietly() {
  local log=$1
  shift
  "$@" >"$log" 2>&1 || { tail -n 200 "$log" >&2; fail "the build failed; the whole log is in $log"; }
}

# build FOLDER TARGET CMAKE_OPTION...: configures and builds this package in FOLDER.
build() {
  local folder=$1 target=$2
  shift 2
  "$root/scripts/install_dependencies.sh" >/dev/null
  mkdir -p "$folder"
  run_quietly "$folder/configure.log" cmake -S "$root" -B "$folder" -DCMAKE_BUILD_TYPE=Release "$@"
  echo "${0##*/}: building ..."
  run_quietly "$folder/build.log" cmake --build "$folder" --target "$target" --parallel "$(job_count)"
}
