// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_GEOMETRY_SAMPLE_TREE_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_GEOMETRY_SAMPLE_TREE_H

#include <CGAL/Inter_angle_remeshing/internal/geometry/Vector3.h>

#include <CGAL/Dimension.h>
#include <CGAL/Euclidean_distance.h>
#include <CGAL/Kd_tree.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits.h>
#include <CGAL/Splitters.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// Nearest neighbors in a set of numbered points. Queries are const and run concurrently.
class Sample_tree
{
public:
  // Of points in the same place only the first is kept: a bucket of equal points cannot be split.
  explicit Sample_tree(const std::vector<Vector3>& points) : Sample_tree(without_doubles(points)) {}
  bool empty() const { return tree_.empty(); }

  std::size_t nearest(const Vector3& q) const
  {
    return Search(tree_, to_sample(q), 1).begin()->first.number;
  }
  // The numbers of the k nearest points, nearest first; of all of them where there are fewer.
  std::vector<std::size_t> nearest(const Vector3& q, unsigned k) const
  {
    std::vector<std::size_t> result;
    const Search search(tree_, to_sample(q), unsigned((std::min)(std::size_t(k), std::size_t(tree_.size()))));
    for (const auto& found : search) result.push_back(found.first.number);
    return result;
  }

private:
  static constexpr unsigned BUCKET = 20;

  struct Sample
  {
    std::array<double, 3> coordinates;
    std::size_t number;
    bool operator==(const Sample& s) const { return number == s.number; }
  };
  struct Coordinate_iterator
  {
    using result_type = const double*;
    const double* operator()(const Sample& s) const { return s.coordinates.data(); }
    const double* operator()(const Sample& s, int) const { return s.coordinates.data() + 3; }
  };
  using Traits = CGAL::Search_traits<double, Sample, const double*, Coordinate_iterator, CGAL::Dimension_tag<3>>;
  using Splitter = CGAL::Midpoint_of_max_spread<Traits>;
  using Distance = CGAL::Euclidean_distance<Traits>;
  using Tree = CGAL::Kd_tree<Traits, Splitter>;
  using Search = CGAL::Orthogonal_k_neighbor_search<Traits, Distance, Splitter, Tree>;

  explicit Sample_tree(const std::vector<Sample>& samples) : tree_(samples.begin(), samples.end(), Splitter(BUCKET))
  {
    if (!samples.empty()) tree_.build();
  }

  static std::vector<Sample> without_doubles(const std::vector<Vector3>& points)
  {
    std::vector<Sample> samples;
    samples.reserve(points.size());
    for (const Vector3& p : points) samples.push_back({{p.x, p.y, p.z}, samples.size()});
    std::vector<Sample> sorted = samples;
    std::sort(sorted.begin(), sorted.end(), [](const Sample& a, const Sample& b) {
      return std::tie(a.coordinates, a.number) < std::tie(b.coordinates, b.number);
    });
    std::vector<char> is_double(points.size(), 0);
    for (std::size_t i = 1; i < sorted.size(); ++i)
      is_double[sorted[i].number] = sorted[i].coordinates == sorted[i - 1].coordinates;
    samples.erase(std::remove_if(samples.begin(), samples.end(),
                                 [&](const Sample& s) { return is_double[s.number] != 0; }), samples.end());
    return samples;
  }

  static Sample to_sample(const Vector3& q) { return {{q.x, q.y, q.z}, 0}; }

  Tree tree_;
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_GEOMETRY_SAMPLE_TREE_H
