// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_ROUNDED_EDGES_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_ROUNDED_EDGES_H

#include <CGAL/Inter_angle_remeshing/internal/mesh/Remeshing_mesh.h>

#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// The fillets of a CAD model, as features.
struct Rounded_edges
{
  std::vector<Remeshing_mesh::Index> edges;         // one half-edge of each, sorted
  // Vertices of features between junctions that are so close together that they should be one.
  std::vector<Remeshing_mesh::Index> joints;
  // How close, in target lengths.
  static constexpr double JOINT_LENGTH = 0.35;
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_ROUNDED_EDGES_H
