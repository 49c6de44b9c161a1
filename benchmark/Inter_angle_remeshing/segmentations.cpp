// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Surfaces of segmentations: what marching cubes make of the voxels whose centres are in a model, cubes and slices three times as
// thick. They are remeshed by default, with all edges of 40 degrees and more as features, and by PMP. Per target length, in mean edge
// lengths, sums and means over the segmentations as a table in Markdown; distances are those from the model, in voxels. The stairs'
// own come first.
//
//   segmentations [mesh...]       closed triangle meshes; models of CGAL's data where none is given

#include "Result_row.h"

#include "../../test/Inter_angle_remeshing/marching_cubes.h"

#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Side_of_triangle_mesh.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace IAR = CGAL::Inter_angle_remeshing;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace parameters = CGAL::parameters;

namespace {

constexpr double FACTORS[] = {.5, 1, 2, 4};
constexpr int VOXELS = 80;             // along the longest side of a model
constexpr double SLICES[] = {1, 3};    // how thick they are, in voxels

Mesh segmentation(const Mesh& model, double voxel, double slice)
{
  const CGAL::Bbox_3 box = PMP::bbox(model);
  const CGAL::Side_of_triangle_mesh<Mesh, Kernel> side(model);
  const std::array<double, 3> step{voxel, voxel, slice * voxel};
  std::array<int, 3> size;
  for (int k = 0; k < 3; ++k) size[k] = int((box.max(k) - box.min(k)) / step[k]) + 1;
  const auto place = [&](double x, double y, double z) {
    return Kernel::Point_3(box.xmin() + step[0] * (x + .5), box.ymin() + step[1] * (y + .5), box.zmin() + step[2] * (z + .5));
  };
  std::vector<char> is_marked;
  for (int x = 0; x < size[0]; ++x)
    for (int y = 0; y < size[1]; ++y)
      for (int z = 0; z < size[2]; ++z) is_marked.push_back(side(place(x, y, z)) == CGAL::ON_BOUNDED_SIDE);
  meshes::Soup surface = meshes::marching_cubes(size, [&](int x, int y, int z) {
    return is_marked[(std::size_t(x) * size[1] + y) * size[2] + z]; });
  std::vector<Kernel::Point_3> points;
  for (const auto& p : surface.points) points.push_back(place(p[0], p[1], p[2]));
  PMP::orient_polygon_soup(points, surface.faces);
  Mesh result;
  PMP::polygon_soup_to_polygon_mesh(points, surface.faces, result);
  return result;
}

struct Segmented
{
  Mesh model, stairs;
  double voxel;
};

}

int main(int argc, char* argv[])
{
  std::vector<std::string> paths(argv + 1, argv + argc);
  if (paths.empty())
    for (const char* name : {"bear", "cow", "elephant", "hand", "homer", "knot1"})
      paths.push_back(CGAL::data_file_path(std::string("meshes/") + name + ".off"));
  std::vector<Segmented> all;
  for (const std::string& path : paths) {
    const Mesh model = read_mesh(path);
    if (!CGAL::is_closed(model)) throw std::runtime_error(path + " is not closed");
    const CGAL::Bbox_3 b = PMP::bbox(model);
    const double voxel = (std::max)({b.xmax() - b.xmin(), b.ymax() - b.ymin(), b.zmax() - b.zmin()}) / VOXELS;
    for (const double slice : SLICES) all.push_back({model, segmentation(model, voxel, slice), voxel});
  }
  Result_row::print_head("length");
  Result_row stairs{"the stairs themselves"};
  for (const Segmented& s : all) stairs.add(s.stairs, s.model, s.voxel, [](Mesh&) {});
  stairs.print(1, stairs);
  for (const double factor : FACTORS) {
    Result_row ours{"ours"}, sharp{"all edges of 40°"}, peer{"PMP"};
    for (const Segmented& s : all) {
      const double length = factor * mean_edge_length(s.stairs);
      ours.add(s.stairs, s.model, s.voxel, [&](Mesh& m) { IAR::isotropic_remeshing(length, m); });
      sharp.add(s.stairs, s.model, s.voxel,
                [&](Mesh& m) { IAR::isotropic_remeshing(length, m, parameters::sharpness_angle(40)); });
      peer.add(s.stairs, s.model, s.voxel,
               [&](Mesh& m) { PMP::isotropic_remeshing(faces(m), length, m, parameters::number_of_iterations(10)); });
    }
    for (const Result_row* row : {&ours, &sharp, &peer}) row->print(factor, peer);
  }
}
