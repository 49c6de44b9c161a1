// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_JAGGED_SEAMS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_JAGGED_SEAMS_H

#include <CGAL/Inter_angle_remeshing/internal/constraints.h>
#include <CGAL/Inter_angle_remeshing/internal/curves.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

// Seams are borders of patches where nothing else is marked. Labels of faces, as a segmentation puts them, leave them jagged: they zigzag
// from edge to edge, and go nearly straight over a few. That tells nothing about the object where the surface is smooth.

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

// Finds the jagged seams of a mesh whose corners are still to be found.
class Jagged_seams
{
  using Index = Remeshing_mesh::Index;

  // Where an edge is sharper than 30 degrees, its place says something about the object; seams are smooth along this part of their
  // length.
  static constexpr double SHARP_COSINE = 0.866025403784439, SMOOTH_SHARE = 0.9;
  // Of corners, in target lengths along the course.
  static constexpr double SCALE = 2.5;

public:
  explicit Jagged_seams(Remeshing_mesh& mesh) : mesh_(mesh), is_passed_(4 * mesh.number_of_face_slots(), 0) {}

  // Marks them, and sets the scales of their corners, by vertex, for this target length.
  void mark(double target, std::vector<double>& scales)
  {
    for (Index h = 0; h < Index(is_passed_.size()); ++h) {
      if (!mesh_.is_face(h >> 2) || (h & 3) == 3 || !is_seam(h) || is_passed_[h]) continue;
      const std::vector<Index> seam = seam_through(h);
      const double detour = is_smooth(seam) ? detour_of(points(seam)) : 1.;
      if (!(detour > 1)) continue;
      for (const Index k : seam) {
        mesh_.add_flags(k, Remeshing_mesh::JAGGED);
        for (const Index v : {mesh_.origin(k), mesh_.target(k)}) scales[v] = (std::max)(scales[v], SCALE * detour * target);
      }
    }
  }

private:
  bool is_seam(Index h) const { return h >= 0 && mesh_.has_flag(h, Remeshing_mesh::SEAM) && !mesh_.is_protected(h); }

  // The next edge of the seam from the target of h; h itself at its end.
  Index following(Index h) const
  {
    const Index v = mesh_.target(h), back = mesh_.opposite(h);
    if (mesh_.is_locked(v)) return h;
    Index next = h;
    int edges = 0;
    for_each_curve_halfedge(mesh_, v, [&](Index k) {
      ++edges;
      if (k != back) next = k;
    });
    return edges == 2 && is_seam(next) ? next : h;
  }

  // Its half-edges, from end to end.
  std::vector<Index> seam_through(Index h)
  {
    Index first = mesh_.opposite(h);
    for (Index k = following(first); k != first && k != mesh_.opposite(h); k = following(first)) first = k;
    first = mesh_.opposite(first);
    std::vector<Index> result;
    for (Index k = first;;) {
      result.push_back(k);
      is_passed_[k] = is_passed_[mesh_.opposite(k)] = 1;
      const Index next = following(k);
      if (next == k || next == first) return result;
      k = next;
    }
  }

  bool is_smooth(const std::vector<Index>& seam) const
  {
    double all = 0, smooth = 0;
    for (const Index h : seam) {
      const double l = std::sqrt(mesh_.squared_edge_length(h));
      all += l;
      smooth += is_sharp(mesh_, h, SHARP_COSINE) ? 0 : l;
    }
    return smooth >= SMOOTH_SHARE * all;
  }

  std::vector<Vector3> points(const std::vector<Index>& seam) const
  {
    std::vector<Vector3> result = {mesh_.position(mesh_.origin(seam.front()))};
    for (const Index h : seam) result.push_back(mesh_.position(mesh_.target(h)));
    return result;
  }

  Remeshing_mesh& mesh_;
  std::vector<char> is_passed_;          // by half-edge
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_JAGGED_SEAMS_H
