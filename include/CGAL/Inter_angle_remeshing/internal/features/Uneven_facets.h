// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_UNEVEN_FACETS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_UNEVEN_FACETS_H

#include <CGAL/Inter_angle_remeshing/internal/features/Face_normals.h>
#include <CGAL/Inter_angle_remeshing/internal/geometry/thin_angles.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/mesh_regions.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// Whether the faces of a mesh are facets, of what was designed or is a hull, and not samples of a surface, which are of about one size.
// Where a part was simplified to some hundred faces, few large facets lie beside many small ones, and a good part of the area is in thin
// faces, along what is straight in one direction.
class Uneven_facets
{
  using Index = Remeshing_mesh::Index;

  // The part of the area that is in very thin faces at least, and the part of the faces, the largest ones, that half of the area is in
  // at most. What has grown has less of the former or more of the latter, but for a few models, on which the facets are right, too.
  static constexpr double LEAST_THIN_SHARE = 0.2, MOST_LARGE_SHARE = 0.29;
  // So many planar polygons, at most, are few if half of the area is in them: simplified stairs of voxels have nearly four times as many.
  static constexpr std::size_t FEW = 50;

public:
  explicit Uneven_facets(const Face_normals& normals)
    : normals_(normals)
  {
    std::vector<double> areas(normals.doubled_areas().begin(), normals.doubled_areas().end());
    if (thin_area() < LEAST_THIN_SHARE * std::accumulate(areas.begin(), areas.end(), 0.)) return;
    const double most = MOST_LARGE_SHARE * double(areas.size());
    are_there_ = double(number_in_half(std::move(areas))) <= most;
    are_few_ = are_there_ && number_in_half(areas_of_polygons()) <= FEW;
  }

  bool are_there() const { return are_there_; }
  // Whether they are there, and half of the area is in few of them.
  bool are_few() const { return are_few_; }

private:
  // These are twice the areas.
  double thin_area() const
  {
    const Remeshing_mesh& mesh = normals_.mesh();
    double sum = 0;
    for (Index f = 0; f < Index(mesh.number_of_face_slots()); ++f) {
      const auto& v = mesh.face_record(f).vertex;
      if (squared_sine_of_smallest_angle(mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2])) < VERY_THIN_SQUARED_SINE)
        sum += normals_.doubled_area(f);
    }
    return sum;
  }
  std::vector<double> areas_of_polygons() const
  {
    const Remeshing_mesh& mesh = normals_.mesh();
    std::vector<Index> number(mesh.number_of_face_slots(), -1);
    std::vector<double> areas;
    for (Index first = 0; first < Index(number.size()); ++first) {
      if (number[first] >= 0) continue;
      double sum = 0;
      for (const Index f : component_of(mesh, first, number, [&](Index h) { return normals_.are_parallel(first, mesh.opposite(h) >> 2); }))
        sum += normals_.doubled_area(f);
      areas.push_back(sum);
    }
    return areas;
  }

  // How many of these areas, the largest ones, make up half of all.
  static std::size_t number_in_half(std::vector<double> areas)
  {
    const double half = std::accumulate(areas.begin(), areas.end(), 0.) / 2;
    std::sort(areas.begin(), areas.end(), std::greater<>());
    std::size_t n = 0;
    for (double sum = 0; n < areas.size() && sum < half; ++n) sum += areas[n];
    return n;
  }

  const Face_normals& normals_;
  bool are_there_ = false, are_few_ = false;
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_UNEVEN_FACETS_H
