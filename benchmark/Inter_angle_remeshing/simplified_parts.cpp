// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parts that were simplified by edge collapses, which breaks their sharp edges: by default, with nothing as a feature, and by PMP with the
// edges of 40 degrees and more marked. Per number of faces, sums and means over the parts as a table in Markdown.
//
//   simplified_parts [mesh...]       triangle meshes; parts of CGAL's data where none is given

#include "Result_row.h"

#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>

#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <cstddef>
#include <string>
#include <vector>

namespace IAR = CGAL::Inter_angle_remeshing;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace parameters = CGAL::parameters;

namespace {

constexpr std::size_t NUMBERS_OF_FACES[] = {4000, 2500, 2000, 1000};
// Of the mean edge length of what was simplified.
constexpr double LENGTH = 0.5;

Mesh simplified(Mesh mesh, std::size_t faces)
{
  const auto are_few = [&](const auto& /* cost */, const auto& /* profile */, auto /* initial */, auto edges) {
    return edges <= 3 * faces / 2; };
  CGAL::Surface_mesh_simplification::edge_collapse(mesh, are_few);
  mesh.collect_garbage();
  return mesh;
}

void remesh_by_pmp(Mesh& mesh, double length)
{
  const auto marks = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_constrained", false).first;
  PMP::detect_sharp_edges(mesh, 40, marks);
  PMP::isotropic_remeshing(faces(mesh), length, mesh, parameters::number_of_iterations(10).edge_is_constrained_map(marks));
}

}

int main(int argc, char* argv[])
{
  std::vector<std::string> paths(argv + 1, argv + argc);
  if (paths.empty())
    for (const char* name : {"anchor_dense", "couplingdown", "fandisk", "part", "pinion", "rotor", "turbine"})
      paths.push_back(CGAL::data_file_path(std::string("meshes/") + name + ".off"));
  Result_row::print_head("faces");
  for (const std::size_t n : NUMBERS_OF_FACES) {
    Result_row ours{"ours"}, plain{"no features"}, peer{"PMP"};
    for (const std::string& path : paths) {
      const Mesh mesh = read_mesh(path);
      if (mesh.number_of_faces() < 5 * n / 4) continue;
      const Mesh input = simplified(mesh, n);
      const double length = LENGTH * mean_edge_length(input);
      ours.add(input, input, length, [&](Mesh& m) { IAR::isotropic_remeshing(length, m); });
      plain.add(input, input, length, [&](Mesh& m) { IAR::isotropic_remeshing(length, m, parameters::sharpness_angle(180)); });
      peer.add(input, input, length, [&](Mesh& m) { remesh_by_pmp(m, length); });
    }
    for (const Result_row* row : {&ours, &plain, &peer}) row->print(double(n), peer);
  }
}
