// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_ANGLE_SUMMARY_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_ANGLE_SUMMARY_H

#include <CGAL/Inter_angle_remeshing/Remeshing_report.h>
#include <CGAL/Inter_angle_remeshing/internal/geometry/arc_cosine.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/Remeshing_mesh.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/parallel_blocks.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// Adds the angles of the triangle abc to a sum whose `average` is that of |θ - 60|, for now, and whose extremes are
// cosines. Where two corners are equal there are none: it counts as of 0 and 180 degrees.
inline void add_angles(const Vector3& a, const Vector3& b, const Vector3& c, Remeshing_report::Angles& sum)
{
  const Vector3 u = b - a, v = c - b, w = a - c;
  const double lu = length(u), lv = length(v), lw = length(w);
  const auto cosine_between = [](const Vector3& d, const Vector3& e, double product) {
    return product > 0 ? -dot(d, e) / product : 1.;
  };
  if (!(lu > 0 && lv > 0 && lw > 0)) sum.maximum = -1;
  for (const double cosine : {cosine_between(w, u, lw * lu), cosine_between(u, v, lu * lv),
                              cosine_between(v, w, lv * lw)}) {
    sum.minimum = (std::max)(sum.minimum, cosine);
    sum.maximum = (std::min)(sum.maximum, cosine);
    sum.average += std::abs(arc_cosine_in_degrees(cosine) - 60);
  }
}

// The angles of the mesh. Sums are made per block and added in block order: the same for any number of threads.
template <class ConcurrencyTag>
Remeshing_report::Angles angle_summary(const Remeshing_mesh& mesh)
{
  using Index = Remeshing_mesh::Index;
  const std::size_t number_of_slots = mesh.number_of_face_slots();
  std::vector<Remeshing_report::Angles> parts(number_of_blocks(number_of_slots, SCAN_BLOCK), {-1, 1, 0});
  for_each_block<ConcurrencyTag>(number_of_slots, SCAN_BLOCK, [&](std::size_t begin, std::size_t end, std::size_t block) {
    for (std::size_t f = begin; f < end; ++f) {
      if (!mesh.is_face(Index(f))) continue;
      const Corner_table::Face& t = mesh.face_record(Index(f));
      add_angles(mesh.position(t.vertex[0]), mesh.position(t.vertex[1]), mesh.position(t.vertex[2]), parts[block]);
    }
  });
  if (mesh.number_of_live_faces() == 0) return {};
  Remeshing_report::Angles result{-1, 1, 0};
  for (const Remeshing_report::Angles& part : parts) {
    result.minimum = (std::max)(result.minimum, part.minimum);
    result.maximum = (std::min)(result.maximum, part.maximum);
    result.average += part.average;
  }
  const auto degrees = [](double cosine) {
    return std::acos((std::max)(-1., (std::min)(1., cosine))) * (180 / CGAL_PI);
  };
  result.minimum = degrees(result.minimum);
  result.maximum = degrees(result.maximum);
  result.average = 60 - result.average / (3. * double(mesh.number_of_live_faces()));
  return result;
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_ANGLE_SUMMARY_H
