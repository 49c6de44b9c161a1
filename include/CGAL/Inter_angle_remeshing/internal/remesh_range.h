// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_REMESH_RANGE_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_REMESH_RANGE_H

#include <CGAL/Inter_angle_remeshing/Policies/Inter_angle_split_policy.h>
#include <CGAL/Inter_angle_remeshing/internal/arguments/check_recipe.h>
#include <CGAL/Inter_angle_remeshing/internal/arguments/projector_traits.h>
#include <CGAL/Inter_angle_remeshing/internal/arguments/referred.h>
#include <CGAL/Inter_angle_remeshing/internal/arguments/refuse.h>
#include <CGAL/Inter_angle_remeshing/internal/arguments/run_with_projector.h>
#include <CGAL/Inter_angle_remeshing/internal/arguments/target_of_run.h>
#include <CGAL/Inter_angle_remeshing/internal/curves/curve_edges.h>
#include <CGAL/Inter_angle_remeshing/internal/curves/settle_corners.h>
#include <CGAL/Inter_angle_remeshing/internal/exchange/attribute_exchange.h>
#include <CGAL/Inter_angle_remeshing/internal/exchange/constraints.h>
#include <CGAL/Inter_angle_remeshing/internal/exchange/mesh_exchange.h>
#include <CGAL/Inter_angle_remeshing/internal/features/input_kind.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/angle_summary.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/edge_lengths.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/space_filling_order.h>
#include <CGAL/Inter_angle_remeshing/internal/run_passes.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

// From a range and its parameters to the result: reads the range and its marks, runs the remesher, writes the result back.
// The user's mesh is changed in the last step alone, but for the point of a vertex that Carrier_vertex borrows.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// Everything that isotropic_remeshing() reads from its named parameters.
template <class VertexPointMap, class EdgeIsConstrainedMap, class VertexIsConstrainedMap, class PatchMap,
          class SplitPolicy, class CollapsePolicy, class FlipPolicy, class MoveFunctor, class ProjectionFunctor, class Visitor>
struct Remeshing_parameters
{
  VertexPointMap vertex_point_map;
  EdgeIsConstrainedMap edge_is_constrained_map;
  VertexIsConstrainedMap vertex_is_constrained_map;
  PatchMap face_patch_map;
  SplitPolicy split_policy;
  CollapsePolicy collapse_policy;
  FlipPolicy flip_policy;
  MoveFunctor allow_move_functor;
  ProjectionFunctor projection_functor;
  Visitor& visitor;                      // a Run_visitor
  Recipe recipe;
  Schedule schedule;
  Constraint_settings constraint_settings;
  bool may_collapse_constraints;
  bool does_project;
  bool may_subdivide;
};

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

// Whether the run keeps to the surface of the input: without a functor of the user's, or with a projector that has such a surface.
template <class Parameters>
constexpr bool keeps_surface()
{
  using Functor = std::decay_t<decltype(referred(std::declval<const Parameters&>().projection_functor))>;
  return std::is_same<Functor, No_map>::value || Has_reference_surface<Functor>::value;
}

// Whether curves may lose tiny edges before the run. Not where the user's marks say what is to be kept, or a policy what may go, or
// where the surface is another one than the mesh itself.
template <class Parameters>
bool may_merge_curve_vertices(const Parameters& parameters, const Input_kind& kind)
{
  return parameters.may_subdivide && parameters.may_collapse_constraints && parameters.does_project && kind.searches_features &&
         std::is_same<std::decay_t<decltype(referred(parameters.projection_functor))>, No_map>::value &&
         std::is_same<std::decay_t<decltype(parameters.face_patch_map)>, No_map>::value;
}

// How wide crests may be, in target lengths, that guide the iterations; 0: none do. Where a policy has a say in what is split and
// collapsed, or curves may not be collapsed, nobody knows what would become of one.
template <class Parameters>
double crest_width(const Parameters& parameters, double target)
{
  const bool may_guide = parameters.may_subdivide && parameters.may_collapse_constraints && parameters.does_project && target > 0;
  return may_guide ? parameters.recipe.crest_width : 0.;
}

// That of the parameters; where it was left to the recipe, the one for CAD models, on which curves with many vertices hold needles.
template <class Parameters>
auto split_policy(const Parameters& parameters, const Input_kind& kind)
{
  constexpr double NEEDLE_ANGLE = 3;
  using Policy = std::decay_t<decltype(parameters.split_policy)>;
  if constexpr (std::is_same<Policy, Inter_angle_split_policy<>>::value)
    if (parameters.may_subdivide && kind.is_cad) return Policy(90, Permit_all(), 2, NEEDLE_ANGLE);
  return parameters.split_policy;
}

// How far apart corners of features may be, in target lengths, that are given up; 0: none are. A vertex that the user holds is one of
// theirs as a corner is.
template <class Parameters>
double release_distance(const Parameters& parameters, const Input_kind& kind)
{
  constexpr double OF_JAGGED_CREASES = 0.3;
  const bool may_release = kind.searches_features && !kind.is_cad &&
                           std::is_same<std::decay_t<decltype(parameters.vertex_is_constrained_map)>, No_map>::value;
  return may_release ? OF_JAGGED_CREASES : 0.;
}

// Whether curves hold details that the target length must fall to. One much under the length of the input's edges finds none.
inline bool has_details_smaller_than(double target, const Input_curves& curves, double mean_length)
{
  constexpr double SMALL = 0.5;
  return target > SMALL * mean_length && curves.have_last_edges_under(SMALL * target, CURVE_TOLERANCE * target);
}

// What the parameters permit the passes to do. Where vertices are kept, nothing is split or collapsed.
template <class TriangleMesh, class Parameters>
void set_rules(Remeshing_context& context, const Parameters& parameters, const Input_kind& kind,
               const std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor>& input_vertices)
{
  const auto rule = [&](const auto& policy, bool is_never) {
    return is_never ? Edge_rule(false) : make_edge_rule(policy, input_vertices, boost::graph_traits<TriangleMesh>::null_vertex());
  };
  context.split_rule = rule(split_policy(parameters, kind), context.keeps_vertices);
  context.collapse_rule = rule(parameters.collapse_policy, context.keeps_vertices);
  context.flip_rule = rule(parameters.flip_policy, false);
  if constexpr (!std::is_same<std::decay_t<decltype(parameters.allow_move_functor)>, No_map>::value) {
    using Point_3 = typename boost::property_traits<decltype(parameters.vertex_point_map)>::value_type;
    context.move_rule = make_move_rule<Point_3>(parameters.allow_move_functor, input_vertices,
                                                boost::graph_traits<TriangleMesh>::null_vertex());
  }
  context.may_collapse_constraints = parameters.may_collapse_constraints;
  context.may_subdivide = parameters.may_subdivide && !context.move_rule.is_given();
  context.release_distance = release_distance(parameters, kind);
}

// What there is to report when nothing has been done yet.
template <class ConcurrencyTag>
Remeshing_report untouched_report(const Remeshing_mesh& mesh, double target)
{
  Remeshing_report report;
  report.input_faces = report.output_faces = mesh.number_of_live_faces();
  report.target_edge_length = mesh.unit() * target;
  report.angles_before = report.angles_after = angle_summary<ConcurrencyTag>(mesh);
  return report;
}

// The user's mesh becomes the result, its marks and attributes with it.
template <class Exchange, class TriangleMesh, class Parameters, class Patches, class Attributes>
void write_result(Exchange& exchange, const Remeshing_mesh& mesh, TriangleMesh& tmesh, const Parameters& parameters,
                  const Patches& patches, Attributes& attributes)
{
  std::vector<typename boost::graph_traits<TriangleMesh>::edge_descriptor> forgotten;
  exchange.write(mesh, [&](const auto& edge) { forget_constraint(parameters.edge_is_constrained_map, edge, forgotten); },
                 [&]() { remember_constraints(parameters.edge_is_constrained_map, forgotten); });
  write_constraints(exchange, mesh, tmesh, parameters.edge_is_constrained_map, parameters.face_patch_map, patches);
  if (attributes.are_carried()) attributes.write(mesh);
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
  const Remeshing_report untouched = untouched_report<Concurrency>(exchange.mesh(), target);
  if (parameters.schedule.iterations == 0) return untouched;
  parameters.schedule.wanted_faces = wanted.faces;

  mark_constraints(exchange, tmesh, parameters.edge_is_constrained_map, parameters.vertex_is_constrained_map,
                   parameters.face_patch_map, parameters.constraint_settings);
  const double mean_length = total_length / (1.5 * double(exchange.input_faces().size()));
  const bool is_looked_at = keeps_surface<Parameters>() && parameters.recipe.surface != Recipe::Surface::paper;
  const Input_kind kind = find_and_mark_features(exchange.mesh(), is_looked_at ? exchange.wider_mesh() : Wider_mesh(), wanted, mean_length,
                                                 is_looked_at, crest_width(parameters, target), parameters.recipe,
                                                 parameters.constraint_settings);
  const auto patches = read_patches(parameters.face_patch_map, exchange.input_faces());
  Remeshing_mesh mesh = exchange.take_mesh(parameters.recipe.split_rim && !parameters.constraint_settings.protect);
  settle_corners(mesh, kind, wanted, may_merge_curve_vertices(parameters, kind) ? parameters.recipe.merging_distance : 0.);
  mesh.renumber<ConcurrencyTag>(morton_order(mesh));
  // Without a length nothing is split or collapsed; steps and distances are measured against the edges that there are.
  const bool keeps_vertices = !(target > 0);
  if (keeps_vertices) target = mean_length;
  Input_curves curves(mesh);
  const bool has_small_details = !keeps_vertices &&
                                 (kind.is_cad || (!parameters.constraint_settings.protect &&
                                                  has_details_smaller_than(target, curves, mean_length)));

  Attribute_exchange attributes(parameters.visitor, exchange, tmesh, mesh);
  bool is_to_be_written = true;
  Remeshing_report report = run_with_projector(parameters, exchange, mesh, kind, curves, wanted,
                                               [&](const Projection& projector, const auto&... restore) {
    std::optional<Input_locator> locator;
    if (wanted.sizing.needs_places() || attributes.are_carried()) locator.emplace(projector, mesh);
    Remeshing_context context(mesh, exchange.surroundings(), parameters.recipe, curves, wanted.sizing, projector, parameters.visitor, target);
    context.keeps_vertices = keeps_vertices;
    set_rules<TriangleMesh>(context, parameters, kind, exchange.input_vertices());
    context.grading_rate = has_small_details ? parameters.recipe.grading : 0.;
    context.may_have_necks = !kind.is_cad && !keeps_vertices && wanted.sizing.is_uniform() && parameters.recipe.grading > 0;
    context.noise = noise(kind, mean_length, target);
    if (locator) context.locator = &*locator;
    const Run_result result = run_passes<Concurrency>(context, parameters.schedule, untouched);
    (restore(), ...);
    is_to_be_written = result.has_target_length;
    if (is_to_be_written) exchange.plan_outside_faces(mesh);
    if (is_to_be_written && attributes.are_carried()) attributes.read(mesh, *locator);
    return result.report;
  });

  report.features = kind.features;
  report.feature_edges = kind.feature_edges;
  if (is_to_be_written) write_result(exchange, mesh, tmesh, parameters, patches, attributes);
  return report;
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_REMESH_RANGE_H
