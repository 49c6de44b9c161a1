// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_PLANAR_POLYGONS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_PLANAR_POLYGONS_H

#include <CGAL/Inter_angle_remeshing/internal/surface/Reference_surface.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// The polygons that faces of a surface triangulate: connected sets of faces whose normals differ from that of one of them by less than .08
// degrees.
class Planar_polygons
{
public:
  using Index = Reference_surface::Index;

  Planar_polygons() = default;
  // Polygons end at the half-edges h for which is_feature(h) is true. Complexity: linear in the number of faces.
  template <class IsFeature>
  Planar_polygons(const Reference_surface& surface, const IsFeature& is_feature)
    : polygon_(surface.number_of_faces(), -1)
  {
    std::vector<Index> faces;
    for (Index first = 0; first < Index(polygon_.size()); ++first) {
      if (polygon_[first] >= 0 || surface.is_degenerate(first)) continue;
      const Vector3 normal = surface.cross_product(first);
      const Index number = Index(polygons_.size());
      Vector3 sum;
      polygon_[first] = number;
      faces.assign(1, first);
      for (std::size_t i = 0; i < faces.size(); ++i) {
        sum += surface.cross_product(faces[i]);
        for (Index h = 4 * faces[i]; h < 4 * faces[i] + 3; ++h) {
          const Index o = surface.opposite(h);
          if (o < 0 || polygon_[o >> 2] >= 0 || is_feature(h) || surface.is_degenerate(o >> 2) ||
              !is_cosine_at_least(surface.cross_product(o >> 2), normal, PLANAR_COSINE)) continue;
          polygon_[o >> 2] = number;
          faces.push_back(o >> 2);
        }
      }
      polygons_.push_back({sum, faces.size() >= MANY_FACES, false, faces.size() > 1 && are_coplanar(surface, faces, sum)});
    }
    find_wide_ones(surface);
  }

  std::size_t size() const { return polygons_.size(); }
  // That of face f; negative: none, as the face is degenerate.
  Index operator[](Index f) const { return polygon_[f]; }
  // Twice the area times the unit normal of a polygon.
  const Vector3& cross_product(Index polygon) const { return polygons_[polygon].cross_product; }
  // Whether there are five faces or more. Fewer may be in a plane on what curves, as the two of each cell of a grid.
  bool has_many_faces(Index polygon) const { return polygons_[polygon].has_many_faces; }
  // Whether there is a vertex that belongs to no other polygon, inside of this one or on the border. Inside of what curves no facet has one.
  bool is_wide(Index polygon) const { return polygons_[polygon].is_wide; }
  // Whether two faces or more lie in the very same plane, but for rounding. On what was scanned hardly any do.
  bool is_exact(Index polygon) const { return polygons_[polygon].is_exact; }

private:
  static constexpr double PLANAR_COSINE = 1 - 1e-6;
  static constexpr std::size_t MANY_FACES = 5;

  struct Polygon
  {
    Vector3 cross_product;
    bool has_many_faces, is_wide, is_exact;
  };

  static bool are_coplanar(const Reference_surface& surface, const std::vector<Index>& faces, const Vector3& normal)
  {
    constexpr double LARGEST_SINE = 1e-4;
    const double bound = LARGEST_SINE * LARGEST_SINE * squared_length(normal);
    return std::all_of(faces.begin(), faces.end(), [&](Index f) {
      const Vector3& c = surface.cross_product(f);
      return squared_length(cross(c, normal)) <= bound * squared_length(c);
    });
  }

  void find_wide_ones(const Reference_surface& surface)
  {
    constexpr Index UNKNOWN = -2, NONE = -1;
    std::vector<Index> around(surface.number_of_vertices(), UNKNOWN);    // by vertex: the polygon of all of its faces
    for (Index f = 0; f < Index(polygon_.size()); ++f)
      for (Index h = 4 * f; h < 4 * f + 3; ++h) {
        Index& polygon = around[surface.origin(h)];
        polygon = polygon == UNKNOWN || polygon == polygon_[f] ? polygon_[f] : NONE;
      }
    for (const Index polygon : around)
      if (polygon >= 0) polygons_[polygon].is_wide = true;
  }

  std::vector<Index> polygon_;                  // by face
  std::vector<Polygon> polygons_;
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_PLANAR_POLYGONS_H
