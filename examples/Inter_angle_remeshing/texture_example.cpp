// Copyright (c) 2026 The Inter_angle_remeshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Texture coordinates of two charts, front and back: at the seam between them a vertex has one pair of coordinates in each.

#include <CGAL/Inter_angle_remeshing/Attribute_transfer.h>
#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

namespace IAR = CGAL::Inter_angle_remeshing;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

// Of a point: the back lies to the right of the front, mirrored.
Kernel::Point_2 project(const Kernel::Point_3& p, bool is_back)
{
  return is_back ? Kernel::Point_2(2 - p.x(), p.y()) : Kernel::Point_2(p.x(), p.y());
}

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << filename << " cannot be read" << std::endl;
    return EXIT_FAILURE;
  }

  const auto is_back = mesh.add_property_map<Mesh::Face_index, bool>("f:back", false).first;
  const auto texture = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:texture").first;
  for(const Mesh::Face_index f : mesh.faces())
  {
    is_back[f] = mesh.point(mesh.target(mesh.halfedge(f))).z() < 0;
    for(const Mesh::Halfedge_index h : mesh.halfedges_around_face(mesh.halfedge(f)))
      texture[h] = project(mesh.point(mesh.target(h)), is_back[f]);
  }

  IAR::Attribute_transfer<Mesh> transfer;
  transfer.add_corner_map(texture);
  transfer.add_face_map(is_back);
  const auto is_seam = mesh.add_property_map<Mesh::Edge_index, bool>("e:seam", false).first;
  const std::size_t seams_before = transfer.mark_seams(mesh, is_seam);
  IAR::isotropic_remeshing(IAR::Face_count(10000), mesh, CGAL::parameters::visitor(transfer).edge_is_constrained_map(is_seam));

  double error = 0;
  for(const Mesh::Face_index f : mesh.faces())
    for(const Mesh::Halfedge_index h : mesh.halfedges_around_face(mesh.halfedge(f)))
      error = (std::max)(error, std::sqrt(CGAL::squared_distance(texture[h], project(mesh.point(mesh.target(h)), is_back[f]))));
  std::size_t seams = 0;
  for(const Mesh::Edge_index e : mesh.edges())
    seams += is_seam[e];
  const bool are_seams_kept = transfer.mark_seams(mesh, is_seam) == seams;
  std::cout << "edges of the seam: " << seams_before << ", now " << seams << "; texture coordinates are off by " << error << " at most\n";
  return are_seams_kept ? EXIT_SUCCESS : EXIT_FAILURE;
}
