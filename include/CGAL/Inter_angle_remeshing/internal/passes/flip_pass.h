// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_FLIP_PASS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_FLIP_PASS_H

#include <CGAL/Inter_angle_remeshing/internal/Remeshing_context.h>
#include <CGAL/Inter_angle_remeshing/internal/geometry/thin_angles.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/regular_valence.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/evaluate_then_apply.h>

#include <algorithm>
#include <vector>

// Flips edges where that brings the valences nearer to 6, or to 4 on the border (Zheng and Lv, edge flipping).

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// Smallest cosine between the normal of a face that a flip makes and the sum of the two faces' normals: 45 degrees.
constexpr double FLIP_NORMAL_COSINE = 0.7;

// By how much a flip changes the sum of the squared valence deviations: two ends lose an edge, the apexes gain one.
inline int flip_gain(const Remeshing_mesh& mesh, Remeshing_mesh::Index h)
{
  const Remeshing_mesh::Index o = mesh.opposite(h);
  return 4 + 2 * (sector_deviation(mesh, mesh.prev(h)) + sector_deviation(mesh, mesh.prev(o)) -
                  sector_deviation(mesh, h) - sector_deviation(mesh, o));
}

// The squared sine of the smallest angle of the two faces at an edge, before and after a flip.
struct Smallest_angle_by_flip
{
  double before, after;
};

inline Smallest_angle_by_flip smallest_angle_by_flip(const Remeshing_mesh& mesh, Remeshing_mesh::Index h)
{
  const Remeshing_mesh::Index o = mesh.opposite(h);
  const Vector3 &a = mesh.position(mesh.origin(h)), &b = mesh.position(mesh.origin(o)), &c = mesh.position(mesh.apex(h)),
                &d = mesh.position(mesh.apex(o));
  return {(std::min)(squared_sine_of_smallest_angle(a, b, c), squared_sine_of_smallest_angle(b, a, d)),
          (std::min)(squared_sine_of_smallest_angle(a, d, c), squared_sine_of_smallest_angle(d, b, c))};
}

// Whether a flip makes the smallest angle of the two faces at once thin and smaller than it was.
inline bool makes_thin_angle_by_flip(const Remeshing_mesh& mesh, Remeshing_mesh::Index h)
{
  const Smallest_angle_by_flip angle = smallest_angle_by_flip(mesh, h);
  return makes_thin_angle(angle.before, angle.after);
}

// Whether the two faces that a flip makes look the same way as those that it takes away.
inline bool keeps_normals_by_flip(const Remeshing_mesh& mesh, Remeshing_mesh::Index h)
{
  const Remeshing_mesh::Index o = mesh.opposite(h);
  const Vector3 &a = mesh.position(mesh.origin(h)), &b = mesh.position(mesh.origin(o)), &c = mesh.position(mesh.apex(h)),
                &d = mesh.position(mesh.apex(o));
  const Vector3 sum = triangle_cross(a, b, c) + triangle_cross(b, a, d);
  return is_cosine_at_least(triangle_cross(a, d, c), sum, FLIP_NORMAL_COSINE) &&
         is_cosine_at_least(triangle_cross(d, b, c), sum, FLIP_NORMAL_COSINE);
}

// Whether a flip makes the smallest angle of the two faces larger by more than a rounding error.
inline bool widens_angle_by_flip(const Remeshing_mesh& mesh, Remeshing_mesh::Index h)
{
  constexpr double NOTICEABLE = 1.0001;
  const Smallest_angle_by_flip angle = smallest_angle_by_flip(mesh, h);
  return angle.after > NOTICEABLE * angle.before;
}

inline bool is_flip_fit(const Remeshing_mesh& mesh, Remeshing_mesh::Index h)
{
  if (!keeps_normals_by_flip(mesh, h)) return false;
  const Remeshing_mesh::Index o = mesh.opposite(h);
  const Remeshing_mesh::Index v[4] = {mesh.origin(h), mesh.origin(o), mesh.apex(h), mesh.apex(o)};
  const Vector3 &a = mesh.position(v[0]), &b = mesh.position(v[1]), &c = mesh.position(v[2]), &d = mesh.position(v[3]);
  if (std::none_of(v, v + 4, [&](Remeshing_mesh::Index u) { return mesh.is_on_curve(u); })) return true;
  // An edge that leads across a strip is not to make way for one along its middle, with flat faces on both sides.
  constexpr double LONGER = 1.4;
  if (mesh.is_on_curve(v[0]) && mesh.is_on_curve(v[1]) && !mesh.is_on_curve(v[2]) && !mesh.is_on_curve(v[3]) &&
      squared_distance(c, d) > LONGER * LONGER * squared_distance(a, b)) return false;
  // At an end the flip leaves one face where there were two; between two curve edges it may be too wide.
  const auto is_wide = [&](const Vector3& p, const Vector3& q, const Vector3& r, Remeshing_mesh::Index k) {
    return mesh.is_on_curve_edge(k) && corner_cosine(p, q, r) < CURVE_CORNER_COSINE;
  };
  if ((mesh.is_on_curve_edge(mesh.prev(h)) && is_wide(a, c, d, mesh.next(o))) ||
      (mesh.is_on_curve_edge(mesh.next(h)) && is_wide(b, c, d, mesh.prev(o)))) return false;
  return !makes_thin_angle_by_flip(mesh, h);
}

// Whether a flip of the edge of h makes a face that turns its back on the surface, where neither of the two did. Where
// no face turns far, the surface need not be asked.
inline bool makes_fold_by_flip(const Remeshing_context& context, Remeshing_mesh::Index h)
{
  const Remeshing_mesh& mesh = context.mesh;
  const Remeshing_mesh::Index o = mesh.opposite(h);
  const Remeshing_mesh::Index a = mesh.origin(h), b = mesh.origin(o), c = mesh.apex(h), d = mesh.apex(o);
  const auto cross_product = [&](Remeshing_mesh::Index u, Remeshing_mesh::Index v, Remeshing_mesh::Index w) {
    return triangle_cross(mesh.position(u), mesh.position(v), mesh.position(w));
  };
  const Vector3 sum = cross_product(a, b, c) + cross_product(b, a, d);
  if (is_cosine_at_least(cross_product(a, d, c), sum, LITTLE_TURN_COSINE) &&
      is_cosine_at_least(cross_product(d, b, c), sum, LITTLE_TURN_COSINE)) return false;
  return (context.is_turned_over(a, d, c) || context.is_turned_over(d, b, c)) &&
         !context.is_turned_over(a, b, c) && !context.is_turned_over(b, a, d);
}

// Whether sweeps move the two faces: at most one of their corners is held, curves apart, whose vertices have sweeps and rules of their own.
inline bool may_faces_move(const Remeshing_mesh& mesh, Remeshing_mesh::Index h)
{
  const Remeshing_mesh::Index o = mesh.opposite(h);
  int held_ones = 0;
  for (const Remeshing_mesh::Index v : {mesh.origin(h), mesh.origin(o), mesh.apex(h), mesh.apex(o)}) held_ones += mesh.is_held_inside(v);
  return held_ones <= 1;
}

// Where corners are held, no sweep mends an angle that a flip makes smaller.
inline bool is_flip_allowed(const Remeshing_context& context, Remeshing_mesh::Index h, bool is_transient)
{
  const Remeshing_mesh& mesh = context.mesh;
  return mesh.is_flip_legal(h) && is_flip_fit(mesh, h) && !makes_fold_by_flip(context, h) &&
         (may_faces_move(mesh, h) || widens_angle_by_flip(mesh, h)) && context.permits_flip(h, is_transient);
}

inline void flip(Remeshing_context& context, Remeshing_mesh::Index h)
{
  Remeshing_mesh& mesh = context.mesh;
  context.visitor.before_flip(Mesh_halfedge(h), mesh);
  mesh.flip(h);
  context.visitor.after_flip(Mesh_halfedge(mesh.next(h)), mesh);
}

// Whether a flip pays. Sweeps turn regular valences into good angles; where none follow, or vertices may not move as they want to, it is
// the angles themselves that count.
inline bool does_flip_pay(const Remeshing_context& context, Remeshing_mesh::Index h)
{
  const Remeshing_mesh& mesh = context.mesh;
  if (mesh.is_on_curve_edge(h)) return false;
  return context.moves_freely() && may_faces_move(mesh, h) ? flip_gain(mesh, h) < 0 : widens_angle_by_flip(mesh, h);
}

// Half-edges whose flip would pay the valences: it takes an edge from a vertex of too many, or gives one to a vertex that lacks two. At a
// curve each of the sectors may have too many or too few.
inline void find_flips_for_valences(const Remeshing_mesh& mesh, Remeshing_mesh::Index v, std::vector<Remeshing_mesh::Index>& found)
{
  using Index = Remeshing_mesh::Index;
  const auto look_at = [&](Index h) { if (!mesh.is_on_curve_edge(h) && flip_gain(mesh, h) < 0) found.push_back(h); };
  if (mesh.is_on_curve(v))
    for_each_sector(mesh, v, [&](Index h, int faces, int deviation) {
      if (deviation > -2 && deviation < 1) return;
      for (; faces > 0; --faces, h = mesh.rotate_ccw(h)) look_at(deviation >= 1 ? h : mesh.next(h));
    });
  else if (mesh.deviation(v) >= 1)
    mesh.for_each_around(v, look_at);
  else if (mesh.deviation(v) <= -2)
    mesh.for_each_around(v, [&](Index h) {       // an end with too many edges finds it by itself
      const Index e = mesh.next(h);
      if (mesh.deviation(mesh.origin(e)) <= 0 && mesh.deviation(mesh.target(e)) <= 0) look_at(e);
    });
}

// Half-edges around v, and opposite to it, whose flip would pay.
inline void find_paying_flips(const Remeshing_context& context, Remeshing_mesh::Index v, std::vector<Remeshing_mesh::Index>& found)
{
  const Remeshing_mesh& mesh = context.mesh;
  if (context.moves_freely()) find_flips_for_valences(mesh, v, found);
  if (context.moves_freely() && !mesh.is_held_inside(v)) return;
  mesh.for_each_around(v, [&](Remeshing_mesh::Index h) {
    for (const Remeshing_mesh::Index k : {h, mesh.next(h)})
      if (does_flip_pay(context, k)) found.push_back(k);
  });
}

// Whether a flip in a strip one face wide, between curves, makes the edge across it longer.
inline bool leans_over_by_flip(const Remeshing_mesh& mesh, Remeshing_mesh::Index h)
{
  if (mesh.is_on_curve_edge(h)) return false;
  const Remeshing_mesh::Index o = mesh.opposite(h), a = mesh.origin(h), b = mesh.origin(o), c = mesh.apex(h), d = mesh.apex(o);
  return mesh.is_on_curve(a) && mesh.is_on_curve(b) && mesh.is_on_curve(c) && mesh.is_on_curve(d) &&
         squared_distance(mesh.position(c), mesh.position(d)) > squared_distance(mesh.position(a), mesh.position(b));
}

// Flips the edges of `candidates` that pay. Returns the number of flips. The sectors have been measured.
//
// In a strip of one face's width two flips may serve the valences alike, and no sweep mends the lean that one of them leaves: those that
// shorten the edges across it come first.
template <class ConcurrencyTag>
std::size_t flip_pass(Remeshing_context& context, std::vector<Remeshing_mesh::Index>& candidates)
{
  using Index = Remeshing_mesh::Index;
  Remeshing_mesh& mesh = context.mesh;
  std::size_t flips = 0;
  std::stable_partition(candidates.begin(), candidates.end(), [&](Index h) { return !leans_over_by_flip(mesh, h); });
  evaluate_then_apply<ConcurrencyTag>(mesh, candidates,
    [&](Index h) -> bool {
      return does_flip_pay(context, h) && is_flip_allowed(context, h, false);
    },
    [&](Index h, bool is_to_flip) {
      if (!is_to_flip) return;
      flip(context, h);
      ++flips;
    });
  return flips;
}

// The same for all edges.
template <class ConcurrencyTag>
std::size_t flip_pass(Remeshing_context& context)
{
  using Index = Remeshing_mesh::Index;
  const Remeshing_mesh& mesh = context.mesh;
  std::vector<Index> candidates;
  scan_into<ConcurrencyTag>(candidates, mesh.number_of_vertex_slots(), [&](std::size_t v, std::vector<Index>& found) {
    if (mesh.is_vertex(Index(v))) find_paying_flips(context, Index(v), found);
  });
  return flip_pass<ConcurrencyTag>(context, candidates);
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_FLIP_PASS_H
