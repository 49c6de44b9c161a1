// Copyright (c) 2026 The Inter_angle_remeshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgInterAngleRemeshingConcepts
\cgalConcept

The concept `RemeshingProjector` describes what pulls vertices back onto a surface: it is the type of the named
parameter `projection_functor` of `CGAL::Inter_angle_remeshing::isotropic_remeshing()`.

A model offers at least one of the two operators below; where it offers both, the one that takes a point is called.
The one that takes a vertex is that of `CGAL::Polygon_mesh_processing::isotropic_remeshing()`, so that functors written
for that function work here; but a generic lambda is asked for a point, and one of vertices must name their type.

A vertex is projected several times in an iteration. So what a functor returns should hardly move when it is projected again, and
neighbors should stay neighbors: with noise of a third of the target length that is added anew in each call, edges become long, are
split, and become long again, and the number of faces grows without end.

A functor that is handed over is copied, several times; hand large ones and those with a state over by `std::ref()`.
An exception ends the run, passes through, and leaves the user's mesh as it was; so does a
`CGAL::Postcondition_exception` that is thrown where a functor returns a point that is not finite, or further away than
10<sup>100</sup> times the extent of the range.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Inter_angle_remeshing::Closest_point_projector}
\cgalHasModels{CGAL::Inter_angle_remeshing::MLS_projector}
\cgalHasModels{CGAL::Inter_angle_remeshing::Point_set_MLS_projector}
\cgalHasModelsEnd
*/
class RemeshingProjector
{
public:
  /// a point, the value type of the vertex point map
  typedef unspecified_type Point_3;

  /// a vertex of the user's mesh
  typedef unspecified_type vertex_descriptor;

  /*!
  returns where a vertex at `p` belongs.

  Called by several threads at once with `CGAL::Parallel_tag`.
  */
  Point_3 operator()(const Point_3& p) const;

  /*!
  returns where the vertex `v` belongs.

  Called by one thread at a time, whatever the concurrency tag. The point of `v` in the vertex point map is the one to
  be projected. `v` is the same vertex of the range in every call, and gets its own point back before the mesh is
  changed; so the functor may read the point of `v`, and nothing else of `v` or of the mesh.
  */
  Point_3 operator()(vertex_descriptor v) const;
};
