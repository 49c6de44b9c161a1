// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_GEOMETRY_POWER_OF_TWO_UNIT_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_GEOMETRY_POWER_OF_TWO_UNIT_H

#include <CGAL/Inter_angle_remeshing/internal/geometry/Vector3.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// The largest coordinate of a difference, taken with what was the largest so far.
inline double larger_extent(double extent, const Vector3& d)
{
  return (std::max)({extent, std::abs(d.x), std::abs(d.y), std::abs(d.z)});
}

// The power of two in whose units an extent lies in [1/2, 1): squares and products then neither overflow nor vanish, and the way there
// and back is exact.
inline double power_of_two_unit(double extent)
{
  constexpr int MAXIMUM_EXPONENT = 1000;   // 2^-1000 and 2^1000 are both normal numbers
  int exponent = 0;
  if (extent > 0 && std::isfinite(extent)) std::frexp(extent, &exponent);
  return std::ldexp(1., (std::max)(-MAXIMUM_EXPONENT, (std::min)(MAXIMUM_EXPONENT, exponent)));
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_GEOMETRY_POWER_OF_TWO_UNIT_H
