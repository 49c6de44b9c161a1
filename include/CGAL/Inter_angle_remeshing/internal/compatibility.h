// Copyright (c) 2026 The Inter_angle_remeshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_COMPATIBILITY_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_COMPATIBILITY_H

// What changed its name between CGAL 5.5 and 6.x, under one name. No other header asks for CGAL's version.

#include <CGAL/version.h>

#if CGAL_VERSION_NR >= 1060000000
#  include <CGAL/AABB_traits_3.h>
#  include <CGAL/AABB_triangle_primitive_3.h>
#else
#  include <CGAL/AABB_traits.h>
#  include <CGAL/AABB_triangle_primitive.h>
#endif

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

#if CGAL_VERSION_NR >= 1060000000
template <class GeomTraits, class Primitive>
using AABB_traits = CGAL::AABB_traits_3<GeomTraits, Primitive>;

template <class GeomTraits, class Iterator>
using AABB_triangle_primitive = CGAL::AABB_triangle_primitive_3<GeomTraits, Iterator>;
#else
template <class GeomTraits, class Primitive>
using AABB_traits = CGAL::AABB_traits<GeomTraits, Primitive>;

template <class GeomTraits, class Iterator>
using AABB_triangle_primitive = CGAL::AABB_triangle_primitive<GeomTraits, Iterator>;
#endif

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_COMPATIBILITY_H
