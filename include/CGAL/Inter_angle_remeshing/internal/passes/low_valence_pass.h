// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_LOW_VALENCE_PASS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_LOW_VALENCE_PASS_H

#include <CGAL/Inter_angle_remeshing/internal/mesh/regular_valence.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/collapse_pass.h>

#include <CGAL/number_utils.h>

#include <limits>

// After the last iteration: removes free vertices of valence 4 and less, which are too poor to become regular, where
// that lowers the sum of the squared valence deviations.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

constexpr int POOR_VALENCE = 4;
// New edges of this many target lengths are let pass: the sweeps that follow even them out.
constexpr double CLEAN_UP_LENGTH = 2;

// By how much merging the source of h into its target changes the sum of the squared valence deviations.
inline int collapse_gain(const Remeshing_mesh& mesh, Remeshing_mesh::Index h)
{
  using Index = Remeshing_mesh::Index;
  const Index a = mesh.origin(h);
  const Index o = mesh.opposite(h);
  const int at_a = mesh.deviation(a), at_b = sector_deviation(mesh, o);
  int gain = CGAL::square(at_b + mesh.valence(a) - 4) - CGAL::square(at_a) - CGAL::square(at_b);
  for (const Index k : {mesh.prev(h), mesh.prev(o)}) {
    const int at_apex = sector_deviation(mesh, k);
    gain += CGAL::square(at_apex - 1) - CGAL::square(at_apex);
  }
  return gain;
}

// Returns the number of collapses.
template <class ConcurrencyTag>
std::size_t low_valence_pass(Remeshing_context& context)
{
  using Index = Remeshing_mesh::Index;
  Remeshing_mesh& mesh = context.mesh;
  const double length = context.target_length;
  const Collapse_limits limits{CGAL::square(CLEAN_UP_LENGTH * length), CGAL::square(context.collapse_tolerance()), MAXIMUM_MERGED_VALENCE};
  std::size_t collapses = 0;
  measure_regular_valences<ConcurrencyTag>(mesh, context.recipe.curvature_valences);
  for (Index v = 0; v < Index(mesh.number_of_vertex_slots()); ++v) {
    if (!mesh.is_vertex(v) || !mesh.is_free(v) || mesh.valence(v) > POOR_VALENCE) continue;
    Index best = NO_COLLAPSE;
    int best_gain = 0;
    mesh.for_each_around(v, [&](Index h) {
      const int gain = collapse_gain(mesh, h);
      if (gain >= best_gain || !is_collapse_fit(mesh, h, context.grading, limits) || !mesh.is_collapse_legal(h) ||
          !context.permits_collapse(h)) return;
      best = h;
      best_gain = gain;
    });
    if (best == NO_COLLAPSE) continue;
    collapse(context, best);
    ++collapses;
  }
  return collapses;
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_LOW_VALENCE_PASS_H
