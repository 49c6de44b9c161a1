// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_LOOK_AT_RANGE_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_LOOK_AT_RANGE_H

#include <CGAL/Inter_angle_remeshing/internal/features/Wider_mesh.h>
#include <CGAL/Inter_angle_remeshing/internal/features/cad_parts.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/Remeshing_mesh.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// Drops the edges of a wider mesh that lie outside of `mesh`, and those on its rim, which are its border.
inline void keep_own_edges(std::vector<Remeshing_mesh::Index>& edges, const Remeshing_mesh& mesh)
{
  const auto is_none = [&](Remeshing_mesh::Index h) {
    return h >= Remeshing_mesh::Index(4 * mesh.number_of_face_slots()) || mesh.is_border(h); };
  edges.erase(std::remove_if(edges.begin(), edges.end(), is_none), edges.end());
}

// What `look(seen, face_of_range)` finds in the wider mesh, as far as it is there in the range, `mesh`; or in the range alone, where that
// is a CAD model beside what is none, and large beside the length. Face f of the mesh `seen` is nearest to face `face_of_range(f)` of
// the range.
template <class Look>
auto look_at_range(const Remeshing_mesh& mesh, const Wider_mesh& wider, double length, const Look& look)
{
  using Index = Remeshing_mesh::Index;
  const auto look_at_it_alone = [&]() { return look(mesh, [](Index f) { return f; }); };
  if (!wider.is_there()) return look_at_it_alone();
  auto found = look(wider.mesh, [&](Index f) { return wider.nearest_face[f]; });
  if (!found.is_cad && found.range_may_be_cad && is_large_part(mesh, length))
    if (auto alone = look_at_it_alone(); alone.is_cad) return alone;
  found.keep_part(mesh, wider.mesh);
  return found;
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_LOOK_AT_RANGE_H
