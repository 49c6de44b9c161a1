// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_PAPER_SURFACE_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_PAPER_SURFACE_H

#include <CGAL/Inter_angle_remeshing/internal/arguments/refuse.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/Mls_surface.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/Reference_surface.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/upsampling.h>
#ifdef CGAL_EIGEN3_ENABLED
#  include <CGAL/Inter_angle_remeshing/Projection/Point_set_MLS_projector.h>
#endif

#include <CGAL/Simple_cartesian.h>

#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// The surface of the paper: MLS on the up-sampled facets. Empty where there is no sample.
inline std::function<Vector3(const Vector3&)> paper_surface(const Reference_surface& facets,
                                                            const std::vector<Remeshing_mesh::Index>& creases)
{
#ifdef CGAL_EIGEN3_ENABLED
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  using Vector = CGAL::Simple_cartesian<double>::Vector_3;
  std::vector<std::pair<Point, Vector>> samples;
  for_each_sample(Mls_surface(facets, creases), [&](const Surface_sample& s) {
    samples.emplace_back(Point(s.point.x, s.point.y, s.point.z), Vector(s.normal.x, s.normal.y, s.normal.z));
  });
  if (samples.empty()) return {};
  return [projector = Point_set_MLS_projector<Point>(samples)](const Vector3& q) {
    const Point p = projector.project(Point(q.x, q.y, q.z));
    return Vector3{p.x(), p.y(), p.z()};
  };
#else
  (void)facets; (void)creases;
  refuse(REMESHING, "Recipe::Surface::paper, as in Recipe::paper(), needs Eigen: define CGAL_EIGEN3_ENABLED");
#endif
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_PAPER_SURFACE_H
