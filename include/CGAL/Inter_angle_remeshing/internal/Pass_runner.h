// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASS_RUNNER_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASS_RUNNER_H

#include <CGAL/Inter_angle_remeshing/Remeshing_report.h>
#include <CGAL/Inter_angle_remeshing/internal/Remeshing_context.h>
#include <CGAL/Inter_angle_remeshing/internal/Run_clock.h>
#include <CGAL/Inter_angle_remeshing/internal/Schedule.h>
#include <CGAL/Inter_angle_remeshing/internal/curves/curve_edges.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/angle_summary.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/edge_lengths.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/regular_valence.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/collapse_pass.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/distance_pass.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/face_count_pass.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/field_detail_pass.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/fit_pass.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/flip_pass.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/glide_pass.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/low_valence_pass.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/narrow_strip_pass.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/polish_pass.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/projection_pass.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/relax_pass.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/release_features.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/repair_pass.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/split_pass.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/spot_pass.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/subdivision_pass.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// Runs passes with what the recipe has for them, each where it was asked for and unless the run was cancelled; counts in the report
// what they do, and tells the visitor and the callback.
template <class ConcurrencyTag>
class Pass_runner
{
  using Index = Remeshing_mesh::Index;

  // The iteration from which on short edges of curves are there to stay.
  static constexpr unsigned SETTLED_CURVES = 5;
  // And that from which on rings of short edges are necks: before, most are those of the input.
  static constexpr unsigned SETTLED_NECKS = 2;

public:
  Pass_runner(Remeshing_context& context, const Schedule& schedule, Run_clock& clock, Remeshing_report& report)
    : context_(context), mesh_(context.mesh), recipe_(context.recipe), schedule_(schedule), clock_(clock), report_(report),
      relaxation_(context.recipe, context.curves, context.grading, context.move_rule, context.moves_spikes ? context.noise : 0.,
                  has_long_protected_edge(context.mesh, [&](Index u, Index v) { return context.length_at(u, v); }),
                  context.keeps_long_edges())
  {}

  bool goes_on() const { return report_.ending == Remeshing_report::Ending::completed; }

  // More than one round pays only where splits and collapses no longer stir up the valences.
  unsigned flip_rounds() const { return clock_.is_late() ? recipe_.flip_rounds : (std::min)(1u, recipe_.flip_rounds); }

  // Short edges that curves could do without are those of the input, at first: they tell nothing about details.
  void measure_grading()
  {
    std::vector<Neck_vertex> necks;
    // A coarser level resolves its input.
    if (context_.may_have_necks && clock_.levels() == 0 && clock_.iterations() >= SETTLED_NECKS)
      necks = find_necks<ConcurrencyTag>(mesh_, context_.target_length);
    context_.has_necks = context_.has_necks || !necks.empty();
    if (!context_.is_graded()) return;
    context_.grading.read<ConcurrencyTag>(mesh_, context_.sizing, context_.locator, context_.target_length);
    context_.grading.sink_at_necks(mesh_, necks, context_.target_length, recipe_.grading);
    if (!(context_.grading_rate > 0)) return;
    const bool are_curves_settled = clock_.iterations() >= SETTLED_CURVES || context_.collapse_rule.is_never();
    context_.grading.sink_at_curves(mesh_, context_.target_length, context_.grading_rate, [&](Index v) {
      return are_curves_settled || !has_surplus_curve_edge(context_, v); });
  }

  // Splits, collapses, and in the last iterations what the wanted number of faces takes. The limits of the edge lengths are those of the
  // recipe, or wider by a factor. Returns the number of splits.
  std::size_t split_and_collapse(double widening = 1)
  {
    if (!goes_on()) return 0;
    measure_grading();
    Edges_out_of_limits edges;
    const std::size_t splits = run(Pass::split, [&]() {
      edges = edges_out_of_limits(widening);
      return split_pass<ConcurrencyTag>(context_, edges.too_long, edges.too_short);
    });
    report_.splits += splits;
    if (!context_.collapse_rule.is_never())
      report_.collapses += run(Pass::collapse, [&]() { return collapse_pass<ConcurrencyTag>(context_, edges.too_short); });
    if (clock_.is_late() && !(context_.grading_rate > 0 && recipe_.clean_up)) meet_face_count();
    return splits;
  }

  // On this level; 0: any.
  std::size_t wanted_faces() const { return schedule_.wanted_faces >> (2 * clock_.levels_left()); }

  // Returns the number of operations.
  std::size_t meet_face_count()
  {
    const std::size_t faces = mesh_.number_of_live_faces(), wanted = wanted_faces();
    std::size_t collapses = 0, splits = 0;
    if (wanted > 0 && faces > wanted && !context_.collapse_rule.is_never())
      collapses = run(Pass::collapse, [&]() { return collapse_surplus(context_, wanted); });
    if (faces < wanted && !context_.split_rule.is_never())
      splits = run(Pass::split, [&]() { return split_for_deficit<ConcurrencyTag>(context_, wanted); });
    report_.collapses += collapses;
    report_.splits += splits;
    return collapses + splits;
  }

  // Flips, and glides perhaps, by turns. Without sweeps a glide does nothing for the angles.
  void flip(unsigned rounds, bool does_glide)
  {
    if (!goes_on() || context_.flip_rule.is_never()) return;
    does_glide = does_glide && recipe_.sweeps > 0;
    measure_regular_valences<ConcurrencyTag>(mesh_, recipe_.curvature_valences && clock_.is_half_done());
    std::size_t done = 1;
    for (unsigned round = 0; round < rounds && done > 0; ++round) {
      done = run(Pass::flip, [&]() { return flip_pass<ConcurrencyTag>(context_); });
      report_.flips += done;
      if (!does_glide) continue;
      const std::size_t glides = run(Pass::glide, [&]() { return glide_pass<ConcurrencyTag>(context_); });
      report_.glides += glides;
      done += glides;
    }
  }

  void relax(unsigned sweeps, Pull_back pull_back)
  {
    if (sweeps == 0) return;
    run(Pass::relax, [&]() {
      for_each_vertex_of_a_visitor([&](Mesh_vertex v) { context_.visitor.before_move(v, mesh_); });
      const std::size_t count = relaxation_.run<ConcurrencyTag>(mesh_, context_.projector, sweeps, pull_back, curve_tolerance());
      for_each_vertex_of_a_visitor([&](Mesh_vertex v) { context_.visitor.after_move(v, mesh_); });
      return count;
    });
  }

  // A surface that is far away is reached in a few steps before the iterations, if at all: in each one some faces may turn, and iterations
  // would multiply them. A wanted number of faces is one of that surface.
  void go_to_far_surface()
  {
    constexpr int MOST_STEPS = 4;
    if (recipe_.sweeps == 0 || !goes_on() || !is_surface_far(context_)) return;
    const double area_before = area(mesh_);
    std::size_t moved = 1;
    for (int step = 0; step < MOST_STEPS && moved > 0 && goes_on() && is_surface_far(context_); ++step)
      run(Pass::relax, [&]() {
        for_each_vertex_of_a_visitor([&](Mesh_vertex v) { context_.visitor.before_move(v, mesh_); });
        moved = projection_pass<ConcurrencyTag>(context_);
        for_each_vertex_of_a_visitor([&](Mesh_vertex v) { context_.visitor.after_move(v, mesh_); });
        return moved;
      });
    if (wanted_faces() > 0 && area_before > 0) context_.target_length *= std::sqrt(area(mesh_) / area_before);
    check_number_of_faces();
  }

  void find_details_of_field()
  {
    if (context_.sizing.is_function() && !context_.split_rule.is_never())
      report_.splits += run(Pass::split, [&]() { return field_detail_pass<ConcurrencyTag>(context_); });
  }

  void subdivide()
  {
    report_.splits += run(Pass::subdivide, [&]() { return subdivision_pass<ConcurrencyTag>(context_); });
  }

  // Returns whether no poor spot is left.
  bool mend_spots()
  {
    Spot_iteration<ConcurrencyTag> spots(context_, relaxation_);
    run(Pass::mend, [&]() { return spots.run(curve_tolerance(), report_, LARGEST_SPOTS); });
    return spots.is_done();
  }

  bool has_heaps() const
  {
    return goes_on() && repairs() && !context_.keeps_vertices && !context_.collapse_rule.is_never() &&
           internal::has_heaps<ConcurrencyTag>(context_);
  }

  // Iterates where heaps of vertices are left. Returns whether there were some.
  bool mend_heaps()
  {
    constexpr double LARGEST_SHARE = 0.5;        // of the vertices, those around included
    if (!has_heaps()) return false;
    Spot_iteration<ConcurrencyTag> spots(context_, relaxation_);
    return run(Pass::mend, [&]() { return spots.run(curve_tolerance(), report_, LARGEST_SHARE); }) > 0;
  }

  // Iterates around edges whose ends stay: beside protected ones subdivision does not cut faces into four, and on the rim faces are poor.
  void mend_beside_fixed_ends()
  {
    std::vector<Index> ends;
    mesh_.for_each_edge([&](Index h) {
      if (mesh_.is_between_fixed_ends(h)) ends.insert(ends.end(), {mesh_.origin(h), mesh_.target(h)}); });
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    if (ends.empty()) return;
    Spot_iteration<ConcurrencyTag> spots(context_, relaxation_);
    run(Pass::mend, [&]() { return spots.run_around(std::move(ends), curve_tolerance(), report_); });
  }

  void remove_low_valences()
  {
    if (!context_.collapse_rule.is_never())
      report_.collapses += run(Pass::clean_up, [&]() { return low_valence_pass<ConcurrencyTag>(context_); });
  }

  void fit()
  {
    if (context_.projector.has_faces() && recipe_.fits > 0 && recipe_.sweeps > 0)
      run(Pass::fit, [&]() { return fit_pass<ConcurrencyTag>(context_, recipe_.fits); });
  }

  void polish()
  {
    if (recipe_.sweeps > 0) run(Pass::polish, [&]() { return polish_pass(context_); });
  }

  // Returns the number of collapses.
  std::size_t remove_middles_of_strips()
  {
    if (!repairs() || !mesh_.has_curves() || context_.collapse_rule.is_never()) return 0;
    const std::size_t collapses = run(Pass::repair, [&]() { return narrow_strip_pass(context_); });
    report_.collapses += collapses;
    return collapses;
  }

  // Returns the number of spots where the distance is smaller now.
  std::size_t lower_distances()
  {
    if (!context_.projector.is_input() || !(recipe_.distance_tolerance > 0) || recipe_.sweeps == 0 ||
        context_.is_finer_than_surface()) return 0;
    return run(Pass::distance, [&]() { return distance_pass(context_); });
  }

  void repair(Repairer& repairer)
  {
    if (repairs()) report_.repairs += run(Pass::repair, [&]() { return repairer.template run<ConcurrencyTag>(); });
  }

  void release_features()
  {
    if (goes_on() && context_.release_distance > 0 && repairs()) Feature_release(context_).release_close_corners();
  }

  void release_crests() { Feature_release(context_).release_crests(); }

  // Chords much shorter than the surface's own do not lead through another sheet, but where the mesh is a wreck.
  void part_crossing_faces(Repairer& repairer)
  {
    if (!goes_on() || !repairs() || (context_.projector.has_faces() && !context_.has_outside() &&
                                     !repairer.leaves_bad_faces() && context_.is_finer_than_surface())) return;
    report_.are_crossing_faces_known = true;
    report_.repairs += run(Pass::repair, [&]() {
      return repairer.part_crossing_faces<ConcurrencyTag>(report_.crossing_faces); });
  }

  // Puts vertices that relaxation left a little off the surface onto it, though the run was cancelled; nobody is told.
  void pull_back()
  {
    relaxation_.run<ConcurrencyTag>(mesh_, context_.projector, 0, Pull_back::after_last_sweep, curve_tolerance());
  }

  void print_state(const std::string& name) const
  {
    if (!schedule_.is_verbose) return;
    const Remeshing_report::Angles angles = angle_summary<ConcurrencyTag>(mesh_);
    std::ostringstream line;                     // whatever flags the user's stream has
    line << name << ": " << mesh_.number_of_live_faces() << " faces, angles "
         << angles.minimum << " to " << angles.maximum << ", average " << angles.average << "; so far "
         << report_.splits << " splits, " << report_.collapses << " collapses, " << report_.flips << " flips, "
         << report_.glides << " glides\n";
    std::cout << line.str();
  }

  // Tells the callback, if it does not know it yet, that nothing is left to do.
  void tell_end()
  {
    if (goes_on() && clock_.progress() < 1) tell_progress(1);
  }

private:
  struct Edges_out_of_limits
  {
    std::vector<Index> too_long, too_short;
  };

  Edges_out_of_limits edges_out_of_limits(double widening) const
  {
    constexpr double inf = std::numeric_limits<double>::infinity();
    const double low = context_.collapse_rule.is_never() ? 0 : context_.squared_shortness_limit() / (widening * widening);
    const double high = context_.split_rule.is_never() ? inf : context_.squared_length_limit() * (widening * widening);
    Edges_out_of_limits result;
    const auto sort_in = [&](const auto& scale) {
      for (const Index h : edges_out_of<ConcurrencyTag>(mesh_, low, high, scale)) {
        const bool is_too_short = mesh_.squared_edge_length(h) < low * scale(mesh_.origin(h), mesh_.target(h));
        (is_too_short ? result.too_short : result.too_long).push_back(h);
      }
    };
    if (context_.grading.is_uniform()) sort_in([](Index, Index) { return 1.; });
    else sort_in([&](Index u, Index v) { return CGAL::square(context_.grading.part(u, v)); });
    return result;
  }

  // The surface may be larger than the mesh by any factor.
  void check_number_of_faces() const
  {
    const double length = std::ldexp(context_.target_length, -int(clock_.levels_left())),
                 faces = context_.keeps_vertices ? 0. : context_.grading.number_of_faces(mesh_, length);
    if (!(faces <= MAXIMUM_NUMBER_OF_FACES))
      refuse(REMESHING, "the surface of the projection functor is so large that about " + to_text(faces) + " faces were needed; at most " +
                        to_text(MAXIMUM_NUMBER_OF_FACES) + " can be indexed");
  }

  bool repairs() const { return recipe_.repair && recipe_.sweeps > 0; }

  double curve_tolerance() const { return internal::curve_tolerance(context_, context_.target_length); }

  template <class Function>
  void for_each_vertex_of_a_visitor(const Function& function) const
  {
    if (context_.visitor.listens())
      for (const Mesh_vertex v : vertices(mesh_))
        if (mesh_.is_movable(v.index())) function(v);
  }

  // Returns what the pass returns, the number of operations.
  template <class Function>
  std::size_t run(Pass pass, const Function& function)
  {
    if (!goes_on()) return 0;
    context_.visitor.start_pass(pass, mesh_);
    const std::size_t count = function();
    context_.visitor.end_pass(pass, mesh_, count);
    clock_.end_pass(flip_rounds());
    tell_progress(clock_.progress());
    return count;
  }

  void tell_progress(double progress)
  {
    if (schedule_.callback && !schedule_.callback(progress)) report_.ending = Remeshing_report::Ending::cancelled;
  }

  Remeshing_context& context_;
  Remeshing_mesh& mesh_;
  const Recipe& recipe_;
  const Schedule& schedule_;
  Run_clock& clock_;
  Remeshing_report& report_;
  Relaxation relaxation_;
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASS_RUNNER_H
