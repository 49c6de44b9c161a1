// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_FEATURE_GRAPH_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_FEATURE_GRAPH_H

#include <CGAL/Inter_angle_remeshing/internal/curves/curves.h>
#include <CGAL/Inter_angle_remeshing/internal/geometry/Point_grid.h>
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

  // Lengths below are multiples of `length`.
  Feature_graph(const Remeshing_mesh& mesh, double length)
    : mesh_(mesh), length_(length), number_(mesh.number_of_vertex_slots(), -1)
  {}

  // Of these edges, whose angles do not matter.
  Feature_graph(const Remeshing_mesh& mesh, double length, const std::vector<Index>& edges)
    : Feature_graph(mesh, length)
  {
    for (const Index h : edges) add(h, 0);
  }

  // `turn`: by which the surface turns over the edge, in degrees, less than 0 in a groove; the sign matters to drop_sides_of_strips()
  // alone. Edges that are certain to be features are not dropped by prune() or cut_out(). Where lengths are others than `length`, that of
  // the edge counts so many times.
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

  // Keeps closed curves that meet no other, are sharp, hardly bend, do not run beside themselves, and are no shorter than this.
  void keep_rings(double least_length)
  {
    for (const Chain& chain : chains())
      if (chain.ends[0] >= 0 || chain.edges.size() < LEAST_EDGES || length_of(chain.edges) < least_length * length_ ||
          !is_fit(chain.edges) || runs_beside_itself(chain)) drop(chain.edges);
  }

  // Whether these edges are those of a machine part: curves that end nowhere, hardly bend, and seldom meet; those of a part that was
  // remeshed coarsely again and again bend more often. Those of animals and scans are loose, jagged, and a tangle. What leads to a free end
  // is dropped.
  bool is_network()
  {
    const Network_shape shape = look_at_network();
    return shape.is_network && (double(shape.bent) <= LARGEST_BENT_SHARE * double(shape.inner) ||
                                double(shape.bent + shape.others) <= LARGEST_UNEVEN_SHARE * double(shape.inner + shape.others));
  }
  // The same where curves may bend, as along fillets: paths of edges join them where they meet.
  bool is_bent_network() { return look_at_network().is_network; }
  // Whether hardly anything else is left out when only curves are kept that end nowhere, hardly bend, and seldom meet. Short ones between
  // others that run on smoothly, and components that are a tangle, are dropped.
  bool is_smooth_network()
  {
    const double length_of_all = length_left();
    drop_trees();
    drop_rungs();
    drop_trees();
    for (const std::vector<Index>& component : components())
      if (component.size() < LEAST_EDGES || !is_smooth(component)) drop(component);
    return length_left() > 0 && length_left() >= LEAST_SMOOTH_SHARE * length_of_all;
  }

  // Takes the edges out of which the density, in the order of adding, is greater than this, and of components that mainly consist of
  // such edges those of half of it. Then what is ragged beside them: from where edges went, on to corners, ends and junctions at a
  // short distance, and on from there where a good part of the component is such edges; and chains that now end after a few lengths.
  void cut_out(const std::vector<double>& density, double largest);

  // Keeps chains that lead somewhere, in components that are long, sharp, and not a tangle, and of two chains side by side
  // the stronger one. The creases of animals and folds of clothes end somewhere; the edges of a machine part hardly do.
  void prune()
  {
    for (int pass = 0; pass < 2; ++pass) drop_dangling_chains(STRONG_ANGLE);
    for (const std::vector<Index>& component : components())
      if (!is_fit(component)) drop(component);
    drop_parallel_chains();
    drop_dangling_chains(0);
    for (const std::vector<Index>& component : components())
      if (component.size() < LEAST_EDGES ||
          length_of(component) < (std::max)(LEAST_COMPONENT, LENGTH_A_FREE_END * free_ends(component)) * length_)
        drop(component);
  }

  // The same where the edges are known to be those of a part: the chains may be loose, and a tangle.
  void prune_part()
  {
    for (int pass = 0; pass < 2; ++pass) drop_dangling_chains(0);
    drop_parallel_chains();
    drop_dangling_chains(0);
    drop_short_components(2 * DANGLING_LENGTH);
  }

  // Where two chains, ridges or grooves, are the sides of a strip of faces that is narrower than this, the weaker one goes, and so does one
  // along such a strip to the border: no good triangles fit in between. Not at the rim of a plate, where the surface turns back; nor if
  // the strip is no narrower than `certain_width`, and a strip narrower than `width` lies on the other side of that chain, too, as around
  // a slender bar. Of a ridge and a groove, where the step is lower than `step(f)`, too, at its face f, the groove goes, else none.
  template <class Step>
  void drop_sides_of_strips(double width, double certain_width, const Step& step);

private:
  struct Network_shape
  {
    bool is_network;
    std::size_t inner, bent, others;     // vertices of two edges, those of them where these turn, and all others
  };

  Network_shape look_at_network()
  {
    const double length_of_all = length_left();
    drop_trees();
    std::size_t inner = 0, bent = 0, others = 0;
    for (Index v = 0; v < Index(vertices_.size()); ++v) {
      if (edges_left_[v] == 0) continue;
      ++(degree(v) == 2 ? inner : others);
      bent += degree(v) == 2 && bends(v);
    }
    return {length_left() >= LEAST_NETWORK_SHARE * length_of_all && inner >= LEAST_EDGES &&
            double(others) <= LARGEST_MEETING_SHARE * double(inner + others), inner, bent, others};
  }

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

  static constexpr double STRONG_ANGLE = 45;
  static constexpr double DANGLING_LENGTH = 4, LEAST_COMPONENT = 5, LENGTH_A_FREE_END = 40;
  static constexpr std::size_t LEAST_EDGES = 12;       // the ring of fewer turns by 30 degrees at each
  static constexpr double LEAST_STRONG_SHARE = 0.5, LARGEST_BAD_SHARE = 0.25;
  static constexpr double LEAST_NETWORK_SHARE = 0.7, LARGEST_BENT_SHARE = 0.2, LARGEST_MEETING_SHARE = 0.4,
                          LARGEST_UNEVEN_SHARE = 0.33;
  // Of a network, what is part of smooth curves; of the vertices of such, those of two edges where these turn, and those of more, of which
  // none has more than so many. Rungs between two curves have at most so many edges.
  static constexpr double LEAST_SMOOTH_SHARE = 0.9, SMOOTH_BENT_SHARE = 0.02, SMOOTH_MEETING_SHARE = 0.2;
  static constexpr int MOST_SMOOTH_DEGREE = 4;
  static constexpr std::size_t LONGEST_RUNG = 3;
  static constexpr double PARALLEL_DISTANCE = 0.35, PARALLEL_SHARE = 0.25;
  static constexpr double ALONG = 3;                   // so many distances apart along it, parts of a chain count as two
  static constexpr double JUNCTION_RADIUS = 1.5;       // in such distances, within which chains that meet are near each other
  static constexpr double ACUTE_COSINE = 0.9063077870366499;      // 25 degrees
  static constexpr double RAGGED_LENGTH = 1.5;         // from corner to corner
  static constexpr double SPREADING_SHARE = 0.2;       // of dense edges in components where what is ragged goes on
  static constexpr double LEAST_REST = 3;              // of a chain, for each of its new ends
  static constexpr double STRIP_SHARE = 0.9;           // of a chain, along a strip
  static constexpr double MOST_TURN = 120;             // of the surface, over the strip
  static constexpr double ALONG_COSINE = 0.7071067811865476;      // 45 degrees
  // In widths of a strip: how far its sides are from each other; edges that run beside what they face, or do not, as a whole.
  static constexpr double MOST_APART = 2, SHORT = 10;

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
  Index other_end(Index e, Index v) const { return edges_[e].ends[0] == v ? edges_[e].ends[1] : edges_[e].ends[0]; }
  const Vector3& position(Index v) const { return mesh_.position(vertices_[v]); }

  template <class Function>
  void for_each_incident(Index v, const Function& function) const
  {
    for (const Index e : incident_[v])
      if (edges_[e].is_left) function(e);
  }
  Vector3 vector_of(Index e) const { return position(edges_[e].ends[1]) - position(edges_[e].ends[0]); }
  // With the border's edges.
  int degree(Index v) const { return edges_left_[v] + (mesh_.is_border_vertex(vertices_[v]) ? 2 : 0); }

  double length_of(const std::vector<Index>& edges) const
  {
    return std::accumulate(edges.begin(), edges.end(), 0., [&](double sum, Index e) { return sum + edges_[e].length; });
  }
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
  void take_out(Index e)
  {
    if (!edges_[e].is_left) return;
    edges_[e].is_left = false;
    for (const Index v : edges_[e].ends) --edges_left_[v];
  }
  void drop(const std::vector<Index>& edges)
  {
    for (const Index e : edges)
      if (!edges_[e].is_certain) take_out(e);
  }
  bool has_certain_edge(const Chain& chain) const
  {
    return std::any_of(chain.edges.begin(), chain.edges.end(), [&](Index e) { return edges_[e].is_certain; });
  }

  std::vector<std::vector<Index>> components() const;
  std::vector<Chain> chains() const;
  void follow(Index e, int side, Chain& chain, std::vector<char>& is_passed) const;
  void drop_dangling_chains(double least_angle);
  void drop_trees();
  void drop_rungs();
  bool runs_on(Index v, const std::vector<Index>& chain) const;
  std::vector<Index> vertices_of(const std::vector<Index>& edges) const;
  bool is_smooth(const std::vector<Index>& component) const;
  std::vector<Index> edges_up_to_corner(Index v, Index first, double distance) const;
  bool is_fit(const std::vector<Index>& component) const;
  int free_ends(const std::vector<Index>& component) const;
  bool bends(Index v) const;
  template <class Function>
  void for_each_sample(const Vector3& a, const Vector3& b, const Function& function) const;
  std::vector<Vector3> samples(const Chain& chain) const;
  std::vector<std::pair<Index, Vector3>> first_edges(const Chain& chain) const;
  bool runs_beside(const Chain& chain, const std::vector<Vector3>& samples, const Point_grid& others) const;
  bool runs_beside_itself(const Chain& chain) const;
  bool are_along(Index e, Index k) const;
  double length_beside(Index e, Index k, double distance) const;
  std::vector<Chain> chains_strongest_first() const;
  void drop_parallel_chains();

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

inline void Feature_graph::drop_dangling_chains(double least_angle)
{
  for (const Chain& chain : chains()) {
    if (chain.free_ends == 0) continue;
    const double l = length_of(chain.edges);
    if (l < chain.free_ends * DANGLING_LENGTH * length_ || weighted_angle(chain.edges) < least_angle * l) drop(chain.edges);
  }
}

inline void Feature_graph::cut_out(const std::vector<double>& density, double largest)
{
  std::vector<char> is_cut(vertices_.size(), 0), is_settled(vertices_.size(), 0);     // by vertex; settled: looked at since the last cut
  std::vector<Index> cut;
  const auto cut_off = [&](Index e) {
    if (edges_[e].is_certain) return;
    take_out(e);
    for (const Index v : edges_[e].ends) {
      is_cut[v] = 1;
      is_settled[v] = 0;
      cut.push_back(v);
    }
  };
  for (const std::vector<Index>& component : components()) {
    const double dense = std::accumulate(component.begin(), component.end(), 0., [&](double sum, Index e) {
      return sum + (density[e] > largest ? edges_[e].length : 0); });
    const double all = length_of(component), bound = dense > all / 2 ? largest / 2 : largest;
    const std::size_t first = cut.size();
    for (const Index e : component)
      if (density[e] > bound) cut_off(e);
    const std::size_t last = cut.size();
    for (std::size_t i = first; i < (dense > SPREADING_SHARE * all ? cut.size() : last); ++i) {
      const Index v = cut[i];
      if (is_settled[v]) continue;
      is_settled[v] = 1;
      if (bends(v))
        for_each_incident(v, [&](Index beside) {
          for (const Index e : edges_up_to_corner(v, beside, RAGGED_LENGTH * length_)) cut_off(e);
        });
    }
  }
  for (const Chain& chain : chains()) {
    const auto new_ends = std::count_if(chain.ends.begin(), chain.ends.end(), [&](Index v) {
      return v >= 0 && is_cut[v] && degree(v) == 1; });
    if (length_of(chain.edges) < double(new_ends) * LEAST_REST * length_) drop(chain.edges);
  }
}

// The edges from v over `first` to the next corner, end or junction; none if it is farther away than this.
inline std::vector<Feature_graph::Index> Feature_graph::edges_up_to_corner(Index v, Index first, double distance) const
{
  std::vector<Index> result;
  double passed = 0;
  for (Index e = first;;) {
    result.push_back(e);
    passed += edges_[e].length;
    if (passed > distance) return {};
    v = other_end(e, v);
    if (bends(v)) return result;
    for_each_incident(v, [&, last = e](Index k) { if (k != last) e = k; });
    if (e == first) return result;
  }
}

// Drops edges with a free end until there is none.
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

// Drops short chains both of whose ends lie on other curves that run on there.
inline void Feature_graph::drop_rungs()
{
  for (const Chain& chain : chains())
    if (chain.edges.size() <= LONGEST_RUNG && chain.ends[0] >= 0 && chain.ends[1] >= 0 && runs_on(chain.ends[0], chain.edges) &&
        runs_on(chain.ends[1], chain.edges)) drop(chain.edges);
}

// Each once.
inline std::vector<Feature_graph::Index> Feature_graph::vertices_of(const std::vector<Index>& edges) const
{
  std::vector<Index> vertices;
  for (const Index e : edges) vertices.insert(vertices.end(), edges_[e].ends.begin(), edges_[e].ends.end());
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

// Whether two edges at v that are not among these continue each other; where there are many, they are a tangle.
inline bool Feature_graph::runs_on(Index v, const std::vector<Index>& chain) const
{
  constexpr int MANY = 10;
  if (degree(v) >= MANY) return false;
  std::vector<Vector3> directions;
  for_each_incident(v, [&](Index e) {
    if (std::find(chain.begin(), chain.end(), e) == chain.end()) directions.push_back(position(other_end(e, v)) - position(v));
  });
  for (auto d = directions.begin(); d != directions.end(); ++d)
    if (std::any_of(d + 1, directions.end(), [&](const Vector3& other) { return is_cosine_at_least(*d, -1. * other, CORNER_COSINE); }))
      return true;
  return false;
}

// Whether the curves of a component hardly bend, and seldom meet, nowhere more than two.
inline bool Feature_graph::is_smooth(const std::vector<Index>& component) const
{
  const std::vector<Index> vertices = vertices_of(component);
  std::size_t bent = 0, others = 0;
  for (const Index v : vertices) {
    if (degree(v) > MOST_SMOOTH_DEGREE) return false;
    if (degree(v) != 2) ++others;
    else bent += bends(v);
  }
  return double(bent) <= SMOOTH_BENT_SHARE * double(vertices.size() - others) &&
         double(others) <= SMOOTH_MEETING_SHARE * double(vertices.size());
}

// Whether v is not the middle of a smooth curve.
inline bool Feature_graph::bends(Index v) const
{
  if (degree(v) != 2 || edges_left_[v] != 2) return true;
  std::array<Vector3, 2> directions;
  std::size_t n = 0;
  for_each_incident(v, [&](Index e) { directions[n++] = position(other_end(e, v)) - position(v); });
  return !is_cosine_at_least(directions[0], -1. * directions[1], CORNER_COSINE);
}

inline bool Feature_graph::is_fit(const std::vector<Index>& component) const
{
  const double l = length_of(component);
  double strong = 0;
  for (const Index e : component)
    if (edges_[e].angle >= STRONG_ANGLE) strong += edges_[e].length;
  const std::vector<Index> vertices = vertices_of(component);
  const auto bad = std::count_if(vertices.begin(), vertices.end(), [&](Index v) { return bends(v); });
  return strong >= LEAST_STRONG_SHARE * l &&
         double(bad) <= LARGEST_BAD_SHARE * double(vertices.size());
}

inline int Feature_graph::free_ends(const std::vector<Index>& component) const
{
  int n = 0;
  for (const Index e : component)
    for (const Index v : edges_[e].ends) n += degree(v) == 1;
  return n;
}

// Calls `function(p)` for points on the segment from a to b that are less than the distance of parallel chains apart.
template <class Function>
void Feature_graph::for_each_sample(const Vector3& a, const Vector3& b, const Function& function) const
{
  constexpr double SPACING = 0.4;          // of that distance
  const int n = (std::max)(1, int(std::ceil(internal::length(b - a) / (SPACING * PARALLEL_DISTANCE * length_))));
  for (int i = 0; i < n; ++i) function(a + ((i + 0.5) / n) * (b - a));
}

inline std::vector<Vector3> Feature_graph::samples(const Chain& chain) const
{
  std::vector<Vector3> result;
  for (const Index e : chain.edges)
    for_each_sample(position(edges_[e].ends[0]), position(edges_[e].ends[1]), [&](const Vector3& p) { result.push_back(p); });
  return result;
}

// The first edges of a chain at its ends: vertex and direction.
inline std::vector<std::pair<Feature_graph::Index, Vector3>> Feature_graph::first_edges(const Chain& chain) const
{
  std::vector<std::pair<Index, Vector3>> result;
  for (const Index e : chain.edges)
    for (const Index v : edges_[e].ends)
      if (v == chain.ends[0] || v == chain.ends[1]) result.emplace_back(v, position(other_end(e, v)) - position(v));
  return result;
}

// Whether more than a quarter of a chain runs beside `others`, not counting where it meets them.
inline bool Feature_graph::runs_beside(const Chain& chain, const std::vector<Vector3>& samples, const Point_grid& others) const
{
  const double at_junction = JUNCTION_RADIUS * PARALLEL_DISTANCE * length_;
  std::size_t looked_at = 0, beside = 0;
  for (const Vector3& p : samples) {
    const bool is_at_junction = std::any_of(chain.ends.begin(), chain.ends.end(), [&](Index v) {
      return v >= 0 && degree(v) > 1 && squared_distance(position(v), p) < at_junction * at_junction; });
    if (is_at_junction) continue;
    ++looked_at;
    beside += others.has_near(p, PARALLEL_DISTANCE * length_);
  }
  return double(beside) > PARALLEL_SHARE * double(looked_at);
}

// Whether more than a quarter of a chain runs beside another part of it, as around a slit.
inline bool Feature_graph::runs_beside_itself(const Chain& chain) const
{
  const double distance = PARALLEL_DISTANCE * length_;
  const std::array<Index, 2>& first = edges_[chain.edges.front()].ends;
  const auto has_end = [&](Index e, Index u) { return edges_[e].ends[0] == u || edges_[e].ends[1] == u; };
  Index v = chain.edges.size() == 1 || has_end(chain.edges[1], first[1]) ? first[0] : first[1];
  std::vector<std::pair<Vector3, double>> samples;          // with their arc lengths
  double arc_length = 0;
  for (const Index e : chain.edges) {
    const Vector3& p = position(v);
    v = other_end(e, v);
    for_each_sample(p, position(v), [&](const Vector3& q) { samples.emplace_back(q, arc_length + internal::length(q - p)); });
    arc_length += edges_[e].length;
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

// Those with certain edges first, then by the sum of their angles; of equal ones, the first.
inline std::vector<Feature_graph::Chain> Feature_graph::chains_strongest_first() const
{
  std::vector<Chain> result = chains();
  for (Chain& chain : result) chain.rank = {has_certain_edge(chain), weighted_angle(chain.edges)};
  std::stable_sort(result.begin(), result.end(), [](const Chain& a, const Chain& b) { return a.rank > b.rank; });
  return result;
}

// Strongest first, chains are accepted unless they run beside an accepted one, the border or themselves, or leave a vertex in
// nearly the same direction as an accepted one.
inline void Feature_graph::drop_parallel_chains()
{
  Point_grid accepted(PARALLEL_DISTANCE * length_);
  mesh_.for_each_halfedge([&](Index h) {
    if (mesh_.is_border(h))
      for_each_sample(mesh_.position(mesh_.origin(h)), mesh_.position(mesh_.target(h)),
                      [&](const Vector3& p) { accepted.insert(p); });
  });

  std::vector<std::vector<Vector3>> directions(vertices_.size());     // of accepted chains
  for (const Chain& chain : chains_strongest_first()) {
    const std::vector<std::pair<Index, Vector3>> first = first_edges(chain);
    const std::vector<Vector3> points = samples(chain);
    const bool is_acute = std::any_of(first.begin(), first.end(), [&](const auto& f) {
      return std::any_of(directions[f.first].begin(), directions[f.first].end(), [&](const Vector3& d) {
        return is_cosine_at_least(d, f.second, ACUTE_COSINE); });
    });
    if (is_acute || runs_beside(chain, points, accepted) || runs_beside_itself(chain)) { drop(chain.edges); continue; }
    for (const auto& [v, d] : first) directions[v].push_back(d);
    for (const Vector3& p : points) accepted.insert(p);
  }
}

// Whether these edges have about the same direction.
inline bool Feature_graph::are_along(Index e, Index k) const
{
  const Vector3 along = vector_of(e), other = vector_of(k);
  return is_cosine_at_least(along, other, ALONG_COSINE) || is_cosine_at_least(along, -1. * other, ALONG_COSINE);
}

// The length along which edge k, which has about the same direction, runs beside e, no farther away than `distance`.
inline double Feature_graph::length_beside(Index e, Index k, double distance) const
{
  const Vector3 &a = position(edges_[e].ends[0]), &c = position(edges_[k].ends[0]);
  const Vector3 along = (1 / edges_[e].length) * vector_of(e), other = vector_of(k);
  const double start = dot(along, c - a), advance = dot(along, other);
  const double from = (std::max)(0., (std::min)(start, start + advance)),
               to = (std::min)(edges_[e].length, (std::max)(start, start + advance));
  const auto is_close = [&](double s) {
    return squared_distance(c + ((s - start) / advance) * other, a + s * along) < distance * distance; };
  return from < to && is_close(from) && is_close(to) ? to - from : 0.;
}

template <class Step>
void Feature_graph::drop_sides_of_strips(double width, double certain_width, const Step& step)
{
  // Ridges first, for the outline of a low step to lie on one of its sides all around.
  std::vector<Chain> in_order = chains_strongest_first();
  std::stable_partition(in_order.begin(), in_order.end(), [&](const Chain& c) { return weighted_turn(c.edges) >= 0; });
  std::vector<Index> chain_of(edges_.size(), -1);
  for (std::size_t i = 0; i < in_order.size(); ++i)
    for (const Index e : in_order[i].edges) chain_of[e] = Index(i);
  std::vector<char> is_accepted(edges_.size(), 0);
  const auto is_low = [&](Index h) { return h >= 0 && mesh_.altitude(h) < width; };
  const auto edges_at_apex = [&](Index h) {
    const Index v = number_[mesh_.apex(h)];
    return v >= 0 ? incident_[v] : std::vector<Index>();
  };
  // A low face of a flat may lie between edges of the same chain.
  const auto is_strip_to_other_chain = [&](Index e, Index h) {
    const std::vector<Index> edges = is_low(h) ? edges_at_apex(h) : std::vector<Index>();
    return std::any_of(edges.begin(), edges.end(), [&](Index k) { return chain_of[k] != chain_of[e]; });
  };
  // The length of e along which accepted edges run on the other side of the face of h, a half-edge of e.
  const auto length_over = [&](Index e, Index h) {
    const double all = edges_[e].length;
    if (!is_low(h)) return 0.;
    if (mesh_.is_border_vertex(mesh_.apex(h))) return all;
    if (mesh_.altitude(h) >= certain_width && is_strip_to_other_chain(e, mesh_.opposite(h))) return 0.;
    std::vector<Index> accepted = edges_at_apex(h);
    accepted.erase(std::remove_if(accepted.begin(), accepted.end(), [&](Index k) { return !is_accepted[k]; }), accepted.end());
    const bool is_low_step = mesh_.altitude(h) < step(h >> 2),
               turns_back = std::any_of(accepted.begin(), accepted.end(), [&](Index k) {
                 return edges_[e].angle + edges_[k].angle >= MOST_TURN; });
    double beside = 0;
    for (const Index k : accepted)
      if (are_along(e, k) && (edges_[e].is_groove == edges_[k].is_groove ? !turns_back : edges_[e].is_groove && is_low_step))
        beside += all < SHORT * width ? all : length_beside(e, k, MOST_APART * width);
    return beside > all / 2 ? all : beside;
  };
  for (const Chain& chain : in_order) {
    double beside = 0;
    for (const Index e : chain.edges) {
      const Index h = edges_[e].halfedge;
      beside += (std::min)(edges_[e].length, length_over(e, h) + length_over(e, mesh_.opposite(h)));
    }
    if (beside > STRIP_SHARE * length_of(chain.edges)) drop(chain.edges);
    else for (const Index e : chain.edges) is_accepted[e] = 1;
  }
  for (const Chain& chain : chains())                          // the ends of strips
    if (chain.free_ends > 0 && length_of(chain.edges) < width) drop(chain.edges);
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_FEATURE_GRAPH_H
