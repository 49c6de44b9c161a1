#!/usr/bin/env bash
# Copyright (c) 2026 The Inter_angle_remeshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# install_dependencies.sh: installs what the package, its tests, examples, benchmarks and documentation need on Debian
# and Ubuntu. Only what is missing is installed; where nothing is, it says so and does nothing.
set -euo pipefail

meshes=/usr/share/doc/libcgal-dev/data.tar.gz # from libcgal-demo

fail() { echo "install_dependencies.sh: $*" >&2; exit 1; }

is_installed() { [[ $(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null) == installed ]]; }

# Tools may have come from elsewhere than a package, so the command counts; libraries are asked for by package.
list_missing() {
  command -v g++ >/dev/null || echo g++
  command -v cmake >/dev/null || echo cmake
  command -v make >/dev/null || echo make
  command -v doxygen >/dev/null || echo doxygen
  local package
  for package in libcgal-dev libeigen3-dev libboost-dev libtbb-dev libgmp-dev libmpfr-dev libbenchmark-dev libopenmesh-dev; do
    is_installed "$package" || echo "$package"
  done
  # Container images leave out what lies under /usr/share/doc, although the package counts as installed.
  { is_installed libcgal-demo && [[ -f $meshes ]]; } || echo libcgal-demo
}

command -v apt-get >/dev/null ||
  fail "apt-get was not found; install CGAL 5.5, Eigen 3, TBB, Boost, GMP, MPFR, Google Benchmark, OpenMesh and doxygen by hand."

mapfile -t missing < <(list_missing)
if (( ${#missing[@]} == 0 )); then
  echo "install_dependencies.sh: everything is installed."
  exit 0
fi

as_root=()
if (( EUID != 0 )); then
  command -v sudo >/dev/null || fail "installing ${missing[*]} needs root or sudo."
  as_root=(sudo)
fi

log=$(mktemp)
trap 'rm -f "$log"' EXIT
apt() { "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -y "$@" >"$log" 2>&1; }

echo "install_dependencies.sh: installing ${missing[*]} ..." >&2
# A list that cannot be refreshed need not matter: the installation below decides.
apt update || true
options=(--no-install-recommends)
# Brings the meshes in where files below /usr/share/doc are left out (dpkg wants their folder included, too) ...
for path in "${meshes%/*}" "$meshes"; do options+=(-o "Dpkg::Options::=--path-include=$path"); done
# ... even where the package has been installed without them.
if is_installed libcgal-demo && [[ ! -f $meshes ]]; then options+=(--reinstall); fi
apt install "${options[@]}" "${missing[@]}" || { cat "$log" >&2; fail "apt-get could not install ${missing[*]}."; }
