// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "remeshers.h"

#include <CGAL/Real_timer.h>

#include <pmp/algorithms/remeshing.h>
#include <pmp/surface_mesh.h>

Timed_soup remesh_by_pmp_library(const Triangle_soup& input, double length)
{
  pmp::SurfaceMesh mesh;
  for (const auto& p : input.points) mesh.add_vertex(pmp::Point(pmp::Scalar(p[0]), pmp::Scalar(p[1]), pmp::Scalar(p[2])));
  const auto vertex = [](std::size_t i) { return pmp::Vertex(pmp::IndexType(i)); };
  for (const auto& t : input.triangles) mesh.add_triangle(vertex(t[0]), vertex(t[1]), vertex(t[2]));

  Timed_soup result;
  CGAL::Real_timer timer;
  timer.start();
  pmp::uniform_remeshing(mesh, pmp::Scalar(length));
  result.seconds = timer.time();

  mesh.garbage_collection();
  for (const pmp::Vertex v : mesh.vertices()) {
    const pmp::Point& p = mesh.position(v);
    result.soup.points.push_back({double(p[0]), double(p[1]), double(p[2])});
  }
  for (const pmp::Face f : mesh.faces()) {
    std::size_t k = 0;
    auto& triangle = result.soup.triangles.emplace_back();
    for (const pmp::Vertex v : mesh.vertices(f)) triangle[k++] = v.idx();
  }
  return result;
}
