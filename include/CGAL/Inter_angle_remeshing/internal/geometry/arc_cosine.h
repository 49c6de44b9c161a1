// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_GEOMETRY_ARC_COSINE_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_GEOMETRY_ARC_COSINE_H

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// The arc cosine in degrees, to 2e-6 degrees: M. Abramowitz and I. Stegun, Handbook of Mathematical Functions, 4.4.46.
// Without a branch or a call, so that the compiler can treat several at once.
inline double arc_cosine_in_degrees(double cosine)
{
  constexpr double A[] = {1.5707963050, -0.2145988016, 0.0889789874, -0.0501743046,
                          0.0308918810, -0.0170881256, 0.0066700901, -0.0012624911};
  const double x = (std::min)(1., std::abs(cosine));
  const double polynomial =
    ((((((A[7] * x + A[6]) * x + A[5]) * x + A[4]) * x + A[3]) * x + A[2]) * x + A[1]) * x + A[0];
  const double angle = std::sqrt(1 - x) * polynomial;
  return (cosine < 0 ? CGAL_PI - angle : angle) * (180 / CGAL_PI);
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_GEOMETRY_ARC_COSINE_H
