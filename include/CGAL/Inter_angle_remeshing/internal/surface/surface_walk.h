// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_SURFACE_WALK_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_SURFACE_WALK_H

#include <CGAL/Inter_angle_remeshing/internal/geometry/closest_point_on_triangle.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/Remeshing_mesh.h>

// Walks over a surface to the point of it that is closest to another one, downhill in distance. A walk does not cross a
// constrained edge: it stays in its patch. `Surface` is a `Corner_table` with the positions of its vertices.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// Steps of a walk; one visits 1.7 faces on the average, but hundreds where these are needles. The bound only keeps rounding from
// running in circles.
constexpr int MAXIMUM_WALK = 100000;
// A step of the walk must come nearer by this fraction of the squared distance: more than rounding.
constexpr double NEARER = 1 - 1e-12;

template <class Surface>
Point_on_triangle closest_point_on_face(const Surface& surface, const Vector3& q, Corner_table::Index f)
{
  const Corner_table::Face& t = surface.face_record(f);
  return closest_point_on_triangle(q, surface.position(t.vertex[0]), surface.position(t.vertex[1]), surface.position(t.vertex[2]));
}

inline bool is_barrier(const Corner_table& surface, Corner_table::Index h)
{
  return (surface.face_record(h >> 2).edge_flags & (Remeshing_mesh::CONSTRAINED << (h & 3))) != 0;
}

// Looks at the faces around the origin of h, as far as no barrier is in between.
template <class Surface>
bool walk_around_vertex(const Surface& surface, const Vector3& q, Corner_table::Index h, Corner_table::Index& f,
                        Point_on_triangle& best, double& distance)
{
  using Index = Corner_table::Index;
  bool is_nearer = false;
  const auto look_at = [&](Index k) {
    const Point_on_triangle c = closest_point_on_face(surface, q, surface.face(k));
    const double d = squared_distance(q, c.point);
    if (d < distance * NEARER) {
      is_nearer = true;
      distance = d;
      best = c;
      f = surface.face(k);
    }
  };
  Index k = h;
  while (!is_barrier(surface, surface.prev(k))) {
    k = surface.rotate_ccw(k);
    if (k < 0 || k == h) break;
    look_at(k);
  }
  if (k < 0 || is_barrier(surface, surface.prev(k)))
    for (k = h; !is_barrier(surface, k);) {
      k = surface.rotate_cw(k);
      if (k < 0) break;
      look_at(k);
    }
  return is_nearer;
}

// From face f, which becomes the face that the walk ends on.
template <class Surface>
Point_on_triangle walk_to_closest_point(const Surface& surface, const Vector3& q, Corner_table::Index& f)
{
  using Index = Corner_table::Index;
  Point_on_triangle best = closest_point_on_face(surface, q, f);
  double distance = squared_distance(q, best.point);
  for (int step = 0; step < MAXIMUM_WALK; ++step) {
    const int part = int(best.part);
    if (best.part == Triangle_part::interior) break;
    if (part <= int(Triangle_part::edge_ca)) {
      const Index h = 4 * f + part - int(Triangle_part::edge_ab), across = surface.opposite(h);
      if (across < 0 || is_barrier(surface, h)) break;
      const Point_on_triangle c = closest_point_on_face(surface, q, surface.face(across));
      const double d = squared_distance(q, c.point);
      if (!(d < distance * NEARER)) break;
      distance = d;
      best = c;
      f = surface.face(across);
    }
    else if (!walk_around_vertex(surface, q, 4 * f + part - int(Triangle_part::vertex_a), f, best, distance))
      break;
  }
  return best;
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_SURFACE_WALK_H
