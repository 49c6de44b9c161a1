// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_LINEAR_COMBINATION_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_LINEAR_COMBINATION_H

#include <CGAL/Origin.h>

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

// Sums of three values with coefficients that add up to 1.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

template <class Value, class = void>
struct Is_linear : std::false_type {};
template <class Value>
struct Is_linear<Value, std::void_t<decltype(Value(1. * std::declval<const Value&>() + 1. * std::declval<const Value&>()))>>
  : std::bool_constant<!std::is_integral<Value>::value && !std::is_enum<Value>::value> {};

template <class Value, class = void>
struct Is_point : std::false_type {};
template <class Value>
struct Is_point<Value, std::void_t<decltype(Value(CGAL::ORIGIN + 1. * (std::declval<const Value&>() - CGAL::ORIGIN)))>>
  : std::true_type {};

template <class Value>
Value linear_combination(const std::array<Value, 3>& values, const std::array<double, 3>& coefficients)
{
  if constexpr (Is_linear<Value>::value)
    return Value(coefficients[0] * values[0] + coefficients[1] * values[1] + coefficients[2] * values[2]);
  else {
    static_assert(Is_point<Value>::value,
                  "Attribute_transfer: values of this type cannot be interpolated linearly. Hand over a functor `Value operator()"
                  "(const std::array<Value, 3>&, const std::array<double, 3>&) const`, or `Nearest_value()` for ids and labels.");
    return Value(CGAL::ORIGIN + (coefficients[0] * (values[0] - CGAL::ORIGIN) + coefficients[1] * (values[1] - CGAL::ORIGIN) +
                                 coefficients[2] * (values[2] - CGAL::ORIGIN)));
  }
}

template <class Number, std::size_t N>
std::array<Number, N> linear_combination(const std::array<std::array<Number, N>, 3>& values,
                                         const std::array<double, 3>& coefficients)
{
  std::array<Number, N> result;
  for (std::size_t i = 0; i < N; ++i)
    result[i] = linear_combination(std::array<Number, 3>{values[0][i], values[1][i], values[2][i]}, coefficients);
  return result;
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_LINEAR_COMBINATION_H
