// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_ANGLE_DESCENT_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_ANGLE_DESCENT_H

#include <CGAL/Inter_angle_remeshing/internal/Remeshing_context.h>
#include <CGAL/Inter_angle_remeshing/internal/curves/curve_edges.h>
#include <CGAL/Inter_angle_remeshing/internal/geometry/thin_angles.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/angle_bands.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/angle_energy.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

// One step of a vertex along the surface, or along its curve, that brings the angles around it nearer to the band: descent on
// the energy of its star, see angle_energy.h.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

class Angle_descent
{
  using Index = Remeshing_mesh::Index;

  // The longest step, and half of the chord that stands for a curve's tangent, in target lengths.
  static constexpr double LONGEST_STEP = 0.15, HALF_CHORD = 1e-4;
  // A step goes beyond the zero of the energy's linear model, for E is quadratic there.
  static constexpr double STEP_FACTOR = 1.5;
  static constexpr int TRIALS = 4;
  static constexpr double BACKTRACK = 0.4;
  // No step makes the least angle of a star smaller where it is, or becomes, less than this, in degrees: the energy alone would give up any
  // small angle for a large one. The second value is for stars at curves, whose vertices do not get out of the way, if the band allows it.
  // The third one is for all stars where vertices are kept, and no split or collapse would mend such an angle.
  static constexpr double SMALL_ANGLE = 20, SMALL_ANGLE_AT_CURVES = 28, SMALL_ANGLE_OF_KEPT_VERTICES = 30;
  // Nor does one of a free vertex make its star, if that has a very thin face, larger by more than this factor, where needles are held
  // or there is no surface: within a nearly flat one a star keeps its area; it grows where needles are pulled off.
  static constexpr double LARGEST_GROWTH = 1.001;
  // Less energy than that of an angle a quarter of a degree out of its band is none: the bands are narrower than those asked for.
  static constexpr double NEGLIGIBLE = 1e-5;
  // A slide leaves at most this part of the energy.
  static constexpr double ENOUGH = 0.99;

public:
  // A step that leaves at most this part of the energy is worth that the vertices around look again.
  static constexpr double MUCH_LESS = 0.8;

  explicit Angle_descent(Remeshing_context& context)
    : context_(context), mesh_(context.mesh), bands_(context.recipe, LOWER_MARGIN, UPPER_MARGIN),
      small_cosine_(cosine(context.keeps_vertices ? SMALL_ANGLE_OF_KEPT_VERTICES : SMALL_ANGLE)),
      small_cosine_at_curves_((std::min)(small_cosine_,
                                         cosine((std::max)(SMALL_ANGLE, (std::min)(SMALL_ANGLE_AT_CURVES, bands_.at_curves.lower())))))
  {}

  const Angle_bands& bands() const { return bands_; }

  // The part of the energy of its star that a step of v leaves; 1 if v does not move.
  double step(Index v)
  {
    if (mesh_.is_free(v)) return move(v);
    return mesh_.is_sliding(v) ? slide(v) : 1;
  }

  // Steps of these vertices, sweep by sweep, until none gains much.
  void sweep(const std::vector<Index>& vertices, int sweeps)
  {
    for (bool gains_much = true; gains_much && sweeps > 0; --sweeps) {
      gains_much = false;
      for (const Index v : vertices) gains_much |= step(v) <= MUCH_LESS;
    }
  }

  // Moves free vertex v by `way`, or by a half, a quarter ... of it, such that no face folds and the energy rises by `slack` at
  // most. Returns whether it moved.
  bool displace(Index v, const Vector3& way, double slack, int trials)
  {
    read_star(v);
    const Vector3 p = mesh_.position(v);
    const double most = star_.value(p) + slack;
    double step = 1;
    for (int trial = 0; trial < trials; ++trial, step *= 0.5) {
      const Vector3 q = p + step * way;
      if (!star_.keeps_orientation(p, q) || star_.value(q) > most || !context_.permits_move(v, q)) continue;
      mesh_.position(v) = q;
      return true;
    }
    return false;
  }

  // Moves free vertex v to q, or part of the way there, whatever becomes of the angles, but without a fold.
  bool snap(Index v, const Vector3& q)
  {
    return displace(v, q - mesh_.position(v), std::numeric_limits<double>::infinity(), TRIALS);
  }

private:
  static double cosine(double degrees) { return std::cos(degrees * (CGAL_PI / 180)); }

  void read_star(Index v)
  {
    is_at_curve_ = false;
    star_.read(mesh_, v, [&](Index u, Index w) -> const Angle_band& {
      const Angle_band& band = bands_.of(mesh_, v, u, w);
      is_at_curve_ = is_at_curve_ || &band == &bands_.at_curves;
      return band;
    });
  }

  // The energy of the star with v at q instead of p, if that is less than `enough`, there is no fold, and no angle is too small; otherwise
  // infinity.
  double lower_energy(double enough, const Vector3& p, const Vector3& q)
  {
    const double result = star_.value(q);
    return result < enough && star_.keeps_orientation(p, q) && !makes_small_angle(p) ? result : std::numeric_limits<double>::infinity();
  }

  // Whether the least angle, with v where the value was asked for last, is small, and smaller than with v at p. Asks for the value there.
  bool makes_small_angle(const Vector3& p)
  {
    const double after = star_.largest_cosine();
    if (after <= (is_at_curve_ ? small_cosine_at_curves_ : small_cosine_)) return false;
    star_.value(p);
    return is_thinner(1 - after * after, star_.squared_sine_of_smallest_angle());
  }

  double move(Index v)
  {
    read_star(v);
    const Vector3 p = mesh_.position(v);
    const double energy = star_.value(p);
    if (!(energy > NEGLIGIBLE)) return 1;
    const Vector3 normal = star_.normal(p);
    const double l = squared_length(normal);
    if (!(l > 0)) return 1;
    Vector3 g = star_.gradient();
    g = g - (dot(g, normal) / l) * normal;
    const double slope = internal::length(g);
    if (!(slope > 0)) return 1;
    Index nearest = mesh_.hint(v);
    const Vector3 offset = offset_of(p, nearest);
    const bool keeps_area = (context_.holds_needles() || !context_.projector.moves_points()) &&
                            star_.squared_sine_of_smallest_angle() < VERY_THIN_SQUARED_SINE;
    const double largest_area = keeps_area ? LARGEST_GROWTH * star_.area(p) : 0;
    double step = (std::min)(LONGEST_STEP * length_at(v), STEP_FACTOR * energy / slope);
    for (int trial = 0; trial < TRIALS; ++trial, step *= BACKTRACK) {
      const Vector3 r = p - (step / slope) * g;
      if (!(star_.value(r) < energy)) continue;    // the projection hardly changes that
      Index hint = nearest;
      const Vector3 q = context_.projector(r, hint) + offset;
      if (!context_.projector.is_compatible(hint, normal) || (keeps_area && star_.area(q) > largest_area)) continue;
      const double left = lower_energy(energy, p, q);
      if (!(left < energy) || !keeps_places(v, p, q) || !context_.permits_move(v, q)) continue;
      mesh_.hint(v) = hint;
      mesh_.position(v) = q;
      return left / energy;
    }
    return 1;
  }

  // Whether the star, with v at q instead of p, is near the places of v, or no farther from them than before.
  bool keeps_places(Index v, const Vector3& p, const Vector3& q) const
  {
    const double longest = Kept_places::LONGEST_WITHDRAWAL * length_at(v), enough = longest * longest;
    return context_.kept_places.all_of(v, [&](const Vector3& place) {
      if (squared_distance(q, place) <= enough) return true;
      const double d = star_.squared_distance(q, place);
      return d <= enough || d <= star_.squared_distance(p, place);
    });
  }

  // What a fit, or the lowering of distances, has put p off the surface: all of it, so that a step of no length leads to p again.
  Vector3 offset_of(const Vector3& p, Index& hint) const
  {
    const bool lie_on_surface = context_.recipe.fits == 0 && !(context_.recipe.distance_tolerance > 0);
    if (!context_.projector.has_faces() || lie_on_surface) return {};
    return p - context_.projector(p, hint);
  }

  // The same along a curve. The energy falls to one of the two sides.
  double slide(Index v)
  {
    read_star(v);
    const Vector3 p = mesh_.position(v);
    const double energy = star_.value(p);
    if (!(energy > NEGLIGIBLE)) return 1;
    std::array<Index, 2> ends{};
    std::size_t n = 0;
    for_each_curve_halfedge(mesh_, v, [&](Index h) { if (n < 2) ends[n++] = mesh_.curve_end(h); });
    const Index curve = mesh_.curve_of(ends[0]);
    const double t = mesh_.arc_length(ends[0]);
    const Vector3 g = star_.gradient();
    double low = mesh_.arc_length(ends[0] ^ 1) - t, high = mesh_.arc_length(ends[1] ^ 1) - mesh_.arc_length(ends[1]);
    if (low > high) std::swap(low, high);
    const double d = HALF_CHORD * length_at(v);
    const double slope = dot(g, context_.curves.point(curve, t + d) - context_.curves.point(curve, t - d)) / (2 * d);
    if (!(slope != 0)) return 1;
    double step = (std::min)(LONGEST_STEP * length_at(v), STEP_FACTOR * energy / std::abs(slope));
    for (int trial = 0; trial < TRIALS; ++trial, step *= BACKTRACK) {
      const double shift = slope > 0 ? -step : step;
      if (!(shift > low / 2 && shift < high / 2)) continue;
      const Vector3 q = context_.curves.point(curve, t + shift);
      const double left = lower_energy(ENOUGH * energy, p, q);
      if (!(left < energy) || leaves_curve(v, ends, shift, q) || !context_.permits_move(v, q)) continue;
      for (const Index end : ends) mesh_.arc_length(end) += shift;
      mesh_.position(v) = q;
      return left / energy;
    }
    return 1;
  }

  // Whether one of the two chords at vertex v of a curve would lie too far from it if the vertex moved to q.
  bool leaves_curve(Index v, const std::array<Index, 2>& ends, double shift, const Vector3& q) const
  {
    return std::any_of(ends.begin(), ends.end(), [&](Index end) {
      const Index curve = mesh_.curve_of(end);
      const double t = mesh_.arc_length(end ^ 1);
      return context_.curves.deviation(curve, mesh_.arc_length(end) + shift, t, q, context_.curves.point(curve, t)) >
             curve_tolerance(context_, length_at(v));
    });
  }

  double length_at(Index v) const { return context_.length_at(v); }

  Remeshing_context& context_;
  Remeshing_mesh& mesh_;
  Angle_bands bands_;                    // narrower than those asked for
  double small_cosine_, small_cosine_at_curves_;          // of the largest angles that are small
  Star_energy star_;                     // of the vertex that is looked at
  bool is_at_curve_ = false;             // whether a face of the star touches a curve
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_ANGLE_DESCENT_H
