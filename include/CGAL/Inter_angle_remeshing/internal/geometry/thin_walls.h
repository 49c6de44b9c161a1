// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_GEOMETRY_THIN_WALLS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_GEOMETRY_THIN_WALLS_H

#include <CGAL/Inter_angle_remeshing/internal/geometry/Vector3.h>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// Whether the sides of a wall could have these normals, of any length: there are 150 degrees and more between them. A zero one looks
// nowhere.
inline bool look_to_opposite_sides(const Vector3& u, const Vector3& v)
{
  constexpr double WALL_COSINE = 0.866;
  return is_cosine_at_least(u, -1. * v, WALL_COSINE);
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_GEOMETRY_THIN_WALLS_H
