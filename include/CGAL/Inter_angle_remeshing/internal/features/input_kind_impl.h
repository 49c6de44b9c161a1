// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_INPUT_KIND_IMPL_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_INPUT_KIND_IMPL_H

#include <CGAL/Inter_angle_remeshing/internal/features/Feature_detector.h>
#include <CGAL/Inter_angle_remeshing/internal/features/cad_parts.h>
#include <CGAL/Inter_angle_remeshing/internal/features/input_kind.h>
#include <CGAL/Inter_angle_remeshing/internal/features/look_at_range.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// One half-edge of each, sorted.
inline std::vector<Remeshing_mesh::Index> features_of(const Remeshing_mesh& mesh)
{
  std::vector<Remeshing_mesh::Index> result;
  mesh.for_each_halfedge([&](Remeshing_mesh::Index h) { if (mesh.is_constrained(h) && mesh.names_edge(h)) result.push_back(h); });
  return result;
}

// What guides the iterations, and is released after them; not beside vertices that are held anyway, and must be so afterwards, nor at
// the border, whose curve it would cut in two.
inline void mark_crests(Remeshing_mesh& mesh, const std::vector<Remeshing_mesh::Index>& crests)
{
  constexpr unsigned HELD = Remeshing_mesh::LOCKED | Remeshing_mesh::PINCHED | Remeshing_mesh::ON_BORDER;
  for (const Remeshing_mesh::Index h : crests) {
    if (((mesh.marks(mesh.origin(h)) | mesh.marks(mesh.target(h))) & HELD) != 0) continue;
    mark_feature(mesh, h);
    mesh.add_flags(h, Remeshing_mesh::FOUND | Remeshing_mesh::PASSING);
  }
}

// What is known of the input once it was looked at, and what is to be marked.
struct Found_in_input
{
  Input_kind kind{};
  bool is_cad = false, range_may_be_cad = false;         // the latter alone, asked where a wider mesh was looked at
  std::vector<Remeshing_mesh::Index> edges, crests;      // one half-edge of each, sorted

  // Found in `wider`, it becomes what there is of it in `mesh`; joints are kept within, on features that are.
  void keep_part(const Remeshing_mesh& mesh, const Remeshing_mesh& wider)
  {
    for (auto* of_wider : {&edges, &crests, &kind.rounded_edges.edges}) keep_own_edges(*of_wider, mesh);
    std::vector<char> is_joint(wider.number_of_vertex_slots(), 0);
    std::vector<Remeshing_mesh::Index>& joints = kind.rounded_edges.joints;
    for (const Remeshing_mesh::Index v : joints) is_joint[v] = 1;
    joints.clear();
    const auto add = [&](Remeshing_mesh::Index v, Remeshing_mesh::Index in_wider) {
      if (!is_joint[in_wider] || mesh.is_border_vertex(v)) return;
      joints.push_back(v);
      is_joint[in_wider] = 0;
    };
    for (const Remeshing_mesh::Index h : edges) {
      add(mesh.origin(h), wider.origin(h));
      add(mesh.target(h), wider.target(h));
    }
  }
};

// What is found in `seen`, which is the mesh or a wider one, whose face f is nearest to face `face_of_range(f)` of the mesh.
template <class Function>
Found_in_input look_at_input(const Remeshing_mesh& mesh, const Remeshing_mesh& seen, const Function& face_of_range, const Target& target,
                             double mean_length, double crest_width, const Recipe& recipe, bool searches_features)
{
  using Index = Remeshing_mesh::Index;
  Found_in_input result;
  Input_kind& kind = result.kind;
  const double unit = mesh.unit() / seen.unit(), length = unit * target.length;
  Feature_detector detector(seen, length);
  kind.is_cad = result.is_cad = detector.kind().is_cad();
  kind.is_faceted = kind.is_cad || detector.kind().has_uneven_facets() || detector.kind().has_jagged_chamfers() ||
                    detector.kind().has_voxel_stairs();
  kind.saddle_excess = kind.is_cad ? 0. : detector.kind().saddle_excess();      // of a part they are details
  kind.searches_features = searches_features;
  result.range_may_be_cad = &seen != &mesh && detector.kind().may_be_cad(mesh.number_of_face_slots());
  // Where vertices only move, features are those of the edges that there are.
  const bool keeps_vertices = !(target.length > 0);
  std::vector<double> lengths(seen.number_of_face_slots());
  for (Index f = 0; f < Index(lengths.size()); ++f)
    lengths[f] = (keeps_vertices ? unit * mean_length : length) * target.sizing.part_of_face(mesh.face_record(face_of_range(f)).source);
  Features_with_parts found = features_with_parts(seen, detector, length, lengths,
                                                  [&](Feature_detector& of_part, const std::vector<double>& lengths_there) {
    if (!searches_features) return std::vector<Index>();
    if (keeps_vertices) return of_part.features(lengths_there);
    Found_features there = of_part.features_for(lengths_there, recipe.fillet_width, recipe.relief_density);
    if (&of_part == &detector) kind.rounded_edges = std::move(there.rounded);
    return there.edges;
  });
  result.edges = std::move(found.edges);
  for (const Index f : found.faces) {
    if (f >= Index(mesh.number_of_face_slots())) continue;
    kind.is_in_faceted_part.resize(mesh.number_of_face_slots());
    kind.is_in_faceted_part[mesh.face_record(f).source] = 1;
  }
  const std::vector<Index> marked = features_of(mesh);
  std::vector<Index> features;
  std::set_union(marked.begin(), marked.end(), result.edges.begin(), result.edges.end(), std::back_inserter(features));
  result.crests = detector.crests(features, std::move(lengths), crest_width);
  return result;
}

CGAL_INTER_ANGLE_REMESHING_INLINE
Input_kind find_and_mark_features(Remeshing_mesh& mesh, const Wider_mesh& wider, const Target& target, double mean_length,
                                  bool is_looked_at, double crest_width, const Recipe& recipe, const Constraint_settings& settings)
{
  using Features = Remeshing_report::Features;
  const bool has_marks = !features_of(mesh).empty();
  Found_in_input found;
  if (is_looked_at) {
    double largest_part = 0;
    for (Remeshing_mesh::Index f = 0; f < Remeshing_mesh::Index(mesh.number_of_face_slots()); ++f)
      largest_part = (std::max)(largest_part, target.sizing.part_of_face(f));
    const double length = largest_part * (target.length > 0 ? target.length : mean_length);
    found = look_at_range(mesh, wider.mesh, length, [&](const Remeshing_mesh& seen) {
      const bool is_wider = &seen != &mesh;
      const auto face_of_range = [&](Remeshing_mesh::Index f) { return is_wider ? wider.nearest_face[f] : f; };
      Found_in_input there = look_at_input(mesh, seen, face_of_range, target, mean_length, crest_width, recipe, settings.finds_features);
      if (is_wider) there.keep_part(mesh, seen);
      return there;
    });
  }
  Input_kind kind = std::move(found.kind);
  for (const Remeshing_mesh::Index h : found.edges) mark_found_feature(mesh, h, settings);
  if (!found.edges.empty()) kind.features = kind.is_cad ? Features::all_sharp_edges : Features::outstanding_edges;
  else kind.features = has_marks ? Features::marked : Features::none;
  kind.feature_edges = features_of(mesh).size();
  mark_crests(mesh, found.crests);
  return kind;
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_INPUT_KIND_IMPL_H
