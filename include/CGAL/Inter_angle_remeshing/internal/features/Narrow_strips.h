// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_NARROW_STRIPS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_NARROW_STRIPS_H

#include <CGAL/Inter_angle_remeshing/internal/features/Feature_graph.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/Remeshing_mesh.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// Chains of a graph that are the sides of strips of faces too narrow for good triangles.
class Narrow_strips
{
  using Index = Feature_graph::Index;
  using Chain = Feature_graph::Chain;
  using Edge = Feature_graph::Edge;

public:
  // Strips are narrower than `width`; those narrower than `certain_width` are such whatever is beside them.
  Narrow_strips(Feature_graph& graph, double width, double certain_width)
    : graph_(graph), mesh_(graph.mesh()), width_(width), certain_width_(certain_width)
  {}

  // Where two chains, ridges or grooves, are the sides of a strip, the weaker one goes, and so does one along a strip to the border. Not at
  // the rim of a plate, where the surface turns back; nor if the strip is no narrower than the certain width, and a strip lies on the other
  // side of that chain, too, as around a slender bar. Of a ridge and a groove, where the step is lower than `step(f)`, too, at its face f,
  // the groove goes, else none.
  template <class Step>
  void drop_sides(const Step& step)
  {
    // Ridges first, for the outline of a low step to lie on one of its sides all around.
    std::vector<Chain> in_order = graph_.chains_strongest_first();
    std::stable_partition(in_order.begin(), in_order.end(), [&](const Chain& c) { return graph_.weighted_turn(c.edges) >= 0; });
    chain_of_.assign(graph_.number_of_edges(), -1);
    for (std::size_t i = 0; i < in_order.size(); ++i)
      for (const Index e : in_order[i].edges) chain_of_[e] = Index(i);
    is_accepted_.assign(graph_.number_of_edges(), 0);
    for (const Chain& chain : in_order) {
      double beside = 0;
      for (const Index e : chain.edges) {
        const Index h = graph_.edge(e).halfedge;
        beside += (std::min)(graph_.edge(e).length, length_over(e, h, step) + length_over(e, mesh_.opposite(h), step));
      }
      if (beside > STRIP_SHARE * graph_.length_of(chain.edges)) graph_.drop(chain.edges);
      else for (const Index e : chain.edges) is_accepted_[e] = 1;
    }
    for (const Chain& chain : graph_.chains())                 // the ends of strips
      if (chain.free_ends > 0 && graph_.length_of(chain.edges) < width_) graph_.drop(chain.edges);
  }

private:
  static constexpr double STRIP_SHARE = 0.9;           // of a chain, along a strip
  static constexpr double MOST_TURN = 120;             // of the surface, over the strip
  static constexpr double ALONG_COSINE = 0.7071067811865476;      // 45 degrees
  // In widths of a strip: how far its sides are from each other; edges that run beside what they face, or do not, as a whole.
  static constexpr double MOST_APART = 2, SHORT = 10;

  bool is_low(Index h) const { return h >= 0 && mesh_.altitude(h) < width_; }
  std::vector<Index> edges_at_apex(Index h) const { return graph_.edges_at(mesh_.apex(h)); }

  // A low face of a flat may lie between edges of the same chain.
  bool is_strip_to_other_chain(Index e, Index h) const
  {
    if (!is_low(h)) return false;
    const std::vector<Index> edges = edges_at_apex(h);
    return std::any_of(edges.begin(), edges.end(), [&](Index k) { return chain_of_[k] != chain_of_[e]; });
  }

  // The length of e along which accepted edges run on the other side of the face of h, a half-edge of e.
  template <class Step>
  double length_over(Index e, Index h, const Step& step) const
  {
    const Edge& edge = graph_.edge(e);
    if (!is_low(h)) return 0;
    if (mesh_.is_border_vertex(mesh_.apex(h))) return edge.length;
    if (mesh_.altitude(h) >= certain_width_ && is_strip_to_other_chain(e, mesh_.opposite(h))) return 0;
    std::vector<Index> accepted = edges_at_apex(h);
    accepted.erase(std::remove_if(accepted.begin(), accepted.end(), [&](Index k) { return !is_accepted_[k]; }), accepted.end());
    const bool is_low_step = mesh_.altitude(h) < step(h >> 2),
               turns_back = std::any_of(accepted.begin(), accepted.end(), [&](Index k) {
                 return edge.angle + graph_.edge(k).angle >= MOST_TURN; });
    double beside = 0;
    for (const Index k : accepted)
      if (are_along(e, k) && (edge.is_groove == graph_.edge(k).is_groove ? !turns_back : edge.is_groove && is_low_step))
        beside += edge.length < SHORT * width_ ? edge.length : length_beside(e, k);
    return beside > edge.length / 2 ? edge.length : beside;
  }

  // Whether these edges have about the same direction.
  bool are_along(Index e, Index k) const
  {
    const Vector3 along = graph_.vector_of(e), other = graph_.vector_of(k);
    return is_cosine_at_least(along, other, ALONG_COSINE) || is_cosine_at_least(along, -1. * other, ALONG_COSINE);
  }

  // The length along which edge k, which has about the same direction, runs beside e.
  double length_beside(Index e, Index k) const
  {
    const double distance = MOST_APART * width_;
    const Vector3 &a = graph_.position(graph_.edge(e).ends[0]), &c = graph_.position(graph_.edge(k).ends[0]);
    const Vector3 along = (1 / graph_.edge(e).length) * graph_.vector_of(e), other = graph_.vector_of(k);
    const double start = dot(along, c - a), advance = dot(along, other);
    const double from = (std::max)(0., (std::min)(start, start + advance)),
                 to = (std::min)(graph_.edge(e).length, (std::max)(start, start + advance));
    const auto is_close = [&](double s) {
      return squared_distance(c + ((s - start) / advance) * other, a + s * along) < distance * distance; };
    return from < to && is_close(from) && is_close(to) ? to - from : 0.;
  }

  Feature_graph& graph_;
  const Remeshing_mesh& mesh_;
  double width_, certain_width_;
  std::vector<Index> chain_of_;          // by edge
  std::vector<char> is_accepted_;        // by edge
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_NARROW_STRIPS_H
