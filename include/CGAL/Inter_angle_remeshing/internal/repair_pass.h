// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_REPAIR_PASS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_REPAIR_PASS_H

#include <CGAL/Inter_angle_remeshing/internal/Angle_descent.h>
#include <CGAL/Inter_angle_remeshing/internal/Face_grid.h>
#include <CGAL/Inter_angle_remeshing/internal/Mesh_snapshot.h>
#include <CGAL/Inter_angle_remeshing/internal/Point_grid.h>
#include <CGAL/Inter_angle_remeshing/internal/Remeshing_context.h>
#include <CGAL/Inter_angle_remeshing/internal/angle_bands.h>
#include <CGAL/Inter_angle_remeshing/internal/collapse_pass.h>
#include <CGAL/Inter_angle_remeshing/internal/crossing_faces.h>
#include <CGAL/Inter_angle_remeshing/internal/flip_pass.h>
#include <CGAL/Inter_angle_remeshing/internal/folds.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh_regions.h>
#include <CGAL/Inter_angle_remeshing/internal/split_pass.h>
#include <CGAL/Inter_angle_remeshing/internal/surface_walk.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

// Mends the faces whose angles no move of a vertex brings into the band, and folds: the worst one first, every flip, collapse
// and split near it is tried, each followed by descents of the vertices around; the one that leaves least stays, all others
// are undone. So, at last, with the faces that cross others where the surface does not.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

class Repairer
{
  using Index = Remeshing_mesh::Index;

  // Rounds over the faces that are bad; in the first one only operations next to the face are tried.
  static constexpr int MAXIMUM_ROUNDS = 12;
  static constexpr std::size_t VERTICES_AT_FIRST = 3, VERTICES_LATER = 12;
  // Sweeps of descent over the vertices around an operation that is tried, and around so many of the best.
  static constexpr int FIRST_SWEEPS = 2, SWEEPS = 8;
  static constexpr std::size_t FINALISTS = 5;
  // The pass ends after so many trials for angles and as many for folds, and so many more of each for every bad face, but at most
  // one for so many faces of the input or of the mesh, what is more: a trial takes as long as ten faces of the run.
  static constexpr std::size_t LEAST_TRIALS = 100, TRIALS_PER_BAD_FACE = 10, FACES_PER_TRIAL = 40;
  // Where faces cross, so many times as many, for they are few, and hardly any finalists; where the surface does, too, no more.
  static constexpr std::size_t CROSSING_TRIALS = 6, CROSSING_FINALISTS = 2;
  // There the pass ends, too, after so many looks at what may be near for every face, and for so many more. Where sheets lie on each
  // other by the dozen, thousands are near each; the meshes of CGAL take at most 16.
  static constexpr std::size_t LOOKS_PER_FACE = 100, FURTHER_FACES = 1000;
  // Operations at vertices with hundreds of edges would take too long to try.
  static constexpr std::size_t LARGEST_REGION = 100;
  // Squared lengths, in those of the target, up to which edges are collapsed and from which they are split here.
  static constexpr double COLLAPSED = 1.1, SPLIT = 0.8;
  // What a collapse may do here: the square of the longest new edge, and how far from the new surface the vertex may lie.
  static constexpr double LONGEST = 3, TOLERANCE = 0.3;
  // By how much a flip may raise the sum of the squared valence deviations.
  static constexpr int GAIN_AT_FIRST = 4, GAIN_LATER = 8;
  // An operation stays if it takes away this part of what is bad around it.
  static constexpr double NOTICEABLE = 0.02;
  static constexpr double TOUCH = 0.05;      // degrees that every bad face counts more
  // What two faces that cross each other count, and what the length of the segment in which they do, in target lengths; less where
  // the surface crosses itself: angles are not given up for what cannot be parted. Edges may be split that are much shorter.
  static constexpr double CROSSING = 200, CROSSING_LENGTH = 6000, INHERITED_CROSSING = 100, SPLIT_AT_CROSSING = 0.1;
  // To unfold a face the mesh may withdraw so many times as far.
  static constexpr double UNFOLDING = 2;
  // Where the surface crosses itself within so many target lengths, or edges of its own, faces may cross. Places that are this near
  // to each other, of which a surface finer than the target has any number, are one.
  static constexpr double SAME_PLACE = 1.5, ONE_PLACE = 0.1;
  // What a surface whose edges are shorter than the target by this factor crosses is small: it is parted, too, where that is easy.
  static constexpr double COARSE = 1.5;
  // What an operation near a face changes lies within so many rings of it.
  static constexpr int REACH = 4;

  enum class Fault { angle, fold, crossing, inherited_crossing };
  enum class Kind { none, flip, collapse, split, place };    // the last one puts a vertex onto the surface
  struct Operation
  {
    Kind kind = Kind::none;
    Index halfedge = -1;
  };
  struct Crossing
  {
    Index face, other;
    double score;
  };
  struct Bad_faces
  {
    std::vector<Index> faces;
    double score = 0;
  };

public:
  Repairer(Remeshing_context& context, std::size_t input_faces)
    : context_(context), mesh_(context.mesh), input_faces_(input_faces), bands_(context.recipe), descent_(context),
      leaving_(context),
      limits_{LONGEST * squared(context.target_length), squared(TOLERANCE * context.target_length), MAXIMUM_MERGED_VALENCE}
  {}

  // Returns the number of operations. A further run looks at what has become bad since; what was given up stays so, and the
  // number of trials is that of both.
  std::size_t run()
  {
    return mend([&]() {
      std::vector<std::pair<double, Index>> bad = bad_faces();
      std::sort(bad.begin(), bad.end());
      Bad_faces result;
      for (const auto& [minus_violation, f] : bad) {
        result.faces.push_back(f);
        result.score += score_of_violation(-minus_violation);
      }
      return result;
    });
  }

  // Whether the last run left faces out of their bands, or folded.
  bool leaves_bad_faces() const { return leaves_bad_faces_; }

  // The same for faces that cross others; at the end `crossing` is the number of those that still do.
  template <class ConcurrencyTag>
  std::size_t part_crossing_faces(std::size_t& crossing)
  {
    given_up_.clear();
    in_vain_.clear();
    fault_ = Fault::crossing;
    most_trials_ = 0;
    places_of_surface_.reset();
    const std::size_t operations = mend([&]() {
      const std::vector<std::pair<Index, Index>> pairs = crossing_faces<ConcurrencyTag>(mesh_);
      Bad_faces result{faces_of(pairs)};
      crossing = result.faces.size();
      if (pairs.empty()) return result;
      if (!places_of_surface_) places_of_surface_ = places_where_surface_crosses<ConcurrencyTag>();
      for (const auto& [f, g] : pairs) result.score += score_of_crossing(f, g);
      const auto inherited = std::stable_partition(result.faces.begin(), result.faces.end(), [&](Index f) { return !is_inherited(f); });
      if (context_.target_length < COARSE * places_of_surface_->edge_length) result.faces.erase(inherited, result.faces.end());
      else sort_by_crossing_lengths(inherited, result.faces.end(), pairs);
      grid_.emplace(mesh_, context_.largest_length());
      return result;
    });
    if (round_ == MAXIMUM_ROUNDS) crossing = faces_of(crossing_faces<ConcurrencyTag>(mesh_)).size();
    return operations;
  }

private:
  static double squared(double x) { return x * x; }

  static std::vector<Index> faces_of(const std::vector<std::pair<Index, Index>>& pairs)
  {
    std::vector<Index> result;
    for (const auto& [f, g] : pairs) result.insert(result.end(), {f, g});
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  // Goes over the faces that `find()` names until they do not get better: what mends one may spoil another.
  template <class Find>
  std::size_t mend(const Find& find)
  {
    std::size_t operations = 0;
    double least = std::numeric_limits<double>::infinity();
    for (round_ = 0; round_ < MAXIMUM_ROUNDS; ++round_) {
      const Bad_faces bad = find();
      leaves_bad_faces_ = !bad.faces.empty();
      if (bad.faces.empty() || (round_ > 1 && !(bad.score < least))) break;
      least = (std::min)(least, bad.score);
      if (most_trials_ == 0)
        most_trials_ = LEAST_TRIALS + (std::min)(TRIALS_PER_BAD_FACE * bad.faces.size(),
                                                 (std::max)(input_faces_, mesh_.number_of_live_faces()) / FACES_PER_TRIAL);
      const char level = round_ == 0 ? 1 : 2;
      const std::size_t operations_before = operations;
      for (const Index f : bad.faces) {
        if (!mesh_.is_face(f) || given_up(f) >= level) continue;
        fault_ = fault_of(f);
        if (trials() > most_trials() || has_looked_enough() || !is_bad(f)) continue;
        if (const Operation best = best_operation(f); best.kind != Kind::none) {
          commit(best);
          ++operations;
        } else
          given_up(f) = level;
      }
      if (round_ > 0 && operations == operations_before) break;
    }
    return operations;
  }

  bool is_at_crossing() const { return fault_ == Fault::crossing || fault_ == Fault::inherited_crossing; }

  std::size_t& trials() { return trials_[std::size_t(fault_)]; }
  std::size_t most_trials() const { return fault_ == Fault::crossing ? CROSSING_TRIALS * most_trials_ : most_trials_; }

  // What face f has, if it has a fault of those that are looked for.
  Fault fault_of(Index f) const
  {
    if (is_at_crossing()) return is_inherited(f) ? Fault::inherited_crossing : Fault::crossing;
    return fold_violation(context_, f) > 0 ? Fault::fold : Fault::angle;
  }
  bool is_bad(Index f) { return is_at_crossing() ? are_crossed(mesh_, *grid_, {f}, marks_, looks_) : violation(f) > 0; }

  bool has_looked_enough() const { return looks_ > LOOKS_PER_FACE * (mesh_.number_of_live_faces() + FURTHER_FACES); }

  // Where the surface crosses itself: corners of its faces that do, in units of the mesh, of those close together one.
  struct Places
  {
    Point_grid corners;
    double edge_length = 0;                // the mean of the surface: what is bent over its faces crosses that far elsewhere
  };

  template <class ConcurrencyTag>
  Places places_where_surface_crosses() const
  {
    if (!context_.projector.has_faces()) return {Point_grid(SAME_PLACE * context_.largest_length())};
    const Reference_surface& surface = *context_.projector.surface;
    double sum = 0;
    for (Index f = 0; f < Index(surface.number_of_faces()); ++f) sum += mean_edge_length(surface, f);
    const double edge_length = sum / (double(surface.number_of_faces()) * context_.projector.factor);
    Places result{Point_grid(SAME_PLACE * (std::max)(edge_length, context_.largest_length())), edge_length};
    for (const Index f : faces_of(crossing_faces<ConcurrencyTag>(surface)))
      for (const Index v : surface.face_record(f).vertex) {
        const Vector3 p = (1 / context_.projector.factor) * surface.position(v);
        if (!result.corners.has_near(p, ONE_PLACE * context_.target_length)) result.corners.insert(p);
      }
    return result;
  }

  // Whether the surface crosses itself near face f.
  bool is_inherited(Index f) const
  {
    const auto& v = mesh_.face_record(f).vertex;
    return std::any_of(v, v + 3, [&](Index u) {
      return places_of_surface_->corners.has_near(
        mesh_.position(u), SAME_PLACE * (std::max)(places_of_surface_->edge_length, context_.length_at(u))); });
  }

  // Those first that cross others in the shortest segments.
  void sort_by_crossing_lengths(std::vector<Index>::iterator begin, std::vector<Index>::iterator end,
                                const std::vector<std::pair<Index, Index>>& pairs) const
  {
    std::vector<double> longest(mesh_.number_of_face_slots(), 0);
    for (const auto& [f, g] : pairs) {
      const double l = crossing_length(mesh_, f, g) / context_.length_at(mesh_.face_record(f).vertex[0]);
      for (const Index x : {f, g}) longest[x] = (std::max)(longest[x], l);
    }
    std::stable_sort(begin, end, [&](Index f, Index g) { return longest[f] < longest[g]; });
  }

  // 1 if no operation next to face f helps, 2 if none near it does.
  char& given_up(Index f)
  {
    if (std::size_t(f) >= given_up_.size()) given_up_.resize(mesh_.number_of_face_slots(), 0);
    return given_up_[f];
  }

  std::vector<std::pair<double, Index>> bad_faces() const
  {
    std::vector<std::pair<double, Index>> result;
    for (Index f = 0; f < Index(mesh_.number_of_face_slots()); ++f)
      if (mesh_.is_face(f))
        if (const double v = violation(f); v > 0) result.emplace_back(-v, f);
    return result;
  }

  // Operations that were tried, from whichever face, and did not help; until something changes there. A half-edge of the border has
  // no slot, and what starts from it is tried again.
  bool is_in_vain(const Operation& operation) const
  {
    const Index h = operation.halfedge;
    return h >= 0 && std::size_t(h) < in_vain_.size() && (in_vain_[h] >> int(operation.kind) & 1) != 0;
  }
  void note_in_vain(const Operation& operation)
  {
    const Index h = operation.halfedge;
    if (h < 0) return;
    if (std::size_t(h) >= in_vain_.size()) in_vain_.resize(4 * mesh_.number_of_face_slots(), 0);
    in_vain_[h] |= char(1 << int(operation.kind));
  }
  void forget(Index f)
  {
    given_up(f) = 0;
    for (std::size_t h = 4 * std::size_t(f); h < 4 * std::size_t(f) + 3 && h < in_vain_.size(); ++h) in_vain_[h] = 0;
  }

  double violation(Index f) const { return internal::violation(context_, bands_, f); }

  static double score_of_violation(double v) { return v > 0 ? TOUCH + v + v * v : 0; }

  double score_of_crossing(Index f, Index g) const
  {
    if (is_inherited(f) && is_inherited(g)) return INHERITED_CROSSING;
    return CROSSING + CROSSING_LENGTH * crossing_length(mesh_, f, g) / context_.length_at(mesh_.face_record(f).vertex[0]);
  }

  // How bad these faces are.
  double score(const std::vector<Index>& faces)
  {
    double sum = 0;
    leaving_.start();
    if (is_at_crossing()) for_each_crossing_near(faces, [&](Index f, Index g) { sum += score_of_crossing(f, g); });
    for (const Index f : faces)
      if (mesh_.is_face(f)) sum += score_of_violation(internal::violation(mesh_, bands_, f, leaving_));
    return sum;
  }

  // How bad they were before anything was tried for the face at hand.
  double score_before(const std::vector<Index>& faces)
  {
    const auto is_one = [&](Index f) { return std::binary_search(faces.begin(), faces.end(), f); };
    double sum = 0;
    for (const Crossing& c : crossings_before_)
      if (is_one(c.face) || is_one(c.other)) sum += c.score;
    for (const Index f : faces) {
      if (is_scored_.visit(std::size_t(f))) score_before_[f] = score_of_violation(violation(f));
      sum += score_before_[f];
    }
    return sum;
  }

  // Calls `function(face, other)` for the pairs of faces that cross each other, of which one is among these.
  template <class Function>
  void for_each_crossing_near(std::vector<Index> faces, const Function& function) const
  {
    const auto is_dead = [&](Index f) { return !mesh_.is_face(f); };
    faces.erase(std::remove_if(faces.begin(), faces.end(), is_dead), faces.end());
    std::vector<Index> others = near_;
    others.insert(others.end(), faces.begin(), faces.end());
    std::sort(others.begin(), others.end());
    others.erase(std::unique(others.begin(), others.end()), others.end());
    others.erase(std::remove_if(others.begin(), others.end(), is_dead), others.end());
    for_each_crossing(mesh_, faces, others, [&](Index f, Index g) {
      function(f, g);
      return true;
    });
  }

  // Nothing has been tried for face f yet.
  void start(Index f)
  {
    is_scored_.start(mesh_.number_of_face_slots());
    score_before_.resize((std::max)(score_before_.size(), mesh_.number_of_face_slots()));
    crossings_before_.clear();
    if (!is_at_crossing()) return;
    const auto& corner = mesh_.face_record(f).vertex;
    const std::vector<Index> within_reach = faces_around(mesh_, ball(mesh_, {corner[0], corner[1], corner[2]}, REACH, marks_));
    near_ = faces_near(mesh_, *grid_, within_reach, marks_, looks_);
    for_each_crossing_near(within_reach, [&](Index g, Index other) {
      crossings_before_.push_back({g, other, score_of_crossing(g, other)}); });
  }

  // What may be tried near face f.
  std::vector<Operation> operations(Index f)
  {
    const auto& corner = mesh_.face_record(f).vertex;
    std::vector<Index> centers = ball(mesh_, {corner[0], corner[1], corner[2]}, 1, marks_);
    centers.resize((std::min)(centers.size(), round_ == 0 ? VERTICES_AT_FIRST : VERTICES_LATER));
    const auto is_hub = [&](Index v) { return std::size_t(mesh_.valence(v)) > LARGEST_REGION; };
    centers.erase(std::remove_if(centers.begin(), centers.end(), is_hub), centers.end());
    std::vector<Index> edges;
    std::vector<Operation> result;
    if (is_at_crossing() && context_.projector.has_faces())
      for (const Index v : centers) if (mesh_.is_free(v)) result.push_back({Kind::place, mesh_.first(v)});
    for (const Index v : centers)
      mesh_.for_each_around(v, [&](Index h) {
        for (const Index k : {h, mesh_.prev(h)}) {
          const Index o = mesh_.opposite(k);
          edges.push_back(o >= 0 && o < k ? o : k);
        }
      });
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    const double shortest = is_at_crossing() ? SPLIT_AT_CROSSING : SPLIT;
    const int gain = round_ == 0 ? GAIN_AT_FIRST : GAIN_LATER;
    for (const Index h : edges) {
      const double unit = squared(context_.length_at(mesh_.origin(h), mesh_.target(h)));
      const double l = mesh_.squared_edge_length(h);
      if (!mesh_.is_on_curve_edge(h) && flip_gain(mesh_, h) <= gain) result.push_back({Kind::flip, h});
      if (l < COLLAPSED * unit) {
        result.push_back({Kind::collapse, h});
        result.push_back({Kind::collapse, mesh_.opposite(h)});
      }
      if (l > shortest * unit) result.push_back({Kind::split, h});
    }
    return result;
  }

  bool is_allowed(const Operation& operation) const
  {
    const Index h = operation.halfedge;
    switch (operation.kind) {
    case Kind::flip:
      return fault_ != Fault::angle ? mesh_.is_flip_legal(h) && context_.permits_flip(h, false) : is_flip_allowed(context_, h, false);
    case Kind::collapse:
      if (fault_ == Fault::fold && mesh_.is_free(mesh_.source(h))) return mesh_.is_collapse_legal(h) && context_.permits_collapse(h);
      return mesh_.valence(mesh_.source(h)) + mesh_.valence(mesh_.source(mesh_.opposite(h))) - 4 <= limits_.valence &&
             is_collapse_allowed(context_, h, limits_);
    case Kind::split: return mesh_.is_split_legal(h) && context_.permits_split(h);
    case Kind::place: return true;
    default: return false;
    }
  }

  // Returns the vertices that it touched. The visitor is told of what stays only.
  std::vector<Index> apply(const Operation& operation, bool is_announced = false)
  {
    const Index h = operation.halfedge;
    std::vector<Index> touched = ends_and_apexes(mesh_, h);
    if (operation.kind == Kind::flip) {
      if (is_announced) flip(context_, h); else mesh_.flip(h);
    } else if (operation.kind == Kind::collapse) {
      touched.erase(std::find(touched.begin(), touched.end(), mesh_.source(h)));
      if (is_announced) collapse(context_, h); else mesh_.collapse(h);
    } else if (operation.kind == Kind::place) {
      const Index v = mesh_.origin(h);
      mesh_.position(v) = context_.projector(mesh_.position(v), mesh_.hint(v));
    } else {
      const Split_vertex made = is_announced ? split(context_, h) : split_edge(context_, h);
      project_split_vertices<CGAL::Sequential_tag>(context_, {made});
      touched.push_back(made.vertex);
    }
    return touched;
  }

  // How much less is bad after the operation and so many sweeps, if they leave no place that is asked for; all is undone.
  double gain(const Operation& operation, int sweeps, bool keeps_places = false)
  {
    const std::vector<Index> around = ball(mesh_, ends_and_apexes(mesh_, operation.halfedge), 1, marks_);
    if (around.size() > LARGEST_REGION) return 0;
    ++trials();
    snapshot_.take(mesh_, around);
    const double before = score_before(snapshot_.faces());
    const std::vector<Index> moving = ball(mesh_, apply(operation), 1, marks_);
    descent_.sweep(moving, sweeps);
    const std::vector<Index> faces = faces_around(mesh_, moving);
    const double after = score(faces);
    const bool pays = before - after > NOTICEABLE * before && !(keeps_places && leaves_places(around, faces));
    snapshot_.restore(mesh_);
    return pays ? before - after : 0;
  }

  // Whether the mesh, of which these faces are new, has withdrawn too far from places of vertices that were around.
  bool leaves_places(const std::vector<Index>& around, const std::vector<Index>& faces) const
  {
    return !std::all_of(around.begin(), around.end(), [&](Index v) {
      const double longest = (fault_ == Fault::fold ? UNFOLDING : 1) * Kept_places::LONGEST_WITHDRAWAL * context_.length_at(v);
      return context_.kept_places.all_of(v, [&](const Vector3& place) {
        return std::any_of(faces.begin(), faces.end(), [&](Index f) {
          return squared_distance(closest_point_on_face(mesh_, place, f).point, place) <= longest * longest;
        });
      });
    });
  }

  // A few sweeps tell which operations are promising, many more which of these is the best.
  Operation best_operation(Index f)
  {
    start(f);
    std::vector<std::pair<double, Operation>> promising;
    for (const Operation& operation : operations(f)) {
      if (trials() > most_trials() || is_in_vain(operation) || !is_allowed(operation)) continue;
      if (const double g = gain(operation, FIRST_SWEEPS); g > 0)
        promising.emplace_back(g, operation);
      else
        note_in_vain(operation);
    }
    const std::size_t n = (std::min)(promising.size(), is_at_crossing() ? CROSSING_FINALISTS : FINALISTS);
    const auto is_better = [](const auto& a, const auto& b) { return a.first > b.first; };
    std::stable_sort(promising.begin(), promising.end(), is_better);
    promising.resize(n);
    for (auto& p : promising) p.first = gain(p.second, SWEEPS, !is_at_crossing());
    const auto best = std::min_element(promising.begin(), promising.end(), is_better);
    return best != promising.end() && best->first > 0 ? best->second : Operation();
  }

  void commit(const Operation& operation)
  {
    if (const Index h = operation.halfedge; operation.kind == Kind::collapse)
      context_.kept_places.hand_over(mesh_.source(h), mesh_.source(mesh_.opposite(h)));
    const std::vector<Index> touched = apply(operation, true);
    descent_.sweep(ball(mesh_, touched, 1, marks_), SWEEPS);
    const std::vector<Index> around = ball(mesh_, touched, 2, marks_);
    descent_.sweep(around, SWEEPS);
    for (const Index g : faces_around(mesh_, around)) forget(g);
  }

  Remeshing_context& context_;
  Remeshing_mesh& mesh_;
  std::size_t input_faces_;
  Angle_bands bands_;
  Angle_descent descent_;
  Leaving_faces leaving_;
  Collapse_limits limits_;
  Mesh_snapshot snapshot_;
  std::optional<Places> places_of_surface_;    // for crossings
  std::optional<Face_grid> grid_;
  std::vector<Index> near_;              // the faces that may cross those around the face at hand
  std::size_t looks_ = 0;                // at faces that may be near others
  std::vector<Crossing> crossings_before_;     // of the faces around the face at hand
  std::vector<double> score_before_;     // by face; without crossings
  Visit_marks is_scored_;                // whether that is known
  int round_ = 0;
  bool leaves_bad_faces_ = false;        // after the last run
  Fault fault_ = Fault::angle;           // of the face at hand
  std::array<std::size_t, 4> trials_{};  // by fault; folds leave angles to mend
  std::size_t most_trials_ = 0;          // of each
  std::vector<char> given_up_;           // by face
  std::vector<char> in_vain_;            // by half-edge, a bit for each kind of operation
  Visit_marks marks_;
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_REPAIR_PASS_H
