// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_FEATURE_DETECTION_IMPL_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_FEATURE_DETECTION_IMPL_H

#include <CGAL/Inter_angle_remeshing/internal/features/Feature_detector.h>
#include <CGAL/Inter_angle_remeshing/internal/features/cad_parts.h>
#include <CGAL/Inter_angle_remeshing/internal/features/feature_detection.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/edge_lengths.h>

#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

CGAL_INTER_ANGLE_REMESHING_INLINE
std::vector<Remeshing_mesh::Index> find_features(const Remeshing_mesh& mesh)
{
  Feature_detector detector(mesh, 0);
  return features_with_parts(mesh, detector, 0, std::vector<double>(mesh.number_of_face_slots(), mean_edge_length(mesh)),
                             [](Feature_detector& d, const std::vector<double>& lengths) { return d.features(lengths); }).edges;
}

CGAL_INTER_ANGLE_REMESHING_INLINE
std::vector<Remeshing_mesh::Index> find_features(const Remeshing_mesh& mesh, double scale, double fillet_width,
                                                 double relief_density)
{
  const double length = scale > 0 ? scale : mean_edge_length(mesh);
  Feature_detector detector(mesh, scale);
  return features_with_parts(mesh, detector, scale, std::vector<double>(mesh.number_of_face_slots(), length),
                             [&](Feature_detector& d, const std::vector<double>& lengths) {
    return d.features_for(lengths, fillet_width, relief_density).edges; }).edges;
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_FEATURE_DETECTION_IMPL_H
