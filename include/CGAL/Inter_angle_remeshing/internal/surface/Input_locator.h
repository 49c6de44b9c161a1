// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_INPUT_LOCATOR_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_INPUT_LOCATOR_H

#include <CGAL/Inter_angle_remeshing/internal/surface/Mls_surface.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/Reference_surface.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/projection.h>

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

// Where on the input a point of the result is.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// A point of the input: the number of a face, and the barycentric coordinates on it.
struct Input_place
{
  Remeshing_mesh::Index source;
  std::array<double, 3> coordinates;
};

// Walks from where the projector left a vertex, if the projector's faces are those of the input; else it has to search. A face stays in
// the patch of the one that it descends from, and a vertex in those of the faces around it: another one may be as near, at a border that
// touches another, or where sheets lie close together.
class Input_locator
{
  using Index = Remeshing_mesh::Index;

public:
  Input_locator(const Input_locator&) = delete;           // it may refer to what it holds
  Input_locator& operator=(const Input_locator&) = delete;

  // The mesh still is the input.
  Input_locator(const Projection& projection, const Remeshing_mesh& mesh)
  {
    if (projection.face_of_source == nullptr) {
      copy_ = std::make_unique<Reference_surface>(mesh);
      surface_ = copy_.get();
      face_in_copy_ = faces_by_source(*copy_);
      face_of_source_ = &face_in_copy_;
    } else {
      surface_ = projection.surface;
      factor_ = projection.factor;
      face_of_source_ = projection.face_of_source;
    }
    note_patches();
  }

  Input_place place_of_vertex(const Remeshing_mesh& mesh, Index v) const
  {
    const Vector3& p = mesh.position(v);
    Index f = copy_ == nullptr ? mesh.hint(v) : 0;
    if (copy_ != nullptr) copy_->locate(p, f);
    const bool is_in_other_patch = mesh.all_around(v, [&](Index h) { return patch_[f] != patch_[face_of_origin(mesh, mesh.face(h))]; });
    if (is_in_other_patch) f = face_of_origin(mesh, mesh.face(mesh.first(v)));
    return is_in_other_patch || copy_ == nullptr ? place_by_walk(p, f) : place_on_face(p, f);
  }
  // Of the centroid of face f, in the patch of the face that it descends from.
  Input_place place_of_face(const Remeshing_mesh& mesh, Index f) const
  {
    const Vector3 centroid = centroid_of(mesh, f);
    return place_on_face(centroid, face_at_centroid(mesh, f, centroid));
  }
  // Of the origin of h, on that side of the curves there on which the face of h is.
  Input_place place_of_corner(const Remeshing_mesh& mesh, Index h) const
  {
    const Vector3 centroid = centroid_of(mesh, mesh.face(h)), p = mesh.position(mesh.origin(h));
    Index f = face_at_centroid(mesh, mesh.face(h), centroid);
    for (int i = 1; i < STRIDES; ++i) surface_->walk(factor_ * (centroid + (double(i) / STRIDES) * (p - centroid)), f);
    return place_by_walk(p, f);
  }

private:
  // A walk to a corner is made in so many parts, so that bends of the surface on its way do not end it.
  static constexpr int STRIDES = 4;

  static Vector3 centroid_of(const Remeshing_mesh& mesh, Index f)
  {
    Vector3 centroid;
    for (const Index v : mesh.face_record(f).vertex) centroid += (1. / 3) * mesh.position(v);
    return centroid;
  }

  // The face of the surface that face f descends from.
  Index face_of_origin(const Remeshing_mesh& mesh, Index f) const { return (*face_of_source_)[mesh.face_record(f).source]; }

  // The face of the surface that is nearest to the centroid of face f, in the patch of the one that f descends from: that of the walks
  // from there and from the places of the corners, as a flip may have taken f far from where it descends from.
  Index face_at_centroid(const Remeshing_mesh& mesh, Index f, const Vector3& centroid) const
  {
    const Index start = face_of_origin(mesh, f);
    Index nearest = start;
    if (copy_ != nullptr) {
      copy_->locate(centroid, nearest);
      if (patch_[nearest] == patch_[start]) return nearest;
      nearest = start;
    }
    const Vector3 q = factor_ * centroid;
    double least = squared_distance(surface_->walk(q, nearest), q);
    if (copy_ != nullptr) return nearest;
    for (const Index v : mesh.face_record(f).vertex) {
      Index g = mesh.hint(v);
      if (patch_[g] != patch_[start]) continue;
      const double d = squared_distance(surface_->walk(q, g), q);
      if (d < least) { least = d; nearest = g; }
    }
    return nearest;
  }

  // Which faces of the surface hang together without a barrier in between; crests are none for what the result is to carry.
  void note_patches()
  {
    const Index n = Index(surface_->number_of_faces());
    patch_.assign(std::size_t(n), -1);
    std::vector<Index> queue;
    for (Index first = 0; first < n; ++first) {
      if (patch_[first] >= 0) continue;
      patch_[first] = first;
      queue.assign(1, first);
      while (!queue.empty()) {
        const Index f = queue.back();
        queue.pop_back();
        for (Index h = 4 * f; h < 4 * f + 3; ++h) {
          const Index o = surface_->opposite(h);
          const bool is_crest = (surface_->face_record(f).edge_flags & (Remeshing_mesh::PASSING << (h & 3))) != 0;
          if (o < 0 || (is_barrier(*surface_, h) && !is_crest) || patch_[o >> 2] >= 0) continue;
          patch_[o >> 2] = first;
          queue.push_back(o >> 2);
        }
      }
    }
  }

  Input_place place_by_walk(const Vector3& p, Index f) const
  {
    const Point_on_triangle closest = surface_->closest_point_near(factor_ * p, f);
    return place(closest, f);
  }
  Input_place place_on_face(const Vector3& p, Index f) const { return place(closest_point_on_face(*surface_, factor_ * p, f), f); }
  Input_place place(const Point_on_triangle& closest, Index f) const
  {
    const auto& v = surface_->face_record(f).vertex;
    std::array<double, 3> b = barycentric(closest, surface_->position(v[0]), surface_->position(v[1]), surface_->position(v[2]));
    for (double& x : b) x = (std::max)(0., x);       // on needles they may be off by rounding
    const double sum = b[0] + b[1] + b[2];
    for (double& x : b) x /= sum;
    return {surface_->face_record(f).source, b};
  }

  const Reference_surface* surface_ = nullptr;
  double factor_ = 1;                                   // from the mesh's units to the surface's
  const std::vector<Index>* face_of_source_ = nullptr;  // the projector's, or that of the copy
  std::unique_ptr<const Reference_surface> copy_;       // of the input, where the projector knows another surface, or none
  std::vector<Index> face_in_copy_, patch_;             // by face of the input; by face of the surface
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_INPUT_LOCATOR_H
