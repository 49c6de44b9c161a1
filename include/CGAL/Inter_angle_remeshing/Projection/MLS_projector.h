// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_PROJECTION_MLS_PROJECTOR_H
#define CGAL_INTER_ANGLE_REMESHING_PROJECTION_MLS_PROJECTOR_H

#include <CGAL/Inter_angle_remeshing/internal/exchange/whole_surface.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/Mls_reference.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/property_map/property_map.hpp>

#include <memory>

namespace CGAL {
namespace Inter_angle_remeshing {

/*!
\ingroup PkgInterAngleRemeshingProjection

@brief projects onto a smooth surface through the vertices of a triangle mesh, by moving least squares.

The surface that a mesh stands for is rarely made of facets. Around each vertex a cubic height field is fitted to the
neighbors with weights that fall with their distance; its normals bend the facets into a surface without creases
between them. Where the mesh samples a smooth surface, the error falls with the fourth power of the edge length instead of the
second. The edges that `detect_features()` finds are features: they become smooth curves, the two sides keep their normals,
and corners stay where they are; so does the border. So are edges of 1 degree and more between two plane polygons of which
each has a vertex that belongs to no other polygon, inside of it or on the border: planes that have been designed stay planes.
Faces that touch a fold, an edge of more than 60 degrees, stay flat, and so do the edges of faces over which the surface would
make such an angle with them, as narrow ones that lead from large facets to much smaller ones, and faces over which it would
run through what is close by, another sheet or another part, though the facets do not. So, nearly, do edges that are several
times as long as the faces beside them are wide, as along a cylinder, and faces that are much larger than others around their
corners, as beside a fillet: there the large ones tell the normals. So do plane polygons of two faces or more beside which the
surface curves three times as much one facet further on, as the flats between fillets of few facets, and two of them at a
vertex, as the facets of a cylinder between such fillets.

No point P of the surface is further from its face than 0.15 times the mean edge length of the face; a projection lies
within another 0.3 of these of P, so that a result is never further than 0.45 mean edge lengths from the mesh.

The projector holds const copies; the mesh may change afterwards. It is handed over to `isotropic_remeshing()` by
`projection_functor(std::ref(projector))`, where every query starts from the face that the vertex was projected onto
last, and, if that is this mesh as it was or a range of its faces, vertices stay in the range and in their patches. It can be
used alone, too, and as the projection functor of
`CGAL::Polygon_mesh_processing::isotropic_remeshing()`, which must then run on the mesh that the projector was built
from, at its place in memory.

All queries are const and may run concurrently. One without a known place takes O(log n) on the average, by a `Kd_tree`
of seven points a face (see `Upsampled_point_set`) that the first such query builds.

Source: M. Alexa, J. Behr, D. Cohen-Or, S. Fleishman, D. Levin, C. Silva, <em>Point Set Surfaces</em>, IEEE
Visualization 2001, and X. Zheng and Z. Lv, <em>Isotropic Remeshing with Inter-Angle Optimization</em>, ICIG 2025, for
the idea; one fit at each vertex in the place of one at each query.

@tparam TriangleMesh a model of `FaceListGraph`
@tparam VertexPointMap a model of `ReadablePropertyMap` with the vertices of `TriangleMesh` as key type and a point of a
        \cgal kernel as value type

\cgalModels{RemeshingProjector}
*/
template <class TriangleMesh,
          class VertexPointMap = typename boost::property_map<TriangleMesh, CGAL::vertex_point_t>::const_type>
class MLS_projector
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

  /// fits the surface to `tmesh`, in time linear in its number of faces, and in that of the pairs of them that are as close to each
  /// other as the surface bulges.
  /// @param tmesh a triangle mesh; it must outlive the projector only where `operator()(vertex_descriptor)` is used
  /// @param vpm the points of its vertices
  /// @throws CGAL::Precondition_exception if `tmesh` has no face or one that is not a triangle, if a coordinate is not
  ///         finite, or if all points are equal
  explicit MLS_projector(const TriangleMesh& tmesh, VertexPointMap vpm)
    : vpm_(vpm), reference_(std::make_shared<const internal::Mls_reference>(
                   internal::copy_whole_surface(tmesh, vpm, "MLS_projector::MLS_projector()").mesh))
  {}

  /// the same with the mesh's own points.
  explicit MLS_projector(const TriangleMesh& tmesh) : MLS_projector(tmesh, get(CGAL::vertex_point, tmesh)) {}

  /// returns the projection of `p`: the point of the surface near the closest point of the mesh, along the normal there.
  Point_3 project(const Point_3& p) const { return project(p, Vector3()); }

  /// returns the projection of `p` onto the part of the surface that looks the same way as `normal`: where two sheets lie
  /// near each other, the one whose normal makes less than 73 degrees with it wins over the nearer one.
  Point_3 project(const Point_3& p, const Vector_3& normal) const { return project(p, internal::to_vector3(normal)); }

  /// returns the unit normal of the surface where `p` is projected to; the zero vector where all faces around have no
  /// area.
  Vector_3 normal(const Point_3& p) const
  {
    Index f = 0;
    const internal::Point_on_triangle closest = reference_->locate(to_flat(p), f);
    const Vector3 n = internal::unit(reference_->mls().normal(f, reference_->mls().barycentric_of(f, closest)));
    return Vector_3(n.x, n.y, n.z);
  }

  /// returns `project()` of the point that `v` has now, in the live mesh or point map.
  Point_3 operator()(vertex_descriptor v) const { return project(get(vpm_, v)); }

#ifndef DOXYGEN_RUNNING
  const internal::Reference_surface& reference_surface() const { return reference_->surface(); }
  const internal::Mls_surface& mls_surface() const { return reference_->mls(); }
#endif

private:
  double unit() const { return reference_->surface().unit(); }
  Vector3 to_flat(const Point_3& p) const { return internal::to_vector3(p, unit()); }

  Point_3 project(const Point_3& p, const Vector3& normal) const
  {
    Index f = 0;
    const Vector3 q = to_flat(p);
    const internal::Point_on_triangle closest = reference_->locate(q, f, normal);
    const Vector3 r = unit() * reference_->mls().project(q, f, closest);
    return Point_3(r.x, r.y, r.z);
  }

  VertexPointMap vpm_;
  std::shared_ptr<const internal::Mls_reference> reference_;   // shared by copies of the projector
};

} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_PROJECTION_MLS_PROJECTOR_H
