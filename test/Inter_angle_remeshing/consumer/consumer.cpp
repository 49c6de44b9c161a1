// Copyright (c) 2026 The Inter_angle_remeshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>
#include <CGAL/Inter_angle_remeshing/triangle_quality.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <cstdlib>

// An icosahedron, refined: the headers are found and so is all that they include and link to.
int main()
{
  namespace IAR = CGAL::Inter_angle_remeshing;
  CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> mesh;
  CGAL::make_icosahedron<decltype(mesh), CGAL::Simple_cartesian<double>::Point_3>(mesh);
  const IAR::Remeshing_report report = IAR::isotropic_remeshing(0.3, mesh);
  const auto angles = IAR::inter_angle_statistics(mesh);
  const bool is_good = faces(mesh).size() > 200 && report.output_faces == faces(mesh).size() &&
                       angles.minimum_angle > 30 && angles.maximum_angle < 120;
  return is_good ? EXIT_SUCCESS : EXIT_FAILURE;
}
