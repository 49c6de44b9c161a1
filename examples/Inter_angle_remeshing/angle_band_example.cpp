// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Asks for a band of angles, and prints which faces are left out of it, and why.

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
using Report = IAR::Remeshing_report;

const char* words(const Report::Reason reason)
{
  switch(reason)
  {
  case Report::Reason::input_corner: return "the angle is the input's";
  case Report::Reason::border_or_feature: return "a border or a feature leaves no room";
  default: return "no operation near it helps";
  }
}

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/armadillo.off");
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << filename << " cannot be read" << std::endl;
    return EXIT_FAILURE;
  }

  IAR::Recipe recipe;
  recipe.lower_angle = 42;           // degrees; these are the defaults
  recipe.upper_angle = 88;
  recipe.distance_tolerance = 0.22;  // in target lengths: larger distances are lowered
  const Report report = IAR::isotropic_remeshing(IAR::Face_count(20000), mesh, IAR::recipe(recipe));

  std::cout << report.output_faces << " faces, angles from " << report.angles_after.minimum << " to "
            << report.angles_after.maximum << " degrees, " << report.repairs << " repairs; the band "
            << (report.band_holds ? "holds" : "does not hold") << "\n";
  if(report.are_crossing_faces_known)
    std::cout << report.crossing_faces << " faces cross others\n";
  else
    std::cout << "crossing faces were not looked for\n";
  for(const Report::Face_out_of_band& face : report.faces_out_of_band)
    std::cout << "  by " << face.violation << " degrees near (" << face.centroid[0] << ", " << face.centroid[1] << ", "
              << face.centroid[2] << "): " << words(face.reason) << "\n";
  return report.band_holds ? EXIT_SUCCESS : EXIT_FAILURE;
}
