// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_MEASURES_FORCED_FACES_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_MEASURES_FORCED_FACES_H

#include <CGAL/Inter_angle_remeshing/internal/measures/Angle_accumulator.h>
#include <CGAL/Inter_angle_remeshing/internal/measures/triangle_coordinates.h>

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {
namespace measures {

// The cosine of the angle between two vectors; 1 where one of them has no length.
inline double cosine(const Coordinates& u, const Coordinates& v)
{
  const double product = std::sqrt(dot_product(u, u)) * std::sqrt(dot_product(v, v));
  return product > 0 ? dot_product(u, v) / product : 1.;
}

// Whether the target of `h` is a corner of curves: not between two edges on curves that turn by less than 45 degrees.
template <class Halfedge, class TriangleMesh, class VertexPointMap, class IsOnCurve>
bool is_corner_of_curves(Halfedge h, const TriangleMesh& tmesh, const VertexPointMap& vpm, const IsOnCurve& is_on_curve)
{
  constexpr double CORNER_COSINE = -.7071067811865476;
  const Coordinates here = double_coordinates(get(vpm, target(h, tmesh)));
  std::vector<Coordinates> arms;
  for (const Halfedge around : CGAL::halfedges_around_target(h, tmesh))
    if (is_on_curve(around)) arms.push_back(half_difference(here, double_coordinates(get(vpm, source(around, tmesh)))));
  return arms.size() != 2 || cosine(arms[0], arms[1]) > CORNER_COSINE;
}

// Whether no remesher can mend the face of `h0` that keeps the curves, see Inter_angle_statistics.
template <class Halfedge, class TriangleMesh, class VertexPointMap, class IsOnCurve>
bool is_forced(Halfedge h0, const Triangle_coordinates& corners, const TriangleMesh& tmesh, const VertexPointMap& vpm,
               const IsOnCurve& is_on_curve)
{
  const Triangle_coordinates edges = normalized_edges(corners);
  Halfedge h = h0;                       // towards corner i, opposite of corner i + 1
  for (std::size_t i = 0; i < 3; ++i, h = next(h, tmesh)) {
    if (!is_on_curve(h)) continue;
    const Coordinates &own = edges[(i + 1) % 3], &u = edges[i], &v = edges[(i + 2) % 3];
    if (-cosine(own, v) > .5 && is_on_curve(next(h, tmesh))) return true;
    if (4 * dot_product(own, own) < (std::min)(dot_product(u, u), dot_product(v, v)) &&
        is_corner_of_curves(h, tmesh, vpm, is_on_curve) && is_corner_of_curves(opposite(h, tmesh), tmesh, vpm, is_on_curve))
      return true;
  }
  return false;
}

} // namespace measures
} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_MEASURES_FORCED_FACES_H
