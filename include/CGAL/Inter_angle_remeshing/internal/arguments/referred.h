// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_ARGUMENTS_REFERRED_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_ARGUMENTS_REFERRED_H

#include <functional>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// What the user handed over, be it by `std::ref` or by value.
template <class Given>
const Given& referred(const Given& given) { return given; }
template <class Given>
const Given& referred(const std::reference_wrapper<Given>& given) { return given.get(); }

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_ARGUMENTS_REFERRED_H
