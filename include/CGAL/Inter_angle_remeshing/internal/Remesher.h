// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_REMESHER_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_REMESHER_H

#include <CGAL/Inter_angle_remeshing/Remeshing_report.h>
#include <CGAL/Inter_angle_remeshing/internal/Clean_up.h>
#include <CGAL/Inter_angle_remeshing/internal/Iterations.h>
#include <CGAL/Inter_angle_remeshing/internal/Pass_runner.h>
#include <CGAL/Inter_angle_remeshing/internal/Remeshing_context.h>
#include <CGAL/Inter_angle_remeshing/internal/Run_clock.h>
#include <CGAL/Inter_angle_remeshing/internal/curves/curve_edges.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/angle_summary.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/crossing_faces.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/edge_lengths.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/Faults.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/angle_bands.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/bent_vertices.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/coarse_levels.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/projection_pass.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/relax_pass.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/spot_pass.h>
#include <CGAL/Inter_angle_remeshing/internal/run_passes.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/Surface_crossings.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

// A run: the iterations and the clean-up, at fine targets on a coarser level first, from which every face is cut into four.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

template <class ConcurrencyTag>
class Remesher
{
  using Index = Remeshing_mesh::Index;

public:
  // `untouched` is the report of a run that does nothing.
  Remesher(Remeshing_context& context, const Schedule& schedule, const Remeshing_report& untouched)
    : context_(context), mesh_(context.mesh), recipe_(context.recipe), schedule_(schedule), untouched_(untouched),
      clock_(schedule.iterations, context.recipe.clean_up), report_(untouched), passes_(context, schedule, clock_, report_),
      iterations_(context, schedule, clock_, report_, passes_), clean_up_(context, clock_, report_, passes_)
  {}

  Remeshing_report run()
  {
    report_.ending = Remeshing_report::Ending::completed;
    choose_levels();
    if (clock_.levels() == 0 || !succeeds_from_coarsest_level()) run_directly();
    if (is_at_finest_level()) finish();
    report_band(mesh_, Angle_bands(recipe_), report_);
    passes_.print_state("result");
    passes_.tell_end();
    return report_;
  }

  // Whether the mesh is one of the target length: cancelled before that, a run has nothing to show, and the mesh is the input.
  bool is_at_finest_level() const { return clock_.is_at_finest_level(); }

private:
  // As many pairs of crossing faces, for so many faces, are still parted on the finest level.
  static constexpr double FEW_CROSSINGS = 0.005;
  // Sweeps on a level between the coarsest and the finest one.
  static constexpr unsigned LEVEL_SWEEPS = 3;
  // On the finest level the limits of the edge lengths are wider by this factor: fewer vertices become irregular.
  static constexpr double FINEST_LIMITS = 1.3;

  void run_directly()
  {
    if (context_.grading_rate > 0 && schedule_.wanted_faces > 0) find_length_for_face_count();
    else iterate();
    if (goes_on() && recipe_.clean_up) clean_up_.run();
  }

  void iterate()
  {
    held_ = bent_vertices_between_long_edges(context_);
    hold();
    iterations_.run();
    release();
  }

  // How many faces grading adds at details of curves nobody knows beforehand. The length is not steered while they are looked at, as curves
  // would keep what they had at another one: the iterations begin anew with a better length, a few times.
  void find_length_for_face_count()
  {
    constexpr int MOST_TRIALS = 4;
    constexpr double CLOSE = 1.04;       // from here the clean-up meets the number
    // The number falls with some power of the length: with 2 where nothing is graded, with less the more curves have a say. After two trials
    // it is known, but may be nearly 0 where curves say all: no step is longer than that factor.
    constexpr double FIRST_POWER = 1.5, LEAST_POWER = 0.5, LARGEST_POWER = 2, LARGEST_FACTOR = 2.5;
    const Remeshing_mesh input = mesh_;
    double power = FIRST_POWER, last_length = 0, last_faces = 0;
    for (int trial = 1;; ++trial) {
      iterate();
      const double faces = double(mesh_.number_of_live_faces()), ratio = faces / double(schedule_.wanted_faces), length = context_.target_length;
      if (!goes_on() || trial == MOST_TRIALS || (ratio < CLOSE && CLOSE * ratio > 1)) return;
      if (trial > 1 && length != last_length && faces != last_faces)
        power = (std::max)(LEAST_POWER, (std::min)(LARGEST_POWER, -std::log(faces / last_faces) / std::log(length / last_length)));
      last_length = length;
      last_faces = faces;
      mesh_ = input;
      context_.target_length = length * (std::max)(1 / LARGEST_FACTOR, (std::min)(LARGEST_FACTOR, std::pow(ratio, 1 / power)));
      forget_what_was_done(0);
    }
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
        !context_.projector.moves_points()) return;
    const Coarse_levels coarse_levels = Coarse_levels::measure<ConcurrencyTag>(mesh_, context_.target_length);
    clock_.set_levels(coarse_levels.number(context_.target_length));
    if (clock_.levels() > 0 && !is_surface_far(context_))
      held_ = coarse_levels.bent_vertices(std::ldexp(context_.target_length, int(clock_.levels())));
  }

  // Returns false, with everything as it was before, where that has left faces, crossings, or distances from curves or corners, that
  // the direct way would hardly leave.
  bool succeeds_from_coarsest_level()
  {
    const Remeshing_mesh input = mesh_;
    const double target_length = context_.target_length;
    run_from_coarsest_level();
    const bool is_poor = goes_on() && (!is_at_finest_level() || clean_up_.is_given_up() || leaves_curves<ConcurrencyTag>(context_) ||
                                       (clean_up_.leaves_poor_spots() && has_poor_faces<ConcurrencyTag>(context_)) ||
                                       (report_.crossing_faces > 0 && has_new_crossings()));
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
    context_.kept_places = Kept_places();
    iterations_.begin_anew();
    clean_up_.begin_anew();
  }

  // The iterations on the coarsest level, and what little the others leave to do.
  void run_from_coarsest_level()
  {
    context_.target_length = std::ldexp(context_.target_length, int(clock_.levels()));
    hold();
    iterations_.run();
    if (goes_on()) clean_up_.mend_valences();
    passes_.polish();
    release();
    while (!is_at_finest_level() && goes_on()) {
      if (cuts_through_itself()) return;
      go_to_finer_level();
    }
    if (goes_on()) passes_.mend_beside_fixed_ends();
    if (goes_on() && recipe_.clean_up) clean_up_.run();
  }

  // Whether many more faces cross others than of the surface do: it is too thin for edges of this level.
  bool cuts_through_itself() const
  {
    if (!context_.projector.has_faces()) return false;
    const std::size_t few = std::size_t(FEW_CROSSINGS * double(mesh_.number_of_live_faces())),
                      pairs = crossing_faces<ConcurrencyTag>(mesh_).size();
    return pairs > few && pairs > few + crossing_faces<ConcurrencyTag>(*context_.projector.surface).size();
  }

  // Whether any face does where the surface does not.
  bool has_new_crossings() const
  {
    return context_.projector.has_faces() && Faults(context_).has_new_crossings<ConcurrencyTag>();
  }

  void go_to_finer_level()
  {
    clock_.start_finer_level();
    context_.target_length /= 2;
    passes_.subdivide();
    passes_.split_and_collapse(is_at_finest_level() ? FINEST_LIMITS : 1);
    passes_.flip(1, recipe_.glide_depth > 0);
    if (!(is_at_finest_level() && recipe_.clean_up)) {
      passes_.relax(LEVEL_SWEEPS, Pull_back::after_last_sweep);
      if (goes_on()) clean_up_.mend_spots();
    }
    passes_.print_state("level " + std::to_string(clock_.levels() - clock_.levels_left()));
  }

  void finish()
  {
    if (report_.ending == Remeshing_report::Ending::cancelled && !clean_up_.is_fitted()) passes_.pull_back();
    passes_.release_crests();
    if (mesh_.has_free_slots()) mesh_.renumber<ConcurrencyTag>(mesh_.block_order());
    report_.output_faces = mesh_.number_of_live_faces();
    report_.target_edge_length = context_.keeps_vertices ? 0. : mesh_.unit() * context_.target_length;
    report_.angles_after = angle_summary<ConcurrencyTag>(mesh_);
  }

  bool goes_on() const { return passes_.goes_on(); }

  Remeshing_context& context_;
  Remeshing_mesh& mesh_;
  const Recipe& recipe_;
  const Schedule& schedule_;
  const Remeshing_report& untouched_;
  Run_clock clock_;
  Remeshing_report report_;
  Pass_runner<ConcurrencyTag> passes_;
  Iterations<ConcurrencyTag> iterations_;
  Clean_up<ConcurrencyTag> clean_up_;
  std::vector<Index> held_;              // vertices that stay where they are in the iterations
};

// Whether sweeps may move the spikes of the input: those of noise that makes this part of its faces cross others, and all where the target
// is longer than its edges by this factor, and cannot resolve them. Else, as on rugged terrain, they are its shape.
template <class ConcurrencyTag>
bool moves_spikes(const Remeshing_context& context)
{
  constexpr double LEAST_SHARE = 0.02, COARSER = 1.4;
  if (!(context.noise > LITTLE_NOISE)) return false;
  return context.target_length > COARSER * mean_edge_length(context.mesh) ||
         double(faces_of(crossing_faces<ConcurrencyTag>(context.mesh)).size()) > LEAST_SHARE * double(context.mesh.number_of_live_faces());
}

template <class ConcurrencyTag>
Run_result run_passes(Remeshing_context& context, const Schedule& schedule, const Remeshing_report& untouched)
{
  context.moves_spikes = moves_spikes<ConcurrencyTag>(context);
  Remesher<ConcurrencyTag> remesher(context, schedule, untouched);
  const Remeshing_report report = remesher.run();
  return {report, remesher.is_at_finest_level()};
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_REMESHER_H
