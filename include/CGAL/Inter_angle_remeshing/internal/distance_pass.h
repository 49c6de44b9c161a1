// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_DISTANCE_PASS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_DISTANCE_PASS_H

#include <CGAL/Inter_angle_remeshing/internal/Angle_descent.h>
#include <CGAL/Inter_angle_remeshing/internal/Face_grid.h>
#include <CGAL/Inter_angle_remeshing/internal/Mesh_snapshot.h>
#include <CGAL/Inter_angle_remeshing/internal/Mls_surface.h>
#include <CGAL/Inter_angle_remeshing/internal/Point_grid.h>
#include <CGAL/Inter_angle_remeshing/internal/Remeshing_context.h>
#include <CGAL/Inter_angle_remeshing/internal/angle_bands.h>
#include <CGAL/Inter_angle_remeshing/internal/crossings.h>
#include <CGAL/Inter_angle_remeshing/internal/flip_pass.h>
#include <CGAL/Inter_angle_remeshing/internal/folds.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh_regions.h>
#include <CGAL/Inter_angle_remeshing/internal/projection.h>
#include <CGAL/Inter_angle_remeshing/internal/split_pass.h>
#include <CGAL/Inter_angle_remeshing/internal/surface_walk.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

// Lowers the largest distances between the result and the surface. They are found at tips, which the result cuts off, and in
// crevices, which it bridges: where its faces meet at large angles. At each such spot, the worst one first, the vertices of a
// patch move by weighted least squares, the farthest samples counting most: as they are, with a vertex put onto the farthest
// point, or with an edge split there. The best of these stays if it leaves the angles as good.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

class Distance_reducer
{
  using Index = Remeshing_mesh::Index;
  using Barycentric = Mls_surface::Barycentric;

  // Spots are looked for beside edges at which the normals turn by more than 53 degrees.
  static constexpr double SHARP_COSINE = 0.6;
  // The surface around them is sampled within this many target lengths, and around a spot that is mended.
  static constexpr double REACH = 1.2, PATCH_RADIUS = 1.7, RING = 0.5;
  // A spot that a patch of one ring does not mend is tried again with a larger one, and with splits.
  static constexpr int MOST_RINGS = 2;
  // Spots that are nearer to each other than this are one.
  static constexpr double SPOT_DISTANCE = 1.5;
  // Longest distance between samples on an edge of the surface.
  static constexpr double SAMPLE_DISTANCE = 0.9;
  // A face of the surface is sampled beyond its corners where one of these is off by this part of the tolerance.
  static constexpr double SUSPICIOUS = 0.5;
  // Least squares end with the first part of the tolerance, and no more is tried with the second one.
  static constexpr double GOOD = 0.85, ACCEPTED = 0.95;
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
  // Edges are hardly longer, in target lengths.
  static constexpr double LONGEST_EDGE = 1.5;
  // Of the samples of a patch so many count, the farthest ones.
  static constexpr std::size_t MOST_SAMPLES = 120;

  struct Sample
  {
    Vector3 point;
    Index surface_face, face;            // on the surface; of the mesh, near by
  };
  struct Spot
  {
    double distance;
    Sample sample;
    std::optional<Vector3> place;        // on the mesh, where the spot is one of its faces that is far from the surface
  };
  enum class Outcome { nothing, bettered, mended };
  enum class Kind { move, snap, split };
  struct Trial
  {
    Kind kind;
    Index element;                       // vertex or half-edge
  };

public:
  Distance_reducer(Remeshing_context& context, double length)
    : context_(context), mesh_(context.mesh), surface_(*context.projector.surface), length_(length),
      tolerance_(context.recipe.distance_tolerance * length), bands_(context.recipe), descent_(context, length),
      most_trials_(LEAST_TRIALS + mesh_.number_of_live_faces() / FACES_PER_TRIAL)
  {}

  // Returns the number of spots where something was changed.
  std::size_t run()
  {
    std::size_t changes = 0;
    for (const Spot& spot : spots()) {
      Outcome outcome = Outcome::nothing;
      for (int rings = 1; rings <= MOST_RINGS && outcome != Outcome::mended && trials_ < most_trials_; ++rings)
        outcome = (std::max)(outcome, mend(spot, rings));
      changes += outcome != Outcome::nothing;
    }
    return changes;
  }

private:
  // --- where ----------------------------------------------------------------------------------------------------

  std::vector<Index> vertices_at_sharp_edges() const
  {
    std::vector<Vector3> normals(mesh_.number_of_face_slots());
    for (Index f = 0; f < Index(normals.size()); ++f)
      if (mesh_.is_face(f)) normals[f] = cross_product(mesh_, f);
    std::vector<Index> result;
    for (Index f = 0; f < Index(normals.size()); ++f) {
      if (!mesh_.is_face(f)) continue;
      for (Index h = 4 * f; h < 4 * f + 3; ++h) {
        const Index o = mesh_.opposite(h);
        if (o < h || mesh_.is_on_curve_edge(h) || is_cosine_at_least(normals[f], normals[mesh_.face(o)], SHARP_COSINE)) continue;
        result.push_back(mesh_.origin(h));
        result.push_back(mesh_.target(h));
      }
    }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  // Calls `function(surface face)` for the faces of the surface that have a corner within `radius` of p, from face f on.
  template <class Function>
  void for_each_surface_face_near(const Vector3& p, double radius, Index f, const Function& function)
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
      function(queue[i]);
      for (Index h = 4 * queue[i]; h < 4 * queue[i] + 3; ++h)
        if (surface_.opposite(h) >= 0 && !is_barrier(surface_, h)) add(surface_.face(surface_.opposite(h)));
    }
  }

  // Samples of a face of the surface. What two faces share is sampled with the one that is asked for first.
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
  // The same for points on long edges, and for the centre.
  template <class Function>
  void for_each_inner_sample_of(Index f, const Function& function)
  {
    const auto& v = surface_.face_record(f).vertex;
    for (int k = 0; k < 3; ++k) {
      const Index h = 4 * f + k, o = surface_.opposite(h);
      if (!surface_edges_.visit(std::size_t(o >= 0 && o < h ? o : h))) continue;
      const double l = std::sqrt(squared_distance(surface_.position(v[k]), surface_.position(v[(k + 1) % 3]))) /
                       context_.projector.factor;
      const int n = l < SAMPLE_DISTANCE / 3 * length_ ? 0 : (std::min)(6, 1 + int(l / (SAMPLE_DISTANCE * length_)));
      for (int i = 1; i <= n; ++i) {
        const double t = double(i) / (n + 1);
        Barycentric b{0, 0, 0};
        b[k] = 1 - t;
        b[(k + 1) % 3] = t;
        function(context_.projector.at(f, b).point);
      }
    }
    if (surface_.least_altitude(f) > SAMPLE_DISTANCE / 3 * length_ * context_.projector.factor)
      function(context_.projector.at(f, {1. / 3, 1. / 3, 1. / 3}).point);
  }
  void start_sampling()
  {
    surface_vertices_.start(surface_.number_of_vertices());
    surface_edges_.start(4 * surface_.number_of_faces());
  }

  // The distance of a sample from the mesh; a walk that ends far away is checked against the faces that `around()` names.
  template <class Faces>
  double distance(Sample& s, const Faces& around, Point_on_triangle& nearest) const
  {
    nearest = walk_to_closest_point(mesh_, s.point, s.face);
    double d = squared_distance(nearest.point, s.point);
    if (d > GOOD * GOOD * tolerance_ * tolerance_)
      for (const Index f : around()) {
        const Point_on_triangle c = closest_point_on_face(mesh_, s.point, f);
        if (const double e = squared_distance(c.point, s.point); e < d) { d = e; nearest = c; s.face = f; }
      }
    return std::sqrt(d);
  }

  // The nearest point of the surface to a point of face f, and the face that it is on. Walks may end in a nook: where they end
  // far away, the faces near by are looked at.
  Vector3 nearest_on_surface(Index f, const Vector3& y, Index& surface_face)
  {
    const double enough = GOOD * GOOD * tolerance_ * tolerance_;
    Vector3 result;
    double least = std::numeric_limits<double>::infinity();
    const auto look_from = [&](Index hint) {
      const Vector3 p = context_.projector(y, hint);
      if (const double d = squared_distance(p, y); d < least) { least = d; result = p; surface_face = hint; }
    };
    for (const Index v : mesh_.face_record(f).vertex) {
      look_from(mesh_.hint(v));
      if (least < enough) return result;
    }
    const double unit = context_.projector.factor;
    const Vector3 q = unit * y;
    Index nearest = -1;
    double d = unit * unit * least;
    for_each_surface_face_near(y, std::sqrt(least) + length_ / 2, surface_face, [&](Index g) {
      if (const double e = squared_distance(closest_point_on_face(surface_, q, g).point, q); e < d) { d = e; nearest = g; }
    });
    if (nearest >= 0) look_from(nearest);
    return result;
  }

  // Whether what is far from its own sheet is near another one, as where the surface crosses itself.
  bool is_near_elsewhere(const Spot& spot)
  {
    const Vector3 p = spot.place.value_or(spot.sample.point);
    const double enough = tolerance_ * tolerance_;
    const Vector3 reach{tolerance_, tolerance_, tolerance_};
    bool result = false;
    grid().for_each_near(p - reach, p + reach, marks_, [&](Index f) {
      if (!spot.place) result = squared_distance(closest_point_on_face(mesh_, p, f).point, p) < enough;
      else for (const Index v : mesh_.face_record(f).vertex) {
        Index hint = mesh_.hint(v);
        if (squared_distance(context_.projector(p, hint), p) < enough) result = true;
      }
      return !result;
    });
    return result;
  }

  // Points of the surface that are too far from the mesh.
  void find_far_samples_of_surface(const std::vector<Index>& sharp, std::vector<Spot>& found)
  {
    std::vector<float> corner_distance(surface_.number_of_vertices());
    Visit_marks sampled;
    sampled.start(surface_.number_of_faces());
    start_sampling();
    for (const Index v : sharp) {
      std::vector<Index> faces;
      const auto around = [&]() -> const std::vector<Index>& {
        if (faces.empty()) faces = faces_around(mesh_, ball(mesh_, {v}, 2, marks_));
        return faces;
      };
      for_each_surface_face_near(mesh_.position(v), REACH * length_, mesh_.hint(v), [&](Index f) {
        if (!sampled.visit(std::size_t(f))) return;
        const auto sample = [&](const Vector3& p) {
          Sample s{p, f, mesh_.face(mesh_.first(v))};
          Point_on_triangle nearest;
          const double d = distance(s, around, nearest);
          if (d > tolerance_) found.push_back({d, s, {}});
          return d;
        };
        for_each_corner_of(f, [&](Index u, const Vector3& p) { corner_distance[u] = float(sample(p)); });
        const auto& corner = surface_.face_record(f).vertex;
        if (std::any_of(corner, corner + 3, [&](Index u) { return corner_distance[u] > SUSPICIOUS * tolerance_; }))
          for_each_inner_sample_of(f, sample);
      });
    }
  }

  // Points of the mesh that are too far from the surface.
  void find_far_samples_of_mesh(const std::vector<Index>& sharp, std::vector<Spot>& found)
  {
    for (const Index f : faces_around(mesh_, sharp))
      for (int k = 0; k < 4; ++k) {
        const Vector3 y = point_on_face(f, PLACES[k]);
        Sample s{Vector3(), -1, f};
        s.point = nearest_on_surface(f, y, s.surface_face);
        if (const double d = length(s.point - y); d > tolerance_) found.push_back({d, s, y});
      }
  }

  // The worst one first, none near another one.
  std::vector<Spot> spots()
  {
    std::vector<Spot> found;
    const std::vector<Index> sharp = vertices_at_sharp_edges();
    find_far_samples_of_surface(sharp, found);
    find_far_samples_of_mesh(sharp, found);
    std::stable_sort(found.begin(), found.end(), [](const Spot& a, const Spot& b) { return a.distance > b.distance; });
    std::vector<Spot> result;
    Point_grid accepted(SPOT_DISTANCE * length_);
    for (const Spot& spot : found) {
      if (accepted.has_near(spot.sample.point) || is_near_elsewhere(spot)) continue;
      accepted.insert(spot.sample.point);
      result.push_back(spot);
      if (result.size() == most_trials_) break;
    }
    return result;
  }

  // --- what -----------------------------------------------------------------------------------------------------

  // Centre, middles of the edges, and corners of a face.
  static constexpr double PLACES[7][3] = {{1. / 3, 1. / 3, 1. / 3}, {.5, .5, 0}, {0, .5, .5}, {.5, 0, .5},
                                          {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  Vector3 point_on_face(Index f, const double (&b)[3]) const
  {
    const auto& v = mesh_.face_record(f).vertex;
    return b[0] * mesh_.position(v[0]) + b[1] * mesh_.position(v[1]) + b[2] * mesh_.position(v[2]);
  }

  // The vertices that move, and what pulls them.
  struct Patch
  {
    std::vector<Index> vertices;
    std::vector<Index> faces;            // around them
    std::vector<std::array<Index, 7>> surface_faces;   // by face: where its places are nearest to; -1: to be looked for
    std::vector<Sample> samples;         // of the surface
    std::vector<Vector3> pull;           // by vertex
    std::vector<double> weight;
  };

  void set_faces(Patch& patch) const
  {
    patch.faces = faces_around(mesh_, patch.vertices);
    patch.surface_faces.assign(patch.faces.size(), {-1, -1, -1, -1, -1, -1, -1});
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
    const auto pull = [&](Index f, const auto& b, const Vector3& way, double d) {
      result.largest = (std::max)(result.largest, d);
      const double e = (std::max)(0., d - tolerance_ / 2);
      result.excess += e * e * e * e;
      const double part = d / tolerance_, weight = part * part * part * part + LEAST_WEIGHT;
      for (int k = 0; k < 3; ++k) {
        const int i = slot_[mesh_.face_record(f).vertex[k]];
        if (i < 0) continue;
        patch.pull[i] += (weight * b[k]) * way;
        patch.weight[i] += weight * b[k] * b[k];
      }
    };
    for (Sample& s : patch.samples) {
      const Point_on_triangle c = walk_to_closest_point(mesh_, s.point, s.face);
      const double d = length(s.point - c.point);
      const auto& v = mesh_.face_record(s.face).vertex;
      pull(s.face, barycentric(c, mesh_.position(v[0]), mesh_.position(v[1]), mesh_.position(v[2])), s.point - c.point, d);
    }
    vertices_.start(mesh_.number_of_vertex_slots());
    for (std::size_t k = 0; k < patch.faces.size(); ++k)
      for (int i = 0; i < 7; ++i) {
        const Index f = patch.faces[k];
        if (i > 0 && i < 4 && is_with_other_face(patch, 4 * f + i - 1)) continue;
        if (i >= 4 && !vertices_.visit(std::size_t(mesh_.face_record(f).vertex[i - 4]))) continue;
        const Vector3 y = point_on_face(f, PLACES[i]);
        Index& g = patch.surface_faces[k][i];
        const Vector3 way = (g < 0 ? nearest_on_surface(f, y, g) : context_.projector(y, g)) - y;
        pull(f, PLACES[i], way, length(way));
      }
    for (const Index v : patch.vertices) slot_[v] = -1;
    return result;
  }

  // Returns the distances afterwards.
  Distances move_by_least_squares(Patch& patch)
  {
    Distances distances = measure(patch);
    for (int i = 0; i < ITERATIONS && distances.largest > GOOD * tolerance_; ++i) {
      for (std::size_t k = 0; k < patch.vertices.size(); ++k) {
        const Index v = patch.vertices[k];
        if (!mesh_.is_free(v) || !(patch.weight[k] > 0)) continue;
        Vector3 step = (STEP / (patch.weight[k] + REGULAR)) * patch.pull[k];
        const double l = length(step);
        if (l > LONGEST * length_) step = (LONGEST * length_ / l) * step;
        descent_.displace(v, step, i + 2 < ITERATIONS ? SLACK : 0, TRIES);
      }
      descent_.sweep(patch.vertices, i + 1 < ITERATIONS ? SWEEPS : LAST_SWEEPS);
      distances = measure(patch);
    }
    return distances;
  }

  // What is too far away, in target lengths, and what is out of the band or folded.
  double score(const Patch& patch, const Distances& distances) const
  {
    double result = std::sqrt(std::sqrt(distances.excess)) / length_;
    for (const Index f : patch.faces)
      if (const double v = violation(context_, bands_, f); v > 0) result += DEGREE * (v + TOUCH);
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
    start_sampling();
    std::vector<std::pair<double, Sample>> samples;
    const double radius = (PATCH_RADIUS + (rings - 1) * RING) * length_;
    for_each_surface_face_near(spot.sample.point, radius, spot.sample.surface_face, [&](Index f) {
      const auto take = [&](const Vector3& p) {
        if (squared_distance(p, spot.sample.point) > radius * radius) return;
        Sample s{p, f, spot.sample.face};
        Point_on_triangle nearest;
        const double d = distance(s, [&]() -> const std::vector<Index>& { return result.faces; }, nearest);
        if (d <= spot.distance && std::binary_search(result.faces.begin(), result.faces.end(), s.face))
          samples.emplace_back(d, s);
      };
      for_each_corner_of(f, [&](Index, const Vector3& p) { take(p); });
      for_each_inner_sample_of(f, take);
    });
    std::stable_sort(samples.begin(), samples.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    samples.resize((std::min)(samples.size(), std::size_t(rings) * MOST_SAMPLES));
    for (const auto& s : samples) result.samples.push_back(s.second);
    return result;
  }

  Outcome mend(const Spot& found, int rings)
  {
    const Sample& spot = found.sample;
    if (!mesh_.is_face(spot.face)) return Outcome::mended;
    Patch start = patch_around(found, rings);
    const Distances before = measure(start);
    if (before.largest < tolerance_) return Outcome::mended;
    if (start.vertices.size() > LARGEST_PATCH) return Outcome::nothing;
    grid();                              // of the mesh before any trial
    snapshot_.take(mesh_, ball(mesh_, start.vertices, 1, marks_));
    double best_score = (1 - NOTICEABLE) * score(start, before);
    Trial best{Kind::move, -1};
    Outcome outcome = Outcome::nothing;
    for (const Trial& trial : trials(spot, rings == MOST_RINGS)) {
      ++trials_;
      Patch patch = start;
      if (!apply(trial, spot, patch, false)) continue;
      const Distances after = move_by_least_squares(patch);
      const double s = score(patch, after);
      const bool is_better = s < best_score && !are_crossed(mesh_, grid(), patch.faces, marks_);
      if (is_better) outcome = after.largest < ACCEPTED * tolerance_ ? Outcome::mended : Outcome::bettered;
      if (outcome == Outcome::mended && (!context_.visitor.listens() || trial.kind != Kind::split)) return outcome;
      snapshot_.restore(mesh_);
      if (!is_better) continue;
      best = trial;
      best_score = s;
      if (outcome == Outcome::mended) break;
    }
    if (outcome == Outcome::nothing) return outcome;
    Patch patch = start;
    apply(best, spot, patch, true);
    move_by_least_squares(patch);
    return outcome;
  }

  // Made when it is needed first.
  const Face_grid& grid()
  {
    if (!grid_) grid_.emplace(mesh_, LONGEST_EDGE * length_);
    return *grid_;
  }

  Remeshing_context& context_;
  Remeshing_mesh& mesh_;
  const Reference_surface& surface_;
  double length_, tolerance_;
  Angle_bands bands_;
  Angle_descent descent_;
  Mesh_snapshot snapshot_;
  std::optional<Face_grid> grid_;
  Visit_marks marks_, vertices_, surface_faces_, surface_vertices_, surface_edges_;
  std::vector<int> slot_;                // by vertex: its number in the patch that is measured
  std::size_t most_trials_, trials_ = 0;
};

// Returns the number of spots where something was changed.
inline std::size_t distance_pass(Remeshing_context& context, double length)
{
  return Distance_reducer(context, length).run();
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_DISTANCE_PASS_H
