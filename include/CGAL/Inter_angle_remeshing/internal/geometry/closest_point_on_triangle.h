// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_GEOMETRY_CLOSEST_POINT_ON_TRIANGLE_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_GEOMETRY_CLOSEST_POINT_ON_TRIANGLE_H

#include <CGAL/Inter_angle_remeshing/internal/geometry/Vector3.h>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// Where on a triangle abc the closest point lies.
enum class Triangle_part { interior, edge_ab, edge_bc, edge_ca, vertex_a, vertex_b, vertex_c };

struct Point_on_triangle
{
  Vector3 point;
  Triangle_part part = Triangle_part::interior;
};

// The point of the segment at the fraction numerator / denominator; its start where the segment has no length.
inline Vector3 point_at_fraction(const Vector3& start, const Vector3& direction, double numerator, double denominator)
{
  return denominator > 0 ? start + (numerator / denominator) * direction : start;
}

// The point of the triangle abc closest to q, by the Voronoi regions of its vertices and edges
// (C. Ericson, Real-Time Collision Detection, section 5.1.5). Degenerate triangles are allowed.
inline Point_on_triangle closest_point_on_triangle(const Vector3& q, const Vector3& a, const Vector3& b, const Vector3& c)
{
  const Vector3 ab = b - a, ac = c - a, aq = q - a, bq = q - b, cq = q - c;
  const double ab_aq = dot(ab, aq), ac_aq = dot(ac, aq), ab_bq = dot(ab, bq), ac_bq = dot(ac, bq), ab_cq = dot(ab, cq), ac_cq = dot(ac, cq);
  const double weight_a = ab_bq * ac_cq - ab_cq * ac_bq, weight_b = ab_cq * ac_aq - ab_aq * ac_cq,
               weight_c = ab_aq * ac_bq - ab_bq * ac_aq, sum = weight_a + weight_b + weight_c;
  const auto in_interior = [&]() -> Point_on_triangle {
    return {a + (weight_b / sum) * ab + (weight_c / sum) * ac, Triangle_part::interior}; };
  // Most often: one branch for that is foretold better than seven.
  if (int(weight_a > 0) & int(weight_b > 0) & int(weight_c > 0)) return in_interior();

  if (ab_aq <= 0 && ac_aq <= 0) return {a, Triangle_part::vertex_a};
  if (ab_bq >= 0 && ac_bq <= ab_bq) return {b, Triangle_part::vertex_b};
  if (weight_c <= 0 && ab_aq >= 0 && ab_bq <= 0)
    return {point_at_fraction(a, ab, ab_aq, ab_aq - ab_bq), Triangle_part::edge_ab};
  if (ac_cq >= 0 && ab_cq <= ac_cq) return {c, Triangle_part::vertex_c};
  if (weight_b <= 0 && ac_aq >= 0 && ac_cq <= 0)
    return {point_at_fraction(a, ac, ac_aq, ac_aq - ac_cq), Triangle_part::edge_ca};
  const double from_b = ac_bq - ab_bq, from_c = ab_cq - ac_cq;
  if (weight_a <= 0 && from_b >= 0 && from_c >= 0)
    return {point_at_fraction(b, c - b, from_b, from_b + from_c), Triangle_part::edge_bc};
  return sum > 0 ? in_interior() : Point_on_triangle{a, Triangle_part::vertex_a};
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_GEOMETRY_CLOSEST_POINT_ON_TRIANGLE_H
