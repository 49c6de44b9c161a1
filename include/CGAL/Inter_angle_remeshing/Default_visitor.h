// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_DEFAULT_VISITOR_H
#define CGAL_INTER_ANGLE_REMESHING_DEFAULT_VISITOR_H

#include <cstddef>

namespace CGAL {
namespace Inter_angle_remeshing {

/// \ingroup PkgInterAngleRemeshingRef
/// the passes, as a visitor meets them: those of an iteration, those of a run that began on a coarser level
/// (`Recipe::multi_level`), and those of the clean-up
enum class Pass
{
  split,     ///< edges that are too long
  collapse,  ///< edges that are too short
  flip,      ///< for more regular valences or, where vertices do not move, larger angles; in the clean-up, too
  glide,     ///< sequences of flips that bring irregular vertices together
  relax,     ///< vertices move towards the centre of their neighbors, in the clean-up, too
  subdivide, ///< every face is cut into four
  mend,      ///< in the few spots that need it after that, edges are split, collapsed and flipped, and vertices relaxed
  clean_up,  ///< vertices of valence 4 and less are removed
  fit,       ///< faces are fitted to the surface
  polish,    ///< angles move into the band; flips beside borders and features
  distance,  ///< the largest distances are lowered
  repair     ///< flips, collapses and splits where the polish does not reach the band, at folds, and where faces cross others
};

/*!
\ingroup PkgInterAngleRemeshingRef

@brief a visitor that does nothing; derive from it and hide the members of interest, or add those about attributes (see
`RemeshingVisitor`).

The mesh that a visitor sees is a model of `FaceGraph`, the one that the remesher works on inside; its vertex points
are `get(CGAL::vertex_point, mesh)`, in the user's units. Descriptors of it hold until the next operation.
All members are called one at a time, whatever the concurrency tag. An exception that one of them throws ends the run
and leaves the user's mesh as it was.

\cgalModels{RemeshingVisitor}
*/
struct Default_visitor
{
  /// called before iteration `i`, counted from 0.
  template <class Mesh>
  void start_iteration(unsigned /* i */, const Mesh&) {}
  /// called after iteration `i`.
  template <class Mesh>
  void end_iteration(unsigned /* i */, const Mesh&) {}

  /// called before a pass.
  template <class Mesh>
  void start_pass(Pass, const Mesh&) {}
  /// called after a pass, with the number of operations that it did, see `RemeshingVisitor::end_pass()`.
  template <class Mesh>
  void end_pass(Pass, const Mesh&, std::size_t /* count */) {}

  /// called before the edge of `h` is split; in a pass `Pass::subdivide` for all edges before the first of them is.
  template <class Halfedge, class Mesh>
  void before_split(Halfedge, const Mesh&) {}
  /// called after a split; `v` is the new vertex. After a pass `Pass::subdivide` it is called for the new vertices in the order
  /// in which their edges were announced.
  template <class Vertex, class Mesh>
  void after_split(Vertex, const Mesh&) {}

  /// called before the source of `h` is merged into its target.
  template <class Halfedge, class Mesh>
  void before_collapse(Halfedge, const Mesh&) {}
  /// called after a collapse; `v` is the vertex that was kept.
  template <class Vertex, class Mesh>
  void after_collapse(Vertex, const Mesh&) {}

  /// called before the edge of `h` is flipped. A glide that fails half-way undoes its flips by further flips, which
  /// are announced, too.
  template <class Halfedge, class Mesh>
  void before_flip(Halfedge, const Mesh&) {}
  /// called after a flip; `h` is a half-edge of the new edge.
  template <class Halfedge, class Mesh>
  void after_flip(Halfedge, const Mesh&) {}

  /// called for each vertex that is about to be relaxed, before a pass `Pass::relax`.
  template <class Vertex, class Mesh>
  void before_move(Vertex, const Mesh&) {}
  /// called for each vertex that may have been moved, after a pass `Pass::relax`.
  template <class Vertex, class Mesh>
  void after_move(Vertex, const Mesh&) {}
};

} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_DEFAULT_VISITOR_H
