// Copyright (c) 2026 The Inter_angle_remeshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Attributes that go with the surface: scalars, normals and materials, whose border is kept because they are patches.

#include <CGAL/Inter_angle_remeshing/Attribute_transfer.h>
#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

namespace IAR = CGAL::Inter_angle_remeshing;
namespace PMP = CGAL::Polygon_mesh_processing;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vector = Kernel::Vector_3;

double wave_at(const Kernel::Point_3& p) { return std::sin(10 * p.x()) * std::cos(10 * p.z()); }

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << filename << " cannot be read" << std::endl;
    return EXIT_FAILURE;
  }

  const auto height = mesh.add_property_map<Mesh::Vertex_index, double>("v:height", 0).first;
  const auto wave = mesh.add_property_map<Mesh::Vertex_index, double>("v:wave", 0).first;
  const auto normal = mesh.add_property_map<Mesh::Vertex_index, Vector>("v:normal").first;
  const auto material = mesh.add_property_map<Mesh::Face_index, int>("f:material", 0).first;
  PMP::compute_vertex_normals(mesh, normal);
  for(const Mesh::Vertex_index v : mesh.vertices())
  {
    height[v] = mesh.point(v).y();
    wave[v] = wave_at(mesh.point(v));
  }
  for(const Mesh::Face_index f : mesh.faces())
    material[f] = mesh.point(mesh.target(mesh.halfedge(f))).y() > 0;

  // Scalars and vectors are interpolated linearly, smooth functions by quadratics; normals have unit length afterwards.
  IAR::Attribute_transfer<Mesh> transfer;
  transfer.add_vertex_map(height);
  transfer.add_smooth_vertex_map(wave, mesh);
  transfer.add_vertex_map(normal, [](const std::array<Vector, 3>& n, const std::array<double, 3>& b) {
    const Vector sum = IAR::Linear_interpolation()(n, b);
    return sum / std::sqrt(sum.squared_length());
  });
  transfer.add_face_map(material);
  IAR::isotropic_remeshing(IAR::Face_count(10000), mesh, CGAL::parameters::visitor(transfer).face_patch_map(material));

  double error = 0, wave_error = 0, length = 0;
  for(const Mesh::Vertex_index v : mesh.vertices())
  {
    error = (std::max)(error, std::abs(height[v] - mesh.point(v).y()));
    wave_error = (std::max)(wave_error, std::abs(wave[v] - wave_at(mesh.point(v))));
    length = (std::max)(length, std::abs(normal[v].squared_length() - 1));
  }
  std::cout << num_faces(mesh) << " faces; the height is off by " << error << " at most, the wave by " << wave_error << "\n";
  return length < 1e-9 ? EXIT_SUCCESS : EXIT_FAILURE;
}
