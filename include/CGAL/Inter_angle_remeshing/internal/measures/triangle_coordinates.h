// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_MEASURES_TRIANGLE_COORDINATES_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_MEASURES_TRIANGLE_COORDINATES_H

#include <CGAL/Inter_angle_remeshing/internal/geometry/to_vector3.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/exceptions.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {
namespace measures {

using Coordinates = std::array<double, 3>;
using Triangle_coordinates = std::array<Coordinates, 3>;

// The refusals have to hold in release builds, too, where CGAL's macros are empty.
[[noreturn]] inline void refuse(const std::string& condition, const std::string& message, const char* file, int line)
{
  throw CGAL::Precondition_exception("CGAL", condition, file, line, message);
}

template <class Halfedge, class TriangleMesh>
bool bounds_triangle(Halfedge h, const TriangleMesh& tmesh)
{
  const Halfedge second = next(h, tmesh), third = next(second, tmesh);
  return second != h && third != h && next(third, tmesh) == h;
}

template <class Point>
Coordinates double_coordinates(const Point& p)
{
  return {exact_to_double(p.x()), exact_to_double(p.y()), exact_to_double(p.z())};
}

inline bool is_finite(const Coordinates& p)
{
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

// The corners of the face `f`, of which the user learns `ordinal` (its place in `range_name`) if it is refused.
template <class Face, class TriangleMesh, class VertexPointMap>
Triangle_coordinates checked_triangle(Face f, std::size_t ordinal, const std::string& range_name, const TriangleMesh& tmesh,
                                      const VertexPointMap& vpm)
{
  const auto describe = [&]() { return "face number " + std::to_string(ordinal) + " of " + range_name; };
  auto h = halfedge(f, tmesh);
  if (!bounds_triangle(h, tmesh))
    refuse("is_triangle(halfedge(f, tmesh), tmesh)", describe() + " is not a triangle", __FILE__, __LINE__);
  Triangle_coordinates corners;
  for (Coordinates& corner : corners) {
    corner = double_coordinates(get(vpm, target(h, tmesh)));
    if (!is_finite(corner))
      refuse("is_finite(get(vpm, target(h, tmesh)))",
             describe() + " has a corner with a coordinate that is not a finite number", __FILE__, __LINE__);
    h = next(h, tmesh);
  }
  return corners;
}

} // namespace measures
} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_MEASURES_TRIANGLE_COORDINATES_H
