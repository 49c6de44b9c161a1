// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTER_ANGLE_REMESHING_BENCHMARK_REMESHERS_H
#define INTER_ANGLE_REMESHING_BENCHMARK_REMESHERS_H

#include "Triangle_soup.h"

#include <cstddef>

// One function for each library beside CGAL, in a source file of its own: none sees the headers of another. All run in one thread.

// pmp-library, uniform_remeshing(): ten iterations, as by default.
Timed_soup remesh_by_pmp_library(const Triangle_soup& input, double length);

// VCGlib, IsotropicRemeshing: ten iterations, creases from 30 degrees on, results within 1% of the diagonal, as MeshLab's default is.
Timed_soup remesh_by_vcglib(const Triangle_soup& input, double length);

// Mmg, mmgs with `hsiz`: edges from 45 degrees on are ridges, as by default. The tolerance, whose default is a length, is a tenth of the
// target length: the angles are as poor with others, and the distances greater.
Timed_soup remesh_by_mmg(const Triangle_soup& input, double length);

// Geogram, remesh_smooth(): a centroidal Voronoi tessellation by 5 iterations of Lloyd and 30 of Newton, as by default.
Timed_soup remesh_by_geogram(const Triangle_soup& input, std::size_t points);

#endif // INTER_ANGLE_REMESHING_BENCHMARK_REMESHERS_H
