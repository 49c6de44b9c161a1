// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_FEATURE_GRAPH_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_FEATURE_GRAPH_H

#include <CGAL/Inter_angle_remeshing/internal/curves/curves.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/Remeshing_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// Edges that may be features, and the chains and components that they form. Border edges of the mesh count where chains
// meet them.
class Feature_graph
{
public:
  using Index = Remeshing_mesh::Index;

  struct Edge
  {
    Index halfedge;
    std::array<Index, 2> ends;
    double angle, length;              // degrees; units of the mesh
    bool is_left, is_certain, is_groove;
  };
  struct Chain
  {
    std::vector<Index> edges;                // one behind the other
    std::array<Index, 2> ends = {-1, -1};    // -1: closed
    int free_ends = 0;
    std::pair<bool, double> rank;            // has certain edges, weighted angle
  };

  // Lengths that are asked for are multiples of `length`.
  Feature_graph(const Remeshing_mesh& mesh, double length)
    : mesh_(mesh), length_(length), number_(mesh.number_of_vertex_slots(), -1)
  {}

  // Of these edges, whose angles do not matter.
  Feature_graph(const Remeshing_mesh& mesh, double length, const std::vector<Index>& edges)
    : Feature_graph(mesh, length)
  {
    for (const Index h : edges) add(h, 0);
  }

  // `turn`: by which the surface turns over the edge, in degrees, less than 0 in a groove; the sign matters to Narrow_strips alone. Edges
  // that are certain to be features are not dropped. Where lengths are others than `length`, that of the edge counts so many times.
  void add(Index h, double turn, bool is_certain = false, double times = 1)
  {
    const std::array<Index, 2> ends = {number_of(mesh_.origin(h)), number_of(mesh_.target(h))};
    for (const Index v : ends) {
      incident_[v].push_back(Index(edges_.size()));
      ++edges_left_[v];
    }
    edges_.push_back({h, ends, std::abs(turn), times * std::sqrt(mesh_.squared_edge_length(h)), true, is_certain, turn < 0});
  }

  // The half-edges of the edges that are left.
  std::vector<Index> edges() const
  {
    std::vector<Index> result;
    for (const Edge& e : edges_)
      if (e.is_left) result.push_back(e.halfedge);
    return result;
  }

  const Remeshing_mesh& mesh() const { return mesh_; }
  double length() const { return length_; }
  std::size_t number_of_edges() const { return edges_.size(); }
  std::size_t number_of_vertices() const { return vertices_.size(); }
  const Edge& edge(Index e) const { return edges_[e]; }
  Index other_end(Index e, Index v) const { return edges_[e].ends[0] == v ? edges_[e].ends[1] : edges_[e].ends[0]; }
  Vector3 vector_of(Index e) const { return position(edges_[e].ends[1]) - position(edges_[e].ends[0]); }
  const Vector3& position(Index v) const { return mesh_.position(vertices_[v]); }
  // How many edges are left at a vertex, with the border's and without.
  int degree(Index v) const { return edges_left_[v] + (mesh_.is_border_vertex(vertices_[v]) ? 2 : 0); }
  int edges_left(Index v) const { return edges_left_[v]; }
  // Calls `function(e)` for each edge left at a vertex.
  template <class Function>
  void for_each_incident(Index v, const Function& function) const
  {
    for (const Index e : incident_[v])
      if (edges_[e].is_left) function(e);
  }
  // Those at a vertex of the mesh, left or not.
  std::vector<Index> edges_at(Index vertex_of_mesh) const
  {
    const Index v = number_[vertex_of_mesh];
    return v >= 0 ? incident_[v] : std::vector<Index>();
  }
  // Whether v is not the middle of a smooth curve.
  bool bends(Index v) const;

  double length_of(const std::vector<Index>& edges) const
  {
    return std::accumulate(edges.begin(), edges.end(), 0., [&](double sum, Index e) { return sum + edges_[e].length; });
  }
  // The sum of the angles, or of the turns, over the edges, times their lengths.
  double weighted_angle(const std::vector<Index>& edges) const
  {
    return std::accumulate(edges.begin(), edges.end(), 0., [&](double sum, Index e) {
      return sum + edges_[e].length * edges_[e].angle; });
  }
  double weighted_turn(const std::vector<Index>& edges) const
  {
    return std::accumulate(edges.begin(), edges.end(), 0., [&](double sum, Index e) {
      return sum + edges_[e].length * (edges_[e].is_groove ? -1 : 1) * edges_[e].angle; });
  }
  double length_left() const
  {
    return std::accumulate(edges_.begin(), edges_.end(), 0., [](double sum, const Edge& e) { return sum + (e.is_left ? e.length : 0); });
  }
  // The vertices of these edges, each once.
  std::vector<Index> vertices_of(const std::vector<Index>& edges) const;
  std::vector<std::vector<Index>> components() const;
  std::vector<Chain> chains() const;
  // Those with certain edges first, then by the sum of their angles; of equal ones, the first.
  std::vector<Chain> chains_strongest_first() const;

  void take_out(Index e)
  {
    if (!edges_[e].is_left) return;
    edges_[e].is_left = false;
    for (const Index v : edges_[e].ends) --edges_left_[v];
  }
  // Those that are not certain.
  void drop(const std::vector<Index>& edges)
  {
    for (const Index e : edges)
      if (!edges_[e].is_certain) take_out(e);
  }
  // Drops edges with a free end until there is none.
  void drop_trees();
  // Drops components that are shorter than this and have fewer edges.
  void drop_short_components(double least_length, std::size_t least_edges = (std::numeric_limits<std::size_t>::max)())
  {
    drop_components_shorter_than([&](Index) { return least_length; }, least_edges);
  }
  // The same; `least_length(h)` is asked for one half-edge of each component.
  template <class Length>
  void drop_components_shorter_than(const Length& least_length, std::size_t least_edges)
  {
    for (const std::vector<Index>& component : components())
      if (component.size() < least_edges && length_of(component) < least_length(edges_[component.front()].halfedge) * length_)
        drop(component);
  }

private:
  Index number_of(Index v)
  {
    if (number_[v] < 0) {
      number_[v] = Index(vertices_.size());
      vertices_.push_back(v);
      incident_.emplace_back();
      edges_left_.push_back(0);
    }
    return number_[v];
  }
  bool has_certain_edge(const Chain& chain) const
  {
    return std::any_of(chain.edges.begin(), chain.edges.end(), [&](Index e) { return edges_[e].is_certain; });
  }

  void follow(Index e, int side, Chain& chain, std::vector<char>& is_passed) const;

  const Remeshing_mesh& mesh_;
  double length_;
  std::vector<Index> number_, vertices_;       // of the mesh's vertices here, and back
  std::vector<std::vector<Index>> incident_;   // by vertex: its edges
  std::vector<int> edges_left_;                // by vertex: how many of these are left
  std::vector<Edge> edges_;
};

inline std::vector<std::vector<Feature_graph::Index>> Feature_graph::components() const
{
  std::vector<std::vector<Index>> result;
  std::vector<char> is_passed(edges_.size(), 0), is_vertex_passed(vertices_.size(), 0);
  for (Index first = 0; first < Index(edges_.size()); ++first) {
    if (is_passed[first] || !edges_[first].is_left) continue;
    result.emplace_back(1, first);
    is_passed[first] = 1;
    for (std::size_t i = 0; i < result.back().size(); ++i)
      for (const Index v : edges_[result.back()[i]].ends) {
        if (is_vertex_passed[v]) continue;
        is_vertex_passed[v] = 1;
        for_each_incident(v, [&](Index e) {
          if (!is_passed[e]) result.back().push_back(e);
          is_passed[e] = 1;
        });
      }
  }
  return result;
}

// Goes on from the end `side` of edge e until the graph ends or branches.
inline void Feature_graph::follow(Index e, int side, Chain& chain, std::vector<char>& is_passed) const
{
  Index v = edges_[e].ends[side];
  for (;;) {
    const int d = degree(v);
    if (d != 2) {
      chain.ends[side] = v;
      chain.free_ends += d == 1;
      return;
    }
    Index following = -1;
    for_each_incident(v, [&](Index k) { if (!is_passed[k]) following = k; });
    if (following < 0) return;                 // around
    is_passed[following] = 1;
    chain.edges.push_back(following);
    v = other_end(following, v);
  }
}

inline std::vector<Feature_graph::Chain> Feature_graph::chains() const
{
  std::vector<Chain> result;
  std::vector<char> is_passed(edges_.size(), 0);
  for (Index e = 0; e < Index(edges_.size()); ++e) {
    if (is_passed[e] || !edges_[e].is_left) continue;
    is_passed[e] = 1;
    Chain chain;
    chain.edges.push_back(e);
    follow(e, 0, chain, is_passed);
    std::reverse(chain.edges.begin(), chain.edges.end());
    follow(e, 1, chain, is_passed);
    result.push_back(std::move(chain));
  }
  return result;
}

inline std::vector<Feature_graph::Chain> Feature_graph::chains_strongest_first() const
{
  std::vector<Chain> result = chains();
  for (Chain& chain : result) chain.rank = {has_certain_edge(chain), weighted_angle(chain.edges)};
  std::stable_sort(result.begin(), result.end(), [](const Chain& a, const Chain& b) { return a.rank > b.rank; });
  return result;
}

inline std::vector<Feature_graph::Index> Feature_graph::vertices_of(const std::vector<Index>& edges) const
{
  std::vector<Index> vertices;
  for (const Index e : edges) vertices.insert(vertices.end(), edges_[e].ends.begin(), edges_[e].ends.end());
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

inline bool Feature_graph::bends(Index v) const
{
  if (degree(v) != 2 || edges_left_[v] != 2) return true;
  std::array<Vector3, 2> directions;
  std::size_t n = 0;
  for_each_incident(v, [&](Index e) { directions[n++] = position(other_end(e, v)) - position(v); });
  return !is_cosine_at_least(directions[0], -1. * directions[1], CORNER_COSINE);
}

inline void Feature_graph::drop_trees()
{
  std::vector<Index> ends(vertices_.size());
  std::iota(ends.begin(), ends.end(), 0);
  while (!ends.empty()) {
    const Index v = ends.back();
    ends.pop_back();
    if (degree(v) != 1) continue;
    for_each_incident(v, [&](Index e) {
      take_out(e);
      ends.push_back(other_end(e, v));
    });
  }
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_FEATURE_GRAPH_H
