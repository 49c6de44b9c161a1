// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_UPSAMPLING_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_UPSAMPLING_H

#include <CGAL/Inter_angle_remeshing/internal/surface/Mls_surface.h>

#include <array>
#include <vector>

// The up-sampled point set of Zheng and Lv: of each face its centroid, the midpoints between it and the corners, and the
// midpoints between these, moved onto the MLS surface.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

constexpr std::size_t SAMPLES_A_FACE = 7;
constexpr std::array<Mls_surface::Barycentric, SAMPLES_A_FACE> SAMPLE_COORDINATES = {{
  {1. / 3, 1. / 3, 1. / 3},
  {2. / 3, 1. / 6, 1. / 6}, {1. / 6, 2. / 3, 1. / 6}, {1. / 6, 1. / 6, 2. / 3},
  {5. / 12, 5. / 12, 1. / 6}, {1. / 6, 5. / 12, 5. / 12}, {5. / 12, 1. / 6, 5. / 12}}};

struct Surface_sample
{
  Vector3 point, normal;         // unit
  Mls_surface::Index face;
  std::size_t number;            // in SAMPLE_COORDINATES
};

// Calls `function(sample)` for the samples in the order of the faces. Faces without a normal have none.
template <class Function>
void for_each_sample(const Mls_surface& mls, const Function& function)
{
  const Reference_surface& surface = mls.reference_surface();
  for (Mls_surface::Index f = 0; f < Mls_surface::Index(surface.number_of_faces()); ++f) {
    const auto& v = surface.face_record(f).vertex;
    const Vector3 c = surface.cross_product(f);
    if (is_degenerate(c, surface.position(v[0]), surface.position(v[1]), surface.position(v[2]))) continue;
    for (std::size_t i = 0; i < SAMPLES_A_FACE; ++i) {
      const Vector3 n = mls.normal(f, SAMPLE_COORDINATES[i]);
      const Vector3 direction = dot(n, c) > 0 ? n : c;
      function(Surface_sample{mls.point(f, SAMPLE_COORDINATES[i]), (1 / length(direction)) * direction, f, i});
    }
  }
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_UPSAMPLING_H
