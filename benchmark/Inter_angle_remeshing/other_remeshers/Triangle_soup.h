// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTER_ANGLE_REMESHING_BENCHMARK_TRIANGLE_SOUP_H
#define INTER_ANGLE_REMESHING_BENCHMARK_TRIANGLE_SOUP_H

#include <array>
#include <cstddef>
#include <vector>

// A mesh as all libraries can take it.
struct Triangle_soup
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::size_t, 3>> triangles;
};

// What a remesher makes of it, and in which time, that of reading and writing the soup left out.
struct Timed_soup
{
  Triangle_soup soup;
  double seconds = 0;
};

#endif // INTER_ANGLE_REMESHING_BENCHMARK_TRIANGLE_SOUP_H
