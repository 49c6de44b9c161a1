// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_JAGGED_CHAMFERS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_JAGGED_CHAMFERS_H

#include <CGAL/Inter_angle_remeshing/internal/Face_normals.h>
#include <CGAL/Inter_angle_remeshing/internal/thin_walls.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

// Whether a mesh has jagged chamfers where the part that it was made of has edges, as alpha wraps have.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// Such a mesh is even. Many of its sharp edges are rims of chamfers one face wide, and some of their chains turn to and fro, which
// designed ones do not. Where most of the chamfers are the rims of thin walls, each of their edges counts, jagged or not.
class Jagged_chamfers
{
  using Index = Remeshing_mesh::Index;

  static constexpr double LONGEST_EDGE = 3.5;                      // of an even mesh, in mean edge lengths
  static constexpr double STEEPEST_RIM = 70;                       // of a chamfer, in degrees
  static constexpr double LEAST_TURN = 15, GREATEST_TURN = 80;     // to and fro, in degrees
  // Parts of the sharp edges.
  static constexpr double LEAST_CHAMFERS = 0.15, LEAST_JAGGED = 0.002, MOST_WALLS = 0.3;

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
    return is_even(mean_length) && chamfer_share() >= LEAST_CHAMFERS && jagged_share() >= LEAST_JAGGED && wall_share() <= MOST_WALLS;
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

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_JAGGED_CHAMFERS_H
