// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_FIT_EQUATIONS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_FIT_EQUATIONS_H

#include <CGAL/Inter_angle_remeshing/internal/geometry/Vector3.h>

#include <array>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// A symmetric 3 by 3 matrix.
struct Symmetric_matrix
{
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;

  // a I + b n nᵀ
  static Symmetric_matrix axial(double a, double b, const Vector3& n)
  {
    return {a + b * n.x * n.x, b * n.x * n.y, b * n.x * n.z, a + b * n.y * n.y, b * n.y * n.z, a + b * n.z * n.z};
  }
  Vector3 operator*(const Vector3& v) const
  {
    return {xx * v.x + xy * v.y + xz * v.z, xy * v.x + yy * v.y + yz * v.z, xz * v.x + yz * v.y + zz * v.z};
  }
  Symmetric_matrix& operator+=(const Symmetric_matrix& m)
  {
    xx += m.xx; xy += m.xy; xz += m.xz; yy += m.yy; yz += m.yz; zz += m.zz;
    return *this;
  }
  // Zero where there is none.
  Symmetric_matrix inverse() const
  {
    const double a = yy * zz - yz * yz, b = xz * yz - xy * zz, c = xy * yz - xz * yy;
    const double determinant = xx * a + xy * b + xz * c;
    if (!(determinant > 0)) return {};
    const double i = 1 / determinant;
    return {i * a, i * b, i * c, i * (xx * zz - xz * xz), i * (xy * xz - xx * yz), i * (xx * yy - xy * xy)};
  }
};

// What the samples on a face say about its corners.
class Face_equations
{
public:
  void add(const std::array<double, 3>& b, const Vector3& n, double weight, double r)
  {
    const float x = float(n.x), y = float(n.y), z = float(n.z);
    const float outer[6] = {x * x, x * y, x * z, y * y, y * z, z * z};
    for (int i = 0; i < 6; ++i) {
      const float w = float(weight * b[PAIRS[i][0]] * b[PAIRS[i][1]]);
      for (int j = 0; j < 6; ++j) matrix_[i][j] += w * outer[j];
    }
    for (int i = 0; i < 3; ++i) {
      const double w = weight * r * b[i];
      right_[i][0] += float(w * n.x); right_[i][1] += float(w * n.y); right_[i][2] += float(w * n.z);
    }
  }
  // The corners have moved by x: the samples have that much less to travel.
  void subtract(const std::array<Vector3, 3>& x)
  {
    const std::array<Vector3, 3> product = *this * x;
    for (int i = 0; i < 3; ++i) {
      right_[i][0] -= float(product[i].x); right_[i][1] -= float(product[i].y); right_[i][2] -= float(product[i].z);
    }
  }
  Symmetric_matrix diagonal(int i) const { return block(i); }
  Vector3 right(int i) const { return {right_[i][0], right_[i][1], right_[i][2]}; }
  // The rows of the three corners times x.
  std::array<Vector3, 3> operator*(const std::array<Vector3, 3>& x) const
  {
    const Symmetric_matrix b01 = block(3), b12 = block(4), b20 = block(5);
    return {block(0) * x[0] + b01 * x[1] + b20 * x[2], b01 * x[0] + block(1) * x[1] + b12 * x[2],
            b20 * x[0] + b12 * x[1] + block(2) * x[2]};
  }

private:
  static constexpr int PAIRS[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {2, 0}};

  Symmetric_matrix block(int i) const
  {
    const float* m = matrix_[i];
    return {m[0], m[1], m[2], m[3], m[4], m[5]};
  }

  float matrix_[6][6] = {};      // Σ w b_i b_j n nᵀ, by pair of corners
  float right_[3][3] = {};       // Σ w r b_i n
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_FIT_EQUATIONS_H
