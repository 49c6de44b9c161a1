// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_RUN_PASSES_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_RUN_PASSES_H

#include <CGAL/Inter_angle_remeshing/Remeshing_report.h>
#include <CGAL/Inter_angle_remeshing/internal/Remeshing_context.h>
#include <CGAL/Inter_angle_remeshing/internal/Schedule.h>

// The door to the passes: what lies behind it knows no type of the user's, and takes the compiler longer than all the rest.
// Behind a macro it is compiled once for many programs, see compiled_passes.h.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

struct Run_result
{
  Remeshing_report report;
  bool has_target_length;                // false: cancelled before that, the run has nothing to show
};

// Remeshes the mesh of the context. The report begins as that of a run that does nothing.
template <class ConcurrencyTag>
Run_result run_passes(Remeshing_context& context, const Schedule& schedule, const Remeshing_report& report);

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#ifndef CGAL_INTER_ANGLE_REMESHING_COMPILED
#  include <CGAL/Inter_angle_remeshing/internal/Remesher.h>
#endif

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_RUN_PASSES_H
