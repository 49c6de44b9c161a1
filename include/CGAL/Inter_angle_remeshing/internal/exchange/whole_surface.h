// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_EXCHANGE_WHOLE_SURFACE_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_EXCHANGE_WHOLE_SURFACE_H

#include <CGAL/Inter_angle_remeshing/internal/arguments/refuse.h>
#include <CGAL/Inter_angle_remeshing/internal/exchange/flat_copy.h>
#include <CGAL/Inter_angle_remeshing/internal/geometry/to_vector3.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/space_filling_order.h>

#include <CGAL/tags.h>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// All faces of a mesh, for a projector: in space-filling order, `source` of a face its number in `faces`.
template <class TriangleMesh, class VertexPointMap>
Flat_copy<TriangleMesh> copy_whole_surface(const TriangleMesh& tmesh, VertexPointMap vpm, const char* caller)
{
  auto copy = Flat_copy_builder<TriangleMesh, VertexPointMap>(tmesh, vpm, caller).build(faces(tmesh));
  if (copy.faces.empty()) refuse(caller, "the mesh has no face");
  copy.mesh.template renumber<CGAL::Sequential_tag>(morton_order(copy.mesh));
  return copy;
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_EXCHANGE_WHOLE_SURFACE_H
