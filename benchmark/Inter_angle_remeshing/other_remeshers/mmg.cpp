// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "remeshers.h"

#include <CGAL/Real_timer.h>

#include <mmg/mmgs/libmmgs.h>

#include <stdexcept>
#include <vector>

namespace { constexpr double TOLERANCE = 0.1; }       // in target lengths

Timed_soup remesh_by_mmg(const Triangle_soup& input, double length)
{
  MMG5_pMesh mesh = nullptr;
  MMG5_pSol metric = nullptr;
  MMGS_Init_mesh(MMG5_ARG_start, MMG5_ARG_ppMesh, &mesh, MMG5_ARG_ppMet, &metric, MMG5_ARG_end);
  const auto check = [](int returned) {
    if (returned != 1) throw std::runtime_error("mmgs refuses the mesh");
  };
  check(MMGS_Set_meshSize(mesh, MMG5_int(input.points.size()), MMG5_int(input.triangles.size()), 0));
  for (std::size_t i = 0; i < input.points.size(); ++i)
    check(MMGS_Set_vertex(mesh, input.points[i][0], input.points[i][1], input.points[i][2], 0, MMG5_int(i + 1)));
  for (std::size_t i = 0; i < input.triangles.size(); ++i) {
    const auto& t = input.triangles[i];
    check(MMGS_Set_triangle(mesh, MMG5_int(t[0] + 1), MMG5_int(t[1] + 1), MMG5_int(t[2] + 1), 0, MMG5_int(i + 1)));
  }
  check(MMGS_Set_iparameter(mesh, metric, MMGS_IPARAM_verbose, -1));
  check(MMGS_Set_dparameter(mesh, metric, MMGS_DPARAM_hsiz, length));
  check(MMGS_Set_dparameter(mesh, metric, MMGS_DPARAM_hausd, TOLERANCE * length));

  Timed_soup result;
  CGAL::Real_timer timer;
  timer.start();
  const int returned = MMGS_mmgslib(mesh, metric);
  result.seconds = timer.time();
  if (returned == MMG5_STRONGFAILURE) throw std::runtime_error("mmgs fails");

  MMG5_int points, triangles;
  check(MMGS_Get_meshSize(mesh, &points, &triangles, nullptr));
  result.soup.points.resize(std::size_t(points));
  for (auto& p : result.soup.points) check(MMGS_Get_vertex(mesh, &p[0], &p[1], &p[2], nullptr, nullptr, nullptr));
  result.soup.triangles.resize(std::size_t(triangles));
  for (auto& t : result.soup.triangles) {
    MMG5_int v[3];
    check(MMGS_Get_triangle(mesh, &v[0], &v[1], &v[2], nullptr, nullptr));
    for (int k = 0; k < 3; ++k) t[k] = std::size_t(v[k] - 1);
  }
  MMGS_Free_all(MMG5_ARG_start, MMG5_ARG_ppMesh, &mesh, MMG5_ARG_ppMet, &metric, MMG5_ARG_end);
  return result;
}
