// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_ITERATIONS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_ITERATIONS_H

#include <CGAL/Inter_angle_remeshing/Recipe.h>
#include <CGAL/Inter_angle_remeshing/Remeshing_report.h>
#include <CGAL/Inter_angle_remeshing/internal/Face_count_steering.h>
#include <CGAL/Inter_angle_remeshing/internal/Pass_runner.h>
#include <CGAL/Inter_angle_remeshing/internal/Remeshing_context.h>
#include <CGAL/Inter_angle_remeshing/internal/Run_clock.h>
#include <CGAL/Inter_angle_remeshing/internal/Schedule.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/edge_lengths.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/space_filling_order.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/angle_bands.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/skew_grid.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

// The iterations: splits and collapses bring the edges to the target length, flips and glides the valences to what is regular, sweeps the
// vertices to the centres of their neighbors. They end once one of them does hardly anything, or after as many as were asked for.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

template <class ConcurrencyTag>
class Iterations
{
  using Index = Remeshing_mesh::Index;

  // The iteration from which on glides pay: before, splits and collapses stir the valences up too much.
  static constexpr unsigned FIRST_GLIDES = 2;
  // Once an iteration does no more than one operation for so many faces, only the last ones are left to do.
  static constexpr std::size_t SETTLED = 1000;
  // If an iteration does hardly anything while many faces are out of the band, the mesh is disturbed once: by splits for .9, or, if too
  // dense, by collapses for 1.25 of the length. Hardly anything: one operation for so many faces; many: this part of the faces.
  static constexpr std::size_t HARDLY_MOVING = 100;
  static constexpr double SKEWED = 0.1, STIRRED_BY_SPLITS = 0.9, STIRRED_BY_COLLAPSES = 1.25;
  // A skew grid is broken up from this iteration on, as long as it is one: its short edges, which it could not do without, are collapsed
  // although that makes edges so many times as long as they may be.
  static constexpr unsigned FIRST_GRID = 3;
  static constexpr double GRID_REACH = 1.3;
  // A mesh of more than so many times the faces that its area asks for is coarsened in up to so many rounds, as long as each leaves
  // less than this part of the faces.
  static constexpr double TOO_DENSE = 1.5, COARSENED = 0.97;
  static constexpr int MOST_COARSENINGS = 8;
  // What stands out of a clean surface is a tip, which collapses spare; of a noisy one most are spikes. Where these keep it too dense, an
  // iteration spares those alone that stand out so many times as far as in the one before, up to so many times in all; but not before
  // the first ones, in which the mesh is still being coarsened.
  static constexpr double SPIKE_GROWTH = 2, LARGEST_SPIKE_FACTOR = 4;
  static constexpr unsigned COARSENING_ITERATIONS = 2;
  // Edges are far too long from so many times the length on that they may have. Splits of those that are very far too long get on if they
  // shorten the longest one to this part, or are one for so many faces.
  static constexpr double FAR_TOO_LONG = 2, VERY_FAR_TOO_LONG = 8, SHORTENED = 0.95;
  static constexpr std::size_t FACES_PER_SPLIT = 20;

public:
  Iterations(Remeshing_context& context, const Schedule& schedule, Run_clock& clock, Remeshing_report& report,
             Pass_runner<ConcurrencyTag>& passes)
    : context_(context), mesh_(context.mesh), recipe_(context.recipe), schedule_(schedule), clock_(clock), report_(report),
      passes_(passes)
  {}

  void run()
  {
    passes_.go_to_far_surface();
    passes_.find_details_of_field();
    Face_count_steering steering(context_.target_length);
    while (clock_.has_iterations_left() && passes_.goes_on()) {
      steering.steer(context_, clock_, passes_.wanted_faces());
      iterate();
    }
  }

  void begin_anew()
  {
    context_.spike_factor = 1;
    operations_in_order_ = 0;
    is_stirred_up_ = false;
    may_be_grid_ = true;
    is_only_split_ = true;
  }

private:
  void iterate()
  {
    const std::size_t operations = number_of_operations();
    clock_.start_iteration();
    context_.visitor.start_iteration(clock_.iterations(), mesh_);
    if (clock_.is_late() && clock_.is_at_finest_level()) passes_.release_features();
    if (clock_.iterations() > COARSENING_ITERATIONS && context_.noise > 0 && has_too_many_faces())
      context_.spike_factor = (std::min)(LARGEST_SPIKE_FACTOR, SPIKE_GROWTH * context_.spike_factor);
    split_and_collapse_in_rounds();
    if (clock_.is_late() && number_of_operations() > operations) settle_lengths();
    order_elements();
    if (clock_.is_late() || !is_only_split_) {
      passes_.flip(passes_.flip_rounds(), recipe_.glide_depth > 0 && (clock_.iterations() >= FIRST_GLIDES || clock_.is_late()));
      relax();
    }
    const std::size_t done = number_of_operations() - operations, faces = mesh_.number_of_live_faces();
    if (passes_.goes_on() && !context_.keeps_vertices && !clock_.is_late()) {
      const bool is_grid = may_be_grid_ && clock_.iterations() >= FIRST_GRID && is_skew_grid(mesh_);
      may_be_grid_ = is_grid || clock_.iterations() < FIRST_GRID;
      if (is_grid) break_grid_up();
      else if (!is_stirred_up_ && done <= faces / HARDLY_MOVING && is_skewed()) stir_up();
      else if (done <= faces / SETTLED) clock_.hurry();
    }
    context_.visitor.end_iteration(clock_.iterations(), mesh_);
    clock_.end_iteration();
    report_.iterations = clock_.iterations();
    passes_.print_state("iteration " + std::to_string(clock_.iterations()));
  }

  std::size_t number_of_operations() const
  {
    return report_.splits + report_.collapses + report_.flips + report_.glides;
  }

  void relax()
  {
    // Between the passes of the early iterations, being a little off the surface does no harm.
    const bool is_pulled_back = clock_.is_late() || clock_.iterations() % 2 == 0;
    passes_.relax(clock_.is_late() ? recipe_.last_sweeps : recipe_.sweeps,
                  is_pulled_back ? Pull_back::after_last_sweep : Pull_back::never);
  }

  // Whether many faces are out of their bands: where hardly an operation is left to do, those of a grid.
  bool is_skewed() const
  {
    const Angle_bands bands(recipe_);
    std::size_t skewed = 0;
    for (Index f = 0; f < Index(mesh_.number_of_face_slots()); ++f) skewed += mesh_.is_face(f) && !holds_band(mesh_, bands, f);
    return double(skewed) > SKEWED * double(mesh_.number_of_live_faces());
  }

  void break_grid_up()
  {
    const std::size_t operations = number_of_operations();
    context_.collapse_reach = GRID_REACH;
    passes_.split_and_collapse();
    context_.collapse_reach = 1;
    may_be_grid_ = number_of_operations() > operations;
    even_out();
  }

  // What is split or collapsed for another length, once, the next iterations take back at other places.
  void stir_up()
  {
    is_stirred_up_ = true;
    const double target_length = context_.target_length;
    context_.target_length *= is_too_dense() ? STIRRED_BY_COLLAPSES : STIRRED_BY_SPLITS;
    passes_.split_and_collapse();
    context_.target_length = target_length;
    even_out();
  }

  // What splits and collapses leave, before the next ones.
  void even_out()
  {
    passes_.flip(1, false);
    passes_.relax(recipe_.sweeps, Pull_back::after_last_sweep);
  }

  // An iteration merges a vertex with few of those around it, and a policy may have kept edges from being split. What is far too long or
  // far too dense even when the last iterations begin goes through as many short ones as it takes, so that those work on a mesh of about
  // the target length. Each should halve the longest edge, or take away faces; where policies do not let it, the rounds end all the same.
  void settle_lengths()
  {
    double excess = excess_of_longest_edge();
    for (int round = most_rounds(excess); round > 0 && passes_.goes_on() && (excess > FAR_TOO_LONG || is_too_dense());
         --round) {
      if (!(is_only_split_ && excess > VERY_FAR_TOO_LONG)) even_out();
      const std::size_t faces = mesh_.number_of_live_faces(), splits = split_and_collapse();
      if ((excess <= FAR_TOO_LONG || splits == 0) && double(mesh_.number_of_live_faces()) > COARSENED * double(faces)) return;
      excess = excess_of_longest_edge();
    }
  }

  bool is_too_dense() const
  {
    return !context_.collapse_rule.is_never() &&
           double(mesh_.number_of_live_faces()) > TOO_DENSE * context_.grading.number_of_faces(mesh_, context_.target_length);
  }

  // Where a number of faces is wanted, the length follows it: then that number tells.
  bool has_too_many_faces() const
  {
    const std::size_t wanted = passes_.wanted_faces();
    return wanted > 0 ? double(mesh_.number_of_live_faces()) > TOO_DENSE * double(wanted) : is_too_dense();
  }

  // Splits and collapses, once, but over and over as long as edges are far too long, from the first iteration on: the input's own,
  // halved, are better than what flips and sweeps would make of them. Faces that long, turned a little, cut through what lies between
  // them, and vertices at short edges are drawn to the far ends of long ones.
  void split_and_collapse_in_rounds()
  {
    int rounds = is_only_split_ && !clock_.is_late() ? most_rounds(excess_of_longest_edge()) : 1;
    do split_and_collapse();
    while (--rounds > 0 && is_only_split_ && passes_.goes_on());
  }

  // Returns the number of splits.
  std::size_t split_and_collapse()
  {
    const double excess = is_only_split_ ? excess_of_longest_edge() : 0;
    is_only_split_ = excess > FAR_TOO_LONG;
    std::size_t splits = passes_.split_and_collapse();
    if (!is_only_split_) return splits;
    double left = excess_of_longest_edge();
    if (excess > VERY_FAR_TOO_LONG && left >= SHORTENED * excess) {            // edges had got other names meanwhile
      splits += passes_.split_and_collapse();
      left = excess_of_longest_edge();
    }
    is_only_split_ = left > FAR_TOO_LONG && are_splits_enough(excess, left, splits);
    return splits;
  }

  // Whether so many splits, which have changed the longest edge's excess, get on with what is to do: a policy may not let them. What is very
  // far too long is not left to flips and sweeps any sooner; in a fan of needles many edges are about as long as the longest.
  bool are_splits_enough(double before, double after, std::size_t splits) const
  {
    if (before > VERY_FAR_TOO_LONG)
      return after < SHORTENED * before || splits > mesh_.number_of_live_faces() / FACES_PER_SPLIT;
    return halvings(after) < halvings(before);
  }

  // How many times as long as it may be the longest edge is.
  double excess_of_longest_edge() const
  {
    if (context_.split_rule.is_never()) return 0;
    return longest_edge_in_targets(mesh_, [&](Index u, Index v) { return context_.length_at(u, v); }) / recipe_.split_ratio;
  }

  // How often an edge must be halved until it is no longer far too long.
  static int halvings(double excess) { return excess > FAR_TOO_LONG ? 1 + int(std::log2(excess)) : 0; }
  static int most_rounds(double excess) { return halvings(excess) + MOST_COARSENINGS; }

  // Puts the elements in space-filling order anew when splits and collapses have left enough of them out of it. The
  // larger the mesh, the sooner that pays.
  void order_elements()
  {
    const std::size_t faces = mesh_.number_of_live_faces(), operations = report_.splits + report_.collapses;
    const std::size_t fraction = faces < 100000 ? 4 : faces < 1000000 ? 8 : 32;
    if (operations - operations_in_order_ <= faces / fraction) return;
    mesh_.renumber<ConcurrencyTag>(morton_order(mesh_));
    passes_.measure_grading();
    operations_in_order_ = operations;
  }

  Remeshing_context& context_;
  Remeshing_mesh& mesh_;
  const Recipe& recipe_;
  const Schedule& schedule_;
  Run_clock& clock_;
  Remeshing_report& report_;
  Pass_runner<ConcurrencyTag>& passes_;
  bool is_stirred_up_ = false;           // once only
  bool may_be_grid_ = true;              // until the mesh is found to be none, or none that can be broken up
  bool is_only_split_ = true;            // as long as edges are far too long
  std::size_t operations_in_order_ = 0;  // splits and collapses before the last ordering
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_ITERATIONS_H
