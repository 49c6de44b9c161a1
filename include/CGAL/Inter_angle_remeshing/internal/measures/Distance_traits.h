// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_MEASURES_DISTANCE_TRAITS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_MEASURES_DISTANCE_TRAITS_H

#include <CGAL/Inter_angle_remeshing/internal/compatibility.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {
namespace measures {

// The surfaces are copied to plain doubles, near the origin and of about unit size. Thus any kernel will do, distances
// of tiny and of huge meshes are equally accurate, and threads share nothing of the user's.
using Distance_kernel = CGAL::Simple_cartesian<double>;
using Distance_point = Distance_kernel::Point_3;
using Distance_triangle = Distance_kernel::Triangle_3;

// A kernel whose projection on a triangle is accurate whatever the triangle's shape. CGAL's own goes through the
// equation of the plane: with plain doubles, and a needle of unit length and a width of 1e-12, distances came out too
// large by up to 1e-5; for thinner ones by as much as the needle is long.
struct Distance_traits : Distance_kernel
{
  using Point = Distance_kernel::Point_3;
  using Vector = Distance_kernel::Vector_3;
  using Triangle = Distance_kernel::Triangle_3;

  class Construct_projected_point_3
  {
    struct Nearest
    {
      const Point& query;
      Point point;
      double squared_distance;

      void offer(const Point& candidate)
      {
        const double d = CGAL::squared_distance(query, candidate);
        if (!(d < squared_distance)) return;
        squared_distance = d;
        point = candidate;
      }

      void offer_segment(const Point& source, const Vector& direction)
      {
        const double length = direction.squared_length();
        if (length > 0) offer(source + std::clamp((query - source) * direction / length, 0., 1.) * direction);
      }
    };

  public:
    Point operator()(const Triangle& t, const Point& query) const
    {
      const Point& a = t[0];
      const Vector ab = t[1] - a, ac = t[2] - a, aq = query - a;
      Nearest nearest{query, a, aq.squared_length()};
      nearest.offer_segment(a, ab);
      nearest.offer_segment(a, ac);
      nearest.offer_segment(t[1], t[2] - t[1]);

      const Vector normal = CGAL::cross_product(ab, ac);
      const double area = normal.squared_length();
      const double weight_b = CGAL::cross_product(aq, ac) * normal, weight_c = CGAL::cross_product(ab, aq) * normal;
      if (area > 0 && weight_b >= 0 && weight_c >= 0 && weight_b + weight_c <= area)
        nearest.offer(a + (weight_b / area) * ab + (weight_c / area) * ac);
      return nearest.point;
    }
  };

  Construct_projected_point_3 construct_projected_point_3_object() const { return {}; }
};

using Distance_primitive = AABB_triangle_primitive<Distance_traits, std::vector<Distance_triangle>::const_iterator>;
using Distance_tree = CGAL::AABB_tree<AABB_traits<Distance_traits, Distance_primitive>>;

} // namespace measures
} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_MEASURES_DISTANCE_TRAITS_H
