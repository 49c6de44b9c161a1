// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_ISOTROPIC_REMESHING_H
#define CGAL_INTER_ANGLE_REMESHING_ISOTROPIC_REMESHING_H

#if __cplusplus < 201703L && !(defined(_MSVC_LANG) && _MSVC_LANG >= 201703L)
#error "CGAL/Inter_angle_remeshing needs C++17: compile with -std=c++17, or /std:c++17"
#endif

#include <CGAL/Inter_angle_remeshing/Default_visitor.h>
#include <CGAL/Inter_angle_remeshing/Face_count.h>
#include <CGAL/Inter_angle_remeshing/Policies/Inter_angle_collapse_policy.h>
#include <CGAL/Inter_angle_remeshing/Policies/Inter_angle_flip_policy.h>
#include <CGAL/Inter_angle_remeshing/Policies/Inter_angle_split_policy.h>
#include <CGAL/Inter_angle_remeshing/Recipe.h>
#include <CGAL/Inter_angle_remeshing/Remeshing_report.h>
#include <CGAL/Inter_angle_remeshing/internal/arguments/Argument_check.h>
#include <CGAL/Inter_angle_remeshing/internal/remesh_by_parameters.h>
#include <CGAL/Inter_angle_remeshing/target_edge_length.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <type_traits>

namespace CGAL {
namespace Inter_angle_remeshing {

/*!
\ingroup PkgInterAngleRemeshingRef

@brief remeshes a range of triangular faces isotropically: about equilateral triangles, edges of about the target
length, regular valences, on the same surface.

Splits, collapses and flips edges by the rules of inter-angle optimization, and relaxes vertices tangentially; after
every second iteration, and each of the last two, the vertices are pulled back onto the surface. Takes the arguments of
`CGAL::Polygon_mesh_processing::isotropic_remeshing()`.

The mesh is changed in one step at the end. An exception before that, from a refused argument, from a functor of the
user's, or for want of memory, leaves it as it was. Vertices that survive keep their descriptors, and those that were
not moved their points to the last bit. Faces outside of the range are left alone, and the edges between them and the
range are neither split nor collapsed, unless `Recipe::split_rim` is on. Isolated vertices stay, garbage of a `Surface_mesh` is not collected.
The result depends neither on the concurrency tag nor on the number of threads.

Source: X. Zheng and Z. Lv, <em>Isotropic Remeshing with Inter-Angle Optimization</em>, ICIG 2025, arXiv 2507.13641;
M. Botsch and L. Kobbelt, <em>A Remeshing Approach to Multiresolution Modeling</em>, SGP 2004. Complexity: linear in the
number of faces of the range and of the result, per iteration; at vertices with thousands of faces in the square of these.

@tparam ConcurrencyTag `CGAL::Sequential_tag` (default), `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`
@tparam FaceRange a model of `ConstRange` with `boost::graph_traits<TriangleMesh>::%face_descriptor` as value type
@tparam Length a number type, `Face_count`, a class with the member `at(vertex, mesh)` of `PMPSizingField`, a functor
        `FT operator()(const Point_3&) const`, or what `Face_count::scaling()` makes of one of these two
@tparam TriangleMesh a model of `MutableFaceGraph` and `FaceListGraph` whose descriptors are models of `Hashable`
@tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

@param faces the range of triangular faces to be remeshed
@param length the target edge length in the units of the mesh, or `Face_count(n)` for a wanted number of faces in the
       range. With length 0 edges are flipped and vertices moved, and nothing is split or collapsed. Steps and tolerances then scale
       with the mean edge length of the range; policies see no target length. `Recipe::clean_up` off leaves flips and relaxation
       alone, in a tenth to a half of the time. Of a sizing field the member `at(vertex, mesh)` is called for each vertex of the
       range, and nothing else; in between it is interpolated. A functor is called at the vertices as they are at the time,
       concurrently with `Parallel_tag`, and before the first iteration at some thousands of points inside of large faces. Both may be
       handed over by `std::cref`.
@param tmesh the mesh
@param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below; a `Recipe` is
       put at the head of it by `recipe()`

\cgalNamedParamsBegin
  \cgalParamNBegin{number_of_iterations}
    \cgalParamDescription{the largest number of iterations of splits, collapses, flips and relaxation: once one of them does
      hardly anything, two more are made}
    \cgalParamType{a number type; a fraction is dropped}
    \cgalParamDefault{10}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_relaxation_steps}
    \cgalParamDescription{the number of sweeps of relaxation in each iteration; with 0 no vertex moves but onto the surface: what the
      clean-up would do by moving vertices, and coarser levels, are off, too, and edges are flipped for the angles, not for the valences}
    \cgalParamType{a number type; a fraction is dropped}
    \cgalParamDefault{`Recipe::sweeps`, in the last two iterations `Recipe::last_sweeps`}
  \cgalParamNEnd
  \cgalParamNBegin{do_split}
    \cgalParamDescription{whether edges are split: a `bool`, or a policy that is asked for each edge that is too long}
    \cgalParamType{`bool`, or a model of `RemeshingPolicy`}
    \cgalParamDefault{`Inter_angle_split_policy` as `Recipe::policies` has it, on CAD models with a `needle_angle` of 3 degrees}
  \cgalParamNEnd
  \cgalParamNBegin{do_collapse}
    \cgalParamDescription{whether edges are collapsed: a `bool`, or a policy that is asked for each edge that is too short}
    \cgalParamType{`bool`, or a model of `RemeshingPolicy`}
    \cgalParamDefault{`Inter_angle_collapse_policy`, as `Recipe::policies` has it}
  \cgalParamNEnd
  \cgalParamNBegin{do_flip}
    \cgalParamDescription{whether edges are flipped: a `bool`, or a policy that is asked for each edge whose flip would
                          make the valences more regular or, where vertices do not move, the smallest angle of its two faces larger}
    \cgalParamType{`bool`, or a model of `RemeshingPolicy`}
    \cgalParamDefault{`Inter_angle_flip_policy`, as `Recipe::policies` has it}
  \cgalParamNEnd
  \cgalParamNBegin{allow_move_functor}
    \cgalParamDescription{whether a vertex may move from one place to another: asked before each step that a vertex takes, to where
                          it ends, on the surface mostly; called concurrently with `Parallel_tag`. The vertex is one of the input,
                          or a null vertex where it is new. Its points are of the value type of the vertex point map. A step that is denied
                          may be tried again with less of its length; one that was allowed may be taken back. New vertices
                          are put into their places without a question. Coarser levels are off, and edges are flipped for the angles, not
                          for the valences, but for glides. Hand a functor with a state over by `std::ref`.}
    \cgalParamType{a functor `bool operator()(vertex_descriptor, const Point_3&, const Point_3&)`}
    \cgalParamDefault{all moves are allowed}
  \cgalParamNEnd
  \cgalParamNBegin{do_project}
    \cgalParamDescription{whether vertices are pulled back onto a surface; else they stay where tangential steps lead, and fine
                          targets are reached without coarser levels}
    \cgalParamType{bool}
    \cgalParamDefault{`true`}
  \cgalParamNEnd
  \cgalParamNBegin{projection_functor}
    \cgalParamDescription{what pulls vertices back: `Point_3 operator()(const Point_3&) const`, called concurrently with
                          `Parallel_tag`; or, as in %Polygon_mesh_processing, `Point_3 operator()(vertex_descriptor) const`,
                          called by one thread, always with the same vertex of the range, whose point is set for the
                          call and restored in the end: it may read nothing else. `Closest_point_projector` and
                          `MLS_projector` run from warm starts. Hand functors with a state over by `std::ref`.}
    \cgalParamType{a model of `RemeshingProjector`}
    \cgalParamDefault{onto the closest point of the range as it was: on CAD models, uneven facets, alpha wraps of parts
                      and stairs of voxels, where faces have sizes of at most two target lengths, and everywhere if hardly any has more. Where they have
                      three and more, onto the surface of `MLS_projector`; between, onto a smooth blend of both. The size of
                      a face is its mean edge length, but at most 1.7 times its altitude, or that of a higher neighbor}
  \cgalParamNEnd
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{edges that are never flipped. They may be split and collapsed, and their ends slide along the
                          polylines that they form, as `relax_constraints` says; no polyline of the input lies further
                          than 0.05 target lengths from what becomes of it, but where it is too jagged for that. After
                          the call the map, if it can be written, is right for every edge of the range.}
    \cgalParamType{a class model of `ReadWritePropertyMap` (or `ReadablePropertyMap`) with
                   `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as value type}
    \cgalParamDefault{the features that `detect_features()` finds, with the target length as `scale`, unless `sharpness_angle` is given,
                      or the projection functor is one that knows no surface, or with `Recipe::paper()`. If the input is not a CAD model,
                      two corners on them that are closer than 0.3 target lengths, beside a face with an angle of less than 20 degrees,
                      are given up before the last iterations, unless `vertex_is_constrained_map` is given}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_is_constrained_map}
    \cgalParamDescription{vertices that are kept and not moved, to the last bit}
    \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor`
                   as key type and `bool` as value type}
    \cgalParamDefault{no vertex is constrained}
  \cgalParamNEnd
  \cgalParamNBegin{face_patch_map}
    \cgalParamDescription{patches whose borders are constrained edges. Where a border zigzags from edge to edge on a smooth
                          surface, as labels of faces leave it, it may lie half a target length from the result's. After the
                          call the map, if it can be written, has the patch of each face of the range.}
    \cgalParamType{a class model of `ReadWritePropertyMap` with `boost::graph_traits<TriangleMesh>::%face_descriptor` as
                   key type and a copyable type that can be compared for equality as value type}
    \cgalParamDefault{one patch}
  \cgalParamNEnd
  \cgalParamNBegin{sharpness_angle}
    \cgalParamDescription{edges whose faces' normals differ by more than this angle, in degrees, are constrained, beside
                          those of `edge_is_constrained_map`; 180: none}
    \cgalParamType{a number type}
    \cgalParamDefault{see `edge_is_constrained_map`}
  \cgalParamNEnd
  \cgalParamNBegin{protect_constraints}
    \cgalParamDescription{whether constrained edges and the border are neither split nor collapsed, and their ends stay;
                          features that are found by themselves are not protected}
    \cgalParamType{bool}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{collapse_constraints}
    \cgalParamDescription{whether constrained edges and edges of the border may be collapsed; features that are found by themselves
                          may be in any case}
    \cgalParamType{bool}
    \cgalParamDefault{`true`}
  \cgalParamNEnd
  \cgalParamNBegin{relax_constraints}
    \cgalParamDescription{whether vertices of the input on constrained edges, found features included, and on the border
                          slide along the polylines that these form. With `false` they stay where they are or are
                          collapsed; vertices that are made there slide all the same. Corners never move: ends and
                          junctions of polylines, and turns of 45 degrees and more (see Section \ref iarCurves).}
    \cgalParamType{bool}
    \cgalParamDefault{`true`, other than in %Polygon_mesh_processing: triangles beside curves are as good as elsewhere}
  \cgalParamNEnd
  \cgalParamNBegin{callback}
    \cgalParamDescription{called after each pass with the progress in [0, 1], at last with 1. If it returns `false`, the run stops, and the
                          mesh holds the result so far; before the finest level of a run that began on a coarser one
                          (`Recipe::multi_level`) it is unchanged.}
    \cgalParamType{convertible to `std::function<bool(double)>`}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{told about every pass and operation, and where on the input each vertex and face of the result comes from,
                          see `Attribute_transfer`; handed over by `std::ref` where it has a state}
    \cgalParamType{a model of `RemeshingVisitor`}
    \cgalParamDefault{`Default_visitor`}
  \cgalParamNEnd
  \cgalParamNBegin{verbose}
    \cgalParamDescription{whether each iteration, each finer level, and the result print a line to `std::cout`}
    \cgalParamType{bool}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices}
    \cgalParamType{a class model of `ReadWritePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor`
                   as key type and a point with coordinates `x()`, `y()`, `z()`, made from three of them, as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
    \cgalParamExtra{Computation is in double precision, whatever the kernel.}
  \cgalParamNEnd
  \cgalParamNBegin{geom_traits}
    \cgalParamDescription{accepted for compatibility; the points' own coordinates are all that is used}
    \cgalParamType{any}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{face_index_map}
    \cgalParamDescription{accepted for compatibility; no index maps are needed}
    \cgalParamType{any}
    \cgalParamDefault{none}
  \cgalParamNEnd
\cgalNamedParamsEnd

@returns what was done

@throws CGAL::Precondition_exception, in release builds too and before anything is changed, if: a face of the range is
        not a triangle, or none of the mesh's (a mesh whose elements have no numbers tells that where the range has at least an eighth of
        its faces); it has more than 268 million faces; a coordinate, or the extent of the range, is not finite; all
        points are equal; `length` is negative, not finite, or so small that the result could not be indexed (about 350
        million faces) or less than four times the distance between numbers in double precision as large as the coordinates, or
        as a field is 0, negative, not finite or too small anywhere; the surface of the projection functor is so large that the result could
        not be indexed; the wanted number of faces is 0 or could not be indexed, or the range has no area for it; a vertex has more than 16383 faces; two edges of a
        face are one; two protected edges join the same vertices; a member of the recipe, `sharpness_angle` or a number of iterations or
        relaxation steps is out of its range; or `Recipe::Surface::paper` is asked for without Eigen
@throws CGAL::Postcondition_exception if the projection functor returns a point that is not finite, or further away than
        10<sup>100</sup> times the extent of the range; nothing is changed
@throws whatever a policy, projector, visitor, callback or property map of the user's throws
*/
template <class ConcurrencyTag = CGAL::Sequential_tag, class FaceRange, class Length, class TriangleMesh,
          typename CGAL_NP_TEMPLATE_PARAMETERS
#ifndef DOXYGEN_RUNNING
          , std::enable_if_t<!internal::Is_named_parameters<TriangleMesh>::value &&
                             !internal::Is_mutable_face_graph<Length>::value, int> = 0
#endif
          >
Remeshing_report isotropic_remeshing(const FaceRange& faces, const Length& length, TriangleMesh& tmesh,
                                     const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  if constexpr (internal::Argument_check<ConcurrencyTag, FaceRange, Length, TriangleMesh, CGAL_NP_CLASS>::IS_PASSED)
    return internal::remesh_by_parameters<ConcurrencyTag>(faces, length, tmesh, np);
  else return {};
}

/*!
\ingroup PkgInterAngleRemeshingRef

@brief the same for all faces of the mesh.
*/
template <class ConcurrencyTag = CGAL::Sequential_tag, class Length, class TriangleMesh,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
Remeshing_report isotropic_remeshing(const Length& length, TriangleMesh& tmesh,
                                     const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  if constexpr (internal::Mesh_check<TriangleMesh>::IS_PASSED)
    return isotropic_remeshing<ConcurrencyTag>(faces(tmesh), length, tmesh, np);
  else return {};
}

#ifndef DOXYGEN_RUNNING
// What else may stand in the place of the named parameters: nothing, with a range or without one.
template <class ConcurrencyTag = CGAL::Sequential_tag, class FaceRange, class Length, class TriangleMesh, class Other,
          std::enable_if_t<!internal::Is_named_parameters<TriangleMesh>::value && !internal::Is_named_parameters<Other>::value, int> = 0>
Remeshing_report isotropic_remeshing(const FaceRange&, const Length&, TriangleMesh&, const Other&)
{
  (void)internal::Parameters_check<Other>::IS_PASSED;
  return {};
}
template <class ConcurrencyTag = CGAL::Sequential_tag, class Length, class TriangleMesh, class Other,
          std::enable_if_t<internal::Is_mutable_face_graph<TriangleMesh>::value && !internal::Is_named_parameters<Other>::value, int> = 0>
Remeshing_report isotropic_remeshing(const Length&, TriangleMesh&, const Other&)
{
  (void)internal::Parameters_check<Other>::IS_PASSED;
  return {};
}
#endif

} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_ISOTROPIC_REMESHING_H
