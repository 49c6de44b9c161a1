// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_MLS_REFERENCE_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_MLS_REFERENCE_H

#include <CGAL/Inter_angle_remeshing/internal/features/feature_detection.h>
#include <CGAL/Inter_angle_remeshing/internal/geometry/Sample_tree.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/Mls_surface.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/upsampling.h>

#include <memory>
#include <mutex>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// A reference surface, the MLS surface over it, and a search structure for queries of which nothing is known.
class Mls_reference
{
public:
  using Index = Reference_surface::Index;

  explicit Mls_reference(const Remeshing_mesh& mesh) : surface_(mesh), mls_(surface_, find_features(mesh)) {}
  Mls_reference(const Mls_reference&) = delete;
  Mls_reference& operator=(const Mls_reference&) = delete;

  const Reference_surface& surface() const { return surface_; }
  const Mls_surface& mls() const { return mls_; }

  // The closest point of the facets to q that can be reached downhill from the nearest sample; f becomes its face.
  // Where `normal` is not zero, from the nearest sample of a face that looks the same way, if one is near.
  Point_on_triangle locate(const Vector3& q, Index& f, const Vector3& normal = Vector3()) const
  {
    f = nearest_face(q, normal);
    return surface_.closest_point_near(q, f);
  }

private:
  // Samples among which one is looked for whose face looks the same way, and the cosine that counts as the same way.
  static constexpr unsigned CANDIDATES = 16;
  static constexpr double COMPATIBLE_COSINE = 0.3;

  struct Samples
  {
    explicit Samples(const std::vector<Vector3>& points) : tree(points) {}
    Sample_tree tree;
    std::vector<Index> faces;
  };

  Index nearest_face(const Vector3& q, const Vector3& normal) const
  {
    const Samples& s = samples();
    if (s.tree.empty()) return 0;          // nothing but degenerate faces
    const Index nearest = s.faces[s.tree.nearest(q)];
    if (normal == Vector3() || is_compatible(nearest, normal)) return nearest;
    for (const std::size_t i : s.tree.nearest(q, CANDIDATES))
      if (is_compatible(s.faces[i], normal)) return s.faces[i];
    return nearest;
  }

  bool is_compatible(Index f, const Vector3& normal) const
  {
    return is_cosine_at_least(surface_.cross_product(f), normal, COMPATIBLE_COSINE);
  }

  const Samples& samples() const
  {
    std::call_once(samples_are_made_, [this]() {
      std::vector<Vector3> points;
      std::vector<Index> faces;
      for_each_sample(mls_, [&](const Surface_sample& s) {
        points.push_back(s.point);
        faces.push_back(s.face);
      });
      samples_ = std::make_unique<Samples>(points);
      samples_->faces = std::move(faces);
    });
    return *samples_;
  }

  Reference_surface surface_;
  Mls_surface mls_;
  // Made by the first query that needs them: warm starts do without.
  mutable std::once_flag samples_are_made_;
  mutable std::unique_ptr<Samples> samples_;
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_MLS_REFERENCE_H
