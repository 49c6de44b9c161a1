// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_COMPILED_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_COMPILED_H

// In front of functions whose definitions only compiled_passes.h includes where CGAL_INTER_ANGLE_REMESHING_COMPILED is defined.
#ifdef CGAL_INTER_ANGLE_REMESHING_COMPILED
#  define CGAL_INTER_ANGLE_REMESHING_INLINE
#else
#  define CGAL_INTER_ANGLE_REMESHING_INLINE inline
#endif

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_COMPILED_H
