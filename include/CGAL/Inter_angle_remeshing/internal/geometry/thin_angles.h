// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_GEOMETRY_THIN_ANGLES_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_GEOMETRY_THIN_ANGLES_H

#include <CGAL/Inter_angle_remeshing/internal/geometry/Vector3.h>

#include <algorithm>

// Beside a curve, whose vertices do not get out of the way, a thin face stays. There no operation may make an angle under
// 20 degrees that is smaller than the smallest one before. (Elsewhere a thin face is often the way out of a jam.
// What moves vertices into the band is stricter, see Angle_descent.h.)

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// Squared sine of 20 degrees.
constexpr double THIN_SQUARED_SINE = 0.116977778440511;
// That of 25 degrees: the bound of relaxation where no edge is split, also far from curves, as no split mends a thin face there.
constexpr double THIN_SQUARED_SINE_OF_KEPT_EDGES = 0.178606195156730;

// That of 10 degrees: a face with a smaller angle is very thin, see Remeshing_context::holds_needles().
constexpr double VERY_THIN_SQUARED_SINE = 0.030153689607046;

// The smallest angle of a triangle lies between its two longest edges. Its squared sine, for the squared lengths of the
// cross product and of the edges; 0 where the triangle has shrunk to a point.
inline double squared_sine_of_smallest_angle(double cross_product, double x, double y, double z)
{
  const double longest = (std::max)({x * y, y * z, z * x});
  return longest > 0 ? cross_product / longest : 0.;
}

inline double squared_sine_of_smallest_angle(const Vector3& a, const Vector3& b, const Vector3& c)
{
  return squared_sine_of_smallest_angle(squared_length(triangle_cross(a, b, c)), squared_distance(a, b),
                                        squared_distance(b, c), squared_distance(c, a));
}

// Two edges of a triangle that lie on curves make no larger angle than 100 degrees: nothing could mend it.
constexpr double CURVE_CORNER_COSINE = -0.17364817766693;

// Whether a squared sine is smaller than it was by more than rounding: a vertex that slides towards a corner of the input leaves the angle
// there as it is.
inline bool is_thinner(double after, double before) { return after < (1 - 1e-9) * before; }

// By the squared sines of the smallest angle before and after an operation.
inline bool makes_thin_angle(double before, double after) { return after < THIN_SQUARED_SINE && is_thinner(after, before); }

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_GEOMETRY_THIN_ANGLES_H
