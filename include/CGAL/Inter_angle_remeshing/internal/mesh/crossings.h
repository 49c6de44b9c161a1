// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_CROSSINGS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_CROSSINGS_H

#include <CGAL/Inter_angle_remeshing/internal/geometry/Bounding_box.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/Face_grid.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/Remeshing_mesh.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/mesh_regions.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

// Whether faces cross each other. Those that share an edge do not, they fold, see folds.h.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// A point lies on a side of a plane for sure where its height is more than this part of its distance from a point of the plane: more
// than rounding could feign.
constexpr double SURE_HEIGHT = 1e-12;

// `Surface` has face_record() and position().
template <class Surface>
Bounding_box bounding_box(const Surface& mesh, Corner_table::Index f)
{
  const auto& v = mesh.face_record(f).vertex;
  return {mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2])};
}

inline bool is_corner(const Corner_table::Face& face, Corner_table::Index v)
{
  return (v == face.vertex[0]) | (v == face.vertex[1]) | (v == face.vertex[2]);
}

template <class Surface>
int number_of_shared_vertices(const Surface& mesh, Corner_table::Index f, Corner_table::Index g)
{
  const Corner_table::Face &a = mesh.face_record(f), &b = mesh.face_record(g);
  return is_corner(b, a.vertex[0]) + is_corner(b, a.vertex[1]) + is_corner(b, a.vertex[2]);
}

// Whether the corners of f that are none of g lie on one side of its plane for sure.
template <class Surface>
bool lies_beside(const Surface& mesh, Corner_table::Index f, Corner_table::Index g)
{
  const auto &a = mesh.face_record(f).vertex, &b = mesh.face_record(g).vertex;
  const Vector3 &p = mesh.position(b[0]), &q = mesh.position(b[1]), &r = mesh.position(b[2]);
  const Vector3 normal = triangle_cross(p, q, r);
  const double longest_normal = squared_distance(p, q) * squared_distance(p, r);         // squared; that of a needle is mostly rounding
  int above = 0, under = 0;
  for (const Corner_table::Index v : a) {
    if (is_corner(mesh.face_record(g), v)) continue;
    const Vector3 way = mesh.position(v) - p;
    const double height = dot(way, normal);
    if (!(height * height > SURE_HEIGHT * SURE_HEIGHT * longest_normal * squared_length(way))) return false;
    ++(height > 0 ? above : under);
  }
  return above == 0 || under == 0;
}

// Whether a plane parts f and g for sure: across the way from the centre of g to that of f, half way, or, through a vertex that they share,
// between the ways from there to the centres. Faces in one plane, beside which none lies, are told apart like that, those of a fan, too.
template <class Surface>
bool lie_apart(const Surface& mesh, Corner_table::Index f, Corner_table::Index g)
{
  const auto &a = mesh.face_record(f).vertex, &b = mesh.face_record(g).vertex;
  const auto centre = [&](const Corner_table::Index* v) {
    return (1. / 3) * (mesh.position(v[0]) + mesh.position(v[1]) + mesh.position(v[2])); };
  const Vector3 from = centre(b), to = centre(a);
  const Corner_table::Index* shared = std::find_first_of(a, a + 3, b, b + 3);
  const bool share_vertex = shared != a + 3;
  const Vector3 middle = share_vertex ? mesh.position(*shared) : 0.5 * (from + to);
  const Vector3 across = share_vertex ? unit(to - middle) - unit(from - middle) : to - from;
  const auto is_beyond = [&](Corner_table::Index v, double side) {
    const Vector3 way = mesh.position(v) - middle;
    const double height = side * dot(way, across);
    return height > 0 && height * height > SURE_HEIGHT * SURE_HEIGHT * squared_length(across) * squared_length(way);
  };
  return std::all_of(a, a + 3, [&](Corner_table::Index v) { return is_corner(mesh.face_record(g), v) || is_beyond(v, 1); }) &&
         std::all_of(b, b + 3, [&](Corner_table::Index v) { return is_corner(mesh.face_record(f), v) || is_beyond(v, -1); });
}

// The corners of f and of g that are one vertex, or one of the user's, which has several fans of faces and here a vertex for each;
// negative where none are, or are two that have no edge in common.
template <class Surface>
std::array<int, 2> common_corner(const Surface& mesh, Corner_table::Index f, Corner_table::Index g)
{
  const auto &a = mesh.face_record(f).vertex, &b = mesh.face_record(g).vertex;
  std::array<int, 2> result{-1, -1};
  int pairs = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      if (a[i] == b[j]) return {i, j};
      if (mesh.position(a[i]) != mesh.position(b[j]) || !mesh.is_pinched(a[i]) || !mesh.is_pinched(b[j])) continue;
      result = {i, j};
      ++pairs;
    }
  return pairs == 1 ? result : std::array<int, 2>{-1, -1};
}

// Whether nothing that is quickly seen tells that f and g do not cross each other.
template <class Surface>
bool may_cross_each_other(const Surface& mesh, Corner_table::Index f, Corner_table::Index g)
{
  return number_of_shared_vertices(mesh, f, g) <= 1 && !lies_beside(mesh, f, g) && !lies_beside(mesh, g, f) && !lie_apart(mesh, f, g);
}

// Whether two faces that may do so cross each other. A triangle without an area crosses nothing. Two that have a corner in common cross
// where the edge of one that is opposite to it meets the other one.
template <class Surface>
bool do_cross_each_other(const Surface& mesh, Corner_table::Index f, Corner_table::Index g)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  const auto &a = mesh.face_record(f).vertex, &b = mesh.face_record(g).vertex;
  const auto point = [&](Corner_table::Index v) {
    const Vector3& p = mesh.position(v);
    return Kernel::Point_3(p.x, p.y, p.z);
  };
  const Kernel::Triangle_3 s(point(a[0]), point(a[1]), point(a[2])), t(point(b[0]), point(b[1]), point(b[2]));
  if (s.is_degenerate() || t.is_degenerate()) return false;
  const auto [i, j] = common_corner(mesh, f, g);
  if (i < 0) return CGAL::do_intersect(s, t);
  return CGAL::do_intersect(Kernel::Segment_3(s[i + 1], s[i + 2]), t) || CGAL::do_intersect(Kernel::Segment_3(t[j + 1], t[j + 2]), s);
}

template <class Surface>
bool cross_each_other(const Surface& mesh, Corner_table::Index f, Corner_table::Index g)
{
  return may_cross_each_other(mesh, f, g) && do_cross_each_other(mesh, f, g);
}

// The length of the segment in which two faces cross each other.
template <class Surface>
double crossing_length(const Surface& mesh, Corner_table::Index f, Corner_table::Index g)
{
  double result = 0;
  Vector3 first;
  bool is_first = true;
  const auto add = [&](const Vector3& p) {
    if (is_first) first = p;
    is_first = false;
    result = (std::max)(result, length(p - first));
  };
  // Where the edges of `s` go through `t`.
  const auto add_points = [&](Corner_table::Index s, Corner_table::Index t) {
    const auto &a = mesh.face_record(s).vertex, &b = mesh.face_record(t).vertex;
    const Vector3 &x = mesh.position(b[0]), &y = mesh.position(b[1]), &z = mesh.position(b[2]), normal = triangle_cross(x, y, z);
    for (int k = 0; k < 3; ++k) {
      const Vector3 &p = mesh.position(a[k]), &q = mesh.position(a[(k + 1) % 3]);
      const double above = dot(p - x, normal), under = dot(q - x, normal);
      if (!(above * under <= 0) || above == under) continue;
      const Vector3 r = p + (above / (above - under)) * (q - p);
      if (dot(triangle_cross(r, x, y), normal) >= 0 && dot(triangle_cross(r, y, z), normal) >= 0 &&
          dot(triangle_cross(r, z, x), normal) >= 0) add(r);
    }
  };
  add_points(f, g);
  add_points(g, f);
  return result;
}

// The faces that may cross one of `faces`, and some others; adds to `looks` how many faces it took to find them.
inline std::vector<Remeshing_mesh::Index> faces_near(const Remeshing_mesh& mesh, Face_grid& grid,
                                                     const std::vector<Remeshing_mesh::Index>& faces, Visit_marks& marks,
                                                     std::size_t& looks)
{
  Bounding_box all;
  for (const Remeshing_mesh::Index f : faces) all += bounding_box(mesh, f);
  std::vector<Remeshing_mesh::Index> result;
  grid.for_each_near(all.low, all.high, marks, [&](Remeshing_mesh::Index f) {
    ++looks;
    if (do_overlap(bounding_box(mesh, f), all)) result.push_back(f);
    return true;
  });
  return result;
}

// Calls `function(face, other)` for every one of `faces`, which are sorted, that crosses one of `others`, until it returns false; but for
// the pairs that `is_left_out(face, other)`. Two that are both among `faces` are one pair.
template <class Surface, class IsLeftOut, class Function>
void for_each_crossing(const Surface& mesh, const std::vector<Remeshing_mesh::Index>& faces,
                       const std::vector<Remeshing_mesh::Index>& others, const IsLeftOut& is_left_out, const Function& function)
{
  using Index = Remeshing_mesh::Index;
  std::vector<Bounding_box> boxes;
  Bounding_box all;
  for (const Index f : faces) {
    boxes.push_back(bounding_box(mesh, f));
    all += boxes.back();
  }
  for (const Index g : others) {
    const Bounding_box b = bounding_box(mesh, g);
    if (!do_overlap(b, all)) continue;
    const auto found = std::lower_bound(faces.begin(), faces.end(), g);
    const std::size_t first = found != faces.end() && *found == g ? std::size_t(found - faces.begin()) + 1 : 0;
    for (std::size_t i = first; i < faces.size(); ++i)
      if (do_overlap(b, boxes[i]) && may_cross_each_other(mesh, g, faces[i]) && !is_left_out(faces[i], g) &&
          do_cross_each_other(mesh, g, faces[i]) && !function(faces[i], g)) return;
  }
}

template <class Surface, class Function>
void for_each_crossing(const Surface& mesh, const std::vector<Remeshing_mesh::Index>& faces,
                       const std::vector<Remeshing_mesh::Index>& others, const Function& function)
{
  for_each_crossing(mesh, faces, others, [](Remeshing_mesh::Index, Remeshing_mesh::Index) { return false; }, function);
}

// Whether one of `faces` crosses another face; adds to `looks` as faces_near() does.
inline bool are_crossed(const Remeshing_mesh& mesh, Face_grid& grid, const std::vector<Remeshing_mesh::Index>& faces,
                        Visit_marks& marks, std::size_t& looks)
{
  bool result = false;
  for_each_crossing(mesh, faces, faces_near(mesh, grid, faces, marks, looks), [&](Remeshing_mesh::Index, Remeshing_mesh::Index) {
    result = true;
    return false;
  });
  return result;
}

inline bool are_crossed(const Remeshing_mesh& mesh, Face_grid& grid, const std::vector<Remeshing_mesh::Index>& faces,
                        Visit_marks& marks)
{
  std::size_t looks = 0;
  return are_crossed(mesh, grid, faces, marks, looks);
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_CROSSINGS_H
