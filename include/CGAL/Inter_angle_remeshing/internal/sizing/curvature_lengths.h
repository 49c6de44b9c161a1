// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_SIZING_CURVATURE_LENGTHS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_SIZING_CURVATURE_LENGTHS_H

#include <CGAL/Inter_angle_remeshing/internal/arguments/refuse.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/Remeshing_mesh.h>
#include <CGAL/Inter_angle_remeshing/internal/sizing/curvature.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <string>
#include <utility>
#include <vector>

// From the curvature of a surface to target edge lengths.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

inline void check_curvature_lengths(const char* caller, double tolerance, const std::pair<double, double>& range, double gradation)
{
  if (!(tolerance > 0) || !std::isfinite(tolerance))
    refuse(caller, "the tolerance is " + to_text(tolerance) + "; it must be finite and positive");
  if (!(range.first > 0 && range.first <= range.second) || !std::isfinite(range.second))
    refuse(caller, "the range of lengths is [" + to_text(range.first) + ", " + to_text(range.second) +
                   "]; it must be finite, positive and not empty");
  if (!(gradation > 0)) refuse(caller, "the gradation is " + to_text(gradation) + "; it must be positive");
}

// Lowers lengths that rise faster than by `slope` along edges; from the shortest one on, each vertex is settled once.
inline void bound_gradation(const Remeshing_mesh& mesh, double slope, std::vector<double>& lengths)
{
  using Entry = std::pair<double, Remeshing_mesh::Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  for (Remeshing_mesh::Index v = 0; v < Remeshing_mesh::Index(lengths.size()); ++v) queue.emplace(lengths[v], v);
  while (!queue.empty()) {
    const auto [l, v] = queue.top();
    queue.pop();
    if (l > lengths[v]) continue;
    mesh.for_each_neighbor(v, [&, l = l, v = v](Remeshing_mesh::Index u) {
      const double bound = l + slope * length(mesh.position(u) - mesh.position(v));
      if (!(bound < lengths[u])) return;
      lengths[u] = bound;
      queue.emplace(bound, u);
    });
  }
}

// At the vertices of a mesh whose features are marked; `tolerance`, the range and the result are in the user's units.
inline std::vector<double> curvature_lengths(const Remeshing_mesh& mesh, double tolerance, const std::pair<double, double>& range,
                                             double gradation)
{
  const double epsilon = tolerance / mesh.unit(), shortest = range.first / mesh.unit(), longest = range.second / mesh.unit();
  const auto length_at = [&](double curvature) {
    const double e = (std::min)(epsilon, 1 / curvature);     // no triangle is further from a sphere than its radius
    const double square = 3 * e * (2 / curvature - e);       // infinite where it is flat
    return square <= shortest * shortest ? shortest : (std::min)(longest, std::sqrt(square));
  };
  Curvature curvature(mesh);
  curvature.average([&](double k) { return 0.5 * length_at(k); });
  std::vector<double> result = curvature.at_vertices();
  for (double& x : result) x = length_at(x);
  bound_gradation(mesh, gradation, result);
  for (double& x : result) x = (std::max)(range.first, (std::min)(range.second, mesh.unit() * x));
  return result;
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_SIZING_CURVATURE_LENGTHS_H
