// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_SURROUNDINGS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_SURROUNDINGS_H

#include <CGAL/Inter_angle_remeshing/internal/geometry/divide_triangle.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/Remeshing_mesh.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/Rim_chains.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/crossing_faces.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/crossings.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

// The faces outside of the range that are joined to its rim. Where edges of the rim were split they are divided, else no pass changes
// them; faces of the range shall not cross them.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

struct Surroundings
{
  using Index = Remeshing_mesh::Index;

  std::vector<std::array<Index, 3>> faces;     // numbers of input vertices of the range, or ~i for points[i]
  std::vector<Vector3> points;                 // in units of the flat mesh
};

class Mesh_in_surroundings;
bool do_cross_each_other(const Mesh_in_surroundings& mesh, Corner_table::Index f, Corner_table::Index g);

// The mesh together with its surroundings, whose faces and points have the names ~0, ~1, ... It is valid as long as no edge of the rim
// is split or collapsed.
class Mesh_in_surroundings
{
public:
  using Index = Remeshing_mesh::Index;

  Mesh_in_surroundings(const Remeshing_mesh& mesh, const Surroundings& surroundings)
    : mesh_(mesh), surroundings_(surroundings)
  {
    if (surroundings.faces.empty()) return;
    std::vector<Index> on_rim(mesh.number_of_vertex_slots(), -1);             // by number in the input
    for (Index v = 0; v < Index(mesh.number_of_vertex_slots()); ++v) {
      if (!mesh.is_vertex(v) || mesh.input(v) < 0 || (mesh.marks(v) & Remeshing_mesh::NEXT_TO_OUTSIDE) == 0) continue;
      if (std::size_t(mesh.input(v)) >= on_rim.size()) on_rim.resize(std::size_t(mesh.input(v)) + 1, -1);
      on_rim[mesh.input(v)] = v;
    }
    const Rim_chains chains(mesh);
    for (const std::array<Index, 3>& corners : surroundings.faces) add_divided(corners, on_rim, chains);
  }

  bool is_alone() const { return faces_.empty(); }

  // What crossings.h asks of a surface.
  const Corner_table::Face& face_record(Index f) const { return f >= 0 ? mesh_.face_record(f) : faces_[~f]; }
  const Vector3& position(Index v) const { return v >= 0 ? mesh_.position(v) : surroundings_.points[~v]; }
  // Whether v may be the same vertex of the user's as another one with its position.
  bool is_pinched(Index v) const { return v < 0 || (mesh_.marks(v) & (Remeshing_mesh::PINCHED | Remeshing_mesh::NEXT_TO_OUTSIDE)) != 0; }

  // The pairs of a face of the mesh and one of the surroundings that cross each other, in order.
  std::vector<std::pair<Index, Index>> crossings() const
  {
    if (is_alone()) return {};
    std::vector<Index> outside, inside;
    Bounding_box all;
    for (Index o = 0; o < Index(faces_.size()); ++o) {
      outside.push_back(~o);
      all += bounding_box(*this, ~o);
    }
    for (Index f = 0; f < Index(mesh_.number_of_face_slots()); ++f)
      if (mesh_.is_face(f) && do_overlap(bounding_box(*this, f), all)) inside.push_back(f);
    return crossing_faces(*this, inside, outside);
  }

  // The faces of the surroundings that may cross one of these faces of the mesh.
  std::vector<Index> faces_near(const std::vector<Index>& faces) const
  {
    std::vector<Index> result;
    if (is_alone()) return result;
    Bounding_box all;
    for (const Index f : faces) all += bounding_box(*this, f);
    for (Index o = 0; o < Index(faces_.size()); ++o)
      if (do_overlap(bounding_box(*this, ~o), all)) result.push_back(~o);
    return result;
  }

  // Whether face f of the mesh crosses one of the surroundings.
  bool crosses(Index f) const
  {
    bool result = false;
    for_each_crossing(*this, {f}, faces_near({f}), [&](Index, Index) { result = true; return false; });
    return result;
  }

private:
  // `on_rim` are the vertices of the mesh by their number in the input.
  void add_divided(const std::array<Index, 3>& corners, const std::vector<Index>& on_rim, const Rim_chains& chains)
  {
    std::vector<Index> loop;
    std::vector<Vector3> points;
    std::array<std::size_t, 3> places;
    const auto add = [&](Index v) {
      loop.push_back(v);
      points.push_back(position(v));
    };
    for (int k = 0; k < 3; ++k) {
      const Index v = corners[k], next = corners[(k + 1) % 3];
      places[k] = loop.size();
      add(v < 0 ? v : on_rim[v]);
      if (v < 0 || next < 0) continue;
      if (const Rim_chains::Chain* chain = chains.find(next, v))
        for (auto h = chain->halfedges.rbegin(); h + 1 != chain->halfedges.rend(); ++h) add(mesh_.origin(*h));
    }
    for (const std::array<std::size_t, 3>& piece : divide_triangle(points, places)) {
      faces_.emplace_back();
      for (int k = 0; k < 3; ++k) faces_.back().vertex[k] = loop[piece[k]];
    }
  }

  const Remeshing_mesh& mesh_;
  const Surroundings& surroundings_;
  std::vector<Corner_table::Face> faces_;
};

// A vertex of the user's may be several of the mesh: faces that have two points in common share an edge.
inline bool do_cross_each_other(const Mesh_in_surroundings& mesh, Corner_table::Index f, Corner_table::Index g)
{
  const auto &a = mesh.face_record(f).vertex, &b = mesh.face_record(g).vertex;
  const auto is_shared = [&](Corner_table::Index v) {
    return std::any_of(b, b + 3, [&](Corner_table::Index w) { return mesh.position(v) == mesh.position(w); }); };
  return ((f >= 0 && g >= 0) || std::count_if(a, a + 3, is_shared) < 2) && do_cross_each_other<Mesh_in_surroundings>(mesh, f, g);
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_SURROUNDINGS_H
