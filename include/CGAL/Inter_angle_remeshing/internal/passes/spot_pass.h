// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_SPOT_PASS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_SPOT_PASS_H

#include <CGAL/Inter_angle_remeshing/Remeshing_report.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/mesh_regions.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/angle_energy.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/collapse_pass.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/flip_pass.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/folds.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/relax_pass.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/split_pass.h>

#include <algorithm>
#include <utility>
#include <vector>

// Iterates on a few spots alone: where a coarse level did not resolve the surface, at a tip or between two sheets that are
// close together, faces of the finer one are stretched, crushed or folded, and need what the direct loop does to all of them.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// Whether the angles of face f are out of the band, or it is folded over. Beside a curve the surface looks several ways, and
// angles are what the curve leaves.
inline bool is_poor_face(const Remeshing_context& context, Remeshing_mesh::Index f, const Angle_band& band)
{
  const Remeshing_mesh& mesh = context.mesh;
  const auto& v = mesh.face_record(f).vertex;
  if (v[0] < 0 || mesh.touches_curve(f)) return false;
  return !band.holds(mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2])) || fold_violation(context, f) > 0;
}

// How many edges away from what was poor at first the vertices of a spot lie.
constexpr int SPOT_REACH = 6;
// On a level, where more than this part of the vertices belongs to spots, they are no spots: the mesh is one that needs the sweeps of all.
constexpr double LARGEST_SPOTS = 0.02;

template <class ConcurrencyTag>
class Spot_iteration
{
  using Index = Remeshing_mesh::Index;

  // A face with an angle out of this band, in degrees, is more than sweeps and the polish can mend.
  static constexpr double LOWER_ANGLE = 30, UPPER_ANGLE = 105;
  static constexpr int ROUNDS = 12;
  // So many rounds without fewer poor faces than ever before are the last ones.
  static constexpr int PATIENCE = 4;
  // Around given vertices, so many: as many as there are iterations by default.
  static constexpr int ROUNDS_AROUND = 10;
  static constexpr unsigned SWEEPS = 5;

public:
  Spot_iteration(Remeshing_context& context, Relaxation& relaxation)
    : context_(context), mesh_(context.mesh), relaxation_(relaxation), band_(LOWER_ANGLE, UPPER_ANGLE)
  {}

  // Whether no poor face is left.
  bool is_done() const { return seeds_.empty(); }

  // Returns the number of vertices in the spots, if these are at most that part of all.
  std::size_t run(double curve_tolerance, Remeshing_report& report, double largest_share)
  {
    scan_into<ConcurrencyTag>(seeds_, mesh_.number_of_face_slots(), [&](std::size_t f, std::vector<Index>& found) {
      const auto& v = mesh_.face_record(Index(f)).vertex;
      if (is_poor(Index(f))) found.insert(found.end(), v, v + 3);
    });
    std::size_t count = 0;
    std::size_t fewest = seeds_.size();
    int stalled = 0;
    for (int round = 0; round < ROUNDS && !seeds_.empty() && stalled < PATIENCE; ++round) {
      find_region();
      if (double(region_.movable) > largest_share * double(mesh_.number_of_live_vertices())) break;
      count = (std::max)(count, region_.movable);
      iterate(curve_tolerance, report);
      find_seeds();
      stalled = seeds_.size() < fewest ? 0 : stalled + 1;
      fewest = (std::min)(fewest, seeds_.size());
    }
    return count;
  }

  // Around these vertices, whatever their faces are. Returns the number of vertices in the spots.
  std::size_t run_around(std::vector<Index> vertices, double curve_tolerance, Remeshing_report& report)
  {
    seeds_ = std::move(vertices);
    for (int round = 0; round < ROUNDS_AROUND; ++round) {
      find_region();
      iterate(curve_tolerance, report);
    }
    return region_.movable;
  }

private:
  bool is_poor(Index f) const { return is_poor_face(context_, f, band_); }

  // The vertices within reach of the seeds, and those around them.
  void find_region()
  {
    is_in_region_.resize(mesh_.number_of_vertex_slots(), 0);
    std::vector<Index>& found = region_.vertices;
    for (const Index v : found) is_in_region_[v] = 0;
    found.clear();
    const auto add = [&](Index v) {
      if (is_in_region_[v]) return;
      is_in_region_[v] = 1;
      found.push_back(v);
    };
    for (const Index v : seeds_)
      if (mesh_.is_vertex(v)) add(v);
    std::size_t begin = 0;
    for (int ring = 0; ring <= SPOT_REACH; ++ring) {
      const std::size_t end = found.size();
      region_.movable = end;
      for (; begin < end; ++begin) mesh_.for_each_neighbor(found[begin], add);
    }
  }

  // On the region that was found.
  void iterate(double curve_tolerance, Remeshing_report& report)
  {
    split_and_collapse(report);
    keep_seeds();
    find_region();
    flip(report);
    find_region();               // flips change who is near
    relaxation_.run<CGAL::Sequential_tag>(mesh_, context_.projector, SWEEPS, Pull_back::after_last_sweep, curve_tolerance, &region_);
  }

  void split_and_collapse(Remeshing_report& report)
  {
    std::vector<Index> long_edges, short_edges;
    for (std::size_t i = 0; i < region_.movable; ++i)
      mesh_.for_each_around(region_.vertices[i], [&](Index h) {
        if (!mesh_.is_border(h) && mesh_.origin(h) > mesh_.target(h)) return;     // met from its other end
        const double l = mesh_.squared_edge_length(h);
        if (l > context_.squared_length_limit(mesh_.origin(h), mesh_.target(h))) long_edges.push_back(h);
        if (l < context_.squared_shortness_limit(mesh_.origin(h), mesh_.target(h))) short_edges.push_back(h);
      });
    report.splits += split_pass<CGAL::Sequential_tag>(context_, long_edges, short_edges);
    report.collapses += collapse_pass<CGAL::Sequential_tag>(context_, short_edges);
  }

  // Collapses may have taken all seeds away; then what is left of the region is looked at.
  void keep_seeds()
  {
    const auto is_live = [&](Index v) { return mesh_.is_vertex(v); };
    if (std::any_of(seeds_.begin(), seeds_.end(), is_live)) return;
    const auto begin = region_.vertices.begin();
    seeds_.assign(begin, begin + std::ptrdiff_t(region_.movable));
  }

  void flip(Remeshing_report& report)
  {
    std::vector<Index> candidates;
    for (std::size_t i = 0; i < region_.movable; ++i) find_paying_flips(context_, region_.vertices[i], candidates);
    report.flips += flip_pass<CGAL::Sequential_tag>(context_, candidates);
  }

  void find_seeds()
  {
    seeds_.clear();
    for (std::size_t i = 0; i < region_.movable; ++i) {
      const Index v = region_.vertices[i];
      bool has_poor_face = false;
      mesh_.for_each_around(v, [&](Index h) { has_poor_face = has_poor_face || is_poor(mesh_.face(h)); });
      if (has_poor_face) seeds_.push_back(v);
    }
  }

  Remeshing_context& context_;
  Remeshing_mesh& mesh_;
  Relaxation& relaxation_;
  Angle_band band_;
  std::vector<Index> seeds_;
  Sweep_data::Region region_;
  std::vector<char> is_in_region_;
};

// Whether a needle is left with an edge that is much shorter than the target length, away from curves: the last iteration has come before
// a heap of vertices, as at a pole or where a scanner saw the same thing many times, was cleared away.
template <class ConcurrencyTag>
bool has_heaps(const Remeshing_context& context)
{
  using Index = Remeshing_mesh::Index;
  constexpr double SHORT = 0.125, NEEDLE_ANGLE = 25;      // of the shortest edge that is not collapsed; in degrees
  const Remeshing_mesh& mesh = context.mesh;
  const Angle_band band(NEEDLE_ANGLE, 180);
  std::vector<Index> found;
  scan_into<ConcurrencyTag>(found, mesh.number_of_face_slots(), [&](std::size_t f, std::vector<Index>& out) {
    const auto& v = mesh.face_record(Index(f)).vertex;
    if (v[0] < 0 || mesh.touches_curve(Index(f)) || band.holds(mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2]))) return;
    for (Index h = Index(4 * f); h < Index(4 * f + 3); ++h)
      if (mesh.squared_edge_length(h) < SHORT * SHORT * context.squared_shortness_limit(mesh.origin(h), mesh.target(h)))
        out.push_back(h);
  });
  return !found.empty();
}

// Whether a protected edge is near: faces beside one that is many times as long as they are wide leave what such an edge forces.
inline bool is_near_protected_edge(const Remeshing_mesh& mesh, Remeshing_mesh::Index f, Visit_marks& marks)
{
  const auto& v = mesh.face_record(f).vertex;
  const std::vector<Remeshing_mesh::Index> around = faces_around(mesh, ball(mesh, {v[0], v[1], v[2]}, SPOT_REACH, marks), marks);
  return std::any_of(around.begin(), around.end(), [&](Remeshing_mesh::Index g) { return mesh.has_protected_edge(g); });
}

// Whether more faces are poor than the direct way leaves, which is one in some hundred thousand; those near protected edges apart.
template <class ConcurrencyTag>
bool has_poor_faces(const Remeshing_context& context)
{
  using Index = Remeshing_mesh::Index;
  constexpr double LOWER_ANGLE = 18, UPPER_ANGLE = 120, LARGEST_SHARE = 1e-5;
  const Angle_band band(LOWER_ANGLE, UPPER_ANGLE);
  std::vector<Index> found;
  scan_into<ConcurrencyTag>(found, context.mesh.number_of_face_slots(), [&](std::size_t f, std::vector<Index>& out) {
    if (is_poor_face(context, Index(f), band)) out.push_back(Index(f));
  });
  Visit_marks marks;
  const auto is_forced = [&](Index f) { return is_near_protected_edge(context.mesh, f, marks); };
  found.erase(std::remove_if(found.begin(), found.end(), is_forced), found.end());
  return double(found.size()) > LARGEST_SHARE * double(context.mesh.number_of_live_faces());
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_SPOT_PASS_H
