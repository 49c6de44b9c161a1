// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_MEASURES_ANGLE_ACCUMULATOR_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_MEASURES_ANGLE_ACCUMULATOR_H

#include <CGAL/Inter_angle_remeshing/Inter_angle_statistics.h>
#include <CGAL/Inter_angle_remeshing/internal/measures/triangle_coordinates.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {
namespace measures {

inline double dot_product(const Coordinates& u, const Coordinates& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }

inline Coordinates cross_product(const Coordinates& u, const Coordinates& v)
{
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

// Half the vector from `a` to `b`: the difference of any two finite numbers, halved, is finite.
inline Coordinates half_difference(const Coordinates& a, const Coordinates& b)
{
  return {.5 * b[0] - .5 * a[0], .5 * b[1] - .5 * a[1], .5 * b[2] - .5 * a[2]};
}

// The edges of a triangle, edge i opposite of corner i, scaled by a power of two (that is, without rounding) such that
// the largest component is about 1: angles stay the same, and fourth powers of lengths neither overflow nor vanish.
inline Triangle_coordinates normalized_edges(const Triangle_coordinates& corners)
{
  // 2^1000 lifts even the smallest denormal number far enough; a larger factor would not be finite.
  constexpr int SMALLEST_EXPONENT = -1000;
  Triangle_coordinates edges = {half_difference(corners[1], corners[2]), half_difference(corners[2], corners[0]),
                                half_difference(corners[0], corners[1])};
  double largest = 0;
  for (const Coordinates& edge : edges)
    for (const double component : edge) largest = (std::max)(largest, std::abs(component));
  int exponent = 0;
  std::frexp(largest, &exponent);
  const double factor = std::ldexp(1., -(std::max)(exponent, SMALLEST_EXPONENT));
  for (Coordinates& edge : edges)
    for (double& component : edge) component *= factor;
  return edges;
}

// Twice the area of the triangle with these edges. The two shorter edges lose the fewest digits.
inline double doubled_area(const Triangle_coordinates& edges)
{
  std::size_t longest = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (dot_product(edges[i], edges[i]) > dot_product(edges[longest], edges[longest])) longest = i;
  const Coordinates normal = cross_product(edges[(longest + 1) % 3], edges[(longest + 2) % 3]);
  return std::hypot(normal[0], normal[1], normal[2]);    // squares could vanish
}

// Sums up faces; divides at the end.
class Angle_accumulator
{
  static constexpr double DEGREES_PER_RADIAN = 180 / CGAL_PI, IDEAL_ANGLE = 60;

public:
  void add(const Triangle_coordinates& corners)
  {
    ++statistics_.number_of_faces;
    const Triangle_coordinates edges = normalized_edges(corners);
    const double cross = doubled_area(edges);
    if (cross == 0) add_degenerate();
    else
      for (std::size_t i = 0; i < 3; ++i) add_angle(corner_angle(edges[(i + 1) % 3], edges[(i + 2) % 3], cross));
  }

  void add_interior_vertex(std::size_t valence)
  {
    std::vector<std::size_t>& bins = statistics_.valence_histogram;
    if (bins.size() <= valence) bins.resize(valence + 1, 0);
    ++bins[valence];
  }

  Inter_angle_statistics result() const
  {
    Inter_angle_statistics result = statistics_;
    if (result.number_of_faces > 0) {
      result.minimum_angle = smallest_;
      result.maximum_angle = largest_;
    }
    const std::size_t number_of_angles = 3 * (result.number_of_faces - result.number_of_degenerate_faces);
    if (number_of_angles > 0) result.average = IDEAL_ANGLE - deviation_ / double(number_of_angles);
    return result;
  }

private:
  // The edges follow one another around the triangle: one of the two points towards their common corner, hence the
  // sign. atan2 is accurate at every angle, unlike acos, which loses half of the digits near 0 and 180 degrees.
  static double corner_angle(const Coordinates& u, const Coordinates& v, double cross)
  {
    return std::atan2(cross, -dot_product(u, v)) * DEGREES_PER_RADIAN;
  }

  void add_degenerate()
  {
    ++statistics_.number_of_degenerate_faces;
    smallest_ = 0;
    largest_ = 180;
  }

  void add_angle(double angle)
  {
    smallest_ = (std::min)(smallest_, angle);
    largest_ = (std::max)(largest_, angle);
    deviation_ += std::abs(angle - IDEAL_ANGLE);
    const std::size_t bin = std::size_t(angle / Inter_angle_statistics::bin_width);
    ++statistics_.histogram[(std::min)(bin, statistics_.histogram.size() - 1)];
  }

  Inter_angle_statistics statistics_;    // the counts; the angles are entered in the result only
  double smallest_ = 180, largest_ = 0;
  double deviation_ = 0;                 // the sum of |angle - 60|
};

} // namespace measures
} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_MEASURES_ANGLE_ACCUMULATOR_H
