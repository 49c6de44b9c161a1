// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_MESH_SNAPSHOT_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_MESH_SNAPSHOT_H

#include <CGAL/Inter_angle_remeshing/internal/mesh/Remeshing_mesh.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/mesh_regions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// The part of a mesh around some vertices as it was, so that operations there can be tried and undone.
class Mesh_snapshot
{
  using Index = Remeshing_mesh::Index;

public:
  // Free slots that splits may take before a restore().
  static constexpr std::size_t MAXIMUM_REUSED = 8;

  // Notes `vertices` and the faces around them: what may change until restore(), beside new elements.
  void take(const Remeshing_mesh& mesh, const std::vector<Index>& vertices)
  {
    vertices_.clear();
    faces_.clear();
    curve_edges_.clear();
    for (const Index v : vertices)
      vertices_.push_back({v, mesh.position_[v], mesh.first_[v], mesh.state_[v], mesh.hint_[v], mesh.input_[v], mesh.block_[v]});
    around_ = faces_around(mesh, vertices, marks_);
    for (const Index f : around_) {
      faces_.push_back({f, mesh.faces_[f], {}});
      if (!mesh.has_curves()) continue;
      for (int k = 0; k < 3; ++k) {
        const Index e = faces_.back().curve_edge_of[k] = mesh.curve_edge_of_[4 * f + k];
        if (mesh.has_place(4 * f + k)) curve_edges_.emplace_back(e >> 1, mesh.curve_edges_[e >> 1]);
      }
    }
    vertex_slots_.take(mesh.position_.size(), mesh.free_vertices_);
    face_slots_.take(mesh.faces_.size(), mesh.free_faces_);
    number_of_curve_edges_ = mesh.curve_edges_.size();
  }

  void restore(Remeshing_mesh& mesh) const
  {
    mesh.resize_vertices(vertex_slots_.size);
    mesh.faces_.resize(face_slots_.size);
    if (mesh.has_curves()) mesh.curve_edge_of_.resize(4 * face_slots_.size);
    mesh.curve_edges_.resize(number_of_curve_edges_);
    vertex_slots_.restore(mesh.free_vertices_, [&](Index v) {
      mesh.first_[v] = -1;
      mesh.state_[v] = Remeshing_mesh::Vertex_state();
    });
    face_slots_.restore(mesh.free_faces_, [&](Index f) { mesh.faces_[f] = Corner_table::Face(); });
    for (const auto& e : curve_edges_) mesh.curve_edges_[e.first] = e.second;
    for (const Face& f : faces_) {
      mesh.faces_[f.face] = f.record;
      if (mesh.has_curves()) std::copy(f.curve_edge_of.begin(), f.curve_edge_of.end(), mesh.curve_edge_of_.begin() + 4 * f.face);
    }
    for (const Vertex& v : vertices_) {
      mesh.position_[v.vertex] = v.position;
      mesh.first_[v.vertex] = v.first;
      mesh.state_[v.vertex] = v.state;
      mesh.hint_[v.vertex] = v.hint;
      mesh.input_[v.vertex] = v.input;
      mesh.block_[v.vertex] = v.block;
    }
  }

  // The faces around the vertices, as they were.
  const std::vector<Index>& faces() const { return around_; }

private:
  struct Vertex
  {
    Index vertex;
    Vector3 position;
    Index first;
    Remeshing_mesh::Vertex_state state;
    Index hint, input, block;
  };
  struct Face
  {
    Index face;
    Corner_table::Face record;
    std::array<Index, 3> curve_edge_of;
  };
  // Slots of vertices or faces: how many there were, and which of them were free.
  struct Slots
  {
    std::size_t size = 0, number_of_free = 0;
    std::array<Index, MAXIMUM_REUSED> last_free;

    void take(std::size_t n, const std::vector<Index>& free)
    {
      size = n;
      number_of_free = free.size();
      std::copy(free.end() - std::ptrdiff_t((std::min)(MAXIMUM_REUSED, free.size())), free.end(), last_free.begin());
    }
    template <class Clear>
    void restore(std::vector<Index>& free, const Clear& clear) const
    {
      free.resize(number_of_free);
      const std::size_t n = (std::min)(MAXIMUM_REUSED, number_of_free);
      std::copy(last_free.begin(), last_free.begin() + std::ptrdiff_t(n), free.end() - std::ptrdiff_t(n));
      for (std::size_t i = 0; i < n; ++i) clear(last_free[i]);
    }
  };

  std::vector<Vertex> vertices_;
  std::vector<Face> faces_;
  std::vector<Index> around_;
  std::vector<std::pair<Index, Remeshing_mesh::Curve_edge>> curve_edges_;
  Slots vertex_slots_, face_slots_;
  Visit_marks marks_;
  std::size_t number_of_curve_edges_ = 0;
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_MESH_SNAPSHOT_H
