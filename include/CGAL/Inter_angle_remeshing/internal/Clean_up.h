// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_CLEAN_UP_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_CLEAN_UP_H

#include <CGAL/Inter_angle_remeshing/Recipe.h>
#include <CGAL/Inter_angle_remeshing/Remeshing_report.h>
#include <CGAL/Inter_angle_remeshing/internal/Pass_runner.h>
#include <CGAL/Inter_angle_remeshing/internal/Remeshing_context.h>
#include <CGAL/Inter_angle_remeshing/internal/Run_clock.h>
#include <CGAL/Inter_angle_remeshing/internal/curves/curve_edges.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/lost_surface.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/repair_pass.h>

#include <cmath>
#include <cstddef>

// What is done once the iterations have ended: low valences go, faces are fitted to the surface, angles are brought into the band, large
// distances lowered, crossing faces parted, and the number of faces met.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

template <class ConcurrencyTag>
class Clean_up
{
  // Sweeps once low valences are gone.
  static constexpr unsigned SWEEPS = 3;
  // What is further from the wanted number of faces when faces are mended, as a part of it, is corrected, and its faces are mended
  // again, up to so many times.
  static constexpr double RECOUNTED = 0.01;
  static constexpr int MOST_RECOUNTS = 8;

public:
  Clean_up(Remeshing_context& context, Run_clock& clock, Remeshing_report& report, Pass_runner<ConcurrencyTag>& passes)
    : context_(context), mesh_(context.mesh), recipe_(context.recipe), clock_(clock), report_(report), passes_(passes)
  {}

  void run()
  {
    clock_.start_clean_up();
    mesh_.settle_rim();
    passes_.measure_grading();
    mend_valences();
    if (passes_.goes_on() && clock_.levels() > 0) mend_spots();
    is_given_up_ = leaves_poor_spots_ && loses_surface(context_);
    if (is_given_up_) return;
    passes_.release_crests();
    context_.kept_places.note(mesh_);
    mend_faces();
    for (int round = 0; round < MOST_RECOUNTS && passes_.goes_on() && misses_face_count(); ++round) {
      if (passes_.meet_face_count() == 0) break;
      passes_.measure_grading();
      passes_.flip(1, false);
      mend_faces();
    }
  }

  void mend_valences()
  {
    passes_.remove_low_valences();
    if (clock_.is_at_finest_level()) passes_.meet_face_count();
    passes_.flip(1, false);
    if (recipe_.sweeps > 0) passes_.relax(SWEEPS, Pull_back::after_last_sweep);
  }

  // Whether vertices need no longer lie on the surface.
  bool is_fitted() const { return is_fitted_; }
  // Whether the spots' own iterations did not get the better of some.
  bool leaves_poor_spots() const { return leaves_poor_spots_; }
  // Whether these are those of a surface of which something is lost.
  bool is_given_up() const { return is_given_up_; }
  void mend_spots() { leaves_poor_spots_ = !passes_.mend_spots(); }

  void begin_anew() { is_fitted_ = leaves_poor_spots_ = is_given_up_ = false; }

private:
  bool misses_face_count() const
  {
    const std::size_t faces = mesh_.number_of_live_faces(), wanted = passes_.wanted_faces();
    return wanted > 0 && std::abs(double(faces) - double(wanted)) > RECOUNTED * double(wanted) + 1 &&
           !is_due_to_curves(mesh_, faces, wanted);
  }

  void mend_faces()
  {
    report_.are_crossing_faces_known = false;      // of faces that were mended before
    report_.crossing_faces = 0;
    is_fitted_ = is_fitted_ || passes_.goes_on();
    fit_and_polish();
    if (passes_.has_heaps()) {
      repair_once();
      if (passes_.mend_heaps()) fit_and_polish();
    }
    if (passes_.remove_middles_of_strips() > 0) passes_.polish();
    Repairer repairer(context_, report_.input_faces);
    passes_.repair(repairer);
    if (passes_.lower_distances() > 0) passes_.repair(repairer);
    passes_.part_crossing_faces(repairer);
  }

  void fit_and_polish()
  {
    passes_.fit();
    passes_.polish();
  }

  void repair_once()
  {
    Repairer repairer(context_, report_.input_faces);
    passes_.repair(repairer);
  }

  Remeshing_context& context_;
  Remeshing_mesh& mesh_;
  const Recipe& recipe_;
  Run_clock& clock_;
  Remeshing_report& report_;
  Pass_runner<ConcurrencyTag>& passes_;
  bool is_fitted_ = false, leaves_poor_spots_ = false, is_given_up_ = false;
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_CLEAN_UP_H
