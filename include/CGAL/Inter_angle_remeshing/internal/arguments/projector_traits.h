// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_ARGUMENTS_PROJECTOR_TRAITS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_ARGUMENTS_PROJECTOR_TRAITS_H

#include <type_traits>
#include <utility>

// What the projectors of this package have that other functors have not.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

template <class Functor>
using Reference_surface_of = decltype(std::declval<const Functor&>().reference_surface());
template <class Functor, class = void>
struct Has_reference_surface : std::false_type {};
template <class Functor>
struct Has_reference_surface<Functor, std::void_t<Reference_surface_of<Functor>>> : std::true_type {};

template <class Functor>
using Mls_surface_of = decltype(std::declval<const Functor&>().mls_surface());
template <class Functor, class = void>
struct Has_mls_surface : std::false_type {};
template <class Functor>
struct Has_mls_surface<Functor, std::void_t<Mls_surface_of<Functor>>> : std::true_type {};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_ARGUMENTS_PROJECTOR_TRAITS_H
