// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_POLICIES_INTER_ANGLE_FLIP_POLICY_H
#define CGAL_INTER_ANGLE_REMESHING_POLICIES_INTER_ANGLE_FLIP_POLICY_H

#include <CGAL/Inter_angle_remeshing/Policies/Permit_all.h>

#include <CGAL/number_type_config.h>

#include <cmath>

namespace CGAL {
namespace Inter_angle_remeshing {

/*!
\ingroup PkgInterAngleRemeshingPolicies

@brief the flip rule of inter-angle optimization: a flip must neither make an obtuse angle nor crease the surface.

A flip that improves the valences is blocked if one of the two faces that it makes has an angle over `maximum_angle`,
or if the normals of the two faces that it replaces differ by more than `maximum_dihedral_angle`. The flips of a glide
are judged by the glide as a whole (`Edge_profile::is_transient()`), and only the base policy is asked.

Source: Zheng and Lv, <em>Isotropic Remeshing with Inter-Angle Optimization</em>, ICIG 2025, the section on edge flipping.

@tparam Base another policy, asked first

\cgalModels{RemeshingPolicy}
*/
template <class Base = Permit_all>
class Inter_angle_flip_policy
{
public:
  /// @param maximum_angle the largest angle, in degrees, that a flip may make. 180 turns the rule off.
  /// @param maximum_dihedral_angle the largest angle, in degrees, between the normals of the two faces of an edge that
  ///        is flipped. 180 turns the rule off.
  /// @param base a policy that must permit the flip, too
  explicit Inter_angle_flip_policy(double maximum_angle = 90, double maximum_dihedral_angle = 20, Base base = Base())
    : cosine_(threshold(maximum_angle)), dihedral_cosine_(threshold(maximum_dihedral_angle)), base_(base)
  {}

  /// returns whether the edge of `profile` may be flipped.
  template <class Profile>
  bool operator()(const Profile& profile) const
  {
    if (!base_(profile)) return false;
    if (profile.is_transient()) return true;
    return (dihedral_cosine_ < -1 || profile.dihedral_cosine() >= dihedral_cosine_) &&
           (cosine_ < -1 || profile.minimum_flipped_cosine() >= cosine_ - TOLERANCE);
  }

private:
  // A right angle that rounding made obtuse is none.
  static constexpr double TOLERANCE = 1e-12;

  static double threshold(double angle) { return angle < 180 ? std::cos(angle * (CGAL_PI / 180)) : -2; }

  double cosine_;
  double dihedral_cosine_;
  Base base_;
};

} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_POLICIES_INTER_ANGLE_FLIP_POLICY_H
