// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_COMPILED_PASSES_H
#define CGAL_INTER_ANGLE_REMESHING_COMPILED_PASSES_H

/*!
\file
\ingroup PkgInterAngleRemeshingRef

The one source file that compiles the passes for a program of many. Where `CGAL_INTER_ANGLE_REMESHING_COMPILED` is defined
`isotropic_remeshing.h` leaves their definitions out, and those that find features and fit surfaces, so that it compiles in a
third of the time; a source file that includes nothing but this header compiles them once, with the same options. CMake's
target `CGAL::Inter_angle_remeshing_compiled` does both.
*/

#ifndef CGAL_INTER_ANGLE_REMESHING_COMPILED
#  define CGAL_INTER_ANGLE_REMESHING_COMPILED
#endif

#include <CGAL/Inter_angle_remeshing/internal/Remesher.h>
#include <CGAL/Inter_angle_remeshing/internal/curves/settle_corners_impl.h>
#include <CGAL/Inter_angle_remeshing/internal/features/feature_detection_impl.h>
#include <CGAL/Inter_angle_remeshing/internal/features/input_kind_impl.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/Mls_surface_impl.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/run_on_surface_impl.h>

#include <CGAL/tags.h>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

template Run_result run_passes<CGAL::Sequential_tag>(Remeshing_context&, const Schedule&, const Remeshing_report&);
#ifdef CGAL_LINKED_WITH_TBB
template Run_result run_passes<CGAL::Parallel_tag>(Remeshing_context&, const Schedule&, const Remeshing_report&);
#endif

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_COMPILED_PASSES_H
