// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_CURVES_CURVES_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_CURVES_CURVES_H

#include <CGAL/Inter_angle_remeshing/internal/mesh/Remeshing_mesh.h>

// Curves are chains of border or feature edges.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// A curve that turns by this angle or more has a corner there. (Cosine of 45 degrees.)
constexpr double CORNER_COSINE = 0.7071067811865476;

// Calls `function(h)` for the half-edges, a border side perhaps, that leave v on curve edges.
template <class Function>
void for_each_curve_halfedge(const Remeshing_mesh& mesh, Remeshing_mesh::Index v, const Function& function)
{
  Remeshing_mesh::Index last = -1;
  mesh.for_each_around(v, [&](Remeshing_mesh::Index h) {
    if (mesh.is_on_curve_edge(h)) function(h);
    last = h;
  });
  if (mesh.is_border_vertex(v)) function(~mesh.prev(last));
}

inline double squared_distance_to_segment(const Vector3& q, const Vector3& a, const Vector3& b)
{
  const Vector3 ab = b - a;
  const double t = dot(q - a, ab), l = squared_length(ab);
  if (t <= 0) return squared_distance(q, a);
  if (t >= l) return squared_distance(q, b);
  return squared_distance(q, a + (t / l) * ab);
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_CURVES_CURVES_H
