// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_POLICIES_INTER_ANGLE_SPLIT_POLICY_H
#define CGAL_INTER_ANGLE_REMESHING_POLICIES_INTER_ANGLE_SPLIT_POLICY_H

#include <CGAL/Inter_angle_remeshing/Policies/Permit_all.h>

#include <CGAL/number_type_config.h>

#include <cmath>

namespace CGAL {
namespace Inter_angle_remeshing {

/*!
\ingroup PkgInterAngleRemeshingPolicies

@brief the split rule of inter-angle optimization: an edge is not split beside an obtuse angle.

If one of the four angles between the edge and its neighbors is obtuse, a vertex on the edge would leave an even larger
angle behind. Only edges that are about the longest ones of their triangles are split, the longer neighbor first; the
edge's own turn comes when that is done. An edge of more than `yield_ratio` times its target length is split all the
same, so that a mesh much coarser than its target is refined without delay; and so is one beside an angle of less than
`needle_angle`: between two dense curves all edges across are sides of needles, and their turns would come too late.

Source: Zheng and Lv, <em>Isotropic Remeshing with Inter-Angle Optimization</em>, ICIG 2025, the section on edge splitting.

@tparam Base another policy, asked first

\cgalModels{RemeshingPolicy}
*/
template <class Base = Permit_all>
class Inter_angle_split_policy
{
public:
  /// @param maximum_angle the largest angle, in degrees, that may lie beside an edge that is split. 180 turns the rule off.
  /// @param base a policy that must permit the split, too
  /// @param yield_ratio edges longer than this many times their target length are not held back
  /// @param needle_angle edges beside an angle of less than so many degrees are not held back, either; by default, there are none.
  ///        Where the user hands no policy over, 3 on CAD models, but not with `Recipe::Policies::paper`
  explicit Inter_angle_split_policy(double maximum_angle = 90, Base base = Base(), double yield_ratio = 2, double needle_angle = 0)
    : cosine_(maximum_angle < 180 ? std::cos(maximum_angle * (CGAL_PI / 180)) : -2),
      yield_ratio_(yield_ratio), needle_cosine_(needle_angle > 0 ? std::cos(needle_angle * (CGAL_PI / 180)) : 2), base_(base)
  {}

  /// returns whether the edge of `profile` may be split.
  template <class Profile>
  bool operator()(const Profile& profile) const
  {
    return base_(profile) &&
           (profile.minimum_adjacent_cosine() >= cosine_ - TOLERANCE || profile.relative_length() > yield_ratio_ ||
            (needle_cosine_ < 1 && profile.maximum_adjacent_cosine() > needle_cosine_));
  }

private:
  // A right angle that rounding made obtuse is none.
  static constexpr double TOLERANCE = 1e-12;

  double cosine_;
  double yield_ratio_;
  double needle_cosine_;      // more than 1: no angle is that of a needle
  Base base_;
};

} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_POLICIES_INTER_ANGLE_SPLIT_POLICY_H
