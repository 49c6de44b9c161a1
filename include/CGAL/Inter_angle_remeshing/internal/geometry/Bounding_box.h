// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_GEOMETRY_BOUNDING_BOX_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_GEOMETRY_BOUNDING_BOX_H

#include <CGAL/Inter_angle_remeshing/internal/geometry/Vector3.h>

#include <algorithm>
#include <limits>

// Boxes without branches: whether two of thousands overlap is not foretold well.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// The corners of the box around two points.
inline Vector3 lower_corner(const Vector3& a, const Vector3& b)
{
  return {(std::min)(a.x, b.x), (std::min)(a.y, b.y), (std::min)(a.z, b.z)};
}
inline Vector3 upper_corner(const Vector3& a, const Vector3& b)
{
  return {(std::max)(a.x, b.x), (std::max)(a.y, b.y), (std::max)(a.z, b.z)};
}

// Empty at first.
struct Bounding_box
{
  static constexpr double INF = std::numeric_limits<double>::infinity();

  Vector3 low{INF, INF, INF}, high{-INF, -INF, -INF};

  Bounding_box() = default;
  Bounding_box(const Vector3& a, const Vector3& b, const Vector3& c)
    : low(lower_corner(lower_corner(a, b), c)), high(upper_corner(upper_corner(a, b), c))
  {}

  Bounding_box& operator+=(const Vector3& p)
  {
    low = lower_corner(low, p);
    high = upper_corner(high, p);
    return *this;
  }
  Bounding_box& operator+=(const Bounding_box& b)
  {
    low = lower_corner(low, b.low);
    high = upper_corner(high, b.high);
    return *this;
  }
};

// Whether they have a point in common.
inline bool do_overlap(const Bounding_box& a, const Bounding_box& b)
{
  const Vector3 gap = upper_corner(a.low - b.high, b.low - a.high);
  return !((std::max)((std::max)(gap.x, gap.y), gap.z) > 0);
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_GEOMETRY_BOUNDING_BOX_H
