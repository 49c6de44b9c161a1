// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_REMESH_RANGE_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_REMESH_RANGE_H

#include <CGAL/Inter_angle_remeshing/internal/attribute_exchange.h>
#include <CGAL/Inter_angle_remeshing/internal/close_curve_vertices.h>
#include <CGAL/Inter_angle_remeshing/internal/constraints.h>
#include <CGAL/Inter_angle_remeshing/internal/corners.h>
#include <CGAL/Inter_angle_remeshing/internal/feature_detection.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh_exchange.h>
#include <CGAL/Inter_angle_remeshing/internal/refuse.h>
#include <CGAL/Inter_angle_remeshing/internal/run_passes.h>
#include <CGAL/Inter_angle_remeshing/internal/run_with_projector.h>
#include <CGAL/Inter_angle_remeshing/internal/space_filling_order.h>
#include <CGAL/Inter_angle_remeshing/internal/target_of_run.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

// From a range and its parameters to the result: reads the range and its marks, runs the remesher, writes the result back.
// The user's mesh is changed in the last step alone.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// Everything that isotropic_remeshing() reads from its named parameters.
template <class VertexPointMap, class EdgeIsConstrainedMap, class VertexIsConstrainedMap, class PatchMap,
          class SplitPolicy, class CollapsePolicy, class FlipPolicy, class ProjectionFunctor, class Visitor>
struct Remeshing_parameters
{
  VertexPointMap vertex_point_map;
  EdgeIsConstrainedMap edge_is_constrained_map;
  VertexIsConstrainedMap vertex_is_constrained_map;
  PatchMap face_patch_map;
  SplitPolicy split_policy;
  CollapsePolicy collapse_policy;
  FlipPolicy flip_policy;
  ProjectionFunctor projection_functor;
  Visitor& visitor;                      // a Run_visitor
  Recipe recipe;
  Schedule schedule;
  Constraint_settings constraint_settings;
  bool may_collapse_constraints;
  bool does_project;
  bool may_subdivide;
};

// Vertices that are farther apart, in target lengths, are details.
constexpr double LARGEST_MERGING_DISTANCE = 0.1;

inline void check_recipe(const Recipe& recipe)
{
  if (!(recipe.split_ratio > 1 && recipe.split_ratio <= 2))
    refuse(REMESHING, "Recipe::split_ratio is " + to_text(recipe.split_ratio) + "; it must lie in (1, 2]");
  if (!(recipe.collapse_ratio >= 0 && recipe.collapse_ratio < 1 &&
        1.2 * recipe.collapse_ratio <= recipe.split_ratio))
    refuse(REMESHING, "Recipe::collapse_ratio is " + to_text(recipe.collapse_ratio) +
                      "; it must lie in [0, 1) and be at most split_ratio / 1.2");
  if (!(recipe.relaxation > 0 && recipe.relaxation <= 1.6))
    refuse(REMESHING, "Recipe::relaxation is " + to_text(recipe.relaxation) + "; it must lie in (0, 1.6]");
  if (recipe.glide_depth > MAXIMUM_GLIDE_DEPTH)
    refuse(REMESHING, "Recipe::glide_depth is " + std::to_string(recipe.glide_depth) + "; at most " +
                      std::to_string(MAXIMUM_GLIDE_DEPTH) + " is possible");
  if (!(recipe.lower_angle >= 0 && recipe.lower_angle < 60 && recipe.upper_angle > 60 && recipe.upper_angle <= 180))
    refuse(REMESHING, "the band of angles [" + to_text(recipe.lower_angle) + ", " +
                      to_text(recipe.upper_angle) + "] of the recipe must lie in [0, 180] and hold 60 inside");
  const auto check_not_negative = [](double value, const char* name) {
    if (!(value >= 0)) refuse(REMESHING, std::string("Recipe::") + name + " is " + to_text(value) + "; it must not be negative");
  };
  check_not_negative(recipe.grading, "grading");
  check_not_negative(recipe.distance_tolerance, "distance_tolerance");
  check_not_negative(recipe.relief_density, "relief_density");
  check_not_negative(recipe.collapse_tolerance, "collapse_tolerance");
  if (!(recipe.fillet_width >= 0 && recipe.fillet_width <= 1))
    refuse(REMESHING, "Recipe::fillet_width is " + to_text(recipe.fillet_width) + "; it must lie in [0, 1]");
  if (!(recipe.merging_distance >= 0 && recipe.merging_distance <= LARGEST_MERGING_DISTANCE))
    refuse(REMESHING, "Recipe::merging_distance is " + to_text(recipe.merging_distance) + "; it must lie in [0, " +
                      to_text(LARGEST_MERGING_DISTANCE) + "]");
}

template <class PatchMap, class Faces>
auto read_patches(const PatchMap& fpm, const Faces& faces)
{
  if constexpr (std::is_same<PatchMap, No_map>::value) {
    (void)fpm; (void)faces;
    return No_map();
  } else {
    std::vector<typename boost::property_traits<PatchMap>::value_type> patches;
    patches.reserve(faces.size());
    for (const auto& f : faces) patches.push_back(get(fpm, f));
    return patches;
  }
}

inline std::size_t count_features(const Remeshing_mesh& mesh)
{
  std::size_t n = 0;
  for (Remeshing_mesh::Index h = 0; h < 4 * Remeshing_mesh::Index(mesh.number_of_face_slots()); ++h)
    n += mesh.corner(h) < 3 && mesh.is_constrained(h) && (mesh.is_border(h) || mesh.opposite(h) > h);
  return n;
}

// Features are found by themselves where nothing is marked, and where the surface stays the input's: a functor of the
// user's may lead to any other, a sphere for an icosahedron.
template <class Parameters>
Input_kind find_and_mark_features(Remeshing_mesh& mesh, const Target& target, double mean_length, const Parameters& parameters)
{
  using Functor = std::decay_t<decltype(referred(parameters.projection_functor))>;
  constexpr bool keeps_surface = std::is_same<Functor, No_map>::value || Has_reference_surface<Functor>::value;
  using Features = Remeshing_report::Features;
  Input_kind kind{false, false, Features::none, count_features(mesh), 0, {}};
  if (kind.feature_edges > 0) kind.features = Features::marked;
  if (!keeps_surface || parameters.recipe.surface == Recipe::Surface::paper) return kind;
  Feature_detector detector(mesh, (std::max)(target.length, mean_length));
  kind.is_cad = detector.is_cad();
  kind.saddle_excess = detector.saddle_excess();
  kind.has_found_features = parameters.constraint_settings.finds_features;
  if (!kind.has_found_features) return kind;
  Found_features found = detector.features([&](Remeshing_mesh::Index f) {
    return target.length * target.sizing.part_of_face(mesh.face_record(f).source); },
    parameters.recipe.fillet_width, parameters.recipe.relief_density);
  for (const Remeshing_mesh::Index h : found.edges) mark_feature(mesh, h);
  kind.rounded_edges = std::move(found.rounded);
  if (!found.edges.empty()) kind.features = kind.is_cad ? Features::all_sharp_edges : Features::outstanding_edges;
  kind.feature_edges = count_features(mesh);
  return kind;
}

// Whether curves may lose tiny edges before the run. Not where the user's marks say what is to be kept, or a policy what may go, or
// where the surface is another one than the mesh itself.
template <class Parameters>
bool may_merge_curve_vertices(const Parameters& parameters, const Input_kind& kind)
{
  return parameters.may_subdivide && parameters.may_collapse_constraints && parameters.does_project && kind.has_found_features &&
         std::is_same<std::decay_t<decltype(referred(parameters.projection_functor))>, No_map>::value &&
         std::is_same<std::decay_t<decltype(parameters.face_patch_map)>, No_map>::value;
}

// Designed curves are not jagged; where the fillets of a part are joined across a corner, they are.
inline std::vector<double> scales_of_corners(const Remeshing_mesh& mesh, const Input_kind& kind, double target)
{
  std::vector<double> scales(mesh.number_of_vertex_slots(), kind.is_cad ? 0. : target);
  for (const Remeshing_mesh::Index h : kind.rounded_edges.edges) scales[mesh.origin(h)] = scales[mesh.target(h)] = target;
  return scales;
}

// How rough noise makes the stars of a mesh with edges of the target length: the shorter these are beside the input's, the rougher.
inline double noise(const Input_kind& kind, double mean_length, double target)
{
  return target > 0 ? kind.saddle_excess * (mean_length / target) * (mean_length / target) : 0.;
}

// Whether curves hold details that the target length must fall to. One much under the length of the input's edges finds none.
inline bool has_details_smaller_than(double target, const Input_curves& curves, double mean_length)
{
  constexpr double SMALL = 0.5;
  return target > SMALL * mean_length && curves.have_last_edges_under(SMALL * target);
}

template <class ConcurrencyTag, class FaceRange, class Length, class TriangleMesh, class Parameters>
Remeshing_report remesh_range(const FaceRange& range, const Length& length, TriangleMesh& tmesh,
                              Parameters& parameters)
{
  using Vpm = decltype(parameters.vertex_point_map);
  using Concurrency = std::conditional_t<is_parallel<ConcurrencyTag>(), CGAL::Parallel_tag, CGAL::Sequential_tag>;
  check_recipe(parameters.recipe);
  if (range.begin() == range.end()) {
    check_length_value(length);
    return {};
  }
  Mesh_exchange<TriangleMesh, Vpm> exchange(range, tmesh, parameters.vertex_point_map, REMESHING);
  const double total_length = total_edge_length(exchange.mesh());
  Target wanted = read_target(length, exchange, tmesh, parameters.vertex_point_map, total_length);
  double& target = wanted.length;
  if (parameters.schedule.iterations == 0) return {};
  parameters.schedule.wanted_faces = wanted.faces;

  mark_constraints(exchange, tmesh, parameters.edge_is_constrained_map, parameters.vertex_is_constrained_map,
                   parameters.face_patch_map, parameters.constraint_settings);
  const double mean_length = total_length / (1.5 * double(exchange.input_faces().size()));
  const Input_kind kind = find_and_mark_features(exchange.mesh(), wanted, mean_length, parameters);
  const auto patches = read_patches(parameters.face_patch_map, exchange.input_faces());
  Remeshing_mesh mesh = exchange.take_mesh();
  const std::vector<double> scales = scales_of_corners(mesh, kind, target);
  if (target > 0 && parameters.recipe.merging_distance > 0 && may_merge_curve_vertices(parameters, kind)) {
    std::vector<char> is_corner = find_corners(mesh, scales, CHAMFER_COSINE), is_joint(mesh.number_of_vertex_slots(), 0);
    for (const Remeshing_mesh::Index v : kind.rounded_edges.joints) is_corner[v] = is_joint[v] = 1;
    Close_curve_vertices(mesh, std::move(is_corner), [&](Remeshing_mesh::Index v) {
      const double part = wanted.sizing.part_of_face(mesh.face_record(mesh.face(mesh.first(v))).source);
      return (is_joint[v] ? Rounded_edges::JOINT_LENGTH : parameters.recipe.merging_distance) * target * part;
    }).merge();
  }
  lock_corners(mesh, scales);
  mesh.renumber<ConcurrencyTag>(morton_order(mesh));
  Input_curves curves(mesh);
  const bool has_small_details = wanted.sizing.is_uniform() &&
    (kind.is_cad || (!parameters.constraint_settings.protect && has_details_smaller_than(target, curves, mean_length)));

  const auto rule = [&](const auto& policy) {
    return make_edge_rule(policy, exchange.input_vertices(), boost::graph_traits<TriangleMesh>::null_vertex());
  };
  Attribute_exchange attributes(parameters.visitor, exchange, tmesh, mesh);
  bool is_to_be_written = true;
  Remeshing_report report = run_with_projector(parameters, exchange, mesh, kind, curves, wanted, [&](const Projection& projector) {
    std::optional<Input_locator> locator;
    if (wanted.sizing.needs_places() || attributes.are_carried()) locator.emplace(projector, mesh);
    Remeshing_context context{mesh, parameters.recipe, curves, rule(parameters.split_policy), rule(parameters.collapse_policy),
                              rule(parameters.flip_policy), projector, parameters.visitor, parameters.may_collapse_constraints,
                              target, parameters.may_subdivide, wanted.sizing, locator ? &*locator : nullptr,
                              has_small_details ? parameters.recipe.grading : 0., noise(kind, mean_length, target), Grading(),
                              Kept_places()};
    const Run_result result = run_passes<Concurrency>(context, parameters.schedule);
    is_to_be_written = result.has_target_length;
    if (is_to_be_written && attributes.are_carried()) attributes.read(mesh, *locator);
    return result.report;
  });

  report.features = kind.features;
  report.feature_edges = kind.feature_edges;
  if (!is_to_be_written) return report;
  exchange.write(mesh, [&](const auto& edge) { forget_constraint(parameters.edge_is_constrained_map, edge); });
  write_constraints(exchange, mesh, tmesh, parameters.edge_is_constrained_map, parameters.face_patch_map, patches);
  if (attributes.are_carried()) attributes.write(mesh);
  return report;
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_REMESH_RANGE_H
