// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Refines a mesh part by part. Edges between the parts may be split: the first part divides faces of the next one, which are remeshed
// when that has its turn. The map of patches tells which faces there are by then.

#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>
#include <CGAL/Inter_angle_remeshing/triangle_quality.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace IAR = CGAL::Inter_angle_remeshing;
namespace PMP = CGAL::Polygon_mesh_processing;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Face = Mesh::Face_index;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh) || !CGAL::is_triangle_mesh(mesh))
  {
    std::cerr << filename << " is no triangle mesh" << std::endl;
    return EXIT_FAILURE;
  }
  double length = 0;
  for(const auto e : edges(mesh))
    length += PMP::edge_length(e, mesh) / (2. * double(num_edges(mesh)));      // half of the mean

  // The quarters of the bounding box.
  constexpr int number_of_parts = 4;
  const CGAL::Bbox_3 box = PMP::bbox(mesh);
  auto part = mesh.add_property_map<Face, int>("f:part", 0).first;
  for(const Face f : faces(mesh))
  {
    const Kernel::Point_3 p = mesh.point(mesh.target(mesh.halfedge(f)));
    part[f] = (2 * p.x() > box.xmin() + box.xmax() ? 1 : 0) + (2 * p.y() > box.ymin() + box.ymax() ? 2 : 0);
  }

  IAR::Recipe recipe;
  recipe.split_rim = true;
  for(int i = 0; i < number_of_parts; ++i)
  {
    std::vector<Face> range;
    for(const Face f : faces(mesh))
      if(part[f] == i)
        range.push_back(f);
    const IAR::Remeshing_report report = IAR::isotropic_remeshing(range, length, mesh,
      IAR::recipe(recipe, CGAL::parameters::face_patch_map(part).sharpness_angle(180)));
    std::cout << "part " << i << ": " << report.input_faces << " faces became " << report.output_faces << "\n";
  }
  mesh.collect_garbage();
  const IAR::Inter_angle_statistics statistics = IAR::inter_angle_statistics(mesh);
  std::cout << num_faces(mesh) << " faces, average " << statistics.average << " degrees\n";
  return CGAL::is_valid_polygon_mesh(mesh) && statistics.average > 50 ? EXIT_SUCCESS : EXIT_FAILURE;
}
