// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_PROJECTION_UPSAMPLED_POINT_SET_H
#define CGAL_INTER_ANGLE_REMESHING_PROJECTION_UPSAMPLED_POINT_SET_H

#include <CGAL/Inter_angle_remeshing/internal/exchange/whole_surface.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/Mls_reference.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {

/*!
\ingroup PkgInterAngleRemeshingProjection

@brief seven points with normals for each face of a triangle mesh, on the surface of `MLS_projector`.

They are the centroid of the face, the midpoints between it and the corners, and the midpoints between these, moved from
the facet onto the surface. Faces without an area have none. The points come face by face.

Source: X. Zheng and Z. Lv, <em>Isotropic Remeshing with Inter-Angle Optimization</em>, ICIG 2025.

@tparam TriangleMesh a model of `FaceListGraph`
@tparam VertexPointMap a model of `ReadablePropertyMap` with the vertices of `TriangleMesh` as key type and a point of a
        \cgal kernel as value type
*/
template <class TriangleMesh,
          class VertexPointMap = typename boost::property_map<TriangleMesh, CGAL::vertex_point_t>::const_type>
class Upsampled_point_set
{
public:
  /// a face of the mesh
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor;
  /// a point
  using Point_3 = typename boost::property_traits<VertexPointMap>::value_type;
  /// a vector
  using Vector_3 = typename CGAL::Kernel_traits<Point_3>::Kernel::Vector_3;
  /// a point and its unit normal
  using Point_with_normal = std::pair<Point_3, Vector_3>;
  /// the points in their order
  using const_iterator = typename std::vector<Point_with_normal>::const_iterator;

  /// samples `tmesh`, in time linear in its number of faces.
  /// @param tmesh a triangle mesh; it need not outlive the point set
  /// @param vpm the points of its vertices
  /// @throws CGAL::Precondition_exception if `tmesh` has no face or one that is not a triangle, if a coordinate is not
  ///         finite, or if all points are equal
  explicit Upsampled_point_set(const TriangleMesh& tmesh, VertexPointMap vpm)
  {
    const auto copy = internal::copy_whole_surface(tmesh, vpm, "Upsampled_point_set::Upsampled_point_set()");
    const internal::Reference_surface surface(copy.mesh);
    const internal::Mls_surface mls(surface, internal::find_features(copy.mesh));
    points_.reserve(internal::SAMPLES_A_FACE * copy.faces.size());
    places_.reserve(internal::SAMPLES_A_FACE * copy.faces.size());
    internal::for_each_sample(mls, [&](const internal::Surface_sample& s) {
      const internal::Vector3 p = surface.unit() * s.point;
      points_.emplace_back(Point_3(p.x, p.y, p.z), Vector_3(s.normal.x, s.normal.y, s.normal.z));
      places_.push_back({copy.faces[surface.face_record(s.face).source], s.number});
    });
  }

  /// the same with the mesh's own points.
  explicit Upsampled_point_set(const TriangleMesh& tmesh)
    : Upsampled_point_set(tmesh, get(CGAL::vertex_point, tmesh))
  {}

  /// the number of points
  std::size_t size() const { return points_.size(); }
  /// the first point
  const_iterator begin() const { return points_.begin(); }
  /// behind the last point
  const_iterator end() const { return points_.end(); }
  /// point number `i`
  const Point_3& point(std::size_t i) const { return points_[i].first; }
  /// its unit normal
  const Vector_3& normal(std::size_t i) const { return points_[i].second; }
  /// the face that point number `i` lies over
  face_descriptor face(std::size_t i) const { return places_[i].face; }
  /// the barycentric coordinates in that face from which point number `i` was moved: that of the source of the face's
  /// half-edge, and of the next corners along the face
  const std::array<double, 3>& barycentric_coordinates(std::size_t i) const
  {
    return internal::SAMPLE_COORDINATES[places_[i].number];
  }

private:
  struct Place
  {
    face_descriptor face;
    std::size_t number;
  };

  std::vector<Point_with_normal> points_;
  std::vector<Place> places_;
};

} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_PROJECTION_UPSAMPLED_POINT_SET_H
