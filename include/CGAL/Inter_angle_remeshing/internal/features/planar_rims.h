// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_PLANAR_RIMS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_PLANAR_RIMS_H

#include <CGAL/Inter_angle_remeshing/internal/features/Face_normals.h>
#include <CGAL/Inter_angle_remeshing/internal/features/Model_kind.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// A planar part has at least so many faces, those of a polygon of twelve corners, and the area of so many squares of the mean edge of
// its rim. This is that of a cut or a base if this part of its length is this sharp: the terraces of isosurfaces of voxels meet at 45
// degrees.
constexpr std::size_t LEAST_PLANAR_FACES = 10;
constexpr double LEAST_PLANAR_AREA = 1, RIM_ANGLE = 60, LEAST_RIM_SHARE = 0.5;

// Whether the planar part around a face, all of whose faces look the way that it does, is that of a cut or a base: nothing that has
// grown has any. Its faces are marked as seen; of the edges of its rim the sharp ones are added to `rim`.
inline void add_rim_of_planar_part(const Face_normals& normals, Remeshing_mesh::Index first, std::vector<char>& is_seen,
                                   std::vector<Remeshing_mesh::Index>& rim)
{
  using Index = Remeshing_mesh::Index;
  const Remeshing_mesh& mesh = normals.mesh();
  const double clear = cosine_of_degrees(RIM_ANGLE), least = cosine_of_degrees(Model_kind::LEAST_ANGLE);
  const std::size_t before = rim.size();
  std::vector<Index> part = {first};
  is_seen[first] = 1;
  std::size_t edges_of_rim = 0;
  double area = 0, length_of_rim = 0, length_of_clear = 0;
  for (std::size_t i = 0; i < part.size(); ++i) {
    area += normals.doubled_area(part[i]) / 2;
    for (Index h = 4 * part[i]; h < 4 * part[i] + 3; ++h) {
      const Index o = mesh.opposite(h);
      if (o < 0) continue;
      const Index f = o >> 2;
      if (normals.are_parallel(first, f)) {
        if (!is_seen[f]) part.push_back(f);
        is_seen[f] = 1;
      } else {
        const double c = normals.cosine(h), l = std::sqrt(mesh.squared_edge_length(h));
        ++edges_of_rim;
        length_of_rim += l;
        length_of_clear += c <= clear ? l : 0;
        if (c <= least) rim.push_back((std::min)(h, o));
      }
    }
  }
  const double mean_length = length_of_rim / double(edges_of_rim);
  if (part.size() < LEAST_PLANAR_FACES || area < LEAST_PLANAR_AREA * mean_length * mean_length ||
      length_of_clear < LEAST_RIM_SHARE * length_of_rim) rim.resize(before);
}

// The edges of the rims of cuts and bases beside these sharp edges, sorted.
inline std::vector<Remeshing_mesh::Index> planar_rims(const Face_normals& normals, const std::vector<Remeshing_mesh::Index>& sharp_edges)
{
  using Index = Remeshing_mesh::Index;
  const Remeshing_mesh& mesh = normals.mesh();
  std::vector<Index> result;
  std::vector<char> is_seen(mesh.number_of_face_slots(), 0);
  for (const Index h : sharp_edges)
    for (const Index side : {h, mesh.opposite(h)})
      if (!is_seen[side >> 2]) add_rim_of_planar_part(normals, side >> 2, is_seen, result);
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_PLANAR_RIMS_H
