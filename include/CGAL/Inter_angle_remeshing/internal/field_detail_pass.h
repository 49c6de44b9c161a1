// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_FIELD_DETAIL_PASS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_FIELD_DETAIL_PASS_H

#include <CGAL/Inter_angle_remeshing/internal/Remeshing_context.h>
#include <CGAL/Inter_angle_remeshing/internal/split_pass.h>

#include <cstddef>
#include <vector>

// Before the iterations, where the target length is a function of the position: passes ask it at vertices alone, and large faces may hide
// where it is short. Such faces are cut, along the longest edge first, until it is about as short at a vertex.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// The edge of face f that is the longest one of those that may be split; negative: none may.
inline Remeshing_mesh::Index longest_edge_to_split(const Remeshing_context& context, Remeshing_mesh::Index f)
{
  using Index = Remeshing_mesh::Index;
  const Remeshing_mesh& mesh = context.mesh;
  Index longest = -1;
  for (Index h = 4 * f; h < 4 * f + 3; ++h)
    if ((longest < 0 || mesh.squared_edge_length(h) > mesh.squared_edge_length(longest)) && mesh.is_split_legal(h) &&
        context.permits_split(h)) longest = h;
  return longest;
}

// Returns the number of splits.
template <class ConcurrencyTag>
std::size_t field_detail_pass(Remeshing_context& context)
{
  using Index = Remeshing_mesh::Index;
  // A face hides lengths that are so many times as short as those at its corners. What is cut is cut further while it has edges so many
  // times as long as it is at a corner.
  constexpr double HIDDEN = 1.5, COARSE = 4;
  constexpr std::size_t MOST_SPLITS = 1 << 18;
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
      const Index h = longest_edge_to_split(context, f);
      const double bound = (hides_detail ? 1 : COARSE) * inside * context.target_length;
      if (h < 0 || mesh.squared_edge_length(h) <= CGAL::square(bound)) continue;
      made.push_back(split(context, h));
      mesh.for_each_around(made.back().vertex, [&](Index k) { faces.push_back(mesh.face(k)); });
    }
  }
  project_split_vertices<ConcurrencyTag>(context, made);
  return made.size();
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_FIELD_DETAIL_PASS_H
