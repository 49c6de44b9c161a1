// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parts that were simplified by edge collapses, which breaks their sharp edges: by default, with nothing as a feature, and by PMP with the
// edges of 40 degrees and more marked. Per number of faces, sums and means over the parts as a table in Markdown. The same for hulls of
// balls and discs, as those of robots' links, by the number of points on a ball.
//
//   simplified_parts [mesh...]       triangle meshes; parts of CGAL's data where none is given

#include "Result_row.h"

#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/convex_hull_3.h>
#include <CGAL/number_type_config.h>

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

namespace IAR = CGAL::Inter_angle_remeshing;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace parameters = CGAL::parameters;

namespace {

constexpr std::size_t NUMBERS_OF_FACES[] = {4000, 2500, 2000, 1000};
// Of the mean edge length of what was simplified.
constexpr double LENGTH = 0.5;
constexpr std::size_t NUMBERS_OF_POINTS[] = {40, 80, 150};
constexpr double PART_OF_DIAGONAL = 0.02;

Mesh simplified(Mesh mesh, std::size_t faces)
{
  const auto are_few = [&](const auto& /* cost */, const auto& /* profile */, auto /* initial */, auto edges) {
    return edges <= 3 * faces / 2; };
  CGAL::Surface_mesh_simplification::edge_collapse(mesh, are_few);
  mesh.collect_garbage();
  return mesh;
}

using Points = std::vector<Kernel::Point_3>;

// Along a spiral on a sphere.
void append_ball(Points& points, std::size_t n, double radius, const Kernel::Vector_3& center)
{
  for (std::size_t i = 0; i < n; ++i) {
    const double z = 1 - double(2 * i + 1) / double(n), angle = double(i) * (3 - std::sqrt(5.)) * CGAL_PI, r = std::sqrt(1 - z * z);
    points.push_back(CGAL::ORIGIN + center + radius * Kernel::Vector_3(r * std::cos(angle), r * std::sin(angle), z));
  }
}

void append_disc(Points& points, std::size_t n, double radius, const Kernel::Vector_3& center, double tilt)
{
  for (std::size_t i = 0; i < n; ++i) {
    const double t = 2 * CGAL_PI * double(i) / double(n), x = std::cos(t);
    points.push_back(CGAL::ORIGIN + center + radius * Kernel::Vector_3(x * std::cos(tilt), std::sin(t), -x * std::sin(tilt)));
  }
}

// Of a ball and a disc, and of two balls and a disc, so far apart.
std::vector<Mesh> hulls(std::size_t n, double distance, double tilt)
{
  Points ball_and_disc, two_balls_and_disc;
  append_ball(ball_and_disc, n, .6, {0, 0, 0});
  append_disc(ball_and_disc, 24, .5, {.7 * distance, 0, distance}, tilt);
  append_ball(two_balls_and_disc, n, .5, {0, 0, 0});
  append_ball(two_balls_and_disc, n / 2, .3, {distance, 0, .4});
  append_disc(two_balls_and_disc, 20, .4, {0, .6 * distance, .5 * distance}, tilt);
  std::vector<Mesh> result(2);
  CGAL::convex_hull_3(ball_and_disc.begin(), ball_and_disc.end(), result[0]);
  CGAL::convex_hull_3(two_balls_and_disc.begin(), two_balls_and_disc.end(), result[1]);
  return result;
}

double diagonal(const Mesh& mesh)
{
  const CGAL::Bbox_3 box = PMP::bbox(mesh);
  return std::hypot(box.x_span(), box.y_span(), box.z_span());
}

struct Rows
{
  Result_row ours{"ours"}, plain{"no features"}, peer{"PMP"};

  void add(const Mesh& input, double length);
  void print(double first) const
  {
    for (const Result_row* row : {&ours, &plain, &peer}) row->print(first, peer);
  }
};

void remesh_by_pmp(Mesh& mesh, double length)
{
  const auto marks = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_constrained", false).first;
  PMP::detect_sharp_edges(mesh, 40, marks);
  PMP::isotropic_remeshing(faces(mesh), length, mesh, parameters::number_of_iterations(10).edge_is_constrained_map(marks));
}

void Rows::add(const Mesh& input, double length)
{
  ours.add(input, input, length, [&](Mesh& m) { IAR::isotropic_remeshing(length, m); });
  plain.add(input, input, length, [&](Mesh& m) { IAR::isotropic_remeshing(length, m, parameters::sharpness_angle(180)); });
  peer.add(input, input, length, [&](Mesh& m) { remesh_by_pmp(m, length); });
}

}

int main(int argc, char* argv[])
{
  std::vector<std::string> paths(argv + 1, argv + argc);
  if (paths.empty())
    for (const char* name : {"anchor_dense", "couplingdown", "fandisk", "part", "pinion", "rotor", "turbine"})
      paths.push_back(CGAL::data_file_path(std::string("meshes/") + name + ".off"));
  Result_row::print_head("faces");
  for (const std::size_t n : NUMBERS_OF_FACES) {
    Rows rows;
    for (const std::string& path : paths) {
      const Mesh mesh = read_mesh(path);
      if (mesh.number_of_faces() < 5 * n / 4) continue;
      const Mesh input = simplified(mesh, n);
      rows.add(input, LENGTH * mean_edge_length(input));
    }
    rows.print(double(n));
  }
  if (argc > 1) return 0;
  std::printf("\n");
  Result_row::print_head("points");
  for (const std::size_t n : NUMBERS_OF_POINTS) {
    Rows rows;
    for (const double distance : {1., 2., 3.})
      for (const double tilt : {0., .4, .8})
        for (const Mesh& input : hulls(n, distance, tilt)) rows.add(input, PART_OF_DIAGONAL * diagonal(input));
    rows.print(double(n));
  }
}
