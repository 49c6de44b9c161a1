// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_CURVES_CORNERS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_CURVES_CORNERS_H

#include <CGAL/Inter_angle_remeshing/internal/curves/curves.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

// The corners of curves, which neither move nor go in a run: ends, junctions, and turns.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// No search along a curve looks at more vertices, whatever its reach.
constexpr int MAXIMUM_CURVE_STEPS = 1000;

// The vertex after u on the curve that comes from `previous`; negative where the curve ends or branches at u.
inline Remeshing_mesh::Index next_curve_vertex(const Remeshing_mesh& mesh, Remeshing_mesh::Index previous, Remeshing_mesh::Index u)
{
  Remeshing_mesh::Index following = -1;
  int edges = 0;
  for_each_curve_halfedge(mesh, u, [&](Remeshing_mesh::Index h) {
    const Remeshing_mesh::Index w = mesh.source(mesh.opposite(h));
    ++edges;
    if (w != previous) following = w;
  });
  return edges == 2 ? following : Remeshing_mesh::Index(-1);
}

// How far a curve is followed from a vertex to see whether it turns there at the scale of the result, how near, along a
// curve, a sharper turn may take the place of another one, and by how much the curve may leave that one out; in target lengths.
constexpr double CORNER_ARM = 0.5, CORNER_DISTANCE = 0.35, CORNER_TOLERANCE = 0.1;

// Walks from v over its curve neighbor u, over vertices where the curve goes on, until the way is `reach` or longer. Calls
// `function(a, b, way)` for the vertices of each edge and the way to b, as long as it returns true.
template <class Function>
void walk_along_curve(const Remeshing_mesh& mesh, Remeshing_mesh::Index v, Remeshing_mesh::Index u, double reach,
                      const Function& function)
{
  using Index = Remeshing_mesh::Index;
  Index previous = v;
  double way = 0;
  for (int step = 0; step < MAXIMUM_CURVE_STEPS && way < reach; ++step) {
    way += length(mesh.position(u) - mesh.position(previous));
    if (!function(previous, u, way)) return;
    const Index following = next_curve_vertex(mesh, previous, u);
    if (following < 0 || following == v) return;
    previous = u;
    u = following;
  }
}

// The way from v over its curve neighbor u to the first vertex that does not lie where v does.
struct Curve_arm
{
  Vector3 direction;
  bool passes_corner = false;    // whether one of the vertices that lie where v does is one
};

inline Curve_arm curve_arm(const Remeshing_mesh& mesh, const std::vector<char>& is_corner, Remeshing_mesh::Index v,
                           Remeshing_mesh::Index u)
{
  Curve_arm arm;
  walk_along_curve(mesh, v, u, std::numeric_limits<double>::infinity(), [&](Remeshing_mesh::Index, Remeshing_mesh::Index b, double) {
    arm.direction = mesh.position(b) - mesh.position(v);
    if (arm.direction != Vector3()) return false;
    arm.passes_corner = arm.passes_corner || is_corner[b];
    return true;
  });
  return arm;
}

// The way from v, in a straight line, to where its curve over u has come after `reach`, or to its end before.
inline Vector3 straight_arm(const Remeshing_mesh& mesh, Remeshing_mesh::Index v, Remeshing_mesh::Index u, double reach)
{
  Vector3 end = mesh.position(v);
  walk_along_curve(mesh, v, u, reach, [&](Remeshing_mesh::Index a, Remeshing_mesh::Index b, double way) {
    end = mesh.position(b);
    if (way > reach) end += ((way - reach) / length(mesh.position(a) - end)) * (mesh.position(a) - end);
    return true;
  });
  return end - mesh.position(v);
}

// A vertex at which a curve turns.
struct Turn
{
  Remeshing_mesh::Index vertex;
  double cosine;                         // 1: straight on
  Remeshing_mesh::Index neighbors[2];
  Vector3 arms[2];                       // straight ones, at the scale of the result
};

inline double cosine_of_turn(const Vector3& arm, const Vector3& other_arm)
{
  const double product = length(arm) * length(other_arm);
  return product > 0 ? -dot(arm, other_arm) / product : 1.;
}

// How many of these the edge of h is, each of which implies the one before: constrained, found, passing. Edges that differ in it are
// of different kinds.
inline unsigned curve_kind(const Remeshing_mesh& mesh, Remeshing_mesh::Index h)
{
  return unsigned(mesh.is_constrained(h)) + unsigned(mesh.has_flag(h, Remeshing_mesh::FOUND)) +
         unsigned(mesh.has_flag(h, Remeshing_mesh::PASSING));
}

// The corners, by vertex: where curves end or meet, where one begins to be another kind of edge, where a curve turns, and what is
// locked. Of several vertices at a turn that lie in the same place, one is a corner, so that the edges without length between
// them can go. A scale above 0, by vertex, says that curves may be jagged there: then those turns count that are turns at the scale
// of that length, too, and the sharpest of several that are close together. A turn is one whose cosine is under the given one.
inline std::vector<char> find_corners(const Remeshing_mesh& mesh, const std::vector<double>& scales,
                                      double corner_cosine = CORNER_COSINE)
{
  using Index = Remeshing_mesh::Index;
  std::vector<Turn> turns;
  std::vector<char> is_corner(mesh.number_of_vertex_slots(), 0), is_sharp_turn(mesh.number_of_vertex_slots(), 0);
  for (Index v = 0; v < Index(mesh.number_of_vertex_slots()); ++v) is_corner[v] = mesh.is_vertex(v) && mesh.is_locked(v);
  for (Index v = 0; v < Index(mesh.number_of_vertex_slots()); ++v) {
    if (!mesh.is_vertex(v) || !mesh.is_on_curve(v)) continue;
    int edges = 0;
    unsigned kinds[2] = {0, 0};
    Curve_arm arms[2];
    Turn turn{v, 1, {v, v}, {}};
    for_each_curve_halfedge(mesh, v, [&](Index h) {
      const Index u = mesh.source(mesh.opposite(h));
      if (edges < 2) {
        arms[edges] = curve_arm(mesh, is_corner, v, u);
        turn.neighbors[edges] = u;
        kinds[edges] = curve_kind(mesh, h < 0 ? ~h : h);
      }
      ++edges;
    });
    if (edges != 2 || kinds[0] != kinds[1]) {
      is_corner[v] = 1;
      continue;
    }
    if (arms[0].passes_corner || arms[1].passes_corner ||
        is_cosine_at_least(arms[0].direction, -1. * arms[1].direction, corner_cosine)) continue;
    const double scale = scales[v];
    if (!(scale > 0)) {
      is_corner[v] = 1;
      continue;
    }
    for (const int k : {0, 1}) turn.arms[k] = straight_arm(mesh, v, turn.neighbors[k], CORNER_ARM * scale);
    turn.cosine = cosine_of_turn(turn.arms[0], turn.arms[1]);
    if (turn.cosine < corner_cosine) turns.push_back(turn);
  }
  std::sort(turns.begin(), turns.end(), [](const Turn& a, const Turn& b) {
    return a.cosine != b.cosine ? a.cosine < b.cosine : a.vertex < b.vertex; });
  for (const Turn& turn : turns) {
    const Vector3& p = mesh.position(turn.vertex);
    const double scale = scales[turn.vertex];
    bool is_left_out = false;
    for (const int k : {0, 1})
      walk_along_curve(mesh, turn.vertex, turn.neighbors[k], CORNER_DISTANCE * scale, [&](Index, Index b, double way) {
        if (!is_sharp_turn[b] || way >= CORNER_DISTANCE * scale) return true;
        const double tolerance = CORNER_TOLERANCE * scale;
        is_left_out = is_left_out ||
                      squared_distance_to_segment(p, mesh.position(b), p + turn.arms[1 - k]) < tolerance * tolerance;
        return false;
      });
    if (is_left_out) continue;
    is_sharp_turn[turn.vertex] = 1;
    is_corner[turn.vertex] = 1;
  }
  return is_corner;
}

// Locks them.
inline void lock_corners(Remeshing_mesh& mesh, const std::vector<double>& scales)
{
  const std::vector<char> is_corner = find_corners(mesh, scales);
  for (Remeshing_mesh::Index v = 0; v < Remeshing_mesh::Index(is_corner.size()); ++v)
    if (is_corner[v]) mesh.add_marks(v, Remeshing_mesh::LOCKED);
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_CURVES_CORNERS_H
