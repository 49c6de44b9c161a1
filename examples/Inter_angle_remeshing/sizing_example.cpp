// Copyright (c) 2026 The Inter_angle_remeshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Edge lengths that vary: by the curvature, by a function of the position, and both as so many faces.

#include <CGAL/Inter_angle_remeshing/Curvature_sizing_field.h>
#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>
#include <CGAL/Inter_angle_remeshing/surface_distance.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>

namespace IAR = CGAL::Inter_angle_remeshing;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/fandisk.off");
  Mesh input;
  if(!CGAL::IO::read_polygon_mesh(filename, input))
  {
    std::cerr << filename << " cannot be read" << std::endl;
    return EXIT_FAILURE;
  }
  const double length = IAR::target_edge_length(faces(input), input, input.number_of_faces());

  // Triangles that lie a fiftieth of the length off the surface, with edges between a third of it and three times as long.
  const IAR::Curvature_sizing_field<Mesh> curvature(length / 50, {length / 3, 3 * length}, faces(input), input);
  Mesh adaptive = input;
  IAR::isotropic_remeshing(curvature, adaptive);
  adaptive.collect_garbage();
  const std::size_t number = adaptive.number_of_faces();

  Mesh uniform = input;
  IAR::isotropic_remeshing(IAR::Face_count(number), uniform);
  uniform.collect_garbage();
  const double by_curvature = IAR::surface_distance(adaptive, input).relative_mean(),
               alike = IAR::surface_distance(uniform, input).relative_mean();
  std::cout << number << " faces; mean distance, in percent of the diagonal: " << 100 * by_curvature
            << " with lengths by curvature, " << 100 * alike << " with all alike\n";

  // Half as many, sized by the same field.
  Mesh half = input;
  const IAR::Remeshing_report report = IAR::isotropic_remeshing(IAR::Face_count(number / 2).scaling(curvature), half);
  std::cout << report.output_faces << " faces of " << number / 2 << "\n";

  // Fine on one side.
  Mesh graded = input;
  const Kernel::Point_3 centre = input.point(*vertices(input).begin());
  const auto near_is_fine = [&](const Kernel::Point_3& p) {
    return length * (0.5 + 0.1 * std::sqrt(CGAL::squared_distance(p, centre)) / length);
  };
  IAR::isotropic_remeshing(near_is_fine, graded);
  graded.collect_garbage();
  std::cout << graded.number_of_faces() << " faces, finest at " << centre << "\n";
  return report.output_faces > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
