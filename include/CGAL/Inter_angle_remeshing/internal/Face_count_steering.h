// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_FACE_COUNT_STEERING_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_FACE_COUNT_STEERING_H

#include <CGAL/Inter_angle_remeshing/internal/Remeshing_context.h>
#include <CGAL/Inter_angle_remeshing/internal/Run_clock.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// Corrects the target length between iterations such that the number of faces comes out as wanted.
//
// The number of faces falls from iteration to iteration as the mesh grows regular; measured, it lies above its final
// value by the factors in the table. What differs from that, half of it on a logarithmic scale, corrects the length.
class Face_count_steering
{
  static constexpr double EXCESS[] = {1.075, 1.045, 1.03, 1.018, 1.012, 1.007};     // from the second iteration on
  static constexpr std::size_t SIZE = sizeof(EXCESS) / sizeof(EXCESS[0]);
  // Until the count is this near, the mesh is still being coarsened, and says nothing about the length. One that is
  // refined comes from below, where the table does not hold, but the length that the run began with does, within 1%.
  static constexpr double CLOSE_RATIO = 1.3;
  // How far the length goes from the first one.
  static constexpr double SHORTEST = 0.88, LONGEST = 1.15;
  // What grading and strips add, and spikes of noise that go late take away, no table knows. From this iteration on, when the mesh has
  // settled, the length takes it back step by step, each within these factors.
  static constexpr unsigned FIRST_STEP = 3;
  static constexpr double SMALLEST_STEP = 0.7, LARGEST_STEP = 1.6;

public:
  explicit Face_count_steering(double first_target_length) : first_target_length_(first_target_length) {}

  void steer(Remeshing_context& context, const Run_clock& clock, std::size_t wanted_faces)
  {
    if (wanted_faces == 0 || clock.iterations() == 0 || clock.is_late()) return;
    const double faces = double(context.mesh.number_of_live_faces()), ratio = faces / double(wanted_faces);
    double& length = context.target_length;
    if (context.grading_rate > 0) return;
    if (context.is_graded() || context.spike_factor > 1) {
      if (clock.iterations() >= FIRST_STEP) length *= (std::max)(SMALLEST_STEP, (std::min)(LARGEST_STEP, std::sqrt(ratio)));
      return;
    }
    is_refined_ = is_refined_ || ratio < 1 / CLOSE_RATIO;
    if (is_refined_ || ratio > CLOSE_RATIO || ++steerings_ < 2) return;
    const double expected = 1.01 * double(wanted_faces) * EXCESS[(std::min)(steerings_ - 2, SIZE - 1)];
    length *= std::sqrt(faces / expected);
    length = (std::max)(SHORTEST * first_target_length_, (std::min)(LONGEST * first_target_length_, length));
  }

private:
  double first_target_length_;
  bool is_refined_ = false;              // by so much that the number of faces is not steered
  std::size_t steerings_ = 0;            // iterations since the number of faces came near the wanted one
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_FACE_COUNT_STEERING_H
