// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_TARGET_EDGE_LENGTH_H
#define CGAL_INTER_ANGLE_REMESHING_TARGET_EDGE_LENGTH_H

#include <CGAL/Inter_angle_remeshing/internal/exchange/flat_copy.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/cross_products.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// n equilateral triangles of edge l cover √3/4 n l²; the remesher was measured to yield as many as if its edges were 5%
// shorter than their target.
inline double length_for_face_count(double area, std::size_t n)
{
  return 1.05 * std::sqrt(4 * area / (std::sqrt(3.) * double(n)));
}

} // namespace internal

/*!
\ingroup PkgInterAngleRemeshingRef

@brief returns the target edge length with which `isotropic_remeshing()` yields about `n` faces.

Source: a surface of area A is covered by F equilateral triangles of edge l = √(4A / (√3 F)); the length is corrected
by what the remesher was measured to yield. Measured on 13 closed surfaces that are refined or keep their number of
faces: within 3%; within 12% where they are coarsened to a sixth. `Face_count` comes nearer, for it steers during the
run. On CAD models, and where borders have small details, `Recipe::grading` adds faces that this length does not know of, up to
several times as many where the target is coarse.
Complexity: linear in the number of faces of the range.

@tparam FaceRange a model of `ConstRange` with the faces of `TriangleMesh` as value type
@tparam TriangleMesh a model of `FaceGraph`
@tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

@param faces the range of triangular faces
@param tmesh the mesh
@param n the wanted number of faces
@param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `tmesh`}
    \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor`
                   as key type and a point type as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
  \cgalParamNEnd
\cgalNamedParamsEnd

@returns a length in the units of the mesh; 0 where the range has no area
@throws CGAL::Precondition_exception if a face is not a triangle, a coordinate is not finite, all points are equal, or
        `n` is 0
*/
template <class FaceRange, class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
double target_edge_length(const FaceRange& faces, const TriangleMesh& tmesh, std::size_t n,
                          const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  constexpr const char* CALLER = "target_edge_length()";
  if (n == 0) internal::refuse(CALLER, "the wanted number of faces is 0");
  const auto vpm = choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                    get_const_property_map(CGAL::vertex_point, tmesh));
  using Vpm = std::decay_t<decltype(vpm)>;
  const auto copy = internal::Flat_copy_builder<TriangleMesh, Vpm>(tmesh, vpm, CALLER).build(faces);
  return copy.mesh.unit() * internal::length_for_face_count(internal::area(copy.mesh), n);
}

} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_TARGET_EDGE_LENGTH_H
