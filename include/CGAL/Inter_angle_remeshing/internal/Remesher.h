// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_REMESHER_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_REMESHER_H

#include <CGAL/Inter_angle_remeshing/Remeshing_report.h>
#include <CGAL/Inter_angle_remeshing/internal/Face_count_steering.h>
#include <CGAL/Inter_angle_remeshing/internal/Pass_runner.h>
#include <CGAL/Inter_angle_remeshing/internal/Remeshing_context.h>
#include <CGAL/Inter_angle_remeshing/internal/Run_clock.h>
#include <CGAL/Inter_angle_remeshing/internal/angle_bands.h>
#include <CGAL/Inter_angle_remeshing/internal/angle_summary.h>
#include <CGAL/Inter_angle_remeshing/internal/bent_vertices.h>
#include <CGAL/Inter_angle_remeshing/internal/coarse_levels.h>
#include <CGAL/Inter_angle_remeshing/internal/crossing_faces.h>
#include <CGAL/Inter_angle_remeshing/internal/curve_edges.h>
#include <CGAL/Inter_angle_remeshing/internal/edge_lengths.h>
#include <CGAL/Inter_angle_remeshing/internal/repair_pass.h>
#include <CGAL/Inter_angle_remeshing/internal/run_passes.h>
#include <CGAL/Inter_angle_remeshing/internal/space_filling_order.h>
#include <CGAL/Inter_angle_remeshing/internal/spot_pass.h>

#include <cmath>
#include <cstddef>
#include <iostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// The passes in order: iterations, on a coarser level perhaps, then the clean-up.
template <class ConcurrencyTag>
class Remesher
{
  using Index = Remeshing_mesh::Index;

public:
  // `untouched` is the report of a run that does nothing.
  Remesher(Remeshing_context& context, const Schedule& schedule, const Remeshing_report& untouched)
    : context_(context), mesh_(context.mesh), recipe_(context.recipe), schedule_(schedule), untouched_(untouched),
      clock_(schedule.iterations, context.recipe.clean_up), report_(untouched), passes_(context, schedule, clock_, report_)
  {}

  Remeshing_report run()
  {
    report_.ending = Remeshing_report::Ending::completed;
    choose_levels();
    if (clock_.levels() == 0 || !succeeds_from_coarsest_level()) run_directly();
    if (is_at_finest_level()) finish();
    report_band(mesh_, Angle_bands(recipe_), report_);
    passes_.tell_end();
    return report_;
  }

  // Whether the mesh is one of the target length: cancelled before that, a run has nothing to show, and the mesh is the input.
  bool is_at_finest_level() const { return clock_.is_at_finest_level(); }

private:
  // The iteration from which on glides pay: before, splits and collapses stir the valences up too much.
  static constexpr unsigned FIRST_GLIDES = 2;
  // Once an iteration does no more than one operation for so many faces, only the last ones are left to do.
  static constexpr std::size_t SETTLED = 1000;
  // If an iteration does hardly anything while many faces are out of the band, the mesh is disturbed once: by splits for .9, or, if too
  // dense, by collapses for 1.25 of the length. Hardly anything: one operation for so many faces; many: this part of the faces.
  static constexpr std::size_t HARDLY_MOVING = 100;
  static constexpr double SKEWED = 0.1, STIRRED_BY_SPLITS = 0.9, STIRRED_BY_COLLAPSES = 1.25;
  // A mesh of more than so many times the faces that its area asks for is coarsened in up to so many rounds, as long as each leaves
  // less than this part of the faces.
  static constexpr double TOO_DENSE = 1.5, COARSENED = 0.97;
  static constexpr int MOST_COARSENINGS = 8;
  // Sweeps after the clean-up.
  static constexpr unsigned CLEAN_UP_SWEEPS = 3;
  // What is further from the wanted number of faces when faces are mended, as a part of it, is corrected, and its faces are mended
  // again, up to so many times.
  static constexpr double RECOUNTED = 0.01;
  static constexpr int MOST_RECOUNTS = 3;
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

  // Levels pay where the faces that come out of the iterations can be cut into four as they are.
  void choose_levels()
  {
    if (!recipe_.multi_level || !context_.may_subdivide || recipe_.sweeps == 0 || context_.is_graded() ||
        has_protected_edges()) return;
    const Coarse_levels coarse_levels = Coarse_levels::measure<ConcurrencyTag>(mesh_, context_.target_length);
    clock_.set_levels(coarse_levels.number(context_.target_length));
    if (clock_.levels() > 0)
      held_ = coarse_levels.bent_vertices(std::ldexp(context_.target_length, int(clock_.levels())));
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
    forget_what_was_done(is_poor ? 0 : clock_.levels_left());
    return !is_poor;
  }

  void forget_what_was_done(unsigned levels)
  {
    const Remeshing_report::Ending ending = report_.ending;
    report_ = untouched_;
    report_.ending = ending;
    report_.target_edge_length = mesh_.unit() * context_.target_length;
    clock_.begin_anew(schedule_.iterations, levels);
    operations_in_order_ = 0;
    context_.kept_places = Kept_places();
    is_fitted_ = is_stirred_up_ = is_only_split_ = has_poor_spots_ = false;
  }

  // The iterations on the coarsest level, and what little the others leave to do.
  void run_from_coarsest_level()
  {
    context_.target_length = std::ldexp(context_.target_length, int(clock_.levels()));
    hold();
    make_iterations();
    if (goes_on()) mend_valences();
    passes_.polish();
    release();
    while (!is_at_finest_level() && goes_on()) {
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
    clock_.start_finer_level();
    context_.target_length /= 2;
    passes_.subdivide();
    split_and_collapse(is_at_finest_level() ? FINEST_LIMITS : 1);
    passes_.flip(1, recipe_.glide_depth > 0);
    if (!(is_at_finest_level() && recipe_.clean_up)) {
      passes_.relax(LEVEL_SWEEPS, Pull_back::after_last_sweep);
      if (goes_on()) mend_spots();
    }
    if (schedule_.is_verbose) print_state("level " + std::to_string(clock_.levels() - clock_.levels_left()));
  }

  void make_iterations()
  {
    Face_count_steering steering(context_.target_length);
    while (clock_.has_iterations_left() && goes_on()) {
      steering.steer(context_, clock_, wanted_faces());
      iterate();
    }
  }

  // On this level; 0: any.
  std::size_t wanted_faces() const { return schedule_.wanted_faces >> (2 * clock_.levels_left()); }

  void iterate()
  {
    const std::size_t operations = number_of_operations();
    clock_.start_iteration();
    context_.visitor.start_iteration(clock_.iterations(), mesh_);
    if (clock_.is_late() && is_at_finest_level()) passes_.release_features();
    const int halvings = clock_.iterations() == 0 || is_only_split_ ? halvings_to_do() : 0;
    split_and_collapse();
    is_only_split_ = is_only_to_be_split(halvings);
    if (clock_.is_late() && number_of_operations() > operations) settle_lengths();
    order_elements();
    if (clock_.is_late() || !is_only_split_) {
      passes_.flip(passes_.flip_rounds(), recipe_.glide_depth > 0 && (clock_.iterations() >= FIRST_GLIDES || clock_.is_late()));
      relax();
    }
    const std::size_t done = number_of_operations() - operations, faces = mesh_.number_of_live_faces();
    if (goes_on() && !context_.keeps_vertices && !clock_.is_late()) {
      if (!is_stirred_up_ && done <= faces / HARDLY_MOVING && is_skewed()) stir_up();
      else if (done <= faces / SETTLED) clock_.hurry();
    }
    context_.visitor.end_iteration(clock_.iterations(), mesh_);
    clock_.end_iteration();
    report_.iterations = clock_.iterations();
    if (schedule_.is_verbose) print_state("iteration " + std::to_string(clock_.iterations()));
  }

  std::size_t number_of_operations() const
  {
    return report_.splits + report_.collapses + report_.flips + report_.glides;
  }

  std::size_t split_and_collapse(double widening = 1)
  {
    const std::size_t splits = passes_.split_and_collapse(widening);
    if (clock_.is_late()) meet_face_count();
    return splits;
  }

  void meet_face_count()
  {
    if (wanted_faces() > 0) passes_.meet_face_count(wanted_faces());
  }

  void relax()
  {
    // Between the passes of the early iterations, being a little off the surface does no harm.
    const bool is_pulled_back = clock_.is_late() || clock_.iterations() % 2 == 0;
    passes_.relax(clock_.is_late() ? recipe_.last_sweeps : recipe_.sweeps,
                  is_pulled_back ? Pull_back::after_last_sweep : Pull_back::never);
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
    even_out();
  }

  // What splits and collapses leave, before the next ones.
  void even_out()
  {
    passes_.flip(1, false);
    passes_.relax(recipe_.sweeps, Pull_back::after_last_sweep);
  }

  // An iteration halves edges, and merges a vertex with few of those around it. What is far too long or far too dense even when
  // the last iterations begin goes through as many short ones as it takes, so that those work on a mesh of about the target
  // length. Each should halve the longest edge, or take away faces; where policies do not let it, the rounds end all the same.
  void settle_lengths()
  {
    int halvings = halvings_to_do();
    for (int round = halvings + MOST_COARSENINGS; round > 0 && goes_on() && (halvings > 0 || is_too_dense()); --round) {
      even_out();
      const std::size_t faces = mesh_.number_of_live_faces(), splits = split_and_collapse();
      if ((halvings == 0 || splits == 0) && double(mesh_.number_of_live_faces()) > COARSENED * double(faces)) return;
      halvings = halvings_to_do();
    }
  }

  bool is_too_dense() const
  {
    return !context_.collapse_rule.is_never() &&
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
    if (context_.split_rule.is_never()) return 0;
    const double ratio = longest_edge_in_targets(mesh_, [&](Index u, Index v) { return context_.length_at(u, v); }) /
                         recipe_.split_ratio;
    return ratio > 2 ? 1 + int(std::log2(ratio)) : 0;
  }

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

  void clean_up()
  {
    clock_.start_clean_up();
    passes_.measure_grading();
    mend_valences();
    if (goes_on() && clock_.levels() > 0) mend_spots();
    passes_.release_crests();
    context_.kept_places.note(mesh_);
    mend_faces();
    for (int round = 0; round < MOST_RECOUNTS && goes_on() && misses_face_count(); ++round) {
      meet_face_count();
      passes_.measure_grading();
      passes_.flip(1, false);
      mend_faces();
    }
  }

  bool misses_face_count() const
  {
    const std::size_t faces = mesh_.number_of_live_faces(), wanted = wanted_faces();
    return wanted > 0 && std::abs(double(faces) - double(wanted)) > RECOUNTED * double(wanted) + 1 &&
           !is_due_to_curves(mesh_, faces, wanted);
  }

  void mend_faces()
  {
    report_.are_crossing_faces_known = false;      // of faces that were mended before
    report_.crossing_faces = 0;
    is_fitted_ = is_fitted_ || goes_on();
    passes_.fit();
    passes_.polish();
    Repairer repairer(context_, report_.input_faces);
    passes_.repair(repairer);
    if (passes_.lower_distances() > 0) passes_.repair(repairer);
    passes_.part_crossing_faces(repairer);
  }

  void mend_valences()
  {
    passes_.remove_low_valences();
    if (is_at_finest_level()) meet_face_count();
    passes_.flip(1, false);
    if (recipe_.sweeps > 0) passes_.relax(CLEAN_UP_SWEEPS, Pull_back::after_last_sweep);
  }

  void mend_spots() { has_poor_spots_ = !passes_.mend_spots(); }

  void finish()
  {
    if (report_.ending == Remeshing_report::Ending::cancelled && !is_fitted_) passes_.pull_back();
    passes_.release_crests();
    if (mesh_.has_free_slots()) mesh_.renumber<ConcurrencyTag>(mesh_.block_order());
    report_.output_faces = mesh_.number_of_live_faces();
    report_.target_edge_length = context_.keeps_vertices ? 0. : mesh_.unit() * context_.target_length;
    report_.angles_after = angle_summary<ConcurrencyTag>(mesh_);
  }

  bool goes_on() const { return passes_.goes_on(); }

  void print_state(const std::string& name) const
  {
    const Remeshing_report::Angles angles = angle_summary<ConcurrencyTag>(mesh_);
    std::cout << name << ": " << mesh_.number_of_live_faces() << " faces, angles "
              << angles.minimum << " to " << angles.maximum << ", average " << angles.average << "; so far "
              << report_.splits << " splits, " << report_.collapses << " collapses, " << report_.flips << " flips, "
              << report_.glides << " glides\n";
  }

  Remeshing_context& context_;
  Remeshing_mesh& mesh_;
  const Recipe& recipe_;
  const Schedule& schedule_;
  const Remeshing_report& untouched_;
  Run_clock clock_;
  Remeshing_report report_;
  Pass_runner<ConcurrencyTag> passes_;
  std::vector<Index> held_;              // vertices that stay where they are in the iterations
  bool is_fitted_ = false;               // from then on, vertices need not lie on the surface
  bool is_stirred_up_ = false;           // once only
  bool is_only_split_ = false;           // in this iteration
  bool has_poor_spots_ = false;          // of which the spots' own iterations did not get the better
  std::size_t operations_in_order_ = 0;  // splits and collapses before the last ordering
};

template <class ConcurrencyTag>
Run_result run_passes(Remeshing_context& context, const Schedule& schedule, const Remeshing_report& untouched)
{
  Remesher<ConcurrencyTag> remesher(context, schedule, untouched);
  const Remeshing_report report = remesher.run();
  return {report, remesher.is_at_finest_level()};
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_REMESHER_H
