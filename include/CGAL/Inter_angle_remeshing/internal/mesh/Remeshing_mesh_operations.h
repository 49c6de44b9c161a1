// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_REMESHING_MESH_OPERATIONS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_REMESHING_MESH_OPERATIONS_H

#include <CGAL/Inter_angle_remeshing/internal/mesh/Remeshing_mesh.h>

#include <cstdint>

// Flips, splits and collapses of the mesh, and which of them are legal topologically.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

inline bool Remeshing_mesh::is_flip_legal(Index h) const
{
  if (is_border(h) || (faces_[h >> 2].edge_flags != 0 && flags(h) != 0)) return false;
  const Index o = opposite(h);
  const Index a = origin(h), b = origin(o), c = apex(h), d = apex(o);
  return c != d && state_[a].valence > least_valence(a) && state_[b].valence > least_valence(b) &&
         state_[c].valence < LARGEST_VALENCE && state_[d].valence < LARGEST_VALENCE &&
         !may_double_edge(c, d) && !is_adjacent(c, d);
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
  // and the third edge of a border loop of three shows as one more common neighbor. What was one edge of the rim may be one again.
  int common = 0;
  bool is_legal = true;
  const Index beyond = is_on_rim(side) ? (h >= 0 ? origin(last_edge(a)) : target(first(a))) : NO_VERTEX;
  for_each_neighbor(a, [&](Index u) {
    if (u == b) return;
    if (u != c && u != d && u != beyond) is_legal &= !may_double_edge(b, u);
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
  if (edge.flags & ON_RIM) add_marks(m, NEXT_TO_OUTSIDE);
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

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_REMESHING_MESH_OPERATIONS_H
