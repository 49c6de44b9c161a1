// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_CURVES_SETTLE_CORNERS_IMPL_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_CURVES_SETTLE_CORNERS_IMPL_H

#include <CGAL/Inter_angle_remeshing/internal/curves/close_curve_vertices.h>
#include <CGAL/Inter_angle_remeshing/internal/curves/corners.h>
#include <CGAL/Inter_angle_remeshing/internal/curves/jagged_curves.h>
#include <CGAL/Inter_angle_remeshing/internal/curves/settle_corners.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/crossing_faces.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// Designed curves are not jagged; where the fillets of a part are joined across a corner, they are. Crests, and the seams and borders
// that are marked here, are as jagged as the input's edges.
inline std::vector<double> scales_of_corners(Remeshing_mesh& mesh, const Input_kind& kind, double target)
{
  constexpr double CREST_SCALE = 2;
  std::vector<double> scales(mesh.number_of_vertex_slots(), kind.is_cad ? 0. : target);
  for (const Remeshing_mesh::Index h : kind.rounded_edges.edges) scales[mesh.origin(h)] = scales[mesh.target(h)] = target;
  mesh.for_each_edge([&](Remeshing_mesh::Index h) {
    if (mesh.has_flag(h, Remeshing_mesh::PASSING)) scales[mesh.origin(h)] = scales[mesh.target(h)] = CREST_SCALE * target; });
  if (target > 0) Jagged_curves(mesh, kind.is_cad).mark(target, scales);
  return scales;
}

// The faces of `mesh` with such a vertex that cross others, as pairs with these.
template <class Predicate>
std::vector<std::pair<Remeshing_mesh::Index, Remeshing_mesh::Index>> crossings_at(const Remeshing_mesh& mesh, const Predicate& is_vertex)
{
  std::vector<Remeshing_mesh::Index> all, faces;
  for (Remeshing_mesh::Index f = 0; f < Remeshing_mesh::Index(mesh.number_of_face_slots()); ++f) {
    if (!mesh.is_face(f)) continue;
    all.push_back(f);
    const auto& corner = mesh.face_record(f).vertex;
    if (std::any_of(corner, corner + 3, is_vertex)) faces.push_back(f);
  }
  return crossing_faces(mesh, faces, all);
}

// `scales` are those of corners. Where the target length is long beside the cross section of a part, what is tiny is the part itself, whose
// sides would cross each other: what makes faces do so that did not is not merged, or nothing where that is not found in a few rounds. Nor are
// vertices within curves where these would only touch each other, and soon again.
inline void merge_curve_vertices(Remeshing_mesh& mesh, const Input_kind& kind, const Target& target, double merging_distance,
                                 const std::vector<double>& scales)
{
  using Index = Remeshing_mesh::Index;
  constexpr int ROUNDS = 8, ROUNDS_OF_TOUCHING = 4;
  std::vector<char> is_corner = find_corners(mesh, scales, CHAMFER_COSINE), is_joint(mesh.number_of_vertex_slots(), 0);
  for (const Index v : kind.rounded_edges.joints) is_corner[v] = is_joint[v] = 1;
  std::vector<char> stays(mesh.number_of_vertex_slots(), 0), stays_apart(mesh.number_of_vertex_slots(), 0);
  std::optional<Remeshing_mesh> before;
  for (int round = 1; round <= ROUNDS; ++round) {
    const auto tolerance = [&](Index v) {
      const double part = target.sizing.part_of_face(mesh.face_record(mesh.face(mesh.first(v))).source);
      return stays[v] ? 0. : (is_joint[v] ? Rounded_edges::JOINT_LENGTH : merging_distance) * target.length * part;
    };
    Close_curve_vertices close_vertices(mesh, is_corner, tolerance, stays_apart);
    if (!close_vertices.are_there()) return;
    if (!before) before = mesh;
    close_vertices.merge();
    const std::vector<Index> touching = close_vertices.touching();
    if (touching.empty()) {
      const std::vector<char> is_merged = close_vertices.are_merged();
      const auto is_one = [&](Index v) { return is_merged[v] != 0; };
      const auto crossings = crossings_at(mesh, is_one);
      if (crossings.empty() || !crossings_at(*before, is_one).empty()) return;
      std::vector<char> crosses(stays.size(), 0);
      for (const auto& [f, g] : crossings)
        for (const Index x : {f, g})
          for (const Index v : mesh.face_record(x).vertex) crosses[v] = 1;
      for (Index v = 0; v < Index(stays.size()); ++v) stays[v] |= crosses[close_vertices.became(v)];
    }
    if (round >= ROUNDS_OF_TOUCHING) stays_apart.assign(stays_apart.size(), 1);
    for (const Index v : touching) stays_apart[v] = 1;
    mesh = *before;
  }
}

CGAL_INTER_ANGLE_REMESHING_INLINE
void settle_corners(Remeshing_mesh& mesh, const Input_kind& kind, const Target& target, double merging_distance)
{
  const std::vector<double> scales = scales_of_corners(mesh, kind, target.length);
  if (merging_distance > 0 && target.length > 0) merge_curve_vertices(mesh, kind, target, merging_distance, scales);
  lock_corners(mesh, scales);
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_CURVES_SETTLE_CORNERS_IMPL_H
