// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_CURVES_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_CURVES_H

#include <CGAL/Inter_angle_remeshing/internal/Remeshing_mesh.h>

// Curves are chains of border or feature edges.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

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

// A chain of border or feature edges that turns by this angle or more has a corner there. (Cosine of 45 degrees.)
constexpr double CORNER_COSINE = 0.7071067811865476;

// The way from v over its curve neighbor u to the first vertex that does not lie where v does.
struct Curve_arm
{
  Vector3 direction;
  bool passes_locked = false;    // whether one of the vertices that lie where v does is locked
};

inline Curve_arm curve_arm(const Remeshing_mesh& mesh, Remeshing_mesh::Index v, Remeshing_mesh::Index u)
{
  constexpr int MAXIMUM_STEPS = 64;
  Curve_arm arm;
  Remeshing_mesh::Index previous = v;
  for (int step = 0; step < MAXIMUM_STEPS && mesh.position(u) == mesh.position(v); ++step) {
    arm.passes_locked = arm.passes_locked || mesh.is_locked(u);
    Remeshing_mesh::Index following = v;
    int edges = 0;
    for_each_curve_halfedge(mesh, u, [&](Remeshing_mesh::Index h) {
      const Remeshing_mesh::Index w = mesh.source(mesh.opposite(h));
      ++edges;
      if (w != previous) following = w;
    });
    if (edges != 2 || following == v) break;
    previous = u;
    u = following;
  }
  arm.direction = mesh.position(u) - mesh.position(v);
  return arm;
}

// Locks the corners of curves: ends, junctions, turns, and where a constrained part of the border begins. Of several
// vertices at a turn that lie in the same place, one is locked, so that the edges without length between them can go.
inline void lock_corners(Remeshing_mesh& mesh)
{
  for (Remeshing_mesh::Index v = 0; v < Remeshing_mesh::Index(mesh.number_of_vertex_slots()); ++v) {
    if (!mesh.is_on_curve(v)) continue;
    int edges = 0, constrained = 0;
    Curve_arm arms[2];
    for_each_curve_halfedge(mesh, v, [&](Remeshing_mesh::Index h) {
      if (edges < 2) arms[edges] = curve_arm(mesh, v, mesh.source(mesh.opposite(h)));
      constrained += mesh.is_constrained(h < 0 ? ~h : h);
      ++edges;
    });
    const bool is_end = edges != 2 || constrained == 1;
    const bool turns = !is_cosine_at_least(arms[0].direction, -1. * arms[1].direction, CORNER_COSINE);
    if (is_end || (turns && !arms[0].passes_locked && !arms[1].passes_locked))
      mesh.add_marks(v, Remeshing_mesh::LOCKED);
  }
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_CURVES_H
