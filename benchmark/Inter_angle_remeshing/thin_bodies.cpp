// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Organic models made as flat as leaves, and swept blades with sharp edges: by default, without features, and by PMP, which has the edges
// of 40 degrees and more of the blades marked. Then models with length 0, where nothing is split or collapsed. Per target length, in
// mean edge lengths, sums and means as tables in Markdown. Last, bodies with round rims: by default, without crests, and by PMP, with the
// same edges marked; target lengths in units.
//
//   thin_bodies

#include "Result_row.h"

#include "../../test/Inter_angle_remeshing/meshes.h"

#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>

#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace IAR = CGAL::Inter_angle_remeshing;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace parameters = CGAL::parameters;

namespace {

constexpr double FACTORS[] = {.5, 1, 2};

Mesh model(const std::string& name) { return read_mesh(CGAL::data_file_path("meshes/" + name + ".off")); }

Mesh leaf(const std::string& name, double height)
{
  Mesh mesh = model(name);
  for (const Mesh::Vertex_index v : mesh.vertices()) {
    auto& p = mesh.point(v);
    p = {p.x(), p.y(), height * p.z()};
  }
  return mesh;
}

// Open at its tips and its back; half of the wedge's angle in degrees. The rows of faces along the edge are narrow.
Mesh blade(double half_angle, double sweep)
{
  constexpr std::size_t SECTIONS = 40;
  const std::array<double, 9> chords{0, .003, .009, .05, .2, .4, .6, .8, 1};
  const std::size_t n = chords.size(), rows = 2 * n - 1;
  meshes::Soup soup;
  for (std::size_t i = 0; i <= SECTIONS; ++i)
    for (std::size_t j = 0; j < rows; ++j) {
      const double x = chords[j < n ? n - 1 - j : j - n + 1], y = 4 * double(i) / SECTIONS,
                   z = x * std::tan(half_angle * CGAL_PI / 180);
      soup.points.push_back({x + sweep * y, y, j < n ? z : -z});
    }
  for (std::size_t i = 0; i < SECTIONS; ++i)
    for (std::size_t j = 0; j + 1 < rows; ++j) {
      const std::size_t a = i * rows + j, b = a + rows;
      soup.faces.push_back({a, b, b + 1});
      soup.faces.push_back({a, b + 1, a + 1});
    }
  return meshes::to_mesh<Mesh>(soup);
}

// A lens of radius 1, or a ring from `inner` to 1 if that is positive: round rims of this radius, between which it is thicker by the bulge
// on both sides.
Mesh lens(double inner, double rim, double bulge)
{
  constexpr int STEPS = 30, RIM_STEPS = 16;
  meshes::Profile bottom;
  for (int i = 1; i < STEPS; ++i) {
    const double t = double(i) / STEPS;
    bottom.push_back({inner + t * (1 - inner), -rim - bulge * (inner > 0 ? 4 * t * (1 - t) : 1 - t * t)});
  }
  meshes::Profile top(bottom.rbegin(), bottom.rend());
  for (auto& [r, z] : top) z = -z;
  meshes::Profile profile = meshes::joined(meshes::joined(bottom, meshes::arc(1, 0, rim, -.5, .5, RIM_STEPS)), top);
  if (inner > 0) profile = meshes::joined(profile, meshes::arc(inner, 0, rim, .5, 1.5, RIM_STEPS));
  return meshes::to_mesh<Mesh>(meshes::turned(profile, 240, inner > 0));
}

// Of a symmetric NACA profile of chord 1, which closes in a sharp trailing edge: half of the thickness at x.
double half_thickness(double thickness, double x)
{
  return 5 * thickness * (.2969 * std::sqrt(x) + x * (-.126 + x * (-.3516 + x * (.2843 - .1036 * x))));
}

// Capped at its tips, with chords in cosine steps.
Mesh wing(double thickness)
{
  constexpr std::size_t CHORDS = 100, ROWS = 2 * CHORDS, SECTIONS = 160;
  constexpr double SPAN = 4;
  meshes::Soup soup;
  for (std::size_t i = 0; i <= SECTIONS; ++i)
    for (std::size_t j = 0; j < ROWS; ++j) {     // from the trailing edge over the upper side, and back below
      const double x = .5 + .5 * std::cos(CGAL_PI * double((std::min)(j, ROWS - j)) / CHORDS), z = half_thickness(thickness, x);
      soup.points.push_back({x, SPAN * double(i) / SECTIONS, j < CHORDS ? z : -z});
    }
  for (std::size_t i = 0; i < SECTIONS; ++i)
    for (std::size_t j = 0; j < ROWS; ++j) {
      const std::size_t a = i * ROWS + j, b = i * ROWS + (j + 1) % ROWS;
      soup.faces.push_back({a, a + ROWS, b + ROWS});
      soup.faces.push_back({a, b + ROWS, b});
    }
  const std::size_t last = SECTIONS * ROWS;
  const auto add_to_caps = [&](std::size_t a, std::size_t b, std::size_t c) {
    soup.faces.push_back({a, b, c});
    soup.faces.push_back({last + a, last + c, last + b});
  };
  for (std::size_t j = 0; j < CHORDS; ++j) {
    if (j + 1 < CHORDS) add_to_caps(j, j + 1, ROWS - j - 1);
    if (j > 0) add_to_caps(j, ROWS - j - 1, ROWS - j);
  }
  return meshes::to_mesh<Mesh>(soup);
}

void remesh_by_pmp(Mesh& mesh, double length, bool marks_edges)
{
  const auto is_sharp = mesh.add_property_map<Mesh::Edge_index, bool>("e:sharp", false).first;
  if (marks_edges) PMP::detect_sharp_edges(mesh, 40, is_sharp);
  PMP::isotropic_remeshing(faces(mesh), length, mesh, parameters::number_of_iterations(10).edge_is_constrained_map(is_sharp));
}

void print_table(const std::vector<Mesh>& bodies, bool marks_edges)
{
  Result_row::print_head("length");
  for (const double factor : FACTORS) {
    Result_row ours{"ours"}, smooth{"no features"}, peer{"PMP"};
    for (const Mesh& body : bodies) {
      const double length = factor * mean_edge_length(body);
      ours.add(body, body, length, [&](Mesh& m) { IAR::isotropic_remeshing(length, m); });
      smooth.add(body, body, length, [&](Mesh& m) { IAR::isotropic_remeshing(length, m, parameters::sharpness_angle(180)); });
      peer.add(body, body, length, [&](Mesh& m) { remesh_by_pmp(m, length, marks_edges); });
    }
    for (const Result_row* row : {&ours, &smooth, &peer}) row->print(factor, peer);
  }
}

void print_round_rims(const std::vector<Mesh>& bodies)
{
  IAR::Recipe no_crests;
  no_crests.crest_width = 0;
  Result_row::print_head("length");
  for (const double length : {.08, .16}) {
    Result_row ours{"ours"}, cut_off{"no crests"}, peer{"PMP"};
    for (const Mesh& body : bodies) {
      ours.add(body, body, length, [&](Mesh& m) { IAR::isotropic_remeshing(length, m); });
      cut_off.add(body, body, length, [&](Mesh& m) { IAR::isotropic_remeshing(length, m, IAR::recipe(no_crests)); });
      peer.add(body, body, length, [&](Mesh& m) { remesh_by_pmp(m, length, true); });
    }
    for (const Result_row* row : {&ours, &cut_off, &peer}) row->print(length, peer);
  }
}

void print_without_length(const std::vector<std::string>& names)
{
  Result_row::print_head("length");
  Result_row ours{"ours"}, peer{"PMP"};
  for (const std::string& name : names) {
    const Mesh mesh = model(name);
    ours.add(mesh, mesh, mean_edge_length(mesh), [](Mesh& m) { IAR::isotropic_remeshing(faces(m), 0, m); });
    peer.add(mesh, mesh, mean_edge_length(mesh), [](Mesh& m) { remesh_by_pmp(m, 0, false); });
  }
  for (const Result_row* row : {&ours, &peer}) row->print(0, peer);
}

}

int main()
{
  std::vector<Mesh> leaves, blades;
  for (const double height : {.1, .03})
    for (const char* name : {"elephant", "cow", "homer", "knot1", "triceratops", "bull", "hand", "man"}) leaves.push_back(leaf(name, height));
  for (const double half_angle : {5., 12.})
    for (const double sweep : {0., .1, .3, 1.}) blades.push_back(blade(half_angle, sweep));
  print_table(leaves, false);
  print_table(blades, true);
  print_without_length({"elephant", "bear_bis", "knot1", "lion-head", "camel", "fandisk", "homer", "retinal"});
  print_round_rims({lens(0, .02, 0), lens(0, .02, .1), lens(0, .03, .25), lens(.4, .02, .06), lens(.6, .01, .03), wing(.12), wing(.06)});
}
