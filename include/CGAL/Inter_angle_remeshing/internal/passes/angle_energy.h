// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_ANGLE_ENERGY_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_ANGLE_ENERGY_H

#include <CGAL/Inter_angle_remeshing/internal/geometry/closest_point_on_triangle.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/Remeshing_mesh.h>

#include <CGAL/number_type_config.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

// How far the angles around a vertex are out of a band: E = Σ (c - cos lo)₊² + w (cos hi - c)₊² over the corner cosines c of
// the vertex's star, with its gradient.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

class Angle_band
{
public:
  // The bounds in degrees; 60 degrees lie between them. `weight_of_large` is w.
  Angle_band(double lower, double upper, double weight_of_large = 1)
    : lower_(lower), upper_(upper), weight_of_large_(weight_of_large),
      lower_cosine_(std::cos(lower * (CGAL_PI / 180))), upper_cosine_(std::cos(upper * (CGAL_PI / 180)))
  {}

  double lower() const { return lower_; }
  double upper() const { return upper_; }

  // By how much a corner cosine is out of the band, with its sign: positive where the angle is too small.
  double excess(double corner_cosine) const
  {
    return corner_cosine - (std::min)((std::max)(corner_cosine, upper_cosine_), lower_cosine_);
  }
  double energy(double corner_cosine) const
  {
    const double e = excess(corner_cosine);
    return weight(e) * e * e;
  }
  // The derivative of the energy.
  double slope(double corner_cosine) const
  {
    const double e = excess(corner_cosine);
    return 2 * weight(e) * e;
  }

  // Whether the angles of the triangle abc lie within the band; by the law of cosines and without a root. One whose corners are
  // equal has no angles.
  bool holds(const Vector3& a, const Vector3& b, const Vector3& c) const
  {
    const double ab = squared_distance(a, b), bc = squared_distance(b, c), ca = squared_distance(c, a);
    const double l[3] = {(std::min)((std::min)(ab, bc), ca), (std::max)((std::min)(ab, bc), (std::min)((std::max)(ab, bc), ca)),
                         (std::max)((std::max)(ab, bc), ca)};
    const double smallest = l[1] + l[2] - l[0], largest = l[0] + l[1] - l[2];   // cosines times the edges beside, twice
    const double bound = 4 * upper_cosine_ * upper_cosine_ * l[0] * l[1];
    return l[2] > 0 && smallest * smallest <= 4 * lower_cosine_ * lower_cosine_ * l[1] * l[2] &&
           (upper_cosine_ >= 0 ? largest >= 0 && largest * largest >= bound : largest >= 0 || largest * largest <= bound);
  }

private:
  double weight(double excess) const { return excess < 0 ? weight_of_large_ : 1; }

  double lower_, upper_, weight_of_large_, lower_cosine_, upper_cosine_;
};

// The star of a vertex that moves while its link stays.
class Star_energy
{
public:
  using Index = Remeshing_mesh::Index;

  // Reads the link of v; `band(u, w)` refers to the band of the face with the link edge uw.
  template <class Band>
  void read(const Remeshing_mesh& mesh, Index v, const Band& band)
  {
    ring_.clear();
    link_.clear();
    has_length_ = true;
    Index last = -1;
    mesh.for_each_around(v, [&](Index h) {
      const Index u = mesh.target(h), w = mesh.apex(h);
      const Vector3 e = mesh.position(w) - mesh.position(u);
      const double l = length(e);
      ring_.push_back(mesh.position(u));
      link_.push_back({l > 0 ? (1 / l) * e : Vector3(), &band(u, w)});
      has_length_ = has_length_ && l > 0;
      last = w;
    });
    is_closed_ = !mesh.is_border_vertex(v);
    if (last >= 0) ring_.push_back(mesh.position(last));     // the first one again where the link is closed
    spoke_.resize(ring_.size());
    inverse_length_.resize(ring_.size());
    slope_.resize(ring_.size());
  }

  // The energy if v lay at p.
  double value(const Vector3& p)
  {
    set_spokes(p);
    double sum = 0;
    for_each_face([&](std::size_t k, const std::array<double, 3>& cosines) {
      for (const double c : cosines) sum += link_[k].band->energy(c);
    });
    return sum;
  }

  // The cosine of the smallest angle where the value was asked for last.
  double largest_cosine() const
  {
    double result = -1;
    for_each_face([&](std::size_t, const std::array<double, 3>& cosines) {
      for (const double c : cosines) result = (std::max)(result, c);
    });
    return result;
  }

  double squared_sine_of_smallest_angle() const { return 1 - CGAL::square(largest_cosine()); }

  // The gradient where the value was asked for last. A corner cosine is a product of unit vectors, two spokes or a spoke and a
  // link edge; of these only the spokes s = (x - p) / |x - p| turn, by ds = -(I - s sᵀ) dp / |x - p|.
  Vector3 gradient()
  {
    std::fill(slope_.begin(), slope_.end(), Vector3());
    for_each_face([&](std::size_t k, const std::array<double, 3>& c) {
      const Angle_band& band = *link_[k].band;
      const double at_v = band.slope(c[0]), at_u = band.slope(c[1]), at_w = band.slope(c[2]);
      slope_[k] += at_v * spoke_[k + 1] - at_u * link_[k].direction;
      slope_[k + 1] += at_v * spoke_[k] + at_w * link_[k].direction;
    });
    Vector3 result;
    for (std::size_t k = 0; k < spoke_.size(); ++k)
      result += inverse_length_[k] * (dot(slope_[k], spoke_[k]) * spoke_[k] - slope_[k]);
    return result;
  }

  // The sum of the faces' cross products.
  Vector3 normal(const Vector3& p) const
  {
    Vector3 sum;
    for (std::size_t k = 0; k < link_.size(); ++k) sum += triangle_cross(p, ring_[k], ring_[k + 1]);
    return sum;
  }

  // Twice its area, if v lay at p.
  double area(const Vector3& p) const
  {
    double sum = 0;
    for (std::size_t k = 0; k < link_.size(); ++k) sum += length(triangle_cross(p, ring_[k], ring_[k + 1]));
    return sum;
  }

  // From the star to x, if v lay at p.
  double squared_distance(const Vector3& p, const Vector3& x) const
  {
    double result = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < link_.size(); ++k) {
      const Vector3 closest = closest_point_on_triangle(x, p, ring_[k], ring_[k + 1]).point;
      result = (std::min)(result, internal::squared_distance(closest, x));
    }
    return result;
  }

  // Whether no face turns by more than 60 degrees when v moves from p to q.
  bool keeps_orientation(const Vector3& p, const Vector3& q) const
  {
    for (std::size_t k = 0; k < link_.size(); ++k)
      if (!is_cosine_at_least(triangle_cross(p, ring_[k], ring_[k + 1]), triangle_cross(q, ring_[k], ring_[k + 1]), 0.5))
        return false;
    return true;
  }

private:
  struct Link_edge
  {
    Vector3 direction;
    const Angle_band* band;
  };

  void set_spokes(const Vector3& p)
  {
    const std::size_t n = ring_.size() - (is_closed_ && !ring_.empty());
    double shortest = 1;
    for (std::size_t k = 0; k < n; ++k) {
      const Vector3 x = ring_[k] - p;
      const double l = length(x);
      inverse_length_[k] = l > 0 ? 1 / l : 0;
      spoke_[k] = inverse_length_[k] * x;
      shortest = (std::min)(shortest, l);
    }
    has_spokes_ = shortest > 0;
    if (n == ring_.size()) return;
    spoke_[n] = spoke_[0];
    inverse_length_[n] = inverse_length_[0];
  }

  // The corner cosines of face k at v and at the two ends of its link edge, if all its edges have a length,
  std::array<double, 3> regular_corners(std::size_t k) const
  {
    const Vector3 &s = spoke_[k], &t = spoke_[k + 1], &e = link_[k].direction;
    return {dot(s, t), -dot(s, e), dot(t, e)};
  }
  // and in any case: 1 beside an edge without length.
  std::array<double, 3> corners(std::size_t k) const
  {
    const Vector3 &s = spoke_[k], &t = spoke_[k + 1], &e = link_[k].direction;
    const bool has_s = inverse_length_[k] > 0, has_t = inverse_length_[k + 1] > 0, has_e = e != Vector3();
    return {has_s && has_t ? dot(s, t) : 1, has_s && has_e ? -dot(s, e) : 1, has_t && has_e ? dot(t, e) : 1};
  }

  template <class Function>
  void for_each_face(const Function& function) const
  {
    const std::size_t n = link_.size();
    if (has_length_ && has_spokes_) for (std::size_t k = 0; k < n; ++k) function(k, regular_corners(k));
    else for (std::size_t k = 0; k < n; ++k) function(k, corners(k));
  }

  bool is_closed_ = true;
  bool has_length_ = true, has_spokes_ = true;     // all link edges have one; all spokes do
  std::vector<Vector3> ring_;                      // of the ends of link edges
  std::vector<Link_edge> link_;                    // from ring vertex k to k + 1
  std::vector<Vector3> spoke_;                     // unit
  std::vector<double> inverse_length_;
  std::vector<Vector3> slope_;                     // of the energy, by spoke
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_ANGLE_ENERGY_H
