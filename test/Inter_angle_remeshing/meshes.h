// Copyright (c) 2026 The Inter_angle_remeshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_TEST_MESHES_H
#define CGAL_INTER_ANGLE_REMESHING_TEST_MESHES_H

// Meshes to remesh, and pictures of meshes that tell whether a bit has changed.

#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace meshes {

// The run under the sanitizers, which are some twenty times slower.
inline bool is_small_run() { return std::getenv("INTER_ANGLE_TEST_SMALL") != nullptr; }

// Points and faces, before they are a mesh.
template <class Face>
struct Soup_of
{
  std::vector<std::array<double, 3>> points;
  std::vector<Face> faces;

  Soup_of scaled(double factor) const
  {
    Soup_of copy = *this;
    for(auto& p : copy.points)
      for(double& coordinate : p)
        coordinate *= factor;
    return copy;
  }

  Soup_of moved(double x, double y, double z) const
  {
    Soup_of copy = *this;
    for(auto& p : copy.points)
      p = {p[0] + x, p[1] + y, p[2] + z};
    return copy;
  }

  Soup_of joined_with(const Soup_of& other) const
  {
    Soup_of copy = *this;
    copy.points.insert(copy.points.end(), other.points.begin(), other.points.end());
    for(Face face : other.faces)
    {
      for(std::size_t& corner : face)
        corner += points.size();
      copy.faces.push_back(face);
    }
    return copy;
  }
};

using Soup = Soup_of<std::array<std::size_t, 3>>;

template <class Graph>
using Point_of = typename boost::property_traits<
  typename boost::property_map<Graph, CGAL::vertex_point_t>::type>::value_type;

// Adds the soup's vertices and faces, in its order; returns the vertices.
template <class Graph>
std::vector<typename boost::graph_traits<Graph>::vertex_descriptor> add_soup(const Soup& soup, Graph& g)
{
  using Vertex = typename boost::graph_traits<Graph>::vertex_descriptor;
  std::vector<Vertex> corners;
  for(const auto& p : soup.points)
  {
    corners.push_back(add_vertex(g));
    put(CGAL::vertex_point, g, corners.back(), Point_of<Graph>(p[0], p[1], p[2]));
  }
  for(const auto& f : soup.faces)
    CGAL::Euler::add_face(std::vector<Vertex>{corners[f[0]], corners[f[1]], corners[f[2]]}, g);
  return corners;
}

template <class Graph>
Graph to_mesh(const Soup& soup)
{
  Graph g;
  add_soup(soup, g);
  return g;
}

inline Soup tetrahedron()
{
  return {{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
}

inline Soup octahedron()
{
  return {{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
          {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
}

// The unit square in the plane z = 0, n by n cells of two triangles.
inline Soup square(std::size_t n)
{
  Soup soup;
  for(std::size_t j = 0; j <= n; ++j)
    for(std::size_t i = 0; i <= n; ++i)
      soup.points.push_back({double(i) / double(n), double(j) / double(n), 0});
  for(std::size_t j = 0; j < n; ++j)
    for(std::size_t i = 0; i < n; ++i)
    {
      const std::size_t a = j * (n + 1) + i, b = a + 1, c = a + n + 1, d = c + 1;
      soup.faces.push_back({a, b, d});
      soup.faces.push_back({a, d, c});
    }
  return soup;
}

// The square without the cells that `is_left_out(i, j)` names; vertices without a face stay.
template <class Predicate>
Soup square_without(std::size_t n, const Predicate& is_left_out)
{
  Soup soup = square(n);
  std::vector<std::array<std::size_t, 3>> kept;
  for(std::size_t f = 0; f < soup.faces.size(); ++f)
    if(!is_left_out((f / 2) % n, f / 2 / n))
      kept.push_back(soup.faces[f]);
  soup.faces = kept;
  return soup;
}

// Removes points without a face.
inline Soup without_isolated_points(const Soup& soup)
{
  std::vector<std::size_t> number(soup.points.size(), std::size_t(-1));
  Soup result;
  for(const auto& f : soup.faces)
    for(const std::size_t v : f)
      if(number[v] == std::size_t(-1))
      {
        number[v] = result.points.size();
        result.points.push_back(soup.points[v]);
      }
  for(const auto& f : soup.faces)
    result.faces.push_back({number[f[0]], number[f[1]], number[f[2]]});
  return result;
}

// The unit sphere: an octahedron, every triangle cut into four `levels` times, lifted.
inline Soup sphere(int levels)
{
  Soup soup = octahedron();
  for(int level = 0; level < levels; ++level)
  {
    Soup fine{soup.points, {}};
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> midpoints;
    const auto midpoint = [&](std::size_t a, std::size_t b)
    {
      const auto entry = midpoints.emplace(std::minmax(a, b), fine.points.size());
      if(entry.second)
      {
        std::array<double, 3> m;
        for(int k = 0; k < 3; ++k)
          m[k] = soup.points[a][k] + soup.points[b][k];
        const double length = std::sqrt(m[0] * m[0] + m[1] * m[1] + m[2] * m[2]);
        fine.points.push_back({m[0] / length, m[1] / length, m[2] / length});
      }
      return entry.first->second;
    };
    for(const auto& f : soup.faces)
    {
      const std::size_t ab = midpoint(f[0], f[1]), bc = midpoint(f[1], f[2]), ca = midpoint(f[2], f[0]);
      fine.faces.insert(fine.faces.end(), {{f[0], ab, ca}, {f[1], bc, ab}, {f[2], ca, bc}, {ab, bc, ca}});
    }
    soup = fine;
  }
  return soup;
}

// A torus around the z axis with the radii 1 and `r`; `along` by `around` cells of two triangles.
inline Soup torus(std::size_t along, std::size_t around, double r)
{
  Soup soup;
  const double circle = 2 * 3.14159265358979323846;
  for(std::size_t i = 0; i < along; ++i)
    for(std::size_t j = 0; j < around; ++j)
    {
      const double u = circle * double(i) / double(along), v = circle * double(j) / double(around);
      soup.points.push_back({(1 + r * std::cos(v)) * std::cos(u), (1 + r * std::cos(v)) * std::sin(u), r * std::sin(v)});
    }
  for(std::size_t i = 0; i < along; ++i)
    for(std::size_t j = 0; j < around; ++j)
    {
      const std::size_t k = (i + 1) % along, l = (j + 1) % around;
      const std::size_t a = i * around + j, b = k * around + j, c = k * around + l, d = i * around + l;
      soup.faces.push_back({a, b, c});
      soup.faces.push_back({a, c, d});
    }
  return soup;
}

// A box of these half sizes between its fillets, whose radius is r; n facets across each fillet, n² faces or more in each corner.
inline Soup rounded_box(const std::array<double, 3>& half, double r, std::size_t n)
{
  Soup soup;
  std::map<std::array<double, 3>, std::size_t> numbers;
  const double step = 3.14159265358979323846 / 2 / double(n);
  // Parallels from pole to pole, those of the equator twice, and four quarters of meridians.
  std::vector<std::vector<std::size_t>> rows;
  for(std::size_t i = 0; i < 2 * (n + 1); ++i)
  {
    const bool is_above = i > n;
    const double latitude = (double(is_above ? i - 1 : i) - double(n)) * step;
    const double radius = i == 0 || i == 2 * n + 1 ? 0 : r * std::cos(latitude);
    rows.emplace_back();
    for(std::size_t quarter = 0; quarter < 4; ++quarter)
      for(std::size_t k = 0; k <= n; ++k)
      {
        const double longitude = double(quarter * n + k) * step;
        const std::array<double, 3> p = {(quarter == 0 || quarter == 3 ? half[0] : -half[0]) + radius * std::cos(longitude),
                                         (quarter < 2 ? half[1] : -half[1]) + radius * std::sin(longitude),
                                         (is_above ? half[2] : -half[2]) + r * std::sin(latitude)};
        const auto [place, is_new] = numbers.emplace(p, soup.points.size());
        if(is_new)
          soup.points.push_back(p);
        rows.back().push_back(place->second);
      }
  }
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
    if(a != b && b != c && c != a)
      soup.faces.push_back({a, b, c});
  };
  for(std::size_t i = 0; i + 1 < rows.size(); ++i)
    for(std::size_t j = 0; j < rows[i].size(); ++j)
    {
      const std::size_t k = (j + 1) % rows[i].size();
      add(rows[i][j], rows[i][k], rows[i + 1][k]);
      add(rows[i][j], rows[i + 1][k], rows[i + 1][j]);
    }
  for(const std::size_t i : {std::size_t(0), rows.size() - 1})
    for(const std::size_t quarter : {1, 2})
    {
      const std::size_t a = rows[i][0], b = rows[i][quarter * (n + 1)], c = rows[i][(quarter + 1) * (n + 1)];
      i == 0 ? add(a, c, b) : add(a, b, c);
    }
  return soup;
}

// Radii and heights.
using Profile = std::vector<std::array<double, 2>>;

// Part of a circle around (r, z), from and to multiples of π.
inline Profile arc(double r, double z, double radius, double from, double to, int steps)
{
  Profile result;
  for(int k = 0; k <= steps; ++k)
  {
    const double t = (from + (to - from) * k / steps) * 3.14159265358979323846;
    result.push_back({r + radius * std::cos(t), z + radius * std::sin(t)});
  }
  return result;
}

inline Profile joined(Profile a, const Profile& b)
{
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

// A wall around the z axis, .2 thick, 6 high, with round ends.
inline Profile wall_with_round_ends()
{
  return joined(arc(.9, 6, .1, 0, 1, 12), arc(.9, 0, .1, 1, 2, 12));
}

// An extruded rectangle of these half sizes whose corners are rounded by n facets, and its edges by fillets of `facets` facets; the caps
// are fans, as in a file for printing.
struct Slab
{
  double width, height, thickness, corner_radius;
  int n;
  double fillet_radius;
  int facets;
};

inline Soup slab(const Slab& s)
{
  Soup soup;
  Profile fillets = arc(s.fillet_radius, s.fillet_radius - s.thickness / 2, s.fillet_radius, 1.5, 1, s.facets);
  for(const auto& [inset, z] : Profile(fillets.rbegin(), fillets.rend()))
    fillets.push_back({inset, -z});
  std::size_t around = 0;
  for(const auto& [inset, z] : fillets)
  {
    Profile outline;
    for(int quarter = 0; quarter < 4; ++quarter)
    {
      const double x = s.width - s.corner_radius, y = s.height - s.corner_radius;
      outline = joined(outline, arc(quarter == 0 || quarter == 3 ? x : -x, quarter < 2 ? y : -y, s.corner_radius - inset, quarter / 2.,
                                    (quarter + 1) / 2., s.n));
    }
    around = outline.size();
    for(const auto& [x, y] : outline)
      soup.points.push_back({x, y, z});
  }
  const std::size_t last = (fillets.size() - 1) * around;
  for(std::size_t i = 0; i < last; i += around)
    for(std::size_t j = 0; j < around; ++j)
    {
      const std::size_t a = i + j, b = i + (j + 1) % around;
      soup.faces.push_back({a, b, b + around});
      soup.faces.push_back({a, b + around, a + around});
    }
  for(std::size_t j = 1; j + 1 < around; ++j)
  {
    soup.faces.push_back({0, j + 1, j});
    soup.faces.push_back({last, last + j, last + j + 1});
  }
  return soup;
}

// A profile turned around the z axis in n steps, the outer side to the right of their order: faces as long as the profile's
// edges. A profile that is not closed ends in fans from one vertex.
inline Soup turned(const Profile& profile, std::size_t n, bool is_closed)
{
  Soup soup;
  for(const auto& [r, z] : profile)
    for(std::size_t i = 0; i < n; ++i)
    {
      const double u = 2 * 3.14159265358979323846 * double(i) / double(n);
      soup.points.push_back({r * std::cos(u), r * std::sin(u), z});
    }
  const std::size_t m = profile.size();
  for(std::size_t j = 0; j < (is_closed ? m : m - 1); ++j)
    for(std::size_t i = 0; i < n; ++i)
    {
      const std::size_t k = (i + 1) % n, l = (j + 1) % m;
      soup.faces.push_back({j * n + i, j * n + k, l * n + k});
      soup.faces.push_back({j * n + i, l * n + k, l * n + i});
    }
  for(std::size_t i = 1; !is_closed && i + 1 < n; ++i)
  {
    soup.faces.push_back({0, i + 1, i});
    soup.faces.push_back({(m - 1) * n, (m - 1) * n + i, (m - 1) * n + i + 1});
  }
  return soup;
}

// The surface of the cube [0, 1]^3, n by n cells of two triangles a side.
inline Soup cube(std::size_t n)
{
  Soup soup;
  std::map<std::array<std::size_t, 3>, std::size_t> number;
  const auto corner = [&](std::array<std::size_t, 3> p)
  {
    const auto entry = number.emplace(p, soup.points.size());
    if(entry.second)
      soup.points.push_back({double(p[0]) / double(n), double(p[1]) / double(n), double(p[2]) / double(n)});
    return entry.first->second;
  };
  for(int axis = 0; axis < 3; ++axis)
    for(const std::size_t side : {std::size_t(0), n})
      for(std::size_t i = 0; i < n; ++i)
        for(std::size_t j = 0; j < n; ++j)
        {
          const auto at = [&](std::size_t u, std::size_t v)
          {
            std::array<std::size_t, 3> p;
            p[axis] = side;
            p[(axis + 1) % 3] = u;
            p[(axis + 2) % 3] = v;
            return corner(p);
          };
          std::array<std::size_t, 4> q = {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
          if(side == 0)
            std::swap(q[1], q[3]);
          soup.faces.push_back({q[0], q[1], q[2]});
          soup.faces.push_back({q[0], q[2], q[3]});
        }
  return soup;
}

// The same, with a vertex in the middle of each edge between two sides that one of them lacks: a face without an area lies there.
inline Soup cube_with_caps(std::size_t n)
{
  Soup soup = cube(n);
  const std::size_t corners = soup.points.size();
  const auto is_sharp = [&](std::size_t a, std::size_t b)
  {
    int planes = 0;
    for(int axis = 0; axis < 3; ++axis)
    {
      const double x = soup.points[a][axis];
      planes += x == soup.points[b][axis] && (x == 0 || x == 1);
    }
    return planes == 2;
  };
  std::vector<std::array<std::size_t, 3>> caps;
  for(std::size_t f = 0; f < soup.faces.size(); ++f)
    for(int k = 0; k < 3; ++k)
    {
      const auto face = soup.faces[f];
      const std::size_t a = face[k], b = face[(k + 1) % 3], c = face[(k + 2) % 3];
      if(a >= b || b >= corners || !is_sharp(a, b))
        continue;
      const std::size_t middle = soup.points.size();
      soup.points.push_back({});
      for(int axis = 0; axis < 3; ++axis)
        soup.points[middle][axis] = .5 * (soup.points[a][axis] + soup.points[b][axis]);
      caps.push_back({a, b, middle});
      soup.faces.push_back({middle, b, c});
      soup.faces[f] = {a, middle, c};
      k = -1;
    }
  soup.faces.insert(soup.faces.end(), caps.begin(), caps.end());
  return soup;
}

// The surface of the unit cells with their lower corners in [-n, n)^3 that `is_inside(corner)` names, two triangles for each side of
// one that is outside.
template <class Predicate>
Soup voxels(int n, const Predicate& is_inside)
{
  Soup soup;
  std::map<std::array<int, 3>, std::size_t> number;
  const auto corner = [&](const std::array<int, 3>& p)
  {
    const auto entry = number.emplace(p, soup.points.size());
    if(entry.second)
      soup.points.push_back({double(p[0]), double(p[1]), double(p[2])});
    return entry.first->second;
  };
  std::array<int, 3> cell;
  for(cell[0] = -n; cell[0] < n; ++cell[0])
    for(cell[1] = -n; cell[1] < n; ++cell[1])
      for(cell[2] = -n; cell[2] < n; ++cell[2])
        for(int axis = 0; axis < 3; ++axis)
          for(const int side : {0, 1})
          {
            std::array<int, 3> other = cell, a = cell;
            other[axis] += side == 0 ? -1 : 1;
            if(!is_inside(cell) || is_inside(other))
              continue;
            a[axis] += side;
            std::array<int, 3> b = a, c = a, d = a;
            ++b[(axis + 1) % 3];
            ++c[(axis + 1) % 3];
            ++c[(axis + 2) % 3];
            ++d[(axis + 2) % 3];
            if(side == 0)
              std::swap(b, d);
            soup.faces.push_back({corner(a), corner(b), corner(c)});
            soup.faces.push_back({corner(a), corner(c), corner(d)});
          }
  return soup;
}

// Flips every edge that `wanted` of the edge's number says, whose ends have six edges or more, and that shares no
// vertex of its two faces with one flipped before: valences of 5, 6 and 7 from a mesh with 6 almost everywhere.
template <class Graph, class Predicate>
void scramble(Graph& g, const Predicate& wanted)
{
  std::set<typename boost::graph_traits<Graph>::vertex_descriptor> touched;
  std::size_t number = 0;
  for(const auto e : edges(g))
  {
    const auto h = halfedge(e, g);
    if(!wanted(number++) || CGAL::is_border_edge(h, g))
      continue;
    const auto a = target(next(h, g), g), b = target(next(opposite(h, g), g), g);
    bool is_free = !CGAL::halfedge(a, b, g).second && degree(source(h, g), g) >= 6 && degree(target(h, g), g) >= 6;
    for(const auto v : {source(h, g), target(h, g), a, b})
      is_free = is_free && touched.count(v) == 0;
    if(!is_free)
      continue;
    for(const auto v : {source(h, g), target(h, g), a, b})
      touched.insert(v);
    CGAL::Euler::flip_edge(h, g);
  }
}

using Bits = std::array<std::uint64_t, 3>;

template <class Point>
Bits bits(const Point& p)
{
  const double coordinates[3] = {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
  Bits result;
  std::memcpy(result.data(), coordinates, sizeof coordinates);
  return result;
}

// What a halfedge, a face and a vertex refer to.
template <class Graph>
auto row(typename boost::graph_traits<Graph>::halfedge_descriptor h, const Graph& g)
{
  return std::make_tuple(h, next(h, g), prev(h, g), opposite(h, g), target(h, g), face(h, g));
}

template <class Graph>
auto face_row(typename boost::graph_traits<Graph>::face_descriptor f, const Graph& g)
{
  return std::make_tuple(f, halfedge(f, g));
}

template <class Graph>
auto vertex_row(typename boost::graph_traits<Graph>::vertex_descriptor v, const Graph& g)
{
  return std::make_tuple(v, halfedge(v, g), bits(get(CGAL::vertex_point, g, v)));
}

// Garbage: only Surface_mesh has any.
template <class Graph>
std::array<std::size_t, 3> number_of_removed_elements(const Graph&) { return {0, 0, 0}; }

template <class Point>
std::array<std::size_t, 3> number_of_removed_elements(const CGAL::Surface_mesh<Point>& mesh)
{
  return {mesh.number_of_removed_vertices(), mesh.number_of_removed_edges(), mesh.number_of_removed_faces()};
}

// All of a mesh. Two pictures are equal if nobody who holds the mesh could tell a difference.
template <class Graph>
struct Picture
{
  using Traits = boost::graph_traits<Graph>;

  std::vector<decltype(vertex_row(typename Traits::vertex_descriptor(), std::declval<const Graph&>()))> vertex_rows;
  std::vector<decltype(row(typename Traits::halfedge_descriptor(), std::declval<const Graph&>()))> halfedge_rows;
  std::vector<decltype(face_row(typename Traits::face_descriptor(), std::declval<const Graph&>()))> face_rows;
  std::array<std::size_t, 3> removed;

  explicit Picture(const Graph& g)
    : removed(number_of_removed_elements(g))
  {
    for(const auto v : vertices(g))
      vertex_rows.push_back(vertex_row<Graph>(v, g));
    for(const auto h : halfedges(g))
      halfedge_rows.push_back(row<Graph>(h, g));
    for(const auto f : faces(g))
      face_rows.push_back(face_row<Graph>(f, g));
  }

  friend bool operator==(const Picture& a, const Picture& b)
  {
    return a.vertex_rows == b.vertex_rows && a.halfedge_rows == b.halfedge_rows && a.face_rows == b.face_rows &&
           a.removed == b.removed;
  }
  friend bool operator!=(const Picture& a, const Picture& b) { return !(a == b); }
};

// The faces without descriptors of their own: triples of vertices, each begun with its smallest, sorted.
template <class Graph>
auto triangles(const Graph& g)
{
  using Vertex = typename boost::graph_traits<Graph>::vertex_descriptor;
  std::vector<std::array<Vertex, 3>> result;
  for(const auto f : faces(g))
  {
    const auto h = halfedge(f, g);
    std::array<Vertex, 3> t = {source(h, g), target(h, g), target(next(h, g), g)};
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    result.push_back(t);
  }
  std::sort(result.begin(), result.end());
  return result;
}

} // namespace meshes

#endif // CGAL_INTER_ANGLE_REMESHING_TEST_MESHES_H
