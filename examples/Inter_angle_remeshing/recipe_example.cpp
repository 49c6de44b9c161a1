// Copyright (c) 2026 The Inter_angle_remeshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What the named parameters of Polygon_mesh_processing have no name for: the default recipe, the one that comes nearest to
// the surface, the paper as printed, and a recipe of one's own, compared by their angles, valences, and distances.

#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>
#include <CGAL/Inter_angle_remeshing/surface_distance.h>
#include <CGAL/Inter_angle_remeshing/triangle_quality.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <string>

namespace IAR = CGAL::Inter_angle_remeshing;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

// Remeshes a copy, and measures it.
IAR::Inter_angle_statistics remesh(const std::string& title, const Mesh& input, const double length, const IAR::Recipe& recipe)
{
  Mesh mesh = input;
  CGAL::Real_timer timer;
  timer.start();
  IAR::isotropic_remeshing(faces(mesh), length, mesh,
                           IAR::recipe(recipe, CGAL::parameters::number_of_iterations(10)));
  timer.stop();
  const IAR::Inter_angle_statistics angles = IAR::inter_angle_statistics(mesh);
  std::cout << std::left << std::setw(18) << title << std::right << std::fixed << std::setprecision(1)
            << std::setw(8) << angles.number_of_faces << std::setw(10) << angles.minimum_angle
            << std::setw(10) << angles.maximum_angle << std::setw(12) << angles.average
            << std::setw(15) << angles.percentage_of_regular_vertices() << std::setprecision(4)
            << std::setw(14) << 100 * IAR::surface_distance(input, mesh).relative_mean() << std::setprecision(0)
            << std::setw(8) << 1000 * timer.time() << "\n";
  return angles;
}

int main()
{
  const std::string filename = CGAL::data_file_path("meshes/elephant.off");
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << filename << " cannot be read" << std::endl;
    return EXIT_FAILURE;
  }
  const double length = IAR::target_edge_length(faces(mesh), mesh, 6000);

  // A recipe is a value: members that are not changed keep their defaults.
  IAR::Recipe quick;
  quick.distance_tolerance = 0;
  quick.repair = false;

  std::cout << "recipe              faces       min       max   theta_avg  valence 6 (%)  distance (%)      ms\n";
  const IAR::Inter_angle_statistics by_default = remesh("default", mesh, length, IAR::Recipe());
  remesh("closest", mesh, length, IAR::Recipe::closest());
  const IAR::Inter_angle_statistics paper = remesh("paper as printed", mesh, length, IAR::Recipe::paper());
  remesh("quick", mesh, length, quick);

  return by_default.average > paper.average && by_default.regular_vertices() > paper.regular_vertices()
         ? EXIT_SUCCESS : EXIT_FAILURE;
}
