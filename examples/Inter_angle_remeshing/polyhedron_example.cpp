// Copyright (c) 2026 The Inter_angle_remeshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Another mesh type: the function takes any model of MutableFaceGraph whose descriptors can be hashed.

#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>

namespace IAR = CGAL::Inter_angle_remeshing;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Polyhedron_3<Kernel>; // needs no `Polyhedron_items_with_id_3`

int main()
{
  const std::string filename = CGAL::data_file_path("meshes/hand.off");
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << filename << " cannot be read" << std::endl;
    return EXIT_FAILURE;
  }

  // A wanted number of faces in place of a length; all faces of the mesh, so that no range is needed.
  const std::size_t wanted = 4000;
  const IAR::Remeshing_report report = IAR::isotropic_remeshing(IAR::Face_count(wanted), mesh);

  std::cout << report.input_faces << " faces became " << mesh.size_of_facets() << ", at an edge length of "
            << report.target_edge_length << "; theta_avg " << report.angles_before.average << " -> "
            << report.angles_after.average << " degrees\n";

  const double excess = static_cast<double>(mesh.size_of_facets()) / static_cast<double>(wanted) - 1;
  return mesh.is_valid() && mesh.is_pure_triangle() && std::abs(excess) < 0.05 ? EXIT_SUCCESS : EXIT_FAILURE;
}
