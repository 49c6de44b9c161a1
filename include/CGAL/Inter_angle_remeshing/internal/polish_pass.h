// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_POLISH_PASS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_POLISH_PASS_H

#include <CGAL/Inter_angle_remeshing/internal/Remeshing_context.h>
#include <CGAL/Inter_angle_remeshing/internal/angle_energy.h>
#include <CGAL/Inter_angle_remeshing/internal/arc_cosine.h>
#include <CGAL/Inter_angle_remeshing/internal/curve_edges.h>
#include <CGAL/Inter_angle_remeshing/internal/flip_pass.h>
#include <CGAL/Inter_angle_remeshing/internal/thin_angles.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <utility>
#include <vector>

// Moves vertices along the surface, and those on curves along these, until the angles around them lie within a band, as far
// as that is possible: descent on the energy of each one's star, see angle_energy.h. What then is still bad beside a curve is
// flipped away, if a flip helps.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

template <class Context>
class Polisher
{
  using Index = Remeshing_mesh::Index;

  // Rounds over the vertices at hand, and how often one on a curve or beside it is looked at; what is not mended by then is
  // stuck, which beside curves is common.
  static constexpr int MAXIMUM_ROUNDS = 30, MAXIMUM_VISITS_AT_CURVES = 12;
  // The longest step, and half of the chord that stands for a curve's tangent, in target lengths.
  static constexpr double LONGEST_STEP = 0.15, DIFFERENCE = 1e-4;
  // A step goes beyond the zero of the energy's linear model, for E is quadratic there.
  static constexpr double STEP_FACTOR = 1.5;
  static constexpr int TRIALS = 4;
  static constexpr double BACKTRACK = 0.4;
  // A slide leaves at most this part of the energy: less is not worth that the neighbors look again.
  static constexpr double ENOUGH = 0.99;
  // The band of the faces that touch a curve, where the narrow one is out of reach as often as not, and to strive for it
  // costs the other angles there half a degree on the average.
  static constexpr double LOWER_ANGLE_AT_CURVES = 35, UPPER_ANGLE_AT_CURVES = 100;
  // Flips mend faces at curves that have a smaller angle, or one that is as far over 60 degrees as half of the rest is under.
  static constexpr double POOR_ANGLE = 35;
  static constexpr int FLIP_ROUNDS = 3;

public:
  Polisher(Context& context, double length)
    : context_(context), mesh_(context.mesh), length_(length),
      band_(context.recipe.lower_angle, context.recipe.upper_angle),
      band_at_curves_((std::min)(context.recipe.lower_angle, LOWER_ANGLE_AT_CURVES),
                      (std::max)(context.recipe.upper_angle, UPPER_ANGLE_AT_CURVES))
  {}

  // Returns the number of moves and flips.
  std::size_t run()
  {
    is_queued_.assign(mesh_.number_of_vertex_slots(), 0);
    visits_.assign(mesh_.number_of_vertex_slots(), 0);
    queue_bad_faces();
    std::size_t changes = move_queued();
    for (int round = 0; round < FLIP_ROUNDS && mesh_.has_curves(); ++round) {
      const std::size_t flips = flip_beside_curves();
      if (flips == 0) break;
      changes += flips + move_queued();
    }
    return changes;
  }

private:
  std::size_t move_queued()
  {
    std::size_t moves = 0;
    for (int round = 0; round < MAXIMUM_ROUNDS && !queue_.empty(); ++round) {
      std::vector<Index> current;
      current.swap(queue_);
      for (const Index v : current) {
        is_queued_[v] = 0;
        visits_[v] += is_at_curve(v);
      }
      for (const Index v : current) moves += mesh_.is_free(v) ? move(v) : slide(v);
    }
    return moves;
  }

  bool is_at_curve(Index v) const
  {
    if (!mesh_.has_curves()) return false;
    bool result = mesh_.is_on_curve(v);
    mesh_.for_each_neighbor(v, [&](Index u) { result = result || mesh_.is_on_curve(u); });
    return result;
  }

  void queue(Index v)
  {
    if (is_queued_[v] || visits_[v] >= MAXIMUM_VISITS_AT_CURVES || !(mesh_.is_free(v) || mesh_.is_sliding(v))) return;
    is_queued_[v] = 1;
    queue_.push_back(v);
  }

  void queue_bad_faces()
  {
    for (std::size_t f = 0; f < mesh_.number_of_face_slots(); ++f) {
      const Corner_table::Face& t = mesh_.face_record(Index(f));
      if (t.vertex[0] < 0 || band(t.vertex[0], t.vertex[1], t.vertex[2])
                               .holds(mesh_.position(t.vertex[0]), mesh_.position(t.vertex[1]), mesh_.position(t.vertex[2])))
        continue;
      for (const Index v : t.vertex) queue(v);
    }
  }

  const Angle_band& band(Index a, Index b, Index c) const
  {
    return mesh_.is_on_curve(a) || mesh_.is_on_curve(b) || mesh_.is_on_curve(c) ? band_at_curves_ : band_;
  }

  void read_star(Index v)
  {
    const bool is_on_curve = mesh_.is_on_curve(v);
    star_.read(mesh_, v, [&](Index u, Index w) -> const Angle_band& {
      return is_on_curve || mesh_.is_on_curve(u) || mesh_.is_on_curve(w) ? band_at_curves_ : band_;
    });
  }

  // Whether the star is better with v at q, having the energy `enough` at most, and neither folds nor grows thin.
  bool is_better(const Star_energy::Value& before, double enough, const Vector3& p, const Vector3& q) const
  {
    const Star_energy::Value after = star_.value(q);
    return after.energy < enough && star_.keeps_orientation(p, q) &&
           !makes_thin_angle(1 - before.largest_cosine * before.largest_cosine, 1 - after.largest_cosine * after.largest_cosine);
  }

  bool move(Index v)
  {
    read_star(v);
    const Vector3 p = mesh_.position(v);
    const Star_energy::Value before = star_.value(p);
    if (!(before.energy > 0)) return false;
    const Vector3 normal = star_.normal(p);
    const double l = squared_length(normal);
    if (!(l > 0)) return false;
    Vector3 g = star_.gradient(p);
    g = g - (dot(g, normal) / l) * normal;
    const double slope = internal::length(g);
    if (!(slope > 0)) return false;
    const Vector3 offset = offset_of(v, normal, l);
    double step = (std::min)(LONGEST_STEP * length_, STEP_FACTOR * before.energy / slope);
    for (int trial = 0; trial < TRIALS; ++trial, step *= BACKTRACK) {
      Index hint = mesh_.hint(v);
      const Vector3 q = context_.projector(p - (step / slope) * g, hint) + offset;
      if (!context_.projector.is_compatible(hint, normal) || !is_better(before, before.energy, p, q)) continue;
      mesh_.hint(v) = hint;
      place(v, q);
      return true;
    }
    return false;
  }

  // What a fit has put v off the surface, along the normal of its star.
  Vector3 offset_of(Index v, const Vector3& normal, double squared_length_of_normal) const
  {
    if (!std::decay_t<decltype(context_.projector)>::HAS_FACES || context_.recipe.fits == 0) return {};
    Index hint = mesh_.hint(v);
    const Vector3 d = mesh_.position(v) - context_.projector(mesh_.position(v), hint);
    return (dot(d, normal) / squared_length_of_normal) * normal;
  }

  void place(Index v, const Vector3& q)
  {
    mesh_.position(v) = q;
    queue(v);
    mesh_.for_each_neighbor(v, [&](Index u) { queue(u); });
  }

  // The same along a curve. The energy falls to one of the two sides.
  bool slide(Index v)
  {
    read_star(v);
    const Vector3 p = mesh_.position(v);
    const Star_energy::Value before = star_.value(p);
    if (!(before.energy > 0)) return false;
    std::array<Index, 2> ends{};
    std::size_t n = 0;
    for_each_curve_halfedge(mesh_, v, [&](Index h) { if (n < 2) ends[n++] = mesh_.curve_end(h); });
    const Index curve = mesh_.curve_of(ends[0]);
    const double t = mesh_.arc_length(ends[0]);
    const Vector3 g = star_.gradient(p);
    double low = mesh_.arc_length(ends[0] ^ 1) - t, high = mesh_.arc_length(ends[1] ^ 1) - mesh_.arc_length(ends[1]);
    if (low > high) std::swap(low, high);
    const double d = DIFFERENCE * length_;
    const double slope = dot(g, context_.curves.point(curve, t + d) - context_.curves.point(curve, t - d)) / (2 * d);
    if (!(slope != 0)) return false;
    double step = (std::min)(LONGEST_STEP * length_, STEP_FACTOR * before.energy / std::abs(slope));
    for (int trial = 0; trial < TRIALS; ++trial, step *= BACKTRACK) {
      const double shift = slope > 0 ? -step : step;
      if (!(shift > low / 2 && shift < high / 2)) continue;
      const Vector3 q = context_.curves.point(curve, t + shift);
      if (!is_better(before, ENOUGH * before.energy, p, q) || leaves_curve(ends, shift, q)) continue;
      for (const Index end : ends) mesh_.arc_length(end) += shift;
      place(v, q);
      return true;
    }
    return false;
  }

  // Whether one of the two chords at a vertex of a curve would lie too far from it if the vertex moved to q.
  bool leaves_curve(const std::array<Index, 2>& ends, double shift, const Vector3& q) const
  {
    return std::any_of(ends.begin(), ends.end(), [&](Index end) {
      const Index curve = mesh_.curve_of(end);
      const double t = mesh_.arc_length(end ^ 1);
      return context_.curves.deviation(curve, mesh_.arc_length(end) + shift, t, q, context_.curves.point(curve, t)) >
             CURVE_TOLERANCE * length_;
    });
  }

  // How far the worst angle of a triangle is from the ends of the scale: its smallest angle, or half of what its largest one
  // leaves, in degrees.
  double worst_angle(Index a, Index b, Index c) const
  {
    const Vector3 &p = mesh_.position(a), &q = mesh_.position(b), &r = mesh_.position(c);
    const double cosines[3] = {corner_cosine(p, q, r), corner_cosine(q, r, p), corner_cosine(r, p, q)};
    const double smallest = arc_cosine_in_degrees(*std::max_element(cosines, cosines + 3)),
                 largest = arc_cosine_in_degrees(*std::min_element(cosines, cosines + 3));
    return (std::min)(smallest, (180 - largest) / 2);
  }

  // Flips edges of poor faces at curves where that makes the worst angle of the two better. Returns the number of flips.
  std::size_t flip_beside_curves()
  {
    std::size_t flips = 0;
    if (is_never(context_.flip_policy)) return flips;
    for (Index f = 0; f < Index(mesh_.number_of_face_slots()); ++f) {
      if (!mesh_.is_face(f)) continue;
      const auto& v = mesh_.face_record(f).vertex;
      if (!(mesh_.is_on_curve(v[0]) || mesh_.is_on_curve(v[1]) || mesh_.is_on_curve(v[2])) ||
          worst_angle(v[0], v[1], v[2]) > POOR_ANGLE) continue;
      for (Index h = 4 * f; h < 4 * f + 3; ++h)
        if (!mesh_.is_on_curve_edge(h) && improves_worst_angle(h) && is_flip_allowed(context_, h, false)) {
          for (const Index u : {mesh_.origin(h), mesh_.target(h), mesh_.apex(h), mesh_.apex(mesh_.opposite(h))}) queue(u);
          flip(context_, h);
          ++flips;
          break;
        }
    }
    return flips;
  }

  bool improves_worst_angle(Index h) const
  {
    constexpr double NOTICEABLE = 1;
    const Index o = mesh_.opposite(h), a = mesh_.origin(h), b = mesh_.origin(o), c = mesh_.apex(h), d = mesh_.apex(o);
    return (std::min)(worst_angle(a, d, c), worst_angle(d, b, c)) >
           (std::min)(worst_angle(a, b, c), worst_angle(b, a, d)) + NOTICEABLE;
  }

  Context& context_;
  Remeshing_mesh& mesh_;
  double length_;
  Angle_band band_, band_at_curves_;
  Star_energy star_;                     // of the vertex that is looked at
  std::vector<char> is_queued_, visits_;
  std::vector<Index> queue_;
};

// Returns the number of moves and flips.
template <class Context>
std::size_t polish_pass(Context& context, double length)
{
  return Polisher<Context>(context, length).run();
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_POLISH_PASS_H
