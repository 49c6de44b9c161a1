// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_WIDER_MESH_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_WIDER_MESH_H

#include <CGAL/Inter_angle_remeshing/internal/mesh/Remeshing_mesh.h>

#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// A range together with faces around it: the dihedral angles of a few faces do not tell what kind of model they are a part of. Faces of
// the range, and their corners, have the same numbers as in its own mesh; vertices need not, and the unit may be another one.
struct Wider_mesh
{
  Remeshing_mesh mesh;
  std::vector<Remeshing_mesh::Index> nearest_face;    // of the range, by face

  // There is none where the range has no faces around it.
  bool is_there() const { return mesh.number_of_face_slots() > 0; }
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_WIDER_MESH_H
