// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What CAD systems export: surfaces of revolution whose faces are as long as the part and as narrow as it curves. By default
// with nothing marked, and by PMP with the edges over 40 degrees marked, both to a length at which so many equilateral
// triangles have the area of the input. Then what few iterations do, and targets far finer than the facets; plates of needles; regular
// grids, flat and wavy; terrains; boxes with tiny chamfers, with and without the merging of these; parts with fillets narrower than the
// target, with these for features and without; and reliefs finer than the target, given up and kept, where nothing is marked for PMP.
// Tables in Markdown.
//
//   tessellations [pairs]       the times are medians over so many pairs of runs; 5

#include "meshes.h"
#include "timing.h"

#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>
#include <CGAL/Inter_angle_remeshing/surface_distance.h>
#include <CGAL/Inter_angle_remeshing/triangle_quality.h>

#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace IAR = CGAL::Inter_angle_remeshing;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace parameters = CGAL::parameters;

namespace {

// Radii and heights, the outer side to the right of their order.
using Profile = std::vector<std::array<double, 2>>;

Profile arc(double r, double z, double radius, double from, double to, int steps)
{
  Profile result;
  for (int k = 0; k <= steps; ++k) {
    const double t = (from + (to - from) * k / steps) * CGAL_PI;
    result.push_back({r + radius * std::cos(t), z + radius * std::sin(t)});
  }
  return result;
}

Profile joined(Profile a, const Profile& b)
{
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

// Turned around the z axis in n steps; a profile that is not closed ends in fans from one vertex.
Mesh turned(const Profile& profile, std::size_t n, bool is_closed)
{
  Mesh mesh;
  std::vector<Mesh::Vertex_index> v;
  for (const auto& [r, z] : profile)
    for (std::size_t i = 0; i < n; ++i) {
      const double u = 2 * CGAL_PI * double(i) / double(n);
      v.push_back(mesh.add_vertex(Kernel::Point_3(r * std::cos(u), r * std::sin(u), z)));
    }
  const std::size_t m = profile.size();
  const auto at = [&](std::size_t j, std::size_t i) { return v[(j % m) * n + i % n]; };
  for (std::size_t j = 0; j < (is_closed ? m : m - 1); ++j)
    for (std::size_t i = 0; i < n; ++i) {
      mesh.add_face(at(j, i), at(j, i + 1), at(j + 1, i + 1));
      mesh.add_face(at(j, i), at(j + 1, i + 1), at(j + 1, i));
    }
  for (std::size_t i = 1; !is_closed && i + 1 < n; ++i) {
    mesh.add_face(at(0, 0), at(0, i + 1), at(0, i));
    mesh.add_face(at(m - 1, 0), at(m - 1, i), at(m - 1, i + 1));
  }
  return mesh;
}

// n by n quadrangles over a surface z = height sin x cos y, all cut the same way.
Mesh grid(std::size_t n, double height)
{
  Mesh mesh;
  std::vector<Mesh::Vertex_index> v;
  for (std::size_t j = 0; j <= n; ++j)
    for (std::size_t i = 0; i <= n; ++i) {
      const double x = 10. * double(i) / double(n), y = 10. * double(j) / double(n);
      v.push_back(mesh.add_vertex(Kernel::Point_3(x, y, height * std::sin(x) * std::cos(y))));
    }
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t a = j * (n + 1) + i, b = a + n + 1;
      mesh.add_face(v[a], v[a + 1], v[b + 1]);
      mesh.add_face(v[a], v[b + 1], v[b]);
    }
  return mesh;
}

// The unit square as n quadrangles as long as it, each of two triangles.
Mesh plate_of_needles(std::size_t n)
{
  Mesh mesh;
  std::vector<Mesh::Vertex_index> v;
  for (std::size_t i = 0; i <= n; ++i)
    for (const double y : {0., 1.}) v.push_back(mesh.add_vertex(Kernel::Point_3(double(i) / double(n), y, 0)));
  for (std::size_t i = 0; i < 2 * n; i += 2) {
    mesh.add_face(v[i], v[i + 2], v[i + 3]);
    mesh.add_face(v[i], v[i + 3], v[i + 1]);
  }
  return mesh;
}

// A torus of the radii 3 and 1, 120 by 40 quadrangles, all cut the same way.
Mesh torus()
{
  constexpr std::size_t ALONG = 120, AROUND = 40;
  Mesh mesh;
  std::vector<Mesh::Vertex_index> v;
  for (std::size_t i = 0; i < ALONG; ++i)
    for (std::size_t j = 0; j < AROUND; ++j) {
      const double a = 2 * CGAL_PI * double(i) / double(ALONG), b = 2 * CGAL_PI * double(j) / double(AROUND), r = 3 + std::cos(b);
      v.push_back(mesh.add_vertex(Kernel::Point_3(r * std::cos(a), r * std::sin(a), std::sin(b))));
    }
  for (std::size_t i = 0; i < ALONG; ++i)
    for (std::size_t j = 0; j < AROUND; ++j) {
      const std::size_t k = (i + 1) % ALONG, l = (j + 1) % AROUND;
      mesh.add_face(v[i * AROUND + j], v[k * AROUND + j], v[k * AROUND + l]);
      mesh.add_face(v[i * AROUND + j], v[k * AROUND + l], v[i * AROUND + l]);
    }
  return mesh;
}

// 40 by 40 cells with scattered corners, cut at random, under a block of 16 by 16 cells: its wall is one face high and goes in and out.
Mesh terrain(double height)
{
  constexpr std::size_t N = 40;
  constexpr double SCATTER = .3, ROUGHNESS = .1;
  std::mt19937 random(1);
  const auto up_to = [&](double bound) { return (random() / 4294967296. * 2 - 1) * bound; };
  const auto is_on_block = [](double x) { return x > .3 * N && x < .7 * N; };
  Mesh mesh;
  std::vector<Mesh::Vertex_index> v;
  for (std::size_t j = 0; j <= N; ++j)
    for (std::size_t i = 0; i <= N; ++i) {
      const double x = double(i) + (i % N == 0 ? 0 : up_to(SCATTER)), y = double(j) + (j % N == 0 ? 0 : up_to(SCATTER));
      v.push_back(mesh.add_vertex(Kernel::Point_3(x, y, is_on_block(x) && is_on_block(y) ? height : up_to(ROUGHNESS))));
    }
  for (std::size_t j = 0; j < N; ++j)
    for (std::size_t i = 0; i < N; ++i) {
      const std::size_t a = j * (N + 1) + i, b = a + N + 1;
      const bool is_flipped = random() % 2 == 0;
      mesh.add_face(v[a], v[a + 1], v[is_flipped ? b : b + 1]);
      mesh.add_face(v[is_flipped ? a + 1 : a], v[b + 1], v[b]);
    }
  return mesh;
}

// A box over the unit square whose upright edges are chamfers that take `c` of each side.
Mesh chamfered_box(double c, double height)
{
  Mesh mesh;
  std::vector<Mesh::Vertex_index> v;
  for (const double z : {0., height})
    for (const auto& [x, y] : {std::pair{c, 0.}, {1 - c, 0.}, {1., c}, {1., 1 - c}, {1 - c, 1.}, {c, 1.}, {0., 1 - c}, {0., c}})
      v.push_back(mesh.add_vertex(Kernel::Point_3(x, y, z)));
  for (std::size_t i = 0; i < 8; ++i) {
    const std::size_t j = (i + 1) % 8;
    mesh.add_face(v[i], v[j], v[8 + j]);
    mesh.add_face(v[i], v[8 + j], v[8 + i]);
    if (i == 0 || j == 0) continue;
    mesh.add_face(v[0], v[j], v[i]);
    mesh.add_face(v[8], v[8 + i], v[8 + j]);
  }
  return mesh;
}

struct Part
{
  std::string name;
  Mesh mesh;
};

constexpr double POLE = 1e-3;               // a small polygon

Profile wall_with_round_ends() { return joined(arc(.9, 6, .1, 0, 1, 12), arc(.9, 0, .1, 1, 2, 12)); }

std::vector<Part> parts()
{
  const Profile shaft = {{1, 0}, {1, 4}, {1.5, 4}, {1.5, 5}, {1, 5}, {1, 9}, {.6, 9}, {.6, 14}},
                pipe = {{1, 0}, {1, 6}, {.8, 6}, {.8, 0}}, rod = {{.3, 0}, {.3, 60}}, disc = {{1, 0}, {1, .05}},
                capsule = joined(arc(POLE, 0, 1, -.5, 0, 7), arc(POLE, 12, 1, 0, .5, 7)),
                tube = wall_with_round_ends();
  return {{"shaft, 12", turned(shaft, 12, false)}, {"shaft, 24", turned(shaft, 24, false)}, {"pipe, 16", turned(pipe, 16, true)},
          {"rod, 24", turned(rod, 24, false)}, {"disc, 200", turned(disc, 200, false)},
          {"capsule, 12", turned(capsule, 12, false)}, {"capsule, 64", turned(capsule, 64, false)},
          {"tube with round ends, 12", turned(tube, 12, true)}, {"tube with round ends, 64", turned(tube, 64, true)}};
}

// A disc and a stepped shaft, all of whose edges are rounded, by a radius of .05.
std::vector<Part> parts_with_fillets(int facets)
{
  const auto fillet = [&](double r, double z, double from, double to) { return arc(r, z, .05, from, to, facets); };
  const Profile disc = joined(fillet(.95, .05, -.5, 0), fillet(.95, .4, 0, .5)),
                shaft = joined(joined(fillet(.95, .05, -.5, 0), fillet(.95, .45, 0, .5)),
                               joined(fillet(.55, .55, 1.5, 1), fillet(.45, 1.2, 0, .5)));
  const std::string suffix = " with fillets of " + std::to_string(facets) + " facets";
  return {{"disc" + suffix, turned(disc, 64, false)}, {"shaft" + suffix, turned(shaft, 64, false)}};
}

// A ball of cubes, so many on a radius.
Mesh ball_of_voxels(int radius)
{
  using Cell = std::array<int, 3>;
  const auto is_inside = [&](const Cell& c) {
    double sum = 0;
    for (const int x : c) sum += (x + .5) * (x + .5);
    return sum < double(radius) * radius;
  };
  Mesh mesh;
  std::map<Cell, Mesh::Vertex_index> vertices;
  const auto vertex = [&](const Cell& p) {
    const auto [place, is_new] = vertices.emplace(p, Mesh::null_vertex());
    if (is_new) place->second = mesh.add_vertex(Kernel::Point_3(p[0], p[1], p[2]));
    return place->second;
  };
  for (Cell c{-radius, -radius, -radius}; c[0] < radius; ++c[0])
    for (c[1] = -radius; c[1] < radius; ++c[1])
      for (c[2] = -radius; c[2] < radius; ++c[2])
        for (int side = 0; side < 6; ++side) {
          const int axis = side / 2, u = (axis + 1) % 3, v = (axis + 2) % 3;
          Cell beyond = c;
          beyond[axis] += side % 2 == 0 ? -1 : 1;
          if (!is_inside(c) || is_inside(beyond)) continue;
          std::array<Cell, 4> q{c, c, c, c};
          for (Cell& corner : q) corner[axis] += side % 2;
          ++q[side % 2 == 0 ? 3 : 1][u];
          ++q[2][u];
          ++q[2][v];
          ++q[side % 2 == 0 ? 1 : 3][v];
          mesh.add_face(vertex(q[0]), vertex(q[1]), vertex(q[2]));
          mesh.add_face(vertex(q[0]), vertex(q[2]), vertex(q[3]));
        }
  return mesh;
}

// A square, twisted once around in thin layers on its way up.
Mesh twisted_bar(int layers)
{
  Mesh mesh;
  std::vector<Mesh::Vertex_index> v;
  for (int k = 0; k <= layers; ++k)
    for (int i = 0; i < 4; ++i) {
      const double u = 2 * CGAL_PI * k / layers + CGAL_PI / 2 * i;
      v.push_back(mesh.add_vertex(Kernel::Point_3(1.4 * std::cos(u), 1.4 * std::sin(u), 6. * k / layers)));
    }
  for (int k = 0; k < layers; ++k)
    for (int i = 0; i < 4; ++i) {
      const std::size_t a = std::size_t(4 * k + i), b = std::size_t(4 * k + (i + 1) % 4);
      mesh.add_face(v[a], v[b], v[b + 4]);
      mesh.add_face(v[a], v[b + 4], v[a + 4]);
    }
  const std::size_t top = std::size_t(4 * layers);
  for (const std::size_t i : {1, 2}) {
    mesh.add_face(v[0], v[i + 1], v[i]);
    mesh.add_face(v[top], v[top + i], v[top + i + 1]);
  }
  return mesh;
}

std::vector<Part> parts_with_reliefs()
{
  Profile shaft = {{2, 0}, {2, 1}, {1, 1}}, layers = {{POLE, -1}};
  for (int k = 0; k < 40; ++k) shaft = joined(shaft, {{.94, 1.05 + .1 * k}, {1, 1.1 + .1 * k}});
  for (int k = 0; k < 60; ++k) {
    const double low = -1 + k / 30., high = low + 1 / 30., r = std::sqrt(1 - (low + high) * (low + high) / 4);
    layers = joined(layers, {{r, low}, {r, high}});
  }
  return {{"shaft with grooves .1 apart, 96", turned(joined(shaft, {{1, 7}}), 96, false)},
          {"ball of layers, 120", turned(joined(layers, {{POLE, 1}}), 120, false)},
          {"twisted bar in layers", twisted_bar(300)}, {"ball of voxels", ball_of_voxels(20)}};
}

void print_figures(const Mesh& input, const Mesh& output)
{
  const auto angles = IAR::inter_angle_statistics(output);
  const auto distance = IAR::surface_distance(input, output);
  std::printf(" %zu | %.0f..%.0f | %.1f | %.2g | %.2g | %zu |", std::size_t(output.number_of_faces()), angles.minimum_angle,
              angles.maximum_angle, angles.average, 100 * distance.relative_hausdorff(), 100 * distance.relative_mean(),
              crossing_pairs(output));
}

void print_head()
{
  std::printf("| part, facets around | faces wanted | | faces | angles | θ_avg | Hd | Md | crossings | times as fast |\n"
              "|---|---|---|---|---|---|---|---|---|---|\n");
}

// For PMP, edges over `angle` degrees are marked.
void compare(const Part& part, std::size_t wanted, std::size_t pairs, unsigned iterations = 10,
             const IAR::Recipe& recipe = IAR::Recipe(), double angle = 40)
{
  const double length = IAR::target_edge_length(faces(part.mesh), part.mesh, wanted);
  Mesh ours, theirs;
  std::vector<double> ratios;
  for (std::size_t i = 0; i < pairs; ++i) {
    const double t = seconds(part.mesh, ours, [&](Mesh& m) {
      IAR::isotropic_remeshing(faces(m), length, m, IAR::recipe(recipe, parameters::number_of_iterations(iterations))); });
    ratios.push_back(seconds(part.mesh, theirs, [&](Mesh& m) {
      const auto is_sharp = m.add_property_map<Mesh::Edge_index, bool>("e:sharp", false).first;
      PMP::detect_sharp_edges(m, angle, is_sharp);
      PMP::isotropic_remeshing(faces(m), length, m, parameters::number_of_iterations(iterations).edge_is_constrained_map(is_sharp));
    }) / t);
  }
  std::printf("| %s | %zu | ours |", part.name.c_str(), wanted);
  print_figures(part.mesh, ours);
  std::printf(" %.1f |\n| | | PMP |", median(ratios));
  print_figures(part.mesh, theirs);
  std::printf(" |\n");
  std::fflush(stdout);
}

} // namespace

int main(int argc, char* argv[])
{
  const std::size_t pairs = argc > 1 ? std::size_t(std::max(1, std::atoi(argv[1]))) : 5;
  print_head();
  for (const Part& part : parts())
    for (const std::size_t wanted : {3000, 12000}) compare(part, wanted, pairs);
  std::printf("\n");
  print_head();
  const Mesh ball = turned(arc(0, 0, 1, -.49, .49, 8), 400, false), cylinder = turned({{1, 0}, {1, 20}}, 16, false);
  compare({"ball, 400, one iteration", ball}, 5000, pairs, 1);
  for (const std::size_t n : {32, 300})
    compare({"tube with round ends, " + std::to_string(n) + ", one iteration", turned(wall_with_round_ends(), n, true)}, 5000, pairs, 1);
  compare({"cylinder, 20 radii long, 16, one iteration", cylinder}, 5000, pairs, 1);
  compare({"cylinder, 20 radii long, 16", cylinder}, 100000, pairs);
  std::printf("\n");
  print_head();
  for (const std::size_t n : {1000, 4000})
    compare({"plate of " + std::to_string(2 * n) + " needles", plate_of_needles(n)}, 1000, pairs);
  std::printf("\n");
  print_head();
  for (const double height : {0., .2})
    for (const std::size_t wanted : {11400, 17800, 285000})
      compare({height > 0 ? "wavy grid, 100 by 100" : "flat grid, 100 by 100", grid(100, height)}, wanted, pairs);
  for (const std::size_t wanted : {7000, 8400, 34000}) compare({"torus, 120 by 40", torus()}, wanted, pairs);
  std::printf("\n");
  print_head();
  for (const double height : {6., 12.})
    for (const std::size_t wanted : {3000, 12000})
      compare({height > 6 ? "terrain, block of height 12" : "terrain, block of height 6", terrain(height)}, wanted, pairs);
  std::printf("\n");
  print_head();
  for (const double c : {.00005, .0005, .005})
    for (const bool is_merged : {true, false}) {
      IAR::Recipe recipe;
      if (!is_merged) recipe.merging_distance = 0;
      char name[64];
      std::snprintf(name, sizeof name, "box with chamfers of %g%s", c, is_merged ? "" : ", not merged");
      compare({name, chamfered_box(c, .4)}, 800, pairs, 10, recipe);
    }
  std::printf("\n");
  print_head();
  for (const int facets : {3, 8})
    for (const std::size_t wanted : {400, 1200})
      for (const Part& part : parts_with_fillets(facets))
        for (const bool are_features : {true, false}) {
          IAR::Recipe recipe;
          if (!are_features) recipe.fillet_width = 0;
          compare({part.name + (are_features ? "" : ", no features"), part.mesh}, wanted, pairs, 10, recipe);
        }
  std::printf("\n");
  print_head();
  for (const std::size_t wanted : {400, 1500, 6000})
    for (const Part& part : parts_with_reliefs())
      for (const bool is_kept : {false, true}) {
        IAR::Recipe recipe;
        if (is_kept) recipe.relief_density = std::numeric_limits<double>::infinity();
        compare({part.name + (is_kept ? ", kept" : ""), part.mesh}, wanted, pairs, 10, recipe, 180);
      }
}
