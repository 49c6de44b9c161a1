// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_PLACE_ON_SURFACE_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_PLACE_ON_SURFACE_H

#include <CGAL/Inter_angle_remeshing/internal/Remeshing_context.h>

#include <limits>

// Where on the surface a point of a face is.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

struct Place_on_surface
{
  Vector3 point;
  Remeshing_mesh::Index facet = -1;
  double squared_distance = std::numeric_limits<double>::infinity();
};

// The place nearest to p, a point of face f, of those where the walks from the corners of f over the surface end, for one alone may get
// stuck at an edge of it; or the first one whose squared distance is less than `enough`. The projector has faces.
inline Place_on_surface place_on_surface(const Remeshing_context& context, Remeshing_mesh::Index f, const Vector3& p, double enough = 0)
{
  Place_on_surface result;
  for (const Remeshing_mesh::Index v : context.mesh.face_record(f).vertex) {
    Remeshing_mesh::Index hint = context.mesh.hint(v);
    const Vector3 q = context.projector(p, hint);
    if (const double d = squared_distance(p, q); d < result.squared_distance) result = {q, hint, d};
    if (result.squared_distance < enough) break;
  }
  return result;
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_PLACE_ON_SURFACE_H
