// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_POLICIES_INTER_ANGLE_COLLAPSE_POLICY_H
#define CGAL_INTER_ANGLE_REMESHING_POLICIES_INTER_ANGLE_COLLAPSE_POLICY_H

#include <CGAL/Inter_angle_remeshing/Policies/Permit_all.h>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Inter_angle_remeshing {

/*!
\ingroup PkgInterAngleRemeshingPolicies

@brief the collapse rules of inter-angle optimization: the boundary condition and the degree judgment.

<em>Boundary condition</em>: a collapse is blocked if an end of the edge lies on the border.

<em>Degree judgment</em>: the merged vertex has the valence `Edge_profile::valence_after_collapse()`. A high valence
means a mean angle well under 60 degrees; the collapse is blocked if it takes the mean angle of the merged vertex
further from 60 degrees than the mean angle of the two ends was. (Valences 5 and 6 give 7: 66 degrees become 51,
blocked.) The rule yields to length where the edge is shorter than `yield_ratio` times its target length; without that,
a mesh could not be coarsened by a large factor.

Measured, both rules cost more than they give: the degree judgment leaves short edges standing, hence more faces and
less regular vertices than asked for, and the boundary condition leaves needles along the border. They are off by
default, and on in the constructor's arguments of the paper's preset.

Source: Zheng and Lv, <em>Isotropic Remeshing with Inter-Angle Optimization</em>, ICIG 2025, the section on edge collapse.

@tparam Base another policy, asked first

\cgalModels{RemeshingPolicy}
*/
template <class Base = Permit_all>
class Inter_angle_collapse_policy
{
public:
  /// @param boundary_condition whether edges with an end on the border are left alone
  /// @param degree_judgment whether the merged vertex's mean angle is judged
  /// @param base a policy that must permit the collapse, too
  /// @param yield_ratio edges shorter than this many times their target length are not judged by degree
  explicit Inter_angle_collapse_policy(bool boundary_condition = false, bool degree_judgment = false,
                                       Base base = Base(), double yield_ratio = 0.5)
    : has_boundary_condition_(boundary_condition), has_degree_judgment_(degree_judgment),
      yield_ratio_(yield_ratio), base_(base)
  {}

  /// returns whether the source of `profile` may be merged into its target.
  template <class Profile>
  bool operator()(const Profile& profile) const
  {
    if (!base_(profile)) return false;
    if (has_boundary_condition_ && (profile.is_border(profile.source()) || profile.is_border(profile.target())))
      return false;
    const bool yields = profile.has_target_length() && profile.relative_length() < yield_ratio_;
    return !has_degree_judgment_ || yields || improves_mean_angle(profile);
  }

private:
  template <class Profile>
  static bool improves_mean_angle(const Profile& profile)
  {
    const auto mean_angle = [&](const auto& v) {
      return Profile::mean_angle(profile.valence(v), profile.is_border(v));
    };
    const double before = (mean_angle(profile.source()) + mean_angle(profile.target())) / 2;
    const double after = Profile::mean_angle(profile.valence_after_collapse(), profile.is_border(profile.target()));
    return std::abs(after - 60) <= std::abs(before - 60);
  }

  bool has_boundary_condition_;
  bool has_degree_judgment_;
  double yield_ratio_;
  Base base_;
};

} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_POLICIES_INTER_ANGLE_COLLAPSE_POLICY_H
