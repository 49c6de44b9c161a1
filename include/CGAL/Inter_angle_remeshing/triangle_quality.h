// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_TRIANGLE_QUALITY_H
#define CGAL_INTER_ANGLE_REMESHING_TRIANGLE_QUALITY_H

#include <CGAL/Inter_angle_remeshing/Inter_angle_statistics.h>
#include <CGAL/Inter_angle_remeshing/internal/measures/Angle_accumulator.h>
#include <CGAL/Inter_angle_remeshing/internal/measures/forced_faces.h>
#include <CGAL/Inter_angle_remeshing/internal/measures/triangle_coordinates.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <iterator>
#include <type_traits>
#include <unordered_set>

namespace CGAL {
namespace Inter_angle_remeshing {

namespace internal {
namespace measures {

// The valence of the target of `h`, or 0 if a face around it is missing or not `is_in_range`.
template <class Halfedge, class TriangleMesh, class IsInRange>
std::size_t interior_valence(Halfedge h, const TriangleMesh& tmesh, const IsInRange& is_in_range)
{
  std::size_t valence = 0;
  for (const Halfedge around : CGAL::halfedges_around_target(h, tmesh)) {
    if (CGAL::is_border(around, tmesh) || !is_in_range(face(around, tmesh))) return 0;
    ++valence;
  }
  return valence;
}

template <class FaceRange, class TriangleMesh, class NamedParameters, class IsInRange>
Inter_angle_statistics inter_angle_statistics(const FaceRange& face_range, const TriangleMesh& tmesh,
                                              const NamedParameters& np, const IsInRange& is_in_range)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  const auto vpm = choose_parameter(get_parameter(np, internal_np::vertex_point),
                                    get_const_property_map(CGAL::vertex_point, tmesh));
  const auto ecm = get_parameter(np, internal_np::edge_is_constrained);
  const auto is_on_curve = [&](const auto h) {
    if (CGAL::is_border_edge(h, tmesh)) return true;
    if constexpr (std::is_same<std::decay_t<decltype(ecm)>, internal_np::Param_not_found>::value) return false;
    else return bool(get(ecm, edge(h, tmesh)));
  };
  Angle_accumulator all, unforced;
  std::size_t ordinal = 0;
  for (const auto f : face_range) {
    const Triangle_coordinates corners = checked_triangle(f, ordinal++, "the range", tmesh, vpm);
    all.add(corners);
    if (!is_forced(halfedge(f, tmesh), corners, tmesh, vpm, is_on_curve)) unforced.add(corners);
    // An interior vertex has one halfedge that stands for it, and the face of that is in the range: counted once.
    for (const auto h : CGAL::halfedges_around_face(halfedge(f, tmesh), tmesh))
      if (halfedge(target(h, tmesh), tmesh) == h)
        if (const std::size_t valence = interior_valence(h, tmesh, is_in_range)) all.add_interior_vertex(valence);
  }
  Inter_angle_statistics result = all.result();
  const Inter_angle_statistics rest = unforced.result();
  const bool is_any_left = rest.number_of_faces > 0;
  result.number_of_forced_faces = result.number_of_faces - rest.number_of_faces;
  result.minimum_unforced_angle = is_any_left ? rest.minimum_angle : result.minimum_angle;
  result.maximum_unforced_angle = is_any_left ? rest.maximum_angle : result.maximum_angle;
  result.unforced_average = is_any_left ? rest.average : result.average;
  return result;
}

} // namespace measures
} // namespace internal

/*!
\ingroup PkgInterAngleRemeshingRef

@brief measures the angles of a range of triangles, and the valences of the vertices inside of it.

The mean is the one of Zheng and Lv, *Isotropic Remeshing with Inter-Angle Optimization*, ICIG 2025. Every angle is
computed by `atan2()` from scaled coordinates, with an absolute error of some 10<sup>-14</sup> degrees at any size of
the triangle and for needles as well.

@tparam FaceRange a range of `boost::graph_traits<TriangleMesh>::%face_descriptor`, model of `ConstRange`
@tparam TriangleMesh a model of `FaceListGraph` whose face descriptors are `Hashable`
@tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

@param face_range the faces to measure, each one once
@param tmesh the mesh that has these faces
@param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `tmesh`}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a `Point_3` of any kernel
                   as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
  \cgalParamNEnd
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{edges that are curves beside the border; tells which faces are forced}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as value type}
    \cgalParamDefault{no edge is}
  \cgalParamNEnd
\cgalNamedParamsEnd

@return the statistics, all zero for an empty range

@throw CGAL::Precondition_exception if a face is not a triangle, or has a coordinate that is not finite as a
       `double`; the message names the face by its place in the range, counted from 0. Release builds check this,
       too.

Complexity: linear in the number of faces of the range, in time and memory.
*/
template <class FaceRange, class TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS>
Inter_angle_statistics inter_angle_statistics(const FaceRange& face_range, const TriangleMesh& tmesh,
                                              const CGAL_NP_CLASS& np = parameters::default_values())
{
  using Face = typename boost::graph_traits<TriangleMesh>::face_descriptor;
  const std::unordered_set<Face> members(std::begin(face_range), std::end(face_range));
  const auto is_in_range = [&members](const Face f) { return members.count(f) != 0; };
  return internal::measures::inter_angle_statistics(face_range, tmesh, np, is_in_range);
}

/*!
\ingroup PkgInterAngleRemeshingRef

@brief measures the angles of all faces of a mesh, and the valences of the vertices that are not on its border.

Same as the function above with `faces(tmesh)`, but without any additional memory.
*/
template <class TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS>
Inter_angle_statistics inter_angle_statistics(const TriangleMesh& tmesh,
                                              const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::measures::inter_angle_statistics(faces(tmesh), tmesh, np, [](const auto&) { return true; });
}

} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_TRIANGLE_QUALITY_H
