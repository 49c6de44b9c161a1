// Copyright (c) 2026 The Inter_angle_remeshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The border of a surface with holes: its vertices slide along it, stay, or nothing of it changes at all.

#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>
#include <CGAL/Inter_angle_remeshing/triangle_quality.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <set>
#include <string>

namespace IAR = CGAL::Inter_angle_remeshing;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

std::set<Kernel::Point_3> border_points(const Mesh& mesh)
{
  std::set<Kernel::Point_3> points;
  for(const auto v : vertices(mesh))
    if(mesh.is_border(v))
      points.insert(mesh.point(v));
  return points;
}

// Of the points of the input's border, those that the result's border has, too.
std::size_t points_left(const Mesh& input, const Mesh& result)
{
  const std::set<Kernel::Point_3> after = border_points(result);
  std::size_t left = 0;
  for(const auto& p : border_points(input))
    left += after.count(p);
  return left;
}

int main()
{
  const std::string filename = CGAL::data_file_path("meshes/holes.off");
  Mesh input;
  if(!CGAL::IO::read_polygon_mesh(filename, input))
  {
    std::cerr << filename << " cannot be read" << std::endl;
    return EXIT_FAILURE;
  }
  const double length = IAR::target_edge_length(faces(input), input, 9000);
  std::cout << "input: " << border_points(input).size() << " points on the border\n";

  const auto run = [&](const char* title, const auto& parameters) {
    Mesh mesh = input;
    IAR::isotropic_remeshing(faces(mesh), length, mesh, parameters);
    const IAR::Inter_angle_statistics angles = IAR::inter_angle_statistics(mesh);
    std::cout << title << ": " << border_points(mesh).size() << " points, of which " << points_left(input, mesh)
              << " are the input's; angles " << angles.minimum_unforced_angle << " to " << angles.maximum_unforced_angle
              << ", average " << angles.unforced_average << "\n";
    return mesh;
  };

  // Edges of the border are split and collapsed, and its vertices slide along it; corners stay.
  const Mesh sliding = run("sliding", CGAL::parameters::default_values());
  // The input's vertices there stay where they are, or go.
  const Mesh pinned = run("not relaxed", CGAL::parameters::relax_constraints(false));
  // Not an edge changes: this part fits to others as it did.
  const Mesh fixed = run("protected", CGAL::parameters::protect_constraints(true));

  return points_left(input, fixed) == border_points(input).size() && points_left(input, pinned) > points_left(input, sliding)
         ? EXIT_SUCCESS : EXIT_FAILURE;
}
