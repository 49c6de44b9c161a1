// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_EXCHANGE_OUTSIDE_FACES_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_EXCHANGE_OUTSIDE_FACES_H

#include <CGAL/Inter_angle_remeshing/internal/exchange/Descriptor_index.h>
#include <CGAL/Inter_angle_remeshing/internal/geometry/divide_triangle.h>
#include <CGAL/Inter_angle_remeshing/internal/geometry/to_vector3.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/Remeshing_mesh.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/Rim_chains.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// The faces outside of the range on whose sides the run has put vertices. Each is divided into triangles between these and its corners;
// the face itself becomes one of them, all others and the edges between them are new.
template <class TriangleMesh>
class Outside_faces
{
  using Traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Traits::vertex_descriptor;
  using halfedge_descriptor = typename Traits::halfedge_descriptor;
  using face_descriptor = typename Traits::face_descriptor;
  using Index = Remeshing_mesh::Index;

public:
  // A triangle by places in the loop around the face. Its sides are such places, too, for those that begin there, or n + 2 e and
  // n + 2 e + 1 for the two sides of new edge e of the face, where n is the length of the loop.
  struct Piece
  {
    std::array<std::size_t, 3> corners, sides;
  };

  struct Divided_face
  {
    face_descriptor face;
    std::array<halfedge_descriptor, 3> sides;      // as they were before; the first is that of the face
    std::array<vertex_descriptor, 3> corners;      // where the sides begin
    std::array<std::size_t, 3> places;             // of the corners in the loop
    std::vector<Index> across;                     // by place: the half-edge of the mesh whose other side begins there; -1: a whole side
    std::vector<double> parts;                     // by place: which part of its side lies before it
    std::vector<Piece> pieces;
    std::size_t elements_before, corners_before;   // those of the faces before it: new faces, and as many edges; places

    // Barycentric, of a place in the loop.
    std::array<double, 3> coordinates(std::size_t place) const
    {
      std::array<double, 3> result{0, 0, 0};
      const int side = side_of(place);
      result[side] = 1 - parts[place];
      result[(side + 1) % 3] = parts[place];
      return result;
    }

    // Whether a place in the loop is one of the face's corners.
    bool is_corner(std::size_t place) const { return std::find(places.begin(), places.end(), place) != places.end(); }

    // The side that begins at that place, or lies there.
    int side_of(std::size_t place) const { return place < places[1] ? 0 : place < places[2] ? 1 : 2; }
  };

  // `user_halfedge(source, target)` is the user's half-edge between these input vertices.
  template <class VertexPointMap, class Function>
  void plan(const TriangleMesh& tmesh, const VertexPointMap& vpm, const Remeshing_mesh& mesh, const Function& user_halfedge)
  {
    const Rim_chains chains(mesh);
    faces_.clear();
    Descriptor_index<face_descriptor> number(std::size_t(chains.end() - chains.begin()));
    std::vector<std::array<const Rim_chains::Chain*, 3>> chains_of;
    for (const Rim_chains::Chain& chain : chains) {
      const halfedge_descriptor side = opposite(user_halfedge(chain.source, chain.target), tmesh);
      const auto [i, is_new] = number.insert(face(side, tmesh), Index(faces_.size()));
      if (is_new) {
        faces_.push_back(divided_face(face(side, tmesh), tmesh));
        chains_of.push_back({nullptr, nullptr, nullptr});
      }
      for (int k = 0; k < 3; ++k)
        if (faces_[i].sides[k] == side) chains_of[i][k] = &chain;
    }
    number_of_new_faces_ = 0;
    std::size_t corners = 0;
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      Divided_face& f = faces_[i];
      divide(f, chains_of[i], vpm, mesh);
      f.elements_before = number_of_new_faces_;
      f.corners_before = corners;
      number_of_new_faces_ += f.pieces.size() - 1;
      corners += f.across.size();
    }
  }

  const std::vector<Divided_face>& divided() const { return faces_; }

  // As many edges are new: each of them divides a face into two.
  std::size_t number_of_new_faces() const { return number_of_new_faces_; }

  // Allocates the new faces and edges; take_back() removes them.
  void make_elements(TriangleMesh& tmesh)
  {
    new_faces_.reserve(number_of_new_faces_);
    new_edges_.reserve(number_of_new_faces_);
    while (new_faces_.size() < number_of_new_faces_) new_faces_.push_back(add_face(tmesh));
    while (new_edges_.size() < number_of_new_faces_) new_edges_.push_back(halfedge(add_edge(tmesh), tmesh));
  }
  void take_back(TriangleMesh& tmesh)
  {
    for (; !new_faces_.empty(); new_faces_.pop_back()) remove_face(new_faces_.back(), tmesh);
    for (; !new_edges_.empty(); new_edges_.pop_back()) remove_edge(edge(new_edges_.back(), tmesh), tmesh);
  }

  // The new vertices are the user's `vertex_of(v)`, the half-edges `halfedge_of(h)`.
  template <class VertexOf, class HalfedgeOf>
  void connect(TriangleMesh& tmesh, const Remeshing_mesh& mesh, const VertexOf& vertex_of, const HalfedgeOf& halfedge_of)
  {
    for (const Divided_face& f : faces_) {
      const std::size_t n = f.across.size();
      const auto vertex = [&](std::size_t place) {
        for (int k = 0; k < 3; ++k)
          if (f.places[k] == place) return f.corners[k];
        return vertex_of(mesh.target(f.across[place]));
      };
      const auto side = [&](std::size_t s) {
        if (s >= n) {
          const halfedge_descriptor h = new_edges_[f.elements_before + (s - n) / 2];
          return (s - n) % 2 == 0 ? h : opposite(h, tmesh);
        }
        if (f.across[s] >= 0) return opposite(halfedge_of(f.across[s]), tmesh);
        return f.sides[f.side_of(s)];
      };
      for (std::size_t i = 0; i < f.pieces.size(); ++i) {
        const face_descriptor piece = face_of(f, i);
        for (int k = 0; k < 3; ++k) {
          const halfedge_descriptor h = side(f.pieces[i].sides[k]);
          set_target(h, vertex(f.pieces[i].corners[(k + 1) % 3]), tmesh);
          set_next(h, side(f.pieces[i].sides[(k + 1) % 3]), tmesh);
          set_face(h, piece, tmesh);
          if (k == 0) set_halfedge(piece, h, tmesh);
        }
      }
    }
  }

  // After connect(): calls `function(face, new face)` for each new face and the one that it was divided from.
  template <class Function>
  void for_each_new_face(const Function& function) const
  {
    for (const Divided_face& f : faces_)
      for (std::size_t i = 1; i < f.pieces.size(); ++i) function(f.face, face_of(f, i));
  }

  // After connect(): calls `function(i, h)` for the half-edges h of the pieces, which point to place number i of all faces' loops.
  template <class Function>
  void for_each_corner(const TriangleMesh& tmesh, const Function& function) const
  {
    for (const Divided_face& f : faces_)
      for (std::size_t i = 0; i < f.pieces.size(); ++i) {
        halfedge_descriptor h = halfedge(face_of(f, i), tmesh);        // the first side
        for (int k = 0; k < 3; ++k, h = next(h, tmesh)) function(f.corners_before + f.pieces[i].corners[(k + 1) % 3], h);
      }
  }

  // A half-edge of each new edge.
  const std::vector<halfedge_descriptor>& new_edges() const { return new_edges_; }

private:
  // The user's face that piece i is.
  face_descriptor face_of(const Divided_face& f, std::size_t i) const { return i == 0 ? f.face : new_faces_[f.elements_before + i - 1]; }

  static Divided_face divided_face(face_descriptor f, const TriangleMesh& tmesh)
  {
    Divided_face result;
    result.face = f;
    halfedge_descriptor h = halfedge(f, tmesh);
    for (int k = 0; k < 3; ++k, h = next(h, tmesh)) {
      result.sides[k] = h;
      result.corners[k] = source(h, tmesh);
    }
    return result;
  }

  template <class VertexPointMap>
  static void divide(Divided_face& f, const std::array<const Rim_chains::Chain*, 3>& chains, const VertexPointMap& vpm,
                     const Remeshing_mesh& mesh)
  {
    std::vector<Vector3> loop;
    std::array<Vector3, 3> corners;
    for (int k = 0; k < 3; ++k) corners[k] = (1 / mesh.unit()) * internal::to_vector3(get(vpm, f.corners[k]));
    for (int k = 0; k < 3; ++k) {
      const Vector3 begin = corners[k];
      const double squared_length = squared_distance(begin, corners[(k + 1) % 3]);
      f.places[k] = loop.size();
      const auto add = [&](const Vector3& p, Index across) {
        loop.push_back(p);
        f.across.push_back(across);
        f.parts.push_back(squared_length > 0 ? std::sqrt(squared_distance(begin, p) / squared_length) : 0);
      };
      add(begin, chains[k] ? chains[k]->halfedges.back() : -1);
      if (chains[k])
        for (auto h = chains[k]->halfedges.rbegin() + 1; h != chains[k]->halfedges.rend(); ++h) add(mesh.position(mesh.target(*h)), *h);
    }
    number_sides(f, divide_triangle(loop, f.places));
  }

  static void number_sides(Divided_face& f, const std::vector<std::array<std::size_t, 3>>& triangles)
  {
    const std::size_t n = f.across.size();
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> inner;      // by their ends, where one side is still to come
    std::size_t edges = 0;
    for (const std::array<std::size_t, 3>& corners : triangles) {
      Piece piece{corners, {}};
      for (int k = 0; k < 3; ++k) {
        const std::size_t a = corners[k], b = corners[(k + 1) % 3];
        if (b == (a + 1) % n) { piece.sides[k] = a; continue; }
        const auto known = inner.find({b, a});
        piece.sides[k] = known != inner.end() ? known->second + 1 : n + 2 * edges++;
        if (known == inner.end()) inner[{a, b}] = piece.sides[k];
      }
      f.pieces.push_back(piece);
    }
  }

  std::vector<Divided_face> faces_;
  std::size_t number_of_new_faces_ = 0;
  std::vector<face_descriptor> new_faces_;
  std::vector<halfedge_descriptor> new_edges_;
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_EXCHANGE_OUTSIDE_FACES_H
