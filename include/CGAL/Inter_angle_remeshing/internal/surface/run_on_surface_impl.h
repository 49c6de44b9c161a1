// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_RUN_ON_SURFACE_IMPL_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_RUN_ON_SURFACE_IMPL_H

#include <CGAL/Inter_angle_remeshing/internal/features/feature_detection.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/edge_lengths.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/Default_surface.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/Part_of_surface.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/paper_surface.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/run_on_surface.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/starting_places.h>

#include <cmath>
#include <optional>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// A surface that the user handed over. Where the mesh is a part of it, all of it or a range of its faces, the projection is onto a copy of
// that part: walks keep to it and to the patches of the run, and begin where the vertices are.
class Handed_surface
{
public:
  using Index = Remeshing_mesh::Index;

  // `mls`, if there is one, smooths the surface and knows no other.
  Handed_surface(const Reference_surface& surface, const Mls_surface* mls, Remeshing_mesh& mesh)
    : projection_{&surface, mesh.unit() / surface.unit(), mls}
  {
    const Part_of_surface part(mesh, surface, projection_.factor);
    if (!part.is_part()) {
      projection_.may_be_elsewhere = true;
      if (looks_to_other_side(mesh, surface, projection_.factor)) projection_.side = -1;
      find_hints(mesh, projection_);
      return;
    }
    copy_.emplace(mesh);
    if (mls != nullptr) mls_.emplace(*mls, *copy_, 1 / projection_.factor, [&](Index h) { return part.halfedge(h); });
    projection_ = Projection{&*copy_, 1, mls_ ? &*mls_ : nullptr};
    face_of_source_ = faces_by_source(*copy_);
    projection_.face_of_source = &face_of_source_;
    start_where_vertices_are(mesh);
  }
  Handed_surface(const Handed_surface&) = delete;            // the projection refers to what it holds
  Handed_surface& operator=(const Handed_surface&) = delete;

  const Projection& projection() const { return projection_; }

private:
  Projection projection_;
  std::optional<Reference_surface> copy_;
  std::optional<Mls_surface> mls_;
  std::vector<Index> face_of_source_;
};

inline Remeshing_report run_on_paper_surface(Remeshing_mesh& mesh, const Run_on_surface& run)
{
  const Reference_surface facets(mesh);
  const std::vector<Remeshing_mesh::Index> face_of_source = faces_by_source(facets);
  const auto rule = paper_surface(facets, find_features(mesh));
  start_where_vertices_are(mesh);
  Projection projection{&facets};
  projection.face_of_source = &face_of_source;
  if (rule) projection.rule = &rule;
  return run(projection);
}

CGAL_INTER_ANGLE_REMESHING_INLINE
Remeshing_report run_on_own_surface(Remeshing_mesh& mesh, const Recipe& recipe, const Input_kind& kind, Input_curves& curves,
                                    Target& target, const Run_on_surface& run)
{
  if (recipe.surface == Recipe::Surface::paper) return run_on_paper_surface(mesh, run);
  const Default_surface surface(mesh, target.length, target.sizing, kind);
  start_where_vertices_are(mesh);
  surface.bend(curves, mean_edge_length(mesh), mesh);
  if (target.faces > 0) target.length *= std::sqrt(surface.area_ratio());
  return run(surface.projection());
}

CGAL_INTER_ANGLE_REMESHING_INLINE
Remeshing_report run_on_handed_surface(const Reference_surface& surface, const Mls_surface* mls, Remeshing_mesh& mesh,
                                       const Run_on_surface& run)
{
  return run(Handed_surface(surface, mls, mesh).projection());
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_RUN_ON_SURFACE_IMPL_H
