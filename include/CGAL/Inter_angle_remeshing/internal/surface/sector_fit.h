// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_SECTOR_FIT_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_SECTOR_FIT_H

#include <CGAL/Inter_angle_remeshing/internal/geometry/Vector3.h>
#include <CGAL/Inter_angle_remeshing/internal/geometry/solve_by_cholesky.h>

#include <array>
#include <cmath>
#include <vector>

// The normal of a smooth surface at a vertex of its triangulation, by moving least squares: the height over the tangent
// plane is fitted by a cubic polynomial through the vertex, with weights that fall with the distance from it.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// The normal at the origin of `offsets`, the neighbors' positions relative to the vertex. `start` is a unit normal to
// begin with, `scale` the mean distance to the first neighbors.
inline Vector3 fit_normal(const std::vector<Vector3>& offsets, const Vector3& start, double scale)
{
  // Of the linear, quadratic and cubic coefficients; relative to the sum of the weights.
  constexpr double RIDGE[3] = {1e-6, 3e-4, 3e-3};
  // A fit that turns the normal by more than 30 degrees is no fit.
  constexpr double LARGEST_TURN_COSINE = 0.86;
  constexpr std::size_t N = 9;
  Vector3 t1, t2;
  complete_frame(start, t1, t2);

  std::array<std::array<double, N>, N> a{};
  std::array<double, N> b{};
  double total = 0;
  for (const Vector3& offset : offsets) {
    const Vector3 d = (1 / scale) * offset;
    const double x = dot(d, t1), y = dot(d, t2), z = dot(d, start), w = std::exp(-squared_length(d));
    const std::array<double, N> row = {x, y, x * x, x * y, y * y, x * x * x, x * x * y, x * y * y, y * y * y};
    for (std::size_t i = 0; i < N; ++i) {
      const double wi = w * row[i];
      for (std::size_t j = 0; j <= i; ++j) a[i][j] += wi * row[j];
      b[i] += wi * z;
    }
    total += w;
  }
  for (std::size_t i = 0; i < N; ++i) a[i][i] += RIDGE[i < 2 ? 0 : i < 5 ? 1 : 2] * total;
  if (!solve_by_cholesky(a, b)) return start;
  const Vector3 n = start - b[0] * t1 - b[1] * t2;
  const Vector3 unit = (1 / length(n)) * n;
  return dot(unit, start) >= LARGEST_TURN_COSINE ? unit : start;
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_SECTOR_FIT_H
