// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_INPUT_KIND_IMPL_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_INPUT_KIND_IMPL_H

#include <CGAL/Inter_angle_remeshing/internal/Feature_detector.h>
#include <CGAL/Inter_angle_remeshing/internal/input_kind.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

inline std::size_t count_features(const Remeshing_mesh& mesh)
{
  std::size_t n = 0;
  mesh.for_each_halfedge([&](Remeshing_mesh::Index h) { n += mesh.is_constrained(h) && mesh.names_edge(h); });
  return n;
}

CGAL_INTER_ANGLE_REMESHING_INLINE
Input_kind find_and_mark_features(Remeshing_mesh& mesh, const Target& target, double mean_length, bool keeps_surface,
                                  const Recipe& recipe, const Constraint_settings& settings)
{
  using Features = Remeshing_report::Features;
  Input_kind kind{false, false, false, false, Features::none, count_features(mesh), 0, {}};
  if (kind.feature_edges > 0) kind.features = Features::marked;
  if (!keeps_surface || recipe.surface == Recipe::Surface::paper) return kind;
  Feature_detector detector(mesh, (std::max)(target.length, mean_length));
  kind.is_cad = detector.kind().is_cad();
  kind.is_leaf = detector.kind().is_leaf();
  kind.is_faceted = kind.is_cad || detector.kind().has_jagged_chamfers() || detector.kind().has_voxel_stairs();
  kind.saddle_excess = detector.kind().saddle_excess();
  kind.searches_features = settings.finds_features;
  if (!kind.searches_features) return kind;
  std::vector<double> lengths(mesh.number_of_face_slots());
  for (Remeshing_mesh::Index f = 0; f < Remeshing_mesh::Index(lengths.size()); ++f)
    lengths[f] = target.length * target.sizing.part_of_face(mesh.face_record(f).source);
  Found_features found = detector.features_for(std::move(lengths), recipe.fillet_width, recipe.relief_density);
  for (const Remeshing_mesh::Index h : found.edges) mark_found_feature(mesh, h, settings);
  kind.rounded_edges = std::move(found.rounded);
  if (!found.edges.empty()) kind.features = kind.is_cad ? Features::all_sharp_edges : Features::outstanding_edges;
  kind.feature_edges = count_features(mesh);
  return kind;
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_INPUT_KIND_IMPL_H
