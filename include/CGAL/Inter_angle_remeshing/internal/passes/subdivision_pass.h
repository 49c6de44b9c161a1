// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_SUBDIVISION_PASS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_SUBDIVISION_PASS_H

#include <CGAL/Inter_angle_remeshing/internal/curves/curves.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/split_pass.h>

#include <algorithm>
#include <type_traits>
#include <vector>

// Cuts every face into four at the middles of its edges. The vertices that this makes are regular: the irregular ones stay as
// few as they were while the faces multiply. Protected edges stay whole: of a face beside one come three.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// Where the surface at the two ends of an edge does not differ by more than this, 26 degrees, the middle of the edge is near
// enough for the sweeps that follow, which pull it back.
constexpr double FLAT_EDGE_COSINE = 0.9;

// Whether the new vertex is to be pulled onto the surface at once.
inline bool is_on_bent_edge(const Remeshing_context& context, const Split_vertex& middle)
{
  if (!context.mesh.is_free(middle.vertex)) return false;
  if (!context.projector.has_faces()) return true;
  const Reference_surface& surface = *context.projector.surface;
  return middle.hint != middle.other_hint &&
         !is_cosine_at_least(surface.cross_product(middle.hint), surface.cross_product(middle.other_hint), FLAT_EDGE_COSINE);
}

// Makes one edge of the two edges of a curve that meet in each of these vertices, of which nobody was told.
inline void join_halves(Remeshing_mesh& mesh, const std::vector<Remeshing_mesh::Index>& middles)
{
  for (const Remeshing_mesh::Index v : middles) {
    Remeshing_mesh::Index half = -1;
    for_each_curve_halfedge(mesh, v, [&](Remeshing_mesh::Index h) { half = h; });
    mesh.collapse(half);
  }
}

// Where the halves of two edges of a face were joined away from the corner between them, one face spans its three corners, and the
// middle of the third edge lies on that face's edge: what is flat there goes with a flip.
inline void flip_at_middles_on_edges(Remeshing_mesh& mesh)
{
  using Index = Remeshing_mesh::Index;
  const auto spans_three_corners = [&](Index h) {
    return mesh.is_protected(mesh.next(h)) && mesh.is_protected(mesh.prev(h)) && !mesh.is_on_curve_edge(h); };
  for (Index f = 0; f < Index(mesh.number_of_face_slots()); ++f) {
    if (!mesh.is_face(f) || !mesh.has_protected_edge(f)) continue;
    for (Index h = 4 * f; h < 4 * f + 3; ++h)
      if (spans_three_corners(h)) {
        mesh.flip(h);
        break;
      }
  }
}

// Returns the number of edges bisected. The mesh is in a space-filling order, and stays in it.
template <class ConcurrencyTag>
std::size_t subdivision_pass(Remeshing_context& context)
{
  using Index = Remeshing_mesh::Index;
  Remeshing_mesh& mesh = context.mesh;
  if (mesh.has_free_slots()) mesh.renumber<ConcurrencyTag>(mesh.block_order());
  const Remeshing_mesh::Subdivision_numbers numbers = mesh.subdivision_numbers();
  const std::size_t n = numbers.edges.size();
  std::vector<Vector3> points(n);
  std::vector<Split_vertex> middles(n);
  std::vector<Index> middles_of_protected;
  for (const Index h : numbers.edges)
    if (mesh.is_protected(h)) middles_of_protected.push_back(numbers.middle[h]);
  for_each_block<ConcurrencyTag>(n, SCAN_BLOCK, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) {
      const Index h = numbers.edges[i];
      points[i] = split_point(context, h);
      middles[i] = split_hints(context, h);
      middles[i].vertex = numbers.middle[h];
    }
  });
  if (context.visitor.listens())
    for (const Index h : numbers.edges)
      if (!mesh.is_protected(h)) context.visitor.before_split(Mesh_halfedge(h), mesh);
  mesh.subdivide<ConcurrencyTag>(numbers, points);
  for (const Split_vertex& middle : middles) mesh.hint(middle.vertex) = middle.hint;
  if (!middles_of_protected.empty()) {
    join_halves(mesh, middles_of_protected);
    flip_at_middles_on_edges(mesh);
  }
  middles.erase(std::remove_if(middles.begin(), middles.end(), [&](const Split_vertex& m) { return !mesh.is_vertex(m.vertex); }),
                middles.end());
  if (context.visitor.listens())
    for (const Split_vertex& middle : middles) context.visitor.after_split(Mesh_vertex(middle.vertex), mesh);
  middles.erase(std::remove_if(middles.begin(), middles.end(),
                               [&](const Split_vertex& middle) { return !is_on_bent_edge(context, middle); }), middles.end());
  project_split_vertices<ConcurrencyTag>(context, middles);
  return n - middles_of_protected.size();
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_SUBDIVISION_PASS_H
