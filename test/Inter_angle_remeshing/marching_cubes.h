// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_TEST_MARCHING_CUBES_H
#define CGAL_INTER_ANGLE_REMESHING_TEST_MARCHING_CUBES_H

#include "meshes.h"

#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace meshes {

// Of the fans of triangles that a polygon can be cut into, the one whose triangles lie in a plane with the next one most often, as in
// the usual tables.
inline std::vector<std::array<std::size_t, 3>> flattest_fan(const std::vector<std::array<double, 3>>& points,
                                                            const std::vector<std::size_t>& polygon)
{
  const auto normal = [&](const std::array<std::size_t, 3>& t)
  {
    const auto &p = points[t[0]], &q = points[t[1]], &r = points[t[2]];
    std::array<double, 3> result;
    for(int k = 0; k < 3; ++k)
    {
      const int l = (k + 1) % 3, m = (k + 2) % 3;
      result[k] = (q[l] - p[l]) * (r[m] - p[m]) - (q[m] - p[m]) * (r[l] - p[l]);
    }
    return result;
  };
  const auto are_coplanar = [](const std::array<double, 3>& a, const std::array<double, 3>& b)
  {
    const auto dot = [](const auto& u, const auto& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; };
    return dot(a, b) > 0 && dot(a, b) * dot(a, b) == dot(a, a) * dot(b, b);      // the coordinates are halves
  };
  std::vector<std::array<std::size_t, 3>> best;
  int most_coplanar = -1;
  for(std::size_t apex = 0; apex < polygon.size(); ++apex)
  {
    const auto corner = [&](std::size_t i) { return polygon[(apex + i) % polygon.size()]; };
    std::vector<std::array<std::size_t, 3>> fan;
    int coplanar = 0;
    for(std::size_t i = 2; i < polygon.size(); ++i)
    {
      fan.push_back({corner(0), corner(i - 1), corner(i)});
      if(i > 2)
        coplanar += are_coplanar(normal(fan[i - 3]), normal(fan[i - 2]));
    }
    if(coplanar > most_coplanar)
    {
      most_coplanar = coplanar;
      best = fan;
    }
  }
  return best;
}

// The surface around the voxels that `is_marked(x, y, z)` names, among those from 0 to `size` - 1 along each axis: what marching cubes
// make of a segmentation. Each vertex is the middle between a marked voxel and a neighbor that is not; marked voxels that share no
// more than an edge are apart.
template <class Predicate>
Soup marching_cubes(const std::array<int, 3>& size, const Predicate& is_marked)
{
  using Voxel = std::array<int, 3>;
  // The corners of the faces of a cube, as bits for each axis, counterclockwise from outside.
  constexpr int FACES[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  Soup result;
  std::map<std::pair<Voxel, Voxel>, std::size_t> number;
  Voxel cube;
  const auto voxel = [&](int corner) { return Voxel{cube[0] + (corner & 1), cube[1] + (corner >> 1 & 1), cube[2] + (corner >> 2)}; };
  const auto is_inside = [&](const Voxel& v)
  {
    for(int k = 0; k < 3; ++k)
      if(v[k] < 0 || v[k] >= size[k])
        return false;
    return bool(is_marked(v[0], v[1], v[2]));
  };
  const auto vertex = [&](int inside, int outside)
  {
    const Voxel a = voxel(inside), b = voxel(outside);
    const auto entry = number.emplace(std::make_pair(a, b), result.points.size());
    if(entry.second)
      result.points.push_back({(a[0] + b[0]) / 2., (a[1] + b[1]) / 2., (a[2] + b[2]) / 2.});
    return entry.first->second;
  };
  for(cube[0] = -1; cube[0] < size[0]; ++cube[0])
    for(cube[1] = -1; cube[1] < size[1]; ++cube[1])
      for(cube[2] = -1; cube[2] < size[2]; ++cube[2])
      {
        std::array<bool, 8> inside;
        for(int c = 0; c < 8; ++c)
          inside[c] = is_inside(voxel(c));
        // On each face, from where the surface begins to go around a run of marked corners to where that ends.
        std::map<std::size_t, std::size_t> next;
        for(const auto& face : FACES)
          for(int first = 0; first < 4; ++first)
          {
            if(!inside[face[first]] || inside[face[(first + 3) % 4]])
              continue;
            int last = first;
            while(inside[face[(last + 1) % 4]])
              ++last;
            next[vertex(face[first], face[(first + 3) % 4])] = vertex(face[last % 4], face[(last + 1) % 4]);
          }
        while(!next.empty())
        {
          std::vector<std::size_t> polygon;
          for(auto entry = next.begin(); entry != next.end(); entry = next.find(polygon.back()))
          {
            polygon.push_back(entry->second);
            next.erase(entry);
          }
          const auto triangles = flattest_fan(result.points, polygon);
          result.faces.insert(result.faces.end(), triangles.begin(), triangles.end());
        }
      }
  return result;
}

} // namespace meshes

#endif // CGAL_INTER_ANGLE_REMESHING_TEST_MARCHING_CUBES_H
