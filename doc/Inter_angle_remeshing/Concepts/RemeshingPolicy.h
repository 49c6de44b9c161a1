// Copyright (c) 2026 The Inter_angle_remeshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgInterAngleRemeshingConcepts
\cgalConcept

The concept `RemeshingPolicy` describes what permits or forbids one kind of operation of
`CGAL::Inter_angle_remeshing::isotropic_remeshing()`: it is the type of the named parameters `do_split`, `do_collapse`
and `do_flip`, where they are not a `bool`.

An edge comes before the policy when the mechanism has *nominated* it (it is too long, too short, or its flip makes
the valences more regular or, where vertices do not move, an angle larger) and found the operation *legal*: it keeps the
mesh manifold, breaks no constraint and turns no face over. Those are not the policy's business, and it cannot overrule them. After the last iteration, and where a number
of faces is wanted, edges are nominated for what else they could mend: bad angles, folds, distances, the count.

A policy that is handed over is copied; one with a state that matters afterwards is handed over by `std::ref()`.
Generic lambdas are models.

Two requirements come from the order of evaluation. Operations are evaluated ahead of being done, and evaluated anew
only where the surroundings of the edge have changed in between; so the answer must be a function of what the profile
tells, and nothing else, or what the user knows of its input vertices; not their points, one of which a projection
functor that takes vertices may borrow during the run. And with `CGAL::Parallel_tag` several threads ask at once; so the
call must be safe to run concurrently with itself.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Inter_angle_remeshing::Inter_angle_split_policy}
\cgalHasModels{CGAL::Inter_angle_remeshing::Inter_angle_collapse_policy}
\cgalHasModels{CGAL::Inter_angle_remeshing::Inter_angle_flip_policy}
\cgalHasModels{CGAL::Inter_angle_remeshing::Permit_all}
\cgalHasModelsEnd

\sa `CGAL::Inter_angle_remeshing::Edge_profile`
*/
class RemeshingPolicy
{
public:
  /*!
  returns whether the operation on this edge is permitted.

  An exception ends the run, passes through, and leaves the user's mesh as it was.

  @tparam Profile a `CGAL::Inter_angle_remeshing::Edge_profile` of the mesh that the remesher works on, which is not of
          the type of the user's; its points are of type `CGAL::Simple_cartesian<double>::Point_3`
  @param profile the configuration around the edge, in the user's units. For a collapse, its source is the vertex to be
         removed and its target the one to be kept; a refusal is followed by the question about the opposite direction,
         where that is possible.
  */
  template <class Profile>
  bool operator()(const Profile& profile) const;
};
