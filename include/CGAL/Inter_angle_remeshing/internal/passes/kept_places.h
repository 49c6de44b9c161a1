// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_KEPT_PLACES_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_KEPT_PLACES_H

#include <CGAL/Inter_angle_remeshing/internal/mesh/Remeshing_mesh.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <unordered_map>
#include <vector>

// What mends angles would rather have no tips: step by step it draws back from the end of a tail or a claw, and none of the steps
// is long. So the places on the surface are noted from which the mesh may withdraw so far and no farther.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

class Kept_places
{
  using Index = Remeshing_mesh::Index;

public:
  // How far the mesh may withdraw from a place, in target lengths.
  static constexpr double LONGEST_WITHDRAWAL = 0.5;

  // From now on the places are those where the vertices are, each the one of its vertex.
  void note(const Remeshing_mesh& mesh)
  {
    merged_.clear();
    own_.assign(mesh.number_of_vertex_slots(), {});
    for (Index v = 0; v < Index(own_.size()); ++v)
      if (mesh.is_vertex(v)) own_[v] = mesh.position(v);
  }

  // Before a vertex is merged into another one.
  void hand_over(Index removed, Index kept)
  {
    if (own_.empty()) return;
    std::vector<Vector3> places;
    all_of(removed, [&](const Vector3& p) { places.push_back(p); return true; });
    if (std::size_t(removed) < own_.size()) own_[removed].reset();
    merged_.erase(removed);
    std::vector<Vector3>& all = merged_[kept];
    all.insert(all.end(), places.begin(), places.end());
  }

  // Whether the predicate holds for all places of a vertex.
  template <class Predicate>
  bool all_of(Index v, const Predicate& predicate) const
  {
    if (std::size_t(v) < own_.size() && own_[v] && !predicate(*own_[v])) return false;
    const auto merged = merged_.find(v);
    return merged == merged_.end() || std::all_of(merged->second.begin(), merged->second.end(), predicate);
  }

private:
  std::vector<std::optional<Vector3>> own_;                    // by vertex
  std::unordered_map<Index, std::vector<Vector3>> merged_;     // of vertices that were merged into this one
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_KEPT_PLACES_H
