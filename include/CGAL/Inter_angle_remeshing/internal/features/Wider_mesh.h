// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_WIDER_MESH_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_WIDER_MESH_H

#include <CGAL/Inter_angle_remeshing/internal/mesh/Remeshing_mesh.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// A range together with faces around it: the dihedral angles of a few faces do not tell what kind of model they are a part of. Faces of
// the range, and their corners, have the same numbers as in its own mesh; vertices need not, and the unit may be another one. It is empty
// where a range has no faces around it.
struct Wider_mesh
{
  Remeshing_mesh mesh;
  std::vector<Remeshing_mesh::Index> nearest_face;    // of the range, by face
};

// Drops the edges of a wider mesh that lie outside of `mesh`, and those on its rim, which are its border.
inline void keep_own_edges(std::vector<Remeshing_mesh::Index>& edges, const Remeshing_mesh& mesh)
{
  const auto is_none = [&](Remeshing_mesh::Index h) {
    return h >= Remeshing_mesh::Index(4 * mesh.number_of_face_slots()) || mesh.is_border(h); };
  edges.erase(std::remove_if(edges.begin(), edges.end(), is_none), edges.end());
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_WIDER_MESH_H
