// Copyright (c) 2026 The Inter_angle_remeshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The MLS surface in functions of Polygon_mesh_processing.
//
// A bunny is made coarse. PMP::isotropic_remeshing() makes it fine again, by itself and with the projector; then
// PMP::tangential_relaxation() moves the vertices in their tangent planes, and the projector puts them back on the surface.

#include <CGAL/Inter_angle_remeshing/Projection/MLS_projector.h>
#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>
#include <CGAL/Inter_angle_remeshing/surface_distance.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Polygon_mesh_processing/tangential_relaxation.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>

namespace IAR = CGAL::Inter_angle_remeshing;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace parameters = CGAL::parameters;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

int main()
{
  const std::string filename = CGAL::data_file_path("meshes/bunny00.off");
  Mesh original;
  if(!CGAL::IO::read_polygon_mesh(filename, original))
  {
    std::cerr << filename << " cannot be read" << std::endl;
    return EXIT_FAILURE;
  }
  const auto distance = [&](const Mesh& mesh) { return IAR::surface_distance(original, mesh).mean(); };

  // The projector takes vertices for points of the surface: a fit would have put them beside it, as would what lowers distances.
  Mesh mesh = original;
  IAR::Recipe recipe;
  recipe.fits = 0;
  recipe.distance_tolerance = 0;
  IAR::isotropic_remeshing(faces(mesh), IAR::Face_count(1500), mesh, IAR::recipe(recipe));
  mesh.collect_garbage();
  Mesh by_pmp_alone = mesh;
  const double fine = IAR::target_edge_length(faces(mesh), mesh, 30000);
  std::cout << mesh.number_of_faces() << " faces: mean distance from the original " << distance(mesh) << "\n";

  PMP::isotropic_remeshing(faces(by_pmp_alone), fine, by_pmp_alone, parameters::number_of_iterations(5));
  by_pmp_alone.collect_garbage();
  std::cout << by_pmp_alone.number_of_faces() << " faces by PMP alone: " << distance(by_pmp_alone) << "\n";

  // The projector keeps a copy of the coarse surface. As a functor on vertices it reads the points that the vertices of
  // `mesh` have when it is called.
  const IAR::MLS_projector<Mesh> projector(mesh);
  PMP::isotropic_remeshing(faces(mesh), fine, mesh,
                           parameters::number_of_iterations(5).projection_functor(std::cref(projector)));
  mesh.collect_garbage();
  const double with_projector = distance(mesh);
  std::cout << mesh.number_of_faces() << " faces by PMP with the projector: " << with_projector << "\n";

  PMP::tangential_relaxation(vertices(mesh), mesh, parameters::number_of_iterations(10));
  const double relaxed = distance(mesh);
  for(const auto v : vertices(mesh))
    mesh.point(v) = projector(v);
  std::cout << "relaxed: " << relaxed << ", projected: " << distance(mesh) << "\n";
  return 1.15 * with_projector < distance(by_pmp_alone) && distance(mesh) <= 1.02 * with_projector ? EXIT_SUCCESS
                                                                                                  : EXIT_FAILURE;
}
