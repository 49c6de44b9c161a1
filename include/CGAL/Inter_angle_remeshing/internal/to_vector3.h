// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_TO_VECTOR3_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_TO_VECTOR3_H

#include <CGAL/Inter_angle_remeshing/internal/Vector3.h>

#include <CGAL/number_utils.h>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// From a point or vector of any kernel.
template <class Triple>
Vector3 to_vector3(const Triple& t)
{
  return {CGAL::to_double(t.x()), CGAL::to_double(t.y()), CGAL::to_double(t.z())};
}

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

// The same for the points of a mesh, which are read more than once.
template <class Point>
Vector3 exact_to_vector3(const Point& p)
{
  return {exact_to_double(p.x()), exact_to_double(p.y()), exact_to_double(p.z())};
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_TO_VECTOR3_H
