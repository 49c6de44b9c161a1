// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The paper's figures beside those of the paper's rules as this package has them, of its default, and of
// Polygon_mesh_processing, as a table in Markdown.
//
//   reproduction T0.obj        (the first model of the paper; any mesh will do, the printed row is that of T0)

#include "meshes.h"

#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>
#include <CGAL/Inter_angle_remeshing/surface_distance.h>
#include <CGAL/Inter_angle_remeshing/triangle_quality.h>

#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Real_timer.h>

#include <cstdio>

namespace IAR = CGAL::Inter_angle_remeshing;
namespace parameters = CGAL::parameters;

namespace {

template <class Remesh>
void row(const char* name, const Mesh& input, const Remesh& remesh)
{
  Mesh mesh = input;
  CGAL::Real_timer timer;
  timer.start();
  remesh(mesh);
  timer.stop();
  mesh.collect_garbage();
  const IAR::Inter_angle_statistics angles = IAR::inter_angle_statistics(mesh);
  const auto distance = IAR::surface_distance(input, mesh);
  std::printf("| %s | %zu | %.4f | %.5f | %.1f | %.1f | %.3f |\n", name, std::size_t(mesh.number_of_faces()),
              distance.relative_hausdorff(), distance.relative_mean(), angles.maximum_angle, angles.average, timer.time());
}

} // namespace

int main(int argc, char** argv)
{
  if (argc != 2) {
    std::fprintf(stderr, "usage: reproduction MESH\n");
    return 1;
  }
  const Mesh input = read_mesh(argv[1]);
  const double length = mean_edge_length(input);
  std::printf("| | faces | Hd | Md | θ_max | θ_avg | s |\n|---|---|---|---|---|---|---|\n"
              "| printed, T0 | about 20000 | .0179 | .0015 | 118.7 | 52.8 | 8.9 |\n");
  row("Recipe::paper()", input, [&](Mesh& mesh) {
    IAR::isotropic_remeshing(faces(mesh), length, mesh,
                             IAR::recipe(IAR::Recipe::paper(), parameters::number_of_iterations(10)));
  });
  row("default", input, [&](Mesh& mesh) {
    IAR::isotropic_remeshing(faces(mesh), length, mesh, parameters::number_of_iterations(10));
  });
  row("PMP", input, [&](Mesh& mesh) {
    CGAL::Polygon_mesh_processing::isotropic_remeshing(faces(mesh), length, mesh, parameters::number_of_iterations(10));
  });
}
