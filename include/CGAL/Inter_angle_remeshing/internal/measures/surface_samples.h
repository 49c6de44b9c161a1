// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_MEASURES_SURFACE_SAMPLES_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_MEASURES_SURFACE_SAMPLES_H

#include <CGAL/Inter_angle_remeshing/internal/measures/Normalized_surface.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <random>
#include <string>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {
namespace measures {

// Random numbers that are the same everywhere: the standard fixes the generator, but none of its distributions.
class Unit_interval_generator
{
public:
  explicit Unit_interval_generator(std::uint64_t seed) : generator_(seed) {}

  // uniform in [0, 1): the upper 53 bits, as many as a double has
  double operator()() { return double(generator_() >> 11) * 0x1p-53; }

private:
  std::mt19937_64 generator_;
};

inline double doubled_area(const Distance_triangle& t)
{
  return std::sqrt(CGAL::cross_product(t[1] - t[0], t[2] - t[0]).squared_length());
}

// A point of `t` from two numbers in [0, 1): a parallelogram is filled evenly, and folded along its diagonal.
inline Distance_point point_in_triangle(const Distance_triangle& t, double along_first, double along_second)
{
  if (along_first + along_second > 1) {
    along_first = 1 - along_first;
    along_second = 1 - along_second;
  }
  return t[0] + along_first * (t[1] - t[0]) + along_second * (t[2] - t[0]);
}

// The surface is laid out as one strip of its triangles and cut in `number` pieces of equal area; each piece gets one
// random point. Every area has the expected number of samples as with independent ones, at a smaller variance.
inline std::vector<Distance_point> sample_surface(const Normalized_surface& surface, std::size_t number, std::uint64_t seed,
                                                  const std::string& name)
{
  double total_area = 0;
  for (const Distance_triangle& t : surface.triangles) total_area += doubled_area(t);
  if (total_area == 0)
    refuse("area(tm) > 0", name + " has no area, so there is no mean distance from it", __FILE__, __LINE__);

  Unit_interval_generator random(seed);
  std::vector<Distance_point> samples;
  samples.reserve(number);
  auto triangle = surface.triangles.begin();
  double end_of_triangle = doubled_area(*triangle);    // on the strip
  for (std::size_t i = 0; i < number; ++i) {
    const double position = (double(i) + random()) / double(number) * total_area;
    while (end_of_triangle <= position && std::next(triangle) != surface.triangles.end())
      end_of_triangle += doubled_area(*++triangle);
    const double along_first = random();    // one by one: the order in which arguments are evaluated is not fixed
    const double along_second = random();
    samples.push_back(point_in_triangle(*triangle, along_first, along_second));
  }
  return samples;
}

} // namespace measures
} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_MEASURES_SURFACE_SAMPLES_H
