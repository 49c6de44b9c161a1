// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_GEOMETRY_LINEAR_COMBINATION_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_GEOMETRY_LINEAR_COMBINATION_H

#include <CGAL/IO/Color.h>
#include <CGAL/Origin.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>

// Sums of values with coefficients that add up to 1.

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
struct Array_size : std::integral_constant<std::size_t, 0> {};
template <class Number, std::size_t N>
struct Array_size<std::array<Number, N>> : std::integral_constant<std::size_t, N> {};

// Sums up the values of `value(i)`, i < n, of type Value, each times `coefficient(i)`; n > 0.
template <class Value, class Get, class Coefficient>
Value linear_combination(std::size_t n, const Get& value, const Coefficient& coefficient)
{
  if constexpr (Array_size<Value>::value > 0) {
    Value result;
    for (std::size_t k = 0; k < result.size(); ++k)
      result[k] = linear_combination<typename Value::value_type>(n, [&](std::size_t i) { return value(i)[k]; }, coefficient);
    return result;
  }
  else if constexpr (Is_linear<Value>::value) {
    using Sum = std::conditional_t<std::is_floating_point<Value>::value, decltype(1. * std::declval<Value>()), Value>;
    Sum sum(coefficient(0) * value(0));
    for (std::size_t i = 1; i < n; ++i) sum = Sum(sum + coefficient(i) * value(i));
    return Value(sum);
  }
  else if constexpr (std::is_same<Value, CGAL::IO::Color>::value) {
    const auto channel = [&](std::size_t k) {
      const double x = linear_combination<double>(n, [&](std::size_t i) { return double(value(i)[k]); }, coefficient);
      return static_cast<unsigned char>(std::lround((std::max)(0., (std::min)(255., x))));
    };
    return Value(channel(0), channel(1), channel(2), channel(3));
  }
  else if constexpr (Is_point<Value>::value) {
    auto sum = coefficient(0) * (value(0) - CGAL::ORIGIN);
    for (std::size_t i = 1; i < n; ++i) sum = sum + coefficient(i) * (value(i) - CGAL::ORIGIN);
    return Value(CGAL::ORIGIN + sum);
  }
  else {
    static_assert(Is_point<Value>::value,
                  "Attribute_transfer: values of this type cannot be interpolated linearly. Hand over a functor `Value operator()"
                  "(const std::array<Value, 3>&, const std::array<double, 3>&) const`, or `Nearest_value()` for ids and labels.");
    return value(0);
  }
}

template <class Value>
Value linear_combination(const std::array<Value, 3>& values, const std::array<double, 3>& coefficients)
{
  return linear_combination<Value>(3, [&](std::size_t i) -> const Value& { return values[i]; },
                                   [&](std::size_t i) { return coefficients[i]; });
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_GEOMETRY_LINEAR_COMBINATION_H
