// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_DEFAULT_SURFACE_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_DEFAULT_SURFACE_H

#include <CGAL/Inter_angle_remeshing/internal/curves/Input_curves.h>
#include <CGAL/Inter_angle_remeshing/internal/features/feature_detection.h>
#include <CGAL/Inter_angle_remeshing/internal/features/input_kind.h>
#include <CGAL/Inter_angle_remeshing/internal/sizing/sizing.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/Mls_surface.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/projection.h>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// The default: facets where they are at most twice as large as the target is long, for they are what the result is measured
// against; the MLS surface where they are three times as large, for there they would show; smooth between. Where hardly any
// facet is that large, the run is one at the input's own length, and the facets rule everywhere; so they do on CAD models, and
// parts of a scene that are such, where they are what the design was approximated by, on wraps of these, and on stairs of voxels.
struct Default_surface
{
  static constexpr double FACET_RATIO = 2, SMOOTH_RATIO = 3;
  static constexpr double LEAST_SHARE = 0.05;       // of the area

  Default_surface(const Remeshing_mesh& mesh, double target, const Sizing& sizing, const Input_kind& kind)
    : facets(mesh), face_of_source(faces_by_source(facets)), target_length(target)
  {
    if (kind.is_faceted) return;
    float smallest_part = 1;
    if (!sizing.is_uniform()) {
      for (Remeshing_mesh::Index f = 0; f < Remeshing_mesh::Index(facets.number_of_faces()); ++f)
        parts.push_back(float(sizing.part_of_face(facets.face_record(f).source)));
      smallest_part = *std::min_element(parts.begin(), parts.end());
    }
    std::vector<char> is_flat(facets.number_of_faces(), 0);
    for (std::size_t f = 0; f < is_flat.size() && !kind.is_in_faceted_part.empty(); ++f)
      is_flat[f] = kind.is_in_faceted_part[facets.face_record(Remeshing_mesh::Index(f)).source];
    double all = 0, large_ones = 0;
    for (Remeshing_mesh::Index f = 0; f < Remeshing_mesh::Index(facets.number_of_faces()); ++f) {
      const double area = length(facets.cross_product(f));
      all += area;
      const double bound = FACET_RATIO * target * part(f);
      if (!is_flat[f] && mean_edge_length(facets, f) > bound && facet_size(facets, f) > bound) large_ones += area;
    }
    if (!(large_ones > LEAST_SHARE * all)) return;
    const std::vector<Remeshing_mesh::Index> creases =
      kind.searches_features ? std::vector<Remeshing_mesh::Index>() : find_features(mesh);
    smooth.emplace(facets, creases, FACET_RATIO * target * double(smallest_part), &is_flat);
  }
  Default_surface(const Default_surface&) = delete;     // `smooth` refers to `facets`
  Default_surface& operator=(const Default_surface&) = delete;
  Projection projection() const
  {
    Projection result{&facets, 1, smooth ? &*smooth : nullptr, FACET_RATIO * target_length, SMOOTH_RATIO * target_length};
    if (!parts.empty()) result.parts = &parts;
    result.face_of_source = &face_of_source;
    return result;
  }

  // Bends the curves of the mesh into those of the surface, where the mesh as a whole is refined by so much: a border is
  // measured against its polyline before that. Edges that the user marked stay straight.
  void bend(Input_curves& curves, double mean_length, const Remeshing_mesh& mesh) const
  {
    if (!smooth || mean_length < SMOOTH_RATIO * target_length) return;
    const Projection blend = projection();
    curves.bend([&](Remeshing_mesh::Index h) {
      const Remeshing_mesh::Index o = facets.opposite(h);
      double share = blend.share_of_mls(blend.facet_size(h >> 2));
      if (o >= 0) share = (share + blend.share_of_mls(blend.facet_size(o >> 2))) / 2;
      if (mesh.is_marked_by_user(h)) return std::array<Vector3, 2>{};
      std::array<Vector3, 2> offsets = smooth->curve_offsets(h);
      for (Vector3& d : offsets) d = share * d;
      return offsets;
    });
  }

  // The area of the surface over that of the facets.
  double area_ratio() const
  {
    if (!smooth) return 1;
    double flat = 0, curved = 0;
    for (Remeshing_mesh::Index f = 0; f < Remeshing_mesh::Index(facets.number_of_faces()); ++f) {
      const double area = length(facets.cross_product(f)) / 2;
      flat += area;
      curved += smooth->size(f) > FACET_RATIO * target_length * part(f) ? smooth->area(f) : area;
    }
    return curved / flat;
  }

  // Of the target length, on face f.
  double part(Remeshing_mesh::Index f) const { return parts.empty() ? 1. : double(parts[f]); }

  Reference_surface facets;
  std::vector<Remeshing_mesh::Index> face_of_source;
  std::optional<Mls_surface> smooth;
  double target_length;
  std::vector<float> parts;      // by face; empty: uniform
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_DEFAULT_SURFACE_H
