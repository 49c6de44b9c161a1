// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meshes that are remeshed again and again to the mean edge length that they had at first, as in a simulation: by default, with the
// edges of 40 degrees and more marked in a map that each run hands over to the next one, and by PMP with such a map. A table in Markdown.
//
//   repetition [mesh...]       triangle meshes; some of CGAL's where none is given
//
// Distances are those from the first mesh, in target lengths.

#include "meshes.h"

#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>
#include <CGAL/Inter_angle_remeshing/surface_distance.h>
#include <CGAL/Inter_angle_remeshing/triangle_quality.h>

#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

namespace IAR = CGAL::Inter_angle_remeshing;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace parameters = CGAL::parameters;

namespace {

const std::vector<unsigned> REPORTED = {1, 2, 5, 10, 20};

template <class Remesh>
void repeat(const std::string& model, const Mesh& input, double length, const char* name, const Remesh& remesh)
{
  Mesh mesh = input;
  auto marks = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_constrained", false).first;
  PMP::detect_sharp_edges(mesh, 40, marks);
  for (unsigned run = 1; run <= REPORTED.back(); ++run) {
    remesh(mesh, marks);
    mesh.collect_garbage();
    if (std::find(REPORTED.begin(), REPORTED.end(), run) == REPORTED.end()) continue;
    const auto angles = IAR::inter_angle_statistics(mesh);
    const IAR::Surface_distance distance = IAR::surface_distance(input, mesh);
    std::printf("| %s | %s | %u | %zu | %.1f | %.1f | %.2f | %.3f | %.4f |\n", model.c_str(), name, run,
                std::size_t(mesh.number_of_faces()), angles.minimum_angle, angles.maximum_angle, angles.average,
                distance.hausdorff() / length, distance.mean() / length);
    std::fflush(stdout);
  }
}

} // namespace

int main(int argc, char** argv)
{
  std::vector<std::string> paths(argv + 1, argv + argc);
  if (paths.empty())
    for (const char* name : {"elephant", "fandisk", "turbine", "couplingdown", "oblong", "anchor"})
      paths.push_back(CGAL::data_file_path("meshes/" + std::string(name) + ".off"));
  std::printf("| model | | runs | faces | θ_min | θ_max | θ_avg | Hd | Md |\n|---|---|---|---|---|---|---|---|---|\n");
  for (const std::string& path : paths) {
    const Mesh input = read_mesh(path);
    const std::string model = path.substr(path.rfind('/') + 1);
    const double length = mean_edge_length(input);
    repeat(model, input, length, "ours", [&](Mesh& m, auto) { IAR::isotropic_remeshing(length, m); });
    repeat(model, input, length, "ours, marked", [&](Mesh& m, auto marks) {
      IAR::isotropic_remeshing(length, m, parameters::edge_is_constrained_map(marks));
    });
    repeat(model, input, length, "PMP, marked", [&](Mesh& m, auto marks) {
      PMP::isotropic_remeshing(faces(m), length, m, parameters::number_of_iterations(10).edge_is_constrained_map(marks));
    });
  }
}
