// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_RUN_CLOCK_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_RUN_CLOCK_H

#include <algorithm>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// How far a run is: iterations on the coarsest level, then the finer levels, one by one.
class Run_clock
{
  // Iterations at the end that relax longest, flip in several rounds, and settle what is left to split.
  static constexpr unsigned LAST_ITERATIONS = 2;
  // Passes of an iteration without rounds of flips, and of such a round.
  static constexpr double PASSES = 3, PASSES_OF_ROUND = 2;

public:
  explicit Run_clock(unsigned iterations) : last_iteration_(iterations) {}

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

  void end_pass(unsigned flip_rounds)
  {
    const double part = (std::min)(1., ++passes_ / (PASSES + PASSES_OF_ROUND * flip_rounds)), iterations = last_iteration_;
    const double done = levels_left_ == levels_ ? (std::min)(iterations_ + part, iterations)
                                                : iterations + (levels_ - levels_left_ - 1) + part;
    progress_ = (std::max)(progress_, done / (iterations + levels_));
  }

  // In [0, 1]; it never falls, also where a run begins anew.
  double progress() const { return progress_; }

  void begin_anew(unsigned iterations, unsigned levels)
  {
    iterations_ = 0;
    last_iteration_ = iterations;
    set_levels(levels);
  }

private:
  unsigned iterations_ = 0, last_iteration_;    // how many are made, unless the run is cancelled
  unsigned levels_ = 0, levels_left_ = 0;
  unsigned passes_ = 0;                         // done in this iteration, or on this level
  double progress_ = 0;
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_RUN_CLOCK_H
