// Copyright (c) 2026 The Inter_angle_remeshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Remeshes a part of a mechanical part: some of its patches, with sharp edges and a few vertices kept, and patches known afterwards.

#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace IAR = CGAL::Inter_angle_remeshing;
namespace PMP = CGAL::Polygon_mesh_processing;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Edge = Mesh::Edge_index;
using Face = Mesh::Face_index;

template <class IsConstrained>
double constrained_length(const Mesh& mesh, const IsConstrained& is_constrained)
{
  double sum = 0;
  for(const Edge e : edges(mesh))
    if(is_constrained[e])
      sum += PMP::edge_length(halfedge(e, mesh), mesh);
  return sum;
}

// Whether the map is right where it must be: all edges between two patches are constrained.
template <class IsConstrained, class Patch>
bool are_borders_of_patches_constrained(const Mesh& mesh, const IsConstrained& is_constrained, const Patch& patch)
{
  for(const Edge e : edges(mesh))
  {
    const Face f = face(halfedge(e, mesh), mesh), g = face(opposite(halfedge(e, mesh), mesh), mesh);
    if(patch[f] != patch[g] && !is_constrained[e])
      return false;
  }
  return true;
}

// The vertices that are where they were in the input.
std::size_t number_in_place(const Mesh& mesh, const std::vector<Vertex>& vertices, const std::vector<Kernel::Point_3>& points)
{
  std::size_t count = 0;
  for(std::size_t i = 0; i < vertices.size(); ++i)
    count += !mesh.is_removed(vertices[i]) && mesh.point(vertices[i]) == points[i];
  return count;
}

int main()
{
  const std::string filename = CGAL::data_file_path("meshes/fandisk.off");
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << filename << " cannot be read" << std::endl;
    return EXIT_FAILURE;
  }

  const auto is_constrained = mesh.add_property_map<Edge, bool>("e:is_constrained", false).first;
  const auto patch = mesh.add_property_map<Face, std::size_t>("f:patch", 0).first;
  PMP::detect_sharp_edges(mesh, 40, is_constrained);
  const std::size_t number_of_patches =
    PMP::connected_components(mesh, patch, CGAL::parameters::edge_is_constrained_map(is_constrained));

  // All patches but the first. The edges that it shares with them are neither split nor collapsed.
  std::vector<Face> range, outside;
  for(const Face f : faces(mesh))
    (patch[f] == 0 ? outside : range).push_back(f);
  std::vector<Kernel::Point_3> corners_outside;
  for(const Face f : outside)
    corners_outside.push_back(mesh.point(target(halfedge(f, mesh), mesh)));

  // One vertex of a hundred, as a measurement may refer to it: these neither move nor vanish.
  const auto is_landmark = mesh.add_property_map<Vertex, bool>("v:is_landmark", false).first;
  std::vector<Vertex> landmarks, others;
  std::vector<Kernel::Point_3> landmark_points, other_points;
  for(const Vertex v : vertices(mesh))
  {
    is_landmark[v] = v.idx() % 100 == 0;
    (is_landmark[v] ? landmarks : others).push_back(v);
    (is_landmark[v] ? landmark_points : other_points).push_back(mesh.point(v));
  }

  const double length = IAR::target_edge_length(range, mesh, range.size() / 2);
  const double length_before = constrained_length(mesh, is_constrained);
  const IAR::Remeshing_report report = IAR::isotropic_remeshing(range, length, mesh,
    CGAL::parameters::edge_is_constrained_map(is_constrained).vertex_is_constrained_map(is_landmark).face_patch_map(patch));
  const double length_after = constrained_length(mesh, is_constrained);

  std::cout << number_of_patches << " patches, " << outside.size() << " faces left out; in the range "
            << report.input_faces << " faces became " << report.output_faces << " by " << report.splits
            << " splits and " << report.collapses << " collapses\n"
            << "theta_avg in the range: " << report.angles_before.average << " -> " << report.angles_after.average
            << " degrees\n"
            << "length of the constrained edges: " << length_before << " -> " << length_after << "\n"
            << "in place: " << number_in_place(mesh, landmarks, landmark_points) << " of " << landmarks.size() << " landmarks, "
            << number_in_place(mesh, others, other_points) << " of " << others.size() << " other vertices\n";

  bool is_outside_untouched = mesh.number_of_faces() == outside.size() + report.output_faces;
  for(std::size_t i = 0; i < outside.size(); ++i)
    is_outside_untouched = is_outside_untouched && !mesh.is_removed(outside[i]) && patch[outside[i]] == 0 &&
                           mesh.point(target(halfedge(outside[i], mesh), mesh)) == corners_outside[i];

  // Curved ones are cut short a little where edges merge.
  const bool are_features_kept = std::abs(length_after - length_before) < 0.01 * length_before;
  const bool are_landmarks_kept = number_in_place(mesh, landmarks, landmark_points) == landmarks.size();
  return is_outside_untouched && are_features_kept && are_landmarks_kept &&
         are_borders_of_patches_constrained(mesh, is_constrained, patch) ? EXIT_SUCCESS : EXIT_FAILURE;
}
