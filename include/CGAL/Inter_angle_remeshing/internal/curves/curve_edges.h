// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_CURVES_CURVE_EDGES_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_CURVES_CURVE_EDGES_H

#include <CGAL/Inter_angle_remeshing/internal/Remeshing_context.h>
#include <CGAL/Inter_angle_remeshing/internal/curves/Input_curves.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/parallel_blocks.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

// When an edge on a curve is too long, too short, or too far from the curve; and when a vertex may leave the curve.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// The chord of an edge may lie this far from the curve, in target lengths,
constexpr double CURVE_TOLERANCE = 0.05;
// unless the edge is shorter than this many target lengths: then the curve is too jagged to follow.
constexpr double SHORTEST_BENT_EDGE = 0.6;
// Where a face has all its vertices on curves, in a strip or a thin wall, its edge on one of these should be no longer than STRIP_ASPECT times
// its height. Where that is less than SHORT_IN_STRIP target lengths, the edge may be so long, but no longer than LARGEST_STRIP_ASPECT times
// the height. Strips thinner than THINNEST_STRIP target lengths are beyond help.
constexpr double STRIP_ASPECT = 1.6, LARGEST_STRIP_ASPECT = 2.2, SHORT_IN_STRIP = 0.2, THINNEST_STRIP = 0.05;

// Two curves that meet at less than 30 degrees: the cosine.
constexpr double ACUTE_CORNER_COSINE = 0.866025403784439;

// How wide the strip is of which the face of h is part, between the curve of h and another one; infinite where it is part of none. At the
// end of a strip a face has two edges on curves, at a corner that is neither acute nor nearly straight, and from its apex the curve turns
// back along the other side.
inline double width_of_strip(const Remeshing_mesh& mesh, Remeshing_mesh::Index h)
{
  using Index = Remeshing_mesh::Index;
  constexpr double NONE = std::numeric_limits<double>::infinity();
  const Vector3 &a = mesh.position(mesh.origin(h)), &b = mesh.position(mesh.target(h));
  const double l = length(b - a);
  if (!(l > 0) || !mesh.is_on_curve(mesh.apex(h))) return NONE;
  const auto height = [&](Index v) { return length(triangle_cross(a, b, mesh.position(v))) / l; };
  const Index next = mesh.next(h), prev = mesh.prev(h);
  const bool ends_at_target = mesh.is_on_curve_edge(next), ends_at_origin = mesh.is_on_curve_edge(prev);
  if (!ends_at_target && !ends_at_origin) return height(mesh.apex(h));
  if (ends_at_target && ends_at_origin) return NONE;
  const Vector3& c = mesh.position(mesh.apex(h));
  if (std::abs(corner_cosine(ends_at_target ? b : a, ends_at_target ? a : b, c)) > ACUTE_CORNER_COSINE) return NONE;
  const auto next_around_apex = [&](Index k) {
    return ends_at_target ? mesh.next(mesh.opposite(k)) : mesh.prev(mesh.opposite(k)); };
  Index k = next_around_apex(ends_at_target ? prev : next);
  while (!mesh.is_on_curve_edge(k)) k = next_around_apex(k);
  const Index beyond = ends_at_target ? mesh.target(k) : mesh.origin(k);
  return beyond == (ends_at_target ? mesh.target(h) : mesh.origin(h)) ? NONE : (std::max)(height(mesh.apex(h)), height(beyond));
}

// The target length of a curve edge.
inline double target_on_curve(const Remeshing_context& context, Remeshing_mesh::Index h)
{
  const Remeshing_mesh& mesh = context.mesh;
  const double wanted = context.length_at(mesh.origin(h), mesh.target(h));
  double target = wanted;
  for (const Remeshing_mesh::Index side : {h, mesh.opposite(h)}) {
    if (side < 0) continue;
    const double width = width_of_strip(mesh, side);
    if (width < THINNEST_STRIP * wanted) continue;
    target = (std::min)(target, std::clamp(SHORT_IN_STRIP * wanted, STRIP_ASPECT * width, LARGEST_STRIP_ASPECT * width));
  }
  return target;
}

inline bool is_at_end_of_strip(const Remeshing_context& context, Remeshing_mesh::Index h)
{
  const Remeshing_mesh& mesh = context.mesh;
  for (const Remeshing_mesh::Index side : {h, mesh.opposite(h)})
    if (side >= 0 && (mesh.is_on_curve_edge(mesh.next(side)) || mesh.is_on_curve_edge(mesh.prev(side))) &&
        STRIP_ASPECT * width_of_strip(mesh, side) < context.length_at(mesh.origin(h), mesh.target(h))) return true;
  return false;
}

// Whether a face beside the edge of h has another edge on a curve, and an acute angle between the two, which no remesher can change. The
// longer these edges, the wider is what lies behind the face.
inline bool is_at_acute_corner(const Remeshing_mesh& mesh, Remeshing_mesh::Index h)
{
  for (const Remeshing_mesh::Index side : {h, mesh.opposite(h)}) {
    if (side < 0) continue;
    const Vector3 &a = mesh.position(mesh.origin(side)), &b = mesh.position(mesh.target(side)), &c = mesh.position(mesh.apex(side));
    if ((mesh.is_on_curve_edge(mesh.next(side)) && corner_cosine(b, a, c) > ACUTE_CORNER_COSINE) ||
        (mesh.is_on_curve_edge(mesh.prev(side)) && corner_cosine(a, b, c) > ACUTE_CORNER_COSINE)) return true;
  }
  return false;
}

// The target length of the edge that two of a curve become: at an acute corner that of the one there, not of the strip behind it.
inline double target_of_merged_edge(const Remeshing_context& context, Remeshing_mesh::Index h, Remeshing_mesh::Index beyond)
{
  double least = std::numeric_limits<double>::infinity();
  for (const Remeshing_mesh::Index k : {h, beyond}) {
    const Remeshing_mesh::Index inside = k < 0 ? ~k : k;
    const double target = target_on_curve(context, inside);
    if (is_at_acute_corner(context.mesh, inside)) return target;
    least = (std::min)(least, target);
  }
  return least;
}

// How far the curve is from the edge of h.
inline double deviation_from_curve(const Remeshing_context& context, Remeshing_mesh::Index h)
{
  const Remeshing_mesh& mesh = context.mesh;
  const Remeshing_mesh::Curve_place place = mesh.curve_place(h);
  return context.curves.deviation(place.curve, place.origin, place.target, mesh.position(mesh.origin(h)),
                                  mesh.position(mesh.target(h)));
}

inline bool is_too_long_on_curve(const Remeshing_context& context, Remeshing_mesh::Index h)
{
  const double length = std::sqrt(context.mesh.squared_edge_length(h)),
               target = context.length_at(context.mesh.origin(h), context.mesh.target(h));
  return length > context.recipe.split_ratio * target_on_curve(context, h) ||
         (length > SHORTEST_BENT_EDGE * target && deviation_from_curve(context, h) > CURVE_TOLERANCE * target);
}

inline bool is_too_short_on_curve(const Remeshing_context& context, Remeshing_mesh::Index h)
{
  return std::sqrt(context.mesh.squared_edge_length(h)) < context.recipe.collapse_ratio * target_on_curve(context, h);
}

// How far the chords at a vertex that slides may lie from its curve, where the target length is this one.
inline double curve_tolerance(const Remeshing_context& context, double target_length)
{
  return context.keeps_vertices ? 0. : CURVE_TOLERANCE * target_length;
}

// Whether the source of h can leave the curve that it lies on: its two edges there become one, which must neither be too long
// nor leave the curve. The edge beyond it belongs to the same curve, as no vertex between two is without a lock.
inline bool keeps_curve(const Remeshing_context& context, Remeshing_mesh::Index h)
{
  using Index = Remeshing_mesh::Index;
  const Remeshing_mesh& mesh = context.mesh;
  if (!mesh.has_place(h)) return false;
  const Index a = mesh.source(h), b = mesh.source(mesh.opposite(h));
  Index beyond = h;
  for_each_curve_halfedge(mesh, a, [&](Index k) { if (k != h) beyond = k; });
  const Index u = mesh.source(mesh.opposite(beyond));
  if (beyond == h || u == b) return false;
  const Vector3 &p = mesh.position(b), &q = mesh.position(u);
  const double limit = context.recipe.split_ratio * target_of_merged_edge(context, h, beyond);
  if (squared_distance(p, q) > limit * limit) return false;
  const Remeshing_mesh::Curve_place removed = mesh.curve_place(h), rest = mesh.curve_place(beyond);
  return context.curves.deviation(removed.curve, removed.target, removed.origin + rest.target - rest.origin, p, q) <=
         CURVE_TOLERANCE * context.length_at(a);
}

// Whether v can leave its curve with an edge that is too short.
inline bool has_surplus_curve_edge(const Remeshing_context& context, Remeshing_mesh::Index v)
{
  bool result = false;
  for_each_curve_halfedge(context.mesh, v, [&](Remeshing_mesh::Index h) {
    result = result || (context.may_collapse_along_curve(h) && is_too_short_on_curve(context, h < 0 ? ~h : h) && keeps_curve(context, h));
  });
  return result;
}

// The point of the curve in the middle of the arc that the edge of h stands for.
inline Vector3 middle_on_curve(const Remeshing_context& context, Remeshing_mesh::Index h)
{
  const Remeshing_mesh::Curve_place place = context.mesh.curve_place(h);
  return context.curves.point(place.curve, 0.5 * (place.origin + place.target));
}

// One half-edge of each edge on a curve for which `is_wanted(h)` holds.
template <class ConcurrencyTag, class Predicate>
std::vector<Remeshing_mesh::Index> curve_edges_where(const Remeshing_context& context, const Predicate& is_wanted)
{
  using Index = Remeshing_mesh::Index;
  const Remeshing_mesh& mesh = context.mesh;
  std::vector<Index> found;
  if (!mesh.has_curves()) return found;
  scan_into<ConcurrencyTag>(found, mesh.number_of_face_slots(), [&](std::size_t f, std::vector<Index>& out) {
    if (!mesh.is_face(Index(f)) || mesh.face_record(Index(f)).edge_flags == 0) return;
    for (Index h = Index(4 * f); h < Index(4 * f) + 3; ++h)
      if (mesh.has_place(h) && (mesh.is_border(h) || mesh.opposite(h) > h) && is_wanted(h))
        out.push_back(h);
  });
  return found;
}

template <class ConcurrencyTag>
std::vector<Remeshing_mesh::Index> long_curve_edges(const Remeshing_context& context)
{
  return curve_edges_where<ConcurrencyTag>(context, [&](Remeshing_mesh::Index h) { return is_too_long_on_curve(context, h); });
}

// Whether the chord of an edge lies further from its curve than it may, be it short or long.
template <class ConcurrencyTag>
bool leaves_curves(const Remeshing_context& context)
{
  return !curve_edges_where<ConcurrencyTag>(context, [&](Remeshing_mesh::Index h) {
    return deviation_from_curve(context, h) > CURVE_TOLERANCE * context.target_length; }).empty();
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_CURVES_CURVE_EDGES_H
