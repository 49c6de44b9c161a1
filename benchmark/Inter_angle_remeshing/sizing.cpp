// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lengths by curvature against one length everywhere, at equal numbers of faces, as a table in Markdown; with CGAL 6, beside
// PMP's adaptive field, whose tolerance is set such that it yields as many faces.
//
//   sizing [mesh...]

#include "meshes.h"

#include <CGAL/Inter_angle_remeshing/Curvature_sizing_field.h>
#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>
#include <CGAL/Inter_angle_remeshing/surface_distance.h>
#include <CGAL/Inter_angle_remeshing/triangle_quality.h>

#if CGAL_VERSION_NR >= 1060000000
#  include <CGAL/Polygon_mesh_processing/Adaptive_sizing_field.h>
#  include <CGAL/Polygon_mesh_processing/remesh.h>
#endif
#include <CGAL/Real_timer.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace IAR = CGAL::Inter_angle_remeshing;

namespace {

constexpr int RUNS = 5;

// The median of the times; the field is a part of it.
template <class Remesh>
double seconds(const Mesh& input, Mesh& result, const Remesh& remesh)
{
  std::vector<double> times;
  for (int i = 0; i < RUNS; ++i) {
    result = input;
    CGAL::Real_timer timer;
    timer.start();
    remesh(result);
    times.push_back(timer.time());
  }
  result.collect_garbage();
  std::nth_element(times.begin(), times.begin() + RUNS / 2, times.end());
  return times[RUNS / 2];
}

void print_row(const std::string& name, const char* who, const Mesh& input, const Mesh& result, double time)
{
  const auto angles = IAR::inter_angle_statistics(result);
  const auto distance = IAR::surface_distance(input, result);
  std::printf("| %s | %s | %zu | %.0f..%.0f | %.1f | %.4f | %.2f | %.3f |\n", name.c_str(), who,
              std::size_t(result.number_of_faces()), angles.minimum_angle, angles.maximum_angle, angles.average, 100 * distance.relative_mean(),
              100 * distance.relative_hausdorff(), time);
  std::fflush(stdout);
}

void compare(const std::string& file)
{
  const Mesh input = read_mesh(file);
  const std::string name = file.substr(file.find_last_of('/') + 1);
  const double length = mean_edge_length(input), tolerance = 0.02 * length;
  const std::pair<double, double> range(length / 3, 3 * length);
  Mesh curved, uniform;
  const double curved_time = seconds(input, curved, [&](Mesh& m) {
    IAR::isotropic_remeshing(IAR::Curvature_sizing_field<Mesh>(tolerance, range, faces(m), m), m); });
  const std::size_t number = curved.number_of_faces();
  const double uniform_time = seconds(input, uniform, [&](Mesh& m) { IAR::isotropic_remeshing(IAR::Face_count(number), m); });
  print_row(name, "curvature", input, curved, curved_time);
  print_row("", "uniform", input, uniform, uniform_time);
#if CGAL_VERSION_NR >= 1060000000
  namespace PMP = CGAL::Polygon_mesh_processing;
  Mesh theirs;
  double their_tolerance = tolerance, their_time = 0;
  for (int trial = 0; trial < 5; ++trial) {
    their_time = seconds(input, theirs, [&](Mesh& m) {
      PMP::Adaptive_sizing_field<Mesh> field(their_tolerance, range, faces(m), m);
      PMP::isotropic_remeshing(faces(m), field, m, CGAL::parameters::number_of_iterations(10));
    });
    const double ratio = double(theirs.number_of_faces()) / double(number);
    if (std::abs(ratio - 1) < 0.03) break;
    their_tolerance *= ratio;
  }
  print_row("", "PMP, adaptive", input, theirs, their_time);
#endif
}

} // namespace

int main(int argc, char* argv[])
{
  std::printf("| model | | faces | θ | θ_avg | Md %% | Hd %% | s |\n|---|---|---|---|---|---|---|---|\n");
  if (argc > 1)
    for (int i = 1; i < argc; ++i) compare(argv[i]);
  else
    for (const char* name : {"elephant", "armadillo", "fandisk", "lion-head"})
      compare(CGAL::data_file_path(std::string("meshes/") + name + ".off"));
}
