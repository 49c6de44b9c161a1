// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_MLS_SURFACE_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_MLS_SURFACE_H

#include <CGAL/Inter_angle_remeshing/internal/curves/curves.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/Remeshing_mesh.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/Close_patches.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/Planar_polygons.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/Reference_surface.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/sector_fit.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
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
  // surface is the triangle. Features are the border, constrained edges, those of the half-edges `creases`, and edges where two wide planar
  // polygons meet. Unless it `keeps_apart`, the surface may cross what is close by.
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
  struct Face_data
  {
    Index sector[3] = {-1, -1, -1};          // of the corners; -1: no normal
    // Of the smooth edges from corner k to the next and the one before: d = -rise n.
    float rise[3][2] = {{0, 0}, {0, 0}, {0, 0}};
    std::uint32_t features = 0;              // a bit for each edge on a feature, each vertex there, and each such edge that is straight
  };

  // The first of the bits of edges on features, of vertices there, and of straight edges there.
  static constexpr std::uint32_t FEATURE_EDGE = 1u, FEATURE_VERTEX = 1u << 3, STRAIGHT_EDGE = 1u << 6;

  // |d| is at most this fraction of the edge. What curves at the ends of an edge says little about one that is more than this many
  // times as long as the faces beside it are large: there it falls with the square of that.
  static constexpr double STEEPEST = 0.35, LONG = 2;
  // Facets around a vertex are uneven where one has so many times the area of another.
  static constexpr double UNEVEN = 32;

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
  void find_sizes(double least_size, const std::vector<char>* is_flat);
  void mark(Index h)
  {
    const Index o = surface_->opposite(h);
    faces_[h >> 2].features |= FEATURE_EDGE << (h & 3);
    if (o >= 0) faces_[o >> 2].features |= FEATURE_EDGE << (o & 3);
  }
  void find_features(const std::vector<Index>& creases);
  void find_creases_between_planes();
  bool is_constrained(Index h) const
  {
    return (surface_->face_record(h >> 2).edge_flags & (Remeshing_mesh::CONSTRAINED << (h & 3))) != 0;
  }
  bool is_at_curved_face(Index h) const { return is_corner_[surface_->origin(h)] || is_corner_[surface_->target(h)]; }
  bool is_fold(Index h) const;
  bool is_beside_fold(Index h) const;
  void find_tangents();
  void fit_sectors();
  void fit_fan(Index first, std::vector<Vector3>& offsets);
  double turn_over(Index h) const;
  double width_at(Index h) const;
  bool is_tangent_rim(Index h) const;
  void find_flats();
  // Whether the face of h is part of a flat.
  bool is_flat(Index h) const
  {
    return !is_flat_polygon_.empty() && polygons_[h >> 2] >= 0 && is_flat_polygon_[polygons_[h >> 2]] != 0;
  }
  Vector3 normal_of_flats(const std::vector<Index>& sector) const;
  Vector3 normal_at_tangent_rims(const std::vector<Index>& sector) const;
  Vector3 normal_of_uneven_sector(const std::vector<Index>& sector) const;
  void fit_sector(const std::vector<Index>& sector, std::vector<Vector3>& offsets);
  void find_rises();
  bool turns_over(Index f) const;
  void flatten_edge(Index h);
  void straighten(Index h);
  void flatten_what_turns_over();
  void flatten_what_crosses();
  Vector3 feature_offset(Index f, int from, int to) const;

  const Reference_surface* surface_;
  std::vector<Face_data> faces_;
  std::vector<float> sizes_;                 // by face
  // Only what the curved faces need is found: the features and normals around their corners.
  std::vector<Index> curved_;
  std::vector<char> is_corner_;              // by vertex: of a curved face
  std::vector<char> is_on_fold_;             // by vertex
  Planar_polygons polygons_;
  std::vector<char> is_flat_polygon_;
  std::vector<char> tangent_rims_;           // by face: a bit for each edge at which what is beyond curves more
  std::vector<Vector3> normals_;             // unit, by sector
  std::vector<Vector3> tangents_;            // unit, by vertex on a feature; zero at corners
};

inline Mls_surface::Mls_surface(const Reference_surface& surface, const std::vector<Index>& creases, double least_size,
                                const std::vector<char>* is_flat, bool keeps_apart)
  : surface_(&surface), faces_(surface.number_of_faces())
{
  find_sizes(least_size, is_flat);
  find_features(creases);
  if (!curved_.empty()) polygons_ = Planar_polygons(surface, [this](Index h) { return is_feature(h); });
  find_creases_between_planes();
  find_flats();
  find_tangents();
  fit_sectors();
  find_rises();
  flatten_what_turns_over();
  if (keeps_apart) flatten_what_crosses();
}

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

inline void Mls_surface::find_sizes(double least_size, const std::vector<char>* is_flat)
{
  is_corner_.assign(surface_->number_of_vertices(), 0);
  sizes_.resize(faces_.size());
  for (Index f = 0; f < Index(faces_.size()); ++f) {
    const double size = is_flat != nullptr && (*is_flat)[f] ? 0. : facet_size(*surface_, f);
    sizes_[f] = float(size);
    if (!(size > least_size)) continue;
    curved_.push_back(f);
    for (int k = 0; k < 3; ++k) is_corner_[surface_->origin(4 * f + k)] = 1;
  }
}

inline bool Mls_surface::is_fold(Index h) const
{
  const Index o = surface_->opposite(h);
  return o >= 0 && !surface_->is_degenerate(h >> 2) && !surface_->is_degenerate(o >> 2) &&
         !is_cosine_at_least(surface_->cross_product(h >> 2), surface_->cross_product(o >> 2), MLS_FOLD_COSINE);
}

inline void Mls_surface::find_features(const std::vector<Index>& creases)
{
  is_on_fold_.assign(surface_->number_of_vertices(), 0);
  for (const Index h : creases) mark(h);
  for (Index h = 0; h < 4 * Index(faces_.size()); ++h) {
    if ((h & 3) == 3 || !is_at_curved_face(h)) continue;
    if (is_constrained(h) || surface_->is_border(h)) mark(h);
    if (surface_->opposite(h) < h && is_fold(h)) is_on_fold_[surface_->origin(h)] = is_on_fold_[surface_->target(h)] = 1;
  }
}

// Where two planes meet that have been designed as such, the surface has a crease, however blunt: from a dozen times the angle on to which
// polygons are plane.
inline void Mls_surface::find_creases_between_planes()
{
  constexpr double CREASE_COSINE = 0.99985;        // 1 degree
  for (Index h = 0; h < 4 * Index(faces_.size()); ++h) {
    if ((h & 3) == 3 || surface_->opposite(h) < h || is_feature(h) || !is_at_curved_face(h)) continue;
    const Index a = polygons_[h >> 2], b = polygons_[surface_->opposite(h) >> 2];
    if (a >= 0 && b >= 0 && polygons_.is_wide(a) && polygons_.is_wide(b) &&
        !is_cosine_at_least(polygons_.cross_product(a), polygons_.cross_product(b), CREASE_COSINE)) mark(h);
  }
}

// The tangent at a vertex between two feature edges where the curve has no corner, the nearer one counting more; but where one of them is
// at a flat and the other is not, it is that one.
inline void Mls_surface::find_tangents()
{
  struct Arms { int count = 0; Vector3 direction[2]; bool is_at_flat[2]; };
  std::vector<Arms> arms(surface_->number_of_vertices());
  for (Index f = 0; f < Index(faces_.size()); ++f)
    for (int k = 0; k < 3; ++k) {
      const Index h = 4 * f + k, o = surface_->opposite(h);
      if (faces_[f].features == 0) break;
      if (!is_feature(h) || (o >= 0 && o < h)) continue;
      const Index ends[2] = {surface_->origin(h), surface_->target(h)};
      const bool is_at_flat = is_flat(h) || (o >= 0 && is_flat(o));
      for (int e = 0; e < 2; ++e) {
        Arms& a = arms[ends[e]];
        if (a.count < 2) {
          a.direction[a.count] = surface_->position(ends[1 - e]) - surface_->position(ends[e]);
          a.is_at_flat[a.count] = is_at_flat;
        }
        ++a.count;
      }
    }
  for (const Index f : curved_)
    for (int k = 0; k < 3; ++k)
      if (arms[surface_->origin(4 * f + k)].count > 0) faces_[f].features |= FEATURE_VERTEX << k;
  tangents_.assign(surface_->number_of_vertices(), Vector3());
  for (std::size_t v = 0; v < arms.size(); ++v) {
    const Vector3 &in = arms[v].direction[0], &out = arms[v].direction[1];
    if (arms[v].count != 2 || !is_cosine_at_least(out, -1. * in, CORNER_COSINE)) continue;
    const double out_part = arms[v].is_at_flat[0] && !arms[v].is_at_flat[1] ? 0 : 1 / squared_length(out),
                 in_part = arms[v].is_at_flat[1] && !arms[v].is_at_flat[0] ? 0 : 1 / squared_length(in);
    const Vector3 t = out_part * out - in_part * in;
    tangents_[v] = (1 / length(t)) * t;
  }
}

inline void Mls_surface::fit_sectors()
{
  std::vector<Vector3> offsets;
  std::vector<char> is_done(surface_->number_of_vertices(), 0);
  for (const Index f : curved_)
    for (int k = 0; k < 3; ++k) {
      char& is_fan_done = is_done[surface_->origin(4 * f + k)];
      if (!is_fan_done) fit_fan(surface_->fan_start(4 * f + k), offsets);
      is_fan_done = 1;
    }
}

// The faces around a vertex, cut at the features into sectors.
inline void Mls_surface::fit_fan(Index first, std::vector<Vector3>& offsets)
{
  // A closed fan that has features begins behind one of them.
  Index start = first;
  if (!surface_->is_border(first)) {
    bool is_found = false;
    surface_->for_each_in_fan(first, [&](Index h) {
      if (!is_found && is_feature(h)) { start = h; is_found = true; }
    });
  }
  std::vector<Index> sector;
  surface_->for_each_in_fan(start, [&](Index h) {
    if (is_feature(h) && !sector.empty()) {
      fit_sector(sector, offsets);
      sector.clear();
    }
    sector.push_back(h);
  });
  fit_sector(sector, offsets);
}

// The angle from the polygon of h to the one behind it, in radians; negative where they meet in a groove.
inline double Mls_surface::turn_over(Index h) const
{
  const Vector3 &n = polygons_.cross_product(polygons_[h >> 2]), &m = polygons_.cross_product(polygons_[surface_->opposite(h) >> 2]),
                axis = cross(n, m);
  const double angle = std::atan2(length(axis), dot(n, m));
  return dot(axis, surface_->position(surface_->target(h)) - surface_->position(surface_->origin(h))) < 0 ? -angle : angle;
}

// How far the polygon of h reaches from h, about, where that is no further than along h.
inline double Mls_surface::width_at(Index h) const
{
  const double area = length(polygons_.cross_product(polygons_[h >> 2])) / 2;
  return (std::min)(std::sqrt(area), area / length(surface_->position(surface_->target(h)) - surface_->position(surface_->origin(h))));
}

// Whether behind h begins what curves, tangent to the polygon of h: over h the surface curves less, by the angles over the widths,
// than over an edge behind the next polygon, which may be a feature, to the same side; and that one is narrower. Inscribed facets turn
// from a flat by half of what they turn from each other.
inline bool Mls_surface::is_tangent_rim(Index h) const
{
  constexpr double TANGENT = 0.35, NARROWER = 2.5;
  const Index o = surface_->opposite(h), next = polygons_[o >> 2];
  if (next < 0) return false;
  const double width = std::sqrt(length(polygons_.cross_product(polygons_[h >> 2])) / 2), next_width = width_at(o);
  if (!(width > NARROWER * next_width)) return false;
  const double curvature = turn_over(h) / (width + next_width);
  const auto curves_more_beyond = [&](Index e) {
    const Index beyond = surface_->opposite(e);
    if (beyond < 0 || polygons_[beyond >> 2] < 0 || polygons_[beyond >> 2] == polygons_[h >> 2]) return false;
    const double other = turn_over(e) / (width_at(e) + width_at(beyond));
    return curvature * other > 0 && std::abs(curvature) < TANGENT * std::abs(other);
  };
  // The next polygon is a triangle or a quadrangle in most cases; of larger ones these faces are enough.
  for (const Index e : {Reference_surface::next(o), surface_->prev(o)}) {
    const Index beyond = surface_->opposite(e);
    if (beyond < 0 || polygons_[beyond >> 2] != next) {
      if (curves_more_beyond(e)) return true;
    } else if (curves_more_beyond(Reference_surface::next(beyond)) || curves_more_beyond(surface_->prev(beyond))) {
      return true;
    }
  }
  return false;
}

// A polygon in one plane is a flat if what curves joins it tangentially on all its sides, but for a tenth of their length and for features.
inline void Mls_surface::find_flats()
{
  constexpr double LEAST_SHARE = 0.9;
  struct Rim { double length = 0, tangent = 0; };
  if (curved_.empty()) return;
  std::vector<Rim> rims(polygons_.size());
  tangent_rims_.assign(faces_.size(), 0);
  for (Index h = 0; h < 4 * Index(faces_.size()); ++h) {
    if ((h & 3) == 3 || polygons_[h >> 2] < 0 || !polygons_.is_exact(polygons_[h >> 2]) || is_feature(h)) continue;
    const Index o = surface_->opposite(h);
    if (o < 0 || polygons_[o >> 2] == polygons_[h >> 2]) continue;
    const double l = length(surface_->position(surface_->target(h)) - surface_->position(surface_->origin(h)));
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

// The normal, not of unit length, of the flats of a sector, the larger ones counting more; zero where there is none.
inline Vector3 Mls_surface::normal_of_flats(const std::vector<Index>& sector) const
{
  Vector3 sum;
  for (auto h = sector.begin(); h != sector.end(); ++h) {
    const Index polygon = polygons_[*h >> 2];
    if (!is_flat(*h) || std::any_of(sector.begin(), h, [&](Index before) { return polygons_[before >> 2] == polygon; })) continue;
    const Vector3& c = polygons_.cross_product(polygon);
    sum += length(c) * c;
  }
  return sum;
}

// The normal, not of unit length, of the facets of a sector behind whose edges begins what curves more, tangent to them, as at the ends
// of a cylinder between two fillets: the shorter these edges are, the nearer it is to a facet's. Zero where there are less than two edges.
inline Vector3 Mls_surface::normal_at_tangent_rims(const std::vector<Index>& sector) const
{
  Vector3 sum;
  int rims = 0;
  for (const Index h : sector)
    for (const Index e : {h, surface_->prev(h)}) {
      if ((tangent_rims_[e >> 2] >> (e & 3) & 1) == 0) continue;
      ++rims;
      const Vector3& c = polygons_.cross_product(polygons_[e >> 2]);
      sum += (1 / (length(c) * length(surface_->position(surface_->target(e)) - surface_->position(surface_->origin(e))))) * c;
    }
  return rims > 1 ? sum : Vector3();
}

// The larger a facet is, the less it turns from the surface, where all are as near to it: a fillet is tangent to the flats that it
// joins, however small its facets are, and however the flats are triangulated. So where the facets of a sector, planar polygons and
// other faces, are uneven, the large ones say what the normal is, which is not of unit length; else it is zero.
inline Vector3 Mls_surface::normal_of_uneven_sector(const std::vector<Index>& sector) const
{
  double least = std::numeric_limits<double>::infinity(), most = 0;
  Vector3 sum;
  const auto polygon_of = [&](Index h) {
    const Index polygon = polygons_[h >> 2];
    return polygon >= 0 && polygons_.has_many_faces(polygon) ? polygon : Index(-1);
  };
  Index before = polygon_of(sector.back());
  for (const Index h : sector) {
    const Index polygon = polygon_of(h);
    if (polygon >= 0 && polygon == before) continue;
    before = polygon;
    const Vector3 c = polygon >= 0 ? polygons_.cross_product(polygon) : surface_->cross_product(h >> 2);
    const double area = length(c);
    if (!(area > 0)) continue;
    least = (std::min)(least, area);
    most = (std::max)(most, area);
    sum += area * c;
  }
  return most > UNEVEN * least ? sum : Vector3();
}

// `sector`: the half-edges that leave the vertex through the faces of the sector, counterclockwise.
inline void Mls_surface::fit_sector(const std::vector<Index>& sector, std::vector<Vector3>& offsets)
{
  const Vector3& p = surface_->position(surface_->origin(sector.front()));
  const auto offset = [&](Index v) { return surface_->position(v) - p; };
  offsets.clear();
  Vector3 sum;
  double scale = 0;
  std::size_t first_neighbors = 0;
  const auto add_first_neighbor = [&](Index v) {
    offsets.push_back(offset(v));
    scale += length(offsets.back());
    ++first_neighbors;
  };
  for (const Index h : sector) {
    const Vector3 a = offset(surface_->target(h)), b = offset(surface_->apex(h)), c = cross(a, b);
    add_first_neighbor(surface_->target(h));
    const double product = squared_length(a) * squared_length(b);
    if (!is_degenerate(c, Vector3(), a, b)) sum += (1 / product) * c;
  }
  const Index last = surface_->prev(sector.back());      // the edge behind the sector's last face
  if (surface_->origin(last) != surface_->target(sector.front())) add_first_neighbor(surface_->origin(last));
  for (const Index h : sector) {
    const Index link = Reference_surface::next(h), across = surface_->opposite(link);
    if (across >= 0 && !is_feature(link) && !is_constrained(link)) offsets.push_back(offset(surface_->apex(across)));
  }
  scale /= double(first_neighbors);
  const double l = length(sum);
  if (!(l > 0) || !(scale > 0)) return;
  Vector3 normal = normal_of_flats(sector);
  if (!(length(normal) > 0)) normal = normal_at_tangent_rims(sector);
  if (!(length(normal) > 0)) normal = normal_of_uneven_sector(sector);
  const double n = length(normal);
  for (const Index h : sector) faces_[h >> 2].sector[h & 3] = Index(normals_.size());
  normals_.push_back(n > 0 ? (1 / n) * normal : fit_normal(offsets, (1 / l) * sum, scale));
}

// Whether one of the faces at h touches a fold.
inline bool Mls_surface::is_beside_fold(Index h) const
{
  const Index across = surface_->opposite(h);
  return is_on_fold_[surface_->origin(h)] || is_on_fold_[surface_->target(h)] || is_on_fold_[surface_->apex(h)] ||
         (across >= 0 && is_on_fold_[surface_->apex(across)]);
}

inline void Mls_surface::find_rises()
{
  for (const Index f : curved_)
    for (int k = 0; k < 3; ++k) {
      const Vector3 n = corner_normal(f, k);
      for (int side = 0; side < 2; ++side) {
        const Index h = 4 * f + (k + 2 * side) % 3, across = surface_->opposite(h);
        if (is_beside_fold(h)) continue;
        const Vector3 e = corner(f, (k + 1 + side) % 3) - corner(f, k);
        const double size = across >= 0 ? (std::min)(sizes_[f], sizes_[across >> 2]) : sizes_[f];
        const double l = length(e), bound = STEEPEST * l, part = l > LONG * size ? LONG * size / l : 1.;
        faces_[f].rise[k][side] = float(part * part * (std::max)(-bound, (std::min)(bound, dot(e, n))));
      }
    }
}

// Whether the surface over face f somewhere makes the angle of a fold with it. Where it hardly rises beside the width of the face, it
// cannot.
inline bool Mls_surface::turns_over(Index f) const
{
  constexpr double LEAST_RISE = 0.5;               // in altitudes
  constexpr int PARTS = 3;                         // of each edge
  float highest = 0;
  for (const auto& at_corner : faces_[f].rise)
    for (const float rise : at_corner) highest = (std::max)(highest, std::abs(rise));
  if (double(highest) <= LEAST_RISE * surface_->least_altitude(f)) return false;
  const auto at = [&](int i, int j) { return point(f, {double(PARTS - i - j) / PARTS, double(i) / PARTS, double(j) / PARTS}); };
  const Vector3& c = surface_->cross_product(f);
  const auto is_steep = [&](const Vector3& p, const Vector3& q, const Vector3& r) {
    return !is_cosine_at_least(triangle_cross(p, q, r), c, MLS_FOLD_COSINE);
  };
  for (int i = 0; i < PARTS; ++i)
    for (int j = 0; i + j < PARTS; ++j) {
      const Vector3 p = at(i, j), q = at(i + 1, j), r = at(i, j + 1);
      if (is_steep(p, q, r) || (i + j + 1 < PARTS && is_steep(q, at(i + 1, j + 1), r))) return true;
    }
  return false;
}

inline void Mls_surface::straighten(Index h)
{
  faces_[h >> 2].features |= STRAIGHT_EDGE << (h & 3);
  if (surface_->opposite(h) >= 0) faces_[surface_->opposite(h) >> 2].features |= STRAIGHT_EDGE << (surface_->opposite(h) & 3);
}

inline void Mls_surface::flatten_edge(Index h)
{
  const auto flatten = [&](Index side) {
    const int k = side & 3;
    faces_[side >> 2].rise[k][0] = faces_[side >> 2].rise[(k + 1) % 3][1] = 0;
  };
  flatten(h);
  if (surface_->opposite(h) >= 0) flatten(surface_->opposite(h));
}

// One that is flattened changes those around it.
inline void Mls_surface::flatten_what_turns_over()
{
  std::vector<Index> suspects = curved_;
  while (!suspects.empty()) {
    const Index f = suspects.back();
    suspects.pop_back();
    if (!turns_over(f)) continue;
    for (Index h = 4 * f; h < 4 * f + 3; ++h) {
      flatten_edge(h);
      if (surface_->opposite(h) >= 0) suspects.push_back(surface_->opposite(h) >> 2);
    }
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

// Where the faces of the reference surface cross each other, nothing is gained.
inline void Mls_surface::flatten_what_crosses()
{
  if (curved_.empty()) return;
  Close_patches<Mls_surface>(*this).part([&](Index f) {
    for (Index h = 4 * f; h < 4 * f + 3; ++h) {
      flatten_edge(h);
      if (is_feature(h)) straighten(h);
    }
  });
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

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_MLS_SURFACE_H
