// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_POLISH_PASS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_POLISH_PASS_H

#include <CGAL/Inter_angle_remeshing/internal/Remeshing_context.h>
#include <CGAL/Inter_angle_remeshing/internal/split_pass.h>
#include <CGAL/Inter_angle_remeshing/internal/thin_angles.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

// Moves vertices along the surface until the angles around them lie within a band, as far as that is possible: descent
// on the energy E = Σ (c - cos lo)₊² + (cos hi - c)₊² over the corner cosines c of a vertex's star.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

class Angle_band
{
public:
  // The bounds in degrees.
  Angle_band(double lower, double upper)
    : lower_cosine_(std::cos(lower * (CGAL_PI / 180))), upper_cosine_(std::cos(upper * (CGAL_PI / 180)))
  {}

  double energy(double corner_cosine) const
  {
    const double below = (std::max)(0., corner_cosine - lower_cosine_);
    const double above = (std::max)(0., upper_cosine_ - corner_cosine);
    return below * below + above * above;
  }

  double energy(const Vector3& a, const Vector3& b, const Vector3& c) const
  {
    return energy(corner_cosine(a, b, c)) + energy(corner_cosine(b, c, a)) + energy(corner_cosine(c, a, b));
  }

private:
  double lower_cosine_, upper_cosine_;
};

template <class Context>
class Polisher
{
  using Index = Remeshing_mesh::Index;

  // Rounds over the vertices at hand; what is not mended by then is stuck.
  static constexpr int MAXIMUM_ROUNDS = 30;
  // The longest step and the step of the difference quotients, in target lengths.
  static constexpr double LONGEST_STEP = 0.15, DIFFERENCE = 1e-4;
  // A step goes beyond the zero of the energy's linear model, for E is quadratic there.
  static constexpr double STEP_FACTOR = 1.5;
  static constexpr int TRIALS = 4;
  static constexpr double BACKTRACK = 0.4;

public:
  Polisher(Context& context, double length, const Angle_band& band)
    : context_(context), mesh_(context.mesh), length_(length), band_(band)
  {}

  // Returns the number of moves.
  std::size_t run()
  {
    is_queued_.assign(mesh_.number_of_vertex_slots(), 0);
    queue_bad_faces();
    std::size_t moves = 0;
    for (int round = 0; round < MAXIMUM_ROUNDS && !queue_.empty(); ++round) {
      std::vector<Index> current;
      current.swap(queue_);
      for (const Index v : current) is_queued_[v] = 0;
      for (const Index v : current) moves += move(v);
    }
    return moves;
  }

private:
  void queue(Index v)
  {
    if (is_queued_[v] || !mesh_.is_free(v)) return;
    is_queued_[v] = 1;
    queue_.push_back(v);
  }

  void queue_bad_faces()
  {
    for (std::size_t f = 0; f < mesh_.number_of_face_slots(); ++f) {
      const Corner_table::Face& t = mesh_.face_record(Index(f));
      if (t.vertex[0] < 0 || !(band_.energy(mesh_.position(t.vertex[0]), mesh_.position(t.vertex[1]),
                                            mesh_.position(t.vertex[2])) > 0)) continue;
      for (const Index v : t.vertex) queue(v);
    }
  }

  double energy(Index v, const Vector3& p) const
  {
    double sum = 0;
    mesh_.for_each_around(v, [&](Index h) {
      sum += band_.energy(p, mesh_.position(mesh_.target(h)), mesh_.position(mesh_.apex(h)));
    });
    return sum;
  }

  // The squared sine of the smallest angle of the star if v lay at p.
  double smallest_angle(Index v, const Vector3& p) const
  {
    double smallest = 1;
    mesh_.for_each_around(v, [&](Index h) {
      smallest = (std::min)(smallest, squared_sine_of_smallest_angle(p, mesh_.position(mesh_.target(h)),
                                                                     mesh_.position(mesh_.apex(h))));
    });
    return smallest;
  }

  // The unit normal of the star; zero where it has none.
  Vector3 star_normal(Index v) const
  {
    const Vector3 p = mesh_.position(v);
    Vector3 sum;
    mesh_.for_each_around(v, [&](Index h) {
      sum += triangle_cross(p, mesh_.position(mesh_.target(h)), mesh_.position(mesh_.apex(h)));
    });
    const double l = internal::length(sum);
    return l > 0 ? (1 / l) * sum : Vector3();
  }

  // The gradient of the energy in the tangent plane with this normal.
  Vector3 gradient(Index v, double energy_here, const Vector3& normal) const
  {
    const Vector3 p = mesh_.position(v);
    const Vector3 axis = std::abs(normal.x) < 0.6 ? Vector3{1, 0, 0} : Vector3{0, 1, 0};
    Vector3 u = cross(normal, axis);
    u = (1 / internal::length(u)) * u;
    const Vector3 w = cross(normal, u);
    const double d = DIFFERENCE * length_;
    return ((energy(v, p + d * u) - energy_here) / d) * u + ((energy(v, p + d * w) - energy_here) / d) * w;
  }

  bool move(Index v)
  {
    const double before = energy(v, mesh_.position(v));
    if (!(before > 0)) return false;
    const Vector3 normal = star_normal(v);
    const Vector3 g = normal == Vector3() ? normal : gradient(v, before, normal);
    const double slope = internal::length(g);
    if (!(slope > 0)) return false;
    double step = (std::min)(LONGEST_STEP * length_, STEP_FACTOR * before / slope);
    for (int trial = 0; trial < TRIALS; ++trial, step *= BACKTRACK) {
      Index hint = mesh_.hint(v);
      const Vector3 q = context_.projector(mesh_.position(v) - (step / slope) * g, hint);
      if (!context_.projector.is_compatible(hint, normal) || !(energy(v, q) < before) ||
          !keeps_orientation(mesh_, v, q) ||
          makes_thin_angle(smallest_angle(v, mesh_.position(v)), smallest_angle(v, q))) continue;
      mesh_.position(v) = q;
      mesh_.hint(v) = hint;
      queue(v);
      mesh_.for_each_neighbor(v, [&](Index u) { queue(u); });
      return true;
    }
    return false;
  }

  Context& context_;
  Remeshing_mesh& mesh_;
  double length_;
  Angle_band band_;
  std::vector<char> is_queued_;
  std::vector<Index> queue_;
};

// Returns the number of moves.
template <class Context>
std::size_t polish_pass(Context& context, double length)
{
  const Angle_band band(context.recipe.lower_angle, context.recipe.upper_angle);
  return Polisher<Context>(context, length, band).run();
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_POLISH_PASS_H
