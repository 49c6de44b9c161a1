// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTER_ANGLE_REMESHING_BENCHMARK_CROSSING_PAIRS_H
#define INTER_ANGLE_REMESHING_BENCHMARK_CROSSING_PAIRS_H

#include "meshes.h"

#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

// How many pairs of faces cross each other.
inline std::size_t crossing_pairs(const Mesh& mesh)
{
  std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> pairs;
  CGAL::Polygon_mesh_processing::self_intersections(mesh, std::back_inserter(pairs));
  return pairs.size();
}

#endif // INTER_ANGLE_REMESHING_BENCHMARK_CROSSING_PAIRS_H
