// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_POINT_GRID_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_POINT_GRID_H

#include <CGAL/Inter_angle_remeshing/internal/Vector3.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// A growing set of points that is asked whether one of them is near; a Kd_tree would have to be built anew.
class Point_grid
{
public:
  explicit Point_grid(double distance) : distance_(distance) {}

  void insert(const Vector3& p) { points_[cell_of(p)].push_back(p); }

  // Whether a point lies nearer to p than the distance.
  bool has_near(const Vector3& p) const
  {
    const Cell c = cell_of(p);
    for (int i = -1; i <= 1; ++i)
      for (int j = -1; j <= 1; ++j)
        for (int k = -1; k <= 1; ++k) {
          const auto found = points_.find(Cell{c[0] + i, c[1] + j, c[2] + k});
          if (found == points_.end()) continue;
          for (const Vector3& q : found->second)
            if (squared_distance(p, q) < distance_ * distance_) return true;
        }
    return false;
  }

private:
  using Cell = std::array<std::int64_t, 3>;

  // By three large primes (M. Teschner et al., Vision, Modeling and Visualization 2003).
  struct Hash
  {
    std::size_t operator()(const Cell& c) const
    {
      return std::size_t(c[0]) * 73856093u ^ std::size_t(c[1]) * 19349663u ^ std::size_t(c[2]) * 83492791u;
    }
  };

  Cell cell_of(const Vector3& p) const
  {
    return {std::int64_t(std::floor(p.x / distance_)), std::int64_t(std::floor(p.y / distance_)),
            std::int64_t(std::floor(p.z / distance_))};
  }

  double distance_;
  std::unordered_map<Cell, std::vector<Vector3>, Hash> points_;
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_POINT_GRID_H
