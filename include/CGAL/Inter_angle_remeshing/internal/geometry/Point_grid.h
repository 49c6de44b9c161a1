// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_GEOMETRY_POINT_GRID_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_GEOMETRY_POINT_GRID_H

#include <CGAL/Inter_angle_remeshing/internal/geometry/Vector3.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

// Points in the cells of a grid, for queries about what is near by; a Kd_tree would have to be built anew for points that come later.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

using Grid_cell = std::array<std::int64_t, 3>;

// By three large primes (M. Teschner et al., Vision, Modeling and Visualization 2003).
inline std::size_t hash_of_cell(const Grid_cell& c)
{
  return std::size_t(c[0]) * 73856093u ^ std::size_t(c[1]) * 19349663u ^ std::size_t(c[2]) * 83492791u;
}

class Point_grid
{
public:
  // Cells of this size suit queries of about that reach.
  explicit Point_grid(double size) : size_(size) {}

  void insert(const Vector3& p, int number = 0)
  {
    if (entries_.size() >= first_.size()) grow();
    entries_.push_back({p, cell_of(p), number, -1});
    link(int(entries_.size()) - 1);
  }

  // Whether a point lies nearer to p than this.
  bool has_near(const Vector3& p, double distance) const
  {
    bool result = false;
    const Vector3 reach{distance, distance, distance};
    for_each_entry_in_box(p - reach, p + reach, [&](const Entry& e) {
      result = squared_distance(p, e.point) < distance * distance;
      return !result;
    });
    return result;
  }

  // Calls `function(number)` for the points in the cells that meet the box, in an order of no meaning.
  template <class Function>
  void for_each_in_box(const Vector3& low, const Vector3& high, const Function& function) const
  {
    for_each_entry_in_box(low, high, [&](const Entry& e) { function(e.number); return true; });
  }

private:
  struct Entry
  {
    Vector3 point;
    Grid_cell cell;
    int number, next;                    // the next one of the same hash
  };

  // As long as the function returns true. Where the cells are more than the points, these are looked at one by one.
  template <class Function>
  void for_each_entry_in_box(const Vector3& low, const Vector3& high, const Function& function) const
  {
    const Grid_cell first = cell_of(low), last = cell_of(high);
    double cells = 1;
    for (int k = 0; k < 3; ++k) cells *= double(last[k] - first[k]) + 1;
    if (cells > double(entries_.size())) {
      for (const Entry& e : entries_)
        if (first[0] <= e.cell[0] && e.cell[0] <= last[0] && first[1] <= e.cell[1] && e.cell[1] <= last[1] &&
            first[2] <= e.cell[2] && e.cell[2] <= last[2] && !function(e)) return;
      return;
    }
    for (Grid_cell c = first; c[0] <= last[0]; ++c[0])
      for (c[1] = first[1]; c[1] <= last[1]; ++c[1])
        for (c[2] = first[2]; c[2] <= last[2]; ++c[2])
          for (int i = first_[bucket(c)]; i >= 0; i = entries_[i].next)
            if (entries_[i].cell == c && !function(entries_[i])) return;
  }

  // The number of buckets is a power of two.
  std::size_t bucket(const Grid_cell& c) const { return hash_of_cell(c) & (first_.size() - 1); }

  void link(int i)
  {
    int& first = first_[bucket(entries_[i].cell)];
    entries_[i].next = first;
    first = i;
  }

  void grow()
  {
    constexpr std::size_t FEWEST = 64;
    first_.assign(first_.empty() ? FEWEST : 2 * first_.size(), -1);
    for (int i = 0; i < int(entries_.size()); ++i) link(i);
  }

  Grid_cell cell_of(const Vector3& p) const
  {
    return {std::int64_t(std::floor(p.x / size_)), std::int64_t(std::floor(p.y / size_)),
            std::int64_t(std::floor(p.z / size_))};
  }

  double size_;
  std::vector<Entry> entries_;
  std::vector<int> first_;               // by hash of the cell; negative: none
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_GEOMETRY_POINT_GRID_H
