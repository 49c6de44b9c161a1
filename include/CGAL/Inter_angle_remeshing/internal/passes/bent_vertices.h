// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_BENT_VERTICES_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_BENT_VERTICES_H

#include <CGAL/Inter_angle_remeshing/internal/Remeshing_context.h>

#include <vector>

// Vertices of tips and ridges, which are held while a mesh is too coarse to stand for them.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

struct Star_shape
{
  double bend;                 // 1 - ρ, ρ = |Σ c| / Σ |c| over the cross products c of the faces: 0 in a plane
  double mean_edge_length;
};

// Stars further from flat than this are those of tips and ridges.
constexpr double BENT = 0.25;

inline Star_shape star_shape(const Remeshing_mesh& mesh, Remeshing_mesh::Index v)
{
  Vector3 sum;
  double total = 0, edges = 0;
  mesh.for_each_around(v, [&](Remeshing_mesh::Index h) {
    const Vector3 c = triangle_cross(mesh.position(v), mesh.position(mesh.target(h)), mesh.position(mesh.apex(h)));
    sum += c;
    total += length(c);
    edges += length(mesh.position(mesh.target(h)) - mesh.position(v));
  });
  return {total > 0 ? 1 - length(sum) / total : 0., edges / mesh.valence(v)};
}

// Those of the input whose edges are many target lengths long. While the edges around the apex of a cone are, a step of a few of its
// faces leads far down the side, and what is lost of the apex no later step finds again.
inline std::vector<Remeshing_mesh::Index> bent_vertices_between_long_edges(const Remeshing_context& context)
{
  using Index = Remeshing_mesh::Index;
  constexpr double LONG = 4;                 // target lengths
  std::vector<Index> result;
  if (!context.projector.is_input()) return result;
  const auto target_length_at = [&](Index v) {      // the field is not read yet
    return context.target_length * (context.sizing.is_uniform() ? 1. : context.sizing.part_at(context.mesh, v, context.locator));
  };
  for (Index v = 0; v < Index(context.mesh.number_of_vertex_slots()); ++v) {
    if (!context.mesh.is_free(v)) continue;
    const Star_shape star = star_shape(context.mesh, v);
    if (star.bend > BENT && star.mean_edge_length > LONG * target_length_at(v)) result.push_back(v);
  }
  return result;
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_BENT_VERTICES_H
