// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_CURVES_JAGGED_CURVES_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_CURVES_JAGGED_CURVES_H

#include <CGAL/Inter_angle_remeshing/internal/curves/curves.h>
#include <CGAL/Inter_angle_remeshing/internal/exchange/constraints.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

// Seams are borders of patches where nothing else is marked. Labels of faces, as a segmentation puts them, leave them jagged: they zigzag
// from edge to edge, and go nearly straight over a few. That tells nothing about the object where the surface is smooth. So it is with the
// borders of scans, which end where the last whole triangle does, as soon as the target length is long beside their edges.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// The mean distance from a point of a polyline to the n-th one after it, over n.
inline double mean_step(const std::vector<Vector3>& points, std::size_t n)
{
  double sum = 0;
  for (std::size_t i = n; i < points.size(); ++i) sum += length(points[i] - points[i - n]);
  return sum / double(n * (points.size() - n));
}

// How many times as long as its course a polyline is that turns to and fro, 1 for others: from point to point it is longer than over every
// second one, but from those on hardly longer than over every fourth one, as a polyline that just turns would be.
inline double detour_of(const std::vector<Vector3>& points)
{
  constexpr std::size_t LEAST_POINTS = 8;        // of fewer, every fourth ones are too few to tell
  constexpr double STRAIGHT = 0.95;              // turns of 36 degrees; labels leave .3 to .9
  if (points.size() < LEAST_POINTS) return 1;
  const double by_one = mean_step(points, 1), by_two = mean_step(points, 2), by_four = mean_step(points, 4);
  const bool is_zigzag = by_two < STRAIGHT * by_one && by_four * by_one > by_two * by_two;
  return is_zigzag && by_four > 0 ? by_one / by_four : 1.;
}

// Finds the jagged seams and borders of a mesh whose corners are still to be found.
class Jagged_curves
{
  using Index = Remeshing_mesh::Index;

  // Where an edge is sharper than 30 degrees, its place says something about the object; seams are smooth along this part of their
  // length.
  static constexpr double SHARP_COSINE = 0.866025403784439, SMOOTH_SHARE = 0.9;
  // The mean edge of a jagged border is at most so many target lengths long; those of seams may be of any length.
  static constexpr double LONGEST_BORDER_EDGE = 0.4;
  // Of corners, in target lengths along the course.
  static constexpr double SCALE = 2.5;

public:
  // `has_designed_borders`: these are none.
  Jagged_curves(Remeshing_mesh& mesh, bool has_designed_borders)
    : mesh_(mesh), has_designed_borders_(has_designed_borders), is_passed_(4 * mesh.number_of_face_slots(), 0)
  {}

  // Marks them, and sets the scales of their corners, by vertex, for this target length.
  void mark(double target, std::vector<double>& scales)
  {
    for (Index h = 0; h < Index(is_passed_.size()); ++h) {
      if (!mesh_.is_face(h >> 2) || (h & 3) == 3 || !may_be_jagged(h) || is_passed_[h]) continue;
      const std::vector<Index> line = line_through(h);
      const double detour = tells_nothing(line, target) ? detour_of(points(line)) : 1.;
      if (!(detour > 1)) continue;
      for (const Index k : line) {
        mesh_.add_flags(side_with_face(k), Remeshing_mesh::JAGGED);
        for (const Index v : {mesh_.source(k), end_of(k)}) scales[v] = (std::max)(scales[v], SCALE * detour * target);
      }
    }
  }

private:
  // The half-edges of a line lead along it, those of a border on the border's side perhaps.
  Index side_with_face(Index h) const { return h < 0 ? ~h : h; }
  Index end_of(Index h) const { return mesh_.source(mesh_.opposite(h)); }

  bool may_be_jagged(Index h) const
  {
    const Index k = side_with_face(h);
    if (mesh_.is_protected(k)) return false;
    return mesh_.is_border(k) ? !has_designed_borders_ && !mesh_.is_constrained(k) : mesh_.has_flag(k, Remeshing_mesh::SEAM);
  }

  // The next edge of the line from the target of h; h itself at its end.
  Index following(Index h) const
  {
    const Index v = end_of(h), back = mesh_.opposite(h);
    if (mesh_.is_locked(v)) return h;
    Index next = h;
    int edges = 0;
    for_each_curve_halfedge(mesh_, v, [&](Index k) {
      ++edges;
      if (k != back) next = k;
    });
    const bool is_same_kind = mesh_.is_border(side_with_face(next)) == mesh_.is_border(side_with_face(h));
    return edges == 2 && is_same_kind && may_be_jagged(next) ? next : h;
  }

  // Its half-edges, from end to end.
  std::vector<Index> line_through(Index h)
  {
    Index first = mesh_.opposite(h);
    for (Index k = following(first); k != first && k != mesh_.opposite(h); k = following(first)) first = k;
    first = mesh_.opposite(first);
    std::vector<Index> result;
    for (Index k = first;;) {
      result.push_back(k);
      for (const Index side : {k, mesh_.opposite(k)})
        if (side >= 0) is_passed_[side] = 1;
      const Index next = following(k);
      if (next == k || next == first) return result;
      k = next;
    }
  }

  // Whether it tells nothing about the object, if it is jagged.
  bool tells_nothing(const std::vector<Index>& line, double target) const
  {
    double all = 0, smooth = 0;
    for (const Index h : line) {
      const double l = std::sqrt(mesh_.squared_edge_length(side_with_face(h)));
      all += l;
      smooth += is_sharp(mesh_, side_with_face(h), SHARP_COSINE) ? 0 : l;
    }
    if (mesh_.is_border(side_with_face(line.front()))) return all <= LONGEST_BORDER_EDGE * target * double(line.size());
    return smooth >= SMOOTH_SHARE * all;
  }

  std::vector<Vector3> points(const std::vector<Index>& line) const
  {
    std::vector<Vector3> result = {mesh_.position(mesh_.source(line.front()))};
    for (const Index h : line) result.push_back(mesh_.position(end_of(h)));
    return result;
  }

  Remeshing_mesh& mesh_;
  bool has_designed_borders_;
  std::vector<char> is_passed_;          // by half-edge
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_CURVES_JAGGED_CURVES_H
