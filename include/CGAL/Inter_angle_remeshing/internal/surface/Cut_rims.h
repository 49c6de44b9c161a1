// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_CUT_RIMS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_CUT_RIMS_H

#include <CGAL/Inter_angle_remeshing/internal/surface/Planar_polygons.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/Reference_surface.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// The rims of plane cuts through what curves, however blunt. A planar polygon is a cut if on most of its rim it is much larger than the
// facet beside it, and the surface turns more than over the edges behind that.
class Cut_rims
{
public:
  using Index = Reference_surface::Index;

  // Both must outlive it.
  Cut_rims(const Reference_surface& surface, const Planar_polygons& polygons)
    : surface_(surface), polygons_(polygons)
  {}

  // One half-edge of each of their edges.
  std::vector<Index> find() const
  {
    struct Rim { double length = 0, length_of_clear = 0; };
    std::vector<Rim> rims(polygons_.size());
    std::vector<Index> edges;
    for (Index h = 0; h < 4 * Index(surface_.number_of_faces()); ++h) {
      if ((h & 3) == 3 || !is_rim(h)) continue;
      const double l = length(surface_.position(surface_.target(h)) - surface_.position(surface_.origin(h))), turn = turn_over(h);
      Rim& rim = rims[polygons_[h >> 2]];
      rim.length += l;
      if (!(turn > LEAST_TURN)) continue;
      edges.push_back(h);
      if (is_much_larger(h) && turn > SHARPER * largest_turn_behind(surface_.opposite(h))) rim.length_of_clear += l;
    }
    const auto is_none = [&](Index h) {
      const Rim& rim = rims[polygons_[h >> 2]];
      return rim.length_of_clear < LEAST_SHARE * rim.length;
    };
    edges.erase(std::remove_if(edges.begin(), edges.end(), is_none), edges.end());
    return edges;
  }

private:
  // Of areas, and of angles; radians; of the length of a rim.
  static constexpr double LARGER = 8, SHARPER = 1.5, LEAST_TURN = 10 * (CGAL_PI / 180), LEAST_SHARE = 0.8;

  // Whether the face of h is part of what may be a cut, and the one behind it of another polygon.
  bool is_rim(Index h) const
  {
    const Index o = surface_.opposite(h), polygon = polygons_[h >> 2];
    return polygon >= 0 && polygons_.has_many_faces(polygon) && polygons_.is_exact(polygon) && o >= 0 && polygons_[o >> 2] >= 0 &&
           polygons_[o >> 2] != polygon;
  }

  bool is_much_larger(Index h) const
  {
    const auto area = [&](Index k) { return length(polygons_.cross_product(polygons_[k >> 2])); };
    return area(h) > LARGER * area(surface_.opposite(h));
  }

  // The angle between the polygons at an edge.
  double turn_over(Index h) const
  {
    const Vector3 &n = polygons_.cross_product(polygons_[h >> 2]), &m = polygons_.cross_product(polygons_[surface_.opposite(h) >> 2]);
    return std::atan2(length(cross(n, m)), dot(n, m));
  }

  // The same, 0 at the border, inside of a polygon, and where that polygon lies across the edge.
  double turn_over(Index e, Index polygon) const
  {
    const Index across = surface_.opposite(e), beyond = across >= 0 ? polygons_[across >> 2] : Index(-1);
    return beyond < 0 || beyond == polygon || beyond == polygons_[e >> 2] ? 0. : turn_over(e);
  }

  // Over the other edges of the face of h, or, where one is inside of a polygon, of the next face of that; not to what lies across h.
  double largest_turn_behind(Index h) const
  {
    const Index before = polygons_[surface_.opposite(h) >> 2];
    double result = 0;
    for (const Index e : {Reference_surface::next(h), surface_.prev(h)}) {
      const Index across = surface_.opposite(e);
      if (across >= 0 && polygons_[across >> 2] == polygons_[h >> 2])
        result = (std::max)({result, turn_over(Reference_surface::next(across), before), turn_over(surface_.prev(across), before)});
      else result = (std::max)(result, turn_over(e, before));
    }
    return result;
  }

  const Reference_surface& surface_;
  const Planar_polygons& polygons_;
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_CUT_RIMS_H
