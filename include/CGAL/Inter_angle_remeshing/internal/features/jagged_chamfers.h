// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_JAGGED_CHAMFERS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_JAGGED_CHAMFERS_H

#include <CGAL/Inter_angle_remeshing/internal/features/Face_normals.h>
#include <CGAL/Inter_angle_remeshing/internal/geometry/thin_walls.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

// Whether a mesh has jagged chamfers where the part that it was made of has edges, as alpha wraps have.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// Such a mesh is even. Many of its sharp edges are rims of chamfers one face wide, and some of their chains turn to and fro, which
// designed ones do not. Where most of the chamfers are the rims of thin walls, each of their edges counts, jagged or not. What has been
// remeshed is as even, and a bit jagged where its edges are long beside its details; but its chamfers have no flat faces any more.
class Jagged_chamfers
{
  using Index = Remeshing_mesh::Index;

  static constexpr double LONGEST_EDGE = 3.5;                      // of an even mesh, in mean edge lengths
  static constexpr double STEEPEST_RIM = 70;                       // of a chamfer, in degrees
  static constexpr double LEAST_TURN = 15, GREATEST_TURN = 80;     // to and fro, in degrees
  // Parts of the sharp edges.
  static constexpr double LEAST_CHAMFERS = 0.15, LEAST_JAGGED = 0.002, MANY_JAGGED = 0.02, MOST_JAGGED = 0.4, MOST_WALLS = 0.3;
  static constexpr std::size_t LEAST_EDGES = 90;
  // This part of the rims of chamfers has a flat face beside it, whose least altitude is less than this part of its longest edge.
  static constexpr double LEAST_FLAT = 0.25, FLAT = 0.39;

public:
  // `sharp_edges` has one half-edge of each.
  Jagged_chamfers(const Face_normals& normals, const std::vector<Index>& sharp_edges)
    : normals_(normals), mesh_(normals.mesh()), sharp_edges_(sharp_edges), chains_(mesh_.number_of_vertex_slots())
  {
    for (const Index h : sharp_edges) {
      add(mesh_.origin(h), mesh_.target(h));
      add(mesh_.target(h), mesh_.origin(h));
    }
  }

  // The parts of the sharp edges that are rims of chamfers, that turn to and fro, and that are rims of thin walls.
  double chamfer_share() const { return part([&](Index h) { return is_rim_of_chamfer(h); }); }
  double jagged_share() const { return part([&](Index h) { return turns_to_and_fro(h); }); }
  double wall_share() const { return part([&](Index h) { return is_rim_of_wall(h); }); }

  // `mean_length` is that of the edges of the mesh.
  bool are_there(double mean_length) const
  {
    return is_even(mean_length) && chamfer_share() >= LEAST_CHAMFERS && jagged_share() >= LEAST_JAGGED && !tell_nothing() &&
           wall_share() <= MOST_WALLS;
  }

  // Whether it tells nothing that edges turn to and fro: there are few, as of a turned part of six facets, or nearly all do, as the creases
  // of folded paper.
  bool tell_nothing() const { return sharp_edges_.size() < LEAST_EDGES || jagged_share() > MOST_JAGGED; }

  // Whether they may be those of a part that has been remeshed: hardly jagged, and few of their faces flat.
  bool may_be_remeshed() const
  {
    const auto is_rim_of_flat_one = [&](Index h) { return is_rim_of_chamfer(h) && (is_flat(h) || is_flat(mesh_.opposite(h))); };
    return jagged_share() < MANY_JAGGED && part(is_rim_of_flat_one) < LEAST_FLAT * chamfer_share();
  }

private:
  // The ends of the sharp edges at a vertex, of two at most.
  struct Chain
  {
    int edges = 0;
    std::array<Index, 2> ends{};
    Index other_than(Index v) const { return ends[0] == v ? ends[1] : ends[0]; }
  };

  void add(Index v, Index end)
  {
    Chain& c = chains_[v];
    if (c.edges < 2) c.ends[c.edges] = end;
    ++c.edges;
  }

  bool is_even(double mean_length) const
  {
    const double longest = LONGEST_EDGE * mean_length;
    bool result = true;
    mesh_.for_each_edge([&](Index h) { result = result && mesh_.squared_edge_length(h) <= longest * longest; });
    return result;
  }

  template <class Predicate>
  double part(const Predicate& predicate) const
  {
    if (sharp_edges_.empty()) return 0;
    return double(std::count_if(sharp_edges_.begin(), sharp_edges_.end(), predicate)) / double(sharp_edges_.size());
  }

  // Whether the face of h is a strip between its edge and other sharp edges.
  bool is_strip(Index h) const { return h >= 0 && chains_[mesh_.apex(h)].edges > 0; }

  // Whether the face of h is a strip, and flat.
  bool is_flat(Index h) const
  {
    if (!is_strip(h)) return false;
    const double longest = (std::max)({mesh_.squared_edge_length(h), mesh_.squared_edge_length(mesh_.next(h)),
                                       mesh_.squared_edge_length(mesh_.prev(h))});
    return normals_.doubled_area(h >> 2) < FLAT * longest;
  }

  bool is_rim_of_chamfer(Index h) const
  {
    return (is_strip(h) || is_strip(mesh_.opposite(h))) && normals_.cosine(h) > cosine_of_degrees(STEEPEST_RIM);
  }

  bool turns_to_and_fro(Index h) const
  {
    const Index a = mesh_.origin(h), b = mesh_.target(h);
    if (chains_[a].edges != 2 || chains_[b].edges != 2) return false;
    const Vector3 &p = mesh_.position(a), &q = mesh_.position(b);
    const Vector3 first = unit(p - mesh_.position(chains_[a].other_than(b))), middle = unit(q - p),
                  last = unit(mesh_.position(chains_[b].other_than(a)) - q);
    const auto [least, greatest] = std::minmax({dot(first, middle), dot(middle, last)});
    return greatest < cosine_of_degrees(LEAST_TURN) && least > cosine_of_degrees(GREATEST_TURN) && dot(first, last) > greatest;
  }

  // Whether the surface across a strip at h looks to the other side.
  bool is_rim_of_wall(Index h) const { return is_wall(h) || is_wall(mesh_.opposite(h)); }
  bool is_wall(Index h) const
  {
    if (!is_strip(h) || mesh_.opposite(h) < 0) return false;
    const Vector3& normal = normals_[mesh_.opposite(h) >> 2];
    return !mesh_.all_around(mesh_.apex(h), [&](Index k) { return !look_to_opposite_sides(normal, normals_[k >> 2]); });
  }

  const Face_normals& normals_;
  const Remeshing_mesh& mesh_;
  const std::vector<Index>& sharp_edges_;
  std::vector<Chain> chains_;            // by vertex
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_JAGGED_CHAMFERS_H
