// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Models with borders and CAD models, as a table in Markdown: this package and PMP at the same target length, in pairs, the
// median of the ratios of the times.
//
//   curves
//
// Of CAD models the edges over 40 degrees are marked for both; once more nothing is marked for this package. Angles are those
// of the faces that the input does not force. `kept` is the part of the length of the marked edges, or of the border, that
// lies within a tenth of the target length of the result's.

#include "meshes.h"
#include "timing.h"

#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>
#include <CGAL/Inter_angle_remeshing/surface_distance.h>
#include <CGAL/Inter_angle_remeshing/triangle_quality.h>

#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace IAR = CGAL::Inter_angle_remeshing;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace parameters = CGAL::parameters;

namespace {

using Edge_map = Mesh::Property_map<Mesh::Edge_index, bool>;
constexpr double FEATURE_ANGLE = 40;

// Marks what is sharp in an input, or, with a smaller angle, what was kept of that in a result.
Edge_map mark(Mesh& mesh, double angle)
{
  Edge_map map = mesh.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first;
  if (angle > 0) PMP::detect_sharp_edges(mesh, angle, map);
  for (const auto e : mesh.edges()) map[e] = map[e] || mesh.is_border(e);
  return map;
}

double kept(const Mesh& input, const Edge_map& marks, Mesh result, double angle, double tolerance)
{
  const Edge_map found = mark(result, angle);
  std::vector<std::pair<Kernel::Point_3, Kernel::Point_3>> segments;
  for (const auto e : result.edges())
    if (found[e]) segments.emplace_back(result.point(result.vertex(e, 0)), result.point(result.vertex(e, 1)));
  double all = 0, near = 0;
  for (const auto e : input.edges()) {
    if (!marks[e]) continue;
    const Kernel::Segment_3 s(input.point(input.vertex(e, 0)), input.point(input.vertex(e, 1)));
    for (double t = 0.1; t < 1; t += 0.2) {
      const auto p = s.source() + t * s.to_vector();
      const double l = std::sqrt(s.squared_length());
      all += l;
      near += l * std::any_of(segments.begin(), segments.end(), [&](const auto& q) {
        return CGAL::squared_distance(p, Kernel::Segment_3(q.first, q.second)) <= tolerance * tolerance; });
    }
  }
  return all > 0 ? 100 * near / all : 100;
}

void print_row(const std::string& name, const char* who, const Mesh& input, const Edge_map& marks, const Mesh& result,
               double length, double feature_angle, double ratio)
{
  Mesh marked = result;
  const Edge_map curves = mark(marked, 0.6 * feature_angle);
  const auto angles = IAR::inter_angle_statistics(marked, parameters::edge_is_constrained_map(curves));
  const auto distance = IAR::surface_distance(input, result);
  std::printf("| %s | %s | %zu | %.0f..%.0f | %.1f | %.0f | %.1f | %.2f | %.4f | %zu | ", name.c_str(), who,
              std::size_t(result.number_of_faces()), angles.minimum_unforced_angle, angles.maximum_unforced_angle,
              angles.unforced_average, angles.percentage_of_regular_vertices(),
              kept(input, marks, result, 0.6 * feature_angle, 0.1 * length), 100 * distance.relative_hausdorff(),
              100 * distance.relative_mean(), crossing_pairs(result));
  if (ratio > 0) std::printf("%.1f |\n", ratio); else std::printf("|\n");
  std::fflush(stdout);
}

void compare(const std::string& name, double factor, bool is_cad)
{
  constexpr int PAIRS = 5;
  Mesh input = read_mesh(CGAL::data_file_path("meshes/" + name + ".off"));
  const double length = factor * mean_edge_length(input), angle = is_cad ? FEATURE_ANGLE : 0;
  const Edge_map marks = mark(input, angle);
  Mesh ours, theirs, unmarked;
  std::vector<double> ratio, ratio_unmarked;
  const auto iterations = parameters::number_of_iterations(10);
  const auto features_of = [](Mesh& m) { return m.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first; };
  for (int i = 0; i < PAIRS; ++i) {
    const double pmp = seconds(input, theirs, [&](Mesh& m) {
      PMP::isotropic_remeshing(faces(m), length, m,
                               parameters::number_of_iterations(10).edge_is_constrained_map(features_of(m)));
    });
    if (is_cad)
      ratio.push_back(pmp / seconds(input, ours, [&](Mesh& m) {
        IAR::isotropic_remeshing(faces(m), length, m,
                                 parameters::number_of_iterations(10).edge_is_constrained_map(features_of(m)));
      }));
    ratio_unmarked.push_back(pmp / seconds(input, unmarked, [&](Mesh& m) {
      IAR::isotropic_remeshing(faces(m), length, m, iterations); }));
  }
  char title[80];
  std::snprintf(title, sizeof title, "%s, %g", name.c_str(), factor);
  print_row(title, "PMP", input, marks, theirs, length, angle, 0);
  if (is_cad) print_row("", "marked", input, marks, ours, length, angle, median(ratio));
  print_row("", is_cad ? "unmarked" : "this package", input, marks, unmarked, length, angle, median(ratio_unmarked));
}

} // namespace

int main()
{
  std::printf("| model, length | | faces | θ | θ_avg | valence 6 %% | kept %% | Hd %% | Md %% | crossing | PMP : ours |\n"
              "|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const auto& [name, factor] : std::vector<std::pair<const char*, double>>{
         {"lion", 1}, {"mannequin-devil", 2}, {"mech-holes-shark", 1}, {"patch-30", .5}, {"three_peaks", 1}, {"holes", 1},
         {"elephant-with-holes", .7}, {"nefertiti", .5}, {"mesh_with_border", 1}, {"horizons", 1},
         {"lion", 4}, {"mech-holes-shark", 4}, {"elephant-with-holes", 4}})       // where jagged borders are not followed exactly
    compare(name, factor, false);
  for (const auto& [name, factor] : std::vector<std::pair<const char*, double>>{
         {"fandisk", 1}, {"joint", .15}, {"anchor", .25}, {"rotor", .5}, {"couplingdown", .7}, {"part", .3}, {"spool", .5}})
    compare(name, factor, true);
}
