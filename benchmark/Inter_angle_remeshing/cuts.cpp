// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Organic models cut by planes: how much of the rim of the cut is found to be a feature, and how near the result is at the
// mean edge length, beside PMP with nothing marked. A table in Markdown.

#include "meshes.h"
#include "timing.h"

#include <CGAL/Inter_angle_remeshing/detect_features.h>
#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>
#include <CGAL/Inter_angle_remeshing/surface_distance.h>

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/clip.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>

#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

namespace IAR = CGAL::Inter_angle_remeshing;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace parameters = CGAL::parameters;

namespace {

// Through a point near the middle of the mesh.
Kernel::Plane_3 plane_through(const Mesh& mesh, const Kernel::Vector_3& normal)
{
  const CGAL::Bbox_3 box = PMP::bbox(mesh);
  return {{.45 * box.xmin() + .55 * box.xmax(), .6 * box.ymin() + .4 * box.ymax(), (box.zmin() + box.zmax()) / 2}, normal};
}

// The part of the length of the cut's rim that is a feature, by default.
double share_of_rim_found(const Mesh& mesh, const Kernel::Plane_3& plane)
{
  const double nearly_0 = 1e-12 * CGAL::square(mean_edge_length(mesh));
  const auto is_cut = [&](Mesh::Face_index f) {
    const auto around = vertices_around_face(mesh.halfedge(f), mesh);
    return std::all_of(around.begin(), around.end(), [&](auto v) { return squared_distance(plane, mesh.point(v)) < nearly_0; });
  };
  Mesh copy = mesh;
  const auto is_feature = copy.add_property_map<Mesh::Edge_index, bool>("e:is_feature", false).first;
  IAR::detect_features(faces(copy), copy, is_feature);
  double found = 0, all = 0;
  for (const auto e : copy.edges()) {
    const auto h = copy.halfedge(e);
    if (is_cut(copy.face(h)) == is_cut(copy.face(opposite(h, copy)))) continue;
    all += PMP::edge_length(h, copy);
    if (is_feature[e]) found += PMP::edge_length(h, copy);
  }
  return found / all;
}

}

int main()
{
  std::printf("| | of the rim found %% | Hd, target lengths | crossing pairs | PMP Hd | PMP crossing pairs |\n|---|---|---|---|---|---|\n");
  std::vector<double> shares, distances, distances_of_pmp;
  for (const char* name : {"elephant", "armadillo", "homer", "dino", "bunny00", "bear", "hand", "cactus", "knot1", "triceratops"})
    for (const Kernel::Vector_3& normal : {Kernel::Vector_3(0, 1, 0), Kernel::Vector_3(.3, .5, .81), Kernel::Vector_3(1, .2, -.4)}) {
      Mesh mesh = read_mesh(CGAL::data_file_path(std::string("meshes/") + name + ".off"));
      const Kernel::Plane_3 plane = plane_through(mesh, normal);
      if (!PMP::clip(mesh, plane, parameters::clip_volume(true)) || !CGAL::is_triangle_mesh(mesh)) continue;
      mesh.collect_garbage();
      const double length = mean_edge_length(mesh);
      const auto distance = [&](const Mesh& result) { return IAR::surface_distance(mesh, result).hausdorff() / length; };
      Mesh ours, theirs;
      seconds(mesh, ours, [&](Mesh& m) { IAR::isotropic_remeshing(length, m); });
      seconds(mesh, theirs, [&](Mesh& m) { PMP::isotropic_remeshing(faces(m), length, m, parameters::number_of_iterations(10)); });
      shares.push_back(share_of_rim_found(mesh, plane));
      distances.push_back(distance(ours));
      distances_of_pmp.push_back(distance(theirs));
      std::printf("| %s, (%g, %g, %g) | %.0f | %.2f | %zu | %.2f | %zu |\n", name, normal.x(), normal.y(), normal.z(),
                  100 * shares.back(), distances.back(), crossing_pairs(ours), distances_of_pmp.back(),
                  crossing_pairs(theirs));
    }
  const auto largest = [](const std::vector<double>& values) { return *std::max_element(values.begin(), values.end()); };
  std::printf("| median | %.0f | %.2f | | %.2f | |\n| worst | %.0f | %.2f | | %.2f | |\n", 100 * median(shares), median(distances),
              median(distances_of_pmp), 100 * *std::min_element(shares.begin(), shares.end()), largest(distances),
              largest(distances_of_pmp));
}
