// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_SPLIT_PASS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_SPLIT_PASS_H

#include <CGAL/Inter_angle_remeshing/internal/Remeshing_context.h>
#include <CGAL/Inter_angle_remeshing/internal/evaluate_then_apply.h>

#include <vector>

// Splits edges that are longer than about 4/3 of the target length at their midpoints (Zheng and Lv, edge splitting).

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// A vertex that a split made, and the face onto which the far end of the split edge was projected.
struct Split_vertex
{
  Remeshing_mesh::Index vertex, far_hint;
};

// New vertices that one task projects; a walk takes about 50 ns.
constexpr std::size_t PROJECTION_BLOCK = 256;

// Whether the faces around v keep their orientation when v moves to p: no normal turns by more than 60 degrees.
inline bool keeps_orientation(const Remeshing_mesh& mesh, Remeshing_mesh::Index v, const Vector3& p)
{
  return mesh.all_around(v, [&](Remeshing_mesh::Index h) {
    const Vector3 &a = mesh.position(mesh.target(h)), &b = mesh.position(mesh.apex(h)), &q = mesh.position(v);
    return is_cosine_at_least(triangle_cross(q, a, b), triangle_cross(p, a, b), 0.5);
  });
}

// Moves the new vertices that do not lie on a curve onto the surface, from the nearer one of the two places where
// the ends of their edges were projected. Where that would fold the surface over, they stay on the edge.
template <class ConcurrencyTag, class Context>
void project_split_vertices(Context& context, const std::vector<Split_vertex>& split)
{
  using Index = Remeshing_mesh::Index;
  Remeshing_mesh& mesh = context.mesh;
  std::vector<Vector3> projected(split.size());
  for_each_block<ConcurrencyTag>(split.size(), PROJECTION_BLOCK, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) {
      const Index v = split[i].vertex;
      const Vector3& q = mesh.position(v);
      Index hint = mesh.hint(v), other = split[i].far_hint;
      projected[i] = context.projector(q, hint);
      if (other != mesh.hint(v)) {
        const Vector3 p = context.projector(q, other);
        if (squared_distance(p, q) < squared_distance(projected[i], q)) { projected[i] = p; hint = other; }
      }
      mesh.hint(v) = hint;
    }
  });
  for (std::size_t i = 0; i < split.size(); ++i) {
    const Index v = split[i].vertex;
    if (mesh.is_free(v) && keeps_orientation(mesh, v, projected[i])) mesh.position(v) = projected[i];
  }
}

// Whether a triangle at the edge of h has an edge more than 1.5 times as long. That one goes first, or needles would
// multiply; where it is protected, to halve the others would only make the triangle flat.
inline bool is_beside_much_longer_edge(const Remeshing_mesh& mesh, Remeshing_mesh::Index h)
{
  const double bound = 2.25 * mesh.squared_edge_length(h);
  for (const Remeshing_mesh::Index side : {h, mesh.opposite(h)})
    if (side >= 0 && (mesh.squared_edge_length(mesh.next(side)) > bound ||
                      mesh.squared_edge_length(mesh.prev(side)) > bound)) return true;
  return false;
}

// Splits the edges of `long_edges` as far as they are still too long; appends short edges at new vertices to
// `short_edges`. Returns the number of splits.
template <class ConcurrencyTag, class Context>
std::size_t split_pass(Context& context, std::vector<Remeshing_mesh::Index>& long_edges,
                       std::vector<Remeshing_mesh::Index>& short_edges)
{
  using Index = Remeshing_mesh::Index;
  Remeshing_mesh& mesh = context.mesh;
  const double limit = context.squared_length_limit(), shortness = context.squared_shortness_limit();
  const auto midpoint = [&](Index h) { return 0.5 * (mesh.position(mesh.origin(h)) + mesh.position(mesh.target(h))); };

  std::vector<Split_vertex> split;
  evaluate_then_apply<ConcurrencyTag>(mesh, long_edges,
    [&](Index h) -> bool {
      if (!(mesh.squared_edge_length(h) > limit) || !mesh.is_split_legal(h) || is_beside_much_longer_edge(mesh, h))
        return false;
      const Vector3 p = midpoint(h);
      return p != mesh.position(mesh.origin(h)) && p != mesh.position(mesh.target(h)) && context.permits_split(h);
    },
    [&](Index h, bool is_to_split) {
      if (!is_to_split) return;
      const Index far_hint = mesh.hint(mesh.target(h));
      context.visitor.before_split(Mesh_halfedge(h), mesh);
      const Index v = mesh.split(h, midpoint(h));
      context.visitor.after_split(Mesh_vertex(v), mesh);
      split.push_back({v, far_hint});
      mesh.for_each_around(v, [&](Index k) {
        if (mesh.squared_edge_length(k) < shortness) short_edges.push_back(k);
      });
    });
  project_split_vertices<typename Context::template Projection_tag<ConcurrencyTag>>(context, split);
  return split.size();
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_SPLIT_PASS_H
