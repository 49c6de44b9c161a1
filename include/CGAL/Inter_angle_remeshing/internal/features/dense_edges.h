// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_DENSE_EDGES_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_DENSE_EDGES_H

#include <CGAL/Inter_angle_remeshing/internal/features/Feature_graph.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// The edges from v over `first` to the next corner, end or junction; none if it is farther away than this.
inline std::vector<Feature_graph::Index> edges_up_to_corner(const Feature_graph& graph, Feature_graph::Index v,
                                                            Feature_graph::Index first, double distance)
{
  std::vector<Feature_graph::Index> result;
  double passed = 0;
  for (Feature_graph::Index e = first;;) {
    result.push_back(e);
    passed += graph.edge(e).length;
    if (passed > distance) return {};
    v = graph.other_end(e, v);
    if (graph.bends(v)) return result;
    graph.for_each_incident(v, [&, last = e](Feature_graph::Index k) { if (k != last) e = k; });
    if (e == first) return result;
  }
}

// Takes the edges out of which the density, in the order of adding, is greater than this, and of components that mainly consist of
// such edges those of half of it. Then what is ragged beside them: from where edges went, on to corners, ends and junctions at a
// short distance, and on from there where a good part of the component is such edges; and chains that now end after a few lengths.
inline void cut_out_dense_edges(Feature_graph& graph, const std::vector<double>& density, double largest)
{
  using Index = Feature_graph::Index;
  constexpr double RAGGED_LENGTH = 1.5;         // from corner to corner
  constexpr double SPREADING_SHARE = 0.2;       // of dense edges in components where what is ragged goes on
  constexpr double LEAST_REST = 3;              // of a chain, for each of its new ends
  std::vector<char> is_cut(graph.number_of_vertices(), 0), is_settled = is_cut;      // settled: looked at since the last cut
  std::vector<Index> cut;
  const auto cut_off = [&](Index e) {
    if (graph.edge(e).is_certain) return;
    graph.take_out(e);
    for (const Index v : graph.edge(e).ends) {
      is_cut[v] = 1;
      is_settled[v] = 0;
      cut.push_back(v);
    }
  };
  for (const std::vector<Index>& component : graph.components()) {
    const double dense = std::accumulate(component.begin(), component.end(), 0., [&](double sum, Index e) {
      return sum + (density[e] > largest ? graph.edge(e).length : 0); });
    const double all = graph.length_of(component), bound = dense > all / 2 ? largest / 2 : largest;
    const std::size_t first = cut.size();
    for (const Index e : component)
      if (density[e] > bound) cut_off(e);
    const std::size_t last = cut.size();
    for (std::size_t i = first; i < (dense > SPREADING_SHARE * all ? cut.size() : last); ++i) {
      const Index v = cut[i];
      if (is_settled[v]) continue;
      is_settled[v] = 1;
      if (graph.bends(v))
        graph.for_each_incident(v, [&](Index beside) {
          for (const Index e : edges_up_to_corner(graph, v, beside, RAGGED_LENGTH * graph.length())) cut_off(e);
        });
    }
  }
  for (const Feature_graph::Chain& chain : graph.chains()) {
    const auto new_ends = std::count_if(chain.ends.begin(), chain.ends.end(), [&](Index v) {
      return v >= 0 && is_cut[v] && graph.degree(v) == 1; });
    if (graph.length_of(chain.edges) < double(new_ends) * LEAST_REST * graph.length()) graph.drop(chain.edges);
  }
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_DENSE_EDGES_H
