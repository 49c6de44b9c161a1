// Copyright (c) 2026 The Inter_angle_remeshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgInterAngleRemeshingConcepts
\cgalConcept

The concept `RemeshingVisitor` describes what is told about the passes and operations of
`CGAL::Inter_angle_remeshing::isotropic_remeshing()`: it is the type of the named parameter `visitor`.

Derive from `CGAL::Inter_angle_remeshing::Default_visitor` and hide the members of interest; a visitor that has a state
is handed over by `std::ref()`, since named parameters are copied.

The mesh that the members see is the one that the remesher works on, a model of `FaceGraph` and not the user's mesh. Its
points are `get(CGAL::vertex_point, mesh)`, of type `CGAL::Simple_cartesian<double>::Point_3`, in the user's units. `Vertex` and
`Halfedge` are its descriptors; they hold until the next operation, no longer. It must not be changed.

All members are called one at a time, whatever the concurrency tag. An exception ends the run, passes through, and
leaves the user's mesh as it was.

Passes that mend what the iterations left, after the last of them, are announced by `start_pass()` and `end_pass()` like
the others, but belong to no iteration. So are up to four passes `Pass::relax` before the first one, by which all vertices go to a
surface far from the mesh, and the passes of the finer levels of a run that began on a coarser one, see
`CGAL::Inter_angle_remeshing::Recipe::multi_level`; where such a run is not good enough, the iterations are made anew, on the
target length, and counted from 0 again.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Inter_angle_remeshing::Default_visitor}
\cgalHasModels{CGAL::Inter_angle_remeshing::Attribute_transfer}
\cgalHasModelsEnd
*/
class RemeshingVisitor
{
public:
  /// called before iteration `i`, counted from 0.
  template <class Mesh>
  void start_iteration(unsigned i, const Mesh& mesh);

  /// called after iteration `i`.
  template <class Mesh>
  void end_iteration(unsigned i, const Mesh& mesh);

  /// called before a pass.
  template <class Mesh>
  void start_pass(CGAL::Inter_angle_remeshing::Pass pass, const Mesh& mesh);

  /// called after a pass that did `count` operations: edges split, collapsed (also by `Pass::clean_up`) or flipped, glides,
  /// vertices that were asked to move, vertices in the spots that `Pass::mend` worked on, vertices that the last displacements of
  /// `Pass::fit` moved, moves and flips of `Pass::polish`, spots where `Pass::distance` lowered the distance, operations of
  /// `Pass::repair`.
  template <class Mesh>
  void end_pass(CGAL::Inter_angle_remeshing::Pass pass, const Mesh& mesh, std::size_t count);

  /// called before the edge of `h` is split. A pass `Pass::subdivide` splits all edges at once: it calls this for each of them
  /// first, and then `after_split()` for the new vertices, in the same order.
  template <class Halfedge, class Mesh>
  void before_split(Halfedge h, const Mesh& mesh);

  /// called after a split; `v` is the new vertex, still at the midpoint of the edge, or on a curve in the middle of the edge's part
  /// of it. It is pulled back onto the surface afterwards, by `Pass::split` at the end of the pass.
  template <class Vertex, class Mesh>
  void after_split(Vertex v, const Mesh& mesh);

  /// called before the source of `h` is merged into its target.
  template <class Halfedge, class Mesh>
  void before_collapse(Halfedge h, const Mesh& mesh);

  /// called after a collapse; `v` is the vertex that was kept.
  template <class Vertex, class Mesh>
  void after_collapse(Vertex v, const Mesh& mesh);

  /// called before the edge of `h` is flipped, by whichever pass. A glide that turns out to be impossible half-way is undone by
  /// flips that are announced, too.
  template <class Halfedge, class Mesh>
  void before_flip(Halfedge h, const Mesh& mesh);

  /// called after a flip; `h` is a half-edge of the new edge.
  template <class Halfedge, class Mesh>
  void after_flip(Halfedge h, const Mesh& mesh);

  /// called for each vertex that is free to move, before a pass `Pass::relax`.
  template <class Vertex, class Mesh>
  void before_move(Vertex v, const Mesh& mesh);

  /// called for each of these vertices after the pass, whether it has moved or not.
  template <class Vertex, class Mesh>
  void after_move(Vertex v, const Mesh& mesh);

  /// \name Attributes
  ///
  /// These members may be missing: those about vertices, those about corners, those about faces, or all. `Vertex`, `Halfedge` and
  /// `Face` are descriptors of the user's mesh. Readers are called when the remesher is done, and the user's mesh still is the input; writers when it is the result.
  /// An exception that a writer throws leaves the result as it is. Elements are numbered from 0, and come in this order.
  /// `CGAL::Inter_angle_remeshing::Attribute_transfer` is a model that has them.
  /// @{

  /// called for vertex number `i` of the result, which lies on the face of the input with these corners and has these barycentric
  /// coordinates there. For a vertex of the input that has not moved, all three are that vertex, and the coordinates 1, 0, 0.
  template <class Vertex>
  void read_vertex(std::size_t i, const std::array<Vertex, 3>& corners, const std::array<double, 3>& coordinates);

  /// called for number `i` of the values that corners of the result have: the corners at a vertex between two curves (borders,
  /// constrained edges, borders of patches, features), or at a vertex on none, have one. They lie on a face of the input, on the same
  /// side of these curves, with these barycentric coordinates at the corners to which the half-edges point.
  template <class Halfedge>
  void read_corner(std::size_t i, const std::array<Halfedge, 3>& corners, const std::array<double, 3>& coordinates);

  /// called for face number `i` of the result, whose centroid lies on face `f` of the input, in the same patch. Numbers after those of the
  /// range are new faces outside of it, see `Recipe::split_rim`: parts of face `f`. Their corners have values of their own, too;
  /// those at a new vertex on the rim are read from the ends of the edge that it divides, with the same coordinates on both sides.
  template <class Face>
  void read_face(std::size_t i, Face f);

  /// called for vertex number `i` of the result, which is `v` now.
  template <class Vertex>
  void write_vertex(std::size_t i, Vertex v);

  /// called for each corner that has value number `i`, the one to which `h` points, of the face of `h`: in the order of the faces.
  template <class Halfedge>
  void write_corner(std::size_t i, Halfedge h);

  /// called for face number `i` of the result, which is `f` now.
  template <class Face>
  void write_face(std::size_t i, Face f);

  /// @}
};
