// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_FINE_RELIEF_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_FINE_RELIEF_H

#include <CGAL/Inter_angle_remeshing/internal/geometry/Point_grid.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/Remeshing_mesh.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/cross_products.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <unordered_map>
#include <vector>

// Ridges and grooves that lie closer together than the target length are a relief that no edges of that length can follow: the stairs
// of voxels, threads, knurls, the layers of an extrusion. Kept as features they would make a mesh of many more faces, all of them
// poor. What is high is no relief: the teeth of a gear are its shape. Thin bars and plates have ridges alone, on all sides.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

class Fine_relief
{
public:
  using Index = Remeshing_mesh::Index;

  // Of the faces the unit normals, zero where there is none, and the target lengths.
  Fine_relief(const Remeshing_mesh& mesh, const std::vector<Vector3>& normal, const std::vector<double>& target_length)
    : mesh_(mesh), normal_(normal), target_length_(target_length)
  {
    const auto [least, most] = std::minmax_element(target_length.begin(), target_length.end());
    largest_length_ = *most;
    is_uniform_ = *least == *most;
  }

  // Raises, by edge, how densely ridges and grooves lie there: within a cube of two target lengths, the lesser of the lengths of both, in
  // target lengths; 0 where they are high. What exceeds `enough` already is not looked at.
  void raise(std::vector<double>& densities, const std::vector<Index>& edges, double enough)
  {
    for (const Index h : edges)
      if (is_between_narrow_faces(h)) add(h);
    if (!cells_.empty()) {
      for (const Index h : edges)
        if (is_narrow(h) != is_narrow(mesh_.opposite(h))) add_faces_beside(h);
      add_small_faces();
    }
    for (std::size_t i = 0; i < edges.size(); ++i)
      if (!(densities[i] > enough) && is_between_narrow_faces(edges[i])) densities[i] = (std::max)(densities[i], density(edges[i]));
  }

private:
  // Cells have this part of a target length: three of them are the cube.
  static constexpr double CELL = 2. / 3;
  // How far the ridges of a relief are from the grooves, at most, in target lengths: a surface half way between them is no farther
  // from either than the distances that a run lets be.
  static constexpr double HIGHEST = 0.4;
  // How far the normals of a relief agree: length of their sum over the sum of their lengths. The stairs of voxels across the diagonal
  // have .58; the sides of thin plates and bars cancel each other out.
  static constexpr double LEAST_COHERENCE = 0.5;
  // Edges are looked at piece by piece, each no longer than a cell, but in hardly more pieces than this.
  static constexpr int MOST_PIECES = 10000;

  // Target lengths may differ. Those of one level are about as long; an edge is noted at the levels beside its own, too.
  struct Key
  {
    int level;
    Grid_cell cell;
    bool operator==(const Key& k) const { return level == k.level && cell == k.cell; }
  };
  struct Hash
  {
    std::size_t operator()(const Key& k) const { return hash_of_cell(k.cell) ^ std::size_t(k.level) * 19260817u; }
  };
  // Pieces of edges: their length, and the sum of their centres by length.
  struct Pieces
  {
    double length = 0;
    Vector3 moment;

    void add(double l, const Vector3& m) { length += l; moment += m; }
    Vector3 centre() const { return (1 / length) * moment; }
  };
  static constexpr double UNKNOWN = -1;
  struct Cell
  {
    Pieces ridges, grooves;
    Vector3 normal;                      // of small faces, and of large ones beside the pieces, by area
    double area = 0;
    double density = UNKNOWN;            // of the cells around it and it, in target lengths

    void add_faces(const Vector3& n, double a) { normal += n; area += a; }
    void add(const Cell& other)
    {
      ridges.add(other.ridges.length, other.ridges.moment);
      grooves.add(other.grooves.length, other.grooves.moment);
      add_faces(other.normal, other.area);
    }
  };

  int level_of(double length) const { return int(std::lround(std::log2(length / largest_length_))); }
  double length_of(int level) const { return std::ldexp(largest_length_, level); }
  Key key(const Vector3& p, int level) const
  {
    const double inverse = 1 / (CELL * length_of(level));
    return {level, {std::int64_t(std::floor(inverse * p.x)), std::int64_t(std::floor(inverse * p.y)),
                    std::int64_t(std::floor(inverse * p.z))}};
  }

  // The target length at an edge: that of its faces, or what is less.
  double target_length(Index h) const { return (std::min)(target_length_[h >> 2], target_length_[mesh_.opposite(h) >> 2]); }
  // A relief goes on to both sides: its end is none.
  bool is_between_narrow_faces(Index h) const { return is_narrow(h) && is_narrow(mesh_.opposite(h)); }
  bool is_narrow(Index h) const { return mesh_.altitude(h) < target_length_[h >> 2]; }

  template <class Function>
  void for_each_piece(Index h, int level, const Function& function) const
  {
    const Vector3 a = mesh_.position(mesh_.origin(h)), way = mesh_.position(mesh_.target(h)) - a;
    const double l = length(way);
    const int n = 1 + int((std::min)(double(MOST_PIECES), l / (CELL * length_of(level))));
    for (int i = 0; i < n; ++i) function(a + ((i + 0.5) / n) * way, l / n);
  }

  void add(Index h)
  {
    const bool is_in_groove = is_groove(mesh_, h, normal_[h >> 2], normal_[mesh_.opposite(h) >> 2]);
    for_each_piece_with_faces(h, [&](const Key& k, const Vector3& p, double l, const Vector3& normal, double area) {
      Cell& cell = cells_[k];
      (is_in_groove ? cell.grooves : cell.ridges).add(l, l * p);
      cell.add_faces(normal, area);
    });
  }

  // Of an edge that is none of a relief, as the rim of a plate's other side; also to cells without pieces, for those around look at them.
  void add_faces_beside(Index h)
  {
    for_each_piece_with_faces(h, [&](const Key& k, const Vector3&, double, const Vector3& normal, double area) {
      cells_[k].add_faces(normal, area); });
  }

  // Calls `function(k, p, l, normal, area)` for each piece of the edge of h, of length l at p, with the area that lies beside it, and the
  // normals times that.
  template <class Function>
  void for_each_piece_with_faces(Index h, const Function& function) const
  {
    const double width = width_beside(h), other = width_beside(mesh_.opposite(h));
    const Vector3 normal = width * normal_[h >> 2] + other * normal_[mesh_.opposite(h) >> 2];
    for_each_level(target_length(h), [&](int level) {
      for_each_piece(h, level, [&](const Vector3& p, double l) { function(key(p, level), p, l, l * normal, l * (width + other)); });
    });
  }

  template <class Function>
  void for_each_level(double length, const Function& function) const
  {
    const int own = level_of(length), reach = is_uniform_ ? 0 : 1;
    for (int level = own - reach; level <= own + reach; ++level) function(level);
  }

  // A face that is small is added to the cell that it lies in; of the other ones what lies beside an edge is added with that.
  bool is_small(Index f) const
  {
    double longest = 0;
    for (Index h = 4 * f; h < 4 * f + 3; ++h) longest = (std::max)(longest, mesh_.squared_edge_length(h));
    return longest < CELL * target_length_[f] * CELL * target_length_[f];
  }
  double width_beside(Index h) const { return is_small(h >> 2) ? 0. : (std::min)(mesh_.altitude(h), target_length_[h >> 2]); }

  void add_small_faces()
  {
    for (Index f = 0; f < Index(normal_.size()); ++f) {
      if (!is_small(f)) continue;
      const auto& v = mesh_.face_record(f).vertex;
      const Vector3 &a = mesh_.position(v[0]), &b = mesh_.position(v[1]), &c = mesh_.position(v[2]);
      const double area = length(triangle_cross(a, b, c)) / 2;
      for_each_level(target_length_[f], [&](int level) {
        const auto cell = cells_.find(key((1. / 3) * (a + b + c), level));
        if (cell != cells_.end()) cell->second.add_faces(area * normal_[f], area);
      });
    }
  }

  double density_around(const Key& centre) const
  {
    const double length = length_of(centre.level);
    Cell sum;
    Key k = centre;
    for (int i = 0; i < 27; ++i) {
      k.cell = {centre.cell[0] + i / 9 - 1, centre.cell[1] + i / 3 % 3 - 1, centre.cell[2] + i % 3 - 1};
      if (const auto found = cells_.find(k); found != cells_.end()) sum.add(found->second);
    }
    const double agreeing = internal::length(sum.normal);
    if (!(sum.ridges.length > 0 && sum.grooves.length > 0 && agreeing > LEAST_COHERENCE * sum.area)) return 0;
    const double height = dot(sum.ridges.centre() - sum.grooves.centre(), sum.normal) / agreeing;
    return std::abs(height) > HIGHEST * length ? 0 : (std::min)(sum.ridges.length, sum.grooves.length) / length;
  }

  // The mean over the edge.
  double density(Index h)
  {
    const int level = level_of(target_length(h));
    double sum = 0, all = 0;
    for_each_piece(h, level, [&](const Vector3& p, double l) {
      all += l;
      const Key k = key(p, level);
      double& density = cells_.at(k).density;
      if (density == UNKNOWN) density = density_around(k);
      sum += l * density;
    });
    return sum / all;
  }

  const Remeshing_mesh& mesh_;
  const std::vector<Vector3>& normal_;
  const std::vector<double>& target_length_;
  double largest_length_;
  bool is_uniform_;
  std::unordered_map<Key, Cell, Hash> cells_;
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_FINE_RELIEF_H
