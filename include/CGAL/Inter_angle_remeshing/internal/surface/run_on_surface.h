// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_RUN_ON_SURFACE_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_RUN_ON_SURFACE_H

#include <CGAL/Inter_angle_remeshing/Recipe.h>
#include <CGAL/Inter_angle_remeshing/Remeshing_report.h>
#include <CGAL/Inter_angle_remeshing/internal/arguments/target_of_run.h>
#include <CGAL/Inter_angle_remeshing/internal/compiled.h>
#include <CGAL/Inter_angle_remeshing/internal/curves/Input_curves.h>
#include <CGAL/Inter_angle_remeshing/internal/features/input_kind.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/projection.h>

#include <functional>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

using Run_on_surface = std::function<Remeshing_report(const Projection&)>;

// Calls `run` with the projection onto the surface of the mesh itself, the one that the recipe says. A wanted number of faces is one of
// that surface: the target length follows its area.
CGAL_INTER_ANGLE_REMESHING_INLINE
Remeshing_report run_on_own_surface(Remeshing_mesh& mesh, const Recipe& recipe, const Input_kind& kind, Input_curves& curves,
                                    Target& target, const Run_on_surface& run);

// The same with a surface that the user handed over. `mls`, if there is one, smooths it and knows no other.
CGAL_INTER_ANGLE_REMESHING_INLINE
Remeshing_report run_on_handed_surface(const Reference_surface& surface, const Mls_surface* mls, Remeshing_mesh& mesh,
                                       const Run_on_surface& run);

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#ifndef CGAL_INTER_ANGLE_REMESHING_COMPILED
#  include <CGAL/Inter_angle_remeshing/internal/surface/run_on_surface_impl.h>
#endif

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_RUN_ON_SURFACE_H
