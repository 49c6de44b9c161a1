// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_INPUT_KIND_IMPL_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_INPUT_KIND_IMPL_H

#include <CGAL/Inter_angle_remeshing/internal/features/Feature_detector.h>
#include <CGAL/Inter_angle_remeshing/internal/features/cad_parts.h>
#include <CGAL/Inter_angle_remeshing/internal/features/input_kind.h>

#include <cstddef>
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

CGAL_INTER_ANGLE_REMESHING_INLINE
Input_kind find_and_mark_features(Remeshing_mesh& mesh, const Target& target, double mean_length, bool keeps_surface,
                                  double crest_width, const Recipe& recipe, const Constraint_settings& settings)
{
  using Features = Remeshing_report::Features;
  Input_kind kind{false, false, false, Features::none, features_of(mesh).size(), 0, {}, {}};
  if (kind.feature_edges > 0) kind.features = Features::marked;
  if (!keeps_surface || recipe.surface == Recipe::Surface::paper) return kind;
  Feature_detector detector(mesh, target.length);
  kind.is_cad = detector.kind().is_cad();
  kind.is_faceted = kind.is_cad || detector.kind().has_jagged_chamfers() || detector.kind().has_voxel_stairs();
  kind.saddle_excess = detector.kind().saddle_excess();
  kind.searches_features = settings.finds_features;
  // Where vertices only move, features are those of the edges that there are.
  const bool keeps_vertices = !(target.length > 0);
  std::vector<double> lengths(mesh.number_of_face_slots());
  for (Remeshing_mesh::Index f = 0; f < Remeshing_mesh::Index(lengths.size()); ++f)
    lengths[f] = (keeps_vertices ? mean_length : target.length) * target.sizing.part_of_face(mesh.face_record(f).source);
  const Features_with_parts found = features_with_parts(mesh, detector, target.length, lengths,
                                                        [&](Feature_detector& of_part, const std::vector<double>& lengths_there) {
    if (!kind.searches_features) return std::vector<Remeshing_mesh::Index>();
    if (keeps_vertices) return of_part.features(lengths_there);
    Found_features there = of_part.features_for(lengths_there, recipe.fillet_width, recipe.relief_density);
    if (&of_part == &detector) kind.rounded_edges = std::move(there.rounded);
    return there.edges;
  });
  for (const Remeshing_mesh::Index h : found.edges) mark_found_feature(mesh, h, settings);
  if (!found.edges.empty()) kind.features = kind.is_cad ? Features::all_sharp_edges : Features::outstanding_edges;
  if (!found.faces.empty()) kind.is_in_cad_part.resize(mesh.number_of_face_slots());
  for (const Remeshing_mesh::Index f : found.faces) kind.is_in_cad_part[mesh.face_record(f).source] = 1;
  const std::vector<Remeshing_mesh::Index> features = features_of(mesh);
  kind.feature_edges = features.size();
  mark_crests(mesh, detector.crests(features, std::move(lengths), crest_width));
  return kind;
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_INPUT_KIND_IMPL_H
