// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_FAULTS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_FAULTS_H

#include <CGAL/Inter_angle_remeshing/internal/Remeshing_context.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/Face_grid.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/Surroundings.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/crossing_faces.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/crossings.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/mesh_regions.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/parallel_blocks.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/angle_bands.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/folds.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/Surface_crossings.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// What the repair mends: angles out of their bands and folds, or faces that cross others, there or elsewhere than the surface does.
enum class Fault { angle, fold, crossing, inherited_crossing };
constexpr std::size_t NUMBER_OF_FAULTS = 4;

inline bool is_at_crossing(Fault fault) { return fault == Fault::crossing || fault == Fault::inherited_crossing; }

// Finds the faces that have faults, and tells how bad these are.
class Faults
{
  using Index = Remeshing_mesh::Index;

  static constexpr double TOUCH = 0.05;      // degrees that every bad face counts more
  // One face that is far out of its band is worse than many that are not; but no angle is worth a crossing, beside which the square of a
  // violation counts no more than this.
  static constexpr double CUBED = 0.2, LARGEST_SQUARE = 900;
  // Nearly flat faces, which cross nothing, count so much more there: those so far out of their band, with the default one those with an
  // angle of 160 to 175 degrees and more.
  static constexpr double FLAT_VIOLATION = 75, FLAT = 1e5;
  // What two faces that cross each other count, and what the length of the segment in which they do, in target lengths; less where
  // the surface crosses itself: angles are not given up for what cannot be parted.
  static constexpr double CROSSING = 1000, CROSSING_LENGTH = 6000, INHERITED_CROSSING = 100;
  // Sheets that lie on each other all over, where more faces than so many, and most of all, cross others, are not parted by the few
  // operations that there is time for; the angles would pay for them.
  static constexpr std::size_t HOPELESS_CROSSINGS = 200;
  // What an operation near a face changes lies within so many rings of it.
  static constexpr int REACH = 4;

public:
  struct Bad_faces
  {
    std::vector<Index> faces;            // what is to be mended first comes first
    double score = 0;
  };

  explicit Faults(const Remeshing_context& context)
    : context_(context), mesh_(context.mesh), around_(context.mesh, context.surroundings), bands_(context.recipe), leaving_(context)
  {}

  // Faces with angles out of their bands, and folds; the worst ones first.
  template <class ConcurrencyTag>
  Bad_faces find_angles_and_folds()
  {
    std::vector<Index> suspects;
    scan_into<ConcurrencyTag>(suspects, mesh_.number_of_face_slots(), [&](std::size_t f, std::vector<Index>& found) {
      if (mesh_.is_face(Index(f))) append_suspects(Index(f), found);
    });
    return find_angles_and_folds(std::move(suspects));
  }
  // The same among these faces.
  Bad_faces find_angles_and_folds(std::vector<Index> suspects)
  {
    finds_crossings_ = false;
    std::sort(suspects.begin(), suspects.end());
    suspects.erase(std::unique(suspects.begin(), suspects.end()), suspects.end());
    std::vector<std::pair<double, Index>> bad;
    for (const Index f : suspects)
      if (mesh_.is_face(f))
        if (const double v = violation(f); v > 0) bad.emplace_back(-v, f);
    std::sort(bad.begin(), bad.end());
    Bad_faces result;
    for (const auto& [minus_violation, f] : bad) {
      result.faces.push_back(f);
      result.score += score_of_violation(-minus_violation);
    }
    return result;
  }

  // Faces that cross others; their number is `crossing`, for those where the surface crosses itself are only mended where that is easy,
  // after the others, and not at all where they lie on each other, or are more than `most_inherited`.
  template <class ConcurrencyTag>
  Bad_faces find_crossings(std::size_t& crossing, std::size_t most_inherited)
  {
    finds_crossings_ = true;
    const std::vector<std::pair<Index, Index>> pairs = crossing_pairs<ConcurrencyTag>();
    Bad_faces result;
    crossing = faces_of_mesh(pairs).size();
    if (pairs.empty()) return result;
    if (crossing > HOPELESS_CROSSINGS && 2 * crossing > mesh_.number_of_live_faces()) return {};
    if (!crossings_of_surface_) crossings_of_surface_ = Surface_crossings::find<ConcurrencyTag>(context_);
    forget_crossings_of_surface();
    std::vector<std::pair<Index, Index>> mended;
    std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(mended),
                 [&](const auto& pair) { return !lie_on_each_other(pair.first, pair.second); });
    result.faces = faces_of_mesh(mended);
    for (const auto& [f, g] : mended) result.score += score_of_crossing(f, g);
    const auto inherited = std::stable_partition(result.faces.begin(), result.faces.end(), [&](Index f) { return !is_inherited(f); });
    const bool is_easy = std::size_t(result.faces.end() - inherited) <= most_inherited &&
                         crossings_of_surface_->are_small(context_.target_length);
    if (is_easy) sort_by_crossing_lengths(inherited, result.faces.end(), pairs);
    else result.faces.erase(inherited, result.faces.end());
    grid_.emplace(mesh_, context_.largest_length());
    return result;
  }

  // Whether faces cross others where the surface does not cross itself.
  template <class ConcurrencyTag>
  bool has_new_crossings() const
  {
    const std::vector<Index> faces = faces_of_mesh(crossing_pairs<ConcurrencyTag>());
    if (faces.empty()) return false;
    const Surface_crossings of_surface = Surface_crossings::find<ConcurrencyTag>(context_);
    return std::any_of(faces.begin(), faces.end(), [&](Index f) { return !of_surface.are_near(context_, f); });
  }

  // The number of faces that cross others.
  template <class ConcurrencyTag>
  std::size_t number_of_crossing_faces() const { return faces_of_mesh(crossing_pairs<ConcurrencyTag>()).size(); }

  // The fault of face f, if it has one of those that were looked for last.
  Fault fault_of(Index f) const
  {
    if (finds_crossings_) return is_inherited(f) ? Fault::inherited_crossing : Fault::crossing;
    return fold_violation(context_, f) > 0 ? Fault::fold : Fault::angle;
  }
  bool is_bad(Index f)
  {
    if (!finds_crossings_) return violation(f) > 0;
    return are_crossed(mesh_, *grid_, {f}, marks_, looks_) || around_.crosses(f);
  }

  bool has_looked_enough() const { return are_enough_looks(mesh_, looks_); }

  // Nothing has been tried for face f yet.
  void start(Index f)
  {
    is_scored_.start(mesh_.number_of_face_slots());
    score_before_.resize((std::max)(score_before_.size(), mesh_.number_of_face_slots()));
    crossings_before_.clear();
    if (!finds_crossings_) return;
    forget_crossings_of_surface();
    const auto& corner = mesh_.face_record(f).vertex;
    const std::vector<Index> within_reach = faces_around(mesh_, ball(mesh_, {corner[0], corner[1], corner[2]}, REACH, marks_), marks_);
    near_ = faces_near(mesh_, *grid_, within_reach, marks_, looks_);
    std::sort(near_.begin(), near_.end());
    near_outside_ = around_.faces_near(within_reach);
    for_each_crossing_near(within_reach, [&](Index g, Index other) {
      crossings_before_.push_back({g, other, score_of_crossing(g, other)});
      return true;
    });
  }

  // How bad these faces, in order, were before anything was tried since the last start().
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

  // How bad they are; from `enough` on, perhaps a part of that.
  double score(const std::vector<Index>& faces, double enough)
  {
    double sum = 0;
    leaving_.start();
    if (finds_crossings_)
      for_each_crossing_near(faces, [&](Index f, Index g) {
        sum += score_of_crossing(f, g);
        return sum < enough;
      });
    for (auto f = faces.begin(); f != faces.end() && sum < enough; ++f)
      if (mesh_.is_face(*f)) sum += score_of_violation(internal::violation(mesh_, bands_, *f, leaving_));
    return sum;
  }

private:
  // The pairs of faces that cross each other, those outside of the range with negative names.
  template <class ConcurrencyTag>
  std::vector<std::pair<Index, Index>> crossing_pairs() const
  {
    std::vector<std::pair<Index, Index>> pairs = crossing_faces<ConcurrencyTag>(mesh_);
    const std::vector<std::pair<Index, Index>> outside = around_.crossings();
    pairs.insert(pairs.end(), outside.begin(), outside.end());
    return pairs;
  }
  static std::vector<Index> faces_of_mesh(const std::vector<std::pair<Index, Index>>& pairs)
  {
    std::vector<Index> faces = faces_of(pairs);
    faces.erase(faces.begin(), std::lower_bound(faces.begin(), faces.end(), 0));
    return faces;
  }

  struct Crossing
  {
    Index face, other;
    double score;
  };

  // Face f if it is out of its band; and it and those after it with which it makes more than a right angle, for one may be folded over
  // the other. Each edge is looked at once.
  void append_suspects(Index f, std::vector<Index>& found) const
  {
    if (!holds_band(mesh_, bands_, f)) found.push_back(f);
    const Vector3 normal = mesh_.cross_product(f);
    for (Index h = 4 * f; h < 4 * f + 3; ++h) {
      const Index o = mesh_.opposite(h);
      if (o < h || mesh_.is_on_curve_edge(h) || dot(normal, mesh_.cross_product(o >> 2)) >= 0) continue;
      found.push_back(f);
      found.push_back(o >> 2);
    }
  }

  double violation(Index f) const { return internal::violation(context_, bands_, f); }
  double score_of_violation(double v) const
  {
    if (!(v > 0)) return 0;
    if (finds_crossings_) return TOUCH + v + (std::min)(v * v, LARGEST_SQUARE) + (v > FLAT_VIOLATION ? FLAT : 0.);
    return TOUCH + v + v * v + CUBED * v * v * v;
  }

  bool is_inherited(Index f) const
  {
    if (f < 0) return false;
    const auto& v = mesh_.face_record(f).vertex;
    return std::any_of(v, v + 3, [&](Index u) { return is_near_crossing_of_surface(u); });
  }
  // It does not change while one face is at hand.
  bool is_near_crossing_of_surface(Index v) const
  {
    if (std::size_t(v) >= is_near_crossing_.size()) return crossings_of_surface_->are_near_vertex(context_, v);
    if (is_looked_up_.visit(std::size_t(v))) is_near_crossing_[v] = crossings_of_surface_->are_near_vertex(context_, v);
    return is_near_crossing_[v] != 0;
  }
  void forget_crossings_of_surface()
  {
    is_looked_up_.start(mesh_.number_of_vertex_slots());
    is_near_crossing_.resize(mesh_.number_of_vertex_slots());
  }
  // Whether two faces where the surface crosses itself cross each other, or touch, in one plane, as parts that are put together do.
  bool lie_on_each_other(Index f, Index g) const
  {
    constexpr double ONE_PLANE = 0.9998;             // 1.1 degrees
    if (f < 0 || g < 0) return false;
    const Vector3 a = mesh_.cross_product(f), b = mesh_.cross_product(g);
    return is_cosine_at_least(a, dot(a, b) < 0 ? -1. * b : b, ONE_PLANE) && is_inherited(f) && is_inherited(g);
  }
  double crossing_length_in_targets(Index f, Index g) const
  {
    return crossing_length(around_, f, g) / context_.length_at(mesh_.face_record(f).vertex[0]);
  }
  double score_of_crossing(Index f, Index g) const
  {
    if (is_inherited(f) && is_inherited(g)) return INHERITED_CROSSING;
    return CROSSING + CROSSING_LENGTH * crossing_length_in_targets(f, g);
  }

  // Those first that cross others in the shortest segments.
  void sort_by_crossing_lengths(std::vector<Index>::iterator begin, std::vector<Index>::iterator end,
                                const std::vector<std::pair<Index, Index>>& pairs) const
  {
    std::vector<double> longest(mesh_.number_of_face_slots(), 0);
    for (const auto& [f, g] : pairs) {
      const double l = crossing_length_in_targets(f, g);
      for (const Index x : {f, g})
        if (x >= 0) longest[x] = (std::max)(longest[x], l);
    }
    std::stable_sort(begin, end, [&](Index f, Index g) { return longest[f] < longest[g]; });
  }

  // Calls `function(face, other)` for the pairs of faces that cross each other, of which one is among these, until it returns false.
  template <class Function>
  void for_each_crossing_near(std::vector<Index> faces, const Function& function) const
  {
    const auto is_dead = [&](Index f) { return !mesh_.is_face(f); };
    faces.erase(std::remove_if(faces.begin(), faces.end(), is_dead), faces.end());
    std::vector<Index> others;
    std::set_union(near_.begin(), near_.end(), faces.begin(), faces.end(), std::back_inserter(others));
    others.erase(std::remove_if(others.begin(), others.end(), is_dead), others.end());
    others.insert(others.end(), near_outside_.begin(), near_outside_.end());
    for_each_crossing(around_, faces, others, [&](Index f, Index g) { return lie_on_each_other(f, g); }, function);
  }

  const Remeshing_context& context_;
  const Remeshing_mesh& mesh_;
  Mesh_in_surroundings around_;
  Angle_bands bands_;
  Leaving_faces leaving_;
  bool finds_crossings_ = false;
  std::optional<Surface_crossings> crossings_of_surface_;
  mutable std::vector<char> is_near_crossing_; // by vertex: whether the surface crosses itself there, once that was looked up
  mutable Visit_marks is_looked_up_;
  std::optional<Face_grid> grid_;              // where faces may cross others
  std::size_t looks_ = 0;                      // at faces that may be near others
  std::vector<Index> near_, near_outside_;     // the faces that may cross those around the face at hand, of the mesh and outside
  std::vector<Crossing> crossings_before_;     // of the faces around the face at hand
  std::vector<double> score_before_;           // by face; without crossings
  Visit_marks is_scored_;                      // whether that is known
  Visit_marks marks_;
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_FAULTS_H
