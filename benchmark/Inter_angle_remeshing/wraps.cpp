// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Alpha wraps of parts, whose edges have become jagged chamfers: by default, with all edges of 40 degrees and more as features, and
// by PMP. Per target length, in mean edge lengths, sums and means over the wraps as a table in Markdown.
//
//   wraps [mesh...]       triangle meshes, wrapped at a 30th and a 60th of their diagonals; parts of CGAL's data where none is given

#include "meshes.h"
#include "timing.h"

#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>
#include <CGAL/Inter_angle_remeshing/surface_distance.h>
#include <CGAL/Inter_angle_remeshing/triangle_quality.h>

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/alpha_wrap_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

namespace IAR = CGAL::Inter_angle_remeshing;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace parameters = CGAL::parameters;

namespace {

constexpr double FACTORS[] = {.5, 1, 2, 4}, PARTS_OF_DIAGONAL[] = {30, 60};
constexpr double NEEDLE = 20;       // degrees

std::size_t number_of_needles(const Mesh& mesh)
{
  return std::size_t(std::count_if(mesh.faces_begin(), mesh.faces_end(), [&](Mesh::Face_index f) {
    const auto h = mesh.halfedge(f);
    const auto &p = mesh.point(mesh.source(h)), &q = mesh.point(mesh.target(h)), &r = mesh.point(mesh.target(mesh.next(h)));
    return (std::min)({CGAL::approximate_angle(p, q, r), CGAL::approximate_angle(q, r, p), CGAL::approximate_angle(r, p, q)}) < NEEDLE;
  }));
}

struct Row
{
  const char* name;
  std::size_t faces = 0, needles = 0;
  double least = 0, average = 0, hausdorff = 0, mean = 0;     // sums over the wraps; distances in target lengths
  std::vector<double> times = {};

  template <class Remesh>
  void add(const Mesh& wrap, double length, const Remesh& remesh)
  {
    Mesh result;
    times.push_back(seconds(wrap, result, remesh));
    const auto angles = IAR::inter_angle_statistics(result);
    const IAR::Surface_distance distance = IAR::surface_distance(wrap, result);
    faces += result.number_of_faces();
    needles += number_of_needles(result);
    least += angles.minimum_angle;
    average += angles.average;
    hausdorff += distance.hausdorff() / length;
    mean += distance.mean() / length;
  }

  void print(double factor, const Row& peer) const
  {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < times.size(); ++i) ratios.push_back(peer.times[i] / times[i]);
    const double n = double((std::max)(times.size(), std::size_t(1)));
    std::printf("| %g | %s | %zu | %zu | %.1f | %.2f | %.3f | %.4f | %.2f |\n", factor, name, faces, needles, least / n, average / n,
                hausdorff / n, mean / n, median(ratios));
  }
};

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
  std::printf("| length | | faces | under 20° | least angle | θ_avg | Hd | Md | PMP : ours |\n|---|---|---|---|---|---|---|---|---|\n");
  for (const double factor : FACTORS) {
    Row ours{"ours"}, sharp{"all edges of 40°"}, peer{"PMP"};
    for (const Mesh& wrap : wraps) {
      const double length = factor * mean_edge_length(wrap);
      ours.add(wrap, length, [&](Mesh& m) { IAR::isotropic_remeshing(length, m); });
      sharp.add(wrap, length, [&](Mesh& m) { IAR::isotropic_remeshing(length, m, parameters::sharpness_angle(40)); });
      peer.add(wrap, length, [&](Mesh& m) { PMP::isotropic_remeshing(faces(m), length, m, parameters::number_of_iterations(10)); });
    }
    for (const Row* row : {&ours, &sharp, &peer}) row->print(factor, peer);
  }
}
