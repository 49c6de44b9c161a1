// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURE_DETECTION_IMPL_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURE_DETECTION_IMPL_H

#include <CGAL/Inter_angle_remeshing/internal/Feature_detector.h>
#include <CGAL/Inter_angle_remeshing/internal/edge_lengths.h>
#include <CGAL/Inter_angle_remeshing/internal/feature_detection.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

CGAL_INTER_ANGLE_REMESHING_INLINE
std::vector<Remeshing_mesh::Index> find_features(const Remeshing_mesh& mesh)
{
  return Feature_detector(mesh, mean_edge_length(mesh)).features();
}

CGAL_INTER_ANGLE_REMESHING_INLINE
std::vector<Remeshing_mesh::Index> find_features(const Remeshing_mesh& mesh, double length, double fillet_width,
                                                 double relief_density)
{
  Feature_detector detector(mesh, (std::max)(length, mean_edge_length(mesh)));
  return detector.features_for(std::vector<double>(mesh.number_of_face_slots(), length), fillet_width, relief_density).edges;
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURE_DETECTION_IMPL_H
