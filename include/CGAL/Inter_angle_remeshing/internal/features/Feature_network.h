// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_FEATURE_NETWORK_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_FEATURE_NETWORK_H

#include <CGAL/Inter_angle_remeshing/internal/curves/curves.h>
#include <CGAL/Inter_angle_remeshing/internal/features/Feature_graph.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// Whether the edges of a graph are those of something designed, a machine part, or curves drawn on what has grown. Animals and scans have
// edges that are loose, jagged, and a tangle.
class Feature_network
{
  using Index = Feature_graph::Index;
  using Chain = Feature_graph::Chain;

public:
  // The functions drop what does not belong to a network.
  explicit Feature_network(Feature_graph& graph)
    : graph_(graph)
  {}

  // The edges in between, neither sharp nor flat, may be so many times as long as sharp ones that form a network; where these lie on planes.
  static constexpr double MOST_BETWEEN = 3.5, MOST_BETWEEN_PLANES = 5;

  // Whether these edges are those of a machine part: curves that end nowhere, hardly bend, and seldom meet. Those of a part that was
  // remeshed coarsely, of few edges each, meet more often; if that was done again and again, they bend more often. Where much of what they
  // lie on is plane, the rest may be curved more finely; or it was simplified, which breaks edges, and less need run through. Those of many
  // small details, as of screws and vents, meet and bend more often, but there are few edges in between. What leads to a free end is
  // dropped. `planar_share`: how much of the area is plane; `between`: how many times as long the edges in between are.
  bool is_network(double planar_share, double between)
  {
    const Shape shape = look();
    const bool is_planar = planar_share >= LEAST_PLANAR_SHARE;
    if (is_planar && between < MOST_BETWEEN && shape.runs_through(LEAST_BROKEN_SHARE) &&
        shape.is_within(LARGEST_BROKEN_MEETING_SHARE, LARGEST_BENT_SHARE)) return true;
    if (!shape.runs_through(LEAST_NETWORK_SHARE)) return false;
    if (planar_share >= DETAILED_PLANAR_SHARE && between < MOST_BETWEEN_DETAILS &&
        shape.is_within(LARGEST_DETAILED_MEETING_SHARE, LARGEST_DETAILED_BENT_SHARE)) return true;
    return between < (is_planar ? MOST_BETWEEN_PLANES : MOST_BETWEEN) &&
           (shape.is_within(LARGEST_MEETING_SHARE, LARGEST_BENT_SHARE) ||
            shape.is_within(LARGEST_COARSE_MEETING_SHARE, LARGEST_COARSE_BENT_SHARE) ||
            double(shape.bent + shape.others) <= LARGEST_UNEVEN_SHARE * double(shape.inner + shape.others));
  }
  // The same where curves may bend, as along fillets: paths of edges join them where they meet.
  bool is_bent()
  {
    const Shape shape = look();
    return shape.runs_through(LEAST_NETWORK_SHARE) && shape.meeting_share() <= LARGEST_MEETING_SHARE;
  }
  // Whether hardly anything else is left out when only curves are kept that end nowhere, hardly bend, and seldom meet. Short ones between
  // others that run on smoothly, and components that are a tangle, are dropped.
  bool is_smooth()
  {
    const double length_of_all = graph_.length_left();
    graph_.drop_trees();
    drop_rungs();
    graph_.drop_trees();
    for (const std::vector<Index>& component : graph_.components())
      if (component.size() < LEAST_EDGES || !is_smooth(component)) graph_.drop(component);
    return graph_.length_left() > 0 && graph_.length_left() >= LEAST_SMOOTH_SHARE * length_of_all;
  }

private:
  struct Shape
  {
    double share;                        // of the length, that is left without what leads to a free end
    std::size_t inner, bent, others;     // vertices of two edges, those of them where these turn, and all others

    bool runs_through(double least_share) const { return share >= least_share && inner >= LEAST_EDGES; }
    double meeting_share() const { return double(others) / double(inner + others); }
    double bent_share() const { return double(bent) / double(inner); }
    bool is_within(double meeting, double bending) const { return meeting_share() <= meeting && bent_share() <= bending; }
  };

  static constexpr std::size_t LEAST_EDGES = 12;       // the ring of fewer turns by 30 degrees at each
  static constexpr double LEAST_NETWORK_SHARE = 0.7, LARGEST_BENT_SHARE = 0.2, LARGEST_MEETING_SHARE = 0.4,
                          LARGEST_COARSE_MEETING_SHARE = 0.5, LARGEST_COARSE_BENT_SHARE = 0.1, LARGEST_UNEVEN_SHARE = 0.33;
  // The edges lie on planes, or some of what they lie on is plane; what has grown, with as many sharp edges, is so mostly over less than a
  // quarter.
  static constexpr double LEAST_PLANAR_SHARE = 0.35, DETAILED_PLANAR_SHARE = 0.22, MOST_BETWEEN_DETAILS = 2,
                          LARGEST_DETAILED_MEETING_SHARE = 0.7, LARGEST_DETAILED_BENT_SHARE = 0.375;
  // Of a network that simplification broke: robots' links of a thousand faces have .37 at least, and .43 at most.
  static constexpr double LEAST_BROKEN_SHARE = 0.35, LARGEST_BROKEN_MEETING_SHARE = 0.45;
  // Of a network, what is part of smooth curves; of the vertices of such, those of two edges where these turn, and those of more, of which
  // none has more than so many. Rungs between two curves have at most so many edges.
  static constexpr double LEAST_SMOOTH_SHARE = 0.9, SMOOTH_BENT_SHARE = 0.02, SMOOTH_MEETING_SHARE = 0.2;
  static constexpr int MOST_SMOOTH_DEGREE = 4;
  static constexpr std::size_t LONGEST_RUNG = 3;

  Shape look()
  {
    const double length_of_all = graph_.length_left();
    graph_.drop_trees();
    std::size_t inner = 0, bent = 0, others = 0;
    for (Index v = 0; v < Index(graph_.number_of_vertices()); ++v) {
      if (graph_.edges_left(v) == 0) continue;
      ++(graph_.degree(v) == 2 ? inner : others);
      bent += graph_.degree(v) == 2 && graph_.bends(v);
    }
    return {length_of_all > 0 ? graph_.length_left() / length_of_all : 0., inner, bent, others};
  }

  // Drops short chains both of whose ends lie on other curves that run on there.
  void drop_rungs()
  {
    for (const Chain& chain : graph_.chains())
      if (chain.edges.size() <= LONGEST_RUNG && chain.ends[0] >= 0 && chain.ends[1] >= 0 && runs_on(chain.ends[0], chain.edges) &&
          runs_on(chain.ends[1], chain.edges)) graph_.drop(chain.edges);
  }

  // Whether two edges at v that are not among these continue each other; where there are many, they are a tangle.
  bool runs_on(Index v, const std::vector<Index>& chain) const
  {
    constexpr int MANY = 10;
    if (graph_.degree(v) >= MANY) return false;
    std::vector<Vector3> directions;
    graph_.for_each_incident(v, [&](Index e) {
      if (std::find(chain.begin(), chain.end(), e) == chain.end())
        directions.push_back(graph_.position(graph_.other_end(e, v)) - graph_.position(v));
    });
    for (auto d = directions.begin(); d != directions.end(); ++d)
      if (std::any_of(d + 1, directions.end(), [&](const Vector3& other) { return is_cosine_at_least(*d, -1. * other, CORNER_COSINE); }))
        return true;
    return false;
  }

  // Whether the curves of a component hardly bend, and seldom meet, nowhere more than two.
  bool is_smooth(const std::vector<Index>& component) const
  {
    const std::vector<Index> vertices = graph_.vertices_of(component);
    std::size_t bent = 0, others = 0;
    for (const Index v : vertices) {
      if (graph_.degree(v) > MOST_SMOOTH_DEGREE) return false;
      if (graph_.degree(v) != 2) ++others;
      else bent += graph_.bends(v);
    }
    return double(bent) <= SMOOTH_BENT_SHARE * double(vertices.size() - others) &&
           double(others) <= SMOOTH_MEETING_SHARE * double(vertices.size());
  }

  Feature_graph& graph_;
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_FEATURE_NETWORK_H
