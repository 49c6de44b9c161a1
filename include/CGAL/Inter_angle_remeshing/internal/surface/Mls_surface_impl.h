// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_MLS_SURFACE_IMPL_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_MLS_SURFACE_IMPL_H

#include <CGAL/Inter_angle_remeshing/internal/surface/Close_patches.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/Curve_tangents.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/Cut_rims.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/Mls_flats.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/Mls_surface.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/Planar_polygons.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/sector_fit.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// What fits an Mls_surface to its facets. It finds what the curved faces need: the features and the normals around their corners, and the
// edges that have to stay flat.
class Mls_surface_fit
{
public:
  using Index = Mls_surface::Index;

  // Of `mls` nothing is known but its reference surface.
  explicit Mls_surface_fit(Mls_surface& mls) : mls_(mls), surface_(mls.reference_surface()) {}

  // The arguments are those of the constructor of Mls_surface.
  void run(const std::vector<Index>& creases, double least_size, const std::vector<char>* is_flat, bool keeps_apart)
  {
    find_sizes(least_size, is_flat);
    find_features(creases);
    Planar_polygons polygons;
    if (!curved_.empty()) {
      const auto is_feature = [this](Index h) { return mls_.is_feature(h); };
      polygons = Planar_polygons(surface_, is_feature);
      find_creases_between_planes(polygons);
      for (const Index h : Cut_rims(surface_, polygons).find()) mark(h);
      flats_.emplace(surface_, polygons, is_feature);
    }
    find_tangents();
    fit_sectors();
    find_rises();
    flatten_what_turns_over();
    if (keeps_apart) flatten_what_crosses();
  }

private:
  void find_sizes(double least_size, const std::vector<char>* is_flat)
  {
    is_corner_.assign(surface_.number_of_vertices(), 0);
    mls_.sizes_.resize(mls_.faces_.size());
    for (Index f = 0; f < Index(mls_.faces_.size()); ++f) {
      const double size = is_flat != nullptr && (*is_flat)[f] ? 0. : facet_size(surface_, f);
      mls_.sizes_[f] = float(size);
      if (!(size > least_size)) continue;
      curved_.push_back(f);
      for (int k = 0; k < 3; ++k) is_corner_[surface_.origin(4 * f + k)] = 1;
    }
  }

  void mark(Index h)
  {
    const Index o = surface_.opposite(h);
    mls_.faces_[h >> 2].features |= Mls_surface::FEATURE_EDGE << (h & 3);
    if (o >= 0) mls_.faces_[o >> 2].features |= Mls_surface::FEATURE_EDGE << (o & 3);
  }

  bool is_constrained(Index h) const
  {
    return (surface_.face_record(h >> 2).edge_flags & (Remeshing_mesh::CONSTRAINED << (h & 3))) != 0;
  }

  bool is_at_curved_face(Index h) const { return is_corner_[surface_.origin(h)] || is_corner_[surface_.target(h)]; }

  bool is_fold(Index h) const
  {
    const Index o = surface_.opposite(h);
    return o >= 0 && !surface_.is_degenerate(h >> 2) && !surface_.is_degenerate(o >> 2) &&
           !is_cosine_at_least(surface_.cross_product(h >> 2), surface_.cross_product(o >> 2), MLS_FOLD_COSINE);
  }

  void find_features(const std::vector<Index>& creases)
  {
    is_on_fold_.assign(surface_.number_of_vertices(), 0);
    for (const Index h : creases) mark(h);
    for (Index h = 0; h < 4 * Index(mls_.faces_.size()); ++h) {
      if ((h & 3) == 3 || !is_at_curved_face(h)) continue;
      if (is_constrained(h) || surface_.is_border(h)) mark(h);
      if (surface_.opposite(h) < h && is_fold(h)) is_on_fold_[surface_.origin(h)] = is_on_fold_[surface_.target(h)] = 1;
    }
  }

  // Where two planes meet that have been designed as such, the surface has a crease, however blunt: from a dozen times the angle on to
  // which polygons are plane.
  void find_creases_between_planes(const Planar_polygons& polygons)
  {
    constexpr double CREASE_COSINE = 0.99985;        // 1 degree
    for (Index h = 0; h < 4 * Index(mls_.faces_.size()); ++h) {
      if ((h & 3) == 3 || surface_.opposite(h) < h || mls_.is_feature(h) || !is_at_curved_face(h)) continue;
      const Index a = polygons[h >> 2], b = polygons[surface_.opposite(h) >> 2];
      if (a >= 0 && b >= 0 && polygons.is_wide(a) && polygons.is_wide(b) &&
          !is_cosine_at_least(polygons.cross_product(a), polygons.cross_product(b), CREASE_COSINE)) mark(h);
    }
  }

  bool is_flat(Index h) const { return flats_ && flats_->is_flat(h); }

  // A tangent takes in how the curve runs on, where it may have left the curved faces.
  void find_tangents()
  {
    Curve_tangents tangents(surface_);
    for (Index f = 0; f < Index(mls_.faces_.size()); ++f)
      for (Index h = 4 * f; h < 4 * f + 3; ++h) {
        const Index o = surface_.opposite(h);
        if ((mls_.is_feature(h) || is_constrained(h) || o < 0) && !(o >= 0 && o < h))
          tangents.add_edge(h, is_flat(h) || (o >= 0 && is_flat(o)));
      }
    mls_.tangents_.assign(surface_.number_of_vertices(), Vector3());
    for (const Index f : curved_)
      for (int k = 0; k < 3; ++k) {
        const Index v = surface_.origin(4 * f + k);
        if (!tangents.is_on_curve(v)) continue;
        mls_.faces_[f].features |= Mls_surface::FEATURE_VERTEX << k;
        mls_.tangents_[v] = tangents.tangent(v);
      }
  }

  void fit_sectors()
  {
    std::vector<Vector3> offsets;
    std::vector<char> is_done(surface_.number_of_vertices(), 0);
    for (const Index f : curved_)
      for (int k = 0; k < 3; ++k) {
        char& is_fan_done = is_done[surface_.origin(4 * f + k)];
        if (!is_fan_done) fit_fan(surface_.fan_start(4 * f + k), offsets);
        is_fan_done = 1;
      }
  }

  // The faces around a vertex, cut at the features into sectors.
  void fit_fan(Index first, std::vector<Vector3>& offsets)
  {
    // A closed fan that has features begins behind one of them.
    Index start = first;
    if (!surface_.is_border(first)) {
      bool is_found = false;
      surface_.for_each_in_fan(first, [&](Index h) {
        if (!is_found && mls_.is_feature(h)) { start = h; is_found = true; }
      });
    }
    std::vector<Index> sector;
    surface_.for_each_in_fan(start, [&](Index h) {
      if (mls_.is_feature(h) && !sector.empty()) {
        fit_sector(sector, offsets);
        sector.clear();
      }
      sector.push_back(h);
    });
    fit_sector(sector, offsets);
  }

  // `sector`: the half-edges that leave the vertex through the faces of the sector, counterclockwise.
  void fit_sector(const std::vector<Index>& sector, std::vector<Vector3>& offsets)
  {
    const Vector3& p = surface_.position(surface_.origin(sector.front()));
    const auto offset = [&](Index v) { return surface_.position(v) - p; };
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
      const Vector3 a = offset(surface_.target(h)), b = offset(surface_.apex(h)), c = cross(a, b);
      add_first_neighbor(surface_.target(h));
      const double product = squared_length(a) * squared_length(b);
      if (!is_degenerate(c, Vector3(), a, b)) sum += (1 / product) * c;
    }
    const Index last = surface_.prev(sector.back());      // the edge behind the sector's last face
    if (surface_.origin(last) != surface_.target(sector.front())) add_first_neighbor(surface_.origin(last));
    for (const Index h : sector) {
      const Index link = Reference_surface::next(h), across = surface_.opposite(link);
      if (across >= 0 && !mls_.is_feature(link) && !is_constrained(link)) offsets.push_back(offset(surface_.apex(across)));
    }
    scale /= double(first_neighbors);
    const double l = length(sum);
    if (!(l > 0) || !(scale > 0)) return;
    const Vector3 normal = flats_->normal(sector);
    const double n = length(normal);
    for (const Index h : sector) mls_.faces_[h >> 2].sector[h & 3] = Index(mls_.normals_.size());
    mls_.normals_.push_back(n > 0 ? (1 / n) * normal : fit_normal(offsets, (1 / l) * sum, scale));
  }

  // Whether one of the faces at h touches a fold.
  bool is_beside_fold(Index h) const
  {
    const Index across = surface_.opposite(h);
    return is_on_fold_[surface_.origin(h)] || is_on_fold_[surface_.target(h)] || is_on_fold_[surface_.apex(h)] ||
           (across >= 0 && is_on_fold_[surface_.apex(across)]);
  }

  // What curves at the ends of an edge says little about one that is more than twice as long as the faces beside it are large: there it
  // falls with the square of that.
  void find_rises()
  {
    constexpr double LONG = 2;
    for (const Index f : curved_)
      for (int k = 0; k < 3; ++k) {
        const Vector3 n = mls_.corner_normal(f, k);
        for (int side = 0; side < 2; ++side) {
          const Index h = 4 * f + (k + 2 * side) % 3, across = surface_.opposite(h);
          if (is_beside_fold(h)) continue;
          const Vector3 e = mls_.corner(f, (k + 1 + side) % 3) - mls_.corner(f, k);
          const double size = across >= 0 ? (std::min)(mls_.sizes_[f], mls_.sizes_[across >> 2]) : mls_.sizes_[f];
          const double l = length(e), bound = Mls_surface::STEEPEST * l, part = l > LONG * size ? LONG * size / l : 1.;
          mls_.faces_[f].rise[k][side] = float(part * part * (std::max)(-bound, (std::min)(bound, dot(e, n))));
        }
      }
  }

  // Whether the surface over face f somewhere makes the angle of a fold with it. Where it hardly rises beside the width of the face, it
  // cannot.
  bool turns_over(Index f) const
  {
    constexpr double LEAST_RISE = 0.5;               // in altitudes
    constexpr int PARTS = 3;                         // of each edge
    float highest = 0;
    for (const auto& at_corner : mls_.faces_[f].rise)
      for (const float rise : at_corner) highest = (std::max)(highest, std::abs(rise));
    if (double(highest) <= LEAST_RISE * surface_.least_altitude(f)) return false;
    const auto at = [&](int i, int j) { return mls_.point(f, {double(PARTS - i - j) / PARTS, double(i) / PARTS, double(j) / PARTS}); };
    const Vector3& c = surface_.cross_product(f);
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

  void straighten(Index h)
  {
    mls_.faces_[h >> 2].features |= Mls_surface::STRAIGHT_EDGE << (h & 3);
    const Index o = surface_.opposite(h);
    if (o >= 0) mls_.faces_[o >> 2].features |= Mls_surface::STRAIGHT_EDGE << (o & 3);
  }

  void flatten_edge(Index h)
  {
    const auto flatten = [&](Index side) {
      const int k = side & 3;
      mls_.faces_[side >> 2].rise[k][0] = mls_.faces_[side >> 2].rise[(k + 1) % 3][1] = 0;
    };
    flatten(h);
    if (surface_.opposite(h) >= 0) flatten(surface_.opposite(h));
  }

  // One that is flattened changes those around it.
  void flatten_what_turns_over()
  {
    std::vector<Index> suspects = curved_;
    while (!suspects.empty()) {
      const Index f = suspects.back();
      suspects.pop_back();
      if (!turns_over(f)) continue;
      for (Index h = 4 * f; h < 4 * f + 3; ++h) {
        flatten_edge(h);
        if (surface_.opposite(h) >= 0) suspects.push_back(surface_.opposite(h) >> 2);
      }
    }
  }

  // Where the faces of the reference surface cross each other, nothing is gained.
  void flatten_what_crosses()
  {
    if (curved_.empty()) return;
    Close_patches<Mls_surface>(mls_).part([&](Index f) {
      for (Index h = 4 * f; h < 4 * f + 3; ++h) {
        flatten_edge(h);
        if (mls_.is_feature(h)) straighten(h);
      }
    });
  }

  Mls_surface& mls_;
  const Reference_surface& surface_;
  std::vector<Index> curved_;
  std::vector<char> is_corner_;              // by vertex: of a curved face
  std::vector<char> is_on_fold_;             // by vertex
  std::optional<Mls_flats> flats_;           // where there are curved faces
};

CGAL_INTER_ANGLE_REMESHING_INLINE
Mls_surface::Mls_surface(const Reference_surface& surface, const std::vector<Index>& creases, double least_size,
                         const std::vector<char>* is_flat, bool keeps_apart)
  : surface_(&surface), faces_(surface.number_of_faces())
{
  Mls_surface_fit(*this).run(creases, least_size, is_flat, keeps_apart);
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_MLS_SURFACE_IMPL_H
