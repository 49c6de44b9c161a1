// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_FEATURE_DETECTION_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_FEATURE_DETECTION_H

#include <CGAL/Inter_angle_remeshing/internal/compiled.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/Remeshing_mesh.h>

#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// One half-edge of each feature of a mesh, sorted: at the scale of its own edges.
CGAL_INTER_ANGLE_REMESHING_INLINE
std::vector<Remeshing_mesh::Index> find_features(const Remeshing_mesh& mesh);

struct Features_around
{
  std::vector<Remeshing_mesh::Index> edges;      // one half-edge of each, sorted
  bool are_of_range_alone;
};

// The same of a range and the faces around it, by the numbers of the wider mesh, see Wider_mesh; or of the range alone where it is told by
// that, or there is no wider mesh.
CGAL_INTER_ANGLE_REMESHING_INLINE
Features_around find_features_around(const Remeshing_mesh& mesh, const Remeshing_mesh& wider);

// Those of the range that edges of this length would cut off; 0: those that the mesh has on its own. The other arguments are those of
// Feature_detector::features_for().
CGAL_INTER_ANGLE_REMESHING_INLINE
std::vector<Remeshing_mesh::Index> find_features_for(const Remeshing_mesh& mesh, const Remeshing_mesh& wider, double scale,
                                                     double fillet_width, double relief_density);

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#ifndef CGAL_INTER_ANGLE_REMESHING_COMPILED
#  include <CGAL/Inter_angle_remeshing/internal/features/feature_detection_impl.h>
#endif

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_FEATURE_DETECTION_H
