// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_PROJECTION_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_PROJECTION_H

#include <CGAL/Inter_angle_remeshing/internal/geometry/to_vector3.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/Mls_surface.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/Reference_surface.h>

#include <CGAL/exceptions.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

// The projector that passes see, whatever the user handed over.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// What a functor of the user's returned, in units of the mesh; the run ends where that is no point, or so far away that products of
// coordinates would not be finite.
inline Vector3 checked_projection(const Vector3& v)
{
  constexpr double FARTHEST = 1e100;
  const auto fail = [](const char* message) {
    throw CGAL::Postcondition_exception("Inter_angle_remeshing", "projection_functor", __FILE__, __LINE__, message);
  };
  if (!is_finite(v)) fail("the projection functor returned a point that is not finite");
  if ((std::max)({std::abs(v.x), std::abs(v.y), std::abs(v.z)}) > FARTHEST)
    fail("the projection functor returned a point more than 1e100 times as far away as the mesh is large");
  return v;
}

// A point of the surface with its unit normal.
struct Surface_point
{
  Vector3 point, normal;
};

// Onto the surface near the hint: the closest point on its facets, a point of the MLS surface over them, or one in
// between, as the size of the facet says. Or by the user's rule; without a surface and without a rule every point stays. Points
// are in the units of the flat mesh; `hint` is the face of the surface where a walk starts and ends.
struct Projection
{
  const Reference_surface* surface = nullptr;
  double factor = 1;                     // from the flat mesh's units to those of the surface and of the rule, a power of two
  const Mls_surface* mls = nullptr;      // none: the facets
  double facet_length = 0;               // size of a face up to which its facet counts,
  double smooth_length = 0;              // and from which on the MLS surface counts alone; by the sizing field's parts
  const std::vector<float>* parts = nullptr;    // by face of the surface; none: uniform
  // Rules where it is given; the walk, if there is a surface, then serves for the hint alone.
  const std::function<Vector3(const Vector3&)>* rule = nullptr;
  const std::vector<Corner_table::Index>* face_of_source = nullptr;   // where the surface's faces are those of the input
  bool is_concurrent = true;             // whether several threads may ask
  bool may_be_elsewhere = false;         // whether the surface may be far from the mesh
  double side = 1;                       // -1: the surface's faces look to the other side than those of the mesh

  bool has_faces() const { return surface != nullptr; }
  // Whether there is a surface or a rule.
  bool moves_points() const { return surface != nullptr || rule != nullptr; }
  Vector3 operator()(const Vector3& q, Corner_table::Index& hint) const
  {
    if (mls != nullptr) return (1 / factor) * smooth_point(factor * q, hint);
    const Vector3 closest = has_faces() ? surface->walk(factor * q, hint) : factor * q;
    return rule == nullptr ? (1 / factor) * closest : checked_projection((1 / factor) * (*rule)(factor * q));
  }
  Vector3 smooth_point(const Vector3& q, Corner_table::Index& hint) const
  {
    const Point_on_triangle closest = surface->closest_point_near(q, hint);
    const double l = facet_size(hint);
    if (l < facet_length) return closest.point;
    const Vector3 p = mls->project(q, hint, closest);
    return l >= smooth_length ? p : closest.point + share_of_mls(l) * (p - closest.point);
  }
  // The point near q with the normal there.
  Surface_point nearest(const Vector3& q, Corner_table::Index& hint) const
  {
    const Vector3 p = (*this)(q, hint);
    return {p, normal_at(hint, p)};
  }
  // The point over the facet of face f that has the barycentric coordinates b.
  Surface_point at(Corner_table::Index f, const Mls_surface::Barycentric& b) const
  {
    const Corner_table::Face& t = surface->face_record(f);
    Vector3 p;
    for (int k = 0; k < 3; ++k) p += b[k] * surface->position(t.vertex[k]);
    if (const double share = mls == nullptr ? 0. : share_of_mls(facet_size(f)); share > 0)
      p += share * (mls->point(f, b) - p);
    return {(1 / factor) * p, normal_at(f, (1 / factor) * p)};
  }
  Vector3 normal_at(Corner_table::Index f, const Vector3& p) const
  {
    if (mls != nullptr && share_of_mls(facet_size(f)) > 0) {
      const Vector3 n = mls->normal(f, mls->barycentric_of(f, closest_point_on_face(*surface, factor * p, f)));
      if (squared_length(n) > 0) return side * unit(n);
    }
    return unit(cross_product(f));
  }
  // That of face f of the surface, on the side to which the mesh looks.
  Vector3 cross_product(Corner_table::Index f) const { return side * surface->cross_product(f); }
  // Whether its faces are those of the input.
  bool is_input() const { return face_of_source != nullptr && rule == nullptr; }
  // The size of a face, as it were if the target length were uniform.
  double facet_size(Corner_table::Index f) const
  {
    const double l = mls->size(f);
    return parts == nullptr ? l : l / double((*parts)[f]);
  }
  // From 0 to 1 without a kink.
  double share_of_mls(double length) const
  {
    if (length < facet_length) return 0;
    if (length >= smooth_length) return 1;
    const double t = (length - facet_length) / (smooth_length - facet_length);
    return t * t * (3 - 2 * t);
  }
  // The face that is the input's face `source`; negative where the surface is another one.
  Corner_table::Index face_of(Corner_table::Index source) const
  {
    return face_of_source == nullptr ? -1 : (*face_of_source)[source];
  }
  // From q to face f of the surface.
  double squared_distance_to_face(const Vector3& q, Corner_table::Index f) const
  {
    return squared_distance(closest_point_on_face(*surface, factor * q, f).point, factor * q) / (factor * factor);
  }
  // Whether the face of the hint looks to the same side as the normal: if not, it belongs to another sheet.
  bool is_compatible(Corner_table::Index hint, const Vector3& normal) const
  {
    return !has_faces() || dot(cross_product(hint), normal) > 0;
  }
  // Whether it looks to the other side: the normals make more than OPPOSITE degrees. Well over a right angle, which
  // faces beside a sharp edge make with the surface beyond it.
  bool is_opposite(Corner_table::Index hint, const Vector3& normal) const
  {
    return has_faces() && is_cosine_at_least(cross_product(hint), -1. * normal, OPPOSITE_COSINE);
  }

  static constexpr double OPPOSITE_COSINE = 0.5;
};

// By a functor of the user's that takes a vertex and reads its point. One vertex of the range carries the points of
// all the others to it; its own point comes back with restore(), or when this object goes without it.
template <class Functor, class Vertex, class VertexPointMap>
class Carrier_vertex
{
  using Point_3 = typename boost::property_traits<VertexPointMap>::value_type;

public:
  Carrier_vertex(const Functor& functor, Vertex vertex, VertexPointMap vpm)
    : functor_(functor), vertex_(vertex), vpm_(vpm), point_(get(vpm, vertex))
  {}
  Carrier_vertex(const Carrier_vertex&) = delete;
  Carrier_vertex& operator=(const Carrier_vertex&) = delete;
  ~Carrier_vertex()
  {
    try { restore(); } catch (...) {}    // of two exceptions, the one that is under way counts
  }
  void restore() const { put(vpm_, vertex_, point_); }

  Vector3 operator()(const Vector3& p) const
  {
    put(vpm_, vertex_, Point_3(p.x, p.y, p.z));
    return internal::to_vector3(Point_3(functor_(vertex_)));
  }

private:
  const Functor& functor_;
  Vertex vertex_;
  VertexPointMap vpm_;
  Point_3 point_;
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_PROJECTION_H
