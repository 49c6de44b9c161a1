// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_INPUT_KIND_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_INPUT_KIND_H

#include <CGAL/Inter_angle_remeshing/Recipe.h>
#include <CGAL/Inter_angle_remeshing/Remeshing_report.h>
#include <CGAL/Inter_angle_remeshing/internal/constraints.h>
#include <CGAL/Inter_angle_remeshing/internal/feature_detection.h>
#include <CGAL/Inter_angle_remeshing/internal/projector_traits.h>
#include <CGAL/Inter_angle_remeshing/internal/referred.h>
#include <CGAL/Inter_angle_remeshing/internal/rounded_edges.h>
#include <CGAL/Inter_angle_remeshing/internal/target_of_run.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// What the dihedral angles tell about the input.
struct Input_kind
{
  bool is_cad;                   // the dihedral angles tell a CAD model
  bool is_faceted;               // so they do, or a wrap of one, or stairs of voxels: its faces are no samples of a smooth surface
  bool searches_features;        // its sharp edges were looked for, and those that were found are constrained
  Remeshing_report::Features features;
  std::size_t feature_edges;
  double saddle_excess;          // how noisy it is, see Model_kind::saddle_excess()
  Rounded_edges rounded_edges;   // among the features
};

inline std::size_t count_features(const Remeshing_mesh& mesh)
{
  std::size_t n = 0;
  mesh.for_each_halfedge([&](Remeshing_mesh::Index h) { n += mesh.is_constrained(h) && mesh.names_edge(h); });
  return n;
}

// Features are found by themselves where nothing is marked, and where the surface stays the input's: a functor of the
// user's may lead to any other, a sphere for an icosahedron.
template <class Parameters>
Input_kind find_and_mark_features(Remeshing_mesh& mesh, const Target& target, double mean_length, const Parameters& parameters)
{
  using Functor = std::decay_t<decltype(referred(parameters.projection_functor))>;
  constexpr bool keeps_surface = std::is_same<Functor, No_map>::value || Has_reference_surface<Functor>::value;
  using Features = Remeshing_report::Features;
  Input_kind kind{false, false, false, Features::none, count_features(mesh), 0, {}};
  if (kind.feature_edges > 0) kind.features = Features::marked;
  if (!keeps_surface || parameters.recipe.surface == Recipe::Surface::paper) return kind;
  Feature_detector detector(mesh, (std::max)(target.length, mean_length));
  kind.is_cad = detector.kind().is_cad();
  kind.is_faceted = kind.is_cad || detector.kind().has_jagged_chamfers() || detector.kind().has_voxel_stairs();
  kind.saddle_excess = detector.kind().saddle_excess();
  kind.searches_features = parameters.constraint_settings.finds_features;
  if (!kind.searches_features) return kind;
  Found_features found = detector.features_for([&](Remeshing_mesh::Index f) {
    return target.length * target.sizing.part_of_face(mesh.face_record(f).source); },
    parameters.recipe.fillet_width, parameters.recipe.relief_density);
  for (const Remeshing_mesh::Index h : found.edges) mark_found_feature(mesh, h, parameters.constraint_settings);
  kind.rounded_edges = std::move(found.rounded);
  if (!found.edges.empty()) kind.features = kind.is_cad ? Features::all_sharp_edges : Features::outstanding_edges;
  kind.feature_edges = count_features(mesh);
  return kind;
}

// Designed curves are not jagged; where the fillets of a part are joined across a corner, they are.
inline std::vector<double> scales_of_corners(const Remeshing_mesh& mesh, const Input_kind& kind, double target)
{
  std::vector<double> scales(mesh.number_of_vertex_slots(), kind.is_cad ? 0. : target);
  for (const Remeshing_mesh::Index h : kind.rounded_edges.edges) scales[mesh.origin(h)] = scales[mesh.target(h)] = target;
  return scales;
}

// How rough noise makes the stars of a mesh with edges of the target length: the shorter these are beside the input's, the rougher.
inline double noise(const Input_kind& kind, double mean_length, double target)
{
  return target > 0 ? kind.saddle_excess * (mean_length / target) * (mean_length / target) : 0.;
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_INPUT_KIND_H
