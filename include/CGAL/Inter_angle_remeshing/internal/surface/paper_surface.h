// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_PAPER_SURFACE_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_PAPER_SURFACE_H

#include <CGAL/Inter_angle_remeshing/internal/compiled.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/Reference_surface.h>

#include <functional>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// The surface of the paper: MLS on the up-sampled facets. Empty where there is no sample.
CGAL_INTER_ANGLE_REMESHING_INLINE
std::function<Vector3(const Vector3&)> paper_surface(const Reference_surface& facets,
                                                     const std::vector<Remeshing_mesh::Index>& creases);

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#ifndef CGAL_INTER_ANGLE_REMESHING_COMPILED
#  include <CGAL/Inter_angle_remeshing/internal/surface/paper_surface_impl.h>
#endif

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_PAPER_SURFACE_H
