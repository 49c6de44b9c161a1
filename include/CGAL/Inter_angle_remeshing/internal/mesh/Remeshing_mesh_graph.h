// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_REMESHING_MESH_GRAPH_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_REMESHING_MESH_GRAPH_H

#include <CGAL/Inter_angle_remeshing/internal/mesh/Remeshing_mesh.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/functional/hash.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/iterator/counting_iterator.hpp>
#include <boost/iterator/filter_iterator.hpp>
#include <boost/iterator/transform_iterator.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <ostream>
#include <type_traits>
#include <utility>
#include <vector>

// Remeshing_mesh as a model of CGAL's FaceListGraph, for policies, visitors and CGAL's own algorithms.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// An index that knows what it counts. The null descriptor lies outside of the range of every mesh.
template <class Tag>
class Mesh_descriptor
{
public:
  using Index = Corner_table::Index;
  static constexpr Index NONE = (std::numeric_limits<Index>::min)();

  Mesh_descriptor() = default;
  explicit Mesh_descriptor(Index i) : index_(i) {}

  Index index() const { return index_; }

  friend bool operator==(Mesh_descriptor a, Mesh_descriptor b) { return a.index_ == b.index_; }
  friend bool operator!=(Mesh_descriptor a, Mesh_descriptor b) { return a.index_ != b.index_; }
  friend bool operator<(Mesh_descriptor a, Mesh_descriptor b) { return a.index_ < b.index_; }
  friend std::size_t hash_value(Mesh_descriptor d) { return std::hash<Index>()(d.index_); }
  friend std::ostream& operator<<(std::ostream& out, Mesh_descriptor d) { return out << d.index_; }

private:
  Index index_ = NONE;
};

struct Vertex_tag {};
struct Halfedge_tag {};
struct Face_tag {};

using Mesh_vertex = Mesh_descriptor<Vertex_tag>;
using Mesh_halfedge = Mesh_descriptor<Halfedge_tag>;   // a corner, or a border side (negative)
using Mesh_face = Mesh_descriptor<Face_tag>;

// The edge of a half-edge, which it remembers: halfedge(edge(h)) is h, as in CGAL's own meshes. Its name, and what is
// compared, is the greater one of its two half-edges, always a corner.
class Mesh_edge
{
public:
  using Index = Corner_table::Index;

  Mesh_edge() = default;
  Mesh_edge(Mesh_halfedge h, Mesh_halfedge opposite) : halfedge_(h), name_((std::max)(h.index(), opposite.index())) {}

  Mesh_halfedge halfedge() const { return halfedge_; }
  Index index() const { return name_; }

  friend bool operator==(const Mesh_edge& a, const Mesh_edge& b) { return a.name_ == b.name_; }
  friend bool operator!=(const Mesh_edge& a, const Mesh_edge& b) { return a.name_ != b.name_; }
  friend bool operator<(const Mesh_edge& a, const Mesh_edge& b) { return a.name_ < b.name_; }
  friend std::size_t hash_value(const Mesh_edge& e) { return std::hash<Index>()(e.name_); }
  friend std::ostream& operator<<(std::ostream& out, const Mesh_edge& e) { return out << e.name_; }

private:
  Mesh_halfedge halfedge_;
  Index name_ = Mesh_vertex::NONE;
};

// --- HalfedgeGraph ----------------------------------------------------------------------------------------------

inline Mesh_halfedge opposite(Mesh_halfedge h, const Remeshing_mesh& m) { return Mesh_halfedge(m.opposite(h.index())); }
inline Mesh_vertex source(Mesh_halfedge h, const Remeshing_mesh& m) { return Mesh_vertex(m.source(h.index())); }
inline Mesh_vertex target(Mesh_halfedge h, const Remeshing_mesh& m)
{
  return Mesh_vertex(m.source(m.opposite(h.index())));
}

inline Mesh_halfedge prev(Mesh_halfedge h, const Remeshing_mesh& m)
{
  if (h.index() >= 0) return Mesh_halfedge(m.prev(h.index()));
  // The border comes in where the fan of the source begins: the source of ~h is the target of the corner h.
  return Mesh_halfedge(~m.first(m.source(h.index())));
}

inline Mesh_halfedge next(Mesh_halfedge h, const Remeshing_mesh& m)
{
  if (h.index() >= 0) return Mesh_halfedge(m.next(h.index()));
  Remeshing_mesh::Index k = m.opposite(h.index());   // leaves the target of h; the last one of its fan leads on
  for (Remeshing_mesh::Index following = k; following >= 0; following = m.rotate_ccw(k)) k = following;
  return Mesh_halfedge(~m.prev(k));
}

inline Mesh_edge edge(Mesh_halfedge h, const Remeshing_mesh& m)
{
  return {h, opposite(h, m)};
}
inline Mesh_halfedge halfedge(const Mesh_edge& e, const Remeshing_mesh&) { return e.halfedge(); }
inline Mesh_vertex source(const Mesh_edge& e, const Remeshing_mesh& m) { return source(halfedge(e, m), m); }
inline Mesh_vertex target(const Mesh_edge& e, const Remeshing_mesh& m) { return target(halfedge(e, m), m); }

// The half-edge that comes in at the start of the fan: on the border where the vertex is.
inline Mesh_halfedge halfedge(Mesh_vertex v, const Remeshing_mesh& m)
{
  return Mesh_halfedge(m.opposite(m.first(v.index())));
}

inline std::pair<Mesh_halfedge, bool> halfedge(Mesh_vertex u, Mesh_vertex v, const Remeshing_mesh& m)
{
  const auto h = m.find_halfedge(u.index(), v.index());
  if (h >= 0) return {Mesh_halfedge(h), true};
  const auto g = m.find_halfedge(v.index(), u.index());
  return g >= 0 ? std::make_pair(Mesh_halfedge(m.opposite(g)), true) : std::make_pair(Mesh_halfedge(), false);
}
inline std::pair<Mesh_edge, bool> edge(Mesh_vertex u, Mesh_vertex v, const Remeshing_mesh& m)
{
  const auto found = halfedge(u, v, m);
  return {found.second ? edge(found.first, m) : Mesh_edge(), found.second};
}

inline std::size_t degree(Mesh_vertex v, const Remeshing_mesh& m) { return std::size_t(m.valence(v.index())); }
inline std::size_t out_degree(Mesh_vertex v, const Remeshing_mesh& m) { return degree(v, m); }
inline std::size_t in_degree(Mesh_vertex v, const Remeshing_mesh& m) { return degree(v, m); }

// --- FaceGraph --------------------------------------------------------------------------------------------------

inline Mesh_face face(Mesh_halfedge h, const Remeshing_mesh& m)
{
  return h.index() >= 0 ? Mesh_face(m.face(h.index())) : Mesh_face();
}
inline Mesh_halfedge halfedge(Mesh_face f, const Remeshing_mesh&) { return Mesh_halfedge(4 * f.index()); }
inline std::size_t degree(Mesh_face, const Remeshing_mesh&) { return 3; }

// --- the lists --------------------------------------------------------------------------------------------------

// Skips the slots of elements that were removed, and what is no element.
struct Is_live_vertex
{
  const Remeshing_mesh* mesh = nullptr;
  bool operator()(Corner_table::Index v) const { return mesh->is_vertex(v); }
};
struct Is_live_face
{
  const Remeshing_mesh* mesh = nullptr;
  bool operator()(Corner_table::Index f) const { return mesh->is_face(f); }
};
// Half-edges are counted through both signs: i and ~i.
struct Is_live_halfedge
{
  const Remeshing_mesh* mesh = nullptr;
  bool operator()(Corner_table::Index h) const
  {
    const Corner_table::Index corner = h >= 0 ? h : ~h;
    return Corner_table::corner(corner) < 3 && mesh->is_face(Corner_table::face(corner)) &&
           (h >= 0 || mesh->is_border(corner));
  }
};
struct Is_live_edge
{
  const Remeshing_mesh* mesh = nullptr;
  bool operator()(Corner_table::Index h) const { return Is_live_halfedge{mesh}(h) && mesh->opposite(h) < h; }
};

template <class Descriptor>
struct As_descriptor
{
  using result_type = Descriptor;
  Descriptor operator()(Corner_table::Index i) const { return Descriptor(i); }
};
template <>
struct As_descriptor<Mesh_edge>
{
  using result_type = Mesh_edge;
  const Remeshing_mesh* mesh = nullptr;
  Mesh_edge operator()(Corner_table::Index h) const { return edge(Mesh_halfedge(h), *mesh); }
};

template <class Descriptor, class Predicate>
using Mesh_iterator = boost::transform_iterator<
  As_descriptor<Descriptor>, boost::filter_iterator<Predicate, boost::counting_iterator<Corner_table::Index>>>;

template <class Descriptor, class Predicate>
Iterator_range<Mesh_iterator<Descriptor, Predicate>> mesh_range(const Remeshing_mesh& m, std::ptrdiff_t first,
                                                                std::ptrdiff_t past)
{
  using Counter = boost::counting_iterator<Corner_table::Index>;
  const Counter begin{Corner_table::Index(first)}, end{Corner_table::Index(past)};
  using Filter = boost::filter_iterator<Predicate, Counter>;
  As_descriptor<Descriptor> as_descriptor{};
  if constexpr (std::is_same<Descriptor, Mesh_edge>::value) as_descriptor.mesh = &m;
  return make_range(Mesh_iterator<Descriptor, Predicate>(Filter(Predicate{&m}, begin, end), as_descriptor),
                    Mesh_iterator<Descriptor, Predicate>(Filter(Predicate{&m}, end, end), as_descriptor));
}

using Mesh_vertex_iterator = Mesh_iterator<Mesh_vertex, Is_live_vertex>;
using Mesh_halfedge_iterator = Mesh_iterator<Mesh_halfedge, Is_live_halfedge>;
using Mesh_edge_iterator = Mesh_iterator<Mesh_edge, Is_live_edge>;
using Mesh_face_iterator = Mesh_iterator<Mesh_face, Is_live_face>;

inline Iterator_range<Mesh_vertex_iterator> vertices(const Remeshing_mesh& m)
{
  return mesh_range<Mesh_vertex, Is_live_vertex>(m, 0, m.number_of_vertex_slots());
}
inline Iterator_range<Mesh_face_iterator> faces(const Remeshing_mesh& m)
{
  return mesh_range<Mesh_face, Is_live_face>(m, 0, m.number_of_face_slots());
}
inline Iterator_range<Mesh_halfedge_iterator> halfedges(const Remeshing_mesh& m)
{
  const std::ptrdiff_t corners = 4 * std::ptrdiff_t(m.number_of_face_slots());
  return mesh_range<Mesh_halfedge, Is_live_halfedge>(m, -corners, corners);
}
inline Iterator_range<Mesh_edge_iterator> edges(const Remeshing_mesh& m)
{
  return mesh_range<Mesh_edge, Is_live_edge>(m, 0, 4 * std::ptrdiff_t(m.number_of_face_slots()));
}

inline std::size_t num_vertices(const Remeshing_mesh& m) { return m.number_of_live_vertices(); }
inline std::size_t num_faces(const Remeshing_mesh& m) { return m.number_of_live_faces(); }
inline std::size_t num_halfedges(const Remeshing_mesh& m)
{
  const auto range = halfedges(m);
  return std::size_t(std::distance(range.begin(), range.end()));
}
inline std::size_t num_edges(const Remeshing_mesh& m) { return num_halfedges(m) / 2; }

// --- property maps ----------------------------------------------------------------------------------------------

// The points of the vertices, in the user's units.
struct Mesh_point_map
{
  using key_type = Mesh_vertex;
  using value_type = CGAL::Simple_cartesian<double>::Point_3;
  using reference = value_type;
  using category = boost::readable_property_map_tag;

  const Remeshing_mesh* mesh = nullptr;

  friend value_type get(const Mesh_point_map& map, key_type v)
  {
    const Vector3 p = map.mesh->unit() * map.mesh->position(v.index());
    return {p.x, p.y, p.z};
  }
};

struct Mesh_edge_is_constrained_map
{
  using key_type = Mesh_edge;
  using value_type = bool;
  using reference = bool;
  using category = boost::readable_property_map_tag;

  const Remeshing_mesh* mesh = nullptr;

  friend bool get(const Mesh_edge_is_constrained_map& map, key_type e) { return map.mesh->is_constrained(e.index()); }
};

// The user's vertices.
template <class Vertex>
struct Mesh_input_vertex_map
{
  using key_type = Mesh_vertex;
  using value_type = Vertex;
  using reference = Vertex;
  using category = boost::readable_property_map_tag;

  const Remeshing_mesh* mesh = nullptr;
  const std::vector<Vertex>* input = nullptr;
  Vertex none{};

  friend Vertex get(const Mesh_input_vertex_map& map, key_type v)
  {
    const auto i = map.mesh->input(v.index());
    return i < 0 ? map.none : (*map.input)[i];
  }
};

inline Mesh_point_map get(CGAL::vertex_point_t, const Remeshing_mesh& m) { return {&m}; }
inline Mesh_point_map::value_type get(CGAL::vertex_point_t, const Remeshing_mesh& m, Mesh_vertex v)
{
  return get(Mesh_point_map{&m}, v);
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

namespace boost {

template <>
struct graph_traits<CGAL::Inter_angle_remeshing::internal::Remeshing_mesh>
{
private:
  struct Traversal : virtual boost::bidirectional_graph_tag, virtual boost::vertex_list_graph_tag,
                     virtual boost::edge_list_graph_tag {};

public:
  using vertex_descriptor = CGAL::Inter_angle_remeshing::internal::Mesh_vertex;
  using halfedge_descriptor = CGAL::Inter_angle_remeshing::internal::Mesh_halfedge;
  using edge_descriptor = CGAL::Inter_angle_remeshing::internal::Mesh_edge;
  using face_descriptor = CGAL::Inter_angle_remeshing::internal::Mesh_face;
  using vertex_iterator = CGAL::Inter_angle_remeshing::internal::Mesh_vertex_iterator;
  using halfedge_iterator = CGAL::Inter_angle_remeshing::internal::Mesh_halfedge_iterator;
  using edge_iterator = CGAL::Inter_angle_remeshing::internal::Mesh_edge_iterator;
  using face_iterator = CGAL::Inter_angle_remeshing::internal::Mesh_face_iterator;
  using directed_category = boost::undirected_tag;
  using edge_parallel_category = boost::disallow_parallel_edge_tag;
  using traversal_category = Traversal;
  using vertices_size_type = std::size_t;
  using halfedges_size_type = std::size_t;
  using edges_size_type = std::size_t;
  using faces_size_type = std::size_t;
  using degree_size_type = std::size_t;

  static vertex_descriptor null_vertex() { return {}; }
  static halfedge_descriptor null_halfedge() { return {}; }
  static face_descriptor null_face() { return {}; }
};

template <>
struct graph_traits<const CGAL::Inter_angle_remeshing::internal::Remeshing_mesh>
  : graph_traits<CGAL::Inter_angle_remeshing::internal::Remeshing_mesh>
{};

template <>
struct property_map<CGAL::Inter_angle_remeshing::internal::Remeshing_mesh, CGAL::vertex_point_t>
{
  using type = CGAL::Inter_angle_remeshing::internal::Mesh_point_map;
  using const_type = type;
};

} // namespace boost

namespace CGAL {
template <>
struct graph_has_property<Inter_angle_remeshing::internal::Remeshing_mesh, CGAL::vertex_point_t>
  : CGAL::Tag_true
{};
} // namespace CGAL

namespace std {
template <class Tag>
struct hash<CGAL::Inter_angle_remeshing::internal::Mesh_descriptor<Tag>>
{
  std::size_t operator()(CGAL::Inter_angle_remeshing::internal::Mesh_descriptor<Tag> d) const
  {
    return hash_value(d);
  }
};
template <>
struct hash<CGAL::Inter_angle_remeshing::internal::Mesh_edge>
{
  std::size_t operator()(const CGAL::Inter_angle_remeshing::internal::Mesh_edge& e) const { return hash_value(e); }
};
} // namespace std

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_REMESHING_MESH_GRAPH_H
