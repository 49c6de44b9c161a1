// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_MEASURES_NORMALIZED_SURFACE_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_MEASURES_NORMALIZED_SURFACE_H

#include <CGAL/Inter_angle_remeshing/internal/measures/Distance_traits.h>
#include <CGAL/Inter_angle_remeshing/internal/measures/triangle_coordinates.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {
namespace measures {

// The surface of a mesh as the user has it.
struct Flat_surface
{
  std::vector<Triangle_coordinates> triangles;   // one for every face, in their order
  std::vector<Coordinates> vertices;             // those of the faces, each one once
};

template <class Vertex, class TriangleMesh>
bool has_face(Vertex v, const TriangleMesh& tm)
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  if (halfedge(v, tm) == Graph_traits::null_halfedge()) return false;
  for (const auto h : CGAL::halfedges_around_target(v, tm))
    if (!CGAL::is_border(h, tm)) return true;
  return false;
}

template <class TriangleMesh, class NamedParameters>
Flat_surface flat_surface(const TriangleMesh& tm, const NamedParameters& np, const std::string& name)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  const auto vpm = choose_parameter(get_parameter(np, internal_np::vertex_point),
                                    get_const_property_map(CGAL::vertex_point, tm));
  Flat_surface surface;
  for (const auto f : faces(tm)) surface.triangles.push_back(checked_triangle(f, surface.triangles.size(), name, tm, vpm));
  if (surface.triangles.empty())
    refuse("!faces(tm).empty()", name + " has no face, so there is no distance to it", __FILE__, __LINE__);
  for (const auto v : vertices(tm))
    if (has_face(v, tm)) surface.vertices.push_back(double_coordinates(get(vpm, v)));
  return surface;
}

struct Bounding_box
{
  Coordinates lower, upper;

  explicit Bounding_box(const std::vector<Coordinates>& points) : lower(points.front()), upper(points.front())
  {
    for (const Coordinates& p : points)
      for (std::size_t i = 0; i < 3; ++i) {
        lower[i] = (std::min)(lower[i], p[i]);
        upper[i] = (std::max)(upper[i], p[i]);
      }
  }

  double largest_coordinate() const
  {
    double largest = 0;
    for (std::size_t i = 0; i < 3; ++i) largest = (std::max)({largest, std::abs(lower[i]), std::abs(upper[i])});
    return largest;
  }
};

// Moves both surfaces to the origin and scales them by a power of two: neither adds an error beyond the one that a
// coordinate has anyway, and no product of coordinates overflows or vanishes.
class Normalization
{
public:
  Normalization(const Bounding_box& first, const Bounding_box& second)
  {
    std::frexp((std::max)(first.largest_coordinate(), second.largest_coordinate()), &exponent_);
    for (std::size_t i = 0; i < 3; ++i)
      centre_[i] = .5 * (scaled((std::min)(first.lower[i], second.lower[i])) + scaled((std::max)(first.upper[i], second.upper[i])));
  }

  Distance_point apply(const Coordinates& p) const
  {
    return {scaled(p[0]) - centre_[0], scaled(p[1]) - centre_[1], scaled(p[2]) - centre_[2]};
  }

  double restore_length(double length) const { return std::ldexp(length, exponent_); }

private:
  double scaled(double coordinate) const { return std::ldexp(coordinate, -exponent_); }

  int exponent_ = 0;                     // of two, above every coordinate
  Coordinates centre_ = {};              // after the scaling
};

struct Normalized_surface
{
  std::vector<Distance_triangle> triangles;
  std::vector<Distance_point> vertices;

  Normalized_surface(const Flat_surface& surface, const Normalization& normalization)
  {
    triangles.reserve(surface.triangles.size());
    for (const Triangle_coordinates& t : surface.triangles)
      triangles.emplace_back(normalization.apply(t[0]), normalization.apply(t[1]), normalization.apply(t[2]));
    vertices.reserve(surface.vertices.size());
    for (const Coordinates& p : surface.vertices) vertices.push_back(normalization.apply(p));
  }
};

} // namespace measures
} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_MEASURES_NORMALIZED_SURFACE_H
