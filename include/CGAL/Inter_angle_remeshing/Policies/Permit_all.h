// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_POLICIES_PERMIT_ALL_H
#define CGAL_INTER_ANGLE_REMESHING_POLICIES_PERMIT_ALL_H

namespace CGAL {
namespace Inter_angle_remeshing {

/*!
\ingroup PkgInterAngleRemeshingPolicies

@brief a policy that permits every operation: plain Botsch-Kobbelt remeshing, and the end of a chain of policies
that decorate each other.

\cgalModels{RemeshingPolicy}
*/
struct Permit_all
{
  /// returns `true`.
  template <class Profile>
  bool operator()(const Profile&) const { return true; }
};

} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_POLICIES_PERMIT_ALL_H
