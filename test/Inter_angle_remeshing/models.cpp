// Copyright (c) 2026 The Inter_angle_remeshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "models.h"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/clip.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/alpha_wrap_3.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace models {

namespace PMP = CGAL::Polygon_mesh_processing;

Mesh of_cgal(const std::string& name)
{
  Mesh mesh;
  if(!PMP::IO::read_polygon_mesh(CGAL::data_file_path("meshes/" + name + ".off"), mesh))
    throw std::runtime_error(name + " cannot be read; see CGAL_DATA_DIR");
  return mesh;
}

Mesh from_file(const std::string& path)
{
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> polygons;
  Mesh mesh;
  if(!CGAL::IO::read_polygon_soup(path, points, polygons))
    return mesh;
  PMP::orient_polygon_soup(points, polygons);
  if(!PMP::is_polygon_soup_a_polygon_mesh(polygons))
    return mesh;
  PMP::polygon_soup_to_polygon_mesh(points, polygons, mesh);
  if(!CGAL::is_triangle_mesh(mesh))
    PMP::triangulate_faces(mesh);
  return CGAL::is_triangle_mesh(mesh) ? mesh : Mesh();
}

Mesh from_soup(const meshes::Soup& soup)
{
  std::vector<Point> points;
  for(const auto& p : soup.points)
    points.emplace_back(p[0], p[1], p[2]);
  auto triangles = soup.faces;
  PMP::merge_duplicate_points_in_polygon_soup(points, triangles);
  PMP::orient_polygon_soup(points, triangles);
  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(points, triangles, mesh);
  return mesh;
}

Mesh cut_off(Mesh mesh, const Kernel::Plane_3& plane)
{
  if(!PMP::clip(mesh, plane, CGAL::parameters::clip_volume(true)) || !CGAL::is_triangle_mesh(mesh))
    throw std::runtime_error("a model was not cut");
  mesh.collect_garbage();
  return mesh;
}

Mesh difference(Mesh a, Mesh b)
{
  for(Mesh* const mesh : {&a, &b})
    if(!PMP::is_outward_oriented(*mesh))
      PMP::reverse_face_orientations(*mesh);
  Mesh result;
  if(!PMP::corefine_and_compute_difference(a, b, result) || !CGAL::is_triangle_mesh(result))
    throw std::runtime_error("there is no difference of two models");
  result.collect_garbage();
  return result;
}

Mesh simplified(Mesh mesh, std::size_t faces)
{
  const auto are_few = [&](const auto& /* cost */, const auto& /* profile */, auto /* initial */, auto edges) {
    return edges <= 3 * faces / 2; };
  CGAL::Surface_mesh_simplification::edge_collapse(mesh, are_few);
  mesh.collect_garbage();
  return mesh;
}

Mesh wrap(const Mesh& mesh)
{
  const CGAL::Bbox_3 box = PMP::bbox(mesh);
  const double alpha = std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin()) / 30;
  Mesh result;
  CGAL::alpha_wrap_3(mesh, alpha, alpha / 20, result);
  return result;
}

Mesh remeshed_by_pmp(Mesh mesh, double length, unsigned iterations)
{
  PMP::isotropic_remeshing(faces(mesh), length, mesh, CGAL::parameters::number_of_iterations(iterations));
  return mesh;
}

} // namespace models
