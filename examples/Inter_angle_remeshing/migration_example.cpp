// Copyright (c) 2026 The Inter_angle_remeshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Calls of CGAL::Polygon_mesh_processing::isotropic_remeshing() as programs have them, each written once and run with both
// packages: what changes is the namespace. An argument is a mesh with a border; the default comes with CGAL.

#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>
#include <CGAL/Inter_angle_remeshing/triangle_quality.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/selection.h>
#include <CGAL/version.h>
#if CGAL_VERSION_NR >= 1060000000
#  include <CGAL/Polygon_mesh_processing/Adaptive_sizing_field.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace parameters = CGAL::parameters;
namespace PMP = CGAL::Polygon_mesh_processing;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Edge = Mesh::Edge_index;
using Face = Mesh::Face_index;

// The two packages. A program that migrates has one of them, and changes the name where it calls the function, or
// `namespace Remeshing = CGAL::Polygon_mesh_processing;`, in one place.
struct Before
{
  static constexpr const char* NAME = "Polygon_mesh_processing";
  static constexpr bool TAKES_FUNCTIONS = false;
  template <class... Arguments>
  static void isotropic_remeshing(Arguments&&... arguments)
  {
    CGAL::Polygon_mesh_processing::isotropic_remeshing(std::forward<Arguments>(arguments)...);
  }
};

struct After
{
  static constexpr const char* NAME = "Inter_angle_remeshing";
  static constexpr bool TAKES_FUNCTIONS = true;
  template <class... Arguments>
  static void isotropic_remeshing(Arguments&&... arguments)
  {
    CGAL::Inter_angle_remeshing::isotropic_remeshing(std::forward<Arguments>(arguments)...);
  }
};

double mean_edge_length(const Mesh& mesh)
{
  double sum = 0;
  for(const Edge e : mesh.edges())
    sum += std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  return sum / double(mesh.number_of_edges());
}

// The whole mesh; its border is cut to the length beforehand, and protected.
template <class Package>
Mesh whole_mesh(Mesh mesh)
{
  const double length = .7 * mean_edge_length(mesh);
  std::vector<Edge> border;
  for(const Edge e : mesh.edges())
    if(mesh.is_border(e))
      border.push_back(e);
  PMP::split_long_edges(border, length, mesh);
  Package::isotropic_remeshing(mesh.faces(), length, mesh, parameters::number_of_iterations(10).protect_constraints(true));
  return mesh;
}

// A patch: one face and eight rings around it, which have their id in a map. The rest of the mesh stays as it is.
template <class Package>
Mesh patch(Mesh mesh)
{
  const double length = .5 * mean_edge_length(mesh);
  const auto ids = mesh.add_property_map<Face, int>("f:patch", 0).first;
  std::vector<Face> range{*mesh.faces_begin()};
  ids[range.front()] = 1;
  CGAL::expand_face_selection(std::vector<Face>(range), mesh, 8, ids, std::back_inserter(range));
  Package::isotropic_remeshing(range, length, mesh,
                               parameters::number_of_iterations(5).face_patch_map(ids).protect_constraints(true));
  return mesh;
}

// What PMP takes for a length that differs from place to place: in CGAL 6 one of its sizing fields, before that nothing, and the
// mean will have to do. This package takes CGAL 6's fields, too, and functions of the position.
struct Finer_at_the_left
{
  double shortest, longest, left, right;

  double operator()(const Point& p) const { return shortest + (longest - shortest) * (p.x() - left) / (right - left); }
};

template <class Package>
Mesh graded_mesh(Mesh mesh)
{
  const auto by_x = [&](Mesh::Vertex_index u, Mesh::Vertex_index v) { return mesh.point(u).x() < mesh.point(v).x(); };
  const auto ends = std::minmax_element(mesh.vertices_begin(), mesh.vertices_end(), by_x);
  const double mean = mean_edge_length(mesh);
  const Finer_at_the_left length{.5 * mean, 1.5 * mean, mesh.point(*ends.first).x(), mesh.point(*ends.second).x()};
  const auto np = parameters::number_of_iterations(5).number_of_relaxation_steps(3);
  if constexpr(Package::TAKES_FUNCTIONS)
    Package::isotropic_remeshing(mesh.faces(), length, mesh, np);
  else
  {
#if CGAL_VERSION_NR >= 1060000000
    PMP::Adaptive_sizing_field<Mesh> field(.05 * mean, std::make_pair(length.shortest, length.longest), mesh.faces(), mesh);
    Package::isotropic_remeshing(mesh.faces(), field, mesh, np);
#else
    Package::isotropic_remeshing(mesh.faces(), mean, mesh, np);
#endif
  }
  return mesh;
}

template <class Package>
void print(const char* what, const Mesh& mesh)
{
  const auto angles = CGAL::Inter_angle_remeshing::inter_angle_statistics(faces(mesh), mesh);
  std::cout << what << ", " << Package::NAME << ": " << mesh.number_of_faces() << " faces, angles from " << angles.minimum_angle
            << " to " << angles.maximum_angle << " degrees" << std::endl;
}

template <class Package>
void run_all(const Mesh& input)
{
  print<Package>("whole mesh", whole_mesh<Package>(input));
  print<Package>("patch", patch<Package>(input));
  print<Package>("graded mesh", graded_mesh<Package>(input));
}

int main(int argc, char** argv)
{
  const std::string file = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/mesh_with_border.off");
  Mesh input;
  if(!PMP::IO::read_polygon_mesh(file, input) || !CGAL::is_triangle_mesh(input))
  {
    std::cerr << file << " is no triangle mesh." << std::endl;
    return EXIT_FAILURE;
  }
  run_all<Before>(input);
  run_all<After>(input);
  return EXIT_SUCCESS;
}
