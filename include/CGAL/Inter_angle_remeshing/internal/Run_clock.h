// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_RUN_CLOCK_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_RUN_CLOCK_H

#include <algorithm>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// How far a run is: iterations on the coarsest level, then the finer levels, one by one, then the clean-up.
class Run_clock
{
  // Iterations at the end that relax longest, flip in several rounds, and settle what is left to split.
  static constexpr unsigned LAST_ITERATIONS = 2;
  // What a level and the clean-up take, in iterations, those of the clean-up for each that is made: of ten models at their own
  // length it takes 44% of the time.
  static constexpr double LEVEL = 1, CLEAN_UP = 0.8;
  // Passes of an iteration without rounds of flips, of such a round, and of the clean-up.
  static constexpr double PASSES = 3, PASSES_OF_ROUND = 2, PASSES_OF_CLEAN_UP = 10;
  // The part of the clean-up that passes can do; the rest is told when none is left.
  static constexpr double LARGEST_PART = 0.99;

public:
  Run_clock(unsigned iterations, bool has_clean_up) : last_iteration_(iterations), has_clean_up_(has_clean_up) {}

  unsigned iterations() const { return iterations_; }
  bool has_iterations_left() const { return iterations_ < last_iteration_; }
  // Before that, the angles around a vertex are those of the mesh rather than of the surface.
  bool is_half_done() const { return 2 * iterations_ >= last_iteration_; }
  bool is_late() const { return iterations_ + LAST_ITERATIONS >= last_iteration_; }

  void start_iteration() { passes_ = 0; }
  void end_iteration() { ++iterations_; }
  // After the iteration at hand only the last ones are left to do.
  void hurry() { last_iteration_ = (std::min)(last_iteration_, iterations_ + 1 + LAST_ITERATIONS); }

  // Levels between the one that the run is at and that of the target length, and how many it goes through in all.
  unsigned levels_left() const { return levels_left_; }
  unsigned levels() const { return levels_; }
  bool is_at_finest_level() const { return levels_left_ == 0; }

  void set_levels(unsigned levels) { levels_ = levels_left_ = levels; }
  void start_finer_level()
  {
    passes_ = 0;
    --levels_left_;
  }

  void start_clean_up()
  {
    passes_ = 0;
    is_cleaning_up_ = true;
  }

  void end_pass(unsigned flip_rounds)
  {
    const double passes = is_cleaning_up_ ? PASSES_OF_CLEAN_UP : PASSES + PASSES_OF_ROUND * flip_rounds;
    const double part = (std::min)(is_cleaning_up_ ? LARGEST_PART : 1., ++passes_ / passes),
                 iterations = last_iteration_, finest = iterations + LEVEL * levels_,
                 clean_up = has_clean_up_ ? CLEAN_UP * iterations : 0;
    const double done = is_cleaning_up_        ? finest + part * clean_up :
                        levels_left_ < levels_ ? iterations + LEVEL * (levels_ - levels_left_ - 1 + part) :
                                                 (std::min)(iterations_ + part, iterations);
    progress_ = (std::max)(progress_, done / (finest + clean_up));
  }

  // In [0, 1]; it never falls, also where a run begins anew.
  double progress() const { return progress_; }

  void begin_anew(unsigned iterations, unsigned levels)
  {
    iterations_ = 0;
    last_iteration_ = iterations;
    is_cleaning_up_ = false;
    set_levels(levels);
  }

private:
  unsigned iterations_ = 0, last_iteration_;    // how many are made, unless the run is cancelled
  unsigned levels_ = 0, levels_left_ = 0;
  bool has_clean_up_, is_cleaning_up_ = false;
  unsigned passes_ = 0;                         // done in this iteration, on this level, or in the clean-up
  double progress_ = 0;
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_RUN_CLOCK_H
