// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_FIELD_DETAIL_PASS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_FIELD_DETAIL_PASS_H

#include <CGAL/Inter_angle_remeshing/internal/Remeshing_context.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/cross_products.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/split_pass.h>

#include <CGAL/number_utils.h>

#include <cstddef>
#include <vector>

// Before the iterations, where the target length is a function of the position: passes ask it at vertices alone, and large faces may hide
// where it is short. Such faces are cut, the longest edges first, until it is about as short at a vertex.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// The edge whose split comes first if the longest edge of face f is to be split: the one at the end of the path on which each face
// is left by its longest edge. It is that of both its faces, so that no split makes needles.
inline Remeshing_mesh::Index edge_to_split_first(const Remeshing_mesh& mesh, Remeshing_mesh::Index f)
{
  Remeshing_mesh::Index h = longest_edge(mesh, f);
  while (mesh.opposite(h) >= 0) {
    const Remeshing_mesh::Index next = longest_edge(mesh, mesh.face(mesh.opposite(h)));
    if (!(mesh.squared_edge_length(next) > mesh.squared_edge_length(h))) break;
    h = next;
  }
  return h;
}

// Returns the number of splits.
template <class ConcurrencyTag>
std::size_t field_detail_pass(Remeshing_context& context)
{
  using Index = Remeshing_mesh::Index;
  // A face hides lengths that are so many times as short as those at its corners. What is cut is cut further while it has edges so many
  // times as long as it is at a corner: else the iterations, which halve edges once each, would not end there.
  constexpr double HIDDEN = 1.5, COARSE = 4;
  constexpr std::size_t MOST_SPLITS = 1 << 18;     // as a function may have details of any number
  Remeshing_mesh& mesh = context.mesh;
  std::vector<Split_vertex> made;
  std::vector<Index> faces;
  for (Index first = 0, end = Index(mesh.number_of_face_slots()); first < end; ++first) {
    if (!mesh.is_face(first) || !context.sizing.looks_inside(mesh, first)) continue;
    faces.assign(1, first);
    for (bool is_cut = false; !faces.empty() && made.size() < MOST_SPLITS; is_cut = true) {
      const Index f = faces.back();
      faces.pop_back();
      const auto [at_corners, inside] = context.sizing.shortest_parts(mesh, f);
      const bool hides_detail = HIDDEN * inside < at_corners;
      if (!hides_detail && !is_cut) continue;
      const double bound = (hides_detail ? 1 : COARSE) * inside * context.target_length;
      if (mesh.squared_edge_length(longest_edge(mesh, f)) <= CGAL::square(bound)) continue;
      const Index h = edge_to_split_first(mesh, f);
      if (!mesh.is_split_legal(h) || !context.permits_split(h)) continue;
      made.push_back(split(context, h));
      faces.push_back(f);
      mesh.for_each_around(made.back().vertex, [&](Index k) { faces.push_back(mesh.face(k)); });
    }
  }
  project_split_vertices<ConcurrencyTag>(context, made);
  return made.size();
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_FIELD_DETAIL_PASS_H
