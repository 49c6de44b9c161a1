// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_LOOK_AT_RANGE_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_LOOK_AT_RANGE_H

#include <CGAL/Inter_angle_remeshing/internal/features/cad_parts.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/Remeshing_mesh.h>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// What `look(seen)` finds in the wider mesh, if that has faces, or in the range alone, `mesh`, where that is a CAD model beside what is
// none, and large beside the length.
template <class Look>
auto look_at_range(const Remeshing_mesh& mesh, const Remeshing_mesh& wider, double length, const Look& look)
{
  if (wider.number_of_face_slots() == 0) return look(mesh);
  auto found = look(wider);
  if (!found.is_cad && found.range_may_be_cad && is_large_part(mesh, length))
    if (auto alone = look(mesh); alone.is_cad) return alone;
  return found;
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_LOOK_AT_RANGE_H
