// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_REPAIR_PASS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_REPAIR_PASS_H

#include <CGAL/Inter_angle_remeshing/internal/Remeshing_context.h>
#include <CGAL/Inter_angle_remeshing/internal/geometry/thin_angles.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/Mesh_snapshot.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/crossing_faces.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/mesh_regions.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/Angle_descent.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/Faults.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/folds.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/kept_places.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/place_on_surface.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/repair_operations.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/surface_walk.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
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
  using Operation = Repair_operation;

  // Rounds over the faces that are bad; in the first one only operations next to the face are tried.
  static constexpr int MAXIMUM_ROUNDS = 12;
  // Sweeps of descent over the vertices around an operation that is tried, and around so many of the best; where faces cross, for
  // there are few, around hardly any.
  static constexpr int FIRST_SWEEPS = 2, SWEEPS = 8;
  static constexpr std::size_t FINALISTS = 5, CROSSING_FINALISTS = 2;
  // The pass ends after so many trials for angles and as many for folds, and so many more of each for every bad face, but at most
  // one for so many faces of the input or of the mesh, what is more: a trial takes as long as ten faces of the run. Where faces cross,
  // after so many times as many; where the surface does, too, after no more.
  static constexpr std::size_t LEAST_TRIALS = 200, TRIALS_PER_BAD_FACE = 10, FACES_PER_TRIAL = 40, CROSSING_TRIALS = 6;
  // An operation stays if it takes away this part of what is bad around it.
  static constexpr double NOTICEABLE = 0.02;
  // One that at first makes it so much worse is not worth a sweep: an angle 53 degrees out of its band.
  static constexpr double HOPELESS = 32000;
  // To unfold a face the mesh may withdraw so many times as far.
  static constexpr double UNFOLDING = 2;
  // What an operation leaves is no farther from the surface, in target lengths, than this or than what was there: angles are not worth a
  // face across the hole of a ring.
  static constexpr double LONGEST_DISTANCE = 0.75;
  // Nor does one for angles or folds turn more of the area away from the surface, beyond rounding, where needles are held and there are very
  // thin faces around.
  static constexpr double ROUNDING = 1e-9;

public:
  Repairer(Remeshing_context& context, std::size_t input_faces)
    : context_(context), mesh_(context.mesh), input_faces_(input_faces), faults_(context), operations_(context), descent_(context)
  {}

  // Returns the number of operations. A further run looks at what has become bad since; what was given up stays so, and the
  // number of trials is that of both.
  template <class ConcurrencyTag>
  std::size_t run()
  {
    return mend([&]() {
      const Faults::Bad_faces bad = round_ == 0 ? faults_.find_angles_and_folds<ConcurrencyTag>()
                                                : faults_.find_angles_and_folds(std::move(suspects_));
      suspects_ = bad.faces;
      return bad;
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
    most_trials_ = 0;
    const std::size_t operations = mend([&]() { return faults_.find_crossings<ConcurrencyTag>(crossing, affordable_trials()); });
    if (round_ == MAXIMUM_ROUNDS) crossing = faults_.number_of_crossing_faces<ConcurrencyTag>();
    return operations;
  }

private:
  // Goes over the faces that `find()` names until they do not get better: what mends one may spoil another.
  template <class Find>
  std::size_t mend(const Find& find)
  {
    std::size_t operations = 0;
    double least = std::numeric_limits<double>::infinity();
    for (round_ = 0; round_ < MAXIMUM_ROUNDS; ++round_) {
      const Faults::Bad_faces bad = find();
      leaves_bad_faces_ = !bad.faces.empty();
      if (bad.faces.empty() || (round_ > 1 && !(bad.score < least))) break;
      least = (std::min)(least, bad.score);
      if (most_trials_ == 0) most_trials_ = (std::min)(LEAST_TRIALS + TRIALS_PER_BAD_FACE * bad.faces.size(), affordable_trials());
      const std::size_t done = mend_each(bad.faces);
      if (round_ > 0 && done == 0) break;
      operations += done;
    }
    return operations;
  }

  std::size_t mend_each(const std::vector<Index>& faces)
  {
    std::size_t operations = 0;
    const char level = round_ == 0 ? 1 : 2;
    for (const Index f : faces) {
      if (!mesh_.is_face(f) || given_up(f) >= level) continue;
      fault_ = faults_.fault_of(f);
      if (has_tried_enough() || faults_.has_looked_enough() || !faults_.is_bad(f)) continue;
      if (const Operation best = best_operation(f); best.kind != Operation::Kind::none) {
        commit(best);
        ++operations;
      } else
        given_up(f) = level;
    }
    return operations;
  }

  // At most so many for angles. More faces than these that cross others where the surface does are let be: it takes some thirty trials to
  // find one operation.
  std::size_t affordable_trials() const
  {
    return LEAST_TRIALS + (std::max)(input_faces_, mesh_.number_of_live_faces()) / FACES_PER_TRIAL;
  }
  std::size_t& trials() { return trials_[std::size_t(fault_)]; }
  bool has_tried_enough() { return trials() > (fault_ == Fault::crossing ? CROSSING_TRIALS * most_trials_ : most_trials_); }

  // 1 if no operation next to face f helps, 2 if none near it does.
  char& given_up(Index f)
  {
    if (std::size_t(f) >= given_up_.size()) given_up_.resize(mesh_.number_of_face_slots(), 0);
    return given_up_[f];
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

  // A few sweeps tell which operations are promising, many more which of these is the best.
  Operation best_operation(Index f)
  {
    faults_.start(f);
    std::vector<std::pair<double, Operation>> promising;
    for (const Operation& operation : operations_.candidates(f, fault_, round_ == 0)) {
      if (has_tried_enough() || is_in_vain(operation) || !operations_.is_allowed(operation, fault_)) continue;
      if (const double g = gain(operation, FIRST_SWEEPS); g > 0)
        promising.emplace_back(g, operation);
      else
        note_in_vain(operation);
    }
    const bool is_crossing = is_at_crossing(fault_);
    const std::size_t n = (std::min)(promising.size(), is_crossing ? CROSSING_FINALISTS : FINALISTS);
    const auto is_better = [](const auto& a, const auto& b) { return a.first > b.first; };
    std::stable_sort(promising.begin(), promising.end(), is_better);
    promising.resize(n);
    for (auto& p : promising) p.first = gain(p.second, SWEEPS, true);
    const auto best = std::min_element(promising.begin(), promising.end(), is_better);
    return best != promising.end() && best->first > 0 ? best->second : Operation();
  }

  // How much less is bad after the operation and so many sweeps; all is undone. For one that may stay, nothing where the mesh withdraws
  // from places, but for crossings, or strays from the surface.
  double gain(const Operation& operation, int sweeps, bool may_stay = false)
  {
    const std::vector<Index> around = ball(mesh_, ends_and_apexes(mesh_, operation.halfedge), 1, marks_);
    if (around.size() > LARGEST_REGION) return 0;
    ++trials();
    snapshot_.take(mesh_, around);
    const double before = faults_.score_before(snapshot_.faces());
    const std::vector<Index> moving = ball(mesh_, operations_.attempt(operation), 1, marks_);
    const std::vector<Index> faces = faces_around(mesh_, moving, marks_);
    if (!may_stay && fault_ == Fault::angle && faults_.score(faces, before + HOPELESS) >= before + HOPELESS) {
      snapshot_.restore(mesh_);
      return 0;
    }
    descent_.sweep(moving, sweeps);
    const double after = faults_.score(faces, before);
    const bool pays = before - after > NOTICEABLE * before &&
                      !(may_stay && !is_at_crossing(fault_) && leaves_places(around, faces));
    const Straying straying = pays && may_stay ? straying_of(faces) : Straying();
    snapshot_.restore(mesh_);
    return pays && !is_too_much(straying) ? before - after : 0;
  }

  // How far an operation has led off the surface: the largest distance of its faces, in target lengths, and twice the area of those that
  // turn away from it, where that counts.
  struct Straying
  {
    double distance = 0, turned_area = 0;
  };

  Straying straying_of(const std::vector<Index>& faces) const
  {
    if (!context_.projector.has_faces()) return {};
    const bool keeps_area = context_.holds_needles() && !is_at_crossing(fault_) && has_very_thin_face(faces);
    return {largest_distance(faces), keeps_area ? area_turned_away(faces) : 0};
  }

  // Whether that is more than for what is there now that the operation is undone. What parts faces that cross may turn them away.
  bool is_too_much(const Straying& straying) const
  {
    if (straying.distance > LONGEST_DISTANCE && straying.distance > largest_distance(snapshot_.faces())) return true;
    if (!(straying.turned_area > 0)) return false;
    const double before = area_turned_away(snapshot_.faces());
    return straying.turned_area > before + ROUNDING * (before + CGAL::square(context_.target_length));
  }

  // How far the centres and the middles of the edges of these faces are from the surface at most, in target lengths; if that is less than
  // LONGEST_DISTANCE, it may say more than it is.
  double largest_distance(const std::vector<Index>& faces) const
  {
    double result = 0;
    for (const Index f : faces) {
      if (!mesh_.is_face(f)) continue;
      const double length = context_.length_at(mesh_.face_record(f).vertex[0]), enough = CGAL::square(LONGEST_DISTANCE * length);
      for (int k = 0; k < 4; ++k) {
        const Vector3 p = point_on_face(mesh_, f, PLACES_ON_FACE[k]);
        result = (std::max)(result, std::sqrt(place_on_surface(context_, f, p, enough).squared_distance) / length);
      }
    }
    return result;
  }

  // Twice the area of the faces that turn away from the surface.
  double area_turned_away(const std::vector<Index>& faces) const
  {
    double result = 0;
    for (const Index f : faces)
      if (mesh_.is_face(f) && leaves_surface(context_, f)) result += length(mesh_.cross_product(f));
    return result;
  }

  bool has_very_thin_face(const std::vector<Index>& faces) const
  {
    return std::any_of(faces.begin(), faces.end(), [&](Index f) {
      if (!mesh_.is_face(f)) return false;
      const auto& v = mesh_.face_record(f).vertex;
      return squared_sine_of_smallest_angle(mesh_.position(v[0]), mesh_.position(v[1]), mesh_.position(v[2])) < VERY_THIN_SQUARED_SINE;
    });
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

  void commit(const Operation& operation)
  {
    const std::vector<Index> touched = operations_.perform(operation);
    descent_.sweep(ball(mesh_, touched, 1, marks_), SWEEPS);
    const std::vector<Index> around = ball(mesh_, touched, 2, marks_);
    descent_.sweep(around, SWEEPS);
    for (const Index g : faces_around(mesh_, around, marks_)) forget(g);
    if (is_at_crossing(fault_)) return;                // then all faces are looked at in each round
    for (const Index g : faces_around(mesh_, ball(mesh_, around, 1, marks_), marks_)) suspects_.push_back(g);
  }

  Remeshing_context& context_;
  Remeshing_mesh& mesh_;
  std::size_t input_faces_;
  Faults faults_;
  Repair_operations operations_;
  Angle_descent descent_;
  Mesh_snapshot snapshot_;
  int round_ = 0;
  bool leaves_bad_faces_ = false;        // after the last run
  Fault fault_ = Fault::angle;           // of the face at hand
  std::array<std::size_t, NUMBER_OF_FAULTS> trials_{};  // by fault; folds leave angles to mend
  std::size_t most_trials_ = 0;          // of each
  std::vector<Index> suspects_;          // faces that are bad, or may have become so
  std::vector<char> given_up_;           // by face
  std::vector<char> in_vain_;            // by half-edge, a bit for each kind of operation
  Visit_marks marks_;
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_REPAIR_PASS_H
