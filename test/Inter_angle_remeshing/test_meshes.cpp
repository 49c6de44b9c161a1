// Copyright (c) 2026 The Inter_angle_remeshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What isotropic_remeshing() keeps of CGAL's meshes and of random ones, and how good its triangles are.
//
//   test_meshes            runs the tests
//   test_meshes measure    prints what the bounds in the tables are made from

#include "invariants.h"

#include <CGAL/Inter_angle_remeshing/Projection/Closest_point_projector.h>
#include <CGAL/Inter_angle_remeshing/internal/exchange/whole_surface.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/crossing_faces.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/regular_valence.h>
#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>
#include <CGAL/Inter_angle_remeshing/triangle_quality.h>

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include "check.h"
#include "meshes.h"
#include "models.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace IAR = CGAL::Inter_angle_remeshing;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace parameters = CGAL::parameters;
using namespace invariants;

const Mesh& mesh_of_cgal(const std::string& name)
{
  static std::map<std::string, Mesh> meshes;
  const auto found = meshes.find(name);
  if(found != meshes.end())
    return found->second;
  return meshes[name] = models::of_cgal(name);
}

// How far borders and constrained edges move, in target lengths: what collapses take away from a curve adds up to this.
constexpr double CURVE_TOLERANCE = .05;
// The same of borders of patches that zigzag.
constexpr double SEAM_TOLERANCE = .5;
// And a jagged border, whose edges are shorter than the other.
constexpr double BORDER_TOLERANCE = .3, LONGEST_JAG = .4;
// Of distances from points that were computed, in edge lengths.
constexpr double ROUNDING = 1e-14;

// Whether `output` is a mesh, and can be asked further questions without running in circles.
bool check_same_shape(const Mesh& output, const Mesh& input, const std::string& what)
{
  const bool is_mesh = CGAL::is_valid_polygon_mesh(output) && CGAL::is_triangle_mesh(output);
  CHECK_MESSAGE(is_mesh, what);
  if(!is_mesh)
    return false;
  CHECK_MESSAGE(!has_double_edges(output) || has_double_edges(input), what);
  CHECK_MESSAGE(is_finite(output), what);
  CHECK_MESSAGE(CGAL::is_closed(output) == CGAL::is_closed(input), what);
  const Topology before = topology(input), after = topology(output);
  CHECK_MESSAGE(after == before, what << ": before " << before << "; after " << after);
  return true;
}

// --- real meshes -------------------------------------------------------------------------------------------------

// What is promised beyond the topology. An output that intersects itself where the input does not, and faces turned
// over, are known to be left where the target is longer than a part of the model is thick (cheese), and on folds of the input
// (lion-head: 20 faces look away from the nearest one).
enum Promises : unsigned
{
  NOTHING = 0,
  EMBEDDED = 1, // no self-intersections
  UPRIGHT = 2,  // no face looks away from the nearest face of the input
  BOTH = EMBEDDED | UPRIGHT
};

// Bounds: the band for smooth closed models; for others the worst of nine runs whose lengths differ by up to 3% (`measure` prints
// it), and beyond it 3 degrees for the extreme angles and .2 degrees for the average. Stricter ones of earlier times stay where the length
// that is tested holds them.
struct Expectation
{
  const char* name;
  double factor;         // of the target length, in mean edge lengths
  unsigned promises;
  double minimum_angle, maximum_angle, average_angle;
};

const Expectation EXPECTATIONS[] = {
  // closed and smooth; of genus 0 where nothing else is said
  {"bear_bis",             1,  BOTH,     42,  88,  56.2},
  {"blobby",               2,  BOTH,     42,  88,  56.8},
  {"cactus",               1,  BOTH,     42,  88,  54.9},
  {"cactus",               .5, BOTH,     42,  88,  56.2},
  {"ellipsoid",            1,  BOTH,     42,  88,  55.8},
  {"ellipsoid",            .5, BOTH,     42,  88,  57.6},
  {"knot1",                1,  BOTH,     42,  88,  56.0},  // genus 1
  {"knot2",                2,  BOTH,     42,  88,  55.2},  // two of genus 1
  {"eight",                1,  BOTH,     42,  88,  52.7},  // genus 2
  {"elephant",             1,  EMBEDDED, 39,  88,  55.5},  // genus 3
  {"armadillo",            1,  EMBEDDED, 40,  88,  56.6},
  {"hand",                 1,  EMBEDDED, 31, 104,  55.3},
  {"retinal",              .5, BOTH,     42,  88,  57.5},
  {"bones",                1,  NOTHING,  31, 103,  53.8},  // 26 components that intersect each other, one with two sharp rims
  // closed and smooth, with a sixty-fourth of the faces
  {"homer",                8,  EMBEDDED, 39,  90,  48.8},
  {"bear",                 8,  EMBEDDED, 39,  89,  52.2},
  {"bunny00",              8,  EMBEDDED, 39,  89,  54.9},
  {"armadillo",            8,  NOTHING,  39,  90,  51.3},  // crosses itself at two of the nine lengths
  // CAD
  {"cube-meshed",          1,  BOTH,     31, 103,  54.2},
  {"fandisk",              2,  BOTH,     17, 105,  53.7},
  {"anchor_dense",         1,  BOTH,     22, 105,  54.3},  // genus 4
  {"joint",                1,  BOTH,     30, 105,  48.8},  // genus 2, faces as long as the model
  {"handle",               2,  BOTH,     22, 109, 52.0},  // the ends of its bore as wide as the target is long
  {"anchor",               2,  BOTH,     26, 106, 46.0},  // discs whose rims have short edges
  {"cheese",               1,  EMBEDDED,  0, 172,  50.6},  // genus 133, faces as long as the model
  // with borders
  {"patch-30",             1,  BOTH,     31, 103,  54.2},  // one border
  {"mushroom",             1,  BOTH,     31, 103,  56.4},  // one border
  {"three_peaks",          .5, BOTH,     32, 103,  56.7},  // one border
  {"nefertiti",            1,  BOTH,     30, 103,  54.7},  // one border
  {"lion-head",            1,  EMBEDDED, 31, 103,  56.2},  // one border
  {"holes",                1,  BOTH,     30, 106,  56.1},  // seven borders
  {"horizons",             1,  BOTH,     32, 103,  56.3},  // two components with a border each
  {"blobby_3cc",           1,  BOTH,     30, 104,  55.1},  // three components, four borders
  {"mech-holes-shark",     2,  EMBEDDED, 14, 111,  54.8},  // four borders
  {"elephant-with-holes",  1,  NOTHING,  25, 109,  50.8},  // 106 borders
  {"ALSTOM_TEST4",         1,  NOTHING,  14, 146,  52.3},  // six flat components with a border each
  // with degenerate faces, four of eight
  {"degtri_sliding",       1,  NOTHING,  19, 110,  40.8},
};

std::string name_of(const Expectation& e) { return std::string(e.name) + " at " + std::to_string(e.factor); }

// The run under the sanitizers takes some twenty times as long.
constexpr std::size_t SMALL = 1300;

void real_meshes_keep_their_shape_and_gain_good_angles()
{
  for(const Expectation& e : EXPECTATIONS)
  {
    const Mesh& input = mesh_of_cgal(e.name);
    if(meshes::is_small_run() && (input.number_of_faces() > SMALL || e.factor < 1))
      continue;
    const std::string what = name_of(e);
    const double length = e.factor * mean_edge_length(input);
    Mesh output = input;
    const IAR::Remeshing_report report = IAR::isotropic_remeshing(length, output);
    if(!check_same_shape(output, input, what))
      continue;
    CHECK_MESSAGE(report.output_faces == output.number_of_faces(), what);

    const auto angles = IAR::inter_angle_statistics(output);
    CHECK_MESSAGE(angles.minimum_angle >= e.minimum_angle, what << ": " << angles.minimum_angle);
    CHECK_MESSAGE(angles.maximum_angle <= e.maximum_angle, what << ": " << angles.maximum_angle);
    CHECK_MESSAGE(angles.average >= e.average_angle, what << ": " << angles.average);
    const double moved = distance(border(input), border(output)) / length;
    CHECK_MESSAGE(moved <= CURVE_TOLERANCE, what << ": " << moved);
    if(e.promises & EMBEDDED)
    {
      CHECK_MESSAGE(!does_self_intersect(input), what << ": the table promises too much");
      CHECK_MESSAGE(!does_self_intersect(output), what);
    }
    if(e.promises & UPRIGHT)
    {
      const std::size_t flipped = number_of_flipped_faces(output, input);
      CHECK_MESSAGE(flipped == 0, what << ": " << flipped << " faces are flipped");
    }
  }
}

void measure_real_meshes()
{
  for(const Expectation& e : EXPECTATIONS)
  {
    const Mesh& input = mesh_of_cgal(e.name);
    double minimum = 180, maximum = 0, average = 60, moved = 0;
    unsigned intersecting = 0, turned = 0;
    for(const double nearby : {.97, .98, .99, .995, 1., 1.005, 1.01, 1.02, 1.03})
    {
      const double length = nearby * e.factor * mean_edge_length(input);
      Mesh output = input;
      IAR::isotropic_remeshing(length, output);
      const auto angles = IAR::inter_angle_statistics(output);
      minimum = (std::min)(minimum, angles.minimum_angle);
      maximum = (std::max)(maximum, angles.maximum_angle);
      average = (std::min)(average, angles.average);
      moved = (std::max)(moved, distance(border(input), border(output)) / length);
      intersecting += does_self_intersect(output);
      turned += number_of_flipped_faces(output, input) > 0;
    }
    std::printf("%-20s %4g: angles %6.2f to %6.2f, average %6.2f, border %.4f; self-intersecting %u of 9, "
                "with turned faces %u of 9\n",
                e.name, e.factor, minimum, maximum, average, moved, intersecting, turned);
  }
}

// Edges cut at one of their ends: a new vertex on top of an old one, and two faces without an area for each.
void degenerate_faces_are_survived()
{
  for(const char* name : {"eight", "nefertiti", "elephant"})
  {
    if(meshes::is_small_run() && mesh_of_cgal(name).number_of_faces() > SMALL)
      continue;
    Mesh input = mesh_of_cgal(name);
    const double length = mean_edge_length(input);
    std::vector<Mesh::Halfedge_index> cut;
    for(const auto h : halfedges(input))
      if(h.idx() % 97 == 5)
        cut.push_back(h);
    for(const auto h : cut)
    {
      const Point p = input.point(source(h, input));
      const auto k = CGAL::Euler::split_edge(h, input);
      input.point(target(k, input)) = p;
      for(const auto side : {k, opposite(next(k, input), input)})
        if(!is_border(side, input))
          CGAL::Euler::split_face(side, next(next(side, input), input), input);
    }
    CHECK_MESSAGE(CGAL::is_triangle_mesh(input), name);
    CHECK_MESSAGE(IAR::inter_angle_statistics(input).number_of_degenerate_faces >= cut.size(), name);

    Mesh output = input;
    IAR::isotropic_remeshing(length, output);
    check_same_shape(output, input, name);
    const auto angles = IAR::inter_angle_statistics(output);
    CHECK_MESSAGE(angles.number_of_degenerate_faces == 0,
                  name << ": " << angles.number_of_degenerate_faces);
    CHECK_MESSAGE(angles.average >= 50, name << ": " << angles.average);
  }
}

// Facets many target lengths long between edges that are no features: these are cut within half of that length, as by any remesher, and
// nowhere deeper. When flips and sweeps came before the last of the long edges was split, the cube had pits of six lengths and thousands
// of crossing faces.
void long_facets_are_not_cut_deeply(const Mesh& input, double length, unsigned iterations, bool marks_some, const std::string& what)
{
  Mesh output = input;
  auto is_marked = output.add_property_map<Mesh::Edge_index, bool>("e:marked", false).first;
  if(marks_some)
    for(const Mesh::Edge_index e : output.edges())
      is_marked[e] = output.point(output.vertex(e, 0)).x() == 0 && output.point(output.vertex(e, 1)).x() == 0;
  const auto parameters = CGAL::parameters::number_of_iterations(iterations);
  if(marks_some)
    IAR::isotropic_remeshing(output.faces(), length, output, parameters.edge_is_constrained_map(is_marked));
  else
    IAR::isotropic_remeshing(output.faces(), length, output, parameters.sharpness_angle(180));

  if(!check_same_shape(output, input, what))
    return;
  CHECK_MESSAGE(!does_self_intersect(output), what);
  const double distance = surface_distance(input, output).hausdorff() / length;
  CHECK_MESSAGE(distance < .9, what << ": " << distance);
  const auto angles = IAR::inter_angle_statistics(output);
  CHECK_MESSAGE(angles.minimum_angle >= 28, what << ": " << angles.minimum_angle);
  CHECK_MESSAGE(angles.maximum_angle <= 108, what << ": " << angles.maximum_angle);
}

void edges_that_are_no_features_survive_long_facets()
{
  const std::vector<std::pair<const char*, Mesh>> inputs{
    {"cube", meshes::to_mesh<Mesh>(meshes::cube(1))},
    {"cylinder", meshes::to_mesh<Mesh>(meshes::turned({{1, 0}, {1, 4}}, 24, false))}};
  for(const auto& [name, input] : inputs)
  {
    const CGAL::Bbox_3 box = PMP::bbox(input);
    const double diagonal = std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());
    for(const double part : {30., 60., 120.})
      for(const unsigned iterations : {1u, 3u, 10u})
      {
        if(meshes::is_small_run() && (part > 30 || iterations > 1))
          continue;
        const std::string what = name + (", 1/" + std::to_string(int(part))) + ", iterations " + std::to_string(iterations);
        long_facets_are_not_cut_deeply(input, diagonal / part, iterations, false, what);
        if(std::string(name) == "cube")
          long_facets_are_not_cut_deeply(input, diagonal / part, iterations, true, what + ", one side marked");
      }
  }
}

// --- lengths and face counts -------------------------------------------------------------------------------------

void lengths_far_too_large_and_far_too_small_return()
{
  for(const std::string name : {"ellipsoid", "eight", "blob", "joint", "quint_tris", "triangular_hole"})
  {
    const Mesh& input = mesh_of_cgal(name);
    // Known to leave folds and needles at the smaller length; the count of faces is then high.
    const bool has_needles = name == "joint" || name == "triangular_hole";
    for(const double factor : {100., 1. / 20})
    {
      if(meshes::is_small_run() && factor < 1 && input.number_of_faces() > 20)
        continue;
      const double length = factor * mean_edge_length(input);
      Mesh output = input;
      IAR::isotropic_remeshing(length, output);
      const std::string what = name + " at " + std::to_string(factor);
      check_same_shape(output, input, what);
      const double faces = double(output.number_of_faces());
      if(factor > 1)
        CHECK_MESSAGE(faces <= double(input.number_of_faces()), what << ": " << faces << " faces");
      else if(!has_needles)
      {
        // An equilateral triangle with the target length as edge has the area sqrt(3) / 4 length^2.
        const double equilateral = PMP::area(input) / (std::sqrt(3.) / 4 * length * length);
        CHECK_MESSAGE(faces > .9 * equilateral && faces < 1.25 * equilateral, what << ": " << faces / equilateral);
      }
    }
  }
}

// Closed models that are smooth enough for the wanted numbers of faces.
const char* const ORGANIC[] = {"cactus", "knot1", "blobby", "retinal", "sphere966", "hand", "handle", "elephant",
                               "homer", "bear_bis"};

// The number is met up to single faces where no edge can be collapsed; measured: .8%, cactus and eight with some hundred faces 3%.
constexpr double COUNT_TOLERANCE = .015;

// Measured: within 2.8%.
constexpr double LENGTH_TOLERANCE = .05;

// How many faces there are of those that a length was asked for.
double yield(const Mesh& input, double wanted)
{
  Mesh output = input;
  IAR::isotropic_remeshing(IAR::target_edge_length(faces(input), input, std::size_t(wanted)), output);
  return double(output.number_of_faces()) / wanted;
}

void wanted_numbers_of_faces_are_met()
{
  for(const char* name : ORGANIC)
  {
    const Mesh& input = mesh_of_cgal(name);
    if(meshes::is_small_run() && input.number_of_faces() > SMALL)
      continue;
    for(const double factor : {.5, 1., 2.})
    {
      const double wanted = std::round(factor * double(input.number_of_faces()));
      Mesh output = input;
      IAR::isotropic_remeshing(IAR::Face_count(std::size_t(wanted)), output);
      const double got = double(output.number_of_faces());
      CHECK_MESSAGE(std::abs(got - wanted) <= COUNT_TOLERANCE * wanted, name << ": " << got << " for " << wanted);
      check_same_shape(output, input, name);
    }
    const double lengths_yield = yield(input, double(input.number_of_faces()));
    CHECK_MESSAGE(std::abs(lengths_yield - 1) <= LENGTH_TOLERANCE, name << ": " << lengths_yield);
  }
}

// The fewer faces there are, the more of them the clean-up makes or takes away, and the more a collapse must be allowed.
void coarse_numbers_of_faces_are_met()
{
  constexpr double TOLERANCE = .02;
  constexpr std::size_t LEAST = 100;
  for(const char* name : {"bear_bis", "camel", "cow", "dino", "elephant", "handle", "homer", "knot1", "retinal", "triceratops"})
  {
    const Mesh& input = mesh_of_cgal(name);
    if(meshes::is_small_run() && input.number_of_faces() > SMALL)
      continue;
    for(const double factor : {.05, .1})
    {
      const std::size_t wanted = std::size_t(factor * double(input.number_of_faces()));
      if(wanted < LEAST)
        continue;
      Mesh output = input;
      IAR::isotropic_remeshing(IAR::Face_count(wanted), output);
      const double ratio = double(output.number_of_faces()) / double(wanted);
      CHECK_MESSAGE(std::abs(ratio - 1) <= TOLERANCE, name << ": " << ratio << " of " << wanted);
      check_same_shape(output, input, name);
    }
  }
  // Of spheres of so few faces some are farther from the surface than a collapse goes by itself.
  for(const std::size_t wanted : {20, 40, 98})
  {
    Mesh sphere = meshes::to_mesh<Mesh>(meshes::sphere(2));
    IAR::isotropic_remeshing(IAR::Face_count(wanted), sphere);
    CHECK_MESSAGE(sphere.number_of_faces() == wanted, sphere.number_of_faces() << " of " << wanted);
  }
}

// An angle between two edges of a border that is too small is the input's; one that is too large could be divided.
void only_small_angles_between_borders_are_forced()
{
  using Reason = IAR::Remeshing_report::Reason;
  for(const auto& [height, reason] : {std::pair{.15, Reason::border_or_feature}, std::pair{3., Reason::input_corner}})
  {
    Mesh m = meshes::to_mesh<Mesh>(meshes::Soup{{{0, 0, 0}, {1, 0, 0}, {.5, height, 0}}, {{0, 1, 2}}});
    const auto report = IAR::isotropic_remeshing(faces(m), 2., m, parameters::protect_constraints(true));
    CHECK(m.number_of_faces() == 1 && report.number_of_faces_out_of_band == 1 && report.faces_out_of_band.size() == 1);
    CHECK(report.faces_out_of_band[0].reason == reason && report.band_holds == (reason == Reason::input_corner));
    const double apex = 2 * std::atan(.5 / height) * 180 / CGAL_PI, violation = std::max(apex - 103, 33 - apex);
    CHECK_MESSAGE(std::abs(report.faces_out_of_band[0].violation - violation) < 1e-6, report.faces_out_of_band[0].violation);
  }
}

// Models on which moving vertices leaves angles out of the band, or folds.
const char* const HARD[] = {"armadillo", "dino", "cow", "triceratops", "bull"};

void the_repair_reaches_the_band()
{
  std::size_t left = 0, mended = 0;
  for(const char* name : HARD)
  {
    const Mesh& input = mesh_of_cgal(name);
    IAR::Recipe recipe;
    Mesh output = input;
    const auto with = IAR::isotropic_remeshing(IAR::Face_count(15000), output, IAR::recipe(recipe));
    CHECK_MESSAGE(with.band_holds && with.number_of_faces_out_of_band == 0, name << ": " << with.number_of_faces_out_of_band);
    CHECK_MESSAGE(with.angles_after.minimum >= 42 - 1e-5 && with.angles_after.maximum <= 88 + 1e-5, name);
    check_same_shape(output, input, name);
    recipe.repair = false;
    Mesh other = input;
    const auto without = IAR::isotropic_remeshing(IAR::Face_count(15000), other, IAR::recipe(recipe));
    CHECK_MESSAGE(without.repairs == 0, name);
    left += without.number_of_faces_out_of_band;
    mended += with.repairs;
    if(meshes::is_small_run())
      break;
  }
  CHECK_MESSAGE(meshes::is_small_run() || (left > 0 && mended > 0), left << " and " << mended);
}

// Tips and crevices: nearer than without, at angles as good, and nothing crosses that did not before.
void large_distances_are_lowered()
{
  double product = 1;
  int models = 0;
  for(const char* name : {"armadillo", "dino", "homer", "elephant", "bunny00"})
  {
    const Mesh& input = mesh_of_cgal(name);
    if(meshes::is_small_run() && input.number_of_faces() > SMALL)
      continue;
    const IAR::Closest_point_projector<Mesh> facets(input);
    const auto remeshed = [&](double tolerance, Mesh& output)
    {
      IAR::Recipe recipe;
      recipe.distance_tolerance = tolerance;
      return IAR::isotropic_remeshing(IAR::Face_count(15000), output,
                                      IAR::recipe(recipe, parameters::projection_functor(std::cref(facets))));
    };
    const auto hausdorff = [&](const Mesh& output)
    {
      return invariants::surface_distance(input, output, 100000).hausdorff();
    };
    Mesh without = input, with = input;
    const auto before = remeshed(0, without), after = remeshed(IAR::Recipe().distance_tolerance, with);
    CHECK_MESSAGE(after.number_of_faces_out_of_band <= before.number_of_faces_out_of_band, name);
    const double ratio = hausdorff(with) / hausdorff(without);
    CHECK_MESSAGE(ratio <= 1.05, name << ": " << ratio);      // samples are dense, not everywhere
    CHECK_MESSAGE(does_self_intersect(input) || does_self_intersect(without) || !does_self_intersect(with), name);
    product *= ratio;
    ++models;
  }
  CHECK_MESSAGE(models == 0 || std::pow(product, 1. / models) < .85, std::pow(product, 1. / models));
}

std::size_t number_of_crossing_faces(const Mesh& m)
{
  std::set<Face> result;
  for(const auto& [f, g] : self_intersections(m))
    result.insert({f, g});
  return result.size();
}

// Chords of thin walls lead through the other side: they are parted. Where the input crosses itself, so does a result that is as fine,
// and the report says how many faces do.
void crossing_faces_are_parted()
{
  IAR::Recipe without_repair;
  without_repair.repair = false;
  std::size_t crossing = 0;
  for(const auto& [name, factor] : {std::pair<const char*, double>{"cheese", 3}, {"homer", 2}, {"dino", 1}, {"turbine", 2}})
  {
    const Mesh& input = mesh_of_cgal(name);
    if(meshes::is_small_run() && input.number_of_faces() > SMALL)
      continue;
    const double length = factor * mean_edge_length(input);
    Mesh with = input, without = input;
    const auto report = IAR::isotropic_remeshing(length, with);
    CHECK_MESSAGE(report.are_crossing_faces_known && report.crossing_faces == 0 && !does_self_intersect(with),
                  name << ": " << report.crossing_faces);
    IAR::isotropic_remeshing(length, without, IAR::recipe(without_repair));
    crossing += number_of_crossing_faces(without);
  }
  CHECK(meshes::is_small_run() || crossing > 0);
  for(const auto& [name, factor] : {std::pair<const char*, double>{"camel", 1}, {"cow", 1}, {"mannequin-devil", 1}, {"helmet", 1},
                                    {"helmet", 2}, {"helmet", 3}})
  {
    Mesh m = mesh_of_cgal(name);
    if(meshes::is_small_run() && m.number_of_faces() > SMALL)
      continue;
    const bool crosses_itself = does_self_intersect(m);
    const auto report = IAR::isotropic_remeshing(factor * mean_edge_length(m), m);
    const std::size_t counted = number_of_crossing_faces(m);
    CHECK_MESSAGE(report.crossing_faces == counted, name << " at " << factor << ": " << report.crossing_faces << " of " << counted);
    CHECK_MESSAGE(!crosses_itself || counted > 0, name);
  }
  // Faces of a range that meet at a vertex alone, with others between them that are none of the range, only touch.
  for(const double factor : {.5, 1., 2.})
  {
    Mesh m = mesh_of_cgal("sphere966");
    std::vector<Face> range;
    for(const Face f : m.faces())
      if(f.idx() * 7919u % 10 != 0)
        range.push_back(f);
    const auto report = IAR::isotropic_remeshing(range, factor * mean_edge_length(m), m);
    CHECK_MESSAGE(report.are_crossing_faces_known && report.crossing_faces == 0 && !does_self_intersect(m),
                  factor << ": " << report.crossing_faces);
  }
  // Where the target is so much finer than the surface that nothing is wrong, they are not looked for.
  for(const bool repairs : {true, false})
  {
    Mesh m = mesh_of_cgal("sphere966");
    IAR::Recipe recipe;
    recipe.repair = repairs;
    const auto report = IAR::isotropic_remeshing((repairs ? .25 : 1) * mean_edge_length(m), m, IAR::recipe(recipe));
    CHECK(!report.are_crossing_faces_known && report.crossing_faces == 0 && (report.band_holds || !repairs));
  }
}

// A ring that is much thinner than the target is long: no angle is good, and the repair does not fill the hole to better them. When this
// was written the largest and the mean distances were .8 and .23 target lengths on the average; 1.2 and .36 with a repair that may.
void thin_rings_stay_rings()
{
  const Mesh input = meshes::to_mesh<Mesh>(meshes::torus(200, 24, .05));
  double largest = 0, mean = 0;
  for(const double length : {.6, .65, .7, .8})
  {
    Mesh m = input;
    IAR::isotropic_remeshing(length, m);
    check_same_shape(m, input, "ring");
    const auto distance = invariants::surface_distance(input, m);
    largest += distance.hausdorff() / length / 4;
    mean += distance.mean() / length / 4;
  }
  CHECK_MESSAGE(largest < .95, largest);
  CHECK_MESSAGE(mean < .28, mean);
}

// Rings whose tubes are up to ten times thinner than the target is long: around them edges must be short, and so must then be those along
// them. When this was written none of 23 rings like these crossed itself; of those without grading 6, with angles of 1 degree.
void limbs_thinner_than_the_target_have_good_angles()
{
  const Mesh input = meshes::to_mesh<Mesh>(meshes::torus(200, 24, .06));
  IAR::Recipe recipe;
  recipe.grading = 0;
  int crossing = 0;
  for(const double length : {.4, .45, .5, .55, .6})
  {
    Mesh graded = input, uniform = input;
    IAR::isotropic_remeshing(length, graded);
    IAR::isotropic_remeshing(faces(uniform), length, uniform, IAR::recipe(recipe));
    check_same_shape(graded, input, "ring");
    crossing += invariants::does_self_intersect(graded);
    const auto with = IAR::inter_angle_statistics(graded), without = IAR::inter_angle_statistics(uniform);
    CHECK_MESSAGE(with.minimum_angle > without.minimum_angle + 10 && with.average > without.average + 3,
                  length << ": " << with.minimum_angle << ", " << with.average << "; " << without.minimum_angle << ", " << without.average);
    CHECK_MESSAGE(graded.number_of_faces() < 400, length << ": " << graded.number_of_faces());
  }
  CHECK_MESSAGE(crossing <= 1, crossing);
}

// Flat discs not wider than the target is long, whose borders of short edges stay: an inner vertex or a few, joined to all of the border.
void discs_with_short_border_edges_have_good_angles()
{
  for(int n = 6; n <= 16; ++n)
    for(const double radius : {.4, .52, .7})
    {
      Mesh m;
      std::vector<Mesh::Vertex_index> corners;
      for(int i = 0; i < n; ++i)
        corners.push_back(m.add_vertex(Point(radius * std::cos(2 * CGAL_PI * i / n), radius * std::sin(2 * CGAL_PI * i / n), 0)));
      for(int i = 1; i + 1 < n; ++i)
        m.add_face(corners[0], corners[i], corners[i + 1]);
      const Mesh input = m;
      IAR::isotropic_remeshing(m.faces(), 1., m, CGAL::parameters::collapse_constraints(false));

      const std::string what = std::to_string(n) + " edges, radius " + std::to_string(radius);
      if(!check_same_shape(m, input, what))
        continue;
      CHECK_MESSAGE(int(border(m).size()) == n, what);
      const auto angles = IAR::inter_angle_statistics(m);
      CHECK_MESSAGE(angles.minimum_angle >= 30, what << ": " << angles.minimum_angle);
      CHECK_MESSAGE(angles.maximum_angle <= 104, what << ": " << angles.maximum_angle);
    }
}

// Where the input crosses itself in what is small beside the target length, the result need not, and hardly withdraws for that. With
// and without the repair 16 and 176 faces crossed others when this was written, 102 with one that let such faces be.
void small_crossings_of_the_input_are_parted()
{
  IAR::Recipe without_repair;
  without_repair.repair = false;
  std::size_t crossing = 0, crossing_without = 0;
  for(const auto& [name, factor] : {std::pair<const char*, double>{"bones", 4}, {"bones", 4.4}, {"camel", 2}, {"mannequin-devil", 4}})
  {
    const Mesh& input = mesh_of_cgal(name);
    if(meshes::is_small_run() && input.number_of_faces() > SMALL)
      continue;
    CHECK_MESSAGE(does_self_intersect(input), name);
    const double length = factor * mean_edge_length(input);
    Mesh with = input, without = input;
    const auto report = IAR::isotropic_remeshing(length, with);
    IAR::isotropic_remeshing(length, without, IAR::recipe(without_repair));
    CHECK_MESSAGE(report.are_crossing_faces_known && report.crossing_faces == number_of_crossing_faces(with), name);
    CHECK_MESSAGE(invariants::surface_distance(with, input).mean() < 1.2 * invariants::surface_distance(without, input).mean(), name);
    crossing += report.crossing_faces;
    crossing_without += number_of_crossing_faces(without);
  }
  CHECK_MESSAGE(5 * crossing < 2 * crossing_without || meshes::is_small_run(), crossing << " of " << crossing_without);
}

// Twelve triangles.
meshes::Soup cuboid(double x, double y, double z)
{
  meshes::Soup soup = meshes::cube(1);
  for(auto& p : soup.points)
    p = {x * p[0], y * p[1], z * p[2]};
  return soup;
}

// Two boxes that lie against each other, or run through each other, and beside them what has much shorter edges: the boxes' triangles cross
// others all over, not at their corners alone, and no angle is given up for what cannot be parted.
void parts_that_touch_keep_their_angles()
{
  const meshes::Soup box = cuboid(2, 2, 1), ball = meshes::sphere(3).scaled(.5).moved(7, 1, .5);
  for(const meshes::Soup& other : {cuboid(2, 1, 1.5).moved(0, 2, 0), cuboid(.9, 1.3, 1.5).moved(.7, 1.2, .3)})
    for(const double length : {.15, .2, .3, .4})
    {
      const Mesh input = meshes::to_mesh<Mesh>(box.joined_with(other).joined_with(ball));
      Mesh m = input;
      const auto report = IAR::isotropic_remeshing(length, m);
      CHECK_MESSAGE(report.angles_after.minimum > 31 && report.angles_after.maximum < 103,
                    length << ": " << report.angles_after.minimum << ", " << report.angles_after.maximum);
      CHECK_MESSAGE(report.crossing_faces == number_of_crossing_faces(m), length << ": " << report.crossing_faces);
      CHECK_MESSAGE(std::abs(PMP::volume(m) / PMP::volume(input) - 1) < .01, length << ": " << PMP::volume(m) / PMP::volume(input));
    }
}

// Hundreds of boxes, side by side: each side lies on another one, and at a coarse target each face has thousands near it. Nothing can
// be done about that; each stays a closed box with its corners, and the search for something to do ends.
void boxes_that_touch_each_other_stay_boxes()
{
  const int n = meshes::is_small_run() ? 3 : 8;
  const meshes::Soup box = meshes::cube(1);
  meshes::Soup boxes;
  for(int i = 0; i < n * n * n; ++i)
    boxes = boxes.joined_with(box.moved(i % n, i / n % n, i / (n * n)));
  for(const double length : {0.5, 5.})
  {
    Mesh m = meshes::to_mesh<Mesh>(boxes);
    const auto report = IAR::isotropic_remeshing(length, m);
    CHECK(report.are_crossing_faces_known && m.is_valid() && CGAL::is_closed(m));
    auto component = m.add_property_map<Face, std::size_t>("f:component").first;
    CHECK(PMP::connected_components(m, component) == std::size_t(n * n * n));
    std::multiset<Point> points;
    for(const Vertex v : m.vertices())
      points.insert(m.point(v));
    for(const auto& p : boxes.points)
    {
      const auto found = points.find(Point(p[0], p[1], p[2]));
      CHECK_MESSAGE(found != points.end(), p[0] << ' ' << p[1] << ' ' << p[2] << " at " << length);
      if(found != points.end())
        points.erase(found);
    }
  }
}

// A grid whose edges are neither too long nor too short, and all of whose vertices are regular, is no better for that: its angles
// are 45 and 90 degrees. Nor is one that is too dense, and whose edges are too long to be merged.
void regular_grids_are_stirred_up()
{
  const std::size_t n = meshes::is_small_run() ? 20 : 60;
  meshes::Soup grid;
  for(std::size_t j = 0; j <= n; ++j)
    for(std::size_t i = 0; i <= n; ++i)
      grid.points.push_back({double(i), double(j), 0});
  for(std::size_t j = 0; j < n; ++j)
    for(std::size_t i = 0; i < n; ++i)
    {
      const std::size_t a = j * (n + 1) + i, b = a + n + 1;
      grid.faces.push_back({a, a + 1, b + 1});
      grid.faces.push_back({a, b + 1, b});
    }
  for(const double length : {1.14, 1.42})
  {
    Mesh m = meshes::to_mesh<Mesh>(grid);
    IAR::isotropic_remeshing(length, m);
    const double average = IAR::inter_angle_statistics(m).average, wanted = 4 / std::sqrt(3.) * double(n * n) / (length * length);
    CHECK_MESSAGE(average > 54, length << ": " << average);
    CHECK_MESSAGE(double(m.number_of_faces()) < 1.4 * wanted, length << ": " << m.number_of_faces() << " of " << wanted);
  }
}

// A grid whose quadrangles are long on one side and short on the other: its edges are collapsed, although that makes some that are too long.
void grids_are_broken_up()
{
  const std::size_t n = meshes::is_small_run() ? 20 : 40;
  meshes::Soup saddle = meshes::square(2 * n);
  for(auto& p : saddle.points)
    p = {3 * p[0], 2 * p[1], .4 * (2 * p[0] - 1) * (2 * p[0] - 1) - .4 * (2 * p[1] - 1) * (2 * p[1] - 1)};
  for(const auto& [name, soup] : {std::pair<const char*, meshes::Soup>("torus", meshes::torus(3 * n, n, 1 / 3.)), {"saddle", saddle}})
  {
    const Mesh grid = meshes::to_mesh<Mesh>(soup);
    for(const double factor : {.55, .9, 1., 1.1})
    {
      Mesh m = grid;
      const auto report = IAR::isotropic_remeshing(factor * mean_edge_length(grid), m);
      const auto statistics = IAR::inter_angle_statistics(m);
      CHECK_MESSAGE(statistics.average > 55, name << ", " << factor << ": " << statistics.average);
      CHECK_MESSAGE(report.band_holds, name << ", " << factor << ": " << statistics.minimum_angle << " to " << statistics.maximum_angle);
      CHECK_MESSAGE(double(m.number_of_faces()) < 1.1 * double(grid.number_of_faces()) / (factor * factor),
                    name << ", " << factor << ": " << m.number_of_faces());
    }
  }
}

// The apexes of a double cone of a few long facets, from which steps of the first iterations would slip off by many target lengths.
void apexes_of_coarse_cones_stay()
{
  constexpr std::size_t N = 40;
  for(const double degrees : {18., 30., 45.})
  {
    const double radius = std::tan(degrees * (CGAL_PI / 180));
    meshes::Soup cones{{{0, 0, 1}, {0, 0, -1}}, {}};
    for(std::size_t i = 0; i < N; ++i)
    {
      const double u = 2 * CGAL_PI * double(i) / N;
      cones.points.push_back({radius * std::cos(u), radius * std::sin(u), 0});
      cones.faces.push_back({0, 2 + i, 2 + (i + 1) % N});
      cones.faces.push_back({1, 2 + (i + 1) % N, 2 + i});
    }
    const Mesh input = meshes::to_mesh<Mesh>(cones);
    const IAR::Closest_point_projector<Mesh> facets(input);
    for(const bool on_facets : {false, true})
    {
      Mesh m = input;
      const double length = IAR::target_edge_length(faces(m), m, 30000);
      if(on_facets)
        IAR::isotropic_remeshing(length, m, parameters::projection_functor(std::cref(facets)));
      else
        IAR::isotropic_remeshing(length, m);
      m.collect_garbage();
      for(const double z : {1., -1.})
      {
        double nearest = 2;
        for(const Vertex v : m.vertices())
          nearest = std::min(nearest, std::sqrt(CGAL::squared_distance(m.point(v), Point(0, 0, z))));
        CHECK_MESSAGE(nearest < 1.2 * length, degrees << ", " << z << ": " << nearest / length);
      }
    }
    if(meshes::is_small_run())
      break;
  }
}

// The camel's tail ends in a tip thinner than the target length, of which more is left at some lengths than at others: the median
// of four says what becomes of it.
void tips_are_not_worn_off_by_what_mends_angles()
{
  if(meshes::is_small_run())
    return;
  const Mesh& input = mesh_of_cgal("camel");
  const double length = IAR::target_edge_length(faces(input), input, 5000);
  std::vector<double> lost;
  for(const double nearby : {.94, .98, 1., 1.02})
  {
    Mesh output = input;
    IAR::isotropic_remeshing(nearby * length, output);
    check_same_shape(output, input, "camel");
    lost.push_back(invariants::surface_distance(input, output).hausdorff_1_to_2 / (nearby * length));
  }
  std::sort(lost.begin(), lost.end());
  CHECK_MESSAGE(lost[1] + lost[2] < 2 * .9, lost[1] << " and " << lost[2]);     // 1.1 where nothing keeps them
}

// Needles take many splits and collapses; a shaft of a few long facets, many splits. Neither takes more iterations, nor does what is
// long cut through the surface before it is short.
void a_few_iterations_are_enough_for_needles_and_long_facets()
{
  const meshes::Soup ball = meshes::turned(meshes::arc(0, 0, 1, -.49, .49, 8), 400, false),
                     tube = meshes::turned(meshes::wall_with_round_ends(), 48, true),
                     shaft = meshes::turned({{1, 0}, {1, 20}}, 16, false);
  struct Case
  {
    const char* name;
    const meshes::Soup& soup;
    double faces;
    unsigned iterations;
  };
  for(const Case& c : {Case{"ball", ball, 5000, 1}, {"ball", ball, 5000, 2}, {"tube", tube, 5000, 1}, {"tube", tube, 5000, 3},
                       {"shaft", shaft, 100000, 10}, {"shaft", shaft, 5000, 1}})
  {
    if(meshes::is_small_run() && (c.iterations > 1 || c.soup.faces.size() > SMALL))
      continue;
    Mesh m = meshes::to_mesh<Mesh>(c.soup);
    const Mesh input = m;
    const double length = std::sqrt(4 / std::sqrt(3.) * PMP::area(m) / c.faces);
    IAR::isotropic_remeshing(faces(m), length, m, CGAL::parameters::number_of_iterations(c.iterations));
    const auto angles = IAR::inter_angle_statistics(m);
    const std::string what = std::string(c.name) + ", " + std::to_string(c.iterations) + " iterations: ";
    CHECK_MESSAGE(angles.minimum_angle > 25 && angles.maximum_angle < 115, what << angles.minimum_angle << ".." << angles.maximum_angle);
    CHECK_MESSAGE(double(angles.number_of_faces) < 1.3 * c.faces, what << angles.number_of_faces);
    CHECK_MESSAGE(!does_self_intersect(m), what);
    const double distance = invariants::surface_distance(input, m).hausdorff();
    CHECK_MESSAGE(distance < length, what << distance / length);
  }
}

// Islands of one voxel, as isosurfaces have them, are far smaller than the target length, and become tetrahedra, but no flat ones.
void islands_keep_a_volume()
{
  meshes::Soup soup = meshes::sphere(3);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> radius(.005, .05);
  for(const auto& centre : meshes::sphere(1).points)
  {
    const std::size_t first = soup.points.size();
    const std::array<double, 3> r = {radius(random), radius(random), radius(random)};
    for(const auto& p : meshes::octahedron().points)
      soup.points.push_back({1.3 * centre[0] + r[0] * p[0], 1.3 * centre[1] + r[1] * p[1], 1.3 * centre[2] + r[2] * p[2]});
    for(const auto& f : meshes::octahedron().faces)
      soup.faces.push_back({first + f[0], first + f[1], first + f[2]});
  }
  const Mesh input = meshes::to_mesh<Mesh>(soup);
  for(const double length : {.1, .15, .2, .3})
  {
    Mesh m = input;
    IAR::isotropic_remeshing(length, m);
    CHECK_MESSAGE(topology(m) == topology(input) && !does_self_intersect(m), length);
    std::vector<Mesh> parts;
    PMP::split_connected_components(m, parts);
    for(const Mesh& part : parts)
      CHECK_MESSAGE(PMP::volume(part) > 1e-8, length << ": " << PMP::volume(part));
  }
}

// A body with a pole of vertices that are far denser than the noise on them is fine, as a turntable scanner sees one: crumpled, it takes more
// collapses than ten iterations make.
void heaps_of_vertices_are_cleared_away()
{
  constexpr int n = 200;
  constexpr double pi = 3.14159265358979323846;
  meshes::Soup soup;
  soup.points.push_back({0, 0, 1});
  for(int j = 1; j < n; ++j)
    for(int i = 0; i < n; ++i)
    {
      const double t = pi * std::pow(double(j) / n, 3), u = 2 * pi * i / n, r = 1 + .1 * std::sin(5 * u) * std::sin(t);
      soup.points.push_back({r * std::sin(t) * std::cos(u), r * std::sin(t) * std::sin(u), std::cos(t)});
    }
  soup.points.push_back({0, 0, -1});
  const auto vertex = [&](int j, int i) { return j == 0 ? 0 : j == n ? soup.points.size() - 1 : std::size_t(1 + (j - 1) * n + i % n); };
  for(int j = 0; j < n; ++j)
    for(int i = 0; i < n; ++i)
    {
      if(j > 0)
        soup.faces.push_back({vertex(j, i), vertex(j + 1, i), vertex(j, i + 1)});
      if(j < n - 1)
        soup.faces.push_back({vertex(j, i + 1), vertex(j + 1, i), vertex(j + 1, i + 1)});
    }
  std::mt19937 random(11);
  std::normal_distribution<double> noise(0, .0003);
  for(auto& p : soup.points)
    for(double& coordinate : p)
      coordinate += noise(random);
  const Mesh input = meshes::to_mesh<Mesh>(soup);
  for(const double length : {.04, .06, .08, .12, .16, .2})
  {
    Mesh m = input;
    const IAR::Remeshing_report report = IAR::isotropic_remeshing(length, m);
    CHECK_MESSAGE(report.angles_after.minimum > 33 && report.angles_after.maximum < 105, length << ": " << report.angles_after.minimum
                  << " to " << report.angles_after.maximum);
  }
}

// The walls' long edges are short before anything is flipped or moved, whatever that takes: vertices would slide down them from the
// narrow facets of the ends.
void thin_walls_keep_their_round_ends()
{
  for(const auto& [facets, faces_wanted] : {std::pair<std::size_t, std::size_t>{64, 6000}, {64, 12000}, {32, 11000}, {128, 14000}})
  {
    Mesh m = meshes::to_mesh<Mesh>(meshes::turned(meshes::wall_with_round_ends(), facets, true));
    const Mesh input = m;
    const double length = IAR::target_edge_length(faces(m), m, faces_wanted);
    IAR::isotropic_remeshing(length, m);
    const auto angles = IAR::inter_angle_statistics(m);
    const double distance = invariants::surface_distance(input, m).hausdorff();
    const std::string what = std::to_string(facets) + " facets, " + std::to_string(faces_wanted) + " faces: ";
    CHECK_MESSAGE(!does_self_intersect(m), what);
    CHECK_MESSAGE(angles.minimum_angle > 40 && angles.maximum_angle < 95, what << angles.minimum_angle << ".." << angles.maximum_angle);
    CHECK_MESSAGE(distance < .6 * length, what << distance / length);
    if(meshes::is_small_run())
      break;
  }
}

// A block on uneven ground, triangulated at random from scattered points: its wall, one face high, goes in and out by less than an
// edge. The way over the surface from a neighbor's place to that of a new vertex leads around such folds.
meshes::Soup terrain_with_block(std::size_t n, std::uint32_t seed)
{
  std::mt19937 random(seed);
  const auto up_to = [&](double bound) { return (random() / 4294967296. * 2 - 1) * bound / double(n); };
  const auto is_inside = [](double x) { return x > 0 && x < 1; };
  const auto is_on_block = [](double x) { return x > .3 && x < .7; };
  meshes::Soup soup = meshes::square(n);
  for(auto& [x, y, z] : soup.points)
  {
    x += is_inside(x) ? up_to(.34) : 0;
    y += is_inside(y) ? up_to(.34) : 0;
    z = is_on_block(x) && is_on_block(y) ? .3 : up_to(.1);
  }
  for(std::size_t i = 0; i < soup.faces.size(); i += 2)
    if(random() % 2 == 0)    // the other diagonal
    {
      soup.faces[i][2] = soup.faces[i + 1][2];
      soup.faces[i + 1][0] = soup.faces[i][1];
    }
  return soup;
}

// Of some 100,000 faces, 125 were out of their bands and 11 crossed others when this was written; where a new vertex was looked for
// from its neighbors' places alone, 643 and 142.
void folded_walls_of_terrains_are_not_missed()
{
  std::size_t out_of_band = 0, crossing = 0;
  for(std::uint32_t seed = 1; seed <= (meshes::is_small_run() ? 1 : 10); ++seed)
  {
    Mesh m = meshes::to_mesh<Mesh>(terrain_with_block(40, seed));
    const IAR::Remeshing_report report = IAR::isotropic_remeshing(.5 * mean_edge_length(m), m);
    out_of_band += report.number_of_faces_out_of_band;
    crossing += report.crossing_faces;
  }
  CHECK_MESSAGE(out_of_band < 300, out_of_band);
  CHECK_MESSAGE(crossing < 30, crossing);
}

// All pairs of crossing faces are found, where these are of one size, where a few are a thousand times as large, and where all lie in
// one plane, beside each other, touching, or overlapping.
void all_crossing_faces_are_found()
{
  const meshes::Soup ball = meshes::sphere(4), two = ball.joined_with(ball.moved(.713, .387, .291));
  const meshes::Soup sheets{{{-1000, -1000, .1}, {1000, -1000, .2}, {0, 1000, .3}, {-1000, 3, -1000}, {1000, 2, -1000}, {0, -1, 1000}},
                            {{0, 1, 2}, {3, 4, 5}}};
  const meshes::Soup flat = meshes::square(8), touching = flat.joined_with(flat.moved(1, .25, 0)),
                     overlapping = flat.joined_with(flat.moved(.3125, .40625, 0));
  for(const meshes::Soup& soup : {two, two.joined_with(sheets), touching, overlapping})
  {
    const Mesh m = meshes::to_mesh<Mesh>(soup);
    const auto expected = self_intersections(m);
    const auto copy = IAR::internal::copy_whole_surface(m, get(CGAL::vertex_point, m), "test");
    const auto found = IAR::internal::crossing_faces<CGAL::Sequential_tag>(copy.mesh);
    CHECK_MESSAGE(!found.empty() && found.size() == expected.size(), found.size() << " of " << expected.size());
  }
}

// A vertex amid a ring of n others, `tip` above it, which rises and falls by `saddle` twice.
meshes::Soup star(std::size_t n, double tip, double saddle)
{
  meshes::Soup result{{{0, 0, tip}}, {}};
  for(std::size_t k = 0; k < n; ++k)
  {
    const double angle = 2 * CGAL_PI * double(k) / double(n);
    result.points.push_back({std::cos(angle), std::sin(angle), saddle * std::cos(2 * angle)});
    result.faces.push_back({0, 1 + k, 1 + (k + 1) % n});
  }
  return result;
}

// Where its angles ask for them, a vertex is regular with the number of faces that it has, but never with more on a tip, or less on
// a saddle.
void vertices_of_tips_and_saddles_are_regular()
{
  struct Case
  {
    std::size_t faces;
    double tip, saddle;
    int regular;
  };
  for(const Case& c : {Case{5, 0, 0, 6}, {5, .2, 0, 6}, {5, .6, 0, 5}, {5, 0, .8, 6}, {4, .6, 0, 5}, {4, 1, 0, 4}, {3, 1, 0, 4}, {3, 2, 0, 3},
                       {6, 1, 0, 6}, {6, 0, .8, 6}, {7, 0, 0, 6}, {7, 0, .3, 6}, {7, 0, .6, 7}, {7, 1, 0, 6}, {8, 0, .6, 7}, {8, 0, .9, 8}})
  {
    const Mesh m = meshes::to_mesh<Mesh>(star(c.faces, c.tip, c.saddle));
    auto copy = IAR::internal::copy_whole_surface(m, get(CGAL::vertex_point, m), "test");
    IAR::internal::measure_inner_vertices<CGAL::Sequential_tag>(copy.mesh);
    for(IAR::internal::Remeshing_mesh::Index v = 0; v < IAR::internal::Remeshing_mesh::Index(c.faces + 1); ++v)
      if(!copy.mesh.is_border_vertex(v))
        CHECK_MESSAGE(copy.mesh.deviation(v) == int(c.faces) - c.regular,
                      c.faces << " faces, tip " << c.tip << ", saddle " << c.saddle << ": " << copy.mesh.deviation(v));
      else
        CHECK(copy.mesh.deviation(v) == 3 - 4);
  }
}

// Single coarse runs scatter, by .6 degrees, those of some dozens of faces by 2; the sums over many lengths do not. (Measured: .41 degrees,
// 525 faces out of their bands instead of 698.)
void coarse_organic_models_gain_by_irregular_vertices()
{
  if(meshes::is_small_run())
    return;
  IAR::Recipe six;
  six.curvature_valences = false;
  double gained = 0;
  std::size_t out_of_band = 0, out_with_six = 0, runs = 0;
  for(const char* name : {"triceratops", "elk", "cow", "pig"})
    for(int twentieths = 40; twentieths < 83; ++twentieths)
    {
      Mesh m = mesh_of_cgal(name), with_six = m;
      const double length = twentieths / 20. * mean_edge_length(m);
      const IAR::Remeshing_report ours = IAR::isotropic_remeshing(length, m),
                                  theirs = IAR::isotropic_remeshing(faces(with_six), length, with_six, IAR::recipe(six));
      gained += ours.angles_after.average - theirs.angles_after.average;
      out_of_band += ours.number_of_faces_out_of_band;
      out_with_six += theirs.number_of_faces_out_of_band;
      ++runs;
    }
  CHECK_MESSAGE(gained > .2 * double(runs), gained / double(runs));
  CHECK_MESSAGE(out_of_band < out_with_six, out_of_band << " and " << out_with_six);
}

// Where nothing is split or collapsed, what flips and moves can mend is mended all the same, measured against the edges that there are.
void without_a_length_angles_are_mended()
{
  for(const char* name : {"knot1", "elephant", "bear_bis"})
  {
    if(meshes::is_small_run() && name != std::string("knot1"))
      continue;
    const Mesh& input = mesh_of_cgal(name);
    Mesh m = input;
    const auto report = IAR::isotropic_remeshing(faces(m), 0, m);
    CHECK(m.number_of_vertices() == input.number_of_vertices() && report.splits == 0 && report.collapses == 0);
    CHECK(report.target_edge_length == 0 && !does_self_intersect(m));
    CHECK_MESSAGE(report.angles_after.minimum > 41 && report.angles_after.maximum < 90,
                  name << ": " << report.angles_after.minimum << " to " << report.angles_after.maximum);
    const Mesh theirs = models::remeshed_by_pmp(input, 0);
    CHECK_MESSAGE(report.angles_after.average > IAR::inter_angle_statistics(theirs).average + 1, report.angles_after.average);
    CHECK_MESSAGE(invariants::surface_distance(input, m).mean() < .95 * invariants::surface_distance(input, theirs).mean(), name);
  }
}

// Moves alone cannot mend the cells of a torus, which are long outside and short inside. They leave no angle thinner all the same: relaxation
// and the polish made 4.6 degrees of 16, and 20 of 27 and of 37.
void moves_alone_make_no_thin_angles()
{
  for(const auto& [along, around, radius] : {std::tuple{40, 40, .4}, {60, 20, .4}, {30, 30, .5}, {80, 20, .25}})
    for(const bool does_flip : {false, true})
    {
      Mesh m = meshes::to_mesh<Mesh>(meshes::torus(along, around, radius));
      const auto report = IAR::isotropic_remeshing(0., m, parameters::do_flip(does_flip));
      CHECK_MESSAGE(report.angles_after.minimum > (std::min)(report.angles_before.minimum, 25.) - .2,
                    along << ": " << report.angles_before.minimum << " to " << report.angles_after.minimum);
    }
}

// Where nothing is left to do, the run ends, and the result is as good.
void settled_meshes_end_early()
{
  for(const char* name : {"sphere966", "blobby", "knot1"})
  {
    Mesh output = mesh_of_cgal(name);
    const double length = mean_edge_length(output);
    const auto first = IAR::isotropic_remeshing(length, output, parameters::number_of_iterations(10));
    const auto again = IAR::isotropic_remeshing(length, output, parameters::number_of_iterations(1000));
    CHECK_MESSAGE(again.iterations >= 3 && again.iterations < 200, name << ": " << again.iterations);
    CHECK_MESSAGE(again.ending == IAR::Remeshing_report::Ending::completed, name);
    CHECK_MESSAGE(again.angles_after.average > first.angles_after.average - .2, name << ": " << again.angles_after.average);
    const auto smoothed = IAR::isotropic_remeshing(0., output, parameters::number_of_iterations(4));
    CHECK_MESSAGE(smoothed.iterations == 4, name); // without a length all of them count
  }
}

// --- Polygon_mesh_processing -------------------------------------------------------------------------------------

struct Quality
{
  double average_angle, hausdorff, mean_distance;

  Quality(const Mesh& output, const Mesh& input)
    : average_angle(IAR::inter_angle_statistics(output).average)
  {
    const auto d = invariants::surface_distance(input, output, 20000);
    hausdorff = d.hausdorff();
    mean_distance = d.mean();
  }
};

std::pair<Quality, Quality> ours_and_that_of_pmp(const Mesh& input, double length)
{
  Mesh ours = input;
  // the facets' surface, which is what PMP keeps to
  const IAR::Closest_point_projector<Mesh> facets(input);
  IAR::isotropic_remeshing(faces(ours), length, ours,
                           parameters::number_of_iterations(10).projection_functor(std::cref(facets)));
  return {Quality(ours, input), Quality(models::remeshed_by_pmp(input, length), input)};
}

// What is gained on PMP, as the mean of three lengths: at one alone, a handful of faces decides on tenths of a degree.
struct Gain
{
  double average_angle = 0;                 // degrees
  double hausdorff = 0, mean_distance = 0;  // parts of PMP's
};

Gain gain_on_pmp(const Mesh& input)
{
  Gain gain;
  const double lengths[] = {.98, 1., 1.02};
  for(const double length : lengths)
  {
    const auto [ours, theirs] = ours_and_that_of_pmp(input, length * mean_edge_length(input));
    gain.average_angle += (ours.average_angle - theirs.average_angle) / std::size(lengths);
    gain.hausdorff += ours.hausdorff / theirs.hausdorff / std::size(lengths);
    gain.mean_distance += ours.mean_distance / theirs.mean_distance / std::size(lengths);
  }
  return gain;
}

// Measured: 1.58 to 4.64 degrees; .41 to .83 and .45 to .73.
constexpr double AVERAGE_GAIN = 1.5, HAUSDORFF_FACTOR = 1, MEAN_DISTANCE_FACTOR = .85;

void angles_are_better_than_those_of_polygon_mesh_processing()
{
  if(meshes::is_small_run())
    return;
  for(const char* name : ORGANIC)
  {
    const Gain gain = gain_on_pmp(mesh_of_cgal(name));
    CHECK_MESSAGE(gain.average_angle >= AVERAGE_GAIN, name << ": " << gain.average_angle);
    CHECK_MESSAGE(gain.hausdorff <= HAUSDORFF_FACTOR, name << ": " << gain.hausdorff);
    CHECK_MESSAGE(gain.mean_distance <= MEAN_DISTANCE_FACTOR, name << ": " << gain.mean_distance);
  }
}

void measure_organic_meshes()
{
  for(const char* name : ORGANIC)
  {
    const Mesh& input = mesh_of_cgal(name);
    std::printf("%-20s faces, of those wanted:", name);
    for(const double factor : {.25, .5, .7, 1., 1.4, 2., 4.})
    {
      const double wanted = std::round(factor * double(input.number_of_faces()));
      Mesh output = input;
      IAR::isotropic_remeshing(IAR::Face_count(std::size_t(wanted)), output);
      std::printf(" %.4f", double(output.number_of_faces()) / wanted);
    }
    std::printf("; by target_edge_length():");
    for(const double factor : {.5, 1., 2.})
      std::printf(" %.4f", yield(input, std::round(factor * double(input.number_of_faces()))));
    const Gain gain = gain_on_pmp(input);
    std::printf("; against PMP: average %+.2f, Hausdorff distance x %.2f, mean distance x %.2f\n", gain.average_angle,
                gain.hausdorff, gain.mean_distance);
  }
}

// --- random meshes -----------------------------------------------------------------------------------------------

// How far the result may be from the input, in edge lengths of the input or of the target, whichever are longer: noise of up to
// .4 is smoothed away, and tubes are as narrow as the target is long.
const double FARTHEST = .75;

// The same numbers everywhere: the standard fixes the generator, but none of its distributions.
class Dice
{
  std::mt19937_64 generator_;

public:
  explicit Dice(std::uint64_t seed) : generator_(seed) {}

  double in(double lower, double upper)
  {
    return lower + (upper - lower) * (double(generator_() >> 11) * 0x1p-53);
  }
  std::size_t below(std::size_t n) { return generator_() % n; }
  bool chance(double probability) { return in(0, 1) < probability; }
  template <class T, std::size_t n>
  const T& one_of(const T (&values)[n]) { return values[below(n)]; }
};

meshes::Soup random_surface(Dice& dice)
{
  switch(dice.below(6))
  {
  case 0: return meshes::sphere(int(2 + dice.below(2)));
  case 1: return meshes::torus(8 + dice.below(20), 4 + dice.below(10), dice.in(.2, .6));
  case 2: return meshes::cube(1 + dice.below(6));
  case 3: return meshes::square(1 + dice.below(12));
  case 4: return meshes::sphere(2).joined_with(meshes::torus(12, 6, .3).moved(3, 0, 0));
  default: return meshes::octahedron();
  }
}

// A mesh with what is asked of the remesher about it.
struct Random_case
{
  Mesh mesh;
  std::vector<Face> range;
  double length;
  unsigned iterations;
  bool do_split, do_collapse, do_flip, protect, collapse_constraints;
  double sharpness_angle;
  IAR::Recipe recipe;
  Mesh::Property_map<Edge, bool> is_constrained_edge;
  Mesh::Property_map<Vertex, bool> is_constrained_vertex;
  Mesh::Property_map<Face, int> patch;
  bool has_patches, has_jagged_patches;

  explicit Random_case(std::uint64_t seed)
  {
    Dice dice(seed);
    mesh = meshes::to_mesh<Mesh>(random_surface(dice));
    add_noise(dice, dice.one_of({0., 0., .05, .2, .4}));
    remove_faces(dice, dice.one_of({0., 0., .02, .1, .3}));
    choose_range(dice);
    mark(dice, dice.one_of({0., 0., .03, .2}), dice.one_of({0., 0., .1}));
    make_patches(dice);
    length = dice.chance(.08) ? 0. : mean_edge_length(mesh) * std::exp(dice.in(std::log(.3), std::log(4.)));
    iterations = unsigned(1 + dice.below(10));
    do_split = dice.chance(.9);
    do_collapse = dice.chance(.9);
    do_flip = dice.chance(.9);
    protect = dice.chance(.3);
    collapse_constraints = dice.chance(.8);
    sharpness_angle = dice.one_of({180., 180., 60., 30.});
    recipe.lower_angle = dice.in(20, 50);
    recipe.upper_angle = dice.in(75, 130);
    recipe.repair = dice.chance(.8);
    recipe.distance_tolerance = dice.one_of({0., .1, .22, .5});
    recipe.fits = unsigned(dice.below(3));
    recipe.fit_tangential_weight = dice.one_of({.3, .3, .03, 1.});
  }

  // A copy of this, remeshed.
  template <class ConcurrencyTag>
  std::pair<Mesh, IAR::Remeshing_report> remeshed() const
  {
    Mesh copy = mesh; // the property maps come along, under the same names
    const auto report = IAR::isotropic_remeshing<ConcurrencyTag>(range, length, copy,
      IAR::recipe(recipe, parameters::number_of_iterations(iterations).do_split(do_split).do_collapse(do_collapse)
        .do_flip(do_flip).edge_is_constrained_map(edge_map(copy)).vertex_is_constrained_map(vertex_map(copy))
        .face_patch_map(patch_map(copy))
        .protect_constraints(protect).collapse_constraints(collapse_constraints).sharpness_angle(sharpness_angle)));
    return {std::move(copy), report};
  }

  static Mesh::Property_map<Edge, bool> edge_map(Mesh& m)
  {
    return m.add_property_map<Edge, bool>("e:is_constrained", false).first;
  }
  static Mesh::Property_map<Vertex, bool> vertex_map(Mesh& m)
  {
    return m.add_property_map<Vertex, bool>("v:is_constrained", false).first;
  }
  static Mesh::Property_map<Face, int> patch_map(Mesh& m)
  {
    return m.add_property_map<Face, int>("f:patch", 0).first;
  }

private:
  void add_noise(Dice& dice, double amount)
  {
    const double size = amount * mean_edge_length(mesh);
    for(const Vertex v : vertices(mesh))
    {
      const double x = dice.in(-size, size), y = dice.in(-size, size), z = dice.in(-size, size);
      mesh.point(v) = mesh.point(v) + Vector(x, y, z);
    }
  }

  void remove_faces(Dice& dice, double probability)
  {
    const std::vector<Face> all(mesh.faces_begin(), mesh.faces_end());
    for(const Face f : all)
      if(dice.chance(probability) && mesh.number_of_faces() > 1)
        CGAL::Euler::remove_face(halfedge(f, mesh), mesh);
  }

  // All faces, those on one side of a plane, or a random half.
  void choose_range(Dice& dice)
  {
    const std::size_t kind = dice.below(4);
    const double bound = dice.in(-.5, .5);
    for(const Face f : faces(mesh))
    {
      const bool is_coin_up = dice.chance(.5);
      if(kind < 2 || (kind == 2 ? corners(f, mesh)[0].x() < bound : is_coin_up))
        range.push_back(f);
    }
  }

  void mark(Dice& dice, double of_edges, double of_vertices)
  {
    is_constrained_edge = edge_map(mesh);
    is_constrained_vertex = vertex_map(mesh);
    for(const Edge e : edges(mesh))
      is_constrained_edge[e] = dice.chance(of_edges);
    for(const Vertex v : vertices(mesh))
      is_constrained_vertex[v] = dice.chance(of_vertices);
  }

  // One, two on the sides of a plane, or three at random.
  void make_patches(Dice& dice)
  {
    patch = patch_map(mesh);
    const std::size_t kind = dice.below(6);
    has_patches = kind < 2;
    has_jagged_patches = kind == 0;
    const double bound = dice.in(-.5, .5);
    for(const Face f : faces(mesh))
    {
      const int any = int(dice.below(3));
      patch[f] = kind == 0 ? int(corners(f, mesh)[0].y() < bound) : kind == 1 ? any : 7;
    }
  }
};

// Between faces of different patches.
std::vector<Segment> patch_borders(Mesh& mesh)
{
  const auto patch = Random_case::patch_map(mesh);
  return segments(mesh, [&](Edge e) {
    const auto h = halfedge(e, mesh);
    return !is_border(e, mesh) && patch[face(h, mesh)] != patch[face(opposite(h, mesh), mesh)];
  });
}

// Vertices and points of the faces, in the order of their descriptors.
template <class Faces>
std::vector<std::pair<Vertex, meshes::Bits>> picture_of_faces(const Faces& all, const Mesh& mesh)
{
  std::vector<std::pair<Vertex, meshes::Bits>> picture;
  for(const Face f : all)
    for(const Vertex v : vertices_around_face(halfedge(f, mesh), mesh))
      picture.emplace_back(v, meshes::bits(mesh.point(v)));
  return picture;
}

void check_constraints_are_kept(Random_case& c, Mesh& output, const std::string& what)
{
  for(const Vertex v : vertices(c.mesh))
    if(c.is_constrained_vertex[v] && !c.mesh.is_isolated(v))
      CHECK_MESSAGE(!output.is_removed(v) && meshes::bits(output.point(v)) == meshes::bits(c.mesh.point(v)), what);

  const auto map = Random_case::edge_map(output);
  const auto before = segments(c.mesh, [&](Edge e) { return c.is_constrained_edge[e]; });
  const auto after = segments(output, [&](Edge e) { return map[e]; });
  const double tolerance = ROUNDING * mean_edge_length(c.mesh) + (c.protect ? 0 : CURVE_TOLERANCE * c.length);
  const double lost = one_sided_distance(before, after);
  CHECK_MESSAGE(lost <= tolerance, what << ": " << lost / c.length);
  if(c.sharpness_angle == 180 && !c.has_patches) // else edges are marked in the end that were not marked before
  {
    const double gained = one_sided_distance(after, before);
    CHECK_MESSAGE(gained <= tolerance, what << ": " << gained / c.length);
  }
  const double patches_moved = distance(patch_borders(c.mesh), patch_borders(output));
  const double patch_tolerance = (std::max)(tolerance, c.has_jagged_patches && !c.protect ? SEAM_TOLERANCE * c.length : 0.);
  CHECK_MESSAGE(patches_moved <= patch_tolerance, what << ": " << patches_moved / c.length);
  // A border becomes a smooth curve where the mesh is refined by a factor of three, which lies within .09 of an edge. One whose edges are
  // short is followed at the scale of the target if it is jagged.
  double longest = 0, shortest = INFINITY;
  for(const Segment& s : border(c.mesh))
  {
    const double l = std::sqrt(CGAL::squared_distance(s.source, s.target));
    longest = std::max(longest, l);
    shortest = std::min(shortest, l);
  }
  const bool is_smooth = 2.7 * c.length < mean_edge_length(c.mesh) || c.range.size() < faces(c.mesh).size();
  const bool may_be_jagged = shortest < LONGEST_JAG * c.length;
  const double moved = distance(border(c.mesh), border(output)),
               most = c.protect ? 0 : std::max(is_smooth ? .09 * longest : 0, may_be_jagged ? BORDER_TOLERANCE * c.length : 0);
  CHECK_MESSAGE(moved <= tolerance + most, what << ": " << moved / c.length);
}

// By how many degrees the worst angle of a face is out of [lower, upper]; at least 0.
double violation(const std::array<Point, 3>& t, double lower, double upper)
{
  double result = 0;
  for(int k = 0; k < 3; ++k)
  {
    const double angle = CGAL::approximate_angle(t[(k + 1) % 3], t[k], t[(k + 2) % 3]);
    result = std::max({result, lower - angle, angle - upper});
  }
  return result;
}

// Every face out of its band is counted, and the worst are named; a face that is named is one of the result.
void check_band(const Random_case& c, const std::vector<Face>& range, const Mesh& output, const IAR::Remeshing_report& report,
                const std::string& what)
{
  constexpr double PRECISION = 1e-3;    // degrees
  std::size_t at_least = 0, at_most = 0; // faces out of the band beside curves, and of that elsewhere
  for(const Face f : range)
  {
    const auto t = corners(f, output);
    at_least += violation(t, std::min(33., c.recipe.lower_angle), std::max(103., c.recipe.upper_angle)) > PRECISION;
    at_most += violation(t, c.recipe.lower_angle + PRECISION, c.recipe.upper_angle - PRECISION) > 0;
  }
  const auto& named = report.faces_out_of_band;
  CHECK_MESSAGE(at_least <= report.number_of_faces_out_of_band && report.number_of_faces_out_of_band <= at_most,
                what << ": " << at_least << ' ' << report.number_of_faces_out_of_band << ' ' << at_most);
  CHECK_MESSAGE(named.size() == std::min<std::size_t>(1000, report.number_of_faces_out_of_band), what);
  bool holds = true;
  for(std::size_t i = 0; i < named.size(); ++i)
  {
    CHECK_MESSAGE(named[i].violation > 0 && (i == 0 || named[i].violation <= named[i - 1].violation), what);
    holds = holds && named[i].reason == IAR::Remeshing_report::Reason::input_corner;
    if(i >= 10)
      continue;
    const Point centroid(named[i].centroid[0], named[i].centroid[1], named[i].centroid[2]);
    double nearest = std::numeric_limits<double>::infinity(), difference = nearest;
    for(const Face f : range)
    {
      const auto t = corners(f, output);
      const double d = CGAL::squared_distance(centroid, CGAL::centroid(t[0], t[1], t[2]));
      if(d > nearest)
        continue;
      nearest = d;
      difference = named[i].violation - violation(t, c.recipe.lower_angle, c.recipe.upper_angle);
    }
    CHECK_MESSAGE(nearest < 1e-20 && difference < PRECISION, what << ": " << nearest << ' ' << difference);
  }
  CHECK_MESSAGE(report.band_holds == holds || named.size() == 1000, what);
}

// Returns whether the result crosses itself, though the input did not.
bool check_random_case(std::uint64_t seed)
{
  const std::string what = "seed " + std::to_string(seed);
  Random_case c(seed);
  auto [output, report] = c.remeshed<CGAL::Sequential_tag>();
  if(!check_same_shape(output, c.mesh, what))
    return false;

  std::vector<Face> outside;
  std::set_difference(c.mesh.faces_begin(), c.mesh.faces_end(), c.range.begin(), c.range.end(),
                      std::back_inserter(outside));
  CHECK_MESSAGE(picture_of_faces(outside, output) == picture_of_faces(outside, c.mesh), what);
  CHECK_MESSAGE(report.input_faces == c.range.size(), what);
  CHECK_MESSAGE(report.output_faces + outside.size() == output.number_of_faces(), what);
  check_constraints_are_kept(c, output, what);
  std::vector<Face> inside;
  std::set_difference(output.faces_begin(), output.faces_end(), outside.begin(), outside.end(), std::back_inserter(inside));
  if(!inside.empty())
    check_band(c, inside, output, report, what);
  const auto distances = invariants::surface_distance(c.mesh, output, 3000);
  const double farthest = distances.hausdorff() / std::max(c.length, mean_edge_length(c.mesh));
  CHECK_MESSAGE(farthest <= FARTHEST, what << ": " << farthest);
  if(c.length == 0 || (!c.do_split && !c.do_collapse))
    CHECK_MESSAGE(output.number_of_faces() == c.mesh.number_of_faces(), what);
  if(!c.do_split || c.length == 0)
    CHECK_MESSAGE(report.splits == 0, what);
  if(!c.do_collapse || c.length == 0)
    CHECK_MESSAGE(report.collapses == 0, what);
  if(!c.do_flip)
    CHECK_MESSAGE(report.flips + report.glides == 0, what);

  const auto again = c.remeshed<CGAL::Parallel_if_available_tag>();
  CHECK_MESSAGE(meshes::Picture<Mesh>(again.first) == meshes::Picture<Mesh>(output), what);
  return does_self_intersect(output) && !does_self_intersect(c.mesh);
}

void random_meshes_keep_what_they_must()
{
  const std::uint64_t cases = meshes::is_small_run() ? 200 : 800;
  std::uint64_t crossed = 0;
  for(std::uint64_t seed = 0; seed < cases; ++seed)
    crossed += check_random_case(seed);
  // A tube that is as wide as the target is long, faces out of the range that stay in the way of others: rare, not never.
  CHECK_MESSAGE(crossed <= cases / 200 + 1, crossed << " of " << cases);
}

// --- fine targets ------------------------------------------------------------------------------------------------

// What a visitor meets.
struct Pass_counter : IAR::Default_visitor
{
  std::size_t levels = 0, announced = 0, made = 0, made_at_last = 0;
  bool counts_in_report = true;

  template <class M>
  void start_pass(IAR::Pass pass, const M&)
  {
    levels += pass == IAR::Pass::subdivide;
    counts_in_report = pass != IAR::Pass::repair && pass != IAR::Pass::distance;
  }
  template <class H, class M>
  void before_split(H, const M&) { ++announced; }
  template <class V, class M>
  void after_split(V, const M&) { ++(counts_in_report ? made : made_at_last); }
};

IAR::Recipe with_levels(bool multi_level)
{
  IAR::Recipe r;
  r.multi_level = multi_level;
  return r;
}

// Corners whose radius is about the edge length of a coarser level, which bites them off where hardly a vertex lies on their fillets.
void coarser_levels_lose_no_corners()
{
  for(const meshes::Slab& s : {meshes::Slab{1.5, 3, .54, .6, 8, .12, 3}, meshes::Slab{1.5, 3, .54, .3, 5, .2, 4}})
    for(const double length : {.1346, .14, .0748})
    {
      const Mesh input = meshes::to_mesh<Mesh>(meshes::slab(s));
      if(meshes::is_small_run() && length < .1)
        continue;
      Mesh m = input;
      const auto report = IAR::isotropic_remeshing(length, m);
      const double distance = invariants::surface_distance(input, m).hausdorff() / length;
      CHECK_MESSAGE(distance < .5, s.corner_radius << ", " << length << ": " << distance);
      CHECK_MESSAGE(report.band_holds, s.corner_radius << ", " << length);
    }
}

// From a coarser level, the irregular vertices are those of a mesh with a quarter or a sixteenth of the faces: on the target
// length alone, seven in a hundred are left, whatever the length.
constexpr double REGULAR_FROM_LEVELS = 95, REGULAR_DIRECTLY = 94;

void fine_targets_are_reached_from_coarser_levels()
{
  struct Fine_case { const char* name; double factor, sharpness_angle; std::size_t levels; double smallest, largest; };
  // The bounds of the angles are those of EXPECTATIONS: [44, 85] and [35, 100] beside curves, with a margin.
  for(const Fine_case& c : {Fine_case{"knot1", .25, 180, 2, 43, 86}, Fine_case{"mesh_with_border", .45, 180, 1, 32, 103},
                            Fine_case{"three_peaks", .4, 180, 1, 32, 103}, Fine_case{"cube-meshed", .45, 40, 1, 32, 103}})
  {
    const Mesh& input = mesh_of_cgal(c.name);
    if(meshes::is_small_run() && input.number_of_faces() > SMALL)
      continue;
    const double length = c.factor * mean_edge_length(input);
    IAR::Recipe recipe = with_levels(true);
    recipe.grading = 0;
    Mesh output = input;
    const auto map = Random_case::edge_map(output);
    Pass_counter passes;
    const IAR::Remeshing_report report = IAR::isotropic_remeshing(length, output,
      IAR::recipe(recipe, parameters::sharpness_angle(c.sharpness_angle).edge_is_constrained_map(map).visitor(std::ref(passes))));
    CHECK_MESSAGE(passes.levels == c.levels, c.name << ": " << passes.levels);
    CHECK_MESSAGE(passes.announced == passes.made + passes.made_at_last && passes.made == report.splits, c.name);
    if(!check_same_shape(output, input, c.name))
      continue;
    CHECK_MESSAGE(!does_self_intersect(output), c.name);
    CHECK_MESSAGE(report.target_edge_length == length, c.name);
    // The mean edge is as long as that of a run on the target length; by how much the few faces of a coarse level scatter.
    Mesh directly = input;
    const auto direct_map = Random_case::edge_map(directly);
    recipe.multi_level = false;
    IAR::isotropic_remeshing(length, directly, IAR::recipe(recipe, parameters::sharpness_angle(c.sharpness_angle)
                                                                     .edge_is_constrained_map(direct_map)));
    recipe.multi_level = true;
    const double mean = mean_edge_length(output) / mean_edge_length(directly);
    CHECK_MESSAGE(mean > .96 && mean < 1.04, c.name << ": " << mean);
    const auto angles = IAR::inter_angle_statistics(output);
    CHECK_MESSAGE(angles.minimum_angle > c.smallest && angles.maximum_angle < c.largest,
                  c.name << ": " << angles.minimum_angle << " to " << angles.maximum_angle);
    CHECK_MESSAGE(angles.percentage_of_regular_vertices() > REGULAR_FROM_LEVELS,
                  c.name << ": " << angles.percentage_of_regular_vertices());
    const double moved = distance(border(input), border(output));
    CHECK_MESSAGE(moved <= CURVE_TOLERANCE * length + ROUNDING, c.name << ": " << moved / length);

    Mesh unseen = input;
    const auto unseen_map = Random_case::edge_map(unseen);
    IAR::isotropic_remeshing<CGAL::Parallel_if_available_tag>(length, unseen,
      IAR::recipe(recipe, parameters::sharpness_angle(c.sharpness_angle).edge_is_constrained_map(unseen_map)));
    CHECK_MESSAGE(meshes::Picture<Mesh>(unseen) == meshes::Picture<Mesh>(output), c.name);

    if(c.sharpness_angle < 180)
    {
      Mesh marked = input;
      const auto sharp = Random_case::edge_map(marked);
      PMP::detect_sharp_edges(marked, c.sharpness_angle, sharp);
      const double feature_moved = distance(segments(marked, [&](Edge e) { return sharp[e]; }),
                                            segments(output, [&](Edge e) { return map[e]; }));
      CHECK_MESSAGE(feature_moved <= CURVE_TOLERANCE * length + ROUNDING, c.name << ": " << feature_moved / length);
    }
  }
}

// Where it is switched off, or rules of the user's say what happens to an edge.
void levels_are_left_out_where_they_are_not_wanted()
{
  const Mesh& input = mesh_of_cgal("mesh_with_border");
  const double length = .25 * mean_edge_length(input);
  const auto run = [&](const auto& np) {
    Pass_counter passes;
    Mesh output = input;
    IAR::isotropic_remeshing(length, output, np.visitor(std::ref(passes)));
    return std::make_pair(passes.levels, IAR::inter_angle_statistics(output).percentage_of_regular_vertices());
  };
  const auto [levels, regular] = run(IAR::recipe(with_levels(false), parameters::number_of_iterations(10)));
  CHECK_MESSAGE(levels == 0 && regular < REGULAR_DIRECTLY, levels << ", " << regular);
  CHECK(run(parameters::number_of_iterations(10)).first == 2);
  CHECK(run(parameters::do_split(true)).first == 2);
  CHECK(run(parameters::do_split([](const auto&) { return true; })).first == 0);
  CHECK(run(parameters::do_collapse(false)).first == 0);
  CHECK(run(parameters::do_flip([](const auto&) { return true; })).first == 0);
  CHECK(run(parameters::protect_constraints(true)).first == 2);
  CHECK(run(parameters::do_project(false)).first == 0);
}

// Without projection nothing leads back to the surface that a coarser level has left. (With levels it was left by .07 and .09 target
// lengths on the average.)
void without_projection_fine_meshes_stay_near_the_surface()
{
  for(const auto& [name, largest] : {std::make_pair("blobby", .03), std::make_pair("elephant", .05)})
  {
    const Mesh& input = mesh_of_cgal(name);
    const double length = .25 * mean_edge_length(input);
    Mesh m = input;
    const auto report = IAR::isotropic_remeshing(faces(m), length, m, parameters::do_project(false).number_of_iterations(10));
    const double moved = invariants::surface_distance(input, m).mean() / length;
    CHECK_MESSAGE(moved < largest, name << ": " << moved);
    CHECK_MESSAGE(report.band_holds, name << ": " << report.angles_after.minimum << " to " << report.angles_after.maximum);
  }
}

// Those with a smaller angle, in degrees.
std::size_t number_of_faces_under(double angle, const Mesh& m)
{
  const auto is_under = [&](Mesh::Face_index f) {
    const auto h = m.halfedge(f);
    const Point &p = m.point(m.source(h)), &q = m.point(m.target(h)), &r = m.point(m.target(m.next(h)));
    return (std::min)({CGAL::approximate_angle(p, q, r), CGAL::approximate_angle(q, r, p), CGAL::approximate_angle(r, p, q)}) < angle;
  };
  return std::size_t(std::count_if(m.faces_begin(), m.faces_end(), is_under));
}

// Whether the centre of f lies on the positive side of the plane x = 0.
bool is_in_half(const Mesh& m, Mesh::Face_index f)
{
  double sum = 0;
  for(const auto v : m.vertices_around_face(m.halfedge(f)))
    sum += m.point(v).x();
  return sum > 0;
}

// The ends of these edges, to the last bit.
template <class Predicate>
std::set<std::pair<meshes::Bits, meshes::Bits>> places_of_edges(const Mesh& m, const Predicate& is_one)
{
  std::set<std::pair<meshes::Bits, meshes::Bits>> result;
  for(const Edge e : m.edges())
    if(is_one(e))
    {
      const meshes::Bits p = meshes::bits(m.point(m.vertex(e, 0))), q = meshes::bits(m.point(m.vertex(e, 1)));
      result.insert({(std::min)(p, q), (std::max)(p, q)});
    }
  return result;
}

// Marks the edges between the two halves in the mesh's map, and splits those that are longer than this.
void mark_edges_between_halves(Mesh& m, double split_length)
{
  const auto map = Random_case::edge_map(m);
  for(const Edge e : m.edges())
    map[e] = is_in_half(m, m.face(m.halfedge(e, 0))) != is_in_half(m, m.face(m.halfedge(e, 1)));
  std::vector<Edge> marked;
  std::copy_if(m.edges_begin(), m.edges_end(), std::back_inserter(marked), [&](Edge e) { return map[e]; });
  PMP::split_long_edges(marked, split_length, m, parameters::edge_is_constrained_map(map));
}

// On coarser levels, too, protected edges are not split, as a visitor sees; the faces beside them are as good as without levels. They are
// the rim of a range, or marked in a whole mesh, as they are or split to the target length, which makes the mean edge shorter.
void protected_edges_stay_whole_on_coarser_levels()
{
  struct Protected_case { const char* name; bool is_range, are_short; };
  const Mesh& knot = mesh_of_cgal("knot1");
  const double length = .25 * mean_edge_length(knot);
  for(const Protected_case& c : {Protected_case{"rim of a range", true, false}, Protected_case{"marked edges", false, false},
                                 Protected_case{"short marked edges", false, true}})
  {
    Mesh input = knot;
    mark_edges_between_halves(input, c.are_short ? length : std::numeric_limits<double>::infinity());
    const auto map = Random_case::edge_map(input);
    std::vector<Mesh::Face_index> range;
    std::copy_if(input.faces_begin(), input.faces_end(), std::back_inserter(range),
                 [&](Mesh::Face_index f) { return !c.is_range || is_in_half(input, f); });
    const auto marked = places_of_edges(input, [&](Edge e) { return map[e]; });
    const auto run = [&](auto tag, bool multi_level, Pass_counter& passes, Mesh& m) {
      m = input;
      const auto marks = Random_case::edge_map(m);
      if(c.is_range)
        for(const Edge e : m.edges())
          marks[e] = false;
      return IAR::isotropic_remeshing<decltype(tag)>(range, length, m,
        IAR::recipe(with_levels(multi_level), parameters::sharpness_angle(180).edge_is_constrained_map(marks)
                                                .protect_constraints(!c.is_range).visitor(std::ref(passes))));
    };
    Mesh output, directly, in_parallel;
    Pass_counter passes, direct_passes, parallel_passes;
    const IAR::Remeshing_report report = run(CGAL::Sequential_tag(), true, passes, output);
    run(CGAL::Sequential_tag(), false, direct_passes, directly);
    run(CGAL::Parallel_if_available_tag(), true, parallel_passes, in_parallel);
    CHECK_MESSAGE(direct_passes.levels == 0 && passes.levels == (c.are_short ? 1 : 2), c.name << ": " << passes.levels);
    CHECK_MESSAGE(passes.announced == passes.made + passes.made_at_last && passes.made == report.splits, c.name);
    CHECK_MESSAGE(meshes::Picture<Mesh>(in_parallel) == meshes::Picture<Mesh>(output), c.name);
    if(!check_same_shape(output, input, c.name))
      continue;
    const auto all = places_of_edges(output, [](Edge) { return true; });
    CHECK_MESSAGE(!marked.empty() && std::includes(all.begin(), all.end(), marked.begin(), marked.end()), c.name);
    CHECK_MESSAGE(!does_self_intersect(output), c.name);
    const std::size_t poor = number_of_faces_under(25, output), direct_poor = number_of_faces_under(25, directly);
    CHECK_MESSAGE(10 * poor <= 13 * direct_poor + 100, c.name << ": " << poor << ", " << direct_poor);
    const auto angles = IAR::inter_angle_statistics(output), direct = IAR::inter_angle_statistics(directly);
    CHECK_MESSAGE(angles.average > direct.average - .3, c.name << ": " << angles.average << ", " << direct.average);
  }
}

// Sharp edges of thin parts, protected and many target lengths long: where the way over coarser levels leaves faces that cross each other,
// the direct one is taken.
void no_level_leaves_crossings_beside_protected_edges()
{
  struct Sharp_case { const char* name; double factor; };
  for(const Sharp_case& c : {Sharp_case{"hand", .3}, Sharp_case{"cactus", .15}})
  {
    const Mesh& input = mesh_of_cgal(c.name);
    Mesh output = input;
    const auto marks = Random_case::edge_map(output);
    PMP::detect_sharp_edges(output, 50, marks);
    const auto marked = places_of_edges(output, [&](Edge e) { return marks[e]; });
    const auto report = IAR::isotropic_remeshing(c.factor * mean_edge_length(input), output,
                                                 parameters::edge_is_constrained_map(marks).protect_constraints(true));
    const auto all = places_of_edges(output, [](Edge) { return true; });
    CHECK_MESSAGE(!marked.empty() && std::includes(all.begin(), all.end(), marked.begin(), marked.end()), c.name);
    CHECK_MESSAGE(report.crossing_faces == 0 && !does_self_intersect(output), c.name << ": " << report.crossing_faces);
    if(meshes::is_small_run())
      break;
  }
}

// A square sheet with holes, cut into as few faces as there can be. Its border, which stays as it is, has edges of dozens of target lengths:
// beside these faces are large and small, and sweeps turned some over. What lies in the plane stays in it, and covers it once.
void sheets_with_long_protected_borders_do_not_fold()
{
  meshes::Soup soup;
  soup.points = {{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}};
  for(const auto& [x, y] : {std::pair(2., 2.), std::pair(8., 2.), std::pair(8., 8.)})
    for(const auto& [dx, dy] : {std::pair(0., -.6), std::pair(-.6, 0.), std::pair(0., .6), std::pair(.6, 0.)})
      soup.points.push_back({x + dx, y + dy, 0});
  soup.faces = {{1, 11, 8},  {8, 9, 7},   {8, 7, 4}, {6, 7, 9}, {6, 9, 10}, {11, 1, 2},   {11, 2, 15}, {11, 15, 12}, {11, 12, 13}, {14, 15, 2},
                {14, 2, 3},  {0, 1, 8},   {0, 8, 4}, {0, 4, 5}, {10, 11, 13}, {13, 14, 3}, {3, 0, 5},  {3, 5, 6},    {3, 6, 10},   {10, 13, 3}};
  const Mesh input = meshes::to_mesh<Mesh>(soup);
  const double area = PMP::area(input);
  std::vector<double> lengths = {.2};
  if(!meshes::is_small_run())
    lengths = {.1, .15, .18, .2, .22, .25, .3};
  for(const double length : lengths)
  {
    Mesh output = input;
    const auto report = IAR::isotropic_remeshing(length, output, parameters::protect_constraints(true));
    output.collect_garbage();
    CHECK(topology(output) == topology(input) && report.crossing_faces == 0);
    CHECK_MESSAGE(std::abs(PMP::area(output) - area) < 1e-9 * area, length << ": " << PMP::area(output) - area);
    CHECK_MESSAGE(std::all_of(output.faces_begin(), output.faces_end(),
                              [&](Face f) { return PMP::compute_face_normal(f, output).z() > .999; }), length);
    const auto before = places_of_edges(input, [&](Edge e) { return input.is_border(e); });
    CHECK_MESSAGE(places_of_edges(output, [&](Edge e) { return output.is_border(e); }) == before, length);
  }
}

void a_run_cancelled_before_its_finest_level_changes_nothing()
{
  const Mesh& input = mesh_of_cgal("mesh_with_border");
  const double length = .25 * mean_edge_length(input);
  double last = 0;
  bool is_monotone = true;
  const auto run_until = [&](double end) {
    Mesh output = input;
    last = 0;
    const IAR::Remeshing_report report = IAR::isotropic_remeshing(length, output, parameters::callback([&](double done) {
      is_monotone = is_monotone && done >= last && done <= 1;
      last = done;
      return done < end;
    }));
    return std::make_pair(std::move(output), report);
  };
  for(const double end : {.01, .3, .5})    // the iterations are ten of twenty parts, two levels are two, and the clean-up the rest
  {
    const auto [output, report] = run_until(end);
    CHECK_MESSAGE(meshes::Picture<Mesh>(output) == meshes::Picture<Mesh>(input), end);
    CHECK_MESSAGE(report.ending == IAR::Remeshing_report::Ending::cancelled && report.splits == 0 &&
                  report.output_faces == report.input_faces, end);
    CHECK_MESSAGE(report.angles_after.minimum == report.angles_before.minimum &&
                  report.band_holds == (report.number_of_faces_out_of_band == 0), end);
  }
  const auto [output, report] = run_until(.95);
  CHECK(report.ending == IAR::Remeshing_report::Ending::cancelled);
  CHECK(check_same_shape(output, input, "cancelled late") && output.number_of_faces() > 8 * input.number_of_faces());
  run_until(2);
  CHECK_MESSAGE(is_monotone && last == 1, last);
}

int main(int argc, char* argv[])
{
  if(argc > 1 && std::strcmp(argv[1], "measure") == 0)
  {
    measure_real_meshes();
    measure_organic_meshes();
    return EXIT_SUCCESS;
  }
  real_meshes_keep_their_shape_and_gain_good_angles();
  degenerate_faces_are_survived();
  edges_that_are_no_features_survive_long_facets();
  lengths_far_too_large_and_far_too_small_return();
  wanted_numbers_of_faces_are_met();
  coarse_numbers_of_faces_are_met();
  the_repair_reaches_the_band();
  only_small_angles_between_borders_are_forced();
  large_distances_are_lowered();
  crossing_faces_are_parted();
  thin_rings_stay_rings();
  limbs_thinner_than_the_target_have_good_angles();
  discs_with_short_border_edges_have_good_angles();
  small_crossings_of_the_input_are_parted();
  parts_that_touch_keep_their_angles();
  boxes_that_touch_each_other_stay_boxes();
  regular_grids_are_stirred_up();
  grids_are_broken_up();
  apexes_of_coarse_cones_stay();
  tips_are_not_worn_off_by_what_mends_angles();
  a_few_iterations_are_enough_for_needles_and_long_facets();
  islands_keep_a_volume();
  heaps_of_vertices_are_cleared_away();
  thin_walls_keep_their_round_ends();
  folded_walls_of_terrains_are_not_missed();
  all_crossing_faces_are_found();
  vertices_of_tips_and_saddles_are_regular();
  coarse_organic_models_gain_by_irregular_vertices();
  without_a_length_angles_are_mended();
  moves_alone_make_no_thin_angles();
  settled_meshes_end_early();
  angles_are_better_than_those_of_polygon_mesh_processing();
  random_meshes_keep_what_they_must();
  fine_targets_are_reached_from_coarser_levels();
  coarser_levels_lose_no_corners();
  levels_are_left_out_where_they_are_not_wanted();
  without_projection_fine_meshes_stay_near_the_surface();
  protected_edges_stay_whole_on_coarser_levels();
  no_level_leaves_crossings_beside_protected_edges();
  sheets_with_long_protected_borders_do_not_fold();
  a_run_cancelled_before_its_finest_level_changes_nothing();
  return result();
}
