// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_LOST_SURFACE_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_LOST_SURFACE_H

#include <CGAL/Inter_angle_remeshing/internal/Remeshing_context.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/Face_grid.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/surface_walk.h>

#include <cstddef>

// What of the surface the mesh has lost: where faces of a coarse level are as long as a rounded corner is thick, they bite it off, and
// the finer ones, which lie on the surface vertex by vertex, do not find it again.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// Whether a vertex of the surface is farther away than the direct way would hardly leave one.
inline bool loses_surface(const Remeshing_context& context)
{
  using Index = Remeshing_mesh::Index;
  constexpr double LARGEST_DISTANCE = 1;         // in target lengths
  if (!context.projector.is_input()) return false;
  const Remeshing_mesh& mesh = context.mesh;
  const Reference_surface& surface = *context.projector.surface;
  const double distance = LARGEST_DISTANCE * context.largest_length();
  const Vector3 reach{distance, distance, distance};
  Face_grid grid(mesh, context.largest_length());
  Visit_marks marks;
  std::size_t looks = 0;
  for (Index v = 0; v < Index(surface.number_of_vertices()); ++v) {
    const Vector3 p = (1 / context.projector.factor) * surface.position(v);
    bool is_found = false;
    grid.for_each_near(p - reach, p + reach, marks, [&](Index f) {
      ++looks;
      is_found = squared_distance(closest_point_on_face(mesh, p, f).point, p) < distance * distance;
      return !is_found;
    });
    if (!is_found) return true;
    if (are_enough_looks(mesh, looks)) return false;
  }
  return false;
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_LOST_SURFACE_H
