// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_CROSSINGS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_CROSSINGS_H

#include <CGAL/Inter_angle_remeshing/internal/Face_grid.h>
#include <CGAL/Inter_angle_remeshing/internal/Remeshing_mesh.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh_regions.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cstddef>
#include <vector>

// Whether faces of a small part of the mesh cross others, anywhere near. Faces that share a vertex are not looked at.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

inline CGAL::Bbox_3 bounding_box(const Remeshing_mesh& mesh, Remeshing_mesh::Index f)
{
  const auto& v = mesh.face_record(f).vertex;
  const Vector3 &a = mesh.position(v[0]), &b = mesh.position(v[1]), &c = mesh.position(v[2]);
  return {(std::min)({a.x, b.x, c.x}), (std::min)({a.y, b.y, c.y}), (std::min)({a.z, b.z, c.z}),
          (std::max)({a.x, b.x, c.x}), (std::max)({a.y, b.y, c.y}), (std::max)({a.z, b.z, c.z})};
}

inline bool share_vertex(const Remeshing_mesh& mesh, Remeshing_mesh::Index f, Remeshing_mesh::Index g)
{
  const auto &a = mesh.face_record(f).vertex, &b = mesh.face_record(g).vertex;
  return std::any_of(a, a + 3, [&](Remeshing_mesh::Index v) { return std::find(b, b + 3, v) != b + 3; });
}

// A triangle without an area crosses nothing.
inline bool cross_each_other(const Remeshing_mesh& mesh, Remeshing_mesh::Index f, Remeshing_mesh::Index g)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  const auto triangle = [&](Remeshing_mesh::Index t) {
    const auto point = [&](Remeshing_mesh::Index v) {
      const Vector3& p = mesh.position(v);
      return Kernel::Point_3(p.x, p.y, p.z);
    };
    const auto& v = mesh.face_record(t).vertex;
    return Kernel::Triangle_3(point(v[0]), point(v[1]), point(v[2]));
  };
  const Kernel::Triangle_3 s = triangle(f), t = triangle(g);
  return !s.is_degenerate() && !t.is_degenerate() && CGAL::do_intersect(s, t);
}

// Whether one of `faces` crosses another face.
inline bool are_crossed(const Remeshing_mesh& mesh, Face_grid& grid, const std::vector<Remeshing_mesh::Index>& faces,
                        Visit_marks& marks)
{
  using Index = Remeshing_mesh::Index;
  std::vector<CGAL::Bbox_3> boxes;
  CGAL::Bbox_3 all;
  for (const Index f : faces) {
    boxes.push_back(bounding_box(mesh, f));
    all += boxes.back();
  }
  bool result = false;
  grid.for_each_near({all.xmin(), all.ymin(), all.zmin()}, {all.xmax(), all.ymax(), all.zmax()}, marks, [&](Index g) {
    const CGAL::Bbox_3 b = bounding_box(mesh, g);
    for (std::size_t i = 0; i < faces.size() && CGAL::do_overlap(b, all) && !result; ++i)
      result = CGAL::do_overlap(b, boxes[i]) && !share_vertex(mesh, g, faces[i]) && cross_each_other(mesh, g, faces[i]);
    return !result;
  });
  return result;
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_CROSSINGS_H
