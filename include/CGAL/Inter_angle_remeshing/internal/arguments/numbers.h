// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_ARGUMENTS_NUMBERS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_ARGUMENTS_NUMBERS_H

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/number_utils.h>

#include <type_traits>

// What stands for a number, or for a bool, in the arguments of isotropic_remeshing().

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// CGAL's traits know its own number types, but not all of the language's: std::size_t is missing.
template <class T>
using Is_number = std::bool_constant<
  !std::is_same<T, bool>::value &&
  (std::is_arithmetic<T>::value ||
   !std::is_same<typename CGAL::Algebraic_structure_traits<T>::Algebraic_category, CGAL::Null_tag>::value)>;

template <class T>
double number_to_double(const T& x)
{
  if constexpr (std::is_arithmetic<T>::value) return double(x); else return CGAL::to_double(x);
}

// An arithmetic type, or a type whose member `value` is a bool, as CGAL::Tag_true.
template <class T, class = void>
struct Is_choice : std::is_arithmetic<T> {};
template <class T>
struct Is_choice<T, std::void_t<std::integral_constant<bool, T::value>>> : std::is_convertible<T, bool> {};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_ARGUMENTS_NUMBERS_H
