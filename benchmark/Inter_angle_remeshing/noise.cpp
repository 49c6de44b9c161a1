// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Models whose vertices are moved at random, by a normal distribution with the same standard deviation in each coordinate, in
// mean edge lengths: the triangles, the crossing pairs of faces, and the distances from the noisy input, beside PMP. A table in
// Markdown.

#include "meshes.h"
#include "timing.h"

#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>
#include <CGAL/Inter_angle_remeshing/surface_distance.h>
#include <CGAL/Inter_angle_remeshing/triangle_quality.h>

#include <CGAL/Polygon_mesh_processing/remesh.h>

#include <cstddef>
#include <cstdio>
#include <random>
#include <string>

namespace IAR = CGAL::Inter_angle_remeshing;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace parameters = CGAL::parameters;

namespace {

Mesh with_noise(Mesh mesh, double deviation)
{
  const double length = mean_edge_length(mesh);
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for (const auto v : mesh.vertices()) {
    const double x = normal(random), y = normal(random), z = normal(random);
    mesh.point(v) += deviation * length * Kernel::Vector_3(x, y, z);
  }
  return mesh;
}

void print(const Mesh& input, const Mesh& result)
{
  const IAR::Inter_angle_statistics angles = IAR::inter_angle_statistics(result);
  const IAR::Surface_distance distance = IAR::surface_distance(input, result);
  std::printf(" %zu | %.0f..%.0f | %.1f | %zu | %.2f | %.3f |", std::size_t(result.number_of_faces()), angles.minimum_angle,
              angles.maximum_angle, angles.average, crossing_pairs(result), 100 * distance.relative_hausdorff(),
              100 * distance.relative_mean());
}

}

int main()
{
  std::printf("| model, deviation, length | crossing before | faces | θ | θ_avg | crossing | Hd %% | Md %% "
              "| PMP: faces | θ | θ_avg | crossing | Hd %% | Md %% | PMP : ours |\n"
              "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const char* name : {"elephant", "homer", "bear", "camel", "armadillo"})
    for (const double deviation : {.15, .25, .35}) {
      const Mesh input = with_noise(read_mesh(CGAL::data_file_path(std::string("meshes/") + name + ".off")), deviation);
      for (const double factor : {1., 2.}) {
        const double length = factor * mean_edge_length(input);
        Mesh ours, theirs;
        const double our_time = seconds(input, ours, [&](Mesh& m) { IAR::isotropic_remeshing(length, m); });
        const double their_time = seconds(input, theirs, [&](Mesh& m) {
          PMP::isotropic_remeshing(faces(m), length, m, parameters::number_of_iterations(10)); });
        std::printf("| %s, %.2g, %g | %zu |", name, deviation, factor, crossing_pairs(input));
        print(input, ours);
        print(input, theirs);
        std::printf(" %.1f |\n", their_time / our_time);
      }
    }
}
