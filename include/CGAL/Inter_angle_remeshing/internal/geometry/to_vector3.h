// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_GEOMETRY_TO_VECTOR3_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_GEOMETRY_TO_VECTOR3_H

#include <CGAL/Inter_angle_remeshing/internal/geometry/Vector3.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

template <class T, class = void>
struct Is_lazy : std::false_type {};
template <class T>
struct Is_lazy<T, std::void_t<decltype(std::declval<const T&>().exact(), std::declval<const T&>().approx().is_point())>>
  : std::true_type {};

// What CGAL::to_double() makes of a lazy number depends on whether its exact value has been asked for; this does not.
template <class Number>
double exact_to_double(const Number& x)
{
  if constexpr (Is_lazy<Number>::value) {
    if (!x.approx().is_point()) return CGAL::to_double(x.exact());
  }
  return CGAL::to_double(x);
}

// From a point or vector of any kernel, or of an application's own type. The namespace of that may have a function by this name, too: to be
// called with the package's.
template <class Triple>
Vector3 to_vector3(const Triple& t)
{
  return {exact_to_double(t.x()), exact_to_double(t.y()), exact_to_double(t.z())};
}

// The same in another unit of length; what is so far away that squares of coordinates would not be finite is brought nearer.
template <class Point>
Vector3 to_vector3(const Point& p, double unit)
{
  constexpr double FARTHEST = 1e150;
  const auto bounded = [=](double x) { return (std::min)((std::max)(x, -FARTHEST), FARTHEST); };
  const Vector3 q = (1 / unit) * internal::to_vector3(p);
  return {bounded(q.x), bounded(q.y), bounded(q.z)};
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_GEOMETRY_TO_VECTOR3_H
