// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_GEOMETRY_SOLVE_BY_CHOLESKY_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_GEOMETRY_SOLVE_BY_CHOLESKY_H

#include <array>
#include <cmath>
#include <cstddef>

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

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_GEOMETRY_SOLVE_BY_CHOLESKY_H
