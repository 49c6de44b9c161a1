// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_OUTSTANDING_EDGES_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_OUTSTANDING_EDGES_H

#include <CGAL/Inter_angle_remeshing/internal/features/Face_normals.h>
#include <CGAL/Inter_angle_remeshing/internal/features/Feature_graph.h>
#include <CGAL/Inter_angle_remeshing/internal/features/Model_kind.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// The edges of a model that is no CAD model which stand out of their surroundings when normals are filtered: bilaterally, around
// connected edges that are sharp over some length.
class Outstanding_edges
{
  using Index = Remeshing_mesh::Index;

  // A candidate is this many times as sharp as three of the four other edges of its faces, before the filter.
  static constexpr double CANDIDATE_RATIO = 2.5;
  static constexpr double LEAST_CANDIDATE_LENGTH = 4;   // of connected candidates, in lengths
  static constexpr int RINGS = 2;                       // around candidates that are filtered
  static constexpr int BILATERAL_PASSES = 5;
  static constexpr double NORMAL_DEVIATION = 0.35;      // σ of the filter's weights, as a distance of unit normals
  // An edge stands out when it is this many times as sharp as the median of the edges around it.
  static constexpr double OUTSTANDING = 3;

public:
  // `sharp_edges` are those before the filter.
  Outstanding_edges(Face_normals& normals, double own_length, const std::vector<Index>& sharp_edges)
    : normals_(normals), mesh_(normals.mesh())
  {
    find_active_faces(own_length, sharp_edges);
  }

  // Whether there is nothing to filter.
  bool are_none() const { return active_.empty(); }

  // Filters the normals. Returns the edges in order.
  std::vector<Index> find()
  {
    for (int pass = 0; pass < BILATERAL_PASSES; ++pass) filter_normals();
    noise_.assign(mesh_.number_of_vertex_slots(), -1);
    std::vector<Index> found;
    const double least = cosine_of_degrees(Model_kind::LEAST_ANGLE);
    for (const Index f : active_)
      for (Index h = 4 * f; h < 4 * f + 3; ++h)
        if (mesh_.opposite(h) > h && is_active_[mesh_.opposite(h) >> 2] && normals_.cosine(h) <= least &&
            normals_.angle(h) >= OUTSTANDING * 0.5 * (mean_noise(mesh_.origin(h)) + mean_noise(mesh_.target(h))))
          found.push_back(h);
    std::sort(found.begin(), found.end());
    return found;
  }

private:
  bool is_candidate(Index h) const
  {
    const Index o = mesh_.opposite(h);
    double around[4] = {normals_.cosine(mesh_.next(h)), normals_.cosine(mesh_.prev(h)), normals_.cosine(mesh_.next(o)),
                        normals_.cosine(mesh_.prev(o))};
    std::sort(around, around + 4);
    return around[1] >= std::cos(std::acos((std::max)(-1., normals_.cosine(h))) / CANDIDATE_RATIO);
  }

  // Some rings around connected candidates.
  void find_active_faces(double own_length, const std::vector<Index>& sharp_edges)
  {
    Feature_graph candidates(mesh_, own_length);
    for (const Index h : sharp_edges)
      if (is_candidate(h)) candidates.add(h, 0);
    candidates.drop_short_components(LEAST_CANDIDATE_LENGTH);

    std::vector<char> is_reached(mesh_.number_of_vertex_slots(), 0);
    std::vector<Index> front;
    const auto reach = [&](Index v, std::vector<Index>& reached) {
      if (is_reached[v]) return;
      is_reached[v] = 1;
      reached.push_back(v);
    };
    for (const Index h : candidates.edges()) {
      reach(mesh_.origin(h), front);
      reach(mesh_.target(h), front);
    }
    is_active_.assign(mesh_.number_of_face_slots(), 0);
    for (int ring = 0; ring < RINGS; ++ring) {
      std::vector<Index> next;
      for (const Index v : front)
        mesh_.for_each_around(v, [&](Index h) {
          if (!is_active_[h >> 2]) {
            is_active_[h >> 2] = 1;
            active_.push_back(h >> 2);
          }
          reach(mesh_.target(h), next);
          reach(mesh_.apex(h), next);
        });
      front.swap(next);
    }
  }

  void filter_normals()
  {
    std::vector<Vector3> filtered;
    filtered.reserve(active_.size());
    for (const Index f : active_) filtered.push_back(normals_[f] == Vector3() ? Vector3() : filtered_normal(f));
    for (std::size_t i = 0; i < active_.size(); ++i) normals_.set(active_[i], filtered[i]);
  }

  // The mean of the normals around, by area, and the less the more they differ: flat parts grow flat, edges stay. Faces that
  // share an edge with f count twice.
  Vector3 filtered_normal(Index f) const
  {
    const Vector3& n = normals_[f];
    Vector3 sum;
    for (Index h = 4 * f; h < 4 * f + 3; ++h)
      mesh_.for_each_around(mesh_.origin(h), [&](Index k) {
        const Vector3& m = normals_[k >> 2];
        const double x = squared_distance(m, n) / (2 * NORMAL_DEVIATION * NORMAL_DEVIATION);
        const double t = (std::max)(0., 1 - x / 8), t2 = t * t, t4 = t2 * t2;       // t⁸, nearly exp(-x)
        sum += (t4 * t4 * normals_.doubled_area(k >> 2)) * m;
      });
    const double l = length(sum);
    return l > 0 ? (1 / l) * sum : n;
  }

  // The median, by length, of the dihedral angles at v and around its star, the two sharpest at v left out.
  double noise(Index v)
  {
    if (noise_[v] >= 0) return noise_[v];
    std::vector<std::pair<double, double>> spokes, all;     // angle and length
    const auto entry = [&](Index h) { return std::make_pair(normals_.angle(h), std::sqrt(mesh_.squared_edge_length(h))); };
    mesh_.for_each_around(v, [&](Index h) {
      if (!mesh_.is_border(h)) spokes.push_back(entry(h));
      if (!mesh_.is_border(mesh_.next(h))) all.push_back(entry(mesh_.next(h)));
    });
    std::sort(spokes.rbegin(), spokes.rend());
    if (spokes.size() > 2) all.insert(all.end(), spokes.begin() + 2, spokes.end());
    std::sort(all.begin(), all.end());
    double total = 0, passed = 0, median = 0;
    for (const auto& [a, l] : all) total += l;
    for (const auto& [a, l] : all) {
      passed += l;
      median = a;
      if (passed >= total / 2) break;
    }
    return noise_[v] = float(median);
  }

  double mean_noise(Index v)
  {
    double sum = noise(v);
    int n = 1;
    mesh_.for_each_neighbor(v, [&](Index u) { sum += noise(u); ++n; });
    return sum / n;
  }

  Face_normals& normals_;
  const Remeshing_mesh& mesh_;
  std::vector<Index> active_;          // the faces that the filter looks at
  std::vector<char> is_active_;
  std::vector<float> noise_;           // by vertex, degrees; negative: not known yet
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_OUTSTANDING_EDGES_H
