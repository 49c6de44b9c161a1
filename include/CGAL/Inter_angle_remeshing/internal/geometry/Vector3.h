// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_GEOMETRY_VECTOR3_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_GEOMETRY_VECTOR3_H

#include <cmath>
#include <initializer_list>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// A point or a vector of plain doubles: what the hot loops compute with.
// The user's kernel stays at the border: see to_vector3.h.
struct Vector3
{
  double x = 0, y = 0, z = 0;

  Vector3& operator+=(const Vector3& v) { x += v.x; y += v.y; z += v.z; return *this; }
};

inline Vector3 operator+(const Vector3& a, const Vector3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vector3 operator-(const Vector3& a, const Vector3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vector3 operator*(double s, const Vector3& a) { return {s * a.x, s * a.y, s * a.z}; }
inline bool operator==(const Vector3& a, const Vector3& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }
inline bool operator!=(const Vector3& a, const Vector3& b) { return !(a == b); }

inline double dot(const Vector3& a, const Vector3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

inline Vector3 cross(const Vector3& a, const Vector3& b)
{
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline double squared_length(const Vector3& a) { return dot(a, a); }
inline double length(const Vector3& a) { return std::sqrt(squared_length(a)); }
inline double squared_distance(const Vector3& a, const Vector3& b) { return squared_length(a - b); }

inline bool is_finite(const Vector3& a)
{
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

// Twice the area times the unit normal of the triangle abc.
inline Vector3 triangle_cross(const Vector3& a, const Vector3& b, const Vector3& c)
{
  return cross(b - a, c - a);
}

// u divided by its length; zero where it has none.
inline Vector3 unit(const Vector3& u)
{
  const double l = length(u);
  return l > 0 ? (1 / l) * u : Vector3();
}

// Two unit vectors that make an orthonormal frame with the unit vector n (T. Duff et al., JCGT 6(1), 2017).
inline void complete_frame(const Vector3& n, Vector3& t1, Vector3& t2)
{
  const double sign = std::copysign(1., n.z), a = -1 / (sign + n.z), b = n.x * n.y * a;
  t1 = {1 + sign * n.x * n.x * a, sign * b, -sign * n.x};
  t2 = {b, sign + n.y * n.y * a, -n.y};
}

// Whether the angle between u and v is under 90 degrees and its cosine at least `cosine` (>= 0).
// Products are compared: no root, and a zero vector fails.
inline bool is_cosine_at_least(const Vector3& u, const Vector3& v, double cosine)
{
  const double d = dot(u, v);
  return d > 0 && d * d >= cosine * cosine * squared_length(u) * squared_length(v);
}

// Whether the triangle abc with this cross product is too thin for its normal to mean anything in double precision.
inline bool is_degenerate(const Vector3& cross_product, const Vector3& a, const Vector3& b, const Vector3& c)
{
  constexpr double THINNEST = 1e-8;    // altitude over longest edge
  double longest = squared_distance(a, b);
  for (const double l : {squared_distance(b, c), squared_distance(c, a)}) longest = l > longest ? l : longest;
  return squared_length(cross_product) <= THINNEST * THINNEST * longest * longest;
}

// The cosine of the angle at `apex` between the directions to `a` and `b`; 1 where one of them has no length,
// as in a needle whose short side has shrunk to nothing.
inline double corner_cosine(const Vector3& apex, const Vector3& a, const Vector3& b)
{
  const Vector3 u = a - apex, v = b - apex;
  const double product = length(u) * length(v);
  return product > 0 ? dot(u, v) / product : 1.;
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_GEOMETRY_VECTOR3_H
