// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_COARSE_LEVELS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_COARSE_LEVELS_H

#include <CGAL/Inter_angle_remeshing/internal/curves/curves.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/cross_products.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/edge_lengths.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/bent_vertices.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

// Where the target length is well under that of the input's edges, the iterations run on a coarser level, and its faces are then
// cut into four until they have the target length. How coarse the input lets a level be is measured here.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// A level is hardly coarser than the mean edge of the input. Nor do edges of its length follow the surface where that is bent: a
// star that is flat to ρ = |Σ c| / Σ |c|, over the cross products c of its faces, is taken to be as far from flat at the length
// of the level, 1 - ρ, as that is longer than its own edges. Vertices that are further from flat than BENT are held where they
// are, with the tips, thin parts and details that they stand for, as long as the mesh is coarse.
class Coarse_levels
{
  using Index = Remeshing_mesh::Index;

  // How long edges of a level may be, in mean edge lengths of the input: of the several ways to take that mean none is the one.
  static constexpr double COARSEST = 1.05;
  // Where more than this part of the vertices were held, with corners and others that stay anyway, they would stand too close
  // together for the faces between them.
  static constexpr double LARGEST_SHARE = 0.015;
  // Beside protected edges, which stay as they are, faces of the finest level need iterations of their own: in strips so many target
  // lengths wide, both sides together. Levels pay where such strips do not cover the mesh.
  static constexpr double STRIP_WIDTH = 10;

public:
  template <class ConcurrencyTag>
  static Coarse_levels measure(const Remeshing_mesh& mesh, double target_length)
  {
    Coarse_levels result;
    result.mean_length_ = mean_edge_length(mesh);
    if (!result.is_fine_enough(target_length)) return result;
    result.length_between_fixed_ends_ = length_between_fixed_ends(mesh);
    result.area_ = area(mesh);
    result.longest_edges_.assign(mesh.number_of_vertex_slots(), UNBENT);
    const std::size_t n = mesh.number_of_vertex_slots();
    for_each_block<ConcurrencyTag>(n, SCAN_BLOCK, [&](std::size_t begin, std::size_t end, std::size_t) {
      for (Index v = Index(begin); v < Index(end); ++v)
        if (mesh.is_free(v)) result.longest_edges_[v] = longest_edges_at(mesh, v);
        else if (mesh.is_locked(v) && !has_edge_between_fixed_ends(mesh, v)) result.longest_edges_[v] = 0;
    });
    return result;
  }

  // The number of levels above that of the target length, each with edges twice as long as the one under it.
  unsigned number(double target_length) const
  {
    unsigned levels = 0;
    if (STRIP_WIDTH * target_length * length_between_fixed_ends_ > area_) return levels;
    while (is_fine_enough(target_length) && is_resolved(2 * target_length)) {
      target_length *= 2;
      ++levels;
    }
    return levels;
  }

  // The vertices that edges of this length are too long for.
  std::vector<Index> bent_vertices(double length) const
  {
    std::vector<Index> result;
    for (Index v = 0; v < Index(longest_edges_.size()); ++v)
      if (longest_edges_[v] < length) result.push_back(v);
    return result;
  }

private:
  static constexpr double UNBENT = std::numeric_limits<double>::infinity();

  // Whether edges of twice the length are not coarser than the input.
  bool is_fine_enough(double length) const { return 2 * length <= COARSEST * mean_length_; }

  bool is_resolved(double length) const
  {
    return double(bent_vertices(length).size()) <= LARGEST_SHARE * double(longest_edges_.size());
  }

  // The longest that edges at v may be: 0 where those that are there are too long already.
  static double longest_edges_at(const Remeshing_mesh& mesh, Index v)
  {
    const Star_shape star = star_shape(mesh, v);
    if (star.bend > BENT) return 0;
    return star.bend > 0 ? BENT / star.bend * star.mean_edge_length : UNBENT;
  }

  static bool has_edge_between_fixed_ends(const Remeshing_mesh& mesh, Index v)
  {
    bool result = false;
    for_each_curve_halfedge(mesh, v, [&](Index h) { result = result || mesh.is_between_fixed_ends(h < 0 ? ~h : h); });
    return result;
  }

  static double length_between_fixed_ends(const Remeshing_mesh& mesh)
  {
    double sum = 0;
    mesh.for_each_edge([&](Index h) {
      if (mesh.is_between_fixed_ends(h)) sum += std::sqrt(mesh.squared_edge_length(h)); });
    return sum;
  }

  double mean_length_ = 0, length_between_fixed_ends_ = 0, area_ = 0;
  std::vector<double> longest_edges_;    // by vertex
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_COARSE_LEVELS_H
