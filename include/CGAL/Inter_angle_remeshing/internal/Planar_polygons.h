// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_PLANAR_POLYGONS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_PLANAR_POLYGONS_H

#include <CGAL/Inter_angle_remeshing/internal/Reference_surface.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// The polygons that faces of a surface triangulate: connected sets of five faces or more whose normals differ from that of one of them
// by less than .08 degrees. Fewer may be in a plane on what curves, as the two of each cell of a grid.
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
      const Index number = Index(cross_products_.size());
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
      if (faces.size() >= LEAST_FACES) cross_products_.push_back(sum);
      else for (const Index f : faces) polygon_[f] = -1;
    }
  }

  // That of face f; negative: none.
  Index operator[](Index f) const { return polygon_[f]; }
  // Twice the area times the unit normal of a polygon.
  const Vector3& cross_product(Index polygon) const { return cross_products_[polygon]; }

private:
  static constexpr double PLANAR_COSINE = 1 - 1e-6;
  static constexpr std::size_t LEAST_FACES = 5;

  std::vector<Index> polygon_;                  // by face
  std::vector<Vector3> cross_products_;         // by polygon
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_PLANAR_POLYGONS_H
