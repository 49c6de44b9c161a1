// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_FEATURE_DETECTION_IMPL_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_FEATURE_DETECTION_IMPL_H

#include <CGAL/Inter_angle_remeshing/internal/features/Feature_detector.h>
#include <CGAL/Inter_angle_remeshing/internal/features/cad_parts.h>
#include <CGAL/Inter_angle_remeshing/internal/features/feature_detection.h>
#include <CGAL/Inter_angle_remeshing/internal/features/look_at_range.h>
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
std::vector<Remeshing_mesh::Index> find_features(const Remeshing_mesh& mesh, const Wider_mesh& wider, double scale, double fillet_width,
                                                 double relief_density)
{
  struct Found
  {
    bool is_cad, range_may_be_cad;
    std::vector<Remeshing_mesh::Index> edges;
    void keep_part(const Remeshing_mesh& mesh, const Remeshing_mesh&) { keep_own_edges(edges, mesh); }
  };
  return look_at_range(mesh, wider, scale > 0 ? scale : mean_edge_length(mesh), [&](const Remeshing_mesh& seen, const auto&) {
    const double unit = mesh.unit() / seen.unit(), length = scale > 0 ? unit * scale : mean_edge_length(seen);
    Feature_detector detector(seen, unit * scale);
    Found found{detector.kind().is_cad(), &seen != &mesh && detector.kind().may_be_cad(mesh.number_of_face_slots()), {}};
    found.edges = features_with_parts(seen, detector, unit * scale, std::vector<double>(seen.number_of_face_slots(), length),
                                      [&](Feature_detector& d, const std::vector<double>& lengths) {
      return d.features_for(lengths, fillet_width, relief_density).edges; }).edges;
    return found;
  }).edges;
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_FEATURE_DETECTION_IMPL_H
