// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_PROJECTION_CLOSEST_POINT_PROJECTOR_H
#define CGAL_INTER_ANGLE_REMESHING_PROJECTION_CLOSEST_POINT_PROJECTOR_H

#include <CGAL/Inter_angle_remeshing/internal/exchange/whole_surface.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/Reference_surface.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/property_map/property_map.hpp>

#include <memory>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {

/*!
\ingroup PkgInterAngleRemeshingProjection

@brief projects onto the closest point of a triangle mesh, as `CGAL::Polygon_mesh_processing` does.

The projector holds a const copy of the surface as it is at construction; the mesh may change afterwards. It is handed
over to `isotropic_remeshing()` by `projection_functor(std::ref(projector))`, where every query starts from the face
that the vertex was projected onto last. If what is remeshed is the mesh as it was, or a range of its faces, it is known for the
input: vertices stay in the range, and in their patches between features, and large distances are lowered. It can be used
alone, too, and as the projection functor of `CGAL::Polygon_mesh_processing::isotropic_remeshing()`, which must then run
on the mesh that the projector was built from, at its place in memory: a point map of `CGAL::Surface_mesh` is void once
another mesh is assigned to it.

All queries are const and may run concurrently. One without a known place takes O(log n) on the average, by an
`AABB_tree` that the first such query builds.

@tparam TriangleMesh a model of `FaceListGraph`
@tparam VertexPointMap a model of `ReadablePropertyMap` with the vertices of `TriangleMesh` as key type and a point of a
        \cgal kernel as value type

\cgalModels{RemeshingProjector}
*/
template <class TriangleMesh,
          class VertexPointMap = typename boost::property_map<TriangleMesh, CGAL::vertex_point_t>::const_type>
class Closest_point_projector
{
  using Index = internal::Corner_table::Index;
  using Vector3 = internal::Vector3;

public:
  /// a vertex of the mesh
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  /// a point
  using Point_3 = typename boost::property_traits<VertexPointMap>::value_type;
  /// a vector
  using Vector_3 = typename CGAL::Kernel_traits<Point_3>::Kernel::Vector_3;

  /// copies the surface of `tmesh`, in time linear in its number of faces.
  /// @param tmesh a triangle mesh; it must outlive the projector only where `operator()(vertex_descriptor)` is used
  /// @param vpm the points of its vertices
  /// @throws CGAL::Precondition_exception if `tmesh` has no face or one that is not a triangle, if a coordinate is not
  ///         finite, or if all points are equal
  explicit Closest_point_projector(const TriangleMesh& tmesh, VertexPointMap vpm)
    : vpm_(vpm), surface_(std::make_shared<const internal::Reference_surface>(
                   internal::copy_whole_surface(tmesh, vpm, "Closest_point_projector::Closest_point_projector()").mesh))
  {}

  /// the same with the mesh's own points.
  explicit Closest_point_projector(const TriangleMesh& tmesh)
    : Closest_point_projector(tmesh, get(CGAL::vertex_point, tmesh))
  {}

  /// returns the point of the surface closest to `p`.
  Point_3 project(const Point_3& p) const { return project(p, Vector3()); }

  /// returns the point closest to `p` on the part of the surface that looks the same way as `normal`: where two
  /// sheets lie near each other, the one whose normal makes less than 90 degrees with it wins over the nearer one.
  /// Where there is no such part near by, the closest point of all.
  Point_3 project(const Point_3& p, const Vector_3& normal) const { return project(p, internal::to_vector3(normal)); }

  /// returns `project()` of the point that `v` has now, in the live mesh or point map.
  Point_3 operator()(vertex_descriptor v) const { return project(get(vpm_, v)); }

#ifndef DOXYGEN_RUNNING
  const internal::Reference_surface& reference_surface() const { return *surface_; }
#endif

private:
  Point_3 project(const Point_3& p, const Vector3& normal) const
  {
    const double unit = surface_->unit();
    Index f = 0;
    const Vector3 q = unit * surface_->locate(internal::to_vector3(p, unit), f, normal);
    return Point_3(q.x, q.y, q.z);
  }

  VertexPointMap vpm_;
  std::shared_ptr<const internal::Reference_surface> surface_;   // shared by copies of the projector
};

} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_PROJECTION_CLOSEST_POINT_PROJECTOR_H
