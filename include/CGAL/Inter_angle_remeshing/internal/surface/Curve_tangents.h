// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_CURVE_TANGENTS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_CURVE_TANGENTS_H

#include <CGAL/Inter_angle_remeshing/internal/curves/curves.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/Reference_surface.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// The tangents at the vertices of polylines on a surface, which stand for curves: the border and features.
//
// At a vertex of a circle the tangent lies between the directions of the two edges, nearer to that of the shorter one. So it is taken
// elsewhere, too, but where a straight edge goes over into an arc: where the polyline bends at the other end of the shorter edge much more
// than at the vertex, that edge has the curvature there, and the longer one what is left of the turn. So it is, too, where the polyline has
// a corner there, if the edge is short enough to be a part of what rounds a corner off.
class Curve_tangents
{
public:
  using Index = Reference_surface::Index;

  // `surface` must outlive it.
  explicit Curve_tangents(const Reference_surface& surface) : surface_(surface), arms_(surface.number_of_vertices()) {}

  // An edge of a polyline, once; whether the surface beside it is flat.
  void add_edge(Index h, bool is_at_flat)
  {
    add_arm(surface_.origin(h), surface_.target(h), is_at_flat);
    add_arm(surface_.target(h), surface_.origin(h), is_at_flat);
  }

  bool is_on_curve(Index v) const { return arms_[v].count > 0; }

  // Of unit length; zero at corners, where polylines end or meet, and where one turns alone.
  Vector3 tangent(Index v) const
  {
    if (!is_smooth(v) || turns_alone(v)) return {};
    const Arms& a = arms_[v];
    const double way[2] = {length(arm(v, 0)), length(arm(v, 1))};
    double part[2] = {way[1], way[0]};                       // of the directions; those of a circle
    if (a.is_at_flat[0] != a.is_at_flat[1]) part[a.is_at_flat[0] ? 1 : 0] = 0;      // the one at the flat tells the tangent
    else {
      const int shorter = way[1] < way[0] ? 1 : 0;
      const double all = way[0] + way[1], rest = part_of_turn_left(v, shorter) * all;
      if (rest < part[shorter]) {
        part[shorter] = rest;
        part[1 - shorter] = all - rest;
      }
    }
    const Vector3 t = (part[1] / way[1]) * arm(v, 1) - (part[0] / way[0]) * arm(v, 0);
    return (1 / length(t)) * t;
  }

private:
  // A vertex that turns more than so many times as much as both of its neighbors turns alone: between vertices of a circle, however
  // they are spaced, one of these turns half as much, at least.
  static constexpr double ALONE = 4;
  // How many times as much as at a vertex a polyline bends at the next one where it goes over into an arc; more than two times: that is
  // what evenly spaced vertices tell, too, and the tangent of a circle serves there.
  static constexpr double MUCH_MORE = 2.1;
  // How many times as long as an edge that rounds a corner off the next one is.
  static constexpr double LONG = 3;

  struct Arms
  {
    int count = 0;
    Index neighbor[2] = {-1, -1};
    bool is_at_flat[2] = {false, false};
  };

  void add_arm(Index v, Index neighbor, bool is_at_flat)
  {
    Arms& a = arms_[v];
    if (a.count < 2) {
      a.neighbor[a.count] = neighbor;
      a.is_at_flat[a.count] = is_at_flat;
    }
    ++a.count;
  }

  Vector3 arm(Index v, int k) const { return surface_.position(arms_[v].neighbor[k]) - surface_.position(v); }

  bool is_smooth(Index v) const { return arms_[v].count == 2 && is_cosine_at_least(arm(v, 1), -1. * arm(v, 0), CORNER_COSINE); }

  // The difference of the directions before and behind v, where two edges meet.
  Vector3 turn(Index v) const { return arms_[v].count == 2 ? unit(arm(v, 0)) + unit(arm(v, 1)) : Vector3(); }

  double curvature(Index v) const
  {
    return arms_[v].count == 2 ? 2 * length(turn(v)) / (length(arm(v, 0)) + length(arm(v, 1))) : 0.;
  }

  bool turns_alone(Index v) const
  {
    const Vector3 t = turn(v);
    const auto turns_little = [&](Index u) { return !is_smooth(u) || ALONE * dot(turn(u), t) < squared_length(t); };
    return turns_little(arms_[v].neighbor[0]) && turns_little(arms_[v].neighbor[1]);
  }

  // What arm k of v, the shorter one, leaves of the turn at v if it is bent as at its other end; 1 where that does not bend much more, or
  // to another side.
  double part_of_turn_left(Index v, int k) const
  {
    const Index u = arms_[v].neighbor[k];
    const Vector3 t = turn(v);
    const double bend = curvature(u);
    const bool may_be_corner = LONG * length(arm(v, k)) < length(arm(v, 1 - k));
    if (!(may_be_corner || is_smooth(u)) || !(bend > MUCH_MORE * curvature(v)) || !(dot(turn(u), t) > 0)) return 1;
    return (std::max)(0., 1 - bend * length(arm(v, k)) / (2 * length(t)));
  }

  const Reference_surface& surface_;
  std::vector<Arms> arms_;           // by vertex
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_CURVE_TANGENTS_H
