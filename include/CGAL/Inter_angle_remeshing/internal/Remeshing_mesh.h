// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_REMESHING_MESH_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_REMESHING_MESH_H

#include <CGAL/Inter_angle_remeshing/internal/Corner_table.h>
#include <CGAL/Inter_angle_remeshing/internal/Vector3.h>
#include <CGAL/Inter_angle_remeshing/internal/parallel_blocks.h>

#include <CGAL/exceptions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
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
    PINCHED = 16,           // one of several fans of the user's vertex: nothing around it may change
    PINNED = 32,            // on a curve, along which it does not slide
    HELD = 64               // locked while the mesh is coarse
  };

  // Flags of edge k of a face: bits k, k + 3, k + 6, k + 9 and k + 12.
  static constexpr std::uint32_t CONSTRAINED = 1;  // never flipped, its chain is kept
  static constexpr std::uint32_t PROTECTED = 8;    // neither flipped, split nor collapsed: keeps its descriptor
  static constexpr std::uint32_t ON_CURVE = 64;    // has a place on a curve of the input, see curve_place()
  static constexpr std::uint32_t FOUND = 512;      // constrained because it was found to be a feature: the user did not mark it
  static constexpr std::uint32_t PASSING = 4096;   // constrained in the iterations alone

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

  // How far the valence is from the regular one: 4 on the border, 6 elsewhere unless another one has been set.
  int deviation(Index v) const { return int(state_[v].valence) - int(state_[v].regular_valence); }
  void set_regular_valence(Index v, int n) { state_[v].regular_valence = static_cast<std::uint8_t>(n); }

  // --- edges --------------------------------------------------------------------------------------------------

  bool is_constrained(Index h) const { return has_flag(h, CONSTRAINED); }
  bool is_marked_by_user(Index h) const { return is_constrained(h) && !has_flag(h, FOUND); }
  bool is_protected(Index h) const { return has_flag(h, PROTECTED); }
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

  // Whether a new edge between u and v could double one that the flat mesh does not see.
  bool may_meet_outside(Index u, Index v) const
  {
    return (state_[u].marks & state_[v].marks & NEXT_TO_OUTSIDE) != 0;
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
  // Whether an operation since start_recording_touched() changed the star of one of the four vertices around h.
  bool is_touched(Index h) const
  {
    if (origin(h) < 0) return true;
    const Index o = opposite(h);
    return touched_[origin(h)] || touched_[target(h)] || touched_[apex(h)] ||
           (!is_border(h) && touched_[apex(o)]);
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

  static constexpr std::uint32_t ALL_FLAGS = CONSTRAINED | PROTECTED | ON_CURVE | FOUND | PASSING;

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

inline bool Remeshing_mesh::is_flip_legal(Index h) const
{
  if (is_border(h) || (faces_[h >> 2].edge_flags != 0 && flags(h) != 0)) return false;
  const Index o = opposite(h);
  const Index a = origin(h), b = origin(o), c = apex(h), d = apex(o);
  return c != d && state_[a].valence > least_valence(a) && state_[b].valence > least_valence(b) &&
         state_[c].valence < LARGEST_VALENCE && state_[d].valence < LARGEST_VALENCE &&
         !may_meet_outside(c, d) && !is_adjacent(c, d);
}

inline bool Remeshing_mesh::is_collapse_legal(Index h) const
{
  const Index g = opposite(h), a = source(h);
  if (is_locked(a)) return false;
  if (is_on_curve(a)) {
    // The triangle of the edge goes; if its other two edges are on curves, too, these would fall into one.
    if (!is_on_curve_edge(h >= 0 ? h : g)) return false;
    for (const Index k : {h, g})
      if (k >= 0 && is_on_curve_edge(next(k)) && is_on_curve_edge(prev(k))) return false;
  }
  return keeps_topology(h);
}

inline bool Remeshing_mesh::keeps_topology(Index h) const
{
  const Index g = opposite(h), a = source(h), b = source(g);
  const Index side = h >= 0 ? h : g;                         // a half-edge of the edge that has a face
  if (is_protected(side) || valence(a) + valence(b) > LARGEST_VALENCE) return false;
  // The face at the tip of an ear goes with it, and a protected edge of it would come to lie on the border.
  if (is_border_vertex(a) && valence(a) == 2 && (is_protected(next(side)) || is_protected(prev(side)))) return false;
  const Index c = h >= 0 ? apex(h) : NO_VERTEX, d = g >= 0 ? apex(g) : NO_VERTEX;
  if (c == d) return false;
  for (const Index v : {c, d})
    if (v >= 0 && state_[v].valence <= least_valence(v)) return false;

  // Link condition: the common neighbors of a and b are the apexes. Where a is on the border, so is the edge,
  // and the third edge of a border loop of three shows as one more common neighbor.
  int common = 0;
  bool is_legal = true;
  for_each_neighbor(a, [&](Index u) {
    if (u == b) return;
    is_legal &= !is_pinched(u);
    if (u != c && u != d) is_legal &= !may_meet_outside(b, u);
    for_each_neighbor(b, [&](Index w) { common += u == w; });
  });
  return is_legal && common == (c < 0 || d < 0 ? 1 : 2);
}

inline void Remeshing_mesh::flip(Index h)
{
  const Index n = next(h), q = prev(h), g = opposite(h), gn = next(g), gp = prev(g);
  const Index a = origin(h), b = origin(g), c = origin(q), d = origin(gp);
  const Index outer_n = opposite(n), outer_gn = opposite(gn);
  if (faces_[h >> 2].edge_flags | faces_[g >> 2].edge_flags) {
    const Edge_label label_n = label(n), label_gn = label(gn);
    set_label(h, label_gn); set_label(g, label_n); set_flags(n, 0); set_flags(gn, 0);
  }
  set_origin(n, d);
  set_origin(gn, c);
  glue(h, outer_gn);
  glue(g, outer_n);
  glue(n, gn);
  --state_[a].valence; --state_[b].valence; ++state_[c].valence; ++state_[d].valence;
  settle_first(a, h); settle_first(b, g); settle_first(c, q); settle_first(d, gp);
  touch(a); touch(b); touch(c); touch(d);
}

inline Remeshing_mesh::Index Remeshing_mesh::split(Index h, const Vector3& p)
{
  const Index m = new_vertex();
  const Index g = opposite(h);
  const Index n = next(h), a = origin(h), b = origin(n), c = apex(h);
  const Index f1 = 4 * new_face();                           // the triangle m b c
  const Edge_label edge = label(h), label_n = label(n);
  Edge_label far_half = edge;
  if (edge.flags & ON_CURVE) {
    const Curve_place place = curve_place(h);
    const double middle = 0.5 * (place.origin + place.target);
    arc_length(edge.curve_end ^ 1) = middle;
    far_half.curve_end = 2 * new_curve_edge(place.curve, middle, place.target);
  }
  faces_[f1 >> 2] = Face{{m, b, c}, faces_[h >> 2].source, {-1, -1, -1}, 0};
  glue(f1 + 1, opposite(n));
  set_origin(n, m);
  glue(n, f1 + 2);
  set_label(f1, far_half); set_label(f1 + 1, label_n); set_flags(n, 0);
  if (first_[b] == n) first_[b] = f1 + 1;
  ++state_[c].valence;

  if (g >= 0) {
    const Index gp = prev(g), d = origin(gp);
    const Index g1 = 4 * new_face();                         // the triangle b m d
    const Edge_label label_gp = label(gp);
    faces_[g1 >> 2] = Face{{b, m, d}, faces_[g >> 2].source, {-1, -1, -1}, 0};
    glue(g1 + 2, opposite(gp));
    set_origin(g, m);
    glue(gp, g1 + 1);
    glue(f1, g1);
    set_label(g1, far_half.reversed()); set_label(g1 + 2, label_gp); set_flags(gp, 0);
    if (first_[b] == g) first_[b] = g1;
    if (first_[d] == gp) first_[d] = g1 + 2;
    ++state_[d].valence;
    touch(d);
  } else
    glue(f1, g);

  position_[m] = p;
  first_[m] = f1;
  state_[m] = Vertex_state{std::uint16_t(g >= 0 ? 4 : 3), 0, 6};
  if (g < 0) add_marks(m, ON_BORDER);
  if (edge.flags & CONSTRAINED) add_marks(m, ON_FEATURE);
  hint_[m] = hint_[a];
  input_[m] = NO_VERTEX;
  block_[m] = block_[a];
  touch(a); touch(b); touch(c); touch(m);
  return m;
}

// Before the source of h is merged into its target: of the two edges of their curve, the one beyond takes the place of
// both.
inline void Remeshing_mesh::leave_curve(Index h)
{
  const Curve_place removed = curve_place(h);
  const Index edge = curve_end(h) >> 1;
  const auto take_over = [&](Index k) {        // k leaves the source of h
    if (!has_place(k) || curve_end(k) >> 1 == edge) return;
    const double shift = arc_length(curve_end(k)) - removed.origin;     // once around a closed curve, or 0
    arc_length(curve_end(k)) = removed.target + shift;
  };
  const Index a = source(h);
  Index last = -1;
  for_each_around(a, [&](Index k) { take_over(k); last = k; });
  if (is_border_vertex(a) && is_border(prev(last))) take_over(~prev(last));
}

inline void Remeshing_mesh::collapse(Index h)
{
  const Index g = opposite(h), a = source(h), b = source(g);
  if (has_curves() && has_place(h)) leave_curve(h);
  touch_star(a);
  for_each_around(a, [&](Index k) { set_origin(k, b); });
  set_valence(b, valence(b) + valence(a) - (h >= 0 && g >= 0 ? 4 : 3));

  // Takes the triangle of the half-edge e between a and b out, and sews its other two edges together.
  const auto remove_face = [&](Index e) {
    const Index n = next(e), q = prev(e), c = origin(q);
    const Index outer_n = opposite(n), outer_q = opposite(q);
    Edge_label merged = label(n);                            // as seen from b
    const Edge_label of_q = label(q);
    if (of_q.flags & ON_CURVE) merged.curve_end = of_q.curve_end ^ 1;
    merged.flags |= of_q.flags;
    glue(outer_n, outer_q);
    if (outer_q >= 0) set_label(outer_q, merged);
    if (outer_n >= 0) set_label(outer_n, merged.reversed());
    for (const Index o : {outer_n, outer_q})                 // one of them lies outside of the star
      if (o >= 0) touch(apex(o));
    --state_[c].valence;
    first_[c] = outer_n >= 0 ? outer_n : next(outer_q);
    first_[b] = outer_q >= 0 ? outer_q : next(outer_n);
    faces_[e >> 2] = Face();
    free_faces_.push_back(e >> 2);
    return c;
  };
  const Index c = h >= 0 ? remove_face(h) : NO_VERTEX;
  const Index d = g >= 0 ? remove_face(g) : NO_VERTEX;
  settle_first(b, first_[b]);
  for (const Index v : {c, d})
    if (v >= 0) settle_first(v, first_[v]);

  first_[a] = -1;
  state_[a] = Vertex_state();
  free_vertices_.push_back(a);
}

inline std::vector<Remeshing_mesh::Index> Remeshing_mesh::block_order() const
{
  Index last = 0;
  for (const Index k : block_)
    last = (std::max)(last, k);
  std::vector<Index> start(std::size_t(last) + 2, 0);
  for (std::size_t v = 0; v < position_.size(); ++v)
    if (first_[v] >= 0) ++start[block_[v] + 1];
  for (std::size_t k = 0; k + 1 < start.size(); ++k)
    start[k + 1] += start[k];
  std::vector<Index> order(start.back());
  for (std::size_t v = 0; v < position_.size(); ++v)
    if (first_[v] >= 0) order[start[block_[v]]++] = Index(v);
  return order;
}

template <class ConcurrencyTag>
void Remeshing_mesh::renumber(const std::vector<Index>& order)
{
  const std::size_t n = order.size();
  std::vector<Index> new_vertex_of(number_of_vertex_slots(), NO_VERTEX);
  for (std::size_t i = 0; i < n; ++i)
    new_vertex_of[order[i]] = Index(i);

  // Faces in the order of their smallest vertex, so that a sweep meets them one after the other. Each is written down at every
  // corner, and kept at one.
  std::vector<Index> new_face_of(number_of_face_slots(), -1), face_order(number_of_live_faces() + 1);
  std::size_t found = 0;
  for (std::size_t i = 0; i < n; ++i)
    for_each_around(order[i], [&](Index h) {
      face_order[found] = h >> 2;
      found += std::size_t((std::min)(new_vertex_of[target(h)], new_vertex_of[apex(h)]) > Index(i));
    });
  face_order.resize(found);
  for (std::size_t i = 0; i < found; ++i) new_face_of[face_order[i]] = Index(i);

  const auto new_corner_of = [&](Index h) { return 4 * new_face_of[h >> 2] + (h & 3); };
  std::vector<Face> faces;
  faces.reserve(face_order.size() + face_order.size() / 8);   // room for the splits that follow
  faces.resize(face_order.size());
  for_each_block<ConcurrencyTag>(faces.size(), SCAN_BLOCK, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) {
      const Face& old = faces_[face_order[i]];
      faces[i] = old;
      for (int k = 0; k < 3; ++k) {
        faces[i].vertex[k] = new_vertex_of[old.vertex[k]];
        faces[i].opposite[k] = old.opposite[k] >= 0 ? new_corner_of(old.opposite[k]) : ~Index(4 * i + k);
      }
    }
  });

  Remeshing_mesh result;
  result.unit_ = unit_;
  result.reserve_vertices(n + n / 8);
  result.resize_vertices(n);
  const unsigned shift = block_shift(n);
  for_each_block<ConcurrencyTag>(n, SCAN_BLOCK, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) {
      const Index v = order[i];
      result.position_[i] = position_[v];
      result.first_[i] = new_corner_of(first_[v]);
      result.state_[i] = state_[v];
      result.hint_[i] = hint_[v];
      result.input_[i] = input_[v];
      result.block_[i] = Index(i >> shift);
    }
  });
  if (has_curves()) {
    result.curve_edge_of_.resize(4 * faces.size());
    for (std::size_t i = 0; i < faces.size(); ++i)
      for (int k = 0; k < 3; ++k) result.curve_edge_of_[4 * i + k] = curve_edge_of_[4 * face_order[i] + k];
    result.curve_edges_ = std::move(curve_edges_);
  }
  result.faces_ = std::move(faces);
  *this = std::move(result);
}

inline Remeshing_mesh::Subdivision_numbers Remeshing_mesh::subdivision_numbers() const
{
  Subdivision_numbers result;
  result.vertex.resize(number_of_vertex_slots());
  result.middle.assign(4 * number_of_face_slots(), -1);
  result.edges.reserve(number_of_face_slots() + number_of_face_slots() / 2);
  Index next_number = 0;
  const auto number_middle = [&](Index h) {
    if (result.middle[h] >= 0) return;
    if (!is_border(h)) result.middle[opposite(h)] = next_number;
    result.middle[h] = next_number++;
    result.edges.push_back(h);
  };
  for (Index v = 0; v < Index(result.vertex.size()); ++v) {
    result.vertex[v] = next_number++;
    for_each_around(v, [&](Index h) {
      number_middle(h);
      number_middle(prev(h));            // the last edge of an open fan
    });
  }
  return result;
}

inline std::array<Corner_table::Face, 4> Remeshing_mesh::subdivided_face(Index f, const Subdivision_numbers& numbers) const
{
  const Face& whole = faces_[f];
  std::array<Face, 4> parts;
  for (int k = 0; k < 3; ++k) {
    const int after = (k + 1) % 3, before = (k + 2) % 3;
    const Index o = whole.opposite[k], o_before = whole.opposite[before];
    Face& part = parts[k];
    part.vertex[k] = numbers.vertex[whole.vertex[k]];
    part.vertex[after] = numbers.middle[4 * f + k];
    part.vertex[before] = numbers.middle[4 * f + before];
    part.opposite[k] = o >= 0 ? second_half(o) : ~first_half(4 * f + k);
    part.opposite[after] = 4 * (4 * f + 3) + before;
    part.opposite[before] = o_before >= 0 ? first_half(o_before) : ~second_half(4 * f + before);
    part.edge_flags = whole.edge_flags & (edge_bits(k) | edge_bits(before));
    parts[3].vertex[k] = part.vertex[after];
    parts[3].opposite[before] = 4 * (4 * f + k) + after;
  }
  for (Face& part : parts) part.source = whole.source;
  return parts;
}

// The edges on curves and their places: each half has one half of the arc.
inline void Remeshing_mesh::subdivide_curves(const std::vector<Index>& edges, Remeshing_mesh& result) const
{
  result.curve_edge_of_.assign(4 * result.faces_.size(), -1);
  const auto add_half = [&](Index half, Index curve, double begin, double end) {
    const Index e = result.new_curve_edge(curve, begin, end);
    result.curve_edge_of_[half] = 2 * e;
    if (!result.is_border(half)) result.curve_edge_of_[result.opposite(half)] = 2 * e + 1;
  };
  for (const Index h : edges) {
    if (!has_place(h)) continue;
    const Curve_place place = curve_place(h);
    const double middle = 0.5 * (place.origin + place.target);
    add_half(first_half(h), place.curve, place.origin, middle);
    add_half(second_half(h), place.curve, middle, place.target);
  }
}

template <class ConcurrencyTag>
void Remeshing_mesh::subdivide(const Subdivision_numbers& numbers, const std::vector<Vector3>& points)
{
  const std::size_t vertices = number_of_vertex_slots(), edges = numbers.edges.size(), faces = number_of_face_slots();
  check_number_of_faces(4 * faces);
  Remeshing_mesh result;
  result.unit_ = unit_;
  result.faces_.resize(4 * faces);
  for_each_block<ConcurrencyTag>(faces, SCAN_BLOCK, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t f = begin; f < end; ++f) {
      const std::array<Face, 4> parts = subdivided_face(Index(f), numbers);
      std::copy(parts.begin(), parts.end(), result.faces_.begin() + std::ptrdiff_t(4 * f));
    }
  });
  result.resize_vertices(vertices + edges);
  for_each_block<ConcurrencyTag>(vertices, SCAN_BLOCK, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t v = begin; v < end; ++v) {
      const Index i = numbers.vertex[v];
      result.position_[i] = position_[v];
      result.first_[i] = first_half(first_[v]);
      result.state_[i] = state_[v];
      result.hint_[i] = hint_[v];
      result.input_[i] = input_[v];
    }
  });
  for_each_block<ConcurrencyTag>(edges, SCAN_BLOCK, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t e = begin; e < end; ++e) {
      const Index h = numbers.edges[e], i = numbers.middle[h];
      result.position_[i] = points[e];
      result.first_[i] = second_half(h);
      result.state_[i] = Vertex_state{std::uint16_t(is_border(h) ? 4 : 6), 0, 6};
      if (is_border(h)) result.add_marks(i, ON_BORDER);
      if (is_constrained(h)) result.add_marks(i, ON_FEATURE);
    }
  });
  const unsigned shift = block_shift(result.block_.size());
  for (std::size_t i = 0; i < result.block_.size(); ++i) result.block_[i] = Index(i >> shift);
  if (has_curves()) subdivide_curves(numbers.edges, result);
  *this = std::move(result);
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_REMESHING_MESH_H
