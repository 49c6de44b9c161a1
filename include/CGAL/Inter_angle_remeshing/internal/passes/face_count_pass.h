// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_FACE_COUNT_PASS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_FACE_COUNT_PASS_H

#include <CGAL/Inter_angle_remeshing/internal/Remeshing_context.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/collapse_pass.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/low_valence_pass.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/split_pass.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

// Meets a wanted number of faces when the target length has brought the mesh near it: collapses the shortest edges that are
// left, or splits the longest ones. The sweeps that follow even them out.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// At most this part of the faces is added or removed: more would spoil the valences.
constexpr double MOST_CORRECTED = 0.1;
// What collapses may do: the valence of the merged vertex, and how far the removed one may lie from the new surface, in tolerances of
// the recipe. Those that spoil less come first; where there are curves, none goes beyond the tolerance.
struct Surplus_limits
{
  int valence;
  double tolerance;
};
constexpr Surplus_limits SURPLUS_LIMITS[] = {{7, 1}, {8, 1}, {7, 2}, {8, 2}, {8, 4}};

// Whether so many faces too many are those that borders and features cost: no collapse takes them away.
inline bool is_due_to_curves(const Remeshing_mesh& mesh, std::size_t faces, std::size_t wanted_faces)
{
  return mesh.has_curves() && double(faces) > (1 + MOST_CORRECTED) * double(wanted_faces);
}

// The edges that are not on curves, by their length over what their target length is, the shortest one first.
inline std::vector<std::pair<double, Remeshing_mesh::Index>> edges_by_length(const Remeshing_context& context)
{
  using Index = Remeshing_mesh::Index;
  const Remeshing_mesh& mesh = context.mesh;
  std::vector<std::pair<double, Index>> result;
  mesh.for_each_edge([&](Index h) {
    if (!mesh.is_on_curve_edge(h))
      result.emplace_back(mesh.squared_edge_length(h) / context.squared_length_limit(mesh.origin(h), mesh.target(h)), h);
  });
  std::sort(result.begin(), result.end());
  return result;
}

// Returns the number of collapses.
inline std::size_t collapse_surplus(Remeshing_context& context, std::size_t wanted_faces)
{
  using Index = Remeshing_mesh::Index;
  Remeshing_mesh& mesh = context.mesh;
  const std::size_t faces = mesh.number_of_live_faces();
  const std::size_t goal = (std::max)(wanted_faces, faces - std::size_t(MOST_CORRECTED * double(faces)));
  if (faces <= goal + 1) return 0;
  const auto edges = edges_by_length(context);
  std::size_t collapses = 0;
  for (const Surplus_limits& surplus : SURPLUS_LIMITS) {
    if (surplus.tolerance > 1 && mesh.has_curves()) break;
    const Collapse_limits limits{CGAL::square(CLEAN_UP_LENGTH * context.target_length),
                                 CGAL::square(surplus.tolerance * context.collapse_tolerance()), surplus.valence};
    for (const auto& e : edges) {
      if (mesh.number_of_live_faces() <= goal + 1) break;
      const Index h = e.second;
      if (mesh.origin(h) < 0 || mesh.is_on_curve_edge(h)) continue;
      const Index k = choose_collapse(context, h, limits);
      if (k == NO_COLLAPSE) continue;
      collapse(context, k);
      ++collapses;
    }
  }
  return collapses;
}

// Returns the number of splits.
template <class ConcurrencyTag>
std::size_t split_for_deficit(Remeshing_context& context, std::size_t wanted_faces)
{
  using Index = Remeshing_mesh::Index;
  Remeshing_mesh& mesh = context.mesh;
  const std::size_t faces = mesh.number_of_live_faces();
  const std::size_t goal = (std::min)(wanted_faces, faces + std::size_t(MOST_CORRECTED * double(faces)));
  if (faces + 1 >= goal) return 0;
  std::vector<Split_vertex> made;
  const auto edges = edges_by_length(context);
  std::vector<char> is_cut(mesh.number_of_face_slots(), 0);
  for (auto e = edges.rbegin(); e != edges.rend() && mesh.number_of_live_faces() + 1 < goal; ++e) {
    const Index h = e->second, f = mesh.face(h), g = mesh.face(mesh.opposite(h));
    if (std::size_t((std::max)(f, g)) >= is_cut.size() || is_cut[f] || is_cut[g]) continue;
    if (!mesh.is_split_legal(h) || !context.permits_split(h)) continue;
    made.push_back(split(context, h));
    mesh.for_each_around(made.back().vertex, [&](Index k) {
      if (std::size_t(mesh.face(k)) < is_cut.size()) is_cut[mesh.face(k)] = 1;
    });
  }
  project_split_vertices<ConcurrencyTag>(context, made);
  return made.size();
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_FACE_COUNT_PASS_H
