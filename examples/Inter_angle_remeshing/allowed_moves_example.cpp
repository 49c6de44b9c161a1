// Copyright (c) 2026 The Inter_angle_remeshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Says which moves of vertices are allowed: none that leads out of a solid, so that the result never needs more room than the input has.
// New vertices are put onto the input's facets, which takes them nowhere else.

#include <CGAL/Inter_angle_remeshing/Projection/Closest_point_projector.h>
#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>

namespace IAR = CGAL::Inter_angle_remeshing;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;
using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

// How far outside of a solid a point is; 0 inside of it.
class Distance_outside
{
public:
  explicit Distance_outside(const Mesh& solid) : tree_(faces(solid).first, faces(solid).second, solid), side_(tree_) {}
  double operator()(const Point& p) const
  {
    return side_(p) == CGAL::ON_UNBOUNDED_SIDE ? std::sqrt(tree_.squared_distance(p)) : 0.;
  }

private:
  Tree tree_;
  CGAL::Side_of_triangle_mesh<Mesh, Kernel> side_;
};

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << filename << " cannot be read" << std::endl;
    return EXIT_FAILURE;
  }
  const Mesh solid = mesh;
  const Distance_outside distance_outside(solid);
  const double length = IAR::target_edge_length(faces(mesh), mesh, mesh.number_of_faces()), tolerance = 1e-3 * length;

  std::size_t questions = 0, denials = 0;
  const auto stays_inside = [&](Vertex, const Point&, const Point& to)
  {
    const bool is_allowed = distance_outside(to) <= tolerance;
    ++questions;
    denials += !is_allowed;
    return is_allowed;
  };
  const IAR::Closest_point_projector<Mesh> facets(solid);
  const IAR::Remeshing_report report = IAR::isotropic_remeshing(faces(mesh), length, mesh,
    CGAL::parameters::allow_move_functor(stays_inside).projection_functor(std::cref(facets)));

  double farthest = 0;
  for(const Vertex v : vertices(mesh))
    farthest = (std::max)(farthest, distance_outside(mesh.point(v)));
  std::cout << questions << " questions, " << denials << " moves denied\n"
            << "theta_avg " << report.angles_before.average << " -> " << report.angles_after.average << " degrees\n"
            << "farthest vertex outside: " << farthest / length << " target lengths" << std::endl;
  return farthest <= tolerance && report.angles_after.average > report.angles_before.average ? EXIT_SUCCESS : EXIT_FAILURE;
}
