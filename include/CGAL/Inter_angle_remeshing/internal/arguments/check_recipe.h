// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_ARGUMENTS_CHECK_RECIPE_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_ARGUMENTS_CHECK_RECIPE_H

#include <CGAL/Inter_angle_remeshing/Recipe.h>
#include <CGAL/Inter_angle_remeshing/internal/Remeshing_context.h>
#include <CGAL/Inter_angle_remeshing/internal/arguments/refuse.h>

#include <string>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// Vertices that are farther apart, in target lengths, are details.
constexpr double LARGEST_MERGING_DISTANCE = 0.1;

// No fit gains from a tenth of these.
constexpr unsigned MOST_FITS = 100;

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
  if (recipe.fits > MOST_FITS)
    refuse(REMESHING, "Recipe::fits is " + std::to_string(recipe.fits) + "; at most " + std::to_string(MOST_FITS) + " are possible");
  if (!(recipe.lower_angle >= 0 && recipe.lower_angle < 60 && recipe.upper_angle > 60 && recipe.upper_angle <= 180))
    refuse(REMESHING, "Recipe::lower_angle is " + to_text(recipe.lower_angle) + " and Recipe::upper_angle " +
                      to_text(recipe.upper_angle) + "; they must lie in [0, 60) and in (60, 180]");
  const auto check_not_negative = [](double value, const char* name) {
    if (!(value >= 0)) refuse(REMESHING, std::string("Recipe::") + name + " is " + to_text(value) + "; it must not be negative");
  };
  check_not_negative(recipe.grading, "grading");
  check_not_negative(recipe.distance_tolerance, "distance_tolerance");
  check_not_negative(recipe.relief_density, "relief_density");
  check_not_negative(recipe.collapse_tolerance, "collapse_tolerance");
  if (!(recipe.fit_tangential_weight > 0 && recipe.fit_tangential_weight <= 1))
    refuse(REMESHING, "Recipe::fit_tangential_weight is " + to_text(recipe.fit_tangential_weight) + "; it must lie in (0, 1]");
  if (!(recipe.fillet_width >= 0 && recipe.fillet_width <= 1))
    refuse(REMESHING, "Recipe::fillet_width is " + to_text(recipe.fillet_width) + "; it must lie in [0, 1]");
  if (!(recipe.crest_width >= 0 && recipe.crest_width <= 2))
    refuse(REMESHING, "Recipe::crest_width is " + to_text(recipe.crest_width) + "; it must lie in [0, 2]");
  if (!(recipe.merging_distance >= 0 && recipe.merging_distance <= LARGEST_MERGING_DISTANCE))
    refuse(REMESHING, "Recipe::merging_distance is " + to_text(recipe.merging_distance) + "; it must lie in [0, " +
                      to_text(LARGEST_MERGING_DISTANCE) + "]");
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_ARGUMENTS_CHECK_RECIPE_H
