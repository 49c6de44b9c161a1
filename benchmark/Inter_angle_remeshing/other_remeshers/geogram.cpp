// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "remeshers.h"

#include <CGAL/Real_timer.h>

#include <geogram/basic/command_line.h>
#include <geogram/basic/command_line_args.h>
#include <geogram/basic/common.h>
#include <geogram/basic/logger.h>
#include <geogram/basic/process.h>
#include <geogram/mesh/mesh.h>
#include <geogram/mesh/mesh_remesh.h>

namespace {

void initialize_geogram()
{
  static const bool is_ready = []() {
    GEO::initialize(GEO::GEOGRAM_INSTALL_NONE);
    for (const char* group : {"standard", "algo", "remesh"}) GEO::CmdLine::import_arg_group(group);
    GEO::Logger::instance()->set_quiet(true);
    GEO::Process::enable_multithreading(false);
    return true;
  }();
  (void)is_ready;
}

} // namespace

Timed_soup remesh_by_geogram(const Triangle_soup& input, std::size_t points)
{
  initialize_geogram();
  GEO::vector<double> coordinates;
  for (const auto& p : input.points) coordinates.insert(coordinates.end(), p.begin(), p.end());
  GEO::vector<GEO::index_t> triangles;
  for (const auto& t : input.triangles)
    for (const std::size_t v : t) triangles.push_back(GEO::index_t(v));
  GEO::Mesh mesh, remeshed;
  mesh.facets.assign_triangle_mesh(3, coordinates, triangles, true);
  mesh.facets.connect();

  Timed_soup result;
  CGAL::Real_timer timer;
  timer.start();
  GEO::remesh_smooth(mesh, remeshed, GEO::index_t(points), 3);
  result.seconds = timer.time();

  for (const GEO::index_t v : remeshed.vertices) {
    const double* p = remeshed.vertices.point_ptr(v);
    result.soup.points.push_back({p[0], p[1], p[2]});
  }
  for (const GEO::index_t f : remeshed.facets)
    result.soup.triangles.push_back({remeshed.facets.vertex(f, 0), remeshed.facets.vertex(f, 1), remeshed.facets.vertex(f, 2)});
  return result;
}
