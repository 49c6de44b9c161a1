// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_EVALUATE_THEN_APPLY_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_EVALUATE_THEN_APPLY_H

#include <CGAL/Inter_angle_remeshing/internal/mesh/Remeshing_mesh.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/parallel_blocks.h>

#include <type_traits>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// Candidates that one task evaluates: each costs some 100 ns.
constexpr std::size_t EVALUATION_BLOCK = 128;

// Takes candidate half-edges one after the other: `apply(h, evaluate(h))`, as if each was evaluated on the mesh that
// the ones before it left. `apply` may append to `candidates`. In parallel all are evaluated beforehand, on the mesh
// as it is, and evaluated anew only where an application changed what the evaluation reads, see Remeshing_mesh::is_touched(). The result
// is the same.
template <class ConcurrencyTag, class Evaluate, class Apply>
void evaluate_then_apply(Remeshing_mesh& mesh, std::vector<Remeshing_mesh::Index>& candidates,
                         const Evaluate& evaluate, const Apply& apply)
{
  if constexpr (!is_parallel<ConcurrencyTag>()) {
    for (std::size_t i = 0; i < candidates.size(); ++i)
      apply(candidates[i], evaluate(candidates[i]));
  } else {
    using Answer = std::decay_t<decltype(evaluate(Remeshing_mesh::Index()))>;
    // The bools of a vector<bool> share words, which several threads would write.
    using Decision = std::conditional_t<std::is_same<Answer, bool>::value, char, Answer>;
    const std::size_t n = candidates.size();
    std::vector<Decision> decisions(n);
    for_each_block<ConcurrencyTag>(n, EVALUATION_BLOCK, [&](std::size_t begin, std::size_t end, std::size_t) {
      for (std::size_t i = begin; i < end; ++i) decisions[i] = evaluate(candidates[i]);
    });
    mesh.start_recording_touched();
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      const Remeshing_mesh::Index h = candidates[i];
      apply(h, i < n && !mesh.is_touched(h) ? Answer(decisions[i]) : evaluate(h));
    }
    mesh.stop_recording_touched();
  }
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_EVALUATE_THEN_APPLY_H
