// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_DISTANCE_SAMPLES_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_DISTANCE_SAMPLES_H

#include <CGAL/Inter_angle_remeshing/internal/Remeshing_context.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/mesh_regions.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/place_on_surface.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/Mls_surface.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/Reference_surface.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/surface_walk.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

// Samples of the surface and of the mesh, and how far each is from the other one. Distances are found by walks; where one ends
// farther away than is good enough, what is near by is looked at.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

class Distance_samples
{
  using Index = Remeshing_mesh::Index;
  using Barycentric = Mls_surface::Barycentric;

  // Longest distance between samples on an edge of the surface, in target lengths.
  static constexpr double SPACING = 0.9;

public:
  struct Sample
  {
    Vector3 point;
    Index surface_face, face;            // on the surface; of the mesh, near by
  };

  // Distances up to this part of the tolerance are not looked into further.
  static constexpr double GOOD = 0.85;

  explicit Distance_samples(const Remeshing_context& context)
    : context_(context), mesh_(context.mesh), surface_(*context.projector.surface)
  {}

  // The scale of what is looked at from now on: the target length at vertex v.
  void set_scale_at(Index v)
  {
    length_ = context_.length_at(v);
    tolerance_ = context_.recipe.distance_tolerance * length_;
    enough_ = GOOD * tolerance_ * GOOD * tolerance_;
  }
  double length() const { return length_; }
  // The largest distance that is let be.
  double tolerance() const { return tolerance_; }

  // Calls `function(surface face)` for the faces of the surface that have a corner within `radius` of p, from face f on.
  template <class Function>
  void for_each_face_near(const Vector3& p, double radius, Index f, const Function& function)
  {
    std::vector<Index> queue;
    surface_faces_.start(surface_.number_of_faces());
    const auto add = [&](Index g) { if (surface_faces_.visit(std::size_t(g))) queue.push_back(g); };
    add(f);
    const Vector3 q = context_.projector.factor * p;
    const double squared_radius = radius * radius * context_.projector.factor * context_.projector.factor;
    for (std::size_t i = 0; i < queue.size(); ++i) {
      const auto& corner = surface_.face_record(queue[i]).vertex;
      const bool is_near = std::any_of(corner, corner + 3, [&](Index v) {
        return squared_distance(surface_.position(v), q) < squared_radius; });
      if (!is_near && i > 0) continue;
      ++looks_;
      function(queue[i]);
      for (Index h = 4 * queue[i]; h < 4 * queue[i] + 3; ++h)
        if (surface_.opposite(h) >= 0 && !is_barrier(surface_, h)) add(surface_.face(surface_.opposite(h)));
    }
  }

  // Whether so many looks at faces of the surface that are near are enough for a pass over the mesh. Where the target is so long that much
  // of a surface is near each vertex, this would be its square; on the meshes of CGAL 18 for each face at most.
  bool are_enough_looks() const
  {
    constexpr std::size_t LOOKS_PER_FACE = 25;
    return looks_ > LOOKS_PER_FACE * (mesh_.number_of_live_faces() + surface_.number_of_faces());
  }

  // From now on every sample is a new one, and no look has been taken.
  void start()
  {
    surface_vertices_.start(surface_.number_of_vertices());
    surface_edges_.start(4 * surface_.number_of_faces());
    looks_ = 0;
  }

  // Samples of a face of the surface: its corners; what two faces share is sampled with the one that is asked for first.
  template <class Function>
  void for_each_corner_of(Index f, const Function& function)
  {
    const auto& v = surface_.face_record(f).vertex;
    for (int k = 0; k < 3; ++k) {
      if (!surface_vertices_.visit(std::size_t(v[k]))) continue;
      Barycentric b{0, 0, 0};
      b[k] = 1;
      function(v[k], context_.projector.at(f, b).point);
    }
  }
  // The same for points on long edges and the centre.
  template <class Function>
  void for_each_inner_sample_of(Index f, const Function& function)
  {
    const auto& v = surface_.face_record(f).vertex;
    for (int k = 0; k < 3; ++k) {
      const Index h = 4 * f + k, o = surface_.opposite(h);
      if (!surface_edges_.visit(std::size_t(o >= 0 && o < h ? o : h))) continue;
      const double l = std::sqrt(squared_distance(surface_.position(v[k]), surface_.position(v[(k + 1) % 3]))) /
                       context_.projector.factor;
      const int n = l < SPACING / 3 * length_ ? 0 : (std::min)(6, 1 + int(l / (SPACING * length_)));
      for (int i = 1; i <= n; ++i) {
        const double t = double(i) / (n + 1);
        Barycentric b{0, 0, 0};
        b[k] = 1 - t;
        b[(k + 1) % 3] = t;
        function(context_.projector.at(f, b).point);
      }
    }
    if (surface_.least_altitude(f) > SPACING / 3 * length_ * context_.projector.factor)
      function(context_.projector.at(f, {1. / 3, 1. / 3, 1. / 3}).point);
  }

  // The distance of a sample from the mesh. `around()` names the faces that are looked at where the walk ends far away.
  template <class Faces>
  double distance(Sample& s, const Faces& around) const
  {
    double d = squared_distance(walk_to_closest_point(mesh_, s.point, s.face).point, s.point);
    if (d > enough_)
      for (const Index f : around())
        if (const double e = squared_distance(closest_point_on_face(mesh_, s.point, f).point, s.point); e < d) {
          d = e;
          s.face = f;
        }
    return std::sqrt(d);
  }

  // The nearest point of the surface to a point of face f, and the face that it is on.
  Vector3 nearest_on_surface(Index f, const Vector3& y, Index& surface_face)
  {
    const Place_on_surface place = place_on_surface(context_, f, y, enough_);
    surface_face = place.facet;
    if (place.squared_distance < enough_) return place.point;
    const double unit = context_.projector.factor;
    const Vector3 q = unit * y;
    Index nearest = -1;
    double d = unit * unit * place.squared_distance;
    for_each_face_near(y, std::sqrt(place.squared_distance) + length_ / 2, surface_face, [&](Index g) {
      if (const double e = squared_distance(closest_point_on_face(surface_, q, g).point, q); e < d) { d = e; nearest = g; }
    });
    if (nearest < 0) return place.point;
    const Vector3 p = context_.projector(y, nearest);
    if (!(squared_distance(p, y) < place.squared_distance)) return place.point;
    surface_face = nearest;
    return p;
  }

private:
  const Remeshing_context& context_;
  const Remeshing_mesh& mesh_;
  const Reference_surface& surface_;
  double length_ = 0, tolerance_ = 0, enough_ = 0;
  std::size_t looks_ = 0;
  Visit_marks surface_faces_, surface_vertices_, surface_edges_;
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_DISTANCE_SAMPLES_H
