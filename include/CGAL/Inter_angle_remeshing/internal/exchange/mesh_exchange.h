// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_EXCHANGE_MESH_EXCHANGE_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_EXCHANGE_MESH_EXCHANGE_H

#include <CGAL/Inter_angle_remeshing/internal/exchange/Outside_faces.h>
#include <CGAL/Inter_angle_remeshing/internal/exchange/flat_copy.h>
#include <CGAL/Inter_angle_remeshing/internal/exchange/read_surroundings.h>
#include <CGAL/Inter_angle_remeshing/internal/exchange/read_wider_mesh.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/Remeshing_mesh_graph.h>

#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// What OpenMesh asks for beyond CGAL's concepts; for other meshes there is nothing to do.
//
// A vertex on the border must know the half-edge of the border that leaves it: OpenMesh::is_boundary() and its circulators
// rely on that. CGAL has a function for it.
template <class Graph, class Vertex>
auto adjust_border(Vertex v, Graph& g, int) -> decltype(adjust_border_halfedge(v, g), void()) { adjust_border_halfedge(v, g); }
template <class Graph, class Vertex>
void adjust_border(Vertex, Graph&, long) {}

// Removed elements are flagged, and the first removal allocates the flags: that must not happen when it is too late to fail.
// A request that fails counts as made, and has to be taken back.
template <class Request, class Release>
void request_or_release(const Request& request, const Release& release)
{
  try { request(); } catch (...) { release(); throw; }
}
template <class Graph>
auto allocate_removal_flags(Graph& g, int)
  -> decltype(g.request_vertex_status(), g.request_halfedge_status(), g.request_edge_status(), g.request_face_status(), void())
{
  if (!g.has_vertex_status()) request_or_release([&] { g.request_vertex_status(); }, [&] { g.release_vertex_status(); });
  if (!g.has_halfedge_status()) request_or_release([&] { g.request_halfedge_status(); }, [&] { g.release_halfedge_status(); });
  if (!g.has_edge_status()) request_or_release([&] { g.request_edge_status(); }, [&] { g.release_edge_status(); });
  if (!g.has_face_status()) request_or_release([&] { g.request_face_status(); }, [&] { g.release_face_status(); });
}
template <class Graph>
void allocate_removal_flags(Graph&, long) {}

// The user's range -> flat mesh, flat mesh -> the user's mesh: the only code that changes the user's mesh, but for the point of a
// vertex that Carrier_vertex borrows.
//
// What the user holds on to stays: a vertex that survives keeps its descriptor, and its point to the last bit if it
// was not moved; protected edges keep theirs; faces and other edges are used again before new ones are made. Faces
// outside of the range are not touched, but that those beside the range are divided where an edge that they share with it was split.
template <class TriangleMesh, class VertexPointMap>
class Mesh_exchange
{
  using Traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Traits::vertex_descriptor;
  using halfedge_descriptor = typename Traits::halfedge_descriptor;
  using edge_descriptor = typename Traits::edge_descriptor;
  using face_descriptor = typename Traits::face_descriptor;
  using Point_3 = typename boost::property_traits<VertexPointMap>::value_type;
  using Index = Remeshing_mesh::Index;

public:
  template <class FaceRange>
  Mesh_exchange(const FaceRange& range, TriangleMesh& tmesh, VertexPointMap vpm, const char* caller)
    : tmesh_(tmesh), vpm_(vpm), caller_(caller),
      copy_(Flat_copy_builder<TriangleMesh, VertexPointMap>(tmesh, vpm, caller).build(range))
  {}

  // The user's vertices, by their number in the input.
  const std::vector<vertex_descriptor>& input_vertices() const { return copy_.vertices; }

  // Calls `function(h, user's half-edge)` for one half-edge of each edge, before take_mesh().
  template <class Function>
  void for_each_edge(const Function& function) const
  {
    copy_.mesh.for_each_edge([&](Index h) { function(h, copy_.halfedge(h)); });
  }
  Remeshing_mesh& mesh() { return copy_.mesh; }

  // The user's faces, by their number in the input: Corner_table::Face::source.
  const std::vector<face_descriptor>& input_faces() const { return copy_.faces; }

  // The range with faces around it, before take_mesh().
  Wider_mesh wider_mesh() const { return read_wider_mesh(copy_, tmesh_, vpm_, caller_); }

  const Surroundings& surroundings() const { return surroundings_; }

  // Hands the flat mesh over, all marks and flags set, to be remeshed; where `may_split_rim`, edges on the rim may be split.
  Remeshing_mesh take_mesh(bool may_split_rim)
  {
    surroundings_ = read_surroundings(copy_, tmesh_, vpm_);
    note_pinched_fans();
    bind_what_is_shared(may_split_rim);
    sort_edges();
    return std::move(copy_.mesh);
  }

  // Replaces the range by the mesh. Everything that may fail, for want of memory or in the user's maps, comes first; if it does,
  // what was done is taken back, and the exception goes on. `mesh` must have no free slots. `before_removal(edge)` is called for edges
  // that the result has no use for, `on_failure()` where they stay after all. Where vertices have moved and no more, every element
  // keeps its descriptor.
  template <class BeforeRemoval, class OnFailure>
  void write(const Remeshing_mesh& mesh, const BeforeRemoval& before_removal, const OnFailure& on_failure)
  {
    plan(mesh);
    const bool keeps_faces = finds_faces_again(mesh);
    try {
      if (!keeps_faces) make_room(mesh);
      set_points(mesh);
      for (std::size_t i = edges_needed_; i < spare_edges_.size(); ++i) before_removal(edge(spare_edges_[i], tmesh_));
    } catch (...) {
      on_failure();
      take_back();
      throw;
    }
    if (keeps_faces) return;
    connect(mesh);
    remove_the_rest();
  }

  // The faces outside that the run has put vertices on: set after plan_outside_faces(mesh), `mesh` being the result.
  void plan_outside_faces(const Remeshing_mesh& mesh)
  {
    outside_faces_.plan(tmesh_, vpm_, mesh, [&](Index source, Index target) { return kept_halfedge(source, target); });
  }
  const Outside_faces<TriangleMesh>& outside_faces() const { return outside_faces_; }

  // After write(): the user's vertex of v, the user's half-edge of h, and the user's face of f.
  vertex_descriptor written_vertex(Index v) const { return vertex_of_[v]; }
  halfedge_descriptor written_halfedge(Index h) const { return halfedge_of_[3 * (h >> 2) + (h & 3)]; }
  face_descriptor written_face(Index f) const { return copy_.faces[f]; }

private:
  // A protected edge: found again by its ends, as numbers of input vertices.
  struct Kept_edge
  {
    Index source, target;
    halfedge_descriptor halfedge;
    bool operator<(const Kept_edge& e) const
    {
      return source != e.source ? source < e.source : target < e.target;
    }
  };

  // A fan of faces at a vertex of the user's that has several. The border of the mesh comes in before one of them and goes out after
  // another one.
  struct Pinched_fan
  {
    Index vertex;                               // its number in the input
    bool has_known;                             // whether the vertex is known by a half-edge of this fan
    halfedge_descriptor in, out;                // sides of the border; null where faces outside are in their place, or nothing
    halfedge_descriptor out_beyond, in_beyond;  // what follows `in`, and what `out` follows, where these are of no fan of the range
    Index fan_beyond;                           // by number in pinched_fans_: the one whose `out` follows `in`; -1: none
  };

  void note_pinched_fans()
  {
    const Remeshing_mesh& mesh = copy_.mesh;
    for (Index v = 0; v < Index(copy_.vertices.size()); ++v)
      if (mesh.is_pinched(v)) pinched_fans_.push_back(pinched_fan(v));
    Descriptor_index<halfedge_descriptor> fan_before(pinched_fans_.size()), fan_after(pinched_fans_.size());
    for (Index i = 0; i < Index(pinched_fans_.size()); ++i) {
      const Pinched_fan& fan = pinched_fans_[i];
      if (fan.in != Traits::null_halfedge()) fan_after.insert(fan.in, i);
      if (fan.out != Traits::null_halfedge()) fan_before.insert(fan.out, i);
    }
    for (Pinched_fan& fan : pinched_fans_) {
      if (fan.in != Traits::null_halfedge()) fan.fan_beyond = fan_before.find(fan.out_beyond);
      if (fan.out != Traits::null_halfedge() && fan_after.find(fan.in_beyond) >= 0) fan.in_beyond = Traits::null_halfedge();
    }
    new_out_.assign(pinched_fans_.size(), Traits::null_halfedge());
  }

  Pinched_fan pinched_fan(Index v) const
  {
    const Remeshing_mesh& mesh = copy_.mesh;
    const halfedge_descriptor none = Traits::null_halfedge(), known = halfedge(copy_.vertices[v], tmesh_);
    Pinched_fan fan{v, false, none, none, none, none, -1};
    mesh.for_each_around(v, [&](Index h) {
      fan.has_known |= opposite(copy_.halfedge(h), tmesh_) == known || copy_.halfedge(mesh.prev(h)) == known;
    });
    if (!mesh.is_border_vertex(v)) return fan;
    const auto border_side = [&](Index h) {
      const halfedge_descriptor side = opposite(copy_.halfedge(h), tmesh_);
      return face(side, tmesh_) == Traits::null_face() ? side : none;
    };
    fan.in = border_side(mesh.first(v));
    fan.out = border_side(mesh.last_edge(v));
    if (fan.in != none) fan.out_beyond = next(fan.in, tmesh_);
    if (fan.out != none) fan.in_beyond = prev(fan.out, tmesh_);
    return fan;
  }

  // Locks the ends of edges towards faces outside, and protects these, unless they may be split, and those of the border that end there; a
  // pinched vertex is locked, so that all fans of the user's keep to one point.
  void bind_what_is_shared(bool may_split_rim)
  {
    Remeshing_mesh& mesh = copy_.mesh;
    for (const Pinched_fan& fan : pinched_fans_) mesh.add_marks(fan.vertex, Remeshing_mesh::LOCKED);
    if (!has_marks(Remeshing_mesh::NEXT_TO_OUTSIDE | Remeshing_mesh::ON_BORDER | Remeshing_mesh::ON_FEATURE)) return;
    for_each_edge([&](Index h, halfedge_descriptor user) {
      if (!mesh.is_border(h)) return;
      const unsigned ends = mesh.marks(mesh.origin(h)) | mesh.marks(mesh.target(h));
      const bool is_outer = face(opposite(user, tmesh_), tmesh_) != Traits::null_face();
      if (is_outer && may_split_rim && !mesh.is_protected(h) && (ends & Remeshing_mesh::PINCHED) == 0 && may_divide_face_across(h, user))
        mesh.add_flags(h, Remeshing_mesh::ON_RIM);
      else if (is_outer || (ends & Remeshing_mesh::NEXT_TO_OUTSIDE)) mesh.add_flags(h, Remeshing_mesh::PROTECTED);
    });
    for_each_edge([&](Index h, halfedge_descriptor) {
      if (!mesh.is_between_fixed_ends(h)) return;
      mesh.add_marks(mesh.origin(h), Remeshing_mesh::LOCKED);
      mesh.add_marks(mesh.target(h), Remeshing_mesh::LOCKED);
    });
  }

  // Whether the face outside is a triangle, and another one than that inside: a vertex would be joined to its apex twice.
  bool may_divide_face_across(Index h, halfedge_descriptor user) const
  {
    const halfedge_descriptor side = opposite(user, tmesh_), following = next(side, tmesh_);
    return next(next(following, tmesh_), tmesh_) == side && target(following, tmesh_) != copy_.vertices[copy_.mesh.apex(h)];
  }

  bool has_marks(unsigned marks) const
  {
    unsigned all = 0;
    for (Index v = 0; v < Index(copy_.vertices.size()); ++v) all |= copy_.mesh.marks(v);
    return (all & marks) != 0;
  }

  // Which edges keep their descriptor, and which may be used for any edge.
  void sort_edges()
  {
    const Remeshing_mesh& mesh = copy_.mesh;
    spare_edges_.reserve(copy_.faces.size() + copy_.faces.size() / 2);
    for_each_edge([&](Index h, halfedge_descriptor user) {
      if (!mesh.is_between_fixed_ends(h)) { spare_edges_.push_back(user); return; }
      kept_edges_.push_back({mesh.origin(h), mesh.target(h), user});
      kept_edges_.push_back({mesh.target(h), mesh.origin(h), opposite(user, tmesh_)});
    });
    std::sort(kept_edges_.begin(), kept_edges_.end());
    const auto twin = std::adjacent_find(kept_edges_.begin(), kept_edges_.end(), [](const auto& a, const auto& b) {
      return !(a < b);
    });
    if (twin != kept_edges_.end())
      refuse(caller_, "two constrained or shared edges of the range join the same two vertices, numbers " +
                      std::to_string(twin->source) + " and " + std::to_string(twin->target));
    std::vector<halfedge_descriptor>().swap(copy_.halfedges);
  }

  // Allocates what write() needs beside the user's mesh.
  void plan(const Remeshing_mesh& mesh)
  {
    halfedge_of_.assign(3 * mesh.number_of_live_faces(), Traits::null_halfedge());
    vertex_of_.assign(mesh.number_of_live_vertices(), Traits::null_vertex());
    is_kept_.assign(copy_.vertices.size(), 0);
    new_vertices_.clear();
    for (Index v = 0; v < Index(vertex_of_.size()); ++v) {
      const Index i = mesh.input(v);
      if (i < 0) { new_vertices_.push_back(v); continue; }
      vertex_of_[v] = copy_.vertices[i];
      is_kept_[i] = 1;
    }
    edges_needed_ = 0;
    mesh.for_each_edge([&](Index h) { edges_needed_ += !is_kept(mesh, h); });
    vertices_made_ = 0;
    old_points_.clear();
    old_points_.reserve(copy_.vertices.size());
    faces_before_ = copy_.faces.size();
    edges_before_ = spare_edges_.size();
    copy_.faces.reserve(mesh.number_of_live_faces());
    spare_edges_.reserve(edges_needed_);
  }

  // Whether the faces of the mesh are those of the input, with the same vertices; if so, the user's elements are noted as those of the
  // result.
  bool finds_faces_again(const Remeshing_mesh& mesh)
  {
    const std::size_t n = copy_.faces.size();
    if (mesh.number_of_live_faces() != n || !new_vertices_.empty() || vertex_of_.size() != copy_.vertices.size()) return false;
    std::vector<face_descriptor> faces(n, Traits::null_face());
    std::vector<char> is_found(n, 0);
    for (Index f = 0; f < Index(n); ++f) {
      const auto& record = mesh.face_record(f);
      if (is_found[record.source]) return false;
      is_found[record.source] = 1;
      faces[f] = copy_.faces[record.source];
      halfedge_descriptor h = halfedge(faces[f], tmesh_);
      for (int turns = 0; turns < 2 && source(h, tmesh_) != vertex_of_[record.vertex[0]]; ++turns) h = next(h, tmesh_);
      for (int k = 0; k < 3; ++k, h = next(h, tmesh_)) {
        if (source(h, tmesh_) != vertex_of_[record.vertex[k]]) return false;
        halfedge_of(4 * f + k) = h;
      }
    }
    copy_.faces.swap(faces);
    return true;
  }

  void make_room(const Remeshing_mesh& mesh)
  {
    const std::size_t outside = outside_faces_.number_of_new_faces(),
                      new_faces = mesh.number_of_live_faces() - (std::min)(mesh.number_of_live_faces(), copy_.faces.size()) + outside,
                      new_edges = edges_needed_ - (std::min)(edges_needed_, spare_edges_.size()) + outside;
    allocate_removal_flags(tmesh_, 0);    // before anything is made that take_back() would have to remove
    using Vertices_size = typename Traits::vertices_size_type;
    using Edges_size = typename Traits::edges_size_type;
    using Faces_size = typename Traits::faces_size_type;
    reserve(tmesh_, Vertices_size(room_for(num_vertices(tmesh_), new_vertices_.size())),
            Edges_size(room_for(num_edges(tmesh_), new_edges)), Faces_size(room_for(num_faces(tmesh_), new_faces)));
    for (; vertices_made_ < new_vertices_.size(); ++vertices_made_)
      vertex_of_[new_vertices_[vertices_made_]] = add_vertex(tmesh_);
    while (copy_.faces.size() < mesh.number_of_live_faces()) copy_.faces.push_back(add_face(tmesh_));
    while (spare_edges_.size() < edges_needed_) spare_edges_.push_back(halfedge(add_edge(tmesh_), tmesh_));
    outside_faces_.make_elements(tmesh_);
  }

  // How many elements to reserve. A mesh whose elements lie in arrays moves all of them when these grow: were just what
  // is needed reserved, every small range of a large mesh would cost as much as a copy of that. Rounded up to an eighth of
  // a power of two the number grows by a sixteenth at least, and ranges one after the other seldom find no room.
  static std::size_t room_for(std::size_t present, std::size_t added)
  {
    if (added == 0) return present;
    const std::size_t needed = present + added;
    std::size_t step = 1;
    while (step <= needed / 16) step *= 2;
    return (needed + step - 1) / step * step;
  }

  // Undoes set_points(), as far as the user's map lets it, and make_room().
  void take_back()
  {
    for (const auto& [v, point] : old_points_)
      try { put(vpm_, v, point); } catch (...) {}    // of two exceptions, the one that is under way counts
    while (vertices_made_ > 0) remove_vertex(vertex_of_[new_vertices_[--vertices_made_]], tmesh_);
    for (; copy_.faces.size() > faces_before_; copy_.faces.pop_back()) remove_face(copy_.faces.back(), tmesh_);
    for (; spare_edges_.size() > edges_before_; spare_edges_.pop_back())
      remove_edge(edge(spare_edges_.back(), tmesh_), tmesh_);
    outside_faces_.take_back(tmesh_);
  }

  halfedge_descriptor& halfedge_of(Index h) { return halfedge_of_[3 * (h >> 2) + (h & 3)]; }

  // Whether the edge of h, a half-edge of a face, keeps a descriptor: a protected one, or the first part of an edge on the rim.
  static bool is_kept(const Remeshing_mesh& mesh, Index h)
  {
    return mesh.is_on_rim(h) ? mesh.input(mesh.origin(h)) >= 0 : mesh.is_protected(h);
  }

  halfedge_descriptor kept_halfedge(const Remeshing_mesh& mesh, Index h) const
  {
    Index end = mesh.target(h);
    while (mesh.input(end) < 0) end = mesh.target(mesh.first(end));
    return kept_halfedge(mesh.input(mesh.origin(h)), mesh.input(end));
  }

  halfedge_descriptor kept_halfedge(Index source, Index target) const
  {
    return std::lower_bound(kept_edges_.begin(), kept_edges_.end(), Kept_edge{source, target, halfedge_descriptor()})->halfedge;
  }

  void connect(const Remeshing_mesh& mesh)
  {
    edges_used_ = 0;
    mesh.for_each_edge([&](Index h) {
      halfedge_of(h) = is_kept(mesh, h) ? kept_halfedge(mesh, h) : spare_edges_[edges_used_++];
      if (!mesh.is_border(h)) halfedge_of(mesh.opposite(h)) = opposite(halfedge_of(h), tmesh_);
    });
    mesh.for_each_halfedge([&](Index h) {
      const halfedge_descriptor user = halfedge_of(h);
      set_target(user, vertex_of_[mesh.target(h)], tmesh_);
      set_next(user, halfedge_of(mesh.next(h)), tmesh_);
      set_face(user, copy_.faces[h >> 2], tmesh_);
      if (mesh.corner(h) == 0) set_halfedge(copy_.faces[h >> 2], user, tmesh_);
    });
    outside_faces_.connect(tmesh_, mesh, [&](Index v) { return vertex_of_[v]; }, [&](Index h) { return halfedge_of(h); });
    mesh.for_each_halfedge([&](Index h) { if (mesh.is_border(h)) connect_border(mesh, h); });
    for (Index v = 0; v < Index(vertex_of_.size()); ++v) connect_vertex(mesh, v);
    connect_pinched_fans(mesh);
  }

  // The border side of h. Where a protected edge of the border ends next to faces outside, the chain of the border runs on as it did.
  void connect_border(const Remeshing_mesh& mesh, Index h)
  {
    const halfedge_descriptor side = opposite(halfedge_of(h), tmesh_);
    if (mesh.is_on_rim(h) || (mesh.is_protected(h) && face(side, tmesh_) != Traits::null_face())) return;
    set_face(side, Traits::null_face(), tmesh_);
    set_target(side, vertex_of_[mesh.origin(h)], tmesh_);
    if (mesh.marks(mesh.origin(h)) & (Remeshing_mesh::NEXT_TO_OUTSIDE | Remeshing_mesh::PINCHED)) return;
    const Mesh_halfedge following = next(Mesh_halfedge(~h), mesh);
    set_next(side, opposite(halfedge_of(~following.index()), tmesh_), tmesh_);
  }

  // The border runs from fan to fan as it did.
  void connect_pinched_fans(const Remeshing_mesh& mesh)
  {
    if (pinched_fans_.empty()) return;
    const auto for_each_fan = [&](const auto& function) {
      for (Index v = 0; v < Index(vertex_of_.size()); ++v) {
        if (!mesh.is_pinched(v)) continue;
        const auto fan = std::lower_bound(pinched_fans_.begin(), pinched_fans_.end(), mesh.input(v),
                                          [](const Pinched_fan& f, Index vertex) { return f.vertex < vertex; });
        function(*fan, v, std::size_t(fan - pinched_fans_.begin()));
      }
    };
    const halfedge_descriptor none = Traits::null_halfedge();
    for_each_fan([&](const Pinched_fan& fan, Index v, std::size_t i) {
      if (fan.has_known) set_halfedge(vertex_of_[v], opposite(halfedge_of(mesh.first(v)), tmesh_), tmesh_);
      if (fan.out == none) return;
      new_out_[i] = opposite(halfedge_of(mesh.last_edge(v)), tmesh_);
      if (fan.in_beyond != none) set_next(fan.in_beyond, new_out_[i], tmesh_);
    });
    for_each_fan([&](const Pinched_fan& fan, Index v, std::size_t) {
      if (fan.in == none) return;
      const halfedge_descriptor in = opposite(halfedge_of(mesh.first(v)), tmesh_);
      set_next(in, fan.fan_beyond >= 0 ? new_out_[fan.fan_beyond] : fan.out_beyond, tmesh_);
      set_halfedge(vertex_of_[v], in, tmesh_);
    });
    for_each_fan([&](const Pinched_fan&, Index v, std::size_t) { adjust_border(vertex_of_[v], tmesh_, 0); });
  }

  void connect_vertex(const Remeshing_mesh& mesh, Index v)
  {
    const unsigned marks = mesh.marks(v);
    if (marks & Remeshing_mesh::PINCHED) return;
    // One that lies on the border of the mesh, outside of the range, is known by a half-edge of that border.
    if ((marks & Remeshing_mesh::NEXT_TO_OUTSIDE) && mesh.input(v) >= 0) {
      const halfedge_descriptor known = halfedge(vertex_of_[v], tmesh_);
      if (target(known, tmesh_) == vertex_of_[v] && CGAL::is_border(known, tmesh_)) return;
    }
    set_halfedge(vertex_of_[v], opposite(halfedge_of(mesh.first(v)), tmesh_), tmesh_);
    if (marks & (Remeshing_mesh::ON_BORDER | Remeshing_mesh::NEXT_TO_OUTSIDE)) adjust_border(vertex_of_[v], tmesh_, 0);
  }

  // A vertex that was not moved is not touched: its point may hold more than the flat mesh's coordinates can.
  void set_points(const Remeshing_mesh& mesh)
  {
    for (Index v = 0; v < Index(vertex_of_.size()); ++v) {
      if (mesh.input(v) >= 0) {
        const Point_3 old = get(vpm_, vertex_of_[v]);
        if (mesh.position(v) == (1 / mesh.unit()) * internal::to_vector3(old)) continue;
        old_points_.emplace_back(vertex_of_[v], old);
      }
      const Vector3 p = mesh.unit() * mesh.position(v);
      put(vpm_, vertex_of_[v], Point_3(p.x, p.y, p.z));
    }
  }

  // Edges first: those of a cell complex count how often their vertices and faces are referred to.
  void remove_the_rest()
  {
    for (std::size_t i = edges_used_; i < spare_edges_.size(); ++i)
      remove_edge(edge(spare_edges_[i], tmesh_), tmesh_);
    for (std::size_t i = 0; i < is_kept_.size(); ++i)
      if (!is_kept_[i]) remove_vertex(copy_.vertices[i], tmesh_);
    const std::size_t faces_used = halfedge_of_.size() / 3;
    for (std::size_t i = faces_used; i < copy_.faces.size(); ++i) remove_face(copy_.faces[i], tmesh_);
  }

  TriangleMesh& tmesh_;
  VertexPointMap vpm_;
  const char* caller_;
  Flat_copy<TriangleMesh> copy_;
  Surroundings surroundings_;
  Outside_faces<TriangleMesh> outside_faces_;
  std::vector<Kept_edge> kept_edges_;
  std::vector<Pinched_fan> pinched_fans_;           // by number of the input vertex
  std::vector<halfedge_descriptor> spare_edges_;

  std::vector<halfedge_descriptor> halfedge_of_;    // by flat corner: 3 f + k
  std::vector<vertex_descriptor> vertex_of_;        // by flat vertex
  std::vector<Index> new_vertices_;
  std::vector<halfedge_descriptor> new_out_;        // by pinched fan
  std::vector<std::pair<vertex_descriptor, Point_3>> old_points_;   // of the vertices that have got a new one
  std::vector<char> is_kept_;                       // by input vertex
  std::size_t vertices_made_ = 0, edges_needed_ = 0, edges_used_ = 0, faces_before_ = 0, edges_before_ = 0;
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_EXCHANGE_MESH_EXCHANGE_H
