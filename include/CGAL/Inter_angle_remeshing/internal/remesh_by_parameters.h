// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_REMESH_BY_PARAMETERS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_REMESH_BY_PARAMETERS_H

#include <CGAL/Inter_angle_remeshing/Recipe.h>
#include <CGAL/Inter_angle_remeshing/Remeshing_report.h>
#include <CGAL/Inter_angle_remeshing/internal/arguments/default_policies.h>
#include <CGAL/Inter_angle_remeshing/internal/arguments/named_parameters.h>
#include <CGAL/Inter_angle_remeshing/internal/remesh_range.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// Reads the named parameters of isotropic_remeshing(), nothing else.
template <class ConcurrencyTag, class FaceRange, class Length, class TriangleMesh, class NamedParameters>
Remeshing_report remesh_by_parameters(const FaceRange& faces, const Length& length, TriangleMesh& tmesh, const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  namespace tags = CGAL::internal_np;

  const Recipe recipe = choose_parameter(get_parameter(np, recipe_tag), Recipe());
  auto vpm = choose_parameter(get_parameter(np, tags::vertex_point), get_property_map(CGAL::vertex_point, tmesh));
  auto ecm = or_no_map(get_parameter(np, tags::edge_is_constrained));
  auto vcm = or_no_map(get_parameter(np, tags::vertex_is_constrained));
  auto fpm = or_no_map(get_parameter(np, tags::face_patch));
  auto split = policy_from(get_parameter(np, tags::do_split), default_split_policy(recipe.policies));
  auto collapse = policy_from(get_parameter(np, tags::do_collapse), default_collapse_policy(recipe.policies));
  auto flip = policy_from(get_parameter(np, tags::do_flip), default_flip_policy(recipe.policies));
  auto allow_move = or_no_map(get_parameter(np, tags::allow_move_functor));
  auto projection = or_no_map(get_parameter(np, tags::projection_functor));
  auto given_visitor = get_parameter(np, tags::visitor);
  auto visitor = visitor_from(given_visitor);

  Remeshing_parameters<decltype(vpm), decltype(ecm), decltype(vcm), decltype(fpm), decltype(split),
                       decltype(collapse), decltype(flip), decltype(allow_move), decltype(projection), decltype(visitor)>
    parameters{vpm, ecm, vcm, fpm, split, collapse, flip, allow_move, projection, visitor, recipe,
               Schedule{count_from(choose_parameter(get_parameter(np, tags::number_of_iterations), 10u), "number_of_iterations"), 0,
                        callback_from(get_parameter(np, tags::callback)),
                        bool(choose_parameter(get_parameter(np, tags::verbose), false))},
               Constraint_settings{
                 sharpness_cosine(choose_parameter(get_parameter(np, tags::sharpness_angle), 180)),
                 bool(choose_parameter(get_parameter(np, tags::protect_constraints), false)),
                 bool(choose_parameter(get_parameter(np, tags::relax_constraints), true)),
                 !has_parameter<NamedParameters, tags::edge_is_constrained_t>() &&
                   !has_parameter<NamedParameters, tags::sharpness_angle_t>()},
               bool(choose_parameter(get_parameter(np, tags::collapse_constraints), true)),
               bool(choose_parameter(get_parameter(np, tags::do_project), true)),
               recipe.policies == Recipe::Policies::measured && is_left_to_the_recipe(get_parameter(np, tags::do_split)) &&
                 is_left_to_the_recipe(get_parameter(np, tags::do_collapse)) &&
                 is_left_to_the_recipe(get_parameter(np, tags::do_flip))};
  set_sweeps(parameters.recipe, get_parameter(np, tags::number_of_relaxation_steps));
  const Remeshing_report report = remesh_range<ConcurrencyTag>(faces, length, tmesh, parameters);
  if (report.ending == Remeshing_report::Ending::nothing_to_do) parameters.schedule.tell_end();
  return report;
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_REMESH_BY_PARAMETERS_H
