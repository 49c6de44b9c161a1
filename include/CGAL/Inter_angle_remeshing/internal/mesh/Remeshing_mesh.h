// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_REMESHING_MESH_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_REMESHING_MESH_H

#include <CGAL/Inter_angle_remeshing/internal/geometry/Vector3.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/Corner_table.h>

#include <CGAL/exceptions.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// The mesh that is remeshed: a corner table, the state of its elements, and every question about it.
// Coordinates are the user's multiplied by a power of two (exact both ways) such that the extent lies in [1/2, 1).
// It models CGAL's FaceGraph through the functions of Remeshing_mesh_graph.h.
class Remeshing_mesh
  : public Corner_table
{
public:
  // What binds a vertex. A vertex with none of these marks is free: it moves and may be removed.
  enum Vertex_mark : std::uint8_t
  {
    ON_BORDER = 1,          // a half-edge of its fan is on the border of the remeshed range
    ON_FEATURE = 2,         // it is an end of a constrained edge
    LOCKED = 4,             // neither moved nor removed
    NEXT_TO_OUTSIDE = 8,    // on the border between the range and faces outside of it
    PINCHED = 16,           // one of several fans of the user's vertex, with a place of its own for each fan
    PINNED = 32,            // on a curve, along which it does not slide
    HELD = 64               // locked while the mesh is coarse
  };

  // Flags of edge k of a face: bits k, k + 3, k + 6 and so on.
  static constexpr std::uint32_t CONSTRAINED = 1;  // never flipped, its chain is kept
  static constexpr std::uint32_t PROTECTED = 8;    // neither flipped, split nor collapsed: keeps its descriptor
  static constexpr std::uint32_t ON_CURVE = 64;    // has a place on a curve of the input, see curve_place()
  static constexpr std::uint32_t FOUND = 512;      // constrained because it was found to be a feature: the user did not mark it
  static constexpr std::uint32_t PASSING = 4096;   // constrained in the iterations alone
  static constexpr std::uint32_t SEAM = 32768;     // constrained because patches meet there, and for nothing else
  static constexpr std::uint32_t JAGGED = 262144;  // of a chain of seams or of the border whose zigzag tells nothing
  static constexpr std::uint32_t ON_RIM = 2097152; // shared with a face outside; in a run, with one that is divided where the edge is

  static constexpr Index NO_VERTEX = -1;

  // A block of the space-filling order holds 2^k vertices; 1024 records of a sweep fill half of a 64 KiB cache.
  static unsigned block_shift(std::size_t number_of_vertices) { return number_of_vertices < 50000 ? 8 : 10; }

  // --- construction -------------------------------------------------------------------------------------------

  void resize_vertices(std::size_t n)
  {
    position_.resize(n); first_.resize(n, -1); state_.resize(n);
    hint_.resize(n, 0); input_.resize(n, NO_VERTEX); block_.resize(n, 0);
  }

  void reserve_vertices(std::size_t n)
  {
    position_.reserve(n); first_.reserve(n); state_.reserve(n);
    hint_.reserve(n); input_.reserve(n); block_.reserve(n);
  }

  // The user's length that is 1 here.
  double unit() const { return unit_; }
  void set_unit(double unit) { unit_ = unit; }

  // --- vertices -----------------------------------------------------------------------------------------------

  std::size_t number_of_vertex_slots() const { return position_.size(); }
  std::size_t number_of_live_vertices() const { return position_.size() - free_vertices_.size(); }
  std::size_t number_of_live_faces() const { return number_of_face_slots() - free_faces_.size(); }
  bool is_vertex(Index v) const { return first_[v] >= 0; }
  // Calls `function(v)` for vertices evenly spread over the slots: as many as the samples, fewer where slots are free.
  template <class Function>
  void for_each_sample_vertex(Index samples, const Function& function) const
  {
    for (Index i = 0; i < samples; ++i) {
      const Index v = Index(std::int64_t(number_of_vertex_slots()) * (2 * i + 1) / (2 * samples));
      if (is_vertex(v)) function(v);
    }
  }

  const Vector3& position(Index v) const { return position_[v]; }
  Vector3& position(Index v) { return position_[v]; }
  const std::vector<Vector3>& positions() const { return position_; }
  int number_of_faces_around(Index v) const { return valence(v) - (is_border_vertex(v) ? 1 : 0); }
  // The half-edge that begins the fan of v.
  Index first(Index v) const { return first_[v]; }
  void set_first(Index v, Index h) { first_[v] = h; }
  // The number of edges at v.
  int valence(Index v) const { return state_[v].valence; }
  void set_valence(Index v, int n) { state_[v].valence = static_cast<std::uint16_t>(n); }
  // The face of the projector's surface onto which v was projected last.
  Index hint(Index v) const { return hint_[v]; }
  Index& hint(Index v) { return hint_[v]; }
  // The user's vertex that v is, as its number in the input; NO_VERTEX for a new one.
  Index input(Index v) const { return input_[v]; }
  void set_input(Index v, Index i) { input_[v] = i; }
  // The block of the space-filling order that v belongs to.
  Index block(Index v) const { return block_[v]; }

  unsigned marks(Index v) const { return state_[v].marks; }
  void add_marks(Index v, unsigned marks)
  {
    state_[v].marks = static_cast<std::uint8_t>(state_[v].marks | marks);
    if (is_border_vertex(v)) state_[v].regular_valence = 4;
  }
  void remove_marks(Index v, unsigned marks) { state_[v].marks = static_cast<std::uint8_t>(state_[v].marks & ~marks); }
  bool is_free(Index v) const { return state_[v].marks == 0; }
  bool is_border_vertex(Index v) const { return (state_[v].marks & ON_BORDER) != 0; }
  bool is_on_curve(Index v) const { return (state_[v].marks & (ON_BORDER | ON_FEATURE)) != 0; }
  bool is_pinched(Index v) const { return (state_[v].marks & PINCHED) != 0; }
  bool is_locked(Index v) const { return (state_[v].marks & (LOCKED | HELD)) != 0; }

  // Whether v is on a curve and may move along it.
  bool is_sliding(Index v) const { return is_on_curve(v) && (state_[v].marks & (LOCKED | PINNED)) == 0; }

  bool is_movable(Index v) const { return is_free(v) || is_sliding(v); }
  bool is_held_inside(Index v) const { return !is_free(v) && !is_on_curve(v); }

  bool touches_curve(Index f) const
  {
    const auto& v = faces_[f].vertex;
    return is_on_curve(v[0]) || is_on_curve(v[1]) || is_on_curve(v[2]);
  }

  // How far the valence is from the regular one: 4 on the border, 6 elsewhere unless another one has been set.
  int deviation(Index v) const { return int(state_[v].valence) - int(state_[v].regular_valence); }
  void set_regular_valence(Index v, int n) { state_[v].regular_valence = static_cast<std::uint8_t>(n); }

  // --- edges --------------------------------------------------------------------------------------------------

  bool is_constrained(Index h) const { return has_flag(h, CONSTRAINED); }
  bool is_marked_by_user(Index h) const { return is_constrained(h) && !has_flag(h, FOUND); }
  bool is_protected(Index h) const { return has_flag(h, PROTECTED); }
  bool is_on_rim(Index h) const { return has_flag(h, ON_RIM); }
  // Whether it leads between two vertices of the input that stay, or is a part of an edge that does.
  bool is_between_fixed_ends(Index h) const { return has_flag(h, PROTECTED | ON_RIM); }
  // What lies outside of the range is known from now on: no edge of the rim is split or collapsed any more.
  void settle_rim()
  {
    for_each_edge([&](Index h) { if (is_on_rim(h)) add_flags(h, PROTECTED); });
  }
  bool has_protected_edge(Index f) const { return (faces_[f].edge_flags & (PROTECTED * 7)) != 0; }
  // Whether the edge belongs to a border or to a feature.
  bool is_on_curve_edge(Index h) const { return is_border(h) || is_constrained(h); }

  bool has_flag(Index h, std::uint32_t flag) const
  {
    return (faces_[h >> 2].edge_flags & (flag << (h & 3))) != 0;
  }
  void add_flags(Index h, std::uint32_t flags)
  {
    faces_[h >> 2].edge_flags |= flags << (h & 3);
    const Index o = opposite(h);
    if (o >= 0) faces_[o >> 2].edge_flags |= flags << (o & 3);
  }
  void remove_flags(Index h, std::uint32_t flags)
  {
    faces_[h >> 2].edge_flags &= ~(flags << (h & 3));
    const Index o = opposite(h);
    if (o >= 0) faces_[o >> 2].edge_flags &= ~(flags << (o & 3));
  }

  // --- places on the input's curves ---------------------------------------------------------------------------

  // Where the edge of h, which may be a border side, lies on a curve: from arc length `origin` to arc length `target`,
  // not modulo the length of a closed curve.
  struct Curve_place
  {
    Index curve;
    double origin, target;
  };

  bool has_curves() const { return !curve_edge_of_.empty(); }
  bool has_place(Index h) const { return has_flag(h < 0 ? ~h : h, ON_CURVE); }
  void set_curve_place(Index h, const Curve_place& place)
  {
    if (!has_curves()) curve_edge_of_.assign(4 * faces_.size(), -1);
    const Index e = new_curve_edge(place.curve, place.origin, place.target);
    add_flags(h, ON_CURVE);
    curve_edge_of_[h] = 2 * e;
    if (!is_border(h)) curve_edge_of_[opposite(h)] = 2 * e + 1;
  }
  Curve_place curve_place(Index h) const
  {
    const Index k = curve_end(h);
    const Curve_edge& e = curve_edges_[k >> 1];
    return {e.curve, e.arc_length[k & 1], e.arc_length[1 - (k & 1)]};
  }
  // Names the place of the origin of h in the edge of h, for arc_length().
  Index curve_end(Index h) const { return h >= 0 ? curve_edge_of_[h] : curve_edge_of_[~h] ^ 1; }
  // The number of faces that is regular in the sector that begins, counterclockwise, with the half-edge of `curve_end`.
  int regular_faces(Index curve_end) const { return curve_edges_[curve_end >> 1].regular_faces[curve_end & 1]; }
  void set_regular_faces(Index curve_end, int n)
  {
    curve_edges_[curve_end >> 1].regular_faces[curve_end & 1] = static_cast<std::uint16_t>(n);
  }
  Index curve_of(Index curve_end) const { return curve_edges_[curve_end >> 1].curve; }
  double& arc_length(Index curve_end) { return curve_edges_[curve_end >> 1].arc_length[curve_end & 1]; }
  double arc_length(Index curve_end) const { return curve_edges_[curve_end >> 1].arc_length[curve_end & 1]; }

  double squared_edge_length(Index h) const { return squared_distance(position_[origin(h)], position_[target(h)]); }
  // Of the shortest edge of face f.
  double least_squared_edge_length(Index f) const
  {
    const auto& v = faces_[f].vertex;
    const Vector3 &a = position_[v[0]], &b = position_[v[1]], &c = position_[v[2]];
    return (std::min)((std::min)(squared_distance(a, b), squared_distance(b, c)), squared_distance(c, a));
  }
  // Twice the area times the unit normal of face f.
  Vector3 cross_product(Index f) const
  {
    const auto& v = faces_[f].vertex;
    return triangle_cross(position_[v[0]], position_[v[1]], position_[v[2]]);
  }
  // Of the face of h, over h.
  double altitude(Index h) const
  {
    const Vector3 &a = position(origin(h)), &b = position(target(h)), &c = position(apex(h));
    return length(triangle_cross(a, b, c)) / length(b - a);
  }

  // Calls `function(h)` for the half-edges that leave v through a face, counterclockwise. They are counted, not taken
  // until the fan closes: the processor need not wait for the end of one fan to begin with the next.
  template <class Function>
  void for_each_around(Index v, const Function& function) const
  {
    Index h = first_[v];
    for (int k = number_of_faces_around(v); k > 0; --k) {
      const Index following = rotate_ccw(h);
      function(h);
      h = following;
    }
  }

  // The half-edge into v, a vertex on the border, with which its fan ends.
  Index last_edge(Index v) const
  {
    Index last = first_[v];
    for_each_around(v, [&](Index h) { last = h; });
    return prev(last);
  }

  // Whether `predicate(h)` holds for all of them; stops at the first one for which it does not.
  template <class Predicate>
  bool all_around(Index v, const Predicate& predicate) const
  {
    Index h = first_[v];
    for (int k = number_of_faces_around(v); k > 0; --k, h = rotate_ccw(h))
      if (!predicate(h)) return false;
    return true;
  }

  // Whether `predicate(c, d)` holds for every face a c d around the source a of h but those of the edge of h: when a is merged into
  // the target b of h, which may be a border side, each becomes b c d. Stops at the first one for which it does not hold.
  template <class Predicate>
  bool all_faces_of_collapse(Index h, const Predicate& predicate) const
  {
    const Index b = source(opposite(h));
    return all_around(source(h), [&](Index k) {
      const Index c = target(k), d = apex(k);
      return c == b || d == b || predicate(c, d);
    });
  }

  // Calls `function(u)` for each neighbor u of v, counterclockwise.
  template <class Function>
  void for_each_neighbor(Index v, const Function& function) const
  {
    Index h = first_[v];
    for (int k = number_of_faces_around(v); k > 0; --k) {
      function(target(h));
      if (k == 1 && is_border_vertex(v)) function(apex(h));
      h = rotate_ccw(h);
    }
  }

  bool is_adjacent(Index u, Index v) const
  {
    bool found = false;
    for_each_neighbor(state_[u].valence <= state_[v].valence ? u : v,
                      [&, other = state_[u].valence <= state_[v].valence ? v : u](Index w) { found |= w == other; });
    return found;
  }

  // The half-edge from u to v through a face; negative where there is none.
  Index find_halfedge(Index u, Index v) const
  {
    Index h = first_[u];
    do {
      if (target(h) == v) return h;
      h = rotate_ccw(h);
    } while (h >= 0 && h != first_[u]);
    return -1;
  }

  // --- what is legal topologically ----------------------------------------------------------------------------

  // Whether a new edge between u and v could double one of the user's that the flat mesh does not see: one outside of the range, or
  // between other fans of the same vertices.
  bool may_double_edge(Index u, Index v) const
  {
    constexpr unsigned HAS_EDGES_ELSEWHERE = NEXT_TO_OUTSIDE | PINCHED;
    const unsigned of_u = state_[u].marks, of_v = state_[v].marks;
    if ((of_u & HAS_EDGES_ELSEWHERE) != 0 && (of_v & HAS_EDGES_ELSEWHERE) != 0) return true;
    return ((of_u | of_v) & PINCHED) != 0 && ((of_u & PINCHED) != 0 ? meets_fan_beside(v, u) : meets_fan_beside(u, v));
  }

  // Whether a neighbor of u is another fan of the user's vertex that v is a fan of.
  bool meets_fan_beside(Index u, Index v) const
  {
    bool found = false;
    for_each_neighbor(u, [&](Index w) { found |= w != v && is_pinched(w) && position_[w] == position_[v]; });
    return found;
  }

  bool is_flip_legal(Index h) const;
  bool is_split_legal(Index h) const
  {
    const Index o = opposite(h);
    return !is_protected(h) && (h < 0 || valence(apex(h)) < LARGEST_VALENCE) && (o < 0 || valence(apex(o)) < LARGEST_VALENCE) &&
           (h < 0 || o < 0 || apex(h) != apex(o));
  }
  // Whether the source of h may be merged into its target: the link condition, and both curves and what lies
  // outside of the range kept. h may be a border side, here and in collapse().
  bool is_collapse_legal(Index h) const;
  // The same, but for locks and curves: the link condition, and what lies outside of the range kept.
  bool keeps_topology(Index h) const;

  // --- the three operations -----------------------------------------------------------------------------------

  // Replaces the edge of h by the other diagonal; next(h) becomes that diagonal, towards what was apex(h).
  void flip(Index h);
  // Puts a vertex at `p` on the edge of h; returns it. On a curve its place is the middle of the edge's arc.
  Index split(Index h, const Vector3& p);
  // Merges the source of h into its target.
  void collapse(Index h);

  // --- the space-filling order --------------------------------------------------------------------------------

  // Renumbers: vertex i becomes `order[i]`'s; faces follow their smallest vertex; free slots vanish.
  template <class ConcurrencyTag>
  void renumber(const std::vector<Index>& order);
  // Live vertices, block by block.
  std::vector<Index> block_order() const;

  // --- subdivision --------------------------------------------------------------------------------------------

  // The numbers that elements get when every face is cut into four. A vertex is followed by the middles of its edges, as far
  // as no vertex before it has them: an order that was local stays so.
  struct Subdivision_numbers
  {
    std::vector<Index> vertex;           // by vertex
    std::vector<Index> middle;           // by half-edge: of the vertex in the middle of its edge
    std::vector<Index> edges;            // one half-edge of each edge, border ones included, by rising number of its middle
  };
  // The mesh has no free slots.
  Subdivision_numbers subdivision_numbers() const;
  // Cuts every face into four at the middles of its edges, which come to lie at the points, given in the order of
  // `numbers.edges`; on curves their places are the middles of the arcs.
  template <class ConcurrencyTag>
  void subdivide(const Subdivision_numbers& numbers, const std::vector<Vector3>& points);
  bool has_free_slots() const { return !free_faces_.empty() || !free_vertices_.empty(); }

  // --- who was touched, for evaluations that were made beforehand ----------------------------------------------

  void start_recording_touched() { touched_.assign(number_of_vertex_slots(), 0); }
  void stop_recording_touched() { touched_.clear(); }
  // Whether an operation since start_recording_touched() changed what an evaluation of h reads: the stars of the four vertices around it,
  // and those of all vertices around its ends where it is on a curve, as the strip beside its other edge may end there, or where an end
  // is pinched, as they may be joined to the fans beside.
  bool is_touched(Index h) const
  {
    if (origin(h) < 0) return true;
    const Index o = opposite(h);
    if (touched_[origin(h)] || touched_[target(h)] || touched_[apex(h)] || (!is_border(h) && touched_[apex(o)])) return true;
    bool result = false;
    if (is_on_curve_edge(h) || is_pinched(origin(h)) || is_pinched(target(h)))
      for (const Index end : {origin(h), target(h)})
        for_each_neighbor(end, [&](Index v) { result = result || touched_[v] != 0; });
    return result;
  }

private:
  friend class Mesh_snapshot;

  // What most questions about a vertex need, in one word.
  struct Vertex_state
  {
    std::uint16_t valence = 0;
    std::uint8_t marks = 0;
    std::uint8_t regular_valence = 6;
  };

  // As many can be indexed by their half-edges.
  static constexpr std::size_t MOST_FACES = std::size_t((std::numeric_limits<Index>::max)()) / 4;
  static void check_number_of_faces(std::size_t n)
  {
    if (n > MOST_FACES)
      throw CGAL::Postcondition_exception("Inter_angle_remeshing", "isotropic_remeshing()", __FILE__, __LINE__,
        "more than " + std::to_string(MOST_FACES) + " faces, which cannot be indexed; does the projection enlarge the surface?");
  }

  // The most that a vertex's state has room for.
  static constexpr int LARGEST_VALENCE = (std::numeric_limits<std::uint16_t>::max)();
  // A vertex of this valence cannot lose an edge.
  int least_valence(Index v) const { return is_border_vertex(v) ? 2 : 3; }

  void touch(Index v)
  {
    if (!touched_.empty()) {
      if (std::size_t(v) >= touched_.size()) touched_.resize(number_of_vertex_slots(), 0);
      touched_[v] = 1;
    }
  }
  void touch_star(Index v)
  {
    if (touched_.empty()) return;
    touch(v);
    for_each_neighbor(v, [&](Index u) { touch(u); });
  }

  // Sets where the fan of v begins, from any of its half-edges.
  void settle_first(Index v, Index h) { first_[v] = is_border_vertex(v) ? fan_start(h) : h; }

  Index new_face();
  Index new_vertex();

  static constexpr std::uint32_t ALL_FLAGS = CONSTRAINED | PROTECTED | ON_CURVE | FOUND | PASSING | SEAM | JAGGED | ON_RIM;

  // The flags of the edge of h, moved down to the bits of edge 0.
  std::uint32_t flags(Index h) const { return (faces_[h >> 2].edge_flags >> (h & 3)) & ALL_FLAGS; }
  void set_flags(Index h, std::uint32_t flags)
  {
    std::uint32_t& bits = faces_[h >> 2].edge_flags;
    bits = (bits & ~(ALL_FLAGS << (h & 3))) | (flags << (h & 3));
  }

  // What an edge carries with it when it becomes another edge of a face: its flags, and its place on a curve as seen
  // from one of its half-edges.
  struct Edge_label
  {
    std::uint32_t flags = 0;
    Index curve_end = -1;

    Edge_label reversed() const { return {flags, curve_end < 0 ? curve_end : curve_end ^ 1}; }
  };
  Edge_label label(Index h) const
  {
    const std::uint32_t f = flags(h);
    return {f, (f & ON_CURVE) != 0 ? curve_edge_of_[h] : -1};
  }
  void set_label(Index h, const Edge_label& label)
  {
    set_flags(h, label.flags);
    if (label.flags & ON_CURVE) curve_edge_of_[h] = label.curve_end;
  }

  struct Curve_edge
  {
    Index curve;
    std::uint16_t regular_faces[2];
    double arc_length[2];
  };

  Index new_curve_edge(Index curve, double begin, double end)
  {
    curve_edges_.push_back({curve, {3, 3}, {begin, end}});
    return Index(curve_edges_.size()) - 1;
  }
  void leave_curve(Index h);

  // The halves of the half-edge h, from its origin to the middle and from there on, when every face is cut into four: face 4 f + k
  // is the one at corner k of face f, 4 f + 3 the one in the middle; corner k of these has the number k, or lies on edge k.
  static Index first_half(Index h) { return 4 * (4 * (h >> 2) + (h & 3)) + (h & 3); }
  static Index second_half(Index h) { return 4 * (4 * (h >> 2) + (next(h) & 3)) + (h & 3); }
  static std::uint32_t edge_bits(int k) { return ALL_FLAGS << k; }
  std::array<Face, 4> subdivided_face(Index f, const Subdivision_numbers& numbers) const;
  void subdivide_curves(const std::vector<Index>& edges, Remeshing_mesh& result) const;

  double unit_ = 1;
  std::vector<Vector3> position_;
  std::vector<Index> first_;
  std::vector<Vertex_state> state_;
  std::vector<Index> hint_, input_, block_;
  std::vector<Index> curve_edge_of_;      // by half-edge: 2 e, or 2 e + 1 where e runs the other way; empty: no curves
  std::vector<Curve_edge> curve_edges_;
  std::vector<Index> free_faces_, free_vertices_;
  std::vector<std::uint8_t> touched_;
};

inline Remeshing_mesh::Index Remeshing_mesh::new_face()
{
  if (!free_faces_.empty()) {
    const Index f = free_faces_.back();
    free_faces_.pop_back();
    return f;
  }
  check_number_of_faces(faces_.size() + 1);
  faces_.emplace_back();
  if (has_curves()) curve_edge_of_.resize(4 * faces_.size(), -1);
  return Index(faces_.size()) - 1;
}

inline Remeshing_mesh::Index Remeshing_mesh::new_vertex()
{
  if (!free_vertices_.empty()) {
    const Index v = free_vertices_.back();
    free_vertices_.pop_back();
    return v;
  }
  resize_vertices(position_.size() + 1);
  return Index(position_.size()) - 1;
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

// The members that are declared above and defined elsewhere.
#include <CGAL/Inter_angle_remeshing/internal/mesh/Remeshing_mesh_operations.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/Remeshing_mesh_renewal.h>

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_REMESHING_MESH_H
