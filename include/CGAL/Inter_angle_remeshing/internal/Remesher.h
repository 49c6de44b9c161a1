// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_REMESHER_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_REMESHER_H

#include <CGAL/Inter_angle_remeshing/Remeshing_report.h>
#include <CGAL/Inter_angle_remeshing/internal/Remeshing_context.h>
#include <CGAL/Inter_angle_remeshing/internal/angle_bands.h>
#include <CGAL/Inter_angle_remeshing/internal/angle_summary.h>
#include <CGAL/Inter_angle_remeshing/internal/bent_vertices.h>
#include <CGAL/Inter_angle_remeshing/internal/clean_up_pass.h>
#include <CGAL/Inter_angle_remeshing/internal/coarse_levels.h>
#include <CGAL/Inter_angle_remeshing/internal/collapse_pass.h>
#include <CGAL/Inter_angle_remeshing/internal/crossing_faces.h>
#include <CGAL/Inter_angle_remeshing/internal/distance_pass.h>
#include <CGAL/Inter_angle_remeshing/internal/edge_lengths.h>
#include <CGAL/Inter_angle_remeshing/internal/face_count_pass.h>
#include <CGAL/Inter_angle_remeshing/internal/fit_pass.h>
#include <CGAL/Inter_angle_remeshing/internal/flip_pass.h>
#include <CGAL/Inter_angle_remeshing/internal/glide_pass.h>
#include <CGAL/Inter_angle_remeshing/internal/polish_pass.h>
#include <CGAL/Inter_angle_remeshing/internal/relax_pass.h>
#include <CGAL/Inter_angle_remeshing/internal/repair_pass.h>
#include <CGAL/Inter_angle_remeshing/internal/run_passes.h>
#include <CGAL/Inter_angle_remeshing/internal/space_filling_order.h>
#include <CGAL/Inter_angle_remeshing/internal/split_pass.h>
#include <CGAL/Inter_angle_remeshing/internal/spot_pass.h>
#include <CGAL/Inter_angle_remeshing/internal/subdivision_pass.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// The iteration: the passes in order.
template <class ConcurrencyTag>
class Remesher
{
  using Index = Remeshing_mesh::Index;

public:
  Remesher(Remeshing_context& context, const Schedule& schedule)
    : context_(context), mesh_(context.mesh), recipe_(context.recipe), schedule_(schedule),
      relaxation_(context.recipe, context.curves, context.grading, context.noise),
      last_iteration_(schedule.iterations), wanted_faces_(schedule.wanted_faces)
  {}

  Remeshing_report run()
  {
    report_.ending = Remeshing_report::Ending::completed;
    report_.input_faces = mesh_.number_of_live_faces();
    report_.angles_before = angle_summary<ConcurrencyTag>(mesh_);
    choose_levels();
    if (levels_ == 0 || !succeeds_from_coarsest_level()) run_directly();
    return is_at_finest_level() ? finish() : report_;
  }

  // Whether the mesh is one of the target length: cancelled before that, a run has nothing to show, and the mesh is the input.
  bool is_at_finest_level() const { return levels_ == 0; }

private:
  // Iterations at the end that relax longest, flip in several rounds, and settle what is left to split.
  static constexpr unsigned LAST_ITERATIONS = 2;
  // The iteration from which on glides pay: before, splits and collapses stir the valences up too much.
  static constexpr unsigned FIRST_GLIDES = 2;
  // The iteration from which on short edges of curves are there to stay.
  static constexpr unsigned SETTLED_CURVES = 5;
  // Once an iteration does no more than one operation for so many faces, only the last ones are left to do.
  static constexpr std::size_t SETTLED = 1000;
  // Once it does no more than one operation for so many faces, and more than this part of the faces is out of the band, splits for
  // this part of the length, or collapses for so many times the length where the mesh is too dense, stir it up.
  static constexpr std::size_t HARDLY_MOVING = 100;
  static constexpr double SKEWED = 0.1, STIRRED_BY_SPLITS = 0.9, STIRRED_BY_COLLAPSES = 1.25;
  // A mesh of more than so many times the faces that its area asks for is coarsened in up to so many rounds, as long as each leaves
  // less than this part of the faces.
  static constexpr double TOO_DENSE = 1.5, COARSENED = 0.97;
  static constexpr int MOST_COARSENINGS = 8;
  // Sweeps after the clean-up.
  static constexpr unsigned CLEAN_UP_SWEEPS = 3;
  // As many pairs of crossing faces, for so many faces, are still parted on the finest level.
  static constexpr double FEW_CROSSINGS = 0.005;
  // Sweeps on a level between the coarsest and the finest one.
  static constexpr unsigned LEVEL_SWEEPS = 3;
  // On the finest level the limits of the edge lengths are wider by this factor: fewer vertices become irregular.
  static constexpr double FINEST_LIMITS = 1.3;

  void run_directly()
  {
    held_ = bent_vertices_between_long_edges(context_);
    hold();
    make_iterations();
    release();
    if (goes_on() && recipe_.clean_up) clean_up();
  }

  void hold()
  {
    for (const Index v : held_) mesh_.add_marks(v, Remeshing_mesh::HELD);
  }
  void release()
  {
    for (Index v = 0; v < Index(mesh_.number_of_vertex_slots()); ++v) mesh_.remove_marks(v, Remeshing_mesh::HELD);
  }

  void make_iterations()
  {
    const double first_target_length = context_.target_length;
    while (report_.iterations < last_iteration_ && goes_on()) {
      steer_to_face_count(first_target_length);
      iterate();
    }
  }

  // Levels pay where the faces that come out of the iterations can be cut into four as they are.
  void choose_levels()
  {
    if (!recipe_.multi_level || !context_.may_subdivide || recipe_.sweeps == 0 || context_.is_graded() ||
        has_protected_edges()) return;
    const Coarse_levels coarse_levels = Coarse_levels::measure<ConcurrencyTag>(mesh_, context_.target_length);
    levels_ = stages_ = coarse_levels.number(context_.target_length);
    if (levels_ > 0) held_ = coarse_levels.bent_vertices(std::ldexp(context_.target_length, int(levels_)));
  }

  bool has_protected_edges() const
  {
    for (std::size_t f = 0; f < mesh_.number_of_face_slots(); ++f)
      if (mesh_.has_protected_edge(Index(f))) return true;
    return false;
  }

  // Returns false, with everything as it was before, where that has left faces, crossings, or distances from curves, that the direct
  // way would hardly leave.
  bool succeeds_from_coarsest_level()
  {
    const Remeshing_mesh input = mesh_;
    const double target_length = context_.target_length;
    run_from_coarsest_level();
    const bool is_poor = goes_on() && (!is_at_finest_level() || leaves_curves<ConcurrencyTag>(context_) ||
                                       (has_poor_spots_ && has_poor_faces<ConcurrencyTag>(context_)));
    if (!is_poor && is_at_finest_level()) return true;
    mesh_ = input;
    context_.target_length = target_length;
    if (is_poor) levels_ = 0;
    forget_what_was_done();
    return !is_poor;
  }

  void forget_what_was_done()
  {
    Remeshing_report report;
    report.ending = report_.ending;
    report.target_edge_length = mesh_.unit() * context_.target_length;
    report.input_faces = report.output_faces = report_.input_faces;
    report.angles_before = report.angles_after = report_.angles_before;
    report_ = report;
    wanted_faces_ = schedule_.wanted_faces;
    last_iteration_ = schedule_.iterations;
    operations_in_order_ = steerings_ = 0;
    is_refined_ = is_fitted_ = is_stirred_up_ = is_only_split_ = has_poor_spots_ = false;
    stages_ = levels_;
  }

  // The iterations on the coarsest level, and what little the others leave to do.
  void run_from_coarsest_level()
  {
    context_.target_length = std::ldexp(context_.target_length, int(levels_));
    wanted_faces_ >>= 2 * levels_;
    hold();
    make_iterations();
    if (goes_on()) mend_valences();
    if (goes_on()) polish();
    release();
    while (levels_ > 0 && goes_on()) {
      if (cuts_through_itself()) return;
      go_to_finer_level();
    }
    if (goes_on() && recipe_.clean_up) clean_up();
  }

  // Whether many more faces cross others than of the surface do: it is too thin for edges of this level.
  bool cuts_through_itself() const
  {
    if (!context_.projector.has_faces()) return false;
    const std::size_t few = std::size_t(FEW_CROSSINGS * double(mesh_.number_of_live_faces())),
                      pairs = crossing_faces<ConcurrencyTag>(mesh_).size();
    return pairs > few && pairs > few + crossing_faces<ConcurrencyTag>(*context_.projector.surface).size();
  }

  void go_to_finer_level()
  {
    passes_ = 0;
    --levels_;
    context_.target_length /= 2;
    wanted_faces_ = schedule_.wanted_faces >> (2 * levels_);
    run_pass(Pass::subdivide, report_.splits, [&]() { return subdivision_pass<ConcurrencyTag>(context_); });
    split_and_collapse(is_at_finest_level() ? FINEST_LIMITS : 1);
    flip(1, recipe_.glide_depth > 0);
    if (goes_on() && !(is_at_finest_level() && recipe_.clean_up)) {
      relax(LEVEL_SWEEPS, Pull_back::after_last_sweep);
      if (goes_on()) mend_spots();
    }
    if (schedule_.is_verbose) print_state("level " + std::to_string(stages_ - levels_));
  }

  void iterate()
  {
    const unsigned i = report_.iterations;
    const std::size_t operations = number_of_operations();
    passes_ = 0;
    context_.visitor.start_iteration(i, mesh_);
    const int halvings = i == 0 || is_only_split_ ? halvings_to_do() : 0;
    split_and_collapse();
    is_only_split_ = is_only_to_be_split(halvings);
    if (is_late() && number_of_operations() > operations) settle_lengths();
    order_elements();
    if (is_late() || !is_only_split_) {
      flip(flip_rounds(), recipe_.glide_depth > 0 && (report_.iterations >= FIRST_GLIDES || is_late()));
      if (goes_on()) relax();
    }
    const std::size_t done = number_of_operations() - operations, faces = mesh_.number_of_live_faces();
    if (goes_on() && context_.target_length > 0 && !is_late()) {
      if (!is_stirred_up_ && done <= faces / HARDLY_MOVING && is_skewed()) stir_up();
      else if (done <= faces / SETTLED) last_iteration_ = (std::min)(last_iteration_, i + 1 + LAST_ITERATIONS);
    }
    context_.visitor.end_iteration(i, mesh_);
    ++report_.iterations;
    if (schedule_.is_verbose) print_state("iteration " + std::to_string(report_.iterations));
  }

  // Whether many faces are out of their bands. Where hardly an operation is left to do, they are those of a grid of edges of nearly
  // the target length: all of its vertices are regular, and at the centres of their neighbors, however skew its faces are.
  bool is_skewed() const
  {
    const Angle_bands bands(recipe_);
    std::size_t skewed = 0;
    for (Index f = 0; f < Index(mesh_.number_of_face_slots()); ++f) skewed += mesh_.is_face(f) && !holds_band(mesh_, bands, f);
    return double(skewed) > SKEWED * double(mesh_.number_of_live_faces());
  }

  // What is split or collapsed for another length, once, the next iterations take back at other places.
  void stir_up()
  {
    is_stirred_up_ = true;
    const double target_length = context_.target_length;
    context_.target_length *= is_too_dense() ? STIRRED_BY_COLLAPSES : STIRRED_BY_SPLITS;
    split_and_collapse();
    context_.target_length = target_length;
    flip(1, false);
    if (goes_on()) relax(recipe_.sweeps, Pull_back::after_last_sweep);
  }

  std::size_t number_of_operations() const
  {
    return report_.splits + report_.collapses + report_.flips + report_.glides;
  }

  // Before that, the angles around a vertex are those of the mesh rather than of the surface.
  bool is_half_done() const { return 2 * report_.iterations >= last_iteration_; }

  bool is_late() const { return report_.iterations + LAST_ITERATIONS >= last_iteration_; }

  // More than one round pays only where splits and collapses no longer stir up the valences.
  unsigned flip_rounds() const { return is_late() ? recipe_.flip_rounds : (std::min)(1u, recipe_.flip_rounds); }

  // An iteration halves edges, and merges a vertex with few of those around it. What is far too long or far too dense even when
  // the last iterations begin goes through as many short ones as it takes, so that those work on a mesh of about the target
  // length. Each should halve the longest edge, or take away faces; where policies do not let it, the rounds end all the same.
  void settle_lengths()
  {
    int halvings = halvings_to_do();
    for (int round = halvings + MOST_COARSENINGS; round > 0 && goes_on() && (halvings > 0 || is_too_dense()); --round) {
      flip(1, false);
      if (goes_on()) relax(recipe_.sweeps, Pull_back::after_last_sweep);
      const std::size_t faces = mesh_.number_of_live_faces(), splits = split_and_collapse();
      if ((halvings == 0 || splits == 0) && double(mesh_.number_of_live_faces()) > COARSENED * double(faces)) return;
      halvings = halvings_to_do();
    }
  }

  bool is_too_dense() const
  {
    return context_.target_length > 0 && !context_.collapse_rule.is_never() &&
           double(mesh_.number_of_live_faces()) > TOO_DENSE * context_.grading.number_of_faces(mesh_, context_.target_length);
  }

  // Whether edges are so much too long that the input's own, halved, are better than what flips and sweeps would make of them: faces
  // that long, turned a little, cut through what lies between them, and vertices at short edges are drawn to the far ends of long
  // ones. `before` is halvings_to_do() before the last splits, which must have shortened the longest edges.
  bool is_only_to_be_split(int before) const
  {
    const int now = before > 0 ? halvings_to_do() : 0;
    return now > 0 && now < before;
  }

  // How often the longest edge must be halved until it is no longer far too long.
  int halvings_to_do() const
  {
    if (!(context_.target_length > 0) || context_.split_rule.is_never()) return 0;
    const double ratio = longest_edge_in_targets(mesh_, [&](Index u, Index v) { return context_.length_at(u, v); }) /
                         recipe_.split_ratio;
    return ratio > 2 ? 1 + int(std::log2(ratio)) : 0;
  }

  // Short edges that curves could do without are those of the input, at first: they tell nothing about details.
  void measure_grading()
  {
    if (!(context_.target_length > 0) || !context_.is_graded()) return;
    context_.grading.read<ConcurrencyTag>(mesh_, context_.sizing, context_.locator, context_.target_length);
    if (!(context_.grading_rate > 0)) return;
    const bool are_curves_settled = report_.iterations >= SETTLED_CURVES || !context_.may_collapse_constraints ||
                                    context_.collapse_rule.is_never();
    context_.grading.sink(mesh_, context_.target_length, context_.grading_rate, [&](Index v) {
      return are_curves_settled || !has_surplus_curve_edge(context_, v); });
  }

  // Returns the number of splits. The limits of the edge lengths are those of the recipe, or wider by a factor.
  std::size_t split_and_collapse(double widening = 1)
  {
    if (!goes_on() || !(context_.target_length > 0)) return 0;
    constexpr double inf = std::numeric_limits<double>::infinity();
    const double low = context_.collapse_rule.is_never() ? 0 : context_.squared_shortness_limit() / (widening * widening);
    const double high = context_.split_rule.is_never() ? inf : context_.squared_length_limit() * (widening * widening);
    std::vector<Remeshing_mesh::Index> long_edges, short_edges;
    std::size_t splits = 0;
    measure_grading();
    run_pass(Pass::split, report_.splits, [&]() {
      if (context_.grading.is_uniform()) {
        for (const Remeshing_mesh::Index h : edges_out_of<ConcurrencyTag>(mesh_, low, high))
          (mesh_.squared_edge_length(h) < low ? short_edges : long_edges).push_back(h);
      } else {
        const auto scale = [&](Remeshing_mesh::Index h) {
          const double part = context_.grading.part(mesh_.origin(h), mesh_.target(h));
          return part * part;
        };
        const auto is_too_short = [&](Remeshing_mesh::Index h) { return mesh_.squared_edge_length(h) < low * scale(h); };
        const auto is_out_of_limits = [&](Remeshing_mesh::Index h) {
          const double l = mesh_.squared_edge_length(h), s = scale(h);
          return l < low * s || l > high * s;
        };
        for (const Remeshing_mesh::Index h : edges_where<ConcurrencyTag>(mesh_, is_out_of_limits))
          (is_too_short(h) ? short_edges : long_edges).push_back(h);
      }
      return splits = split_pass<ConcurrencyTag>(context_, long_edges, short_edges);
    });
    if (goes_on() && !context_.collapse_rule.is_never())
      run_pass(Pass::collapse, report_.collapses, [&]() { return collapse_pass<ConcurrencyTag>(context_, short_edges); });
    if (wanted_faces_ > 0 && is_late()) meet_face_count();
    return splits;
  }

  void meet_face_count()
  {
    const std::size_t faces = mesh_.number_of_live_faces();
    if (goes_on() && faces > wanted_faces_ && !context_.collapse_rule.is_never())
      run_pass(Pass::collapse, report_.collapses, [&]() { return collapse_surplus(context_, wanted_faces_); });
    if (goes_on() && faces < wanted_faces_ && !context_.split_rule.is_never())
      run_pass(Pass::split, report_.splits, [&]() {
        return split_for_deficit<ConcurrencyTag>(context_, wanted_faces_); });
  }

  // Flips, and glides perhaps, by turns.
  void flip(unsigned rounds, bool does_glide)
  {
    if (context_.flip_rule.is_never()) return;
    measure_regular_valences<ConcurrencyTag>(mesh_, recipe_.curvature_valences && is_half_done());
    for (unsigned round = 0; round < rounds && goes_on(); ++round) {
      run_pass(Pass::flip, report_.flips, [&]() { return flip_pass<ConcurrencyTag>(context_); });
      if (goes_on() && does_glide)
        run_pass(Pass::glide, report_.glides, [&]() { return glide_pass<ConcurrencyTag>(context_); });
    }
  }

  void relax()
  {
    // Between the passes of the early iterations, being a little off the surface does no harm.
    const bool is_pulled_back = is_late() || report_.iterations % 2 == 0;
    relax(is_late() ? recipe_.last_sweeps : recipe_.sweeps,
          is_pulled_back ? Pull_back::after_last_sweep : Pull_back::never);
  }

  void relax(unsigned sweeps, Pull_back pull_back)
  {
    if (sweeps == 0) return;
    std::size_t moved = 0;
    run_pass(Pass::relax, moved, [&]() {
      for_each_vertex_of_a_visitor([&](Mesh_vertex v) { context_.visitor.before_move(v, mesh_); });
      const std::size_t count = relaxation_.run<ConcurrencyTag>(mesh_, context_.projector, sweeps, pull_back, curve_tolerance());
      for_each_vertex_of_a_visitor([&](Mesh_vertex v) { context_.visitor.after_move(v, mesh_); });
      return count;
    });
  }

  template <class Function>
  void for_each_vertex_of_a_visitor(const Function& function) const
  {
    if (context_.visitor.listens())
      for (const Mesh_vertex v : vertices(mesh_))
        if (mesh_.is_free(v.index()) || mesh_.is_sliding(v.index())) function(v);
  }

  void clean_up()
  {
    measure_grading();
    mend_valences();
    if (goes_on() && stages_ > 0) mend_spots();
    context_.kept_places.note(mesh_);
    if (goes_on()) fit();
    if (goes_on()) polish();
    Repairer repairer(context_, report_.input_faces);
    repair(repairer);
    if (goes_on() && lower_distances() > 0) repair(repairer);
    part_crossing_faces(repairer);
  }

  void fit()
  {
    std::size_t moves = 0;
    is_fitted_ = true;
    if (context_.projector.has_faces() && recipe_.fits > 0 && recipe_.sweeps > 0)
      run_pass(Pass::fit, moves, [&]() { return fit_pass<ConcurrencyTag>(context_, context_.target_length, recipe_.fits); });
  }

  std::size_t lower_distances()
  {
    std::size_t spots = 0;
    if (context_.projector.is_input() && recipe_.distance_tolerance > 0 && recipe_.sweeps > 0 && context_.target_length > 0 &&
        !is_finer_than_surface(context_, context_.target_length))
      run_pass(Pass::distance, spots, [&]() { return distance_pass(context_); });
    return spots;
  }

  void mend_valences()
  {
    if (context_.target_length > 0 && !context_.collapse_rule.is_never())
      run_pass(Pass::clean_up, report_.collapses, [&]() { return clean_up_pass<ConcurrencyTag>(context_); });
    if (goes_on()) flip(1, false);
    if (goes_on() && recipe_.sweeps > 0) relax(CLEAN_UP_SWEEPS, Pull_back::after_last_sweep);
  }

  void mend_spots()
  {
    std::size_t vertices = 0;
    Spot_iteration<ConcurrencyTag> spots(context_, relaxation_);
    run_pass(Pass::mend, vertices, [&]() { return spots.run(curve_tolerance(), report_); });
    has_poor_spots_ = !spots.is_done();
  }

  void polish()
  {
    std::size_t moves = 0;
    if (recipe_.sweeps > 0)
      run_pass(Pass::polish, moves, [&]() { return polish_pass(context_); });
  }

  bool repairs() const { return goes_on() && recipe_.repair && recipe_.sweeps > 0 && context_.target_length > 0; }

  void repair(Repairer& repairer)
  {
    if (repairs())
      run_pass(Pass::repair, report_.repairs, [&]() { return repairer.run(); });
  }

  // Chords much shorter than the surface's own do not lead through another sheet, but where the mesh is a wreck.
  void part_crossing_faces(Repairer& repairer)
  {
    if (!repairs() || (context_.projector.has_faces() && !repairer.leaves_bad_faces() &&
                       is_finer_than_surface(context_, context_.target_length))) return;
    report_.are_crossing_faces_known = true;
    run_pass(Pass::repair, report_.repairs, [&]() {
      return repairer.part_crossing_faces<ConcurrencyTag>(report_.crossing_faces); });
  }

  Remeshing_report finish()
  {
    if (report_.ending == Remeshing_report::Ending::cancelled && !is_fitted_)
      relaxation_.run<ConcurrencyTag>(mesh_, context_.projector, 0, Pull_back::after_last_sweep, curve_tolerance());
    if (mesh_.has_free_slots()) mesh_.renumber<ConcurrencyTag>(mesh_.block_order());
    report_.output_faces = mesh_.number_of_live_faces();
    report_.target_edge_length = mesh_.unit() * context_.target_length;
    report_.angles_after = angle_summary<ConcurrencyTag>(mesh_);
    report_band(mesh_, Angle_bands(recipe_), report_);
    return report_;
  }

  double curve_tolerance() const { return CURVE_TOLERANCE * context_.target_length; }

  // Runs a pass, tells the visitor and the callback about it.
  template <class Function>
  void run_pass(Pass pass, std::size_t& total, const Function& function)
  {
    context_.visitor.start_pass(pass, mesh_);
    const std::size_t count = function();
    total += count;
    context_.visitor.end_pass(pass, mesh_, count);
    if (!schedule_.callback) return;
    const double passes_an_iteration = 3. + 2. * flip_rounds();
    const double part = (std::min)(1., ++passes_ / passes_an_iteration), iterations = last_iteration_;
    const double done = levels_ == stages_ ? (std::min)(report_.iterations + part, iterations)
                                           : iterations + (stages_ - levels_ - 1) + part;
    progress_ = (std::max)(progress_, done / (iterations + stages_));
    if (!schedule_.callback(progress_)) report_.ending = Remeshing_report::Ending::cancelled;
  }

  bool goes_on() const { return report_.ending == Remeshing_report::Ending::completed; }

  // Puts the elements in space-filling order anew when splits and collapses have left enough of them out of it. The
  // larger the mesh, the sooner that pays.
  void order_elements()
  {
    const std::size_t faces = mesh_.number_of_live_faces(), operations = report_.splits + report_.collapses;
    const std::size_t fraction = faces < 100000 ? 4 : faces < 1000000 ? 8 : 32;
    if (operations - operations_in_order_ <= faces / fraction) return;
    mesh_.renumber<ConcurrencyTag>(morton_order(mesh_));
    if (!context_.sizing.is_uniform()) measure_grading();
    operations_in_order_ = operations;
  }

  void steer_to_face_count(double first_target_length);
  void print_state(const std::string& name) const;

  Remeshing_context& context_;
  Remeshing_mesh& mesh_;
  const Recipe& recipe_;
  const Schedule& schedule_;
  Relaxation relaxation_;
  Remeshing_report report_;
  unsigned last_iteration_;              // how many are made, unless the run is cancelled
  unsigned stages_ = 0, levels_ = 0;     // levels that the run has in all, and still to come
  std::vector<Index> held_;              // vertices that stay where they are in the iterations
  bool is_fitted_ = false;               // from then on, vertices need not lie on the surface
  bool is_stirred_up_ = false;           // once only
  bool has_poor_spots_ = false;          // of which the spots' own iterations did not get the better
  unsigned passes_ = 0;                  // done in this iteration, or on this level
  double progress_ = 0;
  bool is_only_split_ = false;           // in this iteration
  std::size_t wanted_faces_;             // on this level
  std::size_t operations_in_order_ = 0;  // splits and collapses before the last ordering
  bool is_refined_ = false;              // by so much that the number of faces is not steered
  std::size_t steerings_ = 0;            // iterations since the number of faces came near the wanted one
};

// The number of faces falls from iteration to iteration as the mesh grows regular; measured, it lies above its final
// value by the factors in the table. What differs from that, half of it on a logarithmic scale, corrects the length.
template <class ConcurrencyTag>
void Remesher<ConcurrencyTag>::steer_to_face_count(double first_target_length)
{
  static constexpr double EXCESS[] = {1.15, 1.075, 1.045, 1.03, 1.018, 1.012, 1.007};
  static constexpr std::size_t SIZE = sizeof(EXCESS) / sizeof(EXCESS[0]);
  // Until the count is this near, the mesh is still being coarsened, and says nothing about the length. One that is
  // refined comes from below, where the table does not hold, but the length that the run began with does, within 1%.
  static constexpr double NEAR = 1.3;
  if (wanted_faces_ == 0 || report_.iterations == 0 || is_late()) return;
  const double ratio = double(mesh_.number_of_live_faces()) / double(wanted_faces_);
  if (context_.is_graded()) {
    // What grading and strips add, no table knows. Once the mesh has settled, the length takes it back step by step.
    constexpr unsigned FIRST_STEP = 3;
    constexpr double SMALLEST_STEP = 0.7, LARGEST_STEP = 1.6;
    if (report_.iterations >= FIRST_STEP)
      context_.target_length *= (std::max)(SMALLEST_STEP, (std::min)(LARGEST_STEP, std::sqrt(ratio)));
    return;
  }
  is_refined_ = is_refined_ || ratio < 1 / NEAR;
  if (is_refined_ || ratio > NEAR || ++steerings_ < 2) return;
  const double expected = 1.01 * double(wanted_faces_) * EXCESS[(std::min)(steerings_ - 1, SIZE - 1)];
  const double corrected = context_.target_length * std::sqrt(double(mesh_.number_of_live_faces()) / expected);
  context_.target_length = (std::max)(0.88 * first_target_length, (std::min)(1.15 * first_target_length, corrected));
}

template <class ConcurrencyTag>
void Remesher<ConcurrencyTag>::print_state(const std::string& name) const
{
  const Remeshing_report::Angles angles = angle_summary<ConcurrencyTag>(mesh_);
  std::cout << name << ": " << mesh_.number_of_live_faces() << " faces, angles "
            << angles.minimum << " to " << angles.maximum << ", average " << angles.average << "; so far "
            << report_.splits << " splits, " << report_.collapses << " collapses, " << report_.flips << " flips, "
            << report_.glides << " glides\n";
}

template <class ConcurrencyTag>
Run_result run_passes(Remeshing_context& context, const Schedule& schedule)
{
  Remesher<ConcurrencyTag> remesher(context, schedule);
  const Remeshing_report report = remesher.run();
  return {report, remesher.is_at_finest_level()};
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_REMESHER_H
