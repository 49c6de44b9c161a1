// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_MEASURES_ONE_SIDED_DISTANCE_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_MEASURES_ONE_SIDED_DISTANCE_H

#include <CGAL/Inter_angle_remeshing/internal/measures/Distance_traits.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/parallel_blocks.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {
namespace measures {

struct Distance_summary
{
  double maximum = 0;
  double sum = 0;
};

// The blocks, and the order in which they are added up, depend on the number of points only: so does every bit.
template <class ConcurrencyTag>
Distance_summary summarize_distances(const std::vector<Distance_point>& points, const Distance_tree& tree)
{
  constexpr std::size_t BLOCK = 512;     // about 0.5 ms: long against starting a task, short against the whole
  std::vector<Distance_summary> parts(number_of_blocks(points.size(), BLOCK));
  for_each_block<ConcurrencyTag>(points.size(), BLOCK, [&](std::size_t begin, std::size_t end, std::size_t block) {
    Distance_summary part;
    for (std::size_t i = begin; i < end; ++i) {
      const double distance = std::sqrt(CGAL::squared_distance(points[i], tree.closest_point(points[i])));
      part.maximum = (std::max)(part.maximum, distance);
      part.sum += distance;
    }
    parts[block] = part;
  });
  Distance_summary total;
  for (const Distance_summary& part : parts) {
    total.maximum = (std::max)(total.maximum, part.maximum);
    total.sum += part.sum;
  }
  return total;
}

struct One_sided_distance
{
  double hausdorff;
  double mean;
};

// From the samples of a surface, and its vertices, to another one.
template <class ConcurrencyTag>
One_sided_distance one_sided_distance(const std::vector<Distance_point>& samples, const std::vector<Distance_point>& vertices,
                                      const std::vector<Distance_triangle>& other)
{
  Distance_tree tree(other.begin(), other.end());
  tree.build();                          // here rather than at the first query, for which several threads would wait
  tree.accelerate_distance_queries();    // pays from some hundred queries on
  const Distance_summary from_samples = summarize_distances<ConcurrencyTag>(samples, tree);
  const Distance_summary from_vertices = summarize_distances<ConcurrencyTag>(vertices, tree);
  return {(std::max)(from_samples.maximum, from_vertices.maximum), from_samples.sum / double(samples.size())};
}

} // namespace measures
} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_MEASURES_ONE_SIDED_DISTANCE_H
