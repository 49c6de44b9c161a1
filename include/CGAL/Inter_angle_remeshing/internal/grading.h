// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_GRADING_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_GRADING_H

#include <CGAL/Inter_angle_remeshing/internal/curves.h>

#include <algorithm>
#include <cmath>
#include <vector>

// Where curves have short edges, because details are small or strips narrow, the target length falls to theirs, and rises
// again with the distance.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// The target lengths of vertices, as parts of the target length of the run.
class Grading
{
public:
  using Index = Remeshing_mesh::Index;

  bool is_uniform() const { return part_.empty(); }
  // The target of an edge between u and v.
  double part(Index u, Index v) const { return 0.5 * (double(part(u)) + double(part(v))); }
  // A new vertex on an edge between u and v.
  void inherit(Index vertex, Index u, Index v)
  {
    if (is_uniform()) return;
    if (std::size_t(vertex) >= part_.size()) part_.resize(std::size_t(vertex) + 1, 1);
    part_[vertex] = float(part(u, v));
  }

  // Measures the curves' edges. `rate` is by how much the target rises over a unit of length.
  void measure(const Remeshing_mesh& mesh, double target_length, double rate)
  {
    part_.assign(mesh.number_of_vertex_slots(), 1);
    std::vector<Index> queue;
    for (Index v = 0; v < Index(part_.size()); ++v) {
      if (!mesh.is_vertex(v) || !mesh.is_on_curve(v) || mesh.is_locked(v)) continue;
      double sum = 0;
      int edges = 0;
      for_each_curve_halfedge(mesh, v, [&](Index h) {
        sum += std::sqrt(squared_distance(mesh.position(v), mesh.position(mesh.source(mesh.opposite(h)))));
        ++edges;
      });
      if (edges == 0) continue;
      part_[v] = float((std::min)(1., (std::max)(SMALLEST, CURVE_EDGE * sum / (edges * target_length))));
      if (part_[v] < 1) queue.push_back(v);
    }
    for (std::size_t i = 0; i < queue.size(); ++i) {
      const Index v = queue[i];
      mesh.for_each_neighbor(v, [&](Index u) {
        if (mesh.is_on_curve(u)) return;
        const double distance = length(mesh.position(u) - mesh.position(v)) / target_length;
        const float bound = float(double(part_[v]) + rate * distance);
        if (part_[u] <= bound * NOTICEABLE) return;
        part_[u] = bound;
        queue.push_back(u);
      });
    }
  }

private:
  // The target is a little longer than the mean curve edge, and at least this part of the target of the run.
  static constexpr double CURVE_EDGE = 1.05, SMALLEST = 0.3;
  // A vertex whose part falls by less need not be looked at again.
  static constexpr float NOTICEABLE = 1.01f;

  float part(Index v) const { return std::size_t(v) < part_.size() ? part_[v] : 1.f; }

  std::vector<float> part_;              // by vertex; empty: 1 everywhere
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_GRADING_H
