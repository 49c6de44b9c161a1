// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_FEATURE_PRUNING_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_FEATURE_PRUNING_H

#include <CGAL/Inter_angle_remeshing/internal/features/Feature_graph.h>
#include <CGAL/Inter_angle_remeshing/internal/features/Parallel_chains.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// What is left of a graph of edges that may be features: what is long, sharp, leads somewhere, and has room.
class Feature_pruning
{
  using Index = Feature_graph::Index;
  using Chain = Feature_graph::Chain;

public:
  explicit Feature_pruning(Feature_graph& graph)
    : graph_(graph)
  {}

  // Keeps closed curves that meet no other, are sharp, hardly bend, do not run beside themselves, and are no shorter than this.
  void keep_rings(double least_length)
  {
    for (const Chain& chain : graph_.chains())
      if (chain.ends[0] >= 0 || chain.edges.size() < LEAST_EDGES || graph_.length_of(chain.edges) < least_length * graph_.length() ||
          !is_fit(chain.edges) || Parallel_chains(graph_).runs_beside_itself(chain)) graph_.drop(chain.edges);
  }

  // Keeps chains that lead somewhere, in components that are long, sharp, and not a tangle, and of two chains side by side
  // the stronger one. The creases of animals and folds of clothes end somewhere; the edges of a machine part hardly do.
  void prune()
  {
    for (int pass = 0; pass < 2; ++pass) drop_dangling_chains(STRONG_ANGLE);
    for (const std::vector<Index>& component : graph_.components())
      if (!is_fit(component)) graph_.drop(component);
    Parallel_chains(graph_).drop();
    drop_dangling_chains(0);
    for (const std::vector<Index>& component : graph_.components())
      if (component.size() < LEAST_EDGES ||
          graph_.length_of(component) < (std::max)(LEAST_COMPONENT, LENGTH_A_FREE_END * free_ends(component)) * graph_.length())
        graph_.drop(component);
  }

  // The same where the edges are known to be those of a part: the chains may be loose, and a tangle.
  void prune_part()
  {
    for (int pass = 0; pass < 2; ++pass) drop_dangling_chains(0);
    Parallel_chains(graph_).drop();
    drop_dangling_chains(0);
    graph_.drop_short_components(2 * DANGLING_LENGTH);
  }

private:
  static constexpr double STRONG_ANGLE = 45;
  static constexpr double DANGLING_LENGTH = 4, LEAST_COMPONENT = 5, LENGTH_A_FREE_END = 40;
  static constexpr std::size_t LEAST_EDGES = 12;       // the ring of fewer turns by 30 degrees at each
  static constexpr double LEAST_STRONG_SHARE = 0.5, LARGEST_BAD_SHARE = 0.25;

  void drop_dangling_chains(double least_angle)
  {
    for (const Chain& chain : graph_.chains()) {
      if (chain.free_ends == 0) continue;
      const double l = graph_.length_of(chain.edges);
      if (l < chain.free_ends * DANGLING_LENGTH * graph_.length() || graph_.weighted_angle(chain.edges) < least_angle * l)
        graph_.drop(chain.edges);
    }
  }

  // Whether most of a component is sharp, and it seldom bends and meets.
  bool is_fit(const std::vector<Index>& component) const
  {
    const double l = graph_.length_of(component);
    double strong = 0;
    for (const Index e : component)
      if (graph_.edge(e).angle >= STRONG_ANGLE) strong += graph_.edge(e).length;
    const std::vector<Index> vertices = graph_.vertices_of(component);
    const auto bad = std::count_if(vertices.begin(), vertices.end(), [&](Index v) { return graph_.bends(v); });
    return strong >= LEAST_STRONG_SHARE * l &&
           double(bad) <= LARGEST_BAD_SHARE * double(vertices.size());
  }

  int free_ends(const std::vector<Index>& component) const
  {
    int n = 0;
    for (const Index e : component)
      for (const Index v : graph_.edge(e).ends) n += graph_.degree(v) == 1;
    return n;
  }

  Feature_graph& graph_;
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_FEATURE_PRUNING_H
