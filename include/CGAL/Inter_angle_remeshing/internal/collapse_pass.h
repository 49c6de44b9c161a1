// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_COLLAPSE_PASS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_COLLAPSE_PASS_H

#include <CGAL/Inter_angle_remeshing/internal/Remeshing_context.h>
#include <CGAL/Inter_angle_remeshing/internal/closest_point_on_triangle.h>
#include <CGAL/Inter_angle_remeshing/internal/evaluate_then_apply.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

// Collapses edges that are shorter than about 4/5 of the target length (Zheng and Lv, edge collapse), as half-edge collapses: one
// end stays where it is, on the surface, and keeps its descriptor.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// What a collapse must not do, in the units of the flat mesh.
struct Collapse_limits
{
  double squared_length;       // of a new edge
  double squared_tolerance;    // distance from the removed vertex to what replaces its star
  double squared_deviation;    // distance from a removed curve vertex to the curve's new edge
  int valence;                 // of the merged vertex
};

// A removed border or feature vertex may lie this far from the curve's new edge, in target lengths.
constexpr double CURVE_TOLERANCE = 0.05;
// A merged vertex of a higher valence costs more regularity than flips can mend in an iteration.
constexpr int MAXIMUM_MERGED_VALENCE = 9;
// Smallest cosine between the normals of a face before and after a collapse: 60 degrees.
constexpr double COLLAPSE_NORMAL_COSINE = 0.5;

inline double squared_distance_to_segment(const Vector3& q, const Vector3& a, const Vector3& b)
{
  const Vector3 ab = b - a;
  const double t = dot(q - a, ab), l = squared_length(ab);
  if (t <= 0) return squared_distance(q, a);
  if (t >= l) return squared_distance(q, b);
  return squared_distance(q, a + (t / l) * ab);
}

// Whether the source of h can leave the curve that it lies on: between h's edge and exactly one other, almost on
// a line with both neighbors.
inline bool keeps_curve(const Remeshing_mesh& mesh, Remeshing_mesh::Index h, const Collapse_limits& limits)
{
  using Index = Remeshing_mesh::Index;
  const Index a = mesh.source(h), b = mesh.source(mesh.opposite(h));
  Index other = Remeshing_mesh::NO_VERTEX;
  int curve_edges = 0;
  Index last = -1;
  const auto count = [&](Index u, bool is_on_curve) {
    if (!is_on_curve) return;
    ++curve_edges;
    if (u != b) other = u;
  };
  mesh.for_each_around(a, [&](Index k) {
    count(mesh.target(k), mesh.is_on_curve_edge(k));
    last = k;
  });
  if (mesh.is_border_vertex(a)) count(mesh.apex(last), true);
  if (curve_edges != 2 || other < 0) return false;
  const Vector3 &from = mesh.position(b), &to = mesh.position(other);
  return squared_distance(from, to) <= limits.squared_length &&
         squared_distance_to_segment(mesh.position(a), from, to) <= limits.squared_deviation;
}

// Whether no new edge at h's target is too long. The neighbors of a free source other than the target and the two
// apexes, which the target has already, are met from the far side: there most collapses fail.
inline bool has_short_edges_after_collapse(const Remeshing_mesh& mesh, Remeshing_mesh::Index h,
                                           const Collapse_limits& limits)
{
  using Index = Remeshing_mesh::Index;
  const Index a = mesh.source(h);
  const Vector3& q = mesh.position(mesh.source(mesh.opposite(h)));
  const auto is_short = [&](Index k) {
    return squared_distance(q, mesh.position(mesh.target(k))) <= limits.squared_length;
  };
  if (!mesh.is_free(a)) return mesh.all_around(a, is_short);
  Index k = mesh.rotate_ccw(mesh.rotate_ccw(h));
  for (int n = mesh.valence(a) - 3; n > 0; --n, k = mesh.rotate_ccw(k))
    if (!is_short(k)) return false;
  return true;
}

// Whether the faces that replace the star of h's source are fit: no edge too long, no face turned, and one of them
// near the removed point. The last keeps tips and ridges.
inline bool is_collapse_fit(const Remeshing_mesh& mesh, Remeshing_mesh::Index h, const Collapse_limits& limits)
{
  using Index = Remeshing_mesh::Index;
  const Index a = mesh.source(h), b = mesh.source(mesh.opposite(h));
  const Vector3 p = mesh.position(a), q = mesh.position(b);
  if (!has_short_edges_after_collapse(mesh, h, limits)) return false;
  bool is_near = mesh.is_on_curve(a);     // what a curve may lose, keeps_curve() says
  const bool turns_no_face = mesh.all_around(a, [&](Index k) {
    const Index c = mesh.target(k), d = mesh.apex(k);
    if (c == b || d == b) return true;
    const Vector3 &r = mesh.position(c), &s = mesh.position(d);
    if (!is_cosine_at_least(triangle_cross(p, r, s), triangle_cross(q, r, s), COLLAPSE_NORMAL_COSINE)) return false;
    is_near = is_near || squared_distance(closest_point_on_triangle(p, q, r, s).point, p) <= limits.squared_tolerance;
    return true;
  });
  return turns_no_face && is_near;
}

// Whether none of the faces that replace the star of h's source turns its back on the surface.
template <class Context>
bool leaves_no_fold(const Context& context, Remeshing_mesh::Index h)
{
  const Remeshing_mesh& mesh = context.mesh;
  const Remeshing_mesh::Index a = mesh.source(h), b = mesh.source(mesh.opposite(h));
  return mesh.all_around(a, [&](Remeshing_mesh::Index k) {
    const Remeshing_mesh::Index c = mesh.target(k), d = mesh.apex(k);
    return c == b || d == b || !context.is_turned_over(b, c, d);
  });
}

// The half-edge whose source is to be merged into its target, for the edge of h; NO_COLLAPSE where neither may be.
constexpr Remeshing_mesh::Index NO_COLLAPSE = (std::numeric_limits<Remeshing_mesh::Index>::min)();

template <class Context>
Remeshing_mesh::Index choose_collapse(const Context& context, Remeshing_mesh::Index h, const Collapse_limits& limits)
{
  using Index = Remeshing_mesh::Index;
  const Remeshing_mesh& mesh = context.mesh;
  Index first = h, second = mesh.opposite(h);
  const Index a = mesh.source(first), b = mesh.source(second);
  if (mesh.valence(a) + mesh.valence(b) - 4 > limits.valence) return NO_COLLAPSE;
  if (mesh.valence(b) < mesh.valence(a)) std::swap(first, second);
  for (const Index k : {first, second}) {
    const bool is_along_curve = mesh.is_on_curve(mesh.source(k));
    if (is_along_curve && !(context.may_collapse_constraints && keeps_curve(mesh, k, limits))) continue;
    if (is_collapse_fit(mesh, k, limits) && mesh.is_collapse_legal(k) && leaves_no_fold(context, k) &&
        context.permits_collapse(k)) return k;
  }
  return NO_COLLAPSE;
}

// Collapses the edges of `short_edges` as far as they are still too short, and those that become so.
// Returns the number of collapses.
template <class ConcurrencyTag, class Context>
std::size_t collapse_pass(Context& context, std::vector<Remeshing_mesh::Index>& short_edges)
{
  using Index = Remeshing_mesh::Index;
  Remeshing_mesh& mesh = context.mesh;
  const double shortness = context.squared_shortness_limit();
  const double length = context.target_length;
  const auto squared = [](double x) { return x * x; };
  const Collapse_limits limits{context.squared_length_limit(), squared(context.recipe.collapse_tolerance * length),
                               squared(CURVE_TOLERANCE * length), MAXIMUM_MERGED_VALENCE};
  std::size_t collapses = 0;
  evaluate_then_apply<ConcurrencyTag>(mesh, short_edges,
    [&](Index h) -> Index {
      if (mesh.origin(h) < 0 || mesh.squared_edge_length(h) >= shortness) return NO_COLLAPSE;
      return choose_collapse(context, h, limits);
    },
    [&](Index, Index k) {
      if (k == NO_COLLAPSE) return;
      const Index kept = mesh.source(mesh.opposite(k));
      context.visitor.before_collapse(Mesh_halfedge(k), mesh);
      mesh.collapse(k);
      context.visitor.after_collapse(Mesh_vertex(kept), mesh);
      ++collapses;
      mesh.for_each_around(kept, [&](Index e) {
        if (mesh.squared_edge_length(e) < shortness) short_edges.push_back(e);
      });
    });
  return collapses;
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_COLLAPSE_PASS_H
