// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_PARALLEL_CHAINS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_PARALLEL_CHAINS_H

#include <CGAL/Inter_angle_remeshing/internal/features/Feature_graph.h>
#include <CGAL/Inter_angle_remeshing/internal/geometry/Point_grid.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/Remeshing_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// Chains of a graph that run beside each other, or beside themselves: there is no room for both.
class Parallel_chains
{
  using Index = Feature_graph::Index;
  using Chain = Feature_graph::Chain;

public:
  explicit Parallel_chains(Feature_graph& graph)
    : graph_(graph), mesh_(graph.mesh())
  {}

  // Strongest first, chains are accepted unless they run beside an accepted one, the border or themselves, or leave a vertex in
  // nearly the same direction as an accepted one.
  void drop()
  {
    Point_grid accepted(PARALLEL_DISTANCE * graph_.length());
    mesh_.for_each_halfedge([&](Index h) {
      if (mesh_.is_border(h))
        for_each_sample(mesh_.position(mesh_.origin(h)), mesh_.position(mesh_.target(h)),
                        [&](const Vector3& p) { accepted.insert(p); });
    });

    std::vector<std::vector<Vector3>> directions(graph_.number_of_vertices());     // of accepted chains
    for (const Chain& chain : graph_.chains_strongest_first()) {
      const std::vector<std::pair<Index, Vector3>> first = first_edges(chain);
      const std::vector<Vector3> points = samples(chain);
      const bool is_acute = std::any_of(first.begin(), first.end(), [&](const auto& f) {
        return std::any_of(directions[f.first].begin(), directions[f.first].end(), [&](const Vector3& d) {
          return is_cosine_at_least(d, f.second, ACUTE_COSINE); });
      });
      if (is_acute || runs_beside(chain, points, accepted) || runs_beside_itself(chain)) {
        graph_.drop(chain.edges);
        continue;
      }
      for (const auto& [v, d] : first) directions[v].push_back(d);
      for (const Vector3& p : points) accepted.insert(p);
    }
  }

  // Whether more than a quarter of a chain runs beside another part of it, as around a slit.
  bool runs_beside_itself(const Chain& chain) const
  {
    const double distance = PARALLEL_DISTANCE * graph_.length();
    const std::array<Index, 2>& first = graph_.edge(chain.edges.front()).ends;
    const auto has_end = [&](Index e, Index u) { return graph_.edge(e).ends[0] == u || graph_.edge(e).ends[1] == u; };
    Index v = chain.edges.size() == 1 || has_end(chain.edges[1], first[1]) ? first[0] : first[1];
    std::vector<std::pair<Vector3, double>> samples;          // with their arc lengths
    double arc_length = 0;
    for (const Index e : chain.edges) {
      const Vector3& p = graph_.position(v);
      v = graph_.other_end(e, v);
      for_each_sample(p, graph_.position(v), [&](const Vector3& q) { samples.emplace_back(q, arc_length + length(q - p)); });
      arc_length += graph_.edge(e).length;
    }
    Point_grid grid(distance);
    for (std::size_t i = 0; i < samples.size(); ++i) grid.insert(samples[i].first, int(i));
    std::size_t beside = 0;
    for (const auto& [p, s] : samples) {
      bool is_beside = false;
      const Vector3 reach{distance, distance, distance};
      grid.for_each_in_box(p - reach, p + reach, [&, &p = p, s = s](int i) {
        double along = std::abs(samples[i].second - s);
        if (chain.ends[0] < 0) along = (std::min)(along, arc_length - along);
        is_beside = is_beside || (along > ALONG * distance && squared_distance(samples[i].first, p) < distance * distance);
      });
      beside += is_beside;
    }
    return double(beside) > PARALLEL_SHARE * double(samples.size());
  }

private:
  // In lengths; the part of a chain that has to run beside others.
  static constexpr double PARALLEL_DISTANCE = 0.35, PARALLEL_SHARE = 0.25;
  static constexpr double ALONG = 3;                   // so many distances apart along it, parts of a chain count as two
  static constexpr double JUNCTION_RADIUS = 1.5;       // in such distances, within which chains that meet are near each other
  static constexpr double ACUTE_COSINE = 0.9063077870366499;      // 25 degrees

  // Calls `function(p)` for points on the segment from a to b that are less than the distance of parallel chains apart.
  template <class Function>
  void for_each_sample(const Vector3& a, const Vector3& b, const Function& function) const
  {
    constexpr double SPACING = 0.4;          // of that distance
    const int n = (std::max)(1, int(std::ceil(length(b - a) / (SPACING * PARALLEL_DISTANCE * graph_.length()))));
    for (int i = 0; i < n; ++i) function(a + ((i + 0.5) / n) * (b - a));
  }

  std::vector<Vector3> samples(const Chain& chain) const
  {
    std::vector<Vector3> result;
    for (const Index e : chain.edges)
      for_each_sample(graph_.position(graph_.edge(e).ends[0]), graph_.position(graph_.edge(e).ends[1]),
                      [&](const Vector3& p) { result.push_back(p); });
    return result;
  }

  // The first edges of a chain at its ends: vertex and direction.
  std::vector<std::pair<Index, Vector3>> first_edges(const Chain& chain) const
  {
    std::vector<std::pair<Index, Vector3>> result;
    for (const Index e : chain.edges)
      for (const Index v : graph_.edge(e).ends)
        if (v == chain.ends[0] || v == chain.ends[1]) result.emplace_back(v, graph_.position(graph_.other_end(e, v)) - graph_.position(v));
    return result;
  }

  // Whether more than a quarter of a chain runs beside `others`, not counting where it meets them.
  bool runs_beside(const Chain& chain, const std::vector<Vector3>& samples, const Point_grid& others) const
  {
    const double at_junction = JUNCTION_RADIUS * PARALLEL_DISTANCE * graph_.length();
    std::size_t looked_at = 0, beside = 0;
    for (const Vector3& p : samples) {
      const bool is_at_junction = std::any_of(chain.ends.begin(), chain.ends.end(), [&](Index v) {
        return v >= 0 && graph_.degree(v) > 1 && squared_distance(graph_.position(v), p) < at_junction * at_junction; });
      if (is_at_junction) continue;
      ++looked_at;
      beside += others.has_near(p, PARALLEL_DISTANCE * graph_.length());
    }
    return double(beside) > PARALLEL_SHARE * double(looked_at);
  }

  Feature_graph& graph_;
  const Remeshing_mesh& mesh_;
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_PARALLEL_CHAINS_H
