// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_VOXEL_SURFACE_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_VOXEL_SURFACE_H

#include <CGAL/Inter_angle_remeshing/internal/geometry/Vector3.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/Remeshing_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

// Whether the vertices of a mesh are middles of edges of a grid of voxels. Marching cubes make such a mesh around what is marked in a
// volume, with a vertex between each two neighbors of which one is marked. Along each of the three axes its edges go by nothing, by half a
// voxel or by one; by a half along two axes or none.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

class Voxel_surface
{
  using Index = Remeshing_mesh::Index;

  // Marching cubes make 27 vectors. So many are told from each other; with what makes up less than this part of the edges, which
  // counts for nothing, the others may be this part.
  static constexpr std::size_t MOST_VECTORS = 64;
  static constexpr double RARE = 0.0005, OTHERS = 0.02;
  // Meshes with fewer edges a vector may be designed.
  static constexpr std::size_t LEAST_EDGES = 16;
  // Vectors are the same within this part of the mean edge length, and steps along an axis within this part of half a voxel.
  static constexpr double SAME = 0.01, SAME_STEP = 0.05;
  // Two edges are normal to each other if the longer one goes along the shorter one by at most this part of that: voxels may be many times
  // as long as they are wide, and edges between the rings of a slender bar are all but normal to these.
  static constexpr double MOST_ALONG = 0.02;

public:
  // `mean_length` is that of the edges of the mesh.
  Voxel_surface(const Remeshing_mesh& mesh, double mean_length) { read(mesh, SAME * mean_length); }

  bool is_one() const
  {
    if (vectors_.empty() || edges_ < LEAST_EDGES * vectors_.size()) return false;
    for (const Edge_vector& a : vectors_)
      for (const Edge_vector& b : vectors_)
        if (is_normal(a.vector, b.vector) && are_axes({a.vector, b.vector, cross(a.vector, b.vector)})) return true;
    return false;
  }

private:
  struct Edge_vector
  {
    Vector3 vector;
    std::size_t edges;
  };

  // Leaves no vector where there are too many.
  void read(const Remeshing_mesh& mesh, double tolerance)
  {
    const std::size_t most_others = std::size_t(OTHERS * 1.5 * double(mesh.number_of_live_faces()));     // of three edges for two faces
    std::size_t others = 0;
    mesh.for_each_edge([&](Index h) {
      ++edges_;
      if (others > most_others) return;
      const Vector3 d = mesh.position(mesh.target(h)) - mesh.position(mesh.origin(h));
      const auto known = std::find_if(vectors_.begin(), vectors_.end(), [&](const Edge_vector& e) {
        return (std::min)(squared_length(e.vector - d), squared_length(e.vector + d)) <= tolerance * tolerance; });
      if (known != vectors_.end()) ++known->edges;
      else if (vectors_.size() < MOST_VECTORS) vectors_.push_back({d, 1});
      else ++others;
    });
    const auto is_rare = [&](const Edge_vector& e) { return double(e.edges) < RARE * double(edges_); };
    for (const Edge_vector& e : vectors_) others += is_rare(e) ? e.edges : 0;
    vectors_.erase(std::remove_if(vectors_.begin(), vectors_.end(), is_rare), vectors_.end());
    if (others > most_others) vectors_.clear();
  }

  // The longest step along an axis is that of a voxel, or, where the surface is hardly inclined, of half of one.
  bool are_axes(const std::array<Vector3, 3>& axes) const
  {
    std::array<double, 3> longest{};
    for (const Edge_vector& e : vectors_)
      for (int k = 0; k < 3; ++k) longest[k] = (std::max)(longest[k], std::abs(dot(e.vector, axes[k])));
    for (int halves = 0; halves < 8; ++halves)
      if (are_middles(axes, {longest[0] / (2 - (halves & 1)), longest[1] / (2 - (halves >> 1 & 1)), longest[2] / (2 - (halves >> 2))}))
        return true;
    return false;
  }

  // Whether the vectors are those between middles of edges, with these steps of half a voxel along the axes.
  bool are_middles(const std::array<Vector3, 3>& axes, const std::array<double, 3>& step) const
  {
    std::array<bool, 8> are_odd{};       // by axes, a bit for each: whether a vector goes by an odd number of steps along these
    for (const Edge_vector& e : vectors_) {
      unsigned odd = 0;
      for (int k = 0; k < 3; ++k) {
        const double steps = std::abs(dot(e.vector, axes[k])) / step[k], n = std::round(steps);
        if (!(std::abs(steps - n) <= SAME_STEP)) return false;
        odd |= unsigned(n == 1) << k;
      }
      are_odd[odd] = true;
    }
    return are_odd[3] && are_odd[5] && are_odd[6] && !are_odd[1] && !are_odd[2] && !are_odd[4] && !are_odd[7];
  }

  static bool is_normal(const Vector3& a, const Vector3& b)
  {
    return std::abs(dot(a, b)) <= MOST_ALONG * (std::min)(squared_length(a), squared_length(b));
  }

  std::vector<Edge_vector> vectors_;     // of the edges, each with its opposite
  std::size_t edges_ = 0;
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_VOXEL_SURFACE_H
