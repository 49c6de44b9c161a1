// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTER_ANGLE_REMESHING_BENCHMARK_MESHES_H
#define INTER_ANGLE_REMESHING_BENCHMARK_MESHES_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

// Throws std::runtime_error if it is not there or no triangle mesh.
Mesh read_mesh(const std::string& path);

// How many pairs of faces cross each other.
std::size_t crossing_pairs(const Mesh& mesh);

inline double mean_edge_length(const Mesh& mesh)
{
  double sum = 0;
  for (const auto e : mesh.edges())
    sum += CGAL::Polygon_mesh_processing::edge_length(mesh.halfedge(e), mesh);
  return sum / double(mesh.number_of_edges());
}

// The same surface with four triangles for each one: what a remesher gets from a scan of a higher resolution, as far
// as the shapes of the triangles are concerned.
inline Mesh subdivide(const Mesh& mesh)
{
  Mesh result;
  result.reserve(mesh.number_of_vertices() + mesh.number_of_edges(), 4 * mesh.number_of_edges(),
                 4 * mesh.number_of_faces());
  for (const auto v : mesh.vertices()) result.add_vertex(mesh.point(v));
  for (const auto e : mesh.edges())
    result.add_vertex(CGAL::midpoint(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  const auto middle = [&](Mesh::Halfedge_index h) {
    return Mesh::Vertex_index(Mesh::size_type(mesh.number_of_vertices() + std::size_t(mesh.edge(h))));
  };
  for (const auto f : mesh.faces()) {
    const auto h = mesh.halfedge(f), n = mesh.next(h), p = mesh.prev(h);
    result.add_face(mesh.target(p), middle(h), middle(p));
    result.add_face(mesh.target(h), middle(n), middle(h));
    result.add_face(mesh.target(n), middle(p), middle(n));
    result.add_face(middle(h), middle(n), middle(p));
  }
  return result;
}

// A torus with radii 1 and .4, of n times k quadrangles, halved.
inline Mesh torus_mesh(std::size_t n, std::size_t k)
{
  Mesh mesh;
  std::vector<Mesh::Vertex_index> v;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < k; ++j) {
      const double a = 2 * CGAL_PI * double(i) / double(n), b = 2 * CGAL_PI * double(j) / double(k), r = 1 + .4 * std::cos(b);
      v.push_back(mesh.add_vertex(Kernel::Point_3(r * std::cos(a), r * std::sin(a), .4 * std::sin(b))));
    }
  const auto at = [&](std::size_t i, std::size_t j) { return v[(i % n) * k + j % k]; };
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < k; ++j) {
      mesh.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      mesh.add_face(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  return mesh;
}

#endif // INTER_ANGLE_REMESHING_BENCHMARK_MESHES_H
