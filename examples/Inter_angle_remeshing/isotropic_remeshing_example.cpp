// Copyright (c) 2026 The Inter_angle_remeshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The shortest way: remeshes all of a mesh to edges of one length, and writes the result.
//
//   isotropic_remeshing_example [mesh [length]]

#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <iostream>
#include <string>

namespace IAR = CGAL::Inter_angle_remeshing;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << filename << " cannot be read" << std::endl;
    return EXIT_FAILURE;
  }

  // A length in the unit of the mesh. Where only the size of the result matters, ask for `IAR::Face_count(10000)`.
  const double length = argc > 2 ? std::stod(argv[2]) : 0.02;
  const IAR::Remeshing_report report = IAR::isotropic_remeshing(faces(mesh), length, mesh);

  const IAR::Remeshing_report::Angles& before = report.angles_before;
  const IAR::Remeshing_report::Angles& after = report.angles_after;
  std::cout << report.input_faces << " faces became " << report.output_faces << "; in degrees,\n"
            << "the smallest angle: " << before.minimum << " -> " << after.minimum << "\n"
            << "the largest angle:  " << before.maximum << " -> " << after.maximum << "\n"
            << "theta_avg:          " << before.average << " -> " << after.average << "\n";

  // Elements that were removed stay in a Surface_mesh as garbage, as with every function of CGAL.
  mesh.collect_garbage();
  const bool is_written = CGAL::IO::write_polygon_mesh("remeshed.off", mesh, CGAL::parameters::stream_precision(17));

  const bool is_better = after.average > before.average;
  return is_written && is_better ? EXIT_SUCCESS : EXIT_FAILURE;
}
