// Copyright (c) 2026 The Inter_angle_remeshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_TEST_MARCHING_TETRAHEDRA_H
#define CGAL_INTER_ANGLE_REMESHING_TEST_MARCHING_TETRAHEDRA_H

#include "meshes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace meshes {

// The surface f(x, y, z) = 0 in the cube [low, high]^3, closed by its sides, of n³ cells of six tetrahedra each: needles where it
// passes near a corner of a cell, and jagged creases. `f` is negative inside.
template <class Function>
Soup marching_tetrahedra(double low, double high, int n, const Function& f)
{
  using Cell = std::array<int, 3>;
  const double step = (high - low) / n;
  const auto value = [&](const Cell& c) {
    for(const int i : c)
      if(i == 0 || i == n)
        return 1.;
    return f(low + step * c[0], low + step * c[1], low + step * c[2]);
  };
  std::map<Cell, double> values;
  for(int i = 0; i <= n; ++i)
    for(int j = 0; j <= n; ++j)
      for(int k = 0; k <= n; ++k)
        values[{i, j, k}] = value({i, j, k});

  Soup soup;
  std::map<std::pair<Cell, Cell>, std::size_t> vertices;
  const auto vertex = [&](const Cell& a, const Cell& b) {
    const auto [place, is_new] = vertices.emplace(std::minmax(a, b), soup.points.size());
    if(is_new)
    {
      const Cell &c = place->first.first, &d = place->first.second;
      const double t = values[c] / (values[c] - values[d]);
      std::array<double, 3> p;
      for(int m = 0; m < 3; ++m)
        p[m] = low + step * (c[m] + t * (d[m] - c[m]));
      soup.points.push_back(p);
    }
    return place->second;
  };
  // The tetrahedra of a cell lie around its diagonal; these are their ways from one end of it to the other, of even permutations first.
  const std::array<std::array<int, 3>, 6> ways = {{{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j)
      for(int k = 0; k < n; ++k)
        for(std::size_t w = 0; w < ways.size(); ++w)
        {
          std::array<Cell, 4> corners = {Cell{i, j, k}};
          for(int m = 0; m < 3; ++m)
          {
            corners[m + 1] = corners[m];
            ++corners[m + 1][ways[w][m]];
          }
          std::vector<int> inside, outside;
          for(int c = 0; c < 4; ++c)
            (values[corners[c]] < 0 ? inside : outside).push_back(c);
          if(inside.empty() || outside.empty())
            continue;
          // Of an even permutation of the corners, the first ones of them inside, the triangle looks outwards.
          std::array<int, 4> order;
          std::copy(outside.begin(), outside.end(), std::copy(inside.begin(), inside.end(), order.begin()));
          int inversions = w < 3 ? 0 : 1;
          for(int a = 0; a < 4; ++a)
            for(int b = 0; b < a; ++b)
              inversions += order[b] > order[a];
          const auto at = [&](int a, int b) { return vertex(corners[order[a]], corners[order[b]]); };
          std::vector<std::size_t> polygon;
          if(inside.size() == 1)
            polygon = {at(0, 1), at(0, 2), at(0, 3)};
          else if(inside.size() == 3)
            polygon = {at(0, 3), at(1, 3), at(2, 3)};
          else
            polygon = {at(0, 2), at(0, 3), at(1, 3), at(1, 2)};
          if(inversions % 2 != 0)
            std::reverse(polygon.begin(), polygon.end());
          for(std::size_t v = 2; v < polygon.size(); ++v)
            soup.faces.push_back({polygon[0], polygon[v - 1], polygon[v]});
        }
  return soup;
}

} // namespace meshes

#endif // CGAL_INTER_ANGLE_REMESHING_TEST_MARCHING_TETRAHEDRA_H
