// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_ATTRIBUTE_EXCHANGE_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_ATTRIBUTE_EXCHANGE_H

#include <CGAL/Inter_angle_remeshing/internal/Input_locator.h>
#include <CGAL/Inter_angle_remeshing/internal/Remeshing_mesh.h>
#include <CGAL/Inter_angle_remeshing/internal/Run_visitor.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

// Tells the user's visitor where on the input each vertex and face of the result comes from: first while the mesh still is the
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
  static constexpr bool READS_VERTICES = Reads_vertices<Visitor, TriangleMesh>::value,
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

  static constexpr bool are_carried() { return READS_VERTICES || READS_FACES; }

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
        auto h = halfedge(exchange_.input_faces()[place.source], tmesh_);
        std::array<vertex_descriptor, 3> corners;
        for (vertex_descriptor& corner : corners) {
          corner = source(h, tmesh_);
          h = next(h, tmesh_);
        }
        visitor_.read_vertex(std::size_t(v), corners, place.coordinates);
      }
    if constexpr (READS_FACES)
      for (Index f = 0; f < Index(mesh.number_of_live_faces()); ++f)
        visitor_.read_face(std::size_t(f), exchange_.input_faces()[locator.place_of_face(mesh, f).source]);
  }

  // The user's mesh is the result.
  void write(const Remeshing_mesh& mesh)
  {
    if constexpr (READS_VERTICES)
      for (Index v = 0; v < Index(mesh.number_of_live_vertices()); ++v)
        visitor_.write_vertex(std::size_t(v), exchange_.written_vertex(v));
    if constexpr (READS_FACES)
      for (Index f = 0; f < Index(mesh.number_of_live_faces()); ++f)
        visitor_.write_face(std::size_t(f), exchange_.written_face(f));
  }

private:
  bool is_unmoved(const Remeshing_mesh& mesh, Index v) const
  {
    return mesh.input(v) >= 0 && mesh.position(v) == input_positions_[mesh.input(v)];
  }

  Visitor& visitor_;
  const Exchange& exchange_;
  const TriangleMesh& tmesh_;
  std::vector<Vector3> input_positions_;
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_ATTRIBUTE_EXCHANGE_H
