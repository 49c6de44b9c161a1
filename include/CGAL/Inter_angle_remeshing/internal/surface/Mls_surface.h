// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_MLS_SURFACE_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_MLS_SURFACE_H

#include <CGAL/Inter_angle_remeshing/internal/compiled.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/Reference_surface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// Edges with a dihedral angle of more than 60 degrees are folds.
constexpr double MLS_FOLD_COSINE = 0.5;

inline double mean_edge_length(const Reference_surface& surface, Reference_surface::Index f)
{
  const Reference_surface::Face& t = surface.face_record(f);
  double sum = 0;
  for (int k = 0; k < 3; ++k)
    sum += length(surface.position(t.vertex[(k + 1) % 3]) - surface.position(t.vertex[k]));
  return sum / 3;
}

// How large a face is: its mean edge length, but not more than 1.7 times the altitude over the longest edge, of it or of one of its
// neighbors. Where all faces are needles, as along a cylinder, they are narrow, however long.
inline double facet_size(const Reference_surface& surface, Reference_surface::Index f)
{
  constexpr double ALTITUDES = 1.7;
  double altitude = surface.least_altitude(f);
  for (Reference_surface::Index h = 4 * f; h < 4 * f + 3; ++h)
    if (surface.opposite(h) >= 0) altitude = (std::max)(altitude, surface.least_altitude(surface.opposite(h) >> 2));
  return (std::min)(mean_edge_length(surface, f), ALTITUDES * altitude);
}

// A smooth surface over the faces of a reference surface: through its vertices, with the normals of a moving least squares
// fit there. Features and borders become curves, and corners stay. With barycentric coordinates b of a face,
//
//   P(b) = Σ b_i P_i + Σ_{i≠j} (b_i² b_j + ½ b_0 b_1 b_2) d_ij,   N(b) = Σ b_i n_i,
//
// where d_ij is what leads from the edge P_i P_j, at its end P_i, into the tangent plane or onto the tangent there. Faces
// that touch a fold, where the surface turns back on itself, stay flat: bent, the two sides would run through each other. So do the
// edges of faces that would themselves turn that far, as narrow ones between large facets and tiny ones, and of those over which the
// surface would run through what is close by, another sheet or another part.
// Const after construction; the reference surface must outlive it.
class Mls_surface
{
public:
  using Index = Reference_surface::Index;
  using Barycentric = std::array<double, 3>;

  // Of the faces that are larger than `least_size`; on the other ones, and on those of which `is_flat` says so, whose size is 0, the
  // surface is the triangle. Features are the border, constrained edges, those of the half-edges `creases`, edges where two wide planar
  // polygons meet, and the rims of plane cuts. Unless it `keeps_apart`, the surface may cross what is close by.
  CGAL_INTER_ANGLE_REMESHING_INLINE
  Mls_surface(const Reference_surface& surface, const std::vector<Index>& creases, double least_size = -1,
              const std::vector<char>* is_flat = nullptr, bool keeps_apart = true);

  // That of `whole` over a part of its reference surface, whose half-edge h is `halfedge(h)` of the whole one; in its unit lengths are
  // `scale` times as large. Where a feature lies on the part's rim, beside thin faces outside, its curve may be higher. It holds no more
  // than queries need.
  template <class Function>
  Mls_surface(const Mls_surface& whole, const Reference_surface& part, double scale, const Function& halfedge);

  const Reference_surface& reference_surface() const { return *surface_; }

  // The point P(b).
  Vector3 point(Index f, const Barycentric& b) const;
  // The area over face f, about: that of four triangles through the corners and the middles of the edges.
  double area(Index f) const
  {
    const Vector3 p[3] = {corner(f, 0), corner(f, 1), corner(f, 2)};
    const Vector3 q[3] = {point(f, {0, .5, .5}), point(f, {.5, 0, .5}), point(f, {.5, .5, 0})};
    double doubled = length(triangle_cross(q[0], q[1], q[2]));
    for (int k = 0; k < 3; ++k) doubled += length(triangle_cross(p[k], q[(k + 2) % 3], q[(k + 1) % 3]));
    return doubled / 2;
  }
  // The vector N(b), not of unit length; zero where the face has no normal.
  Vector3 normal(Index f, const Barycentric& b) const
  {
    Vector3 sum;
    for (int k = 0; k < 3; ++k) sum += b[k] * corner_normal(f, k);
    return sum;
  }
  // The coordinates of a point on face f.
  Barycentric barycentric_of(Index f, const Point_on_triangle& p) const;
  // Onto the surface over the face f from the point `closest` on it, which is the closest one to q.
  Vector3 project(const Vector3& q, Index f, const Point_on_triangle& closest) const;

  // On the feature edge of h the surface is the curve (1-u) P + u Q + u (1-u) ((1-u) d + u e), with these d and e.
  std::array<Vector3, 2> curve_offsets(Index h) const
  {
    const int from = h & 3, to = (from + 1) % 3;
    return {feature_offset(h >> 2, from, to), feature_offset(h >> 2, to, from)};
  }
  bool is_feature(Index h) const { return (faces_[h >> 2].features >> (h & 3) & 1) != 0; }
  double size(Index f) const { return sizes_[f]; }
  // A bound of the distance from P(b) to the face: the coefficients of all d sum to no more than a third.
  double height(Index f) const;
  // The smooth part of the surface around corner k of face f, between features, and its unit normal there; -1: none.
  Index sector(Index f, int k) const { return faces_[f].sector[k]; }
  const Vector3& sector_normal(Index s) const { return normals_[s]; }
  std::size_t number_of_sectors() const { return normals_.size(); }

  // Bounds, in sizes of the face: of the distance from P(b) to the face, and from P(b) to a projection.
  static constexpr double LARGEST_OFFSET = 0.15, LARGEST_STEP = 0.3;

private:
  friend class Mls_surface_fit;

  struct Face_data
  {
    Index sector[3] = {-1, -1, -1};          // of the corners; -1: no normal
    // Of the smooth edges from corner k to the next and the one before: d = -rise n.
    float rise[3][2] = {{0, 0}, {0, 0}, {0, 0}};
    std::uint32_t features = 0;              // a bit for each edge on a feature, each vertex there, and each such edge that is straight
  };

  // The first of the bits of edges on features, of vertices there, and of straight edges there.
  static constexpr std::uint32_t FEATURE_EDGE = 1u, FEATURE_VERTEX = 1u << 3, STRAIGHT_EDGE = 1u << 6;

  // |d| is at most this fraction of the edge.
  static constexpr double STEEPEST = 0.35;

  static Vector3 clamped(const Vector3& d, double bound)
  {
    const double square = squared_length(d);
    return square > bound * bound ? (bound / std::sqrt(square)) * d : d;
  }

  Vector3 corner_normal(Index f, int k) const
  {
    const Index s = sector(f, k);
    return s < 0 ? Vector3() : sector_normal(s);
  }
  const Vector3& corner(Index f, int k) const { return surface_->position(surface_->face_record(f).vertex[k]); }

  bool is_on_feature(Index f, const Barycentric& b) const;
  Vector3 feature_offset(Index f, int from, int to) const;

  const Reference_surface* surface_;
  std::vector<Face_data> faces_;
  std::vector<float> sizes_;                 // by face
  std::vector<Vector3> normals_;             // unit, by sector
  std::vector<Vector3> tangents_;            // unit, by vertex on a feature; zero at corners
};

template <class Function>
Mls_surface::Mls_surface(const Mls_surface& whole, const Reference_surface& part, double scale, const Function& halfedge)
  : surface_(&part), faces_(part.number_of_faces()), sizes_(part.number_of_faces()), tangents_(part.number_of_vertices())
{
  std::vector<Index> new_sector(whole.normals_.size(), -1);
  for (Index f = 0; f < Index(faces_.size()); ++f) {
    Face_data& data = faces_[f];
    for (int k = 0; k < 3; ++k) {
      const Index h = halfedge(4 * f + k);
      const int there = h & 3;
      const Face_data& source = whole.faces_[h >> 2];
      if (const Index s = source.sector[there]; s >= 0) {
        if (new_sector[s] < 0) {
          new_sector[s] = Index(normals_.size());
          normals_.push_back(whole.normals_[s]);
        }
        data.sector[k] = new_sector[s];
      }
      for (int side = 0; side < 2; ++side) data.rise[k][side] = float(scale * double(source.rise[there][side]));
      for (const std::uint32_t first : {FEATURE_EDGE, FEATURE_VERTEX, STRAIGHT_EDGE})
        if ((source.features & (first << there)) != 0) data.features |= first << k;
      tangents_[part.origin(4 * f + k)] = whole.tangents_[whole.surface_->origin(h)];
    }
    sizes_[f] = float(scale * double(whole.sizes_[halfedge(4 * f) >> 2]));
  }
}

inline double Mls_surface::height(Index f) const
{
  double highest = 0;
  for (int k = 0; k < 3; ++k) {
    for (const float rise : faces_[f].rise[k]) highest = (std::max)(highest, std::abs(double(rise)));
    if (is_feature(4 * f + k)) for (const Vector3& d : curve_offsets(4 * f + k)) highest = (std::max)(highest, length(d));
  }
  return (std::min)(highest / 3, LARGEST_OFFSET * sizes_[f]);
}

// d for a feature edge. The curve must not cross the faces beside it, which may be thinner than it is high.
inline Vector3 Mls_surface::feature_offset(Index f, int from, int to) const
{
  const Vector3& t = tangents_[surface_->face_record(f).vertex[from]];
  const int edge = to == (from + 1) % 3 ? from : to;
  if (t == Vector3() || (faces_[f].features >> edge & STRAIGHT_EDGE) != 0) return {};
  const Vector3 e = corner(f, to) - corner(f, from);
  const Index across = surface_->opposite(4 * f + edge);
  double bound = (std::min)(STEEPEST * length(e), surface_->least_altitude(f));
  if (across >= 0) bound = (std::min)(bound, surface_->least_altitude(across >> 2));
  return clamped(dot(t, e) * t - e, bound);
}

inline Vector3 Mls_surface::point(Index f, const Barycentric& b) const
{
  const Face_data& data = faces_[f];
  const double bubble = 0.5 * b[0] * b[1] * b[2];
  Vector3 flat, offset;
  for (int k = 0; k < 3; ++k) {
    const int next = k == 2 ? 0 : k + 1, before = k == 0 ? 2 : k - 1;
    flat += b[k] * corner(f, k);
    const double to_next = b[k] * b[k] * b[next] + bubble, to_before = b[k] * b[k] * b[before] + bubble;
    double rise = 0;
    if (data.features >> k & 1) offset += to_next * feature_offset(f, k, next);
    else rise += to_next * data.rise[k][0];
    if (data.features >> before & 1) offset += to_before * feature_offset(f, k, before);
    else rise += to_before * data.rise[k][1];
    if (rise != 0) offset += -rise * corner_normal(f, k);
  }
  return flat + clamped(offset, LARGEST_OFFSET * sizes_[f]);
}

inline Mls_surface::Barycentric barycentric(const Vector3& p, const Vector3& a, const Vector3& b, const Vector3& c)
{
  const Vector3 ab = b - a, ac = c - a, ap = p - a, n = cross(ab, ac);
  const double area = squared_length(n);
  if (!(area > 0)) return {1, 0, 0};
  const double vb = dot(cross(ap, ac), n) / area, vc = dot(cross(ab, ap), n) / area;
  return {1 - vb - vc, vb, vc};
}

// The coordinates of a point on an edge or at a vertex, where one or two of them are zero.
inline Mls_surface::Barycentric barycentric(const Point_on_triangle& p, const Vector3& a, const Vector3& b,
                                            const Vector3& c)
{
  const auto fraction = [&](const Vector3& s, const Vector3& t) {
    const Vector3 e = t - s;
    const double l = squared_length(e);
    return l > 0 ? dot(p.point - s, e) / l : 0.;
  };
  double t;
  switch (p.part) {
  case Triangle_part::vertex_a: return {1, 0, 0};
  case Triangle_part::vertex_b: return {0, 1, 0};
  case Triangle_part::vertex_c: return {0, 0, 1};
  case Triangle_part::edge_ab: t = fraction(a, b); return {1 - t, t, 0};
  case Triangle_part::edge_bc: t = fraction(b, c); return {0, 1 - t, t};
  case Triangle_part::edge_ca: t = fraction(c, a); return {t, 0, 1 - t};
  default: return barycentric(p.point, a, b, c);
  }
}

inline Mls_surface::Barycentric Mls_surface::barycentric_of(Index f, const Point_on_triangle& p) const
{
  return barycentric(p, corner(f, 0), corner(f, 1), corner(f, 2));
}

// Whether the point b of face f lies on one of the features, up to rounding.
inline bool Mls_surface::is_on_feature(Index f, const Barycentric& b) const
{
  constexpr double ROUNDING = 1e-9;
  const std::uint32_t features = faces_[f].features;
  if (features == 0) return false;
  for (int k = 0; k < 3; ++k) {
    if ((features >> k & 1) && b[k == 0 ? 2 : k - 1] <= ROUNDING) return true;    // the corner opposite to edge k
    if ((features >> (3 + k) & 1) && b[k] >= 1 - ROUNDING) return true;
  }
  return false;
}

inline Vector3 Mls_surface::project(const Vector3& q, Index f, const Point_on_triangle& closest) const
{
  const Barycentric b = barycentric_of(f, closest);
  const Vector3 p = point(f, b);
  if (is_on_feature(f, b)) return p;
  const Vector3 n = normal(f, b);
  const double square = squared_length(n);
  if (square < 0.25) return p;
  const Vector3 moved = q + (dot(p - q, n) / square) * n;
  const double bound = LARGEST_STEP * sizes_[f];
  return squared_distance(moved, p) <= bound * bound ? moved : p;
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#ifndef CGAL_INTER_ANGLE_REMESHING_COMPILED
#  include <CGAL/Inter_angle_remeshing/internal/surface/Mls_surface_impl.h>
#endif

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_MLS_SURFACE_H
