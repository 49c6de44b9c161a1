// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_EDGE_PROFILE_H
#define CGAL_INTER_ANGLE_REMESHING_EDGE_PROFILE_H

#include <CGAL/Inter_angle_remeshing/internal/geometry/to_vector3.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace CGAL {
namespace Inter_angle_remeshing {

namespace internal {
// target(h, g), called from where a member of the same name hides it.
template <class Halfedge, class Graph>
auto target_vertex(const Halfedge& h, const Graph& g) { return target(h, g); }
} // namespace internal

/*!
\ingroup PkgInterAngleRemeshingPolicies

@brief the configuration around one edge of a triangle mesh: what a policy decides by.

The edge runs from `source()` to `target()`. `left_vertex()` is opposite to it in the face on its left, the face of
`halfedge()`; `right_vertex()` is opposite to it in the face on its right. On the border one of the two faces is
missing. The profile of a collapse has the vertex that would be removed as its source and the one that would be kept
as its target.

Nothing is computed before it is asked for. Each function takes constant time, except that those about valences and borders
may take time proportional to the valence, as the mesh type has it. Lengths are in the user's units, angles in degrees.

A policy must base its decision on the members documented here alone: operations are evaluated beforehand,
concurrently under `Parallel_tag`, and are evaluated anew only if something that these members depend on has changed.

@tparam TriangleMesh a model of `FaceGraph`: the user's own mesh, or the one that the remesher works on inside
@tparam VertexPointMap a model of `ReadablePropertyMap` with the vertices of `TriangleMesh` as key type and a point
        type with coordinates `x()`, `y()` and `z()` as value type
@tparam EdgeIsConstrainedMap a model of `ReadablePropertyMap` with the edges of `TriangleMesh` as key type and `bool`
        as value type
@tparam InputVertexMap a model of `ReadablePropertyMap` from the vertices of `TriangleMesh` to those of the user's mesh
*/
template <class TriangleMesh,
          class VertexPointMap = typename boost::property_map<TriangleMesh, CGAL::vertex_point_t>::const_type,
          class EdgeIsConstrainedMap =
            CGAL::Static_boolean_property_map<typename boost::graph_traits<TriangleMesh>::edge_descriptor, false>,
          class InputVertexMap =
            CGAL::Identity_property_map<typename boost::graph_traits<TriangleMesh>::vertex_descriptor>>
class Edge_profile
{
  using Traits = boost::graph_traits<TriangleMesh>;
  using Vector3 = internal::Vector3;

public:
  /// the mesh
  using Triangle_mesh = TriangleMesh;
  /// a vertex of the mesh
  using vertex_descriptor = typename Traits::vertex_descriptor;
  /// a half-edge of the mesh
  using halfedge_descriptor = typename Traits::halfedge_descriptor;
  /// a point
  using Point_3 = typename boost::property_traits<VertexPointMap>::value_type;
  /// a vertex of the user's mesh
  using Input_vertex_descriptor = typename boost::property_traits<InputVertexMap>::value_type;

  /// the profile of the edge of `h`.
  /// @param h the half-edge from the source to the target of the profile
  /// @param tmesh the mesh; it must outlive the profile
  /// @param vpm the points of the vertices
  /// @param target_length the length that the edge should have, infinite where none is known
  /// @param is_transient see `is_transient()`
  /// @param ecm the constrained edges
  /// @param ivm the vertices of the user's mesh
  /// @param scale the power of two by which coordinates are multiplied before anything is computed from them, so that
  ///        nothing overflows at extreme units
  Edge_profile(halfedge_descriptor h, const TriangleMesh& tmesh, VertexPointMap vpm,
               double target_length = std::numeric_limits<double>::infinity(), bool is_transient = false,
               EdgeIsConstrainedMap ecm = EdgeIsConstrainedMap(), InputVertexMap ivm = InputVertexMap(),
               double scale = 1)
    : halfedge_(h), tmesh_(&tmesh), vpm_(vpm), ecm_(ecm), ivm_(ivm), target_length_(target_length), scale_(scale),
      is_transient_(is_transient)
  {}

  /// \name The edge and the vertices around it
  /// @{

  /// the mesh that the edge belongs to
  const TriangleMesh& mesh() const { return *tmesh_; }
  /// the half-edge from `source()` to `target()`
  halfedge_descriptor halfedge() const { return halfedge_; }
  /// the first end of the edge; in a collapse the vertex that would be removed
  vertex_descriptor source() const { return target_of(opposite_halfedge()); }
  /// the second end of the edge; in a collapse the vertex that would be kept
  vertex_descriptor target() const { return target_of(halfedge_); }
  /// whether the edge has a face on its left
  bool has_left_face() const { return has_face(halfedge_); }
  /// whether the edge has a face on its right
  bool has_right_face() const { return has_face(opposite_halfedge()); }
  /// the vertex opposite to the edge in its left face. \pre `has_left_face()`
  vertex_descriptor left_vertex() const { return apex_of(halfedge_); }
  /// the vertex opposite to the edge in its right face. \pre `has_right_face()`
  vertex_descriptor right_vertex() const { return apex_of(opposite_halfedge()); }
  /// the point of the vertex `v`
  Point_3 point(vertex_descriptor v) const { return get(vpm_, v); }
  /// the vertex of the user's mesh that `v` is; the null vertex if `v` was made by a split
  Input_vertex_descriptor input_vertex(vertex_descriptor v) const { return get(ivm_, v); }

  /// @}
  /// \name Status
  /// @{

  /// whether the edge lies on the border
  bool is_border() const { return !has_left_face() || !has_right_face(); }
  /// whether the edge is constrained
  bool is_constrained() const { return get(ecm_, edge(halfedge_, *tmesh_)); }
  /// whether the vertex `v` lies on the border
  bool is_border(vertex_descriptor v) const { return bool(CGAL::is_border(v, *tmesh_)); }
  /// whether the operation is one of a sequence that is judged as a whole: the flips of a glide, of which one alone
  /// may well make a bad triangle that the next ones mend
  bool is_transient() const { return is_transient_; }

  /// @}
  /// \name Lengths
  /// @{

  /// the length of the edge, in the user's units
  double length() const { return internal::length(position(target()) - position(source())) / scale_; }
  /// the target length, or what the sizing field says for the edge, in the user's units; infinite where none is known. What
  /// `Recipe::grading` takes off near details of borders and features is not taken off here.
  double target_length() const { return target_length_; }
  /// whether a target length is known
  bool has_target_length() const { return std::isfinite(target_length_); }
  /// `length()` divided by `target_length()`; 0 where that is not known
  double relative_length() const { return length() / target_length_; }

  /// @}
  /// \name Angles, in degrees
  /// @{

  /// the angles at `source()` and at `target()` in the left face, then those in the right face;
  /// 0 in place of those of a missing face
  std::array<double, 4> adjacent_angles() const { return in_degrees(adjacent_cosines()); }
  /// the largest of `adjacent_angles()`
  double maximum_adjacent_angle() const { return degrees(smallest(adjacent_cosines())); }
  /// the smallest of `adjacent_angles()`, without those of a missing face
  double minimum_adjacent_angle() const { return degrees(maximum_adjacent_cosine()); }
  /// the angles at `left_vertex()` and at `right_vertex()`; 0 in place of that of a missing face
  std::array<double, 2> opposite_angles() const { return in_degrees(opposite_cosines()); }
  /// the angle between the normals of the two faces: 0 where the surface is flat, and on the border;
  /// 180 where one face has no normal
  double dihedral_angle() const;

  /// @}
  /// \name After a flip
  /// The edge would run from `left_vertex()` to `right_vertex()`.
  /// \pre not `is_border()`
  /// @{

  /// the six angles of the two faces: at the right, the source and the left vertex in the face beside the source,
  /// then at the left, the target and the right vertex in the face beside the target
  std::array<double, 6> flipped_angles() const { return in_degrees(flipped_cosines()); }
  /// the largest of `flipped_angles()`
  double maximum_flipped_angle() const { return degrees(smallest(flipped_cosines())); }

  /// @}
  /// \name Valences
  /// @{

  /// the number of edges at `v`
  std::size_t valence(vertex_descriptor v) const { return degree(v, *tmesh_); }
  /// how many edges `v` has more than a regular vertex: 6, or 4 on the border
  int valence_deviation(vertex_descriptor v) const { return int(valence(v)) - (is_border(v) ? 4 : 6); }
  /// the number of edges that `target()` would have if `source()` were merged into it
  std::size_t valence_after_collapse() const
  {
    return valence(source()) + valence(target()) - (is_border() ? 3 : 4);
  }
  /// the mean of the angles of a vertex, if they filled a flat neighborhood: 360 degrees (180 on the border)
  /// over the number of faces
  static double mean_angle(std::size_t valence, bool is_on_border)
  {
    return is_on_border ? 180. / double((std::max)(valence, std::size_t(2)) - 1)
                        : 360. / double((std::max)(valence, std::size_t(1)));
  }

  /// @}

#ifndef DOXYGEN_RUNNING
  // The same angles by their cosines, for thresholds that need no arc cosine: -1 is 180 degrees, 1 is 0 degrees.
  double minimum_adjacent_cosine() const { return smallest(adjacent_cosines()); }
  double maximum_adjacent_cosine() const
  {
    const std::array<double, 4> cosines = adjacent_cosines();
    double result = -1;
    if (has_left_face()) result = (std::max)({result, cosines[0], cosines[1]});
    if (has_right_face()) result = (std::max)({result, cosines[2], cosines[3]});
    return result;
  }
  double minimum_flipped_cosine() const { return smallest(flipped_cosines()); }
  double dihedral_cosine() const;
#endif

private:
  halfedge_descriptor opposite_halfedge() const { return opposite(halfedge_, *tmesh_); }
  vertex_descriptor target_of(halfedge_descriptor h) const { return internal::target_vertex(h, *tmesh_); }
  vertex_descriptor apex_of(halfedge_descriptor h) const { return target_of(next(h, *tmesh_)); }
  bool has_face(halfedge_descriptor h) const { return face(h, *tmesh_) != Traits::null_face(); }

  Vector3 position(vertex_descriptor v) const
  {
    return scale_ * internal::to_vector3(get(vpm_, v));
  }

  std::array<double, 4> adjacent_cosines() const;
  std::array<double, 2> opposite_cosines() const;
  std::array<double, 6> flipped_cosines() const;

  static double degrees(double cosine)
  {
    return std::acos((std::max)(-1., (std::min)(1., cosine))) * (180 / CGAL_PI);
  }
  template <std::size_t n>
  static std::array<double, n> in_degrees(std::array<double, n> cosines)
  {
    for (double& c : cosines) c = degrees(c);
    return cosines;
  }
  template <std::size_t n>
  static double smallest(const std::array<double, n>& values)
  {
    return *std::min_element(values.begin(), values.end());
  }

  halfedge_descriptor halfedge_;
  const TriangleMesh* tmesh_;
  VertexPointMap vpm_;
  EdgeIsConstrainedMap ecm_;
  InputVertexMap ivm_;
  double target_length_;
  double scale_;
  bool is_transient_;
};

template <class TM, class VPM, class ECM, class IVM>
std::array<double, 4> Edge_profile<TM, VPM, ECM, IVM>::adjacent_cosines() const
{
  using internal::corner_cosine;
  const Vector3 s = position(source()), t = position(target());
  std::array<double, 4> cosines = {1, 1, 1, 1};
  if (has_left_face()) {
    const Vector3 l = position(left_vertex());
    cosines[0] = corner_cosine(s, t, l);
    cosines[1] = corner_cosine(t, l, s);
  }
  if (has_right_face()) {
    const Vector3 r = position(right_vertex());
    cosines[2] = corner_cosine(s, r, t);
    cosines[3] = corner_cosine(t, s, r);
  }
  return cosines;
}

template <class TM, class VPM, class ECM, class IVM>
std::array<double, 2> Edge_profile<TM, VPM, ECM, IVM>::opposite_cosines() const
{
  const Vector3 s = position(source()), t = position(target());
  return {has_left_face() ? internal::corner_cosine(position(left_vertex()), s, t) : 1.,
          has_right_face() ? internal::corner_cosine(position(right_vertex()), s, t) : 1.};
}

template <class TM, class VPM, class ECM, class IVM>
std::array<double, 6> Edge_profile<TM, VPM, ECM, IVM>::flipped_cosines() const
{
  using internal::corner_cosine;
  const Vector3 s = position(source()), t = position(target());
  const Vector3 l = position(left_vertex()), r = position(right_vertex());
  return {corner_cosine(r, l, s), corner_cosine(s, r, l), corner_cosine(l, s, r),
          corner_cosine(l, r, t), corner_cosine(t, l, r), corner_cosine(r, t, l)};
}

#ifndef DOXYGEN_RUNNING
template <class TM, class VPM, class ECM, class IVM>
double Edge_profile<TM, VPM, ECM, IVM>::dihedral_cosine() const
{
  if (is_border()) return 1;
  const Vector3 s = position(source()), t = position(target());
  // Of unit edges: only their own squares must be finite, which the scale sees to.
  const Vector3 edge = internal::unit(t - s);
  const Vector3 left = internal::unit(internal::cross(edge, internal::unit(position(left_vertex()) - s)));
  const Vector3 right = internal::unit(internal::cross(internal::unit(position(right_vertex()) - s), edge));
  return left == Vector3() || right == Vector3() ? -1. : internal::dot(left, right);
}
#endif

template <class TM, class VPM, class ECM, class IVM>
double Edge_profile<TM, VPM, ECM, IVM>::dihedral_angle() const
{
  return degrees(dihedral_cosine());
}

} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_EDGE_PROFILE_H
