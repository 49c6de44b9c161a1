// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_SECTOR_FIT_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_SECTOR_FIT_H

#include <CGAL/Inter_angle_remeshing/internal/Vector3.h>

#include <array>
#include <cmath>
#include <vector>

// The normal of a smooth surface at a vertex of its triangulation, by moving least squares: the height over the tangent
// plane is fitted by a cubic polynomial through the vertex, with weights that fall with the distance from it.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// Solves A x = b by the factorisation A = L Lᵀ, in place; false where A is not positive definite. The lower triangle of A
// is read.
template <std::size_t N>
bool solve_by_cholesky(std::array<std::array<double, N>, N>& a, std::array<double, N>& b)
{
  for (std::size_t j = 0; j < N; ++j) {
    double pivot = a[j][j];
    for (std::size_t k = 0; k < j; ++k) pivot -= a[j][k] * a[j][k];
    if (!(pivot > 0)) return false;
    const double inverse = 1 / std::sqrt(pivot);
    a[j][j] = inverse;
    for (std::size_t i = j + 1; i < N; ++i) {
      double sum = a[i][j];
      for (std::size_t k = 0; k < j; ++k) sum -= a[i][k] * a[j][k];
      a[i][j] = sum * inverse;
    }
  }
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t k = 0; k < i; ++k) b[i] -= a[i][k] * b[k];
    b[i] *= a[i][i];
  }
  for (std::size_t i = N; i-- > 0;) {
    for (std::size_t k = i + 1; k < N; ++k) b[i] -= a[k][i] * b[k];
    b[i] *= a[i][i];
  }
  return true;
}

// Two unit vectors that make an orthonormal frame with the unit vector n (T. Duff et al., JCGT 6(1), 2017).
inline void complete_frame(const Vector3& n, Vector3& t1, Vector3& t2)
{
  const double sign = std::copysign(1., n.z), a = -1 / (sign + n.z), b = n.x * n.y * a;
  t1 = {1 + sign * n.x * n.x * a, sign * b, -sign * n.x};
  t2 = {b, sign + n.y * n.y * a, -n.y};
}

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

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_SECTOR_FIT_H
