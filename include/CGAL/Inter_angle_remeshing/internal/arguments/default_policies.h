// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_ARGUMENTS_DEFAULT_POLICIES_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_ARGUMENTS_DEFAULT_POLICIES_H

#include <CGAL/Inter_angle_remeshing/Policies/Inter_angle_collapse_policy.h>
#include <CGAL/Inter_angle_remeshing/Policies/Inter_angle_flip_policy.h>
#include <CGAL/Inter_angle_remeshing/Policies/Inter_angle_split_policy.h>
#include <CGAL/Inter_angle_remeshing/Recipe.h>

#include <limits>

// The rules that hold where the user hands no policy over: the paper's as printed, or those that were measured to do
// good. The ablation table of the benchmark has the figures.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

inline Inter_angle_split_policy<> default_split_policy(Recipe::Policies policies)
{
  if (policies == Recipe::Policies::paper)
    return Inter_angle_split_policy<>(90, Permit_all(), std::numeric_limits<double>::infinity());
  return Inter_angle_split_policy<>();
}

inline Inter_angle_collapse_policy<> default_collapse_policy(Recipe::Policies policies)
{
  if (policies == Recipe::Policies::paper) return Inter_angle_collapse_policy<>(true, true);
  return Inter_angle_collapse_policy<>();
}

inline Inter_angle_flip_policy<> default_flip_policy(Recipe::Policies policies)
{
  if (policies == Recipe::Policies::paper) return Inter_angle_flip_policy<>(90, 20);
  return Inter_angle_flip_policy<>(180, 180);
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_ARGUMENTS_DEFAULT_POLICIES_H
