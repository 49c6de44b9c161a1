// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_REPAIR_OPERATIONS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_REPAIR_OPERATIONS_H

#include <CGAL/Inter_angle_remeshing/internal/Remeshing_context.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/mesh_regions.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/Faults.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/collapse_pass.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/flip_pass.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/split_pass.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

struct Repair_operation
{
  enum class Kind { none, flip, collapse, split, place };    // the last one puts a vertex onto the surface
  Kind kind = Kind::none;
  Remeshing_mesh::Index halfedge = -1;
};

// Operations at vertices with hundreds of edges would take too long to try.
constexpr std::size_t LARGEST_REGION = 100;

// What the repair may do near a face, wider in what it permits than the passes of the iterations are.
class Repair_operations
{
  using Index = Remeshing_mesh::Index;
  using Kind = Repair_operation::Kind;

  // Vertices whose edges are looked at: at first those of the face alone.
  static constexpr std::size_t VERTICES_AT_FIRST = 3, VERTICES_LATER = 12;
  // By how much a flip may raise the sum of the squared valence deviations; where faces cross, and the surface does not, by any number.
  static constexpr int GAIN_AT_FIRST = 4, GAIN_LATER = 8;
  // Squared lengths, in those of the target, up to which edges are collapsed and from which they are split here; much shorter ones where
  // faces cross, and at curves, for thin strips between these.
  static constexpr double COLLAPSED = 1.1, SPLIT = 0.8, SPLIT_AT_CROSSING = 0.1, SPLIT_AT_CURVE = 0.04;
  // What a collapse may do here: the square of the longest new edge, and how far from the new surface the vertex may lie.
  static constexpr double LONGEST = 3, TOLERANCE = 0.3;

public:
  explicit Repair_operations(Remeshing_context& context)
    : context_(context), mesh_(context.mesh),
      limits_{LONGEST * CGAL::square(context.target_length), CGAL::square(TOLERANCE * context.target_length), MAXIMUM_MERGED_VALENCE}
  {}

  // What may be tried near face f.
  std::vector<Repair_operation> candidates(Index f, Fault fault, bool is_first_round)
  {
    const auto& corner = mesh_.face_record(f).vertex;
    std::vector<Index> centres = ball(mesh_, {corner[0], corner[1], corner[2]}, 1, marks_);
    centres.resize((std::min)(centres.size(), is_first_round ? VERTICES_AT_FIRST : VERTICES_LATER));
    const auto is_hub = [&](Index v) { return std::size_t(mesh_.valence(v)) > LARGEST_REGION; };
    centres.erase(std::remove_if(centres.begin(), centres.end(), is_hub), centres.end());
    std::vector<Repair_operation> result;
    if (is_at_crossing(fault) && context_.projector.has_faces())
      for (const Index v : centres) if (mesh_.is_free(v)) result.push_back({Kind::place, mesh_.first(v)});
    const double shortest_of_all = is_at_crossing(fault) ? SPLIT_AT_CROSSING : SPLIT;
    const int gain = fault == Fault::crossing ? (std::numeric_limits<int>::max)() : is_first_round ? GAIN_AT_FIRST : GAIN_LATER;
    for (const Index h : edges_of_stars(centres)) {
      const double unit = CGAL::square(context_.length_at(mesh_.origin(h), mesh_.target(h)));
      const double l = mesh_.squared_edge_length(h);
      const bool is_at_curve = mesh_.is_on_curve(mesh_.origin(h)) || mesh_.is_on_curve(mesh_.target(h));
      const double shortest = mesh_.is_on_curve_edge(h) && !context_.may_collapse_along_curve(h) ? SPLIT
                              : is_at_curve ? SPLIT_AT_CURVE : shortest_of_all;
      if (!mesh_.is_on_curve_edge(h) && flip_gain(mesh_, h) <= gain) result.push_back({Kind::flip, h});
      if (l < COLLAPSED * unit) {
        result.push_back({Kind::collapse, h});
        result.push_back({Kind::collapse, mesh_.opposite(h)});
      }
      if (l > shortest * unit) result.push_back({Kind::split, h});
    }
    return result;
  }

  // What becomes of angles, the trial tells.
  bool is_allowed(const Repair_operation& operation, Fault fault) const
  {
    const Index h = operation.halfedge;
    switch (operation.kind) {
    case Kind::flip:
      return mesh_.is_flip_legal(h) && context_.permits_flip(h, false) &&
             (fault != Fault::angle || (keeps_normals_by_flip(mesh_, h) && !makes_fold_by_flip(context_, h)));
    case Kind::collapse:
      if (fault == Fault::fold && mesh_.is_free(mesh_.source(h))) return mesh_.is_collapse_legal(h) && context_.permits_collapse(h);
      return mesh_.valence(mesh_.source(h)) + mesh_.valence(mesh_.source(mesh_.opposite(h))) - 4 <= limits_.valence &&
             is_collapse_allowed(context_, h, limits_);
    case Kind::split: return mesh_.is_split_legal(h) && context_.permits_split(h);
    case Kind::place: return true;
    default: return false;
    }
  }

  // Does it, to be undone. Returns the vertices that it touched.
  std::vector<Index> attempt(const Repair_operation& operation) { return apply(operation, false); }
  // Does it for good: the visitor is told.
  std::vector<Index> perform(const Repair_operation& operation) { return apply(operation, true); }

private:
  // The edges of the faces around these vertices, each once.
  std::vector<Index> edges_of_stars(const std::vector<Index>& centres) const
  {
    std::vector<Index> edges;
    for (const Index v : centres)
      mesh_.for_each_around(v, [&](Index h) {
        for (const Index k : {h, mesh_.prev(h)}) {
          const Index o = mesh_.opposite(k);
          edges.push_back(o >= 0 && o < k ? o : k);
        }
      });
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
  }

  std::vector<Index> apply(const Repair_operation& operation, bool is_announced)
  {
    const Index h = operation.halfedge;
    std::vector<Index> touched = ends_and_apexes(mesh_, h);
    if (operation.kind == Kind::flip) {
      apply_flip(h, is_announced);
    } else if (operation.kind == Kind::collapse) {
      touched.erase(std::find(touched.begin(), touched.end(), mesh_.source(h)));
      if (is_announced) collapse(context_, h); else mesh_.collapse(h);
    } else if (operation.kind == Kind::place) {
      const Index v = mesh_.origin(h);
      if (const Vector3 q = context_.projector(mesh_.position(v), mesh_.hint(v)); context_.permits_move(v, q)) mesh_.position(v) = q;
    } else {
      const Split_vertex made = is_announced ? split(context_, h) : split_edge(context_, h);
      project_split_vertices<CGAL::Sequential_tag>(context_, {made});
      flip_across(made.vertex, touched, is_announced);
      touched.push_back(made.vertex);
    }
    return touched;
  }

  // Flips edges opposite to v, and those behind, as long as the smallest angle of the two faces grows; edges that end at `touched`, for
  // no others can be undone. In a fan of needles, as they fill the rim of a bore, a vertex is of use only where it is joined to all.
  void flip_across(Index v, const std::vector<Index>& touched, bool is_announced)
  {
    const auto is_touched = [&](Index u) { return std::find(touched.begin(), touched.end(), u) != touched.end(); };
    const auto find_one = [&]() {
      Index found = -1;
      mesh_.for_each_around(v, [&](Index k) {
        const Index h = mesh_.next(k);
        if (found < 0 && (is_touched(mesh_.origin(h)) || is_touched(mesh_.target(h))) && is_better_flipped(h)) found = h;
      });
      return found;
    };
    for (Index h = find_one(); h >= 0; h = find_one()) apply_flip(h, is_announced);
  }

  bool is_better_flipped(Index h) const
  {
    if (mesh_.is_on_curve_edge(h) || !mesh_.is_flip_legal(h) || !keeps_normals_by_flip(mesh_, h) || !context_.permits_flip(h, false))
      return false;
    const Smallest_angle_by_flip angle = smallest_angle_by_flip(mesh_, h);
    return angle.after > angle.before;
  }

  void apply_flip(Index h, bool is_announced)
  {
    if (is_announced) flip(context_, h); else mesh_.flip(h);
  }

  Remeshing_context& context_;
  Remeshing_mesh& mesh_;
  Collapse_limits limits_;
  Visit_marks marks_;
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_REPAIR_OPERATIONS_H
