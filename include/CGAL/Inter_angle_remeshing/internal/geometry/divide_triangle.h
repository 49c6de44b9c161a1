// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_GEOMETRY_DIVIDE_TRIANGLE_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_GEOMETRY_DIVIDE_TRIANGLE_H

#include <CGAL/Inter_angle_remeshing/internal/geometry/Vector3.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// Divides a triangle that has points on its sides into triangles that have none, by edges between these points and its corners: each
// time from the middle one of the points of the longest side that has some to the corner opposite. `loop` are its corners and the points
// between these, counterclockwise, `corners` where in there the corners are. Returns triples of places in the loop, counterclockwise.
inline std::vector<std::array<std::size_t, 3>> divide_triangle(const std::vector<Vector3>& loop, const std::array<std::size_t, 3>& corners)
{
  struct Part
  {
    std::array<std::size_t, 3> corners;
    std::array<std::size_t, 3> points;   // by side, the first of which leads from the first corner to the second: how many there are
  };
  const std::size_t n = loop.size();
  const auto points_between = [&](std::size_t a, std::size_t b) { return (b + n - a) % n - 1; };
  std::vector<Part> parts{{corners, {points_between(corners[0], corners[1]), points_between(corners[1], corners[2]),
                                     points_between(corners[2], corners[0])}}};
  std::vector<std::array<std::size_t, 3>> result;
  while (!parts.empty()) {
    const auto [c, points] = parts.back();
    parts.pop_back();
    int side = -1;
    double longest = 0;
    for (int k = 0; k < 3; ++k) {
      const double length = squared_distance(loop[c[k]], loop[c[(k + 1) % 3]]);
      if (points[k] == 0 || (side >= 0 && !(length > longest))) continue;
      longest = length;
      side = k;
    }
    if (side < 0) { result.push_back(c); continue; }
    const std::size_t a = c[side], b = c[(side + 1) % 3], apex = c[(side + 2) % 3], before = (points[side] - 1) / 2;
    const std::size_t middle = (a + before + 1) % n;
    parts.push_back({{a, middle, apex}, {before, 0, points[(side + 2) % 3]}});
    parts.push_back({{middle, b, apex}, {points[side] - 1 - before, points[(side + 1) % 3], 0}});
  }
  return result;
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_GEOMETRY_DIVIDE_TRIANGLE_H
