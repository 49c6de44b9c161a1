// Copyright (c) 2026 The Inter_angle_remeshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// With threads, where TBB is linked, and without: the result is the same, to the last bit.

#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/tags.h>

#include <chrono>
#include <cstdlib>
#include <iostream>
#include <string>

namespace IAR = CGAL::Inter_angle_remeshing;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

template <class ConcurrencyTag>
void remesh(const std::string& title, Mesh& mesh)
{
  const auto start = std::chrono::steady_clock::now();
  IAR::isotropic_remeshing<ConcurrencyTag>(IAR::Face_count(100000), mesh);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  mesh.collect_garbage();
  std::cout << title << ": " << num_faces(mesh) << " faces in " << seconds.count() << " s\n";
}

bool are_equal(const Mesh& a, const Mesh& b)
{
  if(num_vertices(a) != num_vertices(b) || num_halfedges(a) != num_halfedges(b) || num_faces(a) != num_faces(b))
    return false;
  for(const Mesh::Vertex_index v : vertices(a))
    if(a.point(v) != b.point(v))
      return false;
  for(const Mesh::Halfedge_index h : halfedges(a))
    if(target(h, a) != target(h, b) || next(h, a) != next(h, b))
      return false;
  return true;
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

  Mesh by_threads = mesh;
  remesh<CGAL::Sequential_tag>("one thread", mesh);
  remesh<CGAL::Parallel_if_available_tag>("as many as there are", by_threads);

  const bool is_same = are_equal(mesh, by_threads);
  std::cout << "the results are " << (is_same ? "the same\n" : "different\n");
  return is_same ? EXIT_SUCCESS : EXIT_FAILURE;
}
