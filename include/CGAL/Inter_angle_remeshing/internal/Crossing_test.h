// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_CROSSING_TEST_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_CROSSING_TEST_H

#include <CGAL/Inter_angle_remeshing/internal/Point_grid.h>
#include <CGAL/Inter_angle_remeshing/internal/Remeshing_mesh.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh_regions.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// Whether faces of a small part of the mesh cross others, anywhere near. Faces that share a vertex are not looked at.
class Crossing_test
{
  using Index = Remeshing_mesh::Index;
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

public:
  // Faces with edges that are longer than `longest_edge` may be overlooked; no vertex moves nearly as far later.
  Crossing_test(const Remeshing_mesh& mesh, double longest_edge)
    : mesh_(mesh), longest_edge_(longest_edge), grid_(longest_edge)
  {
    for (Index v = 0; v < Index(mesh.number_of_vertex_slots()); ++v)
      if (mesh.is_vertex(v)) grid_.insert(mesh.position(v), v);
  }

  // Whether one of `faces` crosses another face.
  bool is_crossed(const std::vector<Index>& faces, Visit_marks& marks) const
  {
    std::vector<CGAL::Bbox_3> boxes;
    CGAL::Bbox_3 all;
    for (const Index f : faces) {
      boxes.push_back(box(f));
      all += boxes.back();
    }
    const Vector3 margin{longest_edge_, longest_edge_, longest_edge_};
    bool result = false;
    marks.start(mesh_.number_of_face_slots());
    const auto look_at = [&](Index g) {
      const CGAL::Bbox_3 b = box(g);
      if (!CGAL::do_overlap(b, all)) return;
      for (std::size_t i = 0; i < faces.size() && !result; ++i)
        result = CGAL::do_overlap(b, boxes[i]) && !share_vertex(g, faces[i]) && cross(triangle(g), triangle(faces[i]));
    };
    grid_.for_each_in_box(Vector3{all.xmin(), all.ymin(), all.zmin()} - margin,
                          Vector3{all.xmax(), all.ymax(), all.zmax()} + margin, [&](Index v) {
      if (result || std::size_t(v) >= mesh_.number_of_vertex_slots() || !mesh_.is_vertex(v)) return;
      mesh_.for_each_around(v, [&](Index h) { if (marks.visit(std::size_t(mesh_.face(h)))) look_at(mesh_.face(h)); });
    });
    return result;
  }

private:
  CGAL::Bbox_3 box(Index f) const
  {
    const auto& v = mesh_.face_record(f).vertex;
    const Vector3 &a = mesh_.position(v[0]), &b = mesh_.position(v[1]), &c = mesh_.position(v[2]);
    return {(std::min)({a.x, b.x, c.x}), (std::min)({a.y, b.y, c.y}), (std::min)({a.z, b.z, c.z}),
            (std::max)({a.x, b.x, c.x}), (std::max)({a.y, b.y, c.y}), (std::max)({a.z, b.z, c.z})};
  }
  Kernel::Triangle_3 triangle(Index f) const
  {
    const auto point = [&](Index v) {
      const Vector3& p = mesh_.position(v);
      return Kernel::Point_3(p.x, p.y, p.z);
    };
    const auto& v = mesh_.face_record(f).vertex;
    return {point(v[0]), point(v[1]), point(v[2])};
  }
  // A triangle without an area crosses nothing.
  static bool cross(const Kernel::Triangle_3& s, const Kernel::Triangle_3& t)
  {
    return !s.is_degenerate() && !t.is_degenerate() && CGAL::do_intersect(s, t);
  }
  bool share_vertex(Index f, Index g) const
  {
    const auto &a = mesh_.face_record(f).vertex, &b = mesh_.face_record(g).vertex;
    return std::any_of(a, a + 3, [&](Index v) { return std::find(b, b + 3, v) != b + 3; });
  }

  const Remeshing_mesh& mesh_;
  double longest_edge_;
  Point_grid grid_;
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_CROSSING_TEST_H
