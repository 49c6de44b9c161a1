// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_MLS_FLATS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_MLS_FLATS_H

#include <CGAL/Inter_angle_remeshing/internal/surface/Planar_polygons.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/Reference_surface.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// The planar polygons of a surface, and what they say of the normals of a smooth one over it: those that are flats of a design, between
// which it curves, and those that are much larger than others.
class Mls_flats
{
public:
  using Index = Reference_surface::Index;

  // Both arguments must outlive it. Features are the edges of the half-edges h for which is_feature(h) is true.
  template <class IsFeature>
  Mls_flats(const Reference_surface& surface, const Planar_polygons& polygons, const IsFeature& is_feature)
    : surface_(surface), polygons_(polygons)
  {
    find_flats(is_feature);
  }

  // Whether the face of h is part of a flat.
  bool is_flat(Index h) const { return polygons_[h >> 2] >= 0 && is_flat_polygon_[polygons_[h >> 2]] != 0; }

  // What the polygons say of the normal of a sector, see Mls_surface_fit; not of unit length, zero where they say nothing. Tiny ones beside
  // a large one say nothing: cuts leave quadrangles around a flat.
  Vector3 normal(const std::vector<Index>& sector) const
  {
    if (is_in_one_plane(sector)) return polygons_.cross_product(polygons_[sector.front() >> 2]);
    double least = 0;
    for (const Index h : sector) least = (std::max)(least, least_area_beside(polygons_[h >> 2]));
    Vector3 result = normal_of_flats(sector, least);
    if (!(length(result) > 0)) result = normal_at_tangent_rims(sector, least);
    if (!(length(result) > 0)) result = normal_of_uneven_sector(sector);
    return result;
  }

private:
  // Facets around a vertex are uneven where one has so many times the area of another, or so many, if it is a polygon.
  static constexpr double UNEVEN = 32, UNEVEN_POLYGON = 8;

  // Whether all faces of a sector are part of one polygon, inside of which their vertex lies, or which has many faces: what curves behind
  // its rim, however near, does not turn it. Of one or two, as at a corner, nothing is known.
  bool is_in_one_plane(const std::vector<Index>& sector) const
  {
    const Index polygon = polygons_[sector.front() >> 2];
    if (polygon < 0 || std::any_of(sector.begin(), sector.end(), [&](Index h) { return polygons_[h >> 2] != polygon; })) return false;
    const bool is_closed = surface_.origin(surface_.prev(sector.back())) == surface_.target(sector.front());
    return is_closed || polygons_.has_many_faces(polygon);
  }

  double least_area_beside(Index polygon) const
  {
    if (polygon < 0) return 0;
    return length(polygons_.cross_product(polygon)) /
           (polygons_.is_exact(polygon) || polygons_.has_many_faces(polygon) ? UNEVEN_POLYGON : UNEVEN);
  }

  // The angle from the polygon of h to the one behind it, in radians; negative where they meet in a groove.
  double turn_over(Index h) const
  {
    const Vector3 &n = polygons_.cross_product(polygons_[h >> 2]), &m = polygons_.cross_product(polygons_[surface_.opposite(h) >> 2]),
                  axis = cross(n, m);
    const double angle = std::atan2(length(axis), dot(n, m));
    return dot(axis, surface_.position(surface_.target(h)) - surface_.position(surface_.origin(h))) < 0 ? -angle : angle;
  }

  // How far the polygon of h reaches from h, about, where that is no further than along h.
  double width_at(Index h) const
  {
    const double area = length(polygons_.cross_product(polygons_[h >> 2])) / 2;
    return (std::min)(std::sqrt(area), area / length(surface_.position(surface_.target(h)) - surface_.position(surface_.origin(h))));
  }

  // Whether behind h begins what curves, tangent to the polygon of h: over h the surface curves less, by the angles over the widths,
  // than over an edge behind the next polygon, which may be a feature, to the same side; and that one is narrower. Inscribed facets turn
  // from a flat by half of what they turn from each other.
  bool is_tangent_rim(Index h) const
  {
    constexpr double TANGENT = 0.35, NARROWER = 2.5;
    const Index o = surface_.opposite(h), next = polygons_[o >> 2];
    if (next < 0) return false;
    const double width = std::sqrt(length(polygons_.cross_product(polygons_[h >> 2])) / 2), next_width = width_at(o);
    if (!(width > NARROWER * next_width)) return false;
    const double curvature = turn_over(h) / (width + next_width);
    const auto curves_more_beyond = [&](Index e) {
      const Index beyond = surface_.opposite(e);
      if (beyond < 0 || polygons_[beyond >> 2] < 0 || polygons_[beyond >> 2] == polygons_[h >> 2]) return false;
      const double other = turn_over(e) / (width_at(e) + width_at(beyond));
      return curvature * other > 0 && std::abs(curvature) < TANGENT * std::abs(other);
    };
    // The next polygon is a triangle or a quadrangle in most cases; of larger ones these faces are enough.
    for (const Index e : {Reference_surface::next(o), surface_.prev(o)}) {
      const Index beyond = surface_.opposite(e);
      if (beyond < 0 || polygons_[beyond >> 2] != next) {
        if (curves_more_beyond(e)) return true;
      } else if (curves_more_beyond(Reference_surface::next(beyond)) || curves_more_beyond(surface_.prev(beyond))) {
        return true;
      }
    }
    return false;
  }

  // A polygon in one plane is a flat if what curves joins it tangentially on all its sides, but for a tenth of their length and for
  // features.
  template <class IsFeature>
  void find_flats(const IsFeature& is_feature)
  {
    constexpr double LEAST_SHARE = 0.9;
    struct Rim { double length = 0, tangent = 0; };
    std::vector<Rim> rims(polygons_.size());
    tangent_rims_.assign(surface_.number_of_faces(), 0);
    for (Index h = 0; h < 4 * Index(surface_.number_of_faces()); ++h) {
      if ((h & 3) == 3 || polygons_[h >> 2] < 0 || !polygons_.is_exact(polygons_[h >> 2]) || is_feature(h)) continue;
      const Index o = surface_.opposite(h);
      if (o < 0 || polygons_[o >> 2] == polygons_[h >> 2]) continue;
      const double l = length(surface_.position(surface_.target(h)) - surface_.position(surface_.origin(h)));
      Rim& rim = rims[polygons_[h >> 2]];
      rim.length += l;
      if (!is_tangent_rim(h)) continue;
      rim.tangent += l;
      tangent_rims_[h >> 2] |= char(1 << (h & 3));
    }
    is_flat_polygon_.assign(rims.size(), 0);
    for (std::size_t i = 0; i < rims.size(); ++i)
      is_flat_polygon_[i] = rims[i].tangent > 0 && rims[i].tangent >= LEAST_SHARE * rims[i].length;
  }

  // The polygon of five faces or more that the face of h is a part of; negative: none.
  Index polygon_of(Index h) const
  {
    const Index polygon = polygons_[h >> 2];
    return polygon >= 0 && polygons_.has_many_faces(polygon) ? polygon : Index(-1);
  }
  // Twice the area times the unit normal of that polygon, or of the face.
  Vector3 facet(Index h) const
  {
    const Index polygon = polygon_of(h);
    return polygon >= 0 ? polygons_.cross_product(polygon) : surface_.cross_product(h >> 2);
  }

  // The normal, not of unit length, of the flats of a sector, the larger ones counting more; zero where there is none. Twice the area of
  // each is at least this.
  Vector3 normal_of_flats(const std::vector<Index>& sector, double least) const
  {
    Vector3 sum;
    for (auto h = sector.begin(); h != sector.end(); ++h) {
      const Index polygon = polygons_[*h >> 2];
      if (!is_flat(*h) || std::any_of(sector.begin(), h, [&](Index before) { return polygons_[before >> 2] == polygon; })) continue;
      const Vector3& c = polygons_.cross_product(polygon);
      if (length(c) >= least) sum += length(c) * c;
    }
    return sum;
  }

  // The normal, not of unit length, of the facets of a sector behind whose edges begins what curves more, tangent to them, as at the ends
  // of a cylinder between two fillets: the shorter these edges are, the nearer it is to a facet's. Zero where there are less than two
  // edges. Twice the area of each facet is at least this.
  Vector3 normal_at_tangent_rims(const std::vector<Index>& sector, double least) const
  {
    Vector3 sum;
    int rims = 0;
    for (const Index h : sector)
      for (const Index e : {h, surface_.prev(h)}) {
        if ((tangent_rims_[e >> 2] >> (e & 3) & 1) == 0) continue;
        const Vector3& c = polygons_.cross_product(polygons_[e >> 2]);
        if (length(c) < least) continue;
        ++rims;
        sum += (1 / (length(c) * length(surface_.position(surface_.target(e)) - surface_.position(surface_.origin(e))))) * c;
      }
    return rims > 1 ? sum : Vector3();
  }

  // The larger a facet is, the less it turns from the surface, where all are as near to it: a fillet is tangent to the flats that it
  // joins, however small its facets are, and however the flats are triangulated. So where the facets of a sector, planar polygons and
  // other faces, are uneven, the large ones say what the normal is, which is not of unit length; else it is zero.
  Vector3 normal_of_uneven_sector(const std::vector<Index>& sector) const
  {
    double least = std::numeric_limits<double>::infinity(), bound = 0;
    Vector3 sum;
    Index before = polygon_of(sector.back());
    for (const Index h : sector) {
      const Index polygon = polygon_of(h);
      if (polygon >= 0 && polygon == before) continue;
      before = polygon;
      const Vector3 c = facet(h);
      const double area = length(c);
      if (!(area > 0)) continue;
      least = (std::min)(least, area);
      bound = (std::max)(bound, area / (polygon >= 0 && polygons_.is_exact(polygon) ? UNEVEN_POLYGON : UNEVEN));
      sum += area * c;
    }
    return bound > least ? sum : Vector3();
  }

  const Reference_surface& surface_;
  const Planar_polygons& polygons_;
  std::vector<char> is_flat_polygon_;
  std::vector<char> tangent_rims_;           // by face: a bit for each edge at which what is beyond curves more
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_MLS_FLATS_H
