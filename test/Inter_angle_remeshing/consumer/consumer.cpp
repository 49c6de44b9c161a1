// Copyright (c) 2026 The Inter_angle_remeshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Inter_angle_remeshing/triangle_quality.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <cstdlib>

// One equilateral triangle, whose angles are known: the headers are found and so is all that they include.
int main()
{
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  CGAL::Surface_mesh<Point> mesh;
  mesh.add_face(mesh.add_vertex(Point(0, 0, 0)),
                mesh.add_vertex(Point(1, 0, 0)),
                mesh.add_vertex(Point(0.5, std::sqrt(0.75), 0)));
  const auto statistics = CGAL::Inter_angle_remeshing::inter_angle_statistics(mesh);
  return std::abs(statistics.minimum_angle - 60) < 1e-6 ? EXIT_SUCCESS : EXIT_FAILURE;
}
