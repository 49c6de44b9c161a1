// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_CURVES_SETTLE_CORNERS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_CURVES_SETTLE_CORNERS_H

#include <CGAL/Inter_angle_remeshing/internal/arguments/target_of_run.h>
#include <CGAL/Inter_angle_remeshing/internal/compiled.h>
#include <CGAL/Inter_angle_remeshing/internal/features/input_kind.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/Remeshing_mesh.h>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// Merges vertices of curves that are closer together than so many target lengths, 0: none, and locks the corners of the curves.
CGAL_INTER_ANGLE_REMESHING_INLINE
void settle_corners(Remeshing_mesh& mesh, const Input_kind& kind, const Target& target, double merging_distance);

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#ifndef CGAL_INTER_ANGLE_REMESHING_COMPILED
#  include <CGAL/Inter_angle_remeshing/internal/curves/settle_corners_impl.h>
#endif

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_CURVES_SETTLE_CORNERS_H
