// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_RELEASE_FEATURES_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_RELEASE_FEATURES_H

#include <CGAL/Inter_angle_remeshing/internal/Remeshing_context.h>
#include <CGAL/Inter_angle_remeshing/internal/curves/curves.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/angle_energy.h>

#include <vector>

// Features that are given up. Where parts of an implicit surface or of a wrap meet, creases are jagged: corners of features lie so close
// together that the faces between them are needles, whatever is done. And crests are no features: they guide the iterations alone.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

class Feature_release
{
  using Index = Remeshing_mesh::Index;

public:
  explicit Feature_release(Remeshing_context& context) : context_(context), mesh_(context.mesh) {}

  // On models that are no CAD models.
  void release_close_corners()
  {
    std::vector<Index> vertices;
    const Angle_band band(LEAST_ANGLE, 180);
    for (Index f = 0; f < Index(mesh_.number_of_face_slots()); ++f) {
      if (!mesh_.is_face(f)) continue;
      const auto& v = mesh_.face_record(f).vertex;
      if (band.holds(mesh_.position(v[0]), mesh_.position(v[1]), mesh_.position(v[2]))) continue;
      for (const Index u : v)
        if (is_close_corner(u)) vertices.push_back(u);
    }
    for (const Index v : vertices) release(v);
  }

  void release_crests()
  {
    std::vector<Index> crests;
    mesh_.for_each_edge([&](Index h) { if (mesh_.has_flag(h, Remeshing_mesh::PASSING)) crests.push_back(h); });
    for (const Index h : crests) release_edge(h);
    for (const Index h : crests)
      for (const Index v : {mesh_.origin(h), mesh_.target(h)}) settle(v);
  }

private:
  // Two corners are too close together where a face beside them has an angle less than this.
  static constexpr double LEAST_ANGLE = 20;

  // Whether v is a corner of nothing but found features, close to another corner on one of these.
  bool is_close_corner(Index v) const
  {
    constexpr unsigned STAYS = Remeshing_mesh::ON_BORDER | Remeshing_mesh::PINNED | Remeshing_mesh::PINCHED;
    if (!mesh_.is_on_curve(v) || !mesh_.is_locked(v) || (mesh_.marks(v) & STAYS) != 0 || is_kept(v)) return false;
    bool is_close = false;
    for_each_curve_halfedge(mesh_, v, [&](Index h) {
      const double least = context_.release_distance * context_.length_at(v, mesh_.target(h));
      is_close = is_close || (mesh_.is_locked(mesh_.target(h)) && mesh_.squared_edge_length(h) < least * least);
    });
    return is_close;
  }

  // Whether v is at an edge that the user marked, or is locked because such an edge, or a fan of faces, is to stay as it is.
  bool is_kept(Index v) const
  {
    return !mesh_.all_around(v, [&](Index h) {
      return !mesh_.is_marked_by_user(h) && !mesh_.is_protected(h) && !mesh_.is_protected(mesh_.next(h)); });
  }

  void release(Index v)
  {
    std::vector<Index> features;
    for_each_curve_halfedge(mesh_, v, [&](Index h) { features.push_back(h); });
    for (const Index h : features) {
      release_edge(h);
      settle(mesh_.target(h));
    }
    settle(v);
  }

  void release_edge(Index h)
  {
    mesh_.remove_flags(h, Remeshing_mesh::CONSTRAINED | Remeshing_mesh::FOUND | Remeshing_mesh::PASSING | Remeshing_mesh::ON_CURVE);
  }

  // A vertex that has lost features is the end of the others, or free.
  void settle(Index v)
  {
    if (mesh_.is_border_vertex(v)) return;
    bool is_end = is_kept(v);
    for_each_curve_halfedge(mesh_, v, [&](Index) { is_end = true; });
    if (is_end) mesh_.add_marks(v, Remeshing_mesh::LOCKED);
    else {
      mesh_.remove_marks(v, Remeshing_mesh::ON_FEATURE | Remeshing_mesh::LOCKED);
      mesh_.set_regular_valence(v, 6);
    }
  }

  const Remeshing_context& context_;
  Remeshing_mesh& mesh_;
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_RELEASE_FEATURES_H
