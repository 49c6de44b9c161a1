// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Alpha wraps of parts, whose edges have become jagged chamfers: by default, with all edges of 40 degrees and more as features, and
// by PMP. Per target length, in mean edge lengths, sums and means over the wraps as a table in Markdown.
//
//   wraps [mesh...]       triangle meshes, wrapped at a 30th and a 60th of their diagonals; parts of CGAL's data where none is given

#include "Result_row.h"

#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/alpha_wrap_3.h>

#include <cmath>
#include <string>
#include <vector>

namespace IAR = CGAL::Inter_angle_remeshing;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace parameters = CGAL::parameters;

namespace {

constexpr double FACTORS[] = {.5, 1, 2, 4}, PARTS_OF_DIAGONAL[] = {30, 60};

Mesh alpha_wrap(const Mesh& mesh, double alpha)
{
  Mesh result;
  CGAL::alpha_wrap_3(mesh, alpha, alpha / 20, result);
  return result;
}

}

int main(int argc, char* argv[])
{
  std::vector<std::string> paths(argv + 1, argv + argc);
  if (paths.empty())
    for (const char* name : {"anchor", "couplingdown", "fandisk", "joint", "part", "pinion", "rotor", "spool"})
      paths.push_back(CGAL::data_file_path(std::string("meshes/") + name + ".off"));
  std::vector<Mesh> wraps;
  for (const std::string& path : paths) {
    const Mesh mesh = read_mesh(path);
    const CGAL::Bbox_3 b = PMP::bbox(mesh);
    const double diagonal = std::hypot(b.xmax() - b.xmin(), b.ymax() - b.ymin(), b.zmax() - b.zmin());
    for (const double part : PARTS_OF_DIAGONAL) wraps.push_back(alpha_wrap(mesh, diagonal / part));
  }
  Result_row::print_head("length");
  for (const double factor : FACTORS) {
    Result_row ours{"ours"}, sharp{"all edges of 40°"}, peer{"PMP"};
    for (const Mesh& wrap : wraps) {
      const double length = factor * mean_edge_length(wrap);
      ours.add(wrap, wrap, length, [&](Mesh& m) { IAR::isotropic_remeshing(length, m); });
      sharp.add(wrap, wrap, length, [&](Mesh& m) { IAR::isotropic_remeshing(length, m, parameters::sharpness_angle(40)); });
      peer.add(wrap, wrap, length, [&](Mesh& m) { PMP::isotropic_remeshing(faces(m), length, m, parameters::number_of_iterations(10)); });
    }
    for (const Result_row* row : {&ours, &sharp, &peer}) row->print(factor, peer);
  }
}
