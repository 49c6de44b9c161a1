// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_SCHEDULE_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_SCHEDULE_H

#include <cstddef>
#include <functional>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// How a run goes, beside the recipe.
struct Schedule
{
  unsigned iterations;
  std::size_t wanted_faces;              // 0: the target length holds throughout
  std::function<bool(double)> callback;
  bool is_verbose;

  // Tells the callback that nothing is left to do; passes do that themselves.
  void tell_end() const { if (callback) callback(1); }
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_SCHEDULE_H
