// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_SIZING_NECKS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_SIZING_NECKS_H

#include <CGAL/Inter_angle_remeshing/internal/mesh/Remeshing_mesh.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/parallel_blocks.h>

#include <vector>

// Where a surface is a tube much thinner than the target length, a tail, a leg, a horn, the edges around it stay short: the last three of
// a ring cannot be collapsed. Edges along it that are as long as the target make needles of all its faces.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// A vertex of a ring of three edges that bounds no face, and the length from which the edges around it should not differ much.
struct Neck_vertex
{
  Remeshing_mesh::Index vertex;
  double length;
};

// Rings are thin if their edges have less than this part of the target length, on the average.
constexpr double THIN_RING = 0.5;
// Triangles that lead from ring to ring may be so much longer than a ring's edge: isosceles ones have no angle of less than 43 degrees then.
constexpr double RING_ASPECT = 1.35;

// Whether two faces of these normals face each other, or look the same way, within 45 degrees: what a ring of a flat fin encloses
// lies along its faces, not across.
inline bool is_facing(const Vector3& a, const Vector3& b)
{
  const double product = dot(a, b);
  return 2 * product * product > squared_length(a) * squared_length(b);
}

// The vertices of all thin rings, some of them several times. Curves have a rule of their own; a vertex with three neighbors, which they
// enclose, makes no neck.
template <class ConcurrencyTag>
std::vector<Neck_vertex> find_necks(const Remeshing_mesh& mesh, double target_length)
{
  using Index = Remeshing_mesh::Index;
  const double longest = THIN_RING * target_length;
  std::vector<Neck_vertex> result;
  scan_into<ConcurrencyTag>(result, mesh.number_of_face_slots(), [&](std::size_t f, std::vector<Neck_vertex>& out) {
    if (!mesh.is_face(Index(f)) || !(mesh.least_squared_edge_length(Index(f)) < longest * longest)) return;
    for (Index h = Index(4 * f); h < Index(4 * f) + 3; ++h) {
      const Index opposite = mesh.opposite(h);
      if (opposite < h || !(mesh.squared_edge_length(h) < longest * longest)) continue;
      const Index a = mesh.origin(h), b = mesh.target(h), c = mesh.apex(h), d = mesh.apex(opposite);
      if (mesh.is_on_curve(a) || mesh.is_on_curve(b) || mesh.valence(c) <= 3 || mesh.valence(d) <= 3) continue;
      mesh.for_each_neighbor(a, [&](Index u) {
        if (u == b || u == c || u == d || mesh.is_on_curve(u) || !mesh.is_adjacent(u, b)) return;
        const Vector3 &p = mesh.position(a), &q = mesh.position(b), &r = mesh.position(u);
        const double edge = (length(q - p) + length(r - q) + length(p - r)) / 3;
        if (!(edge < longest)) return;
        const Vector3 across = triangle_cross(p, q, r);
        if (is_facing(mesh.cross_product(Index(f)), across) || is_facing(mesh.cross_product(mesh.face(opposite)), across)) return;
        for (const Index v : {a, b, u}) out.push_back({v, RING_ASPECT * edge});
      });
    }
  });
  return result;
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_SIZING_NECKS_H
