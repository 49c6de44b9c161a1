// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_ROUNDED_EDGE_FINDER_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_ROUNDED_EDGE_FINDER_H

#include <CGAL/Inter_angle_remeshing/internal/curves/curves.h>
#include <CGAL/Inter_angle_remeshing/internal/features/Rounded_edges.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/Remeshing_mesh.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/cross_products.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

// The edges of machine parts are rounded. No face of a result follows a fillet that is narrower than the target length: edges that
// lead across cut it off, and leave a serrated rim. A chain of edges along its middle, where the surface has turned half of its
// way, is as good as a sharp edge. Nor does one follow the crests over which the surface of a thin body turns back: the leading edge
// of a wing, the rim of a lens, an ear. Nothing is flat beside these.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

class Rounded_edge_finder
{
public:
  using Index = Remeshing_mesh::Index;

  // Of the faces the unit normals, zero where there is none, and the target lengths; the edges that are features anyway.
  Rounded_edge_finder(const Remeshing_mesh& mesh, const std::vector<Vector3>& normal, const std::vector<Index>& features,
                      std::vector<double> target_length)
    : mesh_(mesh), normal_(normal), target_length_(std::move(target_length)),
      state_(4 * mesh.number_of_face_slots(), State::plain), curves_at_(mesh.number_of_vertex_slots(), 0)
  {
    for (Index v = 0; v < Index(curves_at_.size()); ++v)
      if (mesh.is_border_vertex(v)) curves_at_[v] = 2;
    for (const Index h : features) mark(h, State::feature);
  }

  // Fillets are at most so many target lengths wide. One over which the surface turns back, the round rim of a plate, is at most
  // half as wide: the plate's thickness must not go.
  Rounded_edges find(double widest)
  {
    for (const Scale& scale : {Scale{widest, LEAST_TURN_BACK}, Scale{widest / 2, 180}})
      find_chains(scale.width, [&](Index h) { return imbalance_on_fillet(h, scale); });
    settle_free_ends(widest, LENGTH_A_FREE_END);
    return {chosen_edges(), find_joints()};
  }

  // One half-edge of each edge of the crests, sorted, over which the surface turns back within so many target lengths; none where they
  // are too short for the area of a thin body.
  std::vector<Index> find_crests(double width)
  {
    find_chains(width, [&](Index h) { return imbalance_on_crest(h, width); });
    settle_free_ends(width, CREST_LENGTH_A_FREE_END);
    std::vector<Index> crests = chosen_edges();
    if (length_of(crests) < THIN_SHARE * std::sqrt(area(mesh_))) crests.clear();
    return crests;
  }

private:
  enum class State : std::uint8_t { plain, candidate, chosen, feature };
  // A half-edge that a way across the surface leads over, into the face of it.
  struct Step
  {
    double distance;
    Index halfedge;
  };
  using Way = std::vector<Step>;
  struct Scale
  {
    double width, most_turn;       // target lengths, degrees
  };
  using Chain = std::vector<Index>;         // half-edges, one behind the other

  // In degrees: the least turn of the surface across a fillet, and at each of its edges; how much of it is left where the fillet
  // ends, and how little the surface turns beside it; from where on it turns back.
  static constexpr double LEAST_TURN = 40, LEAST_TURN_OF_EDGE = 3, REST = 8, FLAT = 2, LEAST_TURN_BACK = 120;
  // The width of what must be flat on each side, over that of the fillet, and over that of the widest one.
  static constexpr double MARGIN = 0.5, LEAST_MARGIN = 0.25;
  // The sum of the turns may be so much more than the turn from side to side: fillets do not turn to and fro.
  static constexpr double MOST_SWAY = 1.2;
  // The crests of a thin body are at least so long, over the root of its area: those of a lens 2.5, of a wing 1.6.
  static constexpr double THIN_SHARE = 0.6;
  // How far a way goes, over the width: an edge beside the middle of three facets has two thirds of a fillet on one side.
  static constexpr double REACH = 1.2;
  // How far from the middle an edge may be, as a part of the turn.
  static constexpr double LARGEST_IMBALANCE = 0.25;
  // Beside a crest, as far from its middle as it is wide, the surface turns by no more than so many degrees. Its middle is bent by this
  // part of the mean at least, the chord between the unit normals over the mean altitude of the faces taken for the bend, or is a sharp
  // edge, of 60 degrees, as the rim of a plate whose sharp edges are not marked.
  static constexpr double MOST_TURN_BESIDE_CREST = 30, LEAST_BEND = 0.5, SHARP_COSINE = 0.5;
  // In target lengths: chains, closed ones, and what each end takes that leads nowhere.
  static constexpr double LEAST_CHAIN = 1, LEAST_LOOP = 3, LENGTH_A_FREE_END = 4, CREST_LENGTH_A_FREE_END = 2;
  static constexpr int MOST_STEPS = 200;

  static double turn(const Vector3& a, const Vector3& b) { return std::atan2(length(cross(a, b)), dot(a, b)) * (180 / CGAL_PI); }
  const Vector3& normal(Index h) const { return normal_[h >> 2]; }
  double target_length(Index h) const { return target_length_[h >> 2]; }
  Vector3 along(Index h) const { return mesh_.position(mesh_.target(h)) - mesh_.position(mesh_.origin(h)); }
  double length_of(const Chain& chain) const
  {
    double sum = 0;
    for (const Index h : chain) sum += length(along(h));
    return sum;
  }
  // The unit vector at a right angle to h, which has this length, into its face, which has a normal.
  Vector3 inward(Index h, double length) const { return (1 / length) * cross(normal(h), along(h)); }

  bool is_curve(Index h) const { return state_[h] == State::chosen || state_[h] == State::feature; }
  void mark(Index h, State state)
  {
    const bool was_curve = is_curve(h);
    state_[h] = state;
    if (mesh_.is_border(h)) return;
    state_[mesh_.opposite(h)] = state;
    if (is_curve(h) != was_curve)
      for (const Index v : {mesh_.origin(h), mesh_.target(h)}) curves_at_[v] += was_curve ? -1 : 1;
  }

  std::vector<Index> chosen_edges() const
  {
    std::vector<Index> result;
    for (Index h = 0; h < Index(state_.size()); ++h)
      if (state_[h] == State::chosen && mesh_.opposite(h) > h) result.push_back(h);
    return result;
  }

  bool walk(Index h, double distance, Way& way) const;
  double imbalance_on_fillet(Index h, const Scale& scale);
  double imbalance_on_crest(Index h, double width);
  bool is_bent(Index h, double least) const;
  bool is_beside_chosen(Index h, double distance);
  template <class Imbalance>
  void find_chains(double width, const Imbalance& imbalance);
  void grow(Index h, double part, Chain& chain);
  void settle_free_ends(double widest, double length_a_free_end);
  bool join(Index h, double distance);
  std::vector<Index> find_joints() const;

  const Remeshing_mesh& mesh_;
  const std::vector<Vector3>& normal_;
  std::vector<double> target_length_;
  std::vector<State> state_;               // by half-edge
  std::vector<int> curves_at_;             // by vertex: the number of curve edges, with those of the border
  std::vector<Chain> chains_;
  std::array<Way, 2> ways_;                // on both sides of an edge
};

// Goes straight across the surface, from the middle of h at a right angle into its face. Returns whether that meets neither a feature
// nor the border up to a distance.
inline bool Rounded_edge_finder::walk(Index h, double distance, Way& way) const
{
  way.clear();
  if (normal(h) == Vector3()) return false;
  Vector3 p = 0.5 * (mesh_.position(mesh_.origin(h)) + mesh_.position(mesh_.target(h))), direction = inward(h, length(along(h)));
  double gone = 0;
  for (int step = 0; step < MOST_STEPS; ++step) {
    const Vector3 left = cross(normal(h), direction);
    const Index exit = dot(left, mesh_.position(mesh_.apex(h)) - p) >= 0 ? mesh_.next(h) : mesh_.prev(h);
    const Vector3 start = mesh_.position(mesh_.origin(exit)), edge = mesh_.position(mesh_.target(exit)) - start;
    const double to_the_right = -dot(left, start - p), width = dot(left, edge);
    if (!(width > 0)) return false;
    const Vector3 q = start + (std::max)(0., to_the_right) / width * edge;
    gone += (std::max)(0., dot(direction, q - p));
    if (gone >= distance) return true;
    h = mesh_.opposite(exit);
    if (h < 0 || state_[h] == State::feature || normal(h) == Vector3()) return false;
    p = q;
    const double l = length(edge), c = -dot(direction, edge) / l;
    direction = (c / l) * along(h) + std::sqrt((std::max)(0., 1 - c * c)) * inward(h, l);
    way.push_back({gone, h});
  }
  return false;
}

// How far the edge of h is from the middle of a fillet, as a part of its turn, and 0 for those next to it; infinite where there is
// no fillet, or it is wider than the scale, or nothing flat lies beside it.
inline double Rounded_edge_finder::imbalance_on_fillet(Index h, const Scale& scale)
{
  constexpr double none = std::numeric_limits<double>::infinity();
  const std::array<Index, 2> sides = {h, mesh_.opposite(h)};
  const double own = turn(normal(h), normal(sides[1]));
  if (own < LEAST_TURN_OF_EDGE) return none;
  const double widest = scale.width * target_length(h), reach = REACH * widest;
  std::array<Vector3, 2> beyond;
  std::array<double, 2> turns, widths = {0, 0};
  for (const int k : {0, 1}) {
    const Way& way = ways_[k];
    if (!walk(sides[k], reach, ways_[k])) return none;
    const auto before = [&](std::size_t i) { return normal(i == 0 ? sides[k] : way[i - 1].halfedge); };
    beyond[k] = before(way.size());
    turns[k] = turn(normal(sides[k]), beyond[k]);
    for (std::size_t i = way.size(); i > 0 && widths[k] == 0; --i)
      if (turn(before(i - 1), beyond[k]) > REST) widths[k] = way[i - 1].distance;
  }
  const double margin = (std::max)(MARGIN * (widths[0] + widths[1]), LEAST_MARGIN * widest);
  for (const int k : {0, 1}) {
    Vector3 n = normal(sides[k]);
    for (const Step& step : ways_[k])
      if (step.distance <= reach - margin) n = normal(step.halfedge);
    if (widths[k] > reach - margin || turn(n, beyond[k]) > FLAT) return none;
  }
  const double whole = turn(beyond[0], beyond[1]);
  if (widths[0] + widths[1] > widest || whole < LEAST_TURN || whole > scale.most_turn ||
      turns[0] + own + turns[1] > MOST_SWAY * whole) return none;
  return (std::max)(0., std::abs(turns[0] - turns[1]) - own) / whole;
}

// The same for crests: infinite where the surface does not turn back within the width, or does not stop turning beyond.
inline double Rounded_edge_finder::imbalance_on_crest(Index h, double width)
{
  constexpr double none = std::numeric_limits<double>::infinity();
  const double reach = width * target_length(h);
  const std::array<Index, 2> sides = {h, mesh_.opposite(h)};
  if (dot(normal(h), normal(sides[1])) > SHARP_COSINE && !is_bent(h, LEAST_BEND * LEAST_TURN_BACK * (CGAL_PI / 180) / reach)) return none;
  const double own = turn(normal(h), normal(sides[1]));
  std::array<Vector3, 2> at_foot;
  std::array<double, 2> turns;
  for (const int k : {0, 1}) {
    if (!walk(sides[k], reach / 2, ways_[k])) return none;
    at_foot[k] = ways_[k].empty() ? normal(sides[k]) : normal(ways_[k].back().halfedge);
    turns[k] = turn(normal(sides[k]), at_foot[k]);
    if (2 * (turns[k] + own) < (1 - LARGEST_IMBALANCE) * LEAST_TURN_BACK) return none;
  }
  const double whole = turn(at_foot[0], at_foot[1]);
  if (whole < LEAST_TURN_BACK || turns[0] + own + turns[1] > MOST_SWAY * 180) return none;
  for (const int k : {0, 1}) {
    walk(sides[k], reach, ways_[k]);                      // as far as it leads
    if (!ways_[k].empty() && turn(at_foot[k], normal(ways_[k].back().halfedge)) > MOST_TURN_BESIDE_CREST) return none;
  }
  return (std::max)(0., std::abs(turns[0] - turns[1]) - own) / whole;
}

// Whether the chord between the unit normals at h, over the mean altitude of its faces, is at least this.
inline bool Rounded_edge_finder::is_bent(Index h, double least) const
{
  const Index o = mesh_.opposite(h);
  const Vector3 edge = along(h), start = mesh_.position(mesh_.origin(h));
  const double squared_areas = squared_length(cross(edge, mesh_.position(mesh_.apex(h)) - start)) +
                               squared_length(cross(edge, mesh_.position(mesh_.apex(o)) - start));
  return squared_length(normal(h) - normal(o)) * squared_length(edge) >= least * least * squared_areas / 2;
}

inline bool Rounded_edge_finder::is_beside_chosen(Index h, double distance)
{
  for (const Index side : {h, mesh_.opposite(h)}) {
    walk(side, distance, ways_[0]);
    if (std::any_of(ways_[0].begin(), ways_[0].end(), [&](const Step& s) { return state_[s.halfedge] == State::chosen; })) return true;
  }
  return false;
}

// The edges nearest to the middle come first, of these the longest; no other chain of a fillet is followed beside a chosen one.
template <class Imbalance>
void Rounded_edge_finder::find_chains(double width, const Imbalance& imbalance)
{
  std::vector<std::tuple<double, double, Index>> seeds;
  for (Index h = 0; h < Index(state_.size()); ++h) {
    if (mesh_.corner(h) == 3 || mesh_.opposite(h) < h || is_curve(h)) continue;
    const double off = imbalance(h);
    const bool is_candidate = off <= LARGEST_IMBALANCE;
    mark(h, is_candidate ? State::candidate : State::plain);
    if (is_candidate) seeds.emplace_back(off, -mesh_.squared_edge_length(h), h);
  }
  std::sort(seeds.begin(), seeds.end());
  for (const auto& [off, order, h] : seeds) {
    if (state_[h] != State::candidate || is_beside_chosen(h, width * target_length(h))) continue;
    Chain chain = {mesh_.opposite(h)};
    mark(h, State::chosen);
    grow(mesh_.opposite(h), width, chain);
    std::reverse(chain.begin(), chain.end());
    for (Index& k : chain) k = mesh_.opposite(k);
    grow(h, width, chain);
    const bool is_closed = mesh_.target(chain.back()) == mesh_.origin(chain.front());
    if (length_of(chain) >= (is_closed ? LEAST_LOOP : LEAST_CHAIN) * target_length(h)) chains_.push_back(std::move(chain));
    else for (const Index k : chain) mark(k, State::plain);
  }
}

// Goes on from the target of h, as straight as possible.
inline void Rounded_edge_finder::grow(Index h, double part, Chain& chain)
{
  for (;;) {
    Index best = -1;
    double straightest = CORNER_COSINE;
    bool has_arrived = false;
    mesh_.for_each_around(mesh_.target(h), [&](Index k) {
      if (k == mesh_.opposite(h)) return;
      has_arrived = has_arrived || is_curve(k);
      if (state_[k] != State::candidate) return;
      const double c = dot(along(k), along(h)) / (length(along(k)) * length(along(h)));
      if (c > straightest) {
        straightest = c;
        best = k;
      }
    });
    if (has_arrived || best < 0 || is_beside_chosen(best, part * target_length(best))) return;
    mark(best, State::chosen);
    chain.push_back(best);
    h = best;
  }
}

// Where several fillets meet, in a spherical corner, their middles end beside each other, and are joined. Chains that end elsewhere
// are features if they are long.
inline void Rounded_edge_finder::settle_free_ends(double widest, double length_a_free_end)
{
  for (const Chain& chain : chains_) {
    int free_ends = 0;
    for (const Index h : {chain.back(), mesh_.opposite(chain.front())})
      free_ends += curves_at_[mesh_.target(h)] == 1 && !join(h, widest * target_length(h));
    if (length_of(chain) < free_ends * length_a_free_end * target_length(chain.front()))
      for (const Index h : chain) mark(h, State::plain);
  }
}

// Joins the end of a chain, the target of h, to the nearest other curve ahead, by the shortest path of edges within a distance.
inline bool Rounded_edge_finder::join(Index h, double distance)
{
  constexpr double AHEAD_COSINE = 0.5;
  using Entry = std::tuple<double, Index, Index>;                // the length of a path, the vertex and the half-edge where it ends
  const Index end = mesh_.target(h);
  const Vector3 direction = along(h);
  std::map<Index, Index> last_edge;                              // of the shortest path, by vertex
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  queue.emplace(0, end, -1);
  while (!queue.empty()) {
    const auto [path, v, edge] = queue.top();
    queue.pop();
    if (!last_edge.emplace(v, edge).second) continue;
    if (v != end && curves_at_[v] > 0) {
      for (Index u = v; u != end; u = mesh_.origin(last_edge.at(u))) mark(last_edge.at(u), State::chosen);
      return true;
    }
    mesh_.for_each_around(v, [&, path = path](Index k) {
      const double l = path + length(along(k));
      const Vector3 way = mesh_.position(mesh_.target(k)) - mesh_.position(end);
      if (l <= distance && is_cosine_at_least(way, direction, AHEAD_COSINE)) queue.emplace(l, mesh_.target(k), k);
    });
  }
  return false;
}

inline std::vector<Rounded_edge_finder::Index> Rounded_edge_finder::find_joints() const
{
  std::vector<char> is_junction(curves_at_.size(), 0);           // by vertex: whether a fillet meets other curves there
  for (const Index h : chosen_edges())
    for (const Index v : {mesh_.origin(h), mesh_.target(h)}) is_junction[v] = curves_at_[v] > 2;
  std::vector<Index> result;
  for (Index h = 0; h < Index(state_.size()); ++h) {
    if (mesh_.corner(h) == 3 || !is_curve(h) || mesh_.is_border(h) || !is_junction[mesh_.origin(h)]) continue;
    std::vector<Index> passed = {mesh_.origin(h)};
    double way = 0;
    for (Index k = h; k >= 0;) {
      way += length(along(k));
      if (way > Rounded_edges::JOINT_LENGTH * target_length(h)) break;
      const Index v = mesh_.target(k), back = mesh_.opposite(k);
      passed.push_back(v);
      k = -1;
      if (is_junction[v]) result.insert(result.end(), passed.begin(), passed.end());
      else if (curves_at_[v] == 2)
        mesh_.for_each_around(v, [&](Index following) {
          if (following != back && is_curve(following) && !mesh_.is_border(following)) k = following;
        });
    }
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_ROUNDED_EDGE_FINDER_H
