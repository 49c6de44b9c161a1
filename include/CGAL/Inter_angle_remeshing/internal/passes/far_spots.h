// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_FAR_SPOTS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_FAR_SPOTS_H

#include <CGAL/Inter_angle_remeshing/internal/Remeshing_context.h>
#include <CGAL/Inter_angle_remeshing/internal/geometry/Point_grid.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/Face_grid.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/mesh_regions.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/distance_samples.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/folds.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/surface_walk.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

// Where the result and the surface are farther apart than the tolerance: at tips, which the result cuts off, and in crevices,
// which it bridges. There its faces meet at large angles.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

struct Far_spot
{
  double distance;
  double length;                         // the target length there
  Distance_samples::Sample sample;
  std::optional<Vector3> place;          // on the mesh, where the spot is one of its faces that is far from the surface
};

class Far_spot_finder
{
  using Index = Remeshing_mesh::Index;
  using Spot = Far_spot;
  using Sample = Distance_samples::Sample;

  // Spots are looked for beside edges at which the normals turn by more than 53 degrees.
  static constexpr double SHARP_COSINE = 0.6;
  // The surface around them is sampled within this many target lengths.
  static constexpr double REACH = 1.2;
  // Spots that are nearer to each other than this are one; and what is that near to one that is none is none, either, which of 460 runs
  // changes 7.
  static constexpr double SPOT_DISTANCE = 1.5, REJECTED_DISTANCE = 0.25;
  // A face of the surface is sampled beyond its corners where one of these is off by this part of the tolerance.
  static constexpr double SUSPICIOUS = 0.5;

public:
  Far_spot_finder(const Remeshing_context& context, Distance_samples& samples, Face_grid& grid)
    : context_(context), mesh_(context.mesh), surface_(*context.projector.surface), samples_(samples), grid_(grid)
  {}

  // At most so many, the worst one first, none near another one.
  std::vector<Spot> find(std::size_t most)
  {
    std::vector<Spot> found;
    const std::vector<Index> sharp = vertices_at_sharp_edges();
    find_far_samples_of_surface(sharp, found);
    find_far_samples_of_mesh(sharp, found);
    std::stable_sort(found.begin(), found.end(), [](const Spot& a, const Spot& b) {
      return a.distance / a.length > b.distance / b.length; });
    std::vector<Spot> result;
    Point_grid accepted(SPOT_DISTANCE * context_.largest_length()), rejected(REJECTED_DISTANCE * context_.largest_length());
    for (const Spot& spot : found) {
      if (accepted.has_near(spot.sample.point, SPOT_DISTANCE * spot.length) ||
          rejected.has_near(spot.sample.point, REJECTED_DISTANCE * spot.length)) continue;
      if (are_enough_looks(mesh_, looks_)) break;
      if (is_near_elsewhere(spot)) {
        rejected.insert(spot.sample.point);
        continue;
      }
      accepted.insert(spot.sample.point);
      result.push_back(spot);
      if (result.size() == most) break;
    }
    return result;
  }

private:
  std::vector<Index> vertices_at_sharp_edges() const
  {
    std::vector<Vector3> normals(mesh_.number_of_face_slots());
    for (Index f = 0; f < Index(normals.size()); ++f)
      if (mesh_.is_face(f)) normals[f] = mesh_.cross_product(f);
    std::vector<char> is_sharp(mesh_.number_of_vertex_slots(), 0);
    mesh_.for_each_edge([&](Index h) {
      if (mesh_.is_on_curve_edge(h) ||
          is_cosine_at_least(normals[mesh_.face(h)], normals[mesh_.face(mesh_.opposite(h))], SHARP_COSINE)) return;
      is_sharp[mesh_.origin(h)] = is_sharp[mesh_.target(h)] = 1;
    });
    std::vector<Index> result;
    for (Index v = 0; v < Index(is_sharp.size()); ++v)
      if (is_sharp[v]) result.push_back(v);
    return result;
  }

  // Points of the surface that are too far from the mesh.
  void find_far_samples_of_surface(const std::vector<Index>& sharp, std::vector<Spot>& found)
  {
    std::vector<float> corner_distance(surface_.number_of_vertices());
    Visit_marks sampled;
    sampled.start(surface_.number_of_faces());
    samples_.start();
    for (const Index v : sharp) {
      if (samples_.are_enough_looks()) return;
      samples_.set_scale_at(v);
      std::vector<Index> faces;
      const auto around = [&]() -> const std::vector<Index>& {
        if (faces.empty()) faces = faces_around(mesh_, ball(mesh_, {v}, 2, marks_), marks_);
        return faces;
      };
      samples_.for_each_face_near(mesh_.position(v), REACH * samples_.length(), mesh_.hint(v), [&](Index f) {
        if (!sampled.visit(std::size_t(f))) return;
        const auto sample = [&](const Vector3& p) {
          Sample s{p, f, mesh_.face(mesh_.first(v))};
          const double d = samples_.distance(s, around);
          if (d > samples_.tolerance()) found.push_back({d, samples_.length(), s, {}});
          return d;
        };
        samples_.for_each_corner_of(f, [&](Index u, const Vector3& p) { corner_distance[u] = float(sample(p)); });
        const auto& corner = surface_.face_record(f).vertex;
        if (std::any_of(corner, corner + 3, [&](Index u) { return corner_distance[u] > SUSPICIOUS * samples_.tolerance(); }))
          samples_.for_each_inner_sample_of(f, sample);
      });
    }
  }

  // Points of the mesh that are too far from the surface.
  void find_far_samples_of_mesh(const std::vector<Index>& sharp, std::vector<Spot>& found)
  {
    for (const Index f : faces_around(mesh_, sharp, marks_)) {
      samples_.set_scale_at(mesh_.face_record(f).vertex[0]);
      for (int k = 0; k < 4; ++k) {
        const Vector3 y = point_on_face(mesh_, f, PLACES_ON_FACE[k]);
        Sample s{Vector3(), -1, f};
        s.point = samples_.nearest_on_surface(f, y, s.surface_face);
        if (const double d = length(s.point - y); d > samples_.tolerance()) found.push_back({d, samples_.length(), s, y});
      }
    }
  }

  // Whether what is far from its own sheet is near another one, as where the surface crosses itself.
  bool is_near_elsewhere(const Spot& spot)
  {
    const Vector3 p = spot.place.value_or(spot.sample.point);
    const double tolerance = context_.recipe.distance_tolerance * spot.length, enough = tolerance * tolerance;
    const Vector3 reach{tolerance, tolerance, tolerance};
    bool result = false;
    grid_.for_each_near(p - reach, p + reach, marks_, [&](Index f) {
      ++looks_;
      if (!spot.place) result = squared_distance(closest_point_on_face(mesh_, p, f).point, p) < enough;
      else for (const Index v : mesh_.face_record(f).vertex) {
        Index hint = mesh_.hint(v);
        if (squared_distance(context_.projector(p, hint), p) < enough) result = true;
      }
      return !result;
    });
    return result;
  }

  const Remeshing_context& context_;
  const Remeshing_mesh& mesh_;
  const Reference_surface& surface_;
  Distance_samples& samples_;
  Face_grid& grid_;
  std::size_t looks_ = 0;                // at faces that may be near spots
  Visit_marks marks_;
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_FAR_SPOTS_H
