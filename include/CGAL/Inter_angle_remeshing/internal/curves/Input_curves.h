// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_CURVES_INPUT_CURVES_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_CURVES_INPUT_CURVES_H

#include <CGAL/Inter_angle_remeshing/internal/curves/curves.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// The input's curves: polylines of border and feature edges from one locked vertex to the next, or closed, parametrised by
// arc length. What becomes of their edges slides, splits and collapses in that one dimension, and so stays on them. Where
// the surface is a smooth one, its curves are these, bent.
class Input_curves
{
public:
  using Index = Remeshing_mesh::Index;

  Input_curves() = default;
  // Follows the curves of a mesh whose corners are locked, and gives its curve edges their places.
  explicit Input_curves(Remeshing_mesh& mesh);

  // Bends the segments: `offsets(h)` tells for the half-edge h of a segment the offsets at its ends, as
  // Mls_surface::curve_offsets() does.
  template <class Offsets>
  void bend(const Offsets& offsets);

  // Whether an edge is less than this long that no collapse can make longer: from corner to corner; or one of a closed curve, which are
  // three or more, and whose chords, if it is a circle, lie no further from it than `tolerance`. What is there for the iterations alone
  // does not count.
  bool have_last_edges_under(double length, double tolerance) const
  {
    return std::any_of(curves_.begin(), curves_.end(), [&](const Curve& c) {
      const double last_edge = c.is_closed ? (std::min)(c.length / 3, std::sqrt(4 / CGAL_PI * tolerance * c.length)) : c.length;
      return !c.is_passing && last_edge < length;
    });
  }
  // The point at arc length t; on a closed curve t may be any number.
  Vector3 point(Index curve, double t) const;
  // A bound of the distance from the part of the curve between s and t to the segment from p to q, which lie there; a part of that where
  // the curve is jagged, and 0 where it is there for the iterations alone: these zigzag as the input's edges do.
  double deviation(Index curve, double s, double t, Vector3 p, Vector3 q) const;

private:
  // For .05 target lengths, the tolerance of curves, .5: the teeth of a seam are up to an edge high; and .3, as borders are looked at.
  static constexpr double JAGGED_SEAM = 10, JAGGED_BORDER = 6;

  struct Curve
  {
    std::size_t begin, end;          // of its points
    double length;
    bool is_closed;                  // its last point is its first one again
    bool is_passing;
    double leeway;                   // how many times as far as others it may lie from its chords
  };

  struct Bend { Vector3 at_begin, at_end; };

  void follow(Remeshing_mesh& mesh, Index v, Index h, std::vector<char>& is_passed);
  std::size_t guide_cell(const Curve& c, double t) const;
  std::size_t first_point_beyond(const Curve& c, double t) const;

  std::vector<Curve> curves_;
  std::vector<Vector3> points_;
  std::vector<double> arc_length_;   // by point, from the start of its curve
  std::vector<std::size_t> guide_;   // a curve of n points is cut into n equal cells: the first point beyond where each begins
  std::vector<Index> halfedge_;      // by point: of the segment that ends there, a border side perhaps
  std::vector<Bend> bends_;          // by point: of that segment; empty: segments are straight
};

// The half-edge, or border side, with which the curve goes on from the target of h; h itself where it ends there.
inline Remeshing_mesh::Index next_curve_halfedge(const Remeshing_mesh& mesh, Remeshing_mesh::Index h)
{
  const Remeshing_mesh::Index v = mesh.source(mesh.opposite(h)), back = mesh.opposite(h);
  Remeshing_mesh::Index result = h;
  if (!mesh.is_locked(v))
    for_each_curve_halfedge(mesh, v, [&](Remeshing_mesh::Index k) { if (k != back) result = k; });
  return result;
}

inline Input_curves::Input_curves(Remeshing_mesh& mesh)
{
  std::vector<char> is_passed(4 * mesh.number_of_face_slots(), 0);    // by the half-edge of an edge that is not a border side
  for (const bool from_locked : {true, false})
    for (Index v = 0; v < Index(mesh.number_of_vertex_slots()); ++v) {
      if (!mesh.is_on_curve(v) || mesh.is_locked(v) != from_locked) continue;
      std::vector<Index> leaving;
      for_each_curve_halfedge(mesh, v, [&](Index h) { leaving.push_back(h); });
      for (const Index h : leaving)
        if (!is_passed[h < 0 ? ~h : h]) follow(mesh, v, h, is_passed);
    }
}

// From v over the edge of h, to the next locked vertex or around.
inline void Input_curves::follow(Remeshing_mesh& mesh, Index v, Index h, std::vector<char>& is_passed)
{
  const Index curve = Index(curves_.size());
  const std::size_t begin = points_.size();
  points_.push_back(mesh.position(v));
  arc_length_.push_back(0);
  halfedge_.push_back(h);
  bool is_closed = false;
  for (Index k = h;;) {
    const Index u = mesh.source(mesh.opposite(k));
    const double s = arc_length_.back(), t = s + internal::length(mesh.position(u) - points_.back());
    points_.push_back(mesh.position(u));
    arc_length_.push_back(t);
    halfedge_.push_back(k);
    for (const Index side : {k, mesh.opposite(k)})
      if (side >= 0) is_passed[side] = 1;
    if (k >= 0) mesh.set_curve_place(k, {curve, s, t});
    else mesh.set_curve_place(~k, {curve, t, s});
    const Index following = next_curve_halfedge(mesh, k);
    if (following == k) break;
    if (u == v) { is_closed = true; break; }
    k = following;
  }
  const Index side = h < 0 ? ~h : h;
  curves_.push_back({begin, points_.size(), arc_length_.back(), is_closed, mesh.has_flag(side, Remeshing_mesh::PASSING),
                     !mesh.has_flag(side, Remeshing_mesh::JAGGED) ? 1. : mesh.is_border(side) ? JAGGED_BORDER : JAGGED_SEAM});
  const Curve& c = curves_.back();
  guide_.resize(points_.size());
  std::size_t cell = begin;
  for (std::size_t i = begin + 1; i < c.end; ++i)
    for (const std::size_t beyond = i + 1 < c.end ? guide_cell(c, arc_length_[i]) : c.end; cell < beyond; ++cell) guide_[cell] = i;
}

inline std::size_t Input_curves::guide_cell(const Curve& c, double t) const
{
  const std::size_t n = c.end - c.begin;
  return t > 0 ? c.begin + (std::min)(n - 1, std::size_t((std::min)(1., t / c.length) * double(n))) : c.begin;
}

// The first point, of those behind the first one of the curve, that lies beyond t; the last one if none does.
inline std::size_t Input_curves::first_point_beyond(const Curve& c, double t) const
{
  std::size_t i = guide_[guide_cell(c, t)];
  while (i > c.begin + 1 && arc_length_[i - 1] > t) --i;
  while (i + 1 < c.end && !(arc_length_[i] > t)) ++i;
  return i;
}

inline Vector3 Input_curves::point(Index curve, double t) const
{
  const Curve& c = curves_[curve];
  if (c.is_closed && (t < 0 || t >= c.length) && c.length > 0) t -= std::floor(t / c.length) * c.length;
  const std::size_t i = first_point_beyond(c, t);
  const double l = arc_length_[i] - arc_length_[i - 1];
  const double u = l > 0 ? (std::min)(1., (std::max)(0., (t - arc_length_[i - 1]) / l)) : 0.;
  const Vector3 straight = (1 - u) * points_[i - 1] + u * points_[i];
  if (bends_.empty()) return straight;
  return straight + (u * (1 - u)) * ((1 - u) * bends_[i].at_begin + u * bends_[i].at_end);
}

template <class Offsets>
void Input_curves::bend(const Offsets& offsets)
{
  bends_.resize(points_.size());
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Index h = halfedge_[i];
    const std::array<Vector3, 2> d = offsets(h < 0 ? ~h : h);
    bends_[i] = h < 0 ? Bend{d[1], d[0]} : Bend{d[0], d[1]};
  }
}

inline double Input_curves::deviation(Index curve, double s, double t, Vector3 p, Vector3 q) const
{
  if (s > t) { std::swap(s, t); std::swap(p, q); }
  const Curve& c = curves_[curve];
  if (c.is_passing) return 0;
  const double period = c.is_closed ? c.length : 0;
  double turns = period > 0 ? std::floor(s / period) * period : 0.;
  double largest = 0;
  for (std::size_t i = first_point_beyond(c, s - turns);; ++i) {
    if (i == c.end) {
      if (!(period > 0)) break;
      turns += period;
      i = c.begin + 1;
    }
    if (arc_length_[i] + turns >= t) break;
    largest = (std::max)(largest, squared_distance_to_segment(points_[i], p, q));
  }
  return std::sqrt(largest) / c.leeway;
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_CURVES_INPUT_CURVES_H
