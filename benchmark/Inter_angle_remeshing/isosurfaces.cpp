// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Implicit surfaces by marching tetrahedra, cylinders that meet and sheets of a gyroid, whose creases are jagged: by default, without
// features, and by PMP. Per target length, in mean edge lengths, sums and means over the surfaces as a table in Markdown.
//
//   isosurfaces

#include "Result_row.h"

#include "../../test/Inter_angle_remeshing/marching_tetrahedra.h"

#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>

#include <CGAL/Polygon_mesh_processing/remesh.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace IAR = CGAL::Inter_angle_remeshing;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace parameters = CGAL::parameters;

namespace {

constexpr double FACTORS[] = {.5, 1, 1.5, 2};
constexpr int NUMBERS_OF_CELLS[] = {27, 40, 55};

// Three families of parallel cylinders.
double lattice(double x, double y, double z)
{
  const auto from_axis = [](double a) { return std::abs(a - std::floor(a) - .5); };
  const double u = from_axis(x), v = from_axis(y), w = from_axis(z);
  return (std::min)({std::hypot(u, v), std::hypot(v, w), std::hypot(u, w)}) - .09;
}

double gyroid(double x, double y, double z)
{
  return std::abs(std::sin(x) * std::cos(y) + std::sin(y) * std::cos(z) + std::sin(z) * std::cos(x)) - .5;
}

}

int main()
{
  std::vector<Mesh> surfaces;
  for (const int n : NUMBERS_OF_CELLS) {
    surfaces.push_back(meshes::to_mesh<Mesh>(meshes::marching_tetrahedra(-.1, 2.1, n, lattice)));
    surfaces.push_back(meshes::to_mesh<Mesh>(meshes::marching_tetrahedra(0, 6.3, n, gyroid)));
  }
  Result_row::print_head("length");
  for (const double factor : FACTORS) {
    Result_row ours{"ours"}, smooth{"no features"}, peer{"PMP"};
    for (const Mesh& surface : surfaces) {
      const double length = factor * mean_edge_length(surface);
      ours.add(surface, surface, length, [&](Mesh& m) { IAR::isotropic_remeshing(length, m); });
      smooth.add(surface, surface, length, [&](Mesh& m) { IAR::isotropic_remeshing(length, m, parameters::sharpness_angle(180)); });
      peer.add(surface, surface, length, [&](Mesh& m) {
        PMP::isotropic_remeshing(faces(m), length, m, parameters::number_of_iterations(10)); });
    }
    for (const Result_row* row : {&ours, &smooth, &peer}) row->print(factor, peer);
  }
}
