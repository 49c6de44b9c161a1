// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_UNIFORM_SIZING_FIELD_H
#define CGAL_INTER_ANGLE_REMESHING_UNIFORM_SIZING_FIELD_H

#include <boost/graph/graph_traits.hpp>

namespace CGAL {
namespace Inter_angle_remeshing {

/*!
\ingroup PkgInterAngleRemeshingRef

@brief the same target edge length everywhere: `isotropic_remeshing()` does with it what it does with the number.

For code that hands sizing fields to it; `CGAL::Polygon_mesh_processing::Uniform_sizing_field` of \cgal 6 is taken as well. Of the concept
`PMPSizingField` this class has the member that `isotropic_remeshing()` calls, not those that %Polygon_mesh_processing calls.

@tparam TriangleMesh a model of `FaceGraph`
*/
template <class TriangleMesh>
class Uniform_sizing_field
{
public:
  /// the number type
  using FT = double;

  /// @param length the target edge length, in the units of the mesh
  /// @param tmesh the mesh; it tells the type
  Uniform_sizing_field(FT length, const TriangleMesh& tmesh) : length_(length) { (void)tmesh; }

  /// the target edge length at a vertex
  FT at(typename boost::graph_traits<TriangleMesh>::vertex_descriptor, const TriangleMesh&) const { return length_; }

private:
  FT length_;
};

} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_UNIFORM_SIZING_FIELD_H
