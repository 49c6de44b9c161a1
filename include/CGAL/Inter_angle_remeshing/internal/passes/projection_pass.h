// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_PROJECTION_PASS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_PROJECTION_PASS_H

#include <CGAL/Inter_angle_remeshing/internal/Remeshing_context.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/cross_products.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/parallel_blocks.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <vector>

// The way onto a surface that is not where the mesh is, as a projector of the user's may say. All vertices go together: one alone, by more
// than a target length, would turn the faces around it.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// Whether a tenth of some vertices are further from the surface than the target length: fewer are tips and noise, which the passes see to.
inline bool is_surface_far(const Remeshing_context& context)
{
  using Index = Remeshing_mesh::Index;
  constexpr Index SAMPLES = 64;
  constexpr int TENTH = 10;
  const Remeshing_mesh& mesh = context.mesh;
  if (!context.projector.may_be_elsewhere) return false;
  int vertices = 0, far_ones = 0;
  mesh.for_each_sample_vertex(SAMPLES, [&](Index v) {
    if (!mesh.is_free(v)) return;
    Index hint = mesh.hint(v);
    ++vertices;
    far_ones += squared_distance(context.projector(mesh.position(v), hint), mesh.position(v)) > CGAL::square(context.length_at(v));
  });
  return TENTH * far_ones > vertices;
}

// By vertex: the way to its place on the surface, none where it stays, and the face of the surface there.
struct Ways_to_surface
{
  std::vector<Vector3> ways;
  std::vector<Remeshing_mesh::Index> hints;
};

template <class ConcurrencyTag>
Ways_to_surface ways_to_surface(const Remeshing_context& context)
{
  using Index = Remeshing_mesh::Index;
  constexpr std::size_t BLOCK = 256;
  const Remeshing_mesh& mesh = context.mesh;
  const std::size_t n = mesh.number_of_vertex_slots();
  Ways_to_surface result{std::vector<Vector3>(n), std::vector<Index>(n)};
  for_each_block_if<ConcurrencyTag>(context.projector.is_concurrent, n, BLOCK, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (Index v = Index(begin); v < Index(end); ++v) {
      if (!mesh.is_vertex(v)) continue;
      result.hints[v] = mesh.hint(v);
      if (!mesh.is_free(v)) continue;
      Index hint = mesh.hint(v);
      const Vector3 q = context.projector(mesh.position(v), hint);
      if (!context.projector.is_compatible(hint, star_cross_product(mesh, v))) continue;
      result.ways[v] = q - mesh.position(v);
      result.hints[v] = hint;
    }
  });
  return result;
}

// This part of the ways, none where the user's functor denies it.
inline std::vector<Vector3> permitted_steps(const Remeshing_context& context, const std::vector<Vector3>& ways, double part)
{
  using Index = Remeshing_mesh::Index;
  std::vector<Vector3> steps(ways.size());
  for (Index v = 0; v < Index(ways.size()); ++v)
    if (ways[v] != Vector3() && context.permits_move(v, context.mesh.position(v) + part * ways[v])) steps[v] = part * ways[v];
  return steps;
}

// How many faces turn by more than 60 degrees when the vertices take these steps: no step of the sweeps may do that.
inline std::size_t number_of_turned_faces(const Remeshing_mesh& mesh, const std::vector<Vector3>& steps)
{
  using Index = Remeshing_mesh::Index;
  constexpr double TURNED_COSINE = 0.5;
  std::size_t result = 0;
  for (Index f = 0; f < Index(mesh.number_of_face_slots()); ++f) {
    if (!mesh.is_face(f)) continue;
    const auto& v = mesh.face_record(f).vertex;
    const auto moved = [&](Index u) { return mesh.position(u) + steps[u]; };
    result += !is_cosine_at_least(mesh.cross_product(f), triangle_cross(moved(v[0]), moved(v[1]), moved(v[2])), TURNED_COSINE);
  }
  return result;
}

// Moves the vertices that are free the whole way to the surface, or the largest part of it, of a half, a quarter ..., that turns hardly
// a face: those few are mended afterwards, while a single one that had to wait would hold back all the others. Returns how many have moved.
template <class ConcurrencyTag>
std::size_t projection_pass(Remeshing_context& context)
{
  using Index = Remeshing_mesh::Index;
  // Less than the shortest part gets nowhere in a few steps.
  constexpr double SHORTEST_PART = 1. / 16, FEW_FACES = 0.05;
  Remeshing_mesh& mesh = context.mesh;
  const auto [ways, hints] = ways_to_surface<ConcurrencyTag>(context);
  for (double part = 1; part >= SHORTEST_PART; part /= 2) {
    const std::vector<Vector3> steps = permitted_steps(context, ways, part);
    if (double(number_of_turned_faces(mesh, steps)) > FEW_FACES * double(mesh.number_of_live_faces())) continue;
    for (Index v = 0; v < Index(steps.size()); ++v) {
      if (!mesh.is_vertex(v) || (steps[v] == Vector3() && ways[v] != Vector3())) continue;
      mesh.position(v) += steps[v];
      mesh.hint(v) = hints[v];
    }
    return steps.size() - std::size_t(std::count(steps.begin(), steps.end(), Vector3()));
  }
  return 0;
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_PROJECTION_PASS_H
