// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meshes remeshed in eight parts, one after the other, the octants of their bounding boxes; and one of them alone: poor faces with rims
// that stay whole, with rims that are split, and beside PMP. A table in Markdown.

#include "meshes.h"
#include "timing.h"

#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>

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

using Face = Mesh::Face_index;
using Parts = Mesh::Property_map<Face, int>;

enum class Way { whole_rims, split_rims, pmp };

Parts octants(Mesh& mesh)
{
  const Parts result = mesh.add_property_map<Face, int>("f:octant", 0).first;
  const CGAL::Bbox_3 box = PMP::bbox(mesh);
  for (const Face f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    const Kernel::Point_3 c = CGAL::centroid(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), mesh.point(mesh.target(mesh.next(h))));
    for (int axis = 0; axis < 3; ++axis) result[f] = 2 * result[f] + (2 * c[axis] > box.min(axis) + box.max(axis));
  }
  return result;
}

void remesh_part(Mesh& mesh, Parts parts, int part, double length, Way way)
{
  std::vector<Face> range;
  for (const Face f : mesh.faces())
    if (parts[f] == part) range.push_back(f);
  if (range.empty()) return;
  if (way == Way::pmp) {
    PMP::isotropic_remeshing(range, length, mesh, parameters::number_of_iterations(10).face_patch_map(parts));
    return;
  }
  IAR::Recipe recipe;
  recipe.split_rim = way == Way::split_rims;
  IAR::isotropic_remeshing(range, length, mesh, IAR::recipe(recipe, parameters::face_patch_map(parts).sharpness_angle(180)));
}

double least_angle(Face f, const Mesh& mesh)
{
  double result = 180;
  for (const auto h : halfedges_around_face(mesh.halfedge(f), mesh))
    result = (std::min)(result, double(CGAL::approximate_angle(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                                                               mesh.point(mesh.target(mesh.next(h))))));
  return result;
}

void print_row(const std::string& name, double factor, bool is_one_alone, const char* way_name, Way way)
{
  Mesh mesh = read_mesh(CGAL::data_file_path("meshes/" + name + ".off"));
  const double length = factor * mean_edge_length(mesh);
  Mesh result;
  const double time = seconds(mesh, result, [&](Mesh& m) {
    const Parts parts = octants(m);
    for (int part = 0; part < (is_one_alone ? 1 : 8); ++part) remesh_part(m, parts, part, length, way);
  });
  std::size_t poor = 0;
  double smallest = 180, sum = 0;
  for (const Face f : result.faces()) {
    const double angle = least_angle(f, result);
    poor += angle < 25;
    smallest = (std::min)(smallest, angle);
    sum += angle;
  }
  std::printf("| %s, %g%s | %s | %zu | %zu | %.0f | %.1f | %zu | %.2f |\n", name.c_str(), factor, is_one_alone ? ", one part" : "", way_name,
              std::size_t(result.number_of_faces()), poor, smallest, sum / double(result.number_of_faces()), crossing_pairs(result), time);
}

}

int main()
{
  std::printf("| | rims | faces | under 25° | least angle | mean of the faces' least angles | crossing pairs | s |\n|---|---|---|---|---|---|---|---|\n");
  for (const char* name : {"elephant", "fandisk", "bunny00"})
    for (const bool is_one_alone : {false, true})
      for (const double factor : {.5, .25}) {
        print_row(name, factor, is_one_alone, "whole", Way::whole_rims);
        print_row(name, factor, is_one_alone, "split", Way::split_rims);
        print_row(name, factor, is_one_alone, "PMP", Way::pmp);
      }
}
