// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_EXCHANGE_FLAT_COPY_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_EXCHANGE_FLAT_COPY_H

#include <CGAL/Inter_angle_remeshing/internal/arguments/refuse.h>
#include <CGAL/Inter_angle_remeshing/internal/exchange/Descriptor_index.h>
#include <CGAL/Inter_angle_remeshing/internal/geometry/power_of_two_unit.h>
#include <CGAL/Inter_angle_remeshing/internal/geometry/to_vector3.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/Remeshing_mesh.h>

#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// A range of faces of the user's mesh as a flat mesh, and which element of the one is which of the other.
template <class TriangleMesh>
struct Flat_copy
{
  using Traits = boost::graph_traits<TriangleMesh>;

  Remeshing_mesh mesh;
  std::vector<typename Traits::face_descriptor> faces;          // by flat face
  std::vector<typename Traits::halfedge_descriptor> halfedges;  // by flat face and corner: 3 f + k
  std::vector<typename Traits::vertex_descriptor> vertices;     // by flat vertex

  typename Traits::halfedge_descriptor halfedge(Remeshing_mesh::Index h) const
  {
    return halfedges[3 * (h >> 2) + (h & 3)];
  }

  // Whether a face outside of the range lies beyond the edge of h, a half-edge of a face on the border of the copy.
  bool has_outside_face(Remeshing_mesh::Index h, const TriangleMesh& tmesh) const
  {
    return face(opposite(halfedge(h), tmesh), tmesh) != Traits::null_face();
  }
  // Whether the mesh goes on beyond the edge of h, but the copy does not.
  bool is_on_rim(Remeshing_mesh::Index h, const TriangleMesh& tmesh) const { return mesh.is_border(h) && has_outside_face(h, tmesh); }
};

// Whether a descriptor is that of a face of the mesh. Where elements have numbers that is told by the number, else only that it is one.
template <class Graph, class = void>
struct Face_membership
{
  using Face = typename boost::graph_traits<Graph>::face_descriptor;
  static constexpr bool IS_TOLD = false;
  static bool is_face(const Graph&, const Face& f) { return f != boost::graph_traits<Graph>::null_face(); }
};
// CGAL::Surface_mesh. (Two specializations by std::void_t are one to some compilers.)
template <class Graph>
struct Face_membership<Graph, decltype(std::declval<const Graph&>().has_valid_index(
                                typename boost::graph_traits<Graph>::face_descriptor()), void())>
{
  using Face = typename boost::graph_traits<Graph>::face_descriptor;
  static constexpr bool IS_TOLD = true;
  static bool is_face(const Graph& g, const Face& f) { return g.has_valid_index(f) && !g.is_removed(f); }
};
// OpenMesh's kernels.
template <class Graph>
struct Face_membership<Graph, decltype(std::declval<const Graph&>().is_valid_handle(
                                typename boost::graph_traits<Graph>::face_descriptor()), void())>
{
  using Face = typename boost::graph_traits<Graph>::face_descriptor;
  static constexpr bool IS_TOLD = true;
  static bool is_face(const Graph& g, const Face& f)
  {
    return g.is_valid_handle(f) && !(g.has_face_status() && g.status(f).deleted());
  }
};

// Reads a range of faces. Everything that makes an input unfit is refused here, before anything is changed.
template <class TriangleMesh, class VertexPointMap>
class Flat_copy_builder
{
  using Traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Traits::vertex_descriptor;
  using halfedge_descriptor = typename Traits::halfedge_descriptor;
  using Index = Remeshing_mesh::Index;
  using Membership = Face_membership<TriangleMesh>;
  using Face_numbers = Descriptor_index<typename Traits::face_descriptor>;

public:
  // `caller` is the public function in whose name unfit input is refused.
  Flat_copy_builder(const TriangleMesh& tmesh, VertexPointMap vpm, const char* caller)
    : tmesh_(tmesh), vpm_(vpm), caller_(caller)
  {}

  template <class FaceRange>
  Flat_copy<TriangleMesh> build(const FaceRange& range)
  {
    read_faces(range);
    const Face_numbers number = number_faces();
    check_faces(number);
    glue_faces(number);
    number_vertices();
    scale();
    return std::move(copy_);
  }

private:
  // Face indices times four must fit into an index; half of the room is left to the remeshed mesh.
  static constexpr std::size_t MAXIMUM_FACES = std::size_t((std::numeric_limits<Index>::max)()) / 8;
  static constexpr int MAXIMUM_VALENCE = (std::numeric_limits<std::uint16_t>::max)() / 4;

  template <class FaceRange>
  void read_faces(const FaceRange& range)
  {
    for (const auto f : range) {
      if (!Membership::is_face(tmesh_, f))
        refuse(caller_, "face number " + std::to_string(copy_.faces.size()) + " of the range is none of the mesh's, or was removed");
      copy_.faces.push_back(f);
    }
    if (copy_.faces.size() > MAXIMUM_FACES)
      refuse(caller_, "the range has more than " + std::to_string(MAXIMUM_FACES) + " faces");
  }

  // A face that the range lists twice is taken once.
  Face_numbers number_faces()
  {
    Face_numbers number(copy_.faces.size());
    std::size_t n = 0;
    for (std::size_t i = 0; i < copy_.faces.size(); ++i)
      if (number.insert(copy_.faces[i], Index(n)).second) copy_.faces[n++] = copy_.faces[i];
      else repeated_.push_back(i);
    copy_.faces.resize(n);
    return number;
  }

  // "face number i of the range", as the user counts.
  std::string name_of_face(std::size_t i) const
  {
    for (const std::size_t repeated : repeated_) i += repeated <= i;
    return "face number " + std::to_string(i) + " of the range";
  }

  // Where a descriptor does not tell its mesh, and the range is a good part of it, the mesh is gone through.
  void check_faces(const Face_numbers& number) const
  {
    constexpr std::size_t GOOD_PART = 8;
    if (!Membership::IS_TOLD && std::size_t(num_faces(tmesh_)) <= GOOD_PART * copy_.faces.size()) {
      std::size_t found = 0;
      for (const auto f : faces(tmesh_)) found += number.find(f) >= 0;
      if (found != copy_.faces.size())
        refuse(caller_, std::to_string(copy_.faces.size() - found) + " faces of the range are none of the mesh's");
    }
    for (std::size_t i = 0; i < copy_.faces.size(); ++i) {
      const halfedge_descriptor h = halfedge(copy_.faces[i], tmesh_);
      if (next(next(next(h, tmesh_), tmesh_), tmesh_) != h)
        refuse(caller_, name_of_face(i) + " is not a triangle; see CGAL::Polygon_mesh_processing::triangulate_faces()");
    }
  }

  void glue_faces(const Face_numbers& number)
  {
    const std::size_t n = copy_.faces.size();
    copy_.halfedges.resize(3 * n);
    copy_.mesh.reserve_faces(n + n / 8);
    copy_.mesh.resize_faces(n);
    for (std::size_t f = 0; f < n; ++f) {
      halfedge_descriptor h = halfedge(copy_.faces[f], tmesh_);
      for (int k = 0; k < 3; ++k, h = next(h, tmesh_)) copy_.halfedges[3 * f + k] = h;
      copy_.mesh.face_record(Index(f)).source = Index(f);
    }
    for (std::size_t f = 0; f < n; ++f)
      for (int k = 0; k < 3; ++k) glue_corner(Index(4 * f + k), number);
  }

  void glue_corner(Index h, const Face_numbers& number)
  {
    if (copy_.mesh.opposite(h) != -1) return;
    const halfedge_descriptor o = opposite(copy_.halfedge(h), tmesh_);
    const auto f = face(o, tmesh_);
    const Index g = f == Traits::null_face() ? -1 : number.find(f);
    if (g == h >> 2) refuse(caller_, "two edges of " + name_of_face(std::size_t(g)) + " are one");
    if (g < 0) { copy_.mesh.glue(h, ~h); return; }
    for (int k = 0; k < 3; ++k)
      if (copy_.halfedges[3 * g + k] == o) copy_.mesh.glue(h, 4 * g + k);
  }

  // A flat vertex for each fan: a vertex at which several fans meet becomes several, all of them pinched.
  void number_vertices()
  {
    Remeshing_mesh& mesh = copy_.mesh;
    mesh.reserve_vertices(copy_.faces.size() / 2 + copy_.faces.size() / 16 + 8);
    for (Index h = 0; h < Index(4 * copy_.faces.size()); ++h) {
      if (mesh.corner(h) == 3 || mesh.origin(h) >= 0) continue;
      const Index v = Index(copy_.vertices.size());
      const vertex_descriptor user_vertex = source(copy_.halfedge(h), tmesh_);
      copy_.vertices.push_back(user_vertex);
      mesh.resize_vertices(copy_.vertices.size());
      mesh.set_input(v, v);
      number_fan(h, v);
      mesh.position(v) = read_point(user_vertex, h);
    }
    mark_pinched();
  }

  // A vertex knows one of its half-edges, which lies in one of its fans; and the border runs from one fan on into the
  // next. Only a fan that lacks the one, or does not continue the other, can have company.
  void mark_pinched()
  {
    if (doubtful_fans_.empty()) return;
    Remeshing_mesh& mesh = copy_.mesh;
    Descriptor_index<vertex_descriptor> fan_of(doubtful_fans_.size());
    const auto mark_both = [&](Index v, Index w) {
      mesh.add_marks(v, Remeshing_mesh::PINCHED);
      mesh.add_marks(w, Remeshing_mesh::PINCHED);
    };
    std::vector<char> is_doubtful(copy_.vertices.size(), 0);
    for (const Index v : doubtful_fans_) {
      is_doubtful[v] = 1;
      const auto [known, is_new] = fan_of.insert(copy_.vertices[v], v);
      if (!is_new) mark_both(v, known);
      // There is one more fan, which the range lacks, unless faces outside lie between.
      if (!(mesh.marks(v) & Remeshing_mesh::NEXT_TO_OUTSIDE)) mesh.add_marks(v, Remeshing_mesh::PINCHED);
    }
    for (Index v = 0; v < Index(copy_.vertices.size()); ++v) {
      if (is_doubtful[v]) continue;
      const Index other = fan_of.find(copy_.vertices[v]);
      if (other >= 0) mark_both(v, other);
    }
  }

  void number_fan(Index h, Index v)
  {
    Remeshing_mesh& mesh = copy_.mesh;
    const Index first = mesh.fan_start(h);
    const halfedge_descriptor known = halfedge(copy_.vertices[v], tmesh_);
    int faces = 0;
    bool has_known = opposite(copy_.halfedge(first), tmesh_) == known;
    mesh.for_each_in_fan(first, [&](Index k) {
      ++faces;
      mesh.set_origin(k, v);
      has_known |= copy_.halfedge(mesh.prev(k)) == known;
    });
    const bool is_border = mesh.is_border(first);
    if (faces > MAXIMUM_VALENCE)
      refuse(caller_, "a corner of " + name_of_face(std::size_t(h >> 2)) + " has " + std::to_string(faces) +
                      " faces around it; at most " + std::to_string(MAXIMUM_VALENCE) + " are supported");
    mesh.set_first(v, first);
    mesh.set_valence(v, faces + (is_border ? 1 : 0));
    if (is_border) mark_border(v, first);
    if (!has_known || (is_border && !continues_its_border(v))) doubtful_fans_.push_back(v);
  }

  void mark_border(Index v, Index first)
  {
    copy_.mesh.add_marks(v, Remeshing_mesh::ON_BORDER);
    if (copy_.has_outside_face(first, tmesh_) || copy_.has_outside_face(copy_.mesh.last_edge(v), tmesh_))
      copy_.mesh.add_marks(v, Remeshing_mesh::NEXT_TO_OUTSIDE);
  }

  // Whether the user's half-edge that comes in before the fan of v is followed by the one that goes out after it. If not,
  // there is another fan in between, or faces outside.
  bool continues_its_border(Index v) const
  {
    return next(opposite(copy_.halfedge(copy_.mesh.first(v)), tmesh_), tmesh_) ==
           opposite(copy_.halfedge(copy_.mesh.last_edge(v)), tmesh_);
  }

  // Of the user's vertex that is the origin of h.
  Vector3 read_point(vertex_descriptor v, Index h) const
  {
    const Vector3 q = internal::to_vector3(get(vpm_, v));
    if (!is_finite(q))
      refuse(caller_, "a corner of " + name_of_face(std::size_t(h >> 2)) + " has a coordinate that is not finite");
    return q;
  }

  // Multiplies by the power of two that brings the largest extent into [1/2, 1).
  void scale()
  {
    Remeshing_mesh& mesh = copy_.mesh;
    double extent = 0;
    if (mesh.number_of_vertex_slots() == 0) return;
    const Vector3 origin = mesh.position(0);
    for (Index v = 0; v < Index(mesh.number_of_vertex_slots()); ++v) extent = larger_extent(extent, mesh.position(v) - origin);
    if (!(extent > 0)) refuse(caller_, "all points of the range are equal");
    if (!std::isfinite(extent)) refuse(caller_, "the extent of the range is too large for double precision");
    const double unit = power_of_two_unit(extent);
    for (Index v = 0; v < Index(mesh.number_of_vertex_slots()); ++v) mesh.position(v) = (1 / unit) * mesh.position(v);
    mesh.set_unit(unit);
  }

  const TriangleMesh& tmesh_;
  VertexPointMap vpm_;
  const char* caller_;
  Flat_copy<TriangleMesh> copy_;
  std::vector<std::size_t> repeated_;  // places in the range of faces that it has listed before
  std::vector<Index> doubtful_fans_;   // of which the user's vertex may have another one
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_EXCHANGE_FLAT_COPY_H
