// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_COLLAPSE_PASS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_COLLAPSE_PASS_H

#include <CGAL/Inter_angle_remeshing/internal/Remeshing_context.h>
#include <CGAL/Inter_angle_remeshing/internal/curves/curve_edges.h>
#include <CGAL/Inter_angle_remeshing/internal/geometry/closest_point_on_triangle.h>
#include <CGAL/Inter_angle_remeshing/internal/geometry/thin_angles.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/cross_products.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/evaluate_then_apply.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

// Collapses edges that are shorter than Recipe::collapse_ratio times the target length (Zheng and Lv, edge collapse), as half-edge
// collapses: one end stays where it is, on the surface, and keeps its descriptor.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// What a collapse must not do, in the units of the flat mesh; lengths where the target length is that of the run.
struct Collapse_limits
{
  double squared_length;       // of a new edge
  double squared_tolerance;    // distance from the removed vertex to what replaces its star
  int valence;                 // of the merged vertex
  double reach = 1;            // off the curves a new edge may be so many times as long
};

// A merged vertex of a higher valence costs more regularity than flips can mend in an iteration.
constexpr int MAXIMUM_MERGED_VALENCE = 9;
// Smallest cosine between the normals of a face before and after a collapse: 60 degrees.
constexpr double COLLAPSE_NORMAL_COSINE = 0.5;

// An edge is tiny if it is this part of the longest new edge, about an eighth of the target length: as the short side of a needle.
// Edges of more than so many times the longest new one, two target lengths, are split all the same.
constexpr double SQUARED_TINY = 0.01, SQUARED_YIELD = 2.25;

// Whether no new edge at h's target is too long, or longer than before where the edge of h is tiny: else needles would neither be
// collapsed, for their sides are too long, nor split, for their angles are obtuse. The neighbors of a free source other than the
// target and the two apexes, which the target has already, are met from the far side: there most collapses fail. Where the source
// lies on a curve, its own short edges are what lowers the target length: that must not keep them short.
inline bool has_short_edges_after_collapse(const Remeshing_mesh& mesh, Remeshing_mesh::Index h, const Grading& grading,
                                           const Collapse_limits& limits)
{
  using Index = Remeshing_mesh::Index;
  const Index a = mesh.source(h), b = mesh.source(mesh.opposite(h));
  const Vector3& q = mesh.position(b);
  const bool is_on_curve = mesh.is_on_curve(a),
             is_tiny = squared_distance(mesh.position(a), q) <
                       SQUARED_TINY * CGAL::square(grading.field_part(a, b)) * limits.squared_length;
  const double squared_reach = is_on_curve ? 1. : limits.reach * limits.reach;
  const auto is_short = [&](Index k) {
    const Index c = mesh.target(k);
    const double part = is_on_curve ? grading.field_part(b, c) : grading.is_uniform() ? 1. : grading.part(b, c);
    const double l = squared_distance(q, mesh.position(c));
    return l <= part * part * squared_reach * limits.squared_length ||
           (is_tiny && l <= SQUARED_YIELD * part * part * limits.squared_length &&
            l <= squared_distance(mesh.position(a), mesh.position(c)));
  };
  if (!mesh.is_free(a)) return mesh.all_around(a, is_short);
  Index k = mesh.rotate_ccw(mesh.rotate_ccw(h));
  for (int n = mesh.valence(a) - 3; n > 0; --n, k = mesh.rotate_ccw(k))
    if (!is_short(k)) return false;
  return true;
}

// Whether the collapse of h leaves a tetrahedron, the least that a closed component can be, that is flat: all of its volume would be lost.
inline bool leaves_flat_tetrahedron(const Remeshing_mesh& mesh, Remeshing_mesh::Index h)
{
  using Index = Remeshing_mesh::Index;
  constexpr double FLAT = 0.1;           // altitude over the largest face, over the longest edge
  const Index o = mesh.opposite(h);
  if (h < 0 || o < 0) return false;
  const Index a = mesh.source(h), b = mesh.source(o), c = mesh.apex(h), d = mesh.apex(o);
  if (mesh.valence(a) + mesh.valence(b) != 7 || mesh.valence(c) != 4 || mesh.valence(d) != 4) return false;
  Index e = b;
  for (const Index end : {a, b})
    mesh.for_each_neighbor(end, [&](Index u) { if (u != a && u != b && u != c && u != d) e = u; });
  if (mesh.valence(e) != 3) return false;
  const Vector3 p[4] = {mesh.position(b), mesh.position(c), mesh.position(d), mesh.position(e)};
  double largest_area = 0, longest_edge = 0;
  for (int k = 0; k < 4; ++k) {
    largest_area = (std::max)(largest_area, length(triangle_cross(p[k], p[(k + 1) % 4], p[(k + 2) % 4])));
    for (int l = 0; l < k; ++l) longest_edge = (std::max)(longest_edge, length(p[k] - p[l]));
  }
  return std::abs(dot(triangle_cross(p[0], p[1], p[2]), p[3] - p[0])) < FLAT * longest_edge * largest_area;
}

// Whether the faces that replace the star of h's source are fit: no edge too long, no face turned, and one of them
// near the removed point. The last keeps tips and ridges.
inline bool is_collapse_fit(const Remeshing_mesh& mesh, Remeshing_mesh::Index h, const Grading& grading,
                            const Collapse_limits& limits)
{
  using Index = Remeshing_mesh::Index;
  const Index a = mesh.source(h), b = mesh.source(mesh.opposite(h));
  const Vector3 p = mesh.position(a), q = mesh.position(b);
  const double part = grading.field_part(a), squared_tolerance = part * part * limits.squared_tolerance;
  if (!has_short_edges_after_collapse(mesh, h, grading, limits)) return false;
  bool is_near = mesh.is_on_curve(a);     // what a curve may lose, keeps_curve() says
  const bool turns_no_face = mesh.all_faces_of_collapse(h, [&](Index c, Index d) {
    const Vector3 &r = mesh.position(c), &s = mesh.position(d);
    const Vector3 before = triangle_cross(p, r, s), after = triangle_cross(q, r, s);
    const bool is_turned = is_degenerate(before, p, r, s)
                             ? dot(after, star_cross_product(mesh, a)) < 0      // it had no normal to compare with
                             : !is_cosine_at_least(before, after, COLLAPSE_NORMAL_COSINE);
    if (is_turned) return false;
    is_near = is_near || squared_distance(closest_point_on_triangle(p, q, r, s).point, p) <= squared_tolerance;
    return true;
  });
  return turns_no_face && is_near && !leaves_flat_tetrahedron(mesh, h);
}

// Smallest angle that a collapse may leave where a curve is near, unless it was smaller before: 15 degrees, as the square
// of the sine.
constexpr double COLLAPSED_SQUARED_SINE = 0.0669872981077807;
// Where all neighbors lie on curves, and the edge is shorter than this part of the longest new one, about .4 target lengths, it may become
// smaller by this factor: along two curves with vertices close together, as of a bar with many rings, each collapse on one makes the
// needles between them a little thinner, until the other one follows.
constexpr double SQUARED_MUCH_TOO_SHORT = 0.09, SQUARED_YIELDING_SINE = 0.25;

// Whether h leads to a curve, or one touches the star of its source.
inline bool is_near_curve(const Remeshing_mesh& mesh, Remeshing_mesh::Index h)
{
  return mesh.is_on_curve(mesh.source(mesh.opposite(h))) || !mesh.all_around(mesh.source(h), [&](Remeshing_mesh::Index k) {
    return !mesh.is_on_curve(mesh.target(k)) && !mesh.is_on_curve(mesh.apex(k)); });
}

// Whether faces beside a curve stay fit when the source of h is merged into its target.
inline bool keeps_faces_at_curves(const Remeshing_mesh& mesh, Remeshing_mesh::Index h, const Grading& grading,
                                  const Collapse_limits& limits)
{
  using Index = Remeshing_mesh::Index;
  const Index a = mesh.source(h), b = mesh.source(mesh.opposite(h));
  const Vector3 &p = mesh.position(a), &q = mesh.position(b);
  if (!is_near_curve(mesh, h)) return true;
  const double much_too_short = SQUARED_MUCH_TOO_SHORT * CGAL::square(grading.field_part(a, b)) * limits.squared_length;
  const bool is_locked = mesh.is_on_curve(a) && squared_distance(p, q) < much_too_short &&
                         mesh.all_around(a, [&](Index k) { return mesh.is_on_curve(mesh.target(k)) && mesh.is_on_curve(mesh.apex(k)); });
  double before = 1, after = 1;
  // Whether the edge between b and u is on a curve, once b has taken the edges of a over.
  const auto will_be_on_curve = [&](Index u, bool is_on_curve_from_a) {
    Index existing = mesh.find_halfedge(b, u);
    if (existing < 0 && mesh.is_border_vertex(b)) existing = mesh.find_halfedge(u, b);
    return is_on_curve_from_a || (existing >= 0 && mesh.is_on_curve_edge(existing));
  };
  const bool keeps_corners = mesh.all_around(a, [&](Index k) {
    const Index c = mesh.target(k), d = mesh.apex(k);
    const Vector3 &r = mesh.position(c), &s = mesh.position(d);
    before = (std::min)(before, squared_sine_of_smallest_angle(p, r, s));
    if (c == b || d == b) return true;
    after = (std::min)(after, squared_sine_of_smallest_angle(q, r, s));
    const auto is_wide = [&](const Vector3& apex, const Vector3& x, const Vector3& y) {
      return corner_cosine(apex, x, y) < CURVE_CORNER_COSINE;
    };
    if (!is_wide(q, r, s) && !is_wide(r, q, s) && !is_wide(s, q, r)) return true;
    const bool is_c = will_be_on_curve(c, mesh.is_on_curve_edge(k)), is_link = mesh.is_on_curve_edge(mesh.next(k)),
               is_d = will_be_on_curve(d, mesh.is_on_curve_edge(mesh.prev(k)));
    return !(is_c && is_d && is_wide(q, r, s)) && !(is_link && ((is_c && is_wide(r, q, s)) || (is_d && is_wide(s, q, r))));
  });
  if (is_locked) before *= SQUARED_YIELDING_SINE;
  return keeps_corners && !(after < COLLAPSED_SQUARED_SINE && is_thinner(after, before));
}

// Whether no face turns by more than 26 degrees when the source of h is merged into its target.
inline bool turns_little(const Remeshing_mesh& mesh, Remeshing_mesh::Index h)
{
  const Vector3 &p = mesh.position(mesh.source(h)), &q = mesh.position(mesh.source(mesh.opposite(h)));
  return mesh.all_faces_of_collapse(h, [&](Remeshing_mesh::Index c, Remeshing_mesh::Index d) {
    const Vector3 &r = mesh.position(c), &s = mesh.position(d);
    return is_cosine_at_least(triangle_cross(p, r, s), triangle_cross(q, r, s), LITTLE_TURN_COSINE);
  });
}

// Whether one of the faces that replace the star of h's source turns its back on the surface, where none of the star
// did. Where no face turns far, the surface need not be asked.
inline bool makes_fold(const Remeshing_context& context, Remeshing_mesh::Index h)
{
  const Remeshing_mesh& mesh = context.mesh;
  const Remeshing_mesh::Index a = mesh.source(h), b = mesh.source(mesh.opposite(h));
  if (turns_little(mesh, h)) return false;
  const bool is_fold_free = mesh.all_faces_of_collapse(h, [&](Remeshing_mesh::Index c, Remeshing_mesh::Index d) {
    return !context.is_turned_over(b, c, d); });
  return !is_fold_free && mesh.all_around(a, [&](Remeshing_mesh::Index k) {
    return !context.is_turned_over(a, mesh.target(k), mesh.apex(k));
  });
}

// Whether the source of h may be merged into its target.
inline bool is_collapse_allowed(const Remeshing_context& context, Remeshing_mesh::Index h, const Collapse_limits& limits)
{
  const Remeshing_mesh& mesh = context.mesh;
  if (mesh.is_on_curve(mesh.source(h)) && !(context.may_collapse_along_curve(h) && keeps_curve(context, h))) return false;
  return is_collapse_fit(mesh, h, context.grading, limits) && mesh.is_collapse_legal(h) &&
         (!mesh.has_curves() || keeps_faces_at_curves(mesh, h, context.grading, limits)) && !makes_fold(context, h) &&
         context.permits_collapse(h);
}

// The half-edge whose source is to be merged into its target, for the edge of h; NO_COLLAPSE where neither may be.
constexpr Remeshing_mesh::Index NO_COLLAPSE = (std::numeric_limits<Remeshing_mesh::Index>::min)();

inline Remeshing_mesh::Index choose_collapse(const Remeshing_context& context, Remeshing_mesh::Index h,
                                             const Collapse_limits& limits)
{
  using Index = Remeshing_mesh::Index;
  const Remeshing_mesh& mesh = context.mesh;
  Index first = h, second = mesh.opposite(h);
  const Index a = mesh.source(first), b = mesh.source(second);
  if (mesh.valence(a) + mesh.valence(b) - 4 > limits.valence) return NO_COLLAPSE;
  if (mesh.valence(b) < mesh.valence(a)) std::swap(first, second);
  for (const Index k : {first, second})
    if (is_collapse_allowed(context, k, limits)) return k;
  return NO_COLLAPSE;
}

// Merges the source of h into its target, which is returned.
inline Remeshing_mesh::Index collapse(Remeshing_context& context, Remeshing_mesh::Index h)
{
  const Remeshing_mesh::Index kept = context.mesh.source(context.mesh.opposite(h));
  context.kept_places.hand_over(context.mesh.source(h), kept);
  context.visitor.before_collapse(Mesh_halfedge(h), context.mesh);
  context.mesh.collapse(h);
  context.visitor.after_collapse(Mesh_vertex(kept), context.mesh);
  return kept;
}

// Collapses the edges of `short_edges` as far as they are still too short, and those that become so.
// Returns the number of collapses.
template <class ConcurrencyTag>
std::size_t collapse_pass(Remeshing_context& context, std::vector<Remeshing_mesh::Index>& short_edges)
{
  using Index = Remeshing_mesh::Index;
  Remeshing_mesh& mesh = context.mesh;
  const Collapse_limits limits{context.squared_length_limit(), CGAL::square(context.collapse_tolerance()), MAXIMUM_MERGED_VALENCE,
                               context.collapse_reach};
  const auto is_too_short = [&](Index h) {
    return mesh.has_place(h) ? is_too_short_on_curve(context, h)
                             : mesh.squared_edge_length(h) < context.squared_shortness_limit(mesh.origin(h), mesh.target(h));
  };
  std::size_t collapses = 0;
  evaluate_then_apply<ConcurrencyTag>(mesh, short_edges,
    [&](Index h) -> Index {
      return mesh.origin(h) >= 0 && is_too_short(h) ? choose_collapse(context, h, limits) : NO_COLLAPSE;
    },
    [&](Index, Index k) {
      if (k == NO_COLLAPSE) return;
      const Index kept = collapse(context, k);
      ++collapses;
      mesh.for_each_around(kept, [&](Index e) {
        if (is_too_short(e)) short_edges.push_back(e);
      });
    });
  return collapses;
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_COLLAPSE_PASS_H
