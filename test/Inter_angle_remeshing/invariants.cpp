// Copyright (c) 2026 The Inter_angle_remeshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "invariants.h"

#include <CGAL/Inter_angle_remeshing/internal/compatibility.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/distance.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <iterator>

namespace invariants {

namespace PMP = CGAL::Polygon_mesh_processing;

Topology topology(const Mesh& mesh)
{
  Topology t;
  for(const Vertex v : vertices(mesh))
    t.isolated_vertices += mesh.is_isolated(v);
  t.euler_characteristic = long(mesh.number_of_vertices() - t.isolated_vertices) - long(mesh.number_of_edges()) +
                           long(mesh.number_of_faces());
  std::vector<std::size_t> component(mesh.number_of_faces() + mesh.number_of_removed_faces());
  t.components = PMP::connected_components(
    mesh, boost::make_iterator_property_map(component.begin(), get(CGAL::face_index, mesh)));
  t.border_cycles = number_of_border_cycles(mesh);
  return t;
}

double mean_edge_length(const Mesh& mesh)
{
  double sum = 0;
  for(const Edge e : edges(mesh))
    sum += std::sqrt(CGAL::squared_distance(mesh.point(source(e, mesh)), mesh.point(target(e, mesh))));
  return sum / double(mesh.number_of_edges());
}

bool does_self_intersect(const Mesh& mesh) { return PMP::does_self_intersect(mesh); }

std::vector<std::pair<Face, Face>> self_intersections(const Mesh& mesh)
{
  std::vector<std::pair<Face, Face>> pairs;
  PMP::self_intersections(mesh, std::back_inserter(pairs));
  return pairs;
}

std::size_t number_of_flipped_faces(const Mesh& mesh, const Mesh& input)
{
  using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh>;
  using Tree = CGAL::AABB_tree<CGAL::Inter_angle_remeshing::internal::AABB_traits<Kernel, Primitive>>;
  std::vector<Face> proper;
  for(const Face f : faces(input))
    if(normal(f, input) != CGAL::NULL_VECTOR)
      proper.push_back(f);
  Tree tree(proper.begin(), proper.end(), input);
  tree.accelerate_distance_queries();
  const auto all = faces(mesh);
  return std::size_t(std::count_if(all.begin(), all.end(), [&](Face f) {
    const auto p = corners(f, mesh);
    const Face nearest = tree.closest_point_and_primitive(CGAL::centroid(p[0], p[1], p[2])).second;
    return normal(f, mesh) * normal(nearest, input) < 0;
  }));
}

CGAL::Inter_angle_remeshing::Surface_distance surface_distance(const Mesh& mesh, const Mesh& other, std::size_t number_of_points)
{
  return CGAL::Inter_angle_remeshing::surface_distance(mesh, other, CGAL::parameters::number_of_points_on_faces(number_of_points));
}

double largest_distance(const std::vector<Point>& points, const Mesh& mesh)
{
  return PMP::max_distance_to_triangle_mesh<CGAL::Sequential_tag>(points, mesh);
}

} // namespace invariants
