// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_FACE_GRID_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_FACE_GRID_H

#include <CGAL/Inter_angle_remeshing/internal/geometry/Point_grid.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/Remeshing_mesh.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/mesh_regions.h>

#include <cstddef>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// Finds the faces of the mesh that are near, over any sheet: those of the vertices that are, where these lay when it was asked
// first. Faces with edges that are longer than those of a remeshed mesh may be overlooked; no vertex moves nearly as far later.
class Face_grid
{
  // Edges are hardly longer than this, in target lengths.
  static constexpr double LONGEST_EDGE = 1.5;

public:
  using Index = Remeshing_mesh::Index;

  Face_grid(const Remeshing_mesh& mesh, double target_length)
    : mesh_(mesh), longest_edge_(LONGEST_EDGE * target_length), vertices_(longest_edge_)
  {}

  // Calls `function(face)` for the faces that may meet the box, and some others, until it returns false.
  template <class Function>
  void for_each_near(const Vector3& low, const Vector3& high, Visit_marks& marks, const Function& function)
  {
    if (!is_filled_) fill();
    const Vector3 margin{longest_edge_, longest_edge_, longest_edge_};
    bool goes_on = true;
    marks.start(mesh_.number_of_face_slots());
    vertices_.for_each_in_box(low - margin, high + margin, [&](Index v) {
      if (!goes_on || std::size_t(v) >= mesh_.number_of_vertex_slots() || !mesh_.is_vertex(v)) return;
      mesh_.for_each_around(v, [&](Index h) {
        const Index f = mesh_.face(h);
        if (goes_on && marks.visit(std::size_t(f))) goes_on = function(f);
      });
    });
  }

private:
  void fill()
  {
    for (Index v = 0; v < Index(mesh_.number_of_vertex_slots()); ++v)
      if (mesh_.is_vertex(v)) vertices_.insert(mesh_.position(v), v);
    is_filled_ = true;
  }

  const Remeshing_mesh& mesh_;
  double longest_edge_;
  Point_grid vertices_;
  bool is_filled_ = false;
};

// Whether so many looks at faces that may be near are enough for a pass over the mesh. Where sheets lie on each other by the dozen, or the
// target length differs by the thousand from place to place, thousands of faces are near each; on the meshes of CGAL parting faces takes
// at most 16 looks for each of these faces and some more, finding far spots 37.
inline bool are_enough_looks(const Remeshing_mesh& mesh, std::size_t looks)
{
  constexpr std::size_t LOOKS_PER_FACE = 100, FURTHER_FACES = 1000;
  return looks > LOOKS_PER_FACE * (mesh.number_of_live_faces() + FURTHER_FACES);
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_FACE_GRID_H
