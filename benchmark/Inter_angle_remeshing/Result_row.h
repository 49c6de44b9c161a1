// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTER_ANGLE_REMESHING_BENCHMARK_RESULT_ROW_H
#define INTER_ANGLE_REMESHING_BENCHMARK_RESULT_ROW_H

#include "meshes.h"
#include "timing.h"

#include <CGAL/Inter_angle_remeshing/surface_distance.h>
#include <CGAL/Inter_angle_remeshing/triangle_quality.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <vector>

constexpr double NEEDLE = 20;       // degrees

inline std::size_t number_of_needles(const Mesh& mesh)
{
  return std::size_t(std::count_if(mesh.faces_begin(), mesh.faces_end(), [&](Mesh::Face_index f) {
    const auto h = mesh.halfedge(f);
    const auto &p = mesh.point(mesh.source(h)), &q = mesh.point(mesh.target(h)), &r = mesh.point(mesh.target(mesh.next(h)));
    return (std::min)({CGAL::approximate_angle(p, q, r), CGAL::approximate_angle(q, r, p), CGAL::approximate_angle(r, p, q)}) < NEEDLE;
  }));
}

// A row of a table in Markdown: sums and means over some inputs.
struct Result_row
{
  const char* name;
  std::size_t faces = 0, needles = 0;
  double least = 0, average = 0, hausdorff = 0, mean = 0;     // sums over the inputs
  std::vector<double> times = {};

  static void print_head(const char* first)
  {
    std::printf("| %s | | faces | under 20° | least angle | θ_avg | Hd | Md | PMP : ours |\n|---|---|---|---|---|---|---|---|---|\n",
                first);
  }

  // Distances are those from the reference, in units.
  template <class Remesh>
  void add(const Mesh& input, const Mesh& reference, double unit, const Remesh& remesh)
  {
    namespace IAR = CGAL::Inter_angle_remeshing;
    Mesh result;
    times.push_back(seconds(input, result, remesh));
    const auto angles = IAR::inter_angle_statistics(result);
    const IAR::Surface_distance distance = IAR::surface_distance(reference, result);
    faces += result.number_of_faces();
    needles += number_of_needles(result);
    least += angles.minimum_angle;
    average += angles.average;
    hausdorff += distance.hausdorff() / unit;
    mean += distance.mean() / unit;
  }

  void print(double first, const Result_row& peer) const
  {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < times.size(); ++i) ratios.push_back(peer.times[i] / times[i]);
    const double n = double((std::max)(times.size(), std::size_t(1)));
    std::printf("| %g | %s | %zu | %zu | %.1f | %.2f | %.3f | %.4f | ", first, name, faces, needles, least / n, average / n,
                hausdorff / n, mean / n);
    if (this == &peer) std::printf("|\n");
    else std::printf("%.1f |\n", median(ratios));
  }
};

#endif // INTER_ANGLE_REMESHING_BENCHMARK_RESULT_ROW_H
