// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_ARGUMENTS_REFUSE_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_ARGUMENTS_REFUSE_H

#include <CGAL/exceptions.h>

#include <cstdio>
#include <string>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

constexpr const char* REMESHING = "isotropic_remeshing()";

// Refuses an argument in words, in release builds too: CGAL's own checks vanish with NDEBUG.
[[noreturn]] inline void refuse(const char* function, const std::string& what_is_wrong)
{
  throw CGAL::Precondition_exception("Inter_angle_remeshing", function, __FILE__, __LINE__, what_is_wrong);
}

// A value as it is told in a refusal: std::to_string() makes 0 of a small one.
inline std::string to_text(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_ARGUMENTS_REFUSE_H
