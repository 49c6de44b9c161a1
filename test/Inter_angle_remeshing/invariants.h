// Copyright (c) 2026 The Inter_angle_remeshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_TEST_INVARIANTS_H
#define CGAL_INTER_ANGLE_REMESHING_TEST_INVARIANTS_H

// What a remeshed surface has in common with the one that it was made from, as values to compare.

#include <CGAL/Inter_angle_remeshing/surface_distance.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <ostream>
#include <set>
#include <utility>
#include <vector>

namespace invariants {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;
using Edge = Mesh::Edge_index;
using Halfedge = Mesh::Halfedge_index;
using Face = Mesh::Face_index;

// --- ranges ------------------------------------------------------------------------------------------------------

// The first `n` faces that a search by breadth meets from `start` on.
inline std::vector<Face> faces_around(Face start, std::size_t n, const Mesh& m)
{
  std::vector<Face> range = {start};
  std::set<Face> known = {start};
  for(std::size_t i = 0; i < range.size(); ++i)
    for(const auto f : CGAL::faces_around_face(m.halfedge(range[i]), m))
      if(f != Mesh::null_face() && range.size() < n && known.insert(f).second)
        range.push_back(f);
  return range;
}

// --- topology ----------------------------------------------------------------------------------------------------

struct Topology
{
  long euler_characteristic = 0; // isolated vertices left out
  std::size_t components = 0;    // of the faces
  std::size_t border_cycles = 0;
  std::size_t isolated_vertices = 0;

  bool is_closed() const { return border_cycles == 0; }

  friend bool operator==(const Topology& a, const Topology& b)
  {
    return a.euler_characteristic == b.euler_characteristic && a.components == b.components &&
           a.border_cycles == b.border_cycles && a.isolated_vertices == b.isolated_vertices;
  }

  friend std::ostream& operator<<(std::ostream& out, const Topology& t)
  {
    return out << "Euler characteristic " << t.euler_characteristic << ", " << t.components << " components, "
               << t.border_cycles << " border cycles, " << t.isolated_vertices << " isolated vertices";
  }
};

inline std::size_t number_of_border_cycles(const Mesh& mesh)
{
  std::set<Mesh::Halfedge_index> seen;
  std::size_t cycles = 0;
  for(const auto h : halfedges(mesh))
    if(is_border(h, mesh) && seen.insert(h).second)
    {
      ++cycles;
      for(auto k = next(h, mesh); k != h; k = next(k, mesh))
        seen.insert(k);
    }
  return cycles;
}

Topology topology(const Mesh& mesh);

// Whether two edges join the same vertices, or one joins a vertex to itself.
inline bool has_double_edges(const Mesh& mesh)
{
  std::set<std::pair<Vertex, Vertex>> seen;
  for(const Edge e : edges(mesh))
  {
    const Vertex u = source(e, mesh), v = target(e, mesh);
    if(u == v || !seen.insert(std::minmax(u, v)).second)
      return true;
  }
  return false;
}

inline bool is_finite(const Mesh& mesh)
{
  return std::all_of(mesh.vertices_begin(), mesh.vertices_end(), [&](Vertex v) {
    const Point& p = mesh.point(v);
    return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
  });
}

// --- geometry ----------------------------------------------------------------------------------------------------

double mean_edge_length(const Mesh& mesh);

inline std::array<Point, 3> corners(Face f, const Mesh& mesh)
{
  const auto h = halfedge(f, mesh);
  return {mesh.point(source(h, mesh)), mesh.point(target(h, mesh)), mesh.point(target(next(h, mesh), mesh))};
}

inline Vector normal(Face f, const Mesh& mesh)
{
  const auto p = corners(f, mesh);
  return CGAL::cross_product(p[1] - p[0], p[2] - p[0]);
}

// Throws where faces are degenerate, as the next one does.
bool does_self_intersect(const Mesh& mesh);

// The pairs of faces that do.
std::vector<std::pair<Face, Face>> self_intersections(const Mesh& mesh);

// Faces of `mesh` that look away from where the nearest face of `input` looks.
std::size_t number_of_flipped_faces(const Mesh& mesh, const Mesh& input);

// The package's own, which test_measures tests. With so many points the mean is known to about 0.6% of itself.
CGAL::Inter_angle_remeshing::Surface_distance surface_distance(const Mesh& mesh, const Mesh& other,
                                                               std::size_t number_of_points = 30000);

// Of the points from the mesh.
double largest_distance(const std::vector<Point>& points, const Mesh& mesh);

// --- curves ------------------------------------------------------------------------------------------------------

struct Segment
{
  Point source, target;

  double distance(const Point& q) const
  {
    const Vector along = target - source;
    const double length = along.squared_length();
    const double t = length > 0 ? std::clamp((q - source) * along / length, 0., 1.) : 0.;
    return std::sqrt(CGAL::squared_distance(q, source + t * along));
  }
};

template <class Predicate>
std::vector<Segment> segments(const Mesh& mesh, const Predicate& is_wanted)
{
  std::vector<Segment> result;
  for(const Edge e : edges(mesh))
    if(is_wanted(e))
      result.push_back({mesh.point(source(e, mesh)), mesh.point(target(e, mesh))});
  return result;
}

inline std::vector<Segment> border(const Mesh& mesh)
{
  return segments(mesh, [&](Edge e) { return is_border(e, mesh); });
}

// From points of the one curve, five a segment, to the other one.
inline double one_sided_distance(const std::vector<Segment>& from, const std::vector<Segment>& to)
{
  double largest = 0;
  for(const Segment& s : from)
    for(const double t : {0., .25, .5, .75, 1.})
    {
      const Point q = s.source + t * (s.target - s.source);
      double nearest = std::numeric_limits<double>::infinity();
      for(const Segment& other : to)
        nearest = (std::min)(nearest, other.distance(q));
      largest = (std::max)(largest, nearest);
    }
  return largest;
}

inline double distance(const std::vector<Segment>& a, const std::vector<Segment>& b)
{
  return (std::max)(one_sided_distance(a, b), one_sided_distance(b, a));
}

} // namespace invariants

#endif // CGAL_INTER_ANGLE_REMESHING_TEST_INVARIANTS_H
