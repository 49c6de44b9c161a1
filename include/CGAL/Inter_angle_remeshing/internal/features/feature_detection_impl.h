// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_FEATURE_DETECTION_IMPL_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_FEATURE_DETECTION_IMPL_H

#include <CGAL/Inter_angle_remeshing/internal/features/Feature_detector.h>
#include <CGAL/Inter_angle_remeshing/internal/features/Wider_mesh.h>
#include <CGAL/Inter_angle_remeshing/internal/features/cad_parts.h>
#include <CGAL/Inter_angle_remeshing/internal/features/feature_detection.h>
#include <CGAL/Inter_angle_remeshing/internal/features/look_at_range.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/edge_lengths.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// What `find(detector, lengths)` finds in the range, `mesh`, and around it; the lengths are `scale` by face, or, if that is 0, the mean
// edge length.
template <class Find>
Features_around find_features_around(const Remeshing_mesh& mesh, const Remeshing_mesh& wider, double scale, const Find& find)
{
  struct Found
  {
    bool is_cad, range_may_be_cad;
    Features_around features;
  };
  return look_at_range(mesh, wider, scale > 0 ? scale : mean_edge_length(mesh), [&](const Remeshing_mesh& seen) {
    const double unit = mesh.unit() / seen.unit(), length = scale > 0 ? unit * scale : mean_edge_length(seen);
    const bool is_alone = &seen == &mesh;
    Feature_detector detector(seen, unit * scale);
    Found found{detector.kind().is_cad(), !is_alone && detector.kind().may_be_cad(mesh.number_of_face_slots()), {{}, is_alone}};
    found.features.edges =
      features_with_parts(seen, detector, unit * scale, std::vector<double>(seen.number_of_face_slots(), length), find).edges;
    return found;
  }).features;
}

CGAL_INTER_ANGLE_REMESHING_INLINE
Features_around find_features_around(const Remeshing_mesh& mesh, const Remeshing_mesh& wider)
{
  return find_features_around(mesh, wider, 0, [](Feature_detector& d, const std::vector<double>& lengths) { return d.features(lengths); });
}

CGAL_INTER_ANGLE_REMESHING_INLINE
std::vector<Remeshing_mesh::Index> find_features(const Remeshing_mesh& mesh)
{
  return find_features_around(mesh, Remeshing_mesh()).edges;
}

CGAL_INTER_ANGLE_REMESHING_INLINE
std::vector<Remeshing_mesh::Index> find_features_for(const Remeshing_mesh& mesh, const Remeshing_mesh& wider, double scale,
                                                     double fillet_width, double relief_density)
{
  Features_around found = find_features_around(mesh, wider, scale, [&](Feature_detector& d, const std::vector<double>& lengths) {
    return d.features_for(lengths, fillet_width, relief_density).edges; });
  keep_own_edges(found.edges, mesh);
  return std::move(found.edges);
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_FEATURE_DETECTION_IMPL_H
