// Copyright (c) 2026 The Inter_angle_remeshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The smooth surface that a coarse mesh stands for.
//
// A sphere of some 500 triangles is refined eight times: onto its facets, onto the MLS surface over them, and by
// default. Then points near the coarse mesh are projected onto its MLS surface, without any remeshing.

#include <CGAL/Inter_angle_remeshing/Projection/Closest_point_projector.h>
#include <CGAL/Inter_angle_remeshing/Projection/MLS_projector.h>
#include <CGAL/Inter_angle_remeshing/Projection/Upsampled_point_set.h>
#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iostream>
#include <vector>

namespace IAR = CGAL::Inter_angle_remeshing;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace parameters = CGAL::parameters;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

double distance_from_sphere(const Point& p) { return std::abs(std::sqrt((p - CGAL::ORIGIN).squared_length()) - 1); }

double mean_error(const Mesh& mesh)
{
  double sum = 0;
  for(const auto v : mesh.vertices())
    sum += distance_from_sphere(mesh.point(v));
  return sum / double(mesh.number_of_vertices());
}

// A sphere whose vertices are exact: an icosahedron, remeshed while it is projected by a function.
Mesh coarse_sphere()
{
  Mesh mesh;
  CGAL::make_icosahedron(mesh, Point(0, 0, 0), 1.);
  const auto onto_sphere = [](const Point& p) {
    const Kernel::Vector_3 v = p - CGAL::ORIGIN;
    return CGAL::ORIGIN + v / std::sqrt(v.squared_length());
  };
  IAR::isotropic_remeshing(IAR::Face_count(500), mesh, parameters::projection_functor(onto_sphere));
  for(const auto v : mesh.vertices())
    mesh.point(v) = onto_sphere(mesh.point(v));
  mesh.collect_garbage();
  return mesh;
}

int main()
{
  const Mesh coarse = coarse_sphere();
  const double fine = IAR::target_edge_length(faces(coarse), coarse, 30000);

  const IAR::Closest_point_projector<Mesh> facets(coarse);
  const IAR::MLS_projector<Mesh> mls(coarse);
  Mesh on_facets = coarse, on_mls = coarse, by_default = coarse, by_pmp = coarse;
  IAR::isotropic_remeshing(faces(on_facets), fine, on_facets, parameters::projection_functor(std::cref(facets)));
  IAR::isotropic_remeshing(faces(on_mls), fine, on_mls, parameters::projection_functor(std::cref(mls)));
  IAR::isotropic_remeshing(faces(by_default), fine, by_default);
  PMP::isotropic_remeshing(faces(by_pmp), fine, by_pmp, parameters::number_of_iterations(10));
  std::cout << coarse.number_of_faces() << " faces become " << by_default.number_of_faces()
            << "; mean distance of the vertices from the sphere:\n"
            << "  on the facets                 " << mean_error(on_facets) << "\n"
            << "  on the MLS surface            " << mean_error(on_mls) << "\n"
            << "  by default                    " << mean_error(by_default) << "\n"
            << "  by Polygon_mesh_processing    " << mean_error(by_pmp) << "\n";

  // A projector alone: points of a scan, say, that lie near the mesh.
  double near_error = 0, projected_error = 0;
  const IAR::Upsampled_point_set<Mesh> samples(coarse);
  for(const auto& [point, normal] : samples)
  {
    const Point moved = point + 0.01 * normal;
    near_error += distance_from_sphere(moved) / double(samples.size());
    projected_error += distance_from_sphere(mls.project(moved)) / double(samples.size());
  }
  std::cout << samples.size() << " points that are " << near_error << " off on the average are " << projected_error
            << " off after their projection\n";

  std::ofstream("coarse_sphere.off") << coarse;
  on_facets.collect_garbage();
  on_mls.collect_garbage();
  std::ofstream("on_facets.off") << on_facets;
  std::ofstream("on_mls.off") << on_mls;
  std::cout << "written: coarse_sphere.off, on_facets.off, on_mls.off\n";
  return 8 * mean_error(by_default) < mean_error(by_pmp) && 8 * projected_error < near_error ? EXIT_SUCCESS
                                                                                             : EXIT_FAILURE;
}
