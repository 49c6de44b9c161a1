// Copyright (c) 2026 The Inter_angle_remeshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// A projector alone, in this package's remesher, and in that of Polygon_mesh_processing; and a run that projects nothing.
//
// A mesh is made coarse and then fine again. Left to itself, the second run keeps to the coarse mesh; with a projector
// that has a copy of the original surface, it returns to that.

#include <CGAL/Inter_angle_remeshing/Projection/Closest_point_projector.h>
#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>
#include <CGAL/Inter_angle_remeshing/surface_distance.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>

namespace IAR = CGAL::Inter_angle_remeshing;
namespace PMP = CGAL::Polygon_mesh_processing;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

int main()
{
  const std::string filename = CGAL::data_file_path("meshes/elephant.off");
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << filename << " cannot be read" << std::endl;
    return EXIT_FAILURE;
  }
  const Mesh original = mesh;

  // Copies the surface as it is now. As a functor on vertices, which is how Polygon_mesh_processing calls it, it reads
  // the points that the vertices of `mesh` have at the time of the call.
  const IAR::Closest_point_projector<Mesh> projector(mesh);

  // Alone. Between two sheets, a normal tells which one is meant.
  const Kernel::Point_3 query(0, -0.3, 0);
  const Kernel::Vector_3 to_the_left(-1, 0, 0);
  const Kernel::Point_3 closest = projector.project(query), on_the_other_leg = projector.project(query, to_the_left);
  std::cout << "closest to (" << query << "), between two legs: (" << closest << ")\n"
            << "on the leg that looks to the left: (" << on_the_other_leg << ")\n";

  const double fine = IAR::target_edge_length(faces(mesh), mesh, 6000);

  // By default vertices are pulled back onto the surface of the input; without that they stay where relaxation leaves them.
  Mesh pulled_back = mesh, adrift = mesh;
  IAR::isotropic_remeshing(faces(pulled_back), fine, pulled_back);
  IAR::isotropic_remeshing(faces(adrift), fine, adrift, CGAL::parameters::do_project(false));
  pulled_back.collect_garbage();
  adrift.collect_garbage();
  const double on_surface = IAR::surface_distance(original, pulled_back).mean();
  const double off_surface = IAR::surface_distance(original, adrift).mean();
  std::cout << "mean distance from the input: " << on_surface << ", without projection " << off_surface << "\n";

  IAR::isotropic_remeshing(faces(mesh), 3 * fine, mesh);
  mesh.collect_garbage();

  // By std::ref, as the projector is large; the run starts every query from where it projected the vertex last.
  Mesh left_to_itself = mesh, guided = mesh;
  IAR::isotropic_remeshing(faces(left_to_itself), fine, left_to_itself);
  IAR::isotropic_remeshing(faces(guided), fine, guided, CGAL::parameters::projection_functor(std::ref(projector)));
  PMP::isotropic_remeshing(faces(mesh), fine, mesh,
                           CGAL::parameters::number_of_iterations(5).projection_functor(std::ref(projector)));

  left_to_itself.collect_garbage();
  guided.collect_garbage();
  mesh.collect_garbage();

  // A fine mesh on the original differs from it by less than the coarse one's facets do.
  const double without = IAR::surface_distance(original, left_to_itself).mean();
  const double with = IAR::surface_distance(original, guided).mean();
  const double pmp = IAR::surface_distance(original, mesh).mean();
  std::cout << "mean distance from the original: left to itself " << without << ", with the projector " << with
            << ", with it in Polygon_mesh_processing " << pmp << "\n";
  return 2 * with < without && 2 * pmp < without && 1.5 * on_surface < off_surface && closest != on_the_other_leg
         ? EXIT_SUCCESS : EXIT_FAILURE;
}
