// Copyright (c) 2026 The Inter_angle_remeshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The sides of a mechanical part as patches, which stay patches from one run to the next; its points are those of a property map that
// is not the mesh's own.

#include <CGAL/Inter_angle_remeshing/detect_features.h>
#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace IAR = CGAL::Inter_angle_remeshing;
namespace PMP = CGAL::Polygon_mesh_processing;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

int main()
{
  const std::string filename = CGAL::data_file_path("meshes/fandisk.off");
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << filename << " cannot be read" << std::endl;
    return EXIT_FAILURE;
  }

  // Points in centimetres beside those of the file, which are taken for metres.
  const auto centimetres = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_3>("v:centimetres").first;
  for(const Mesh::Vertex_index v : vertices(mesh))
    centimetres[v] = CGAL::ORIGIN + 100 * (mesh.point(v) - CGAL::ORIGIN);

  // A patch is what sharp edges enclose.
  const auto is_sharp = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_sharp", false).first;
  const auto patch = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:patch", 0).first;
  IAR::detect_features(faces(mesh), mesh, is_sharp);
  const std::size_t patches = PMP::connected_components(mesh, patch, CGAL::parameters::edge_is_constrained_map(is_sharp));

  const auto areas = [&]() {
    std::vector<double> result(patches, 0);
    for(const Mesh::Face_index f : faces(mesh))
      result[patch[f]] += PMP::face_area(f, mesh, CGAL::parameters::vertex_point_map(centimetres));
    return result;
  };
  const std::vector<double> before = areas();

  // The patch map is right for the faces of each result, the edge map for its edges, also for those sharp ones that lie within a
  // patch; so both can be handed over again. Once coarser, once finer.
  for(const std::size_t n : {4000, 10000})
  {
    const IAR::Remeshing_report report =
      IAR::isotropic_remeshing(IAR::Face_count(n), mesh, CGAL::parameters::vertex_point_map(centimetres)
                                                             .face_patch_map(patch)
                                                             .edge_is_constrained_map(is_sharp));
    std::cout << report.output_faces << " faces, angles of " << report.angles_after.minimum << " to "
              << report.angles_after.maximum << " degrees\n";
  }

  double largest_change = 0;
  const std::vector<double> after = areas();
  for(std::size_t i = 0; i < patches; ++i)
  {
    std::cout << "patch " << i << ": " << before[i] << " square centimetres, then " << after[i] << "\n";
    largest_change = (std::max)(largest_change, std::abs(after[i] / before[i] - 1));
  }
  return patches > 10 && largest_change < .01 ? EXIT_SUCCESS : EXIT_FAILURE;
}
