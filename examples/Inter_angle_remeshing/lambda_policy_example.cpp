// Copyright (c) 2026 The Inter_angle_remeshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// A lambda as a policy: remeshes a mesh, but keeps the connectivity of one region, for instance because something is
// attached to its faces. The vertices of the region still move, and its triangles improve.

#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <set>
#include <string>

namespace IAR = CGAL::Inter_angle_remeshing;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;

// The triangles between kept vertices. Faces may change their descriptors, vertices do not.
template <class IsKept>
std::set<std::array<Vertex, 3> > kept_triangles(const Mesh& mesh, const IsKept& is_kept)
{
  std::set<std::array<Vertex, 3> > triangles;
  for(const Mesh::Face_index f : faces(mesh))
  {
    std::array<Vertex, 3> corners;
    std::size_t i = 0;
    for(const Vertex v : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
      corners[i++] = v;
    if(!std::all_of(corners.begin(), corners.end(), is_kept))
      continue;
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    triangles.insert(corners);
  }
  return triangles;
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

  // The region is remembered by vertices of the input, not by coordinates: vertices move during the run.
  const std::size_t number_of_input_vertices = num_vertices(mesh);
  const auto kept = mesh.add_property_map<Vertex, char>("v:kept", 0).first;
  for(const Vertex v : vertices(mesh))
    kept[v] = mesh.point(v).y() > 0;
  const auto is_kept = [&kept](const Vertex v) { return kept[v] != 0; };
  const auto before = kept_triangles(mesh, is_kept);

  // A vertex that a split made is none of the user's: its input vertex is the null vertex.
  const auto is_free = [&is_kept](const Vertex v) { return v == Mesh::null_vertex() || !is_kept(v); };
  // The parameter is generic, for it is an edge of the mesh that the remesher works on, which is not the user's.
  const auto may_change = [&is_free](const auto& edge)
  {
    return is_free(edge.input_vertex(edge.source())) && is_free(edge.input_vertex(edge.target()));
  };

  const IAR::Remeshing_report report = IAR::isotropic_remeshing(IAR::Face_count(2 * num_faces(mesh)), mesh,
    CGAL::parameters::do_split(may_change).do_collapse(may_change).do_flip(may_change));

  const auto after = kept_triangles(mesh, [&](const Vertex v)
  {
    return v < Vertex(Mesh::size_type(number_of_input_vertices)) && is_kept(v);
  });
  std::cout << report.input_faces << " faces became " << report.output_faces << "; of " << before.size()
            << " triangles of the region, " << after.size() << " are there afterwards\n"
            << "theta_avg of the whole mesh: " << report.angles_before.average << " -> " << report.angles_after.average
            << " degrees\n";
  return !before.empty() && before == after ? EXIT_SUCCESS : EXIT_FAILURE;
}
