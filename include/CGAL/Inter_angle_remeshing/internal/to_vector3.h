// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_TO_VECTOR3_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_TO_VECTOR3_H

#include <CGAL/Inter_angle_remeshing/internal/Vector3.h>

#include <CGAL/number_utils.h>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// From a point or vector of any kernel.
template <class Triple>
Vector3 to_vector3(const Triple& t)
{
  return {CGAL::to_double(t.x()), CGAL::to_double(t.y()), CGAL::to_double(t.z())};
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_TO_VECTOR3_H
