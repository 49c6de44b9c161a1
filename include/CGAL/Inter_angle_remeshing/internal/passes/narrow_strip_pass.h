// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_NARROW_STRIP_PASS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_NARROW_STRIP_PASS_H

#include <CGAL/Inter_angle_remeshing/internal/geometry/thin_angles.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/collapse_pass.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>

// After the polish: a strip between two curves that is a little narrower than the target length, such as a side of a bar, has a row of
// vertices in its middle where the edges across are too long to be collapsed, by little, and their halves are needles' short sides.
// These vertices go where that leaves better faces.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// What a needle is: its least angle is under 25 degrees. The squares of the sine of that, and of what is gained at least.
constexpr double NEEDLE_SQUARED_SINE = 0.178606194892, NEEDLE_SQUARED_GAIN = 1.5;
// In target lengths: the longest new edge, and how far the strip may be from flat.
constexpr double LONGEST_ACROSS_STRIP = 1.7, FLAT_STRIP = 0.05;

// How v, a free vertex, is to be merged into a neighbor, where all of these lie on curves and one of its faces is a needle.
inline Remeshing_mesh::Index collapse_onto_curve(const Remeshing_context& context, Remeshing_mesh::Index v, const Collapse_limits& limits)
{
  using Index = Remeshing_mesh::Index;
  const Remeshing_mesh& mesh = context.mesh;
  if (!mesh.all_around(v, [&](Index h) { return mesh.is_on_curve(mesh.target(h)); })) return NO_COLLAPSE;
  const auto squared_sine = [&](Index a, Index b, Index c) {
    return squared_sine_of_smallest_angle(mesh.position(a), mesh.position(b), mesh.position(c)); };
  double before = 1;
  mesh.for_each_around(v, [&](Index h) { before = (std::min)(before, squared_sine(v, mesh.target(h), mesh.apex(h))); });
  if (before > NEEDLE_SQUARED_SINE) return NO_COLLAPSE;
  Index best = NO_COLLAPSE;
  double most = NEEDLE_SQUARED_GAIN * before;
  mesh.for_each_around(v, [&](Index h) {
    double after = 1;
    mesh.all_faces_of_collapse(h, [&](Index c, Index d) {
      after = (std::min)(after, squared_sine(mesh.target(h), c, d));
      return true;
    });
    if (after < most || !is_collapse_allowed(context, h, limits)) return;
    best = h;
    most = after;
  });
  return best;
}

// Returns the number of collapses.
inline std::size_t narrow_strip_pass(Remeshing_context& context)
{
  using Index = Remeshing_mesh::Index;
  Remeshing_mesh& mesh = context.mesh;
  const double length = context.target_length;
  const Collapse_limits limits{CGAL::square(LONGEST_ACROSS_STRIP * length), CGAL::square(FLAT_STRIP * length), MAXIMUM_MERGED_VALENCE};
  std::size_t collapses = 0;
  for (Index v = 0; v < Index(mesh.number_of_vertex_slots()); ++v) {
    if (!mesh.is_vertex(v) || !mesh.is_free(v)) continue;
    const Index h = collapse_onto_curve(context, v, limits);
    if (h == NO_COLLAPSE) continue;
    collapse(context, h);
    ++collapses;
  }
  return collapses;
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_NARROW_STRIP_PASS_H
