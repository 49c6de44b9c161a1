// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_EXCHANGE_ATTRIBUTE_EXCHANGE_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_EXCHANGE_ATTRIBUTE_EXCHANGE_H

#include <CGAL/Inter_angle_remeshing/internal/Run_visitor.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/Remeshing_mesh.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/Input_locator.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/surface_walk.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

// Tells the user's visitor where on the input each vertex, corner and face of the result comes from: first while the mesh still is the
// input, to read attributes, then when it is the result, to write them.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

template <class Visitor, class TriangleMesh, class = void>
struct Reads_vertices : std::false_type {};
template <class Visitor, class TriangleMesh>
struct Reads_vertices<Visitor, TriangleMesh, std::void_t<decltype(std::declval<Visitor&>().read_vertex(
  std::size_t(), std::declval<const std::array<typename boost::graph_traits<TriangleMesh>::vertex_descriptor, 3>&>(),
  std::declval<const std::array<double, 3>&>()))>> : std::true_type {};

template <class Visitor, class TriangleMesh, class = void>
struct Reads_faces : std::false_type {};
template <class Visitor, class TriangleMesh>
struct Reads_faces<Visitor, TriangleMesh, std::void_t<decltype(std::declval<Visitor&>().read_face(
  std::size_t(), std::declval<typename boost::graph_traits<TriangleMesh>::face_descriptor>()))>> : std::true_type {};

template <class Visitor, class TriangleMesh, class = void>
struct Reads_corners : std::false_type {};
template <class Visitor, class TriangleMesh>
struct Reads_corners<Visitor, TriangleMesh, std::void_t<decltype(std::declval<Visitor&>().read_corner(
  std::size_t(), std::declval<const std::array<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor, 3>&>(),
  std::declval<const std::array<double, 3>&>()))>> : std::true_type {};

// Nobody wants to know.
template <class RunVisitor, class Exchange, class TriangleMesh>
class Attribute_exchange
{
public:
  Attribute_exchange(RunVisitor&, const Exchange&, const TriangleMesh&, const Remeshing_mesh&) {}
  static constexpr bool are_carried() { return false; }
  void read(const Remeshing_mesh&, const Input_locator&) const {}
  void write(const Remeshing_mesh&) const {}
};

template <class Visitor, class Exchange, class TriangleMesh>
class Attribute_exchange<User_visitor<Visitor>, Exchange, TriangleMesh>
{
  using Index = Remeshing_mesh::Index;
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  static constexpr bool READS_VERTICES = Reads_vertices<Visitor, TriangleMesh>::value,
                        READS_CORNERS = Reads_corners<Visitor, TriangleMesh>::value,
                        READS_FACES = Reads_faces<Visitor, TriangleMesh>::value;

public:
  // `input` is the flat mesh before the run.
  Attribute_exchange(User_visitor<Visitor>& visitor, const Exchange& exchange, const TriangleMesh& tmesh, const Remeshing_mesh& input)
    : visitor_(visitor.user()), exchange_(exchange), tmesh_(tmesh)
  {
    if constexpr (READS_VERTICES) {
      input_positions_.resize(exchange.input_vertices().size());
      for (Index v = 0; v < Index(input.number_of_vertex_slots()); ++v) input_positions_[input.input(v)] = input.position(v);
    }
  }

  static constexpr bool are_carried() { return READS_VERTICES || READS_CORNERS || READS_FACES; }

  // The user's mesh is the input, `mesh` the result.
  void read(const Remeshing_mesh& mesh, const Input_locator& locator)
  {
    if constexpr (READS_VERTICES)
      for (Index v = 0; v < Index(mesh.number_of_live_vertices()); ++v) {
        if (is_unmoved(mesh, v)) {
          const vertex_descriptor user = exchange_.input_vertices()[mesh.input(v)];
          visitor_.read_vertex(std::size_t(v), std::array<vertex_descriptor, 3>{user, user, user}, std::array<double, 3>{1, 0, 0});
          continue;
        }
        const Input_place place = locator.place_of_vertex(mesh, v);
        const auto [a, b, c] = corners_of(place.source);
        const std::array<vertex_descriptor, 3> corners{target(a, tmesh_), target(b, tmesh_), target(c, tmesh_)};
        visitor_.read_vertex(std::size_t(v), corners, place.coordinates);
      }
    if constexpr (READS_CORNERS) read_corners(mesh, locator);
    if constexpr (READS_FACES)
      for (Index f = 0; f < Index(mesh.number_of_live_faces()); ++f)
        visitor_.read_face(std::size_t(f), exchange_.input_faces()[locator.place_of_face(mesh, f).source]);
    read_outside(mesh);
  }

  // The user's mesh is the result.
  void write(const Remeshing_mesh& mesh)
  {
    if constexpr (READS_VERTICES)
      for (Index v = 0; v < Index(mesh.number_of_live_vertices()); ++v)
        visitor_.write_vertex(std::size_t(v), exchange_.written_vertex(v));
    if constexpr (READS_CORNERS)
      for (Index f = 0; f < Index(mesh.number_of_live_faces()); ++f)
        for (const halfedge_descriptor h : halfedges_around_face(halfedge(exchange_.written_face(f), tmesh_), tmesh_))
          visitor_.write_corner(sectors_[corner_at(mesh, f, target(h, tmesh_))], h);
    if constexpr (READS_FACES)
      for (Index f = 0; f < Index(mesh.number_of_live_faces()); ++f)
        visitor_.write_face(std::size_t(f), exchange_.written_face(f));
    write_outside(mesh);
  }

private:
  // New faces outside of the range are parts of one that was there before. Their vertices are the range's.
  void read_outside(const Remeshing_mesh& mesh)
  {
    std::size_t face = mesh.number_of_live_faces(), corner = corners_read_;
    for (const auto& f : exchange_.outside_faces().divided()) {
      if constexpr (READS_FACES)
        for (std::size_t i = 1; i < f.pieces.size(); ++i) visitor_.read_face(face++, f.face);
      if constexpr (READS_CORNERS)
        for (std::size_t place = 0; place < f.across.size(); ++place) {
          const std::array<halfedge_descriptor, 3> corners{f.sides[2], f.sides[0], f.sides[1]};
          visitor_.read_corner(corner++, corners, f.coordinates(place));
        }
    }
    (void)face; (void)corner;
  }

  void write_outside(const Remeshing_mesh& mesh)
  {
    if constexpr (READS_FACES) {
      std::size_t face = mesh.number_of_live_faces();
      exchange_.outside_faces().for_each_new_face([&](auto, auto new_face) { visitor_.write_face(face++, new_face); });
    }
    if constexpr (READS_CORNERS)
      exchange_.outside_faces().for_each_corner(tmesh_, [&](std::size_t i, auto h) { visitor_.write_corner(corners_read_ + i, h); });
  }

  // The half-edges that point to the corners of a face of the input, in the order of coordinates.
  std::array<halfedge_descriptor, 3> corners_of(Index source) const
  {
    const halfedge_descriptor h = halfedge(exchange_.input_faces()[source], tmesh_);
    return {prev(h, tmesh_), h, next(h, tmesh_)};
  }

  // The corners at a vertex between two curves, or at a vertex on none, are a sector: one place of the input.
  void read_corners(const Remeshing_mesh& mesh, const Input_locator& locator)
  {
    sectors_.assign(4 * mesh.number_of_live_faces(), NONE);
    const std::unordered_map<Index, Rim_place> rim_places = places_on_rim(mesh);
    std::size_t n = 0;
    mesh.for_each_halfedge([&](Index h) {
      if (sectors_[h] != NONE) return;
      const bool is_bounded = note_sector(mesh, h, n);
      if (const auto rim = rim_places.find(mesh.origin(h)); rim != rim_places.end()) {
        const halfedge_descriptor side = rim->second.side;
        const std::array<halfedge_descriptor, 3> corners{side, prev(side, tmesh_), next(side, tmesh_)};
        visitor_.read_corner(n++, corners, std::array<double, 3>{1 - rim->second.part, rim->second.part, 0});
        return;
      }
      const Input_place place = is_bounded ? locator.place_of_corner(mesh, h) : locator.place_of_vertex(mesh, mesh.origin(h));
      visitor_.read_corner(n++, corners_of(place.source), place.coordinates);
    });
    corners_read_ = n;
  }

  // A new vertex on a divided side of a face outside: the user's half-edge across it, and which part of that lies between its target and
  // the vertex.
  struct Rim_place
  {
    halfedge_descriptor side;
    double part;
  };

  // The corners on both sides of the rim read the same values with the same weights: there is no seam where the input has none.
  std::unordered_map<Index, Rim_place> places_on_rim(const Remeshing_mesh& mesh) const
  {
    std::unordered_map<Index, Rim_place> result;
    for (const auto& f : exchange_.outside_faces().divided())
      for (std::size_t place = 0; place < f.across.size(); ++place)
        if (!f.is_corner(place))
          result[mesh.target(f.across[place])] = {opposite(f.sides[f.side_of(place)], tmesh_), f.parts[place]};
    return result;
  }

  // Gives number i to the sector of h. Returns whether curves bound it.
  bool note_sector(const Remeshing_mesh& mesh, Index h, std::size_t i)
  {
    Index k = h;
    do {
      sectors_[k] = i;
      if (is_barrier(mesh, mesh.prev(k))) break;
      k = mesh.rotate_ccw(k);
      if (k == h) return false;
    } while (k >= 0);
    bool is_bounded = k >= 0;
    for (k = h; !is_barrier(mesh, k);) {
      k = mesh.rotate_cw(k);
      if (k < 0) return is_bounded;
      sectors_[k] = i;
    }
    return true;
  }

  // The half-edge of face f that starts at what is vertex v of the user's mesh.
  Index corner_at(const Remeshing_mesh& mesh, Index f, vertex_descriptor v) const
  {
    Index h = 4 * f;
    while (exchange_.written_vertex(mesh.origin(h)) != v) ++h;
    return h;
  }

  bool is_unmoved(const Remeshing_mesh& mesh, Index v) const
  {
    return mesh.input(v) >= 0 && mesh.position(v) == input_positions_[mesh.input(v)];
  }

  Visitor& visitor_;
  const Exchange& exchange_;
  const TriangleMesh& tmesh_;
  std::vector<Vector3> input_positions_;

  static constexpr std::size_t NONE = std::size_t(-1);
  std::size_t corners_read_ = 0;           // in the range
  std::vector<std::size_t> sectors_;       // by half-edge of the result: the number of what its origin's corner reads
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_EXCHANGE_ATTRIBUTE_EXCHANGE_H
