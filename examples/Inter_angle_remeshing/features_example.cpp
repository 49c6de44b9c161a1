// Copyright (c) 2026 The Inter_angle_remeshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The sharp edges of a mechanical part, which are found and kept by themselves: with them, without them, with those over an angle
// of the user's, and the detector alone.

#include <CGAL/Inter_angle_remeshing/detect_features.h>
#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>
#include <CGAL/Inter_angle_remeshing/surface_distance.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>

namespace IAR = CGAL::Inter_angle_remeshing;
namespace PMP = CGAL::Polygon_mesh_processing;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

// Of the edges with a dihedral angle over that one, in degrees.
double length_of_sharp_edges(Mesh mesh, double angle)
{
  const auto is_sharp = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_sharp", false).first;
  PMP::detect_sharp_edges(mesh, angle, is_sharp);
  double sum = 0;
  for(const Mesh::Edge_index e : edges(mesh))
    if(is_sharp[e])
      sum += PMP::edge_length(halfedge(e, mesh), mesh);
  return sum;
}

int main()
{
  const std::string filename = CGAL::data_file_path("meshes/anchor_dense.off");
  Mesh input;
  if(!CGAL::IO::read_polygon_mesh(filename, input))
  {
    std::cerr << filename << " cannot be read" << std::endl;
    return EXIT_FAILURE;
  }
  const double length = IAR::target_edge_length(faces(input), input, 8000);

  // Nothing is marked: the model tells its features itself.
  Mesh sharp = input;
  const IAR::Remeshing_report report = IAR::isotropic_remeshing(length, sharp);
  const bool is_cad = report.features == IAR::Remeshing_report::Features::all_sharp_edges;
  std::cout << (is_cad ? "a CAD model" : "no CAD model") << ": " << report.feature_edges << " edges are features\n";

  // An angle of 180 degrees turns that off: nothing is a feature.
  Mesh rounded = input;
  IAR::isotropic_remeshing(length, rounded, CGAL::parameters::sharpness_angle(180));

  sharp.collect_garbage();
  rounded.collect_garbage();
  const double kept = IAR::surface_distance(input, sharp).relative_hausdorff(),
               lost = IAR::surface_distance(input, rounded).relative_hausdorff();
  std::cout << "Hausdorff distance from the input, in percent of the diagonal: " << 100 * kept << " with features, "
            << 100 * lost << " without\n";

  // An angle in degrees: the edges over it are features, whatever the model looks like, and nothing else is looked for. A map that is
  // handed over with it holds them afterwards.
  Mesh by_angle = input;
  const auto is_sharp = by_angle.add_property_map<Mesh::Edge_index, bool>("e:is_sharp", false).first;
  const double sharp_before = length_of_sharp_edges(input, 60);
  IAR::isotropic_remeshing(length, by_angle, CGAL::parameters::sharpness_angle(60).edge_is_constrained_map(is_sharp));
  double sharp_after = 0;
  for(const Mesh::Edge_index e : edges(by_angle))
    if(is_sharp[e])
      sharp_after += PMP::edge_length(halfedge(e, by_angle), by_angle);
  std::cout << "length of the edges over 60 degrees: " << sharp_before << ", of what they became: " << sharp_after << "\n";

  // The detector alone. What it finds can be changed before it is handed over as edge_is_constrained_map.
  Mesh mesh = input;
  const auto is_feature = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_feature", false).first;
  const std::size_t found = IAR::detect_features(faces(mesh), mesh, is_feature);
  IAR::isotropic_remeshing(length, mesh, CGAL::parameters::edge_is_constrained_map(is_feature));
  std::size_t after = 0;
  for(const Mesh::Edge_index e : edges(mesh))
    after += is_feature[e];
  std::cout << "detect_features(): " << found << " edges; " << after << " of the result lie on their curves\n";
  // Curved ones are cut short a little where edges merge.
  const bool are_sharp_edges_kept = std::abs(sharp_after - sharp_before) < 0.01 * sharp_before;
  return is_cad && found == report.feature_edges && 3 * kept < lost && are_sharp_edges_kept ? EXIT_SUCCESS : EXIT_FAILURE;
}
