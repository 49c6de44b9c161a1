// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_DISTANCE_PASS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_DISTANCE_PASS_H

#include <CGAL/Inter_angle_remeshing/internal/Remeshing_context.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/Face_grid.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/Mesh_snapshot.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/crossings.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/mesh_regions.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/Angle_descent.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/angle_bands.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/distance_samples.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/far_spots.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/flip_pass.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/folds.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/split_pass.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/surface_walk.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

// Lowers the largest distances between the result and the surface. At each far spot, the worst one first, the vertices of a patch
// move by weighted least squares, the farthest samples counting most: as they are, with a vertex put onto the farthest point, or
// with an edge split there. The best of these stays if it leaves the angles as good.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

class Distance_reducer
{
  using Index = Remeshing_mesh::Index;

  // The surface is sampled around a spot within this many target lengths, and with every further ring so many more.
  static constexpr double PATCH_RADIUS = 1.7, RING = 0.5;
  // A spot that a patch of one ring does not mend is tried again with a larger one, and with splits; if that betters it, once more
  // with one ring where it is farthest away then.
  static constexpr int MOST_RINGS = 2;
  // Least squares end with the first part of the tolerance, and no more is tried with the second one.
  static constexpr double GOOD = Distance_samples::GOOD, ACCEPTED = 0.95;
  // Least squares: their number, damping, regularisation, and the weight of a sample that is right: the others count by the
  // fourth power of their distances over the tolerance.
  static constexpr int ITERATIONS = 5, SWEEPS = 2, LAST_SWEEPS = 4, TRIES = 4;
  static constexpr double STEP = 0.8, REGULAR = 0.05, LEAST_WEIGHT = 0.01, LONGEST = 0.25;
  // By how much the energy of angles may rise in the first iterations: a degree too much.
  static constexpr double SLACK = 1.5e-4;
  // A trial must lower the score by so much; a degree out of the band counts as half a target length.
  static constexpr double NOTICEABLE = 0.03, DEGREE = 0.5, TOUCH = 0.05;
  // The pass ends after so many trials and one more for so many faces: a trial takes as long as 80 faces of the run.
  static constexpr std::size_t LEAST_TRIALS = 20, FACES_PER_TRIAL = 300;
  // Larger patches are those of vertices with hundreds of edges.
  static constexpr std::size_t LARGEST_PATCH = 200;
  // Of the samples of a patch so many count, the farthest ones.
  static constexpr std::size_t MOST_SAMPLES = 120;

  using Sample = Distance_samples::Sample;
  using Spot = Far_spot;
  enum class Outcome { nothing, bettered, mended };
  enum class Kind { move, snap, split };
  struct Trial
  {
    Kind kind;
    Index element;                       // vertex or half-edge
  };

public:
  explicit Distance_reducer(Remeshing_context& context)
    : context_(context), mesh_(context.mesh), samples_(context), grid_(context.mesh, context.largest_length()),
      bands_(context.recipe), descent_(context), leaving_(context),
      most_trials_(LEAST_TRIALS + mesh_.number_of_live_faces() / FACES_PER_TRIAL)
  {}

  // Returns the number of spots where something was changed.
  std::size_t run()
  {
    std::size_t changes = 0;
    std::vector<Spot> bettered;
    for (const Spot& spot : Far_spot_finder(context_, samples_, grid_).find(most_trials_)) {
      Outcome outcome = Outcome::nothing;
      Spot rest = spot;
      for (int rings = 1; rings <= MOST_RINGS && outcome != Outcome::mended && trials_ < most_trials_; ++rings)
        outcome = (std::max)(outcome, mend(spot, rings, rest));
      changes += outcome != Outcome::nothing;
      if (outcome == Outcome::bettered) bettered.push_back(rest);
    }
    for (const Spot& spot : bettered) {
      Spot rest = spot;
      if (trials_ < most_trials_) mend(spot, 1, rest);
    }
    return changes;
  }

private:
  struct Place
  {
    Index face;
    int number;                          // of PLACES_ON_FACE
    Index surface_face;                  // where it is nearest to; -1: to be looked for
  };

  // The vertices that move, and what pulls them.
  struct Patch
  {
    std::vector<Index> vertices;
    std::vector<Index> faces;            // around them
    std::vector<Place> places;           // of these faces, which are measured
    std::vector<Sample> samples;         // of the surface
    std::vector<Vector3> pull;           // by vertex
    std::vector<double> weight;
  };

  void set_faces(Patch& patch)
  {
    patch.faces = faces_around(mesh_, patch.vertices, marks_);
    patch.places.clear();
    vertices_.start(mesh_.number_of_vertex_slots());
    for (const Index f : patch.faces)
      for (int i = 0; i < 7; ++i) {
        if (i > 0 && i < 4 && is_with_other_face(patch, 4 * f + i - 1)) continue;
        if (i >= 4 && !vertices_.visit(std::size_t(mesh_.face_record(f).vertex[i - 4]))) continue;
        patch.places.push_back({f, i, -1});
      }
  }

  // Whether the middle of the edge of h is taken with the face across.
  bool is_with_other_face(const Patch& patch, Index h) const
  {
    const Index o = mesh_.opposite(h);
    return o >= 0 && o < h && std::binary_search(patch.faces.begin(), patch.faces.end(), mesh_.face(o));
  }

  struct Distances
  {
    double largest = 0;
    Sample farthest{};
    double excess = 0;                   // sum of the fourth powers of what exceeds half of the tolerance
  };

  // Notes the pulls of the samples, too.
  Distances measure(Patch& patch)
  {
    patch.pull.assign(patch.vertices.size(), Vector3());
    patch.weight.assign(patch.vertices.size(), 0);
    if (slot_.size() < mesh_.number_of_vertex_slots()) slot_.resize(mesh_.number_of_vertex_slots(), -1);
    for (std::size_t i = 0; i < patch.vertices.size(); ++i) slot_[patch.vertices[i]] = int(i);
    Distances result;
    const auto pull = [&](const Sample& s, const auto& b, const Vector3& way, double d) {
      if (d > result.largest) {
        result.largest = d;
        result.farthest = s;
      }
      const double e = (std::max)(0., d - samples_.tolerance() / 2);
      result.excess += e * e * e * e;
      const double part = d / samples_.tolerance(), weight = part * part * part * part + LEAST_WEIGHT;
      for (int k = 0; k < 3; ++k) {
        const int i = slot_[mesh_.face_record(s.face).vertex[k]];
        if (i < 0) continue;
        patch.pull[i] += (weight * b[k]) * way;
        patch.weight[i] += weight * b[k] * b[k];
      }
    };
    for (Sample& s : patch.samples) {
      const Point_on_triangle c = walk_to_closest_point(mesh_, s.point, s.face);
      const double d = length(s.point - c.point);
      const auto& v = mesh_.face_record(s.face).vertex;
      pull(s, barycentric(c, mesh_.position(v[0]), mesh_.position(v[1]), mesh_.position(v[2])), s.point - c.point, d);
    }
    for (Place& place : patch.places) {
      const Vector3 y = point_on_face(mesh_, place.face, PLACES_ON_FACE[place.number]);
      Index& g = place.surface_face;
      const Vector3 way = (g < 0 ? samples_.nearest_on_surface(place.face, y, g) : context_.projector(y, g)) - y;
      pull(Sample{y + way, g, place.face}, PLACES_ON_FACE[place.number], way, length(way));
    }
    for (const Index v : patch.vertices) slot_[v] = -1;
    return result;
  }

  // Starts from these distances, and returns those afterwards.
  Distances move_by_least_squares(Patch& patch, Distances distances)
  {
    for (int i = 0; i < ITERATIONS && distances.largest > GOOD * samples_.tolerance(); ++i) {
      for (std::size_t k = 0; k < patch.vertices.size(); ++k) {
        const Index v = patch.vertices[k];
        if (!mesh_.is_free(v) || !(patch.weight[k] > 0)) continue;
        Vector3 step = (STEP / (patch.weight[k] + REGULAR)) * patch.pull[k];
        const double l = length(step);
        if (l > LONGEST * samples_.length()) step = (LONGEST * samples_.length() / l) * step;
        descent_.displace(v, step, i + 2 < ITERATIONS ? SLACK : 0, TRIES);
      }
      descent_.sweep(patch.vertices, i + 1 < ITERATIONS ? SWEEPS : LAST_SWEEPS);
      distances = measure(patch);
    }
    return distances;
  }

  // What is too far away, in target lengths, and what is out of the band or folded.
  double score(const Patch& patch, const Distances& distances)
  {
    leaving_.start();
    double result = std::sqrt(std::sqrt(distances.excess)) / samples_.length();
    for (const Index f : patch.faces)
      if (const double v = violation(mesh_, bands_, f, leaving_); v > 0) result += DEGREE * (v + TOUCH);
    return result;
  }

  // Does what a trial does before the least squares; returns whether it could be done. The visitor is told of what stays only.
  bool apply(const Trial& trial, const Sample& spot, Patch& patch, bool is_announced)
  {
    if (trial.kind == Kind::snap) {
      if (!descent_.snap(trial.element, spot.point)) return false;
      mesh_.hint(trial.element) = spot.surface_face;
    } else if (trial.kind == Kind::split) {
      const Index h = trial.element;
      if (mesh_.is_on_curve_edge(h) || !mesh_.is_split_legal(h) || !context_.permits_split(h)) return false;
      const Split_vertex made = is_announced ? split(context_, h) : split_edge(context_, h);
      mesh_.position(made.vertex) = spot.point;
      mesh_.hint(made.vertex) = spot.surface_face;
      patch.vertices.push_back(made.vertex);
      flip_around(made.vertex, is_announced);
      set_faces(patch);
    }
    return true;
  }

  void flip_around(Index v, bool is_announced)
  {
    std::vector<Index> around;
    mesh_.for_each_around(v, [&](Index h) { around.push_back(mesh_.next(h)); });
    for (const Index h : around)
      if (!mesh_.is_on_curve_edge(h) && flip_gain(mesh_, h) < 0 && is_flip_allowed(context_, h, false)) {
        if (is_announced) flip(context_, h); else mesh_.flip(h);
      }
  }

  std::vector<Trial> trials(const Sample& spot, bool with_splits) const
  {
    std::array<Index, 3> corner;
    std::copy(std::begin(mesh_.face_record(spot.face).vertex), std::end(mesh_.face_record(spot.face).vertex), corner.begin());
    std::sort(corner.begin(), corner.end(), [&](Index a, Index b) {
      return squared_distance(mesh_.position(a), spot.point) < squared_distance(mesh_.position(b), spot.point); });
    std::vector<Trial> result = {{Kind::move, -1}};
    for (const Index v : corner)
      if (mesh_.is_free(v)) result.push_back({Kind::snap, v});
    for (Index h = 4 * spot.face; with_splits && h < 4 * spot.face + 3; ++h) result.push_back({Kind::split, h});
    return result;
  }

  // The patch of so many rings around a spot. Samples that belong to another sheet are farther away than the spot, or nearest
  // to other faces.
  Patch patch_around(const Spot& spot, int rings)
  {
    const auto& corner = mesh_.face_record(spot.sample.face).vertex;
    Patch result;
    result.vertices = ball(mesh_, {corner[0], corner[1], corner[2]}, rings, marks_);
    set_faces(result);
    samples_.start();
    std::vector<std::pair<double, Sample>> samples;
    const double radius = (PATCH_RADIUS + (rings - 1) * RING) * samples_.length();
    samples_.for_each_face_near(spot.sample.point, radius, spot.sample.surface_face, [&](Index f) {
      const auto take = [&](const Vector3& p) {
        if (squared_distance(p, spot.sample.point) > radius * radius) return;
        Sample s{p, f, spot.sample.face};
        const double d = samples_.distance(s, [&]() -> const std::vector<Index>& { return result.faces; });
        if (d <= spot.distance && std::binary_search(result.faces.begin(), result.faces.end(), s.face))
          samples.emplace_back(d, s);
      };
      samples_.for_each_corner_of(f, [&](Index, const Vector3& p) { take(p); });
      samples_.for_each_inner_sample_of(f, take);
    });
    std::stable_sort(samples.begin(), samples.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    samples.resize((std::min)(samples.size(), std::size_t(rings) * MOST_SAMPLES));
    for (const auto& s : samples) result.samples.push_back(s.second);
    return result;
  }

  // Where something is changed, `rest` becomes what is farthest away afterwards.
  Outcome mend(const Spot& found, int rings, Spot& rest)
  {
    const Sample& spot = found.sample;
    if (!mesh_.is_face(spot.face)) return Outcome::mended;
    samples_.set_scale_at(mesh_.face_record(spot.face).vertex[0]);
    Patch start = patch_around(found, rings);
    const Distances before = measure(start);
    if (before.largest < samples_.tolerance()) return Outcome::mended;
    if (start.vertices.size() > LARGEST_PATCH) return Outcome::nothing;
    const std::vector<Index> around = ball(mesh_, start.vertices, 1, marks_);
    before_.take(mesh_, around);
    double best_score = (1 - NOTICEABLE) * score(start, before);
    Trial best{Kind::move, -1};
    Outcome outcome = Outcome::nothing;
    for (const Trial& trial : trials(spot, rings == MOST_RINGS)) {
      ++trials_;
      Patch patch = start;
      if (!apply(trial, spot, patch, false)) continue;
      const Distances after = move_by_least_squares(patch, trial.kind == Kind::move ? before : measure(patch));
      const double s = score(patch, after);
      const bool is_better = s < best_score && !are_crossed(mesh_, grid_, patch.faces, marks_);
      if (is_better) rest = {after.largest, found.length, after.farthest, {}};
      if (is_better) outcome = after.largest < ACCEPTED * samples_.tolerance() ? Outcome::mended : Outcome::bettered;
      if (outcome == Outcome::mended && (!context_.visitor.listens() || trial.kind != Kind::split)) return outcome;
      if (is_better && trial.kind != Kind::split) best_.take(mesh_, around);
      before_.restore(mesh_);
      if (!is_better) continue;
      best = trial;
      best_score = s;
      if (outcome == Outcome::mended) break;
    }
    if (outcome == Outcome::nothing) return outcome;
    if (best.kind != Kind::split) { best_.restore(mesh_); return outcome; }
    Patch patch = start;
    apply(best, spot, patch, true);
    move_by_least_squares(patch, measure(patch));
    return outcome;
  }

  Remeshing_context& context_;
  Remeshing_mesh& mesh_;
  Distance_samples samples_;
  Face_grid grid_;
  Angle_bands bands_;
  Angle_descent descent_;
  Leaving_faces leaving_;
  Mesh_snapshot before_, best_;          // a trial, and after the best one without a split
  Visit_marks marks_, vertices_;
  std::vector<int> slot_;                // by vertex: its number in the patch that is measured
  std::size_t most_trials_, trials_ = 0;
};

// Returns the number of spots where something was changed.
inline std::size_t distance_pass(Remeshing_context& context)
{
  return Distance_reducer(context).run();
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_DISTANCE_PASS_H
