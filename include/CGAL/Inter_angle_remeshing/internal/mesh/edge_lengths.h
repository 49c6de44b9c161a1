// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_EDGE_LENGTHS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_EDGE_LENGTHS_H

#include <CGAL/Inter_angle_remeshing/internal/mesh/Remeshing_mesh.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/parallel_blocks.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// One half-edge of each edge whose squared length is out of [low, high] times `scale(u, v)`, for the vertices u and v of the edge.
// Lengths are taken face by face; the adjacency is looked at for the few hits only.
template <class ConcurrencyTag, class Scale>
std::vector<Remeshing_mesh::Index> edges_out_of(const Remeshing_mesh& mesh, double low, double high, const Scale& scale)
{
  using Index = Remeshing_mesh::Index;
  std::vector<Index> found;
  scan_into<ConcurrencyTag>(found, mesh.number_of_face_slots(), [&](std::size_t f, std::vector<Index>& out) {
    if (!mesh.is_face(Index(f))) return;
    const Index h = Index(4 * f), u = mesh.origin(h), v = mesh.origin(h + 1), w = mesh.origin(h + 2);
    const Vector3 &a = mesh.position(u), &b = mesh.position(v), &c = mesh.position(w);
    const double length[3] = {squared_distance(a, b), squared_distance(b, c), squared_distance(c, a)};
    const double unit[3] = {scale(u, v), scale(v, w), scale(w, u)};
    const auto is_out = [&](int k) { return int(length[k] < low * unit[k]) | int(length[k] > high * unit[k]); };
    if (!(is_out(0) | is_out(1) | is_out(2))) return;
    Index edges[3];                      // of which some are written over: no branch is foretold well here
    int n = 0;
    for (int k = 0; k < 3; ++k) {
      edges[n] = h + k;
      n += is_out(k) & int(mesh.names_edge(h + k));
    }
    for (int k = 0; k < n; ++k) out.push_back(edges[k]);
  });
  return found;
}

// The length of all edges, those of the border by half.
inline double total_edge_length(const Remeshing_mesh& mesh)
{
  double sum = 0;
  for (std::size_t f = 0; f < mesh.number_of_face_slots(); ++f) {
    if (!mesh.is_face(Corner_table::Index(f))) continue;
    for (int k = 0; k < 3; ++k) sum += std::sqrt(mesh.squared_edge_length(Corner_table::Index(4 * f + k)));
  }
  return sum / 2;
}

// The mean, an edge of the border by half.
inline double mean_edge_length(const Remeshing_mesh& mesh)
{
  return total_edge_length(mesh) / (1.5 * double(mesh.number_of_live_faces()));
}

// The largest length of an edge in targets, `target(u, v)` being that of an edge between u and v, of those that may be split: a
// protected one stays as long as it is.
template <class Target>
double longest_edge_in_targets(const Remeshing_mesh& mesh, const Target& target)
{
  double longest = 0;                    // squared
  for (std::size_t f = 0; f < mesh.number_of_face_slots(); ++f)
    if (mesh.is_face(Remeshing_mesh::Index(f)))
      for (int k = 0; k < 3; ++k) {
        const Remeshing_mesh::Index h = Remeshing_mesh::Index(4 * f + k);
        const double unit = target(mesh.origin(h), mesh.target(h)), length = mesh.squared_edge_length(h) / (unit * unit);
        if (length > longest && mesh.is_split_legal(h)) longest = length;
      }
  return std::sqrt(longest);
}

// Whether a protected edge is dozens of times as long as the target length between its ends.
template <class Target>
bool has_long_protected_edge(const Remeshing_mesh& mesh, const Target& target)
{
  constexpr double LONG = 20;            // from 3 on the rims of fine ranges would be, and their runs be made anew
  bool result = false;
  mesh.for_each_edge([&](Remeshing_mesh::Index h) {
    if (result || !mesh.is_protected(h)) return;
    const double bound = LONG * target(mesh.origin(h), mesh.target(h));
    result = mesh.squared_edge_length(h) > bound * bound;
  });
  return result;
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_EDGE_LENGTHS_H
