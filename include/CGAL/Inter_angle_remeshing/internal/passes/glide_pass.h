// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_GLIDE_PASS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_GLIDE_PASS_H

#include <CGAL/Inter_angle_remeshing/internal/passes/flip_pass.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

// Glides: an edge between a vertex with too many and one with too few edges is a dislocation of the triangular
// lattice. A sequence of flips moves it through the mesh until it meets another irregular vertex and both become
// regular. None of the flips need pay by itself, the sequence as a whole does.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// The flips of a glide, as pairs of vertices: the flips before one change the half-edges of the next.
struct Glide
{
  std::array<std::pair<Remeshing_mesh::Index, Remeshing_mesh::Index>, MAXIMUM_GLIDE_DEPTH> edges;
  unsigned length = 0;
};

// Looks for a glide that starts at the edge of h0, from a vertex p with too many edges to q with too few, into the
// face of `side` (h0 or its opposite). Each step flips the edge between p and the vertex y opposite to pq; z is the
// vertex beyond. That makes p and q regular and moves their deviations on to z and y.
inline bool find_glide(const Remeshing_mesh& mesh, Remeshing_mesh::Index h0, Remeshing_mesh::Index side,
                       const Recipe& recipe, Glide& glide)
{
  using Index = Remeshing_mesh::Index;
  Index p = mesh.origin(h0);
  std::array<Index, 2 * MAXIMUM_GLIDE_DEPTH + 2> visited;
  unsigned number_of_visited = 0;
  visited[number_of_visited++] = p;
  visited[number_of_visited++] = mesh.target(h0);
  const auto is_new = [&](Index v) {
    return std::find(visited.begin(), visited.begin() + number_of_visited, v) == visited.begin() + number_of_visited;
  };
  int deviation_p = sector_deviation(mesh, h0), deviation_q = sector_deviation(mesh, mesh.opposite(h0));
  int total = 0;
  glide.length = 0;
  Index h = side;
  while (glide.length < (std::min)(recipe.glide_depth, MAXIMUM_GLIDE_DEPTH)) {
    if (h < 0) return false;
    const bool starts_at_p = mesh.origin(h) == p;
    const Index y = mesh.apex(h);
    const Index e = starts_at_p ? mesh.prev(h) : mesh.next(h);    // between p and y
    const Index o = mesh.opposite(e);
    if (o < 0 || mesh.is_constrained(e)) return false;
    const Index z = mesh.apex(o);
    if (!is_new(y) || !is_new(z)) return false;
    const int deviation_y = sector_deviation(mesh, mesh.prev(h)), deviation_z = sector_deviation(mesh, mesh.prev(o));
    total += 4 + 2 * ((deviation_q + deviation_z) - (deviation_p + deviation_y));
    glide.edges[glide.length++] = {p, y};
    if (total < 0) return true;
    if (total > recipe.glide_slack) return false;
    visited[number_of_visited++] = y;
    visited[number_of_visited++] = z;
    // On into the face across yz, away from the flipped edge.
    const Index across = starts_at_p ? mesh.next(o) : mesh.prev(o);
    if (mesh.is_on_curve_edge(across)) return false;
    h = mesh.opposite(across);
    p = z;
    deviation_p = deviation_z + 1;
    deviation_q = deviation_y - 1;
  }
  return false;
}

// Performs the flips of a glide; undoes them if one is not allowed.
inline bool perform_glide(Remeshing_context& context, const Glide& glide)
{
  using Index = Remeshing_mesh::Index;
  Remeshing_mesh& mesh = context.mesh;
  std::array<Index, MAXIMUM_GLIDE_DEPTH> done;
  for (unsigned i = 0; i < glide.length; ++i) {
    const Index h = mesh.find_halfedge(glide.edges[i].first, glide.edges[i].second);
    if (h < 0 || !is_flip_allowed(context, h, true)) {
      while (i > 0) flip(context, done[--i]);
      return false;
    }
    flip(context, h);
    done[i] = mesh.next(h);
  }
  return true;
}

// Whether h runs from a vertex with too many edges to one with too few, on a curve in the sectors that meet at h.
inline bool is_dislocation(const Remeshing_mesh& mesh, Remeshing_mesh::Index h)
{
  return !mesh.is_on_curve_edge(h) && sector_deviation(mesh, h) >= 1 && sector_deviation(mesh, mesh.opposite(h)) <= -1;
}

// Returns the number of glides. The sectors have been measured.
template <class ConcurrencyTag>
std::size_t glide_pass(Remeshing_context& context)
{
  using Index = Remeshing_mesh::Index;
  Remeshing_mesh& mesh = context.mesh;
  const Recipe& recipe = context.recipe;
  std::vector<Index> candidates;
  scan_into<ConcurrencyTag>(candidates, mesh.number_of_vertex_slots(), [&](std::size_t v, std::vector<Index>& found) {
    if (!mesh.is_vertex(Index(v)) || (mesh.deviation(Index(v)) < 1 && !mesh.is_on_curve(Index(v)))) return;
    mesh.for_each_around(Index(v), [&](Index h) {
      if (!is_dislocation(mesh, h)) return;
      Glide glide;
      if (find_glide(mesh, h, h, recipe, glide) || find_glide(mesh, h, mesh.opposite(h), recipe, glide))
        found.push_back(h);
    });
  });

  std::size_t glides = 0;
  for (const Index h : candidates)
    for (const Index side : {h, mesh.opposite(h)}) {
      Glide glide;
      if (!is_dislocation(mesh, h)) break;
      if (find_glide(mesh, h, side, recipe, glide) && perform_glide(context, glide)) {
        ++glides;
        break;
      }
    }
  return glides;
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_GLIDE_PASS_H
