// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_POINT_GRID_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_POINT_GRID_H

#include <CGAL/Inter_angle_remeshing/internal/Vector3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// A growing set of points, each with a number, that is asked which of them are near; a Kd_tree would have to be built anew.
class Point_grid
{
public:
  // Cells of this size suit queries of about that reach.
  explicit Point_grid(double size) : size_(size) {}

  void insert(const Vector3& p, int number = 0) { points_[cell_of(p)].push_back({p, number}); }

  // Whether a point lies nearer to p than this.
  bool has_near(const Vector3& p, double distance) const
  {
    bool result = false;
    const Vector3 reach{distance, distance, distance};
    for_each_entry_in_box(p - reach, p + reach, [&](const Entry& e) {
      result = result || squared_distance(p, e.point) < distance * distance; });
    return result;
  }

  // Calls `function(number)` for the points in the cells that meet the box; where these are more than the cells that hold points,
  // in an order of no meaning.
  template <class Function>
  void for_each_in_box(const Vector3& low, const Vector3& high, const Function& function) const
  {
    for_each_entry_in_box(low, high, [&](const Entry& e) { function(e.number); });
  }

private:
  using Cell = std::array<std::int64_t, 3>;
  struct Entry
  {
    Vector3 point;
    int number;
  };

  template <class Function>
  void for_each_entry_in_box(const Vector3& low, const Vector3& high, const Function& function) const
  {
    const Cell first = cell_of(low), last = cell_of(high);
    double cells = 1;
    for (int k = 0; k < 3; ++k) cells *= double(last[k] - first[k]) + 1;
    if (cells > double(points_.size())) {
      for (const auto& cell : points_)
        if (std::equal(first.begin(), first.end(), cell.first.begin(), std::less_equal<std::int64_t>()) &&
            std::equal(last.begin(), last.end(), cell.first.begin(), std::greater_equal<std::int64_t>()))
          for (const Entry& e : cell.second) function(e);
      return;
    }
    for (Cell c = first; c[0] <= last[0]; ++c[0])
      for (c[1] = first[1]; c[1] <= last[1]; ++c[1])
        for (c[2] = first[2]; c[2] <= last[2]; ++c[2]) {
          const auto found = points_.find(c);
          if (found == points_.end()) continue;
          for (const Entry& e : found->second) function(e);
        }
  }

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
    return {std::int64_t(std::floor(p.x / size_)), std::int64_t(std::floor(p.y / size_)),
            std::int64_t(std::floor(p.z / size_))};
  }

  double size_;
  std::unordered_map<Cell, std::vector<Entry>, Hash> points_;
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_POINT_GRID_H
