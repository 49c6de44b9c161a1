// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_REGULAR_VALENCE_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_REGULAR_VALENCE_H

#include <CGAL/Inter_angle_remeshing/internal/geometry/arc_cosine.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/Remeshing_mesh.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/parallel_blocks.h>

#include <algorithm>
#include <cstdint>
#include <limits>

// How many faces are regular around a vertex. Curves divide them into sectors, which no flip joins: a sector is regular with as many
// faces as it has times 60 degrees, but with one at least. Around other vertices six are regular, or what lies between six and the
// number that there is, if the angles ask for that: five at a tip, seven at a saddle. So such a vertex is not chased away from where
// the mesh has put it; but no vertex is drawn there, for six faces are good enough.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// In degrees, at the origin of h.
inline double corner_angle(const Remeshing_mesh& mesh, Remeshing_mesh::Index h)
{
  return arc_cosine_in_degrees(corner_cosine(mesh.position(mesh.origin(h)), mesh.position(mesh.target(h)), mesh.position(mesh.apex(h))));
}

inline int faces_in_angle(double degrees) { return int(degrees / 60 + 0.5); }

// The number of faces between six and those around v, which is on no curve, that is nearest to what its angles ask for.
inline int regular_valence_by_angles(const Remeshing_mesh& mesh, Remeshing_mesh::Index v)
{
  constexpr int LARGEST = (std::numeric_limits<std::uint8_t>::max)();
  const int valence = mesh.valence(v);
  if (valence == 6) return 6;
  double angle = 0;
  mesh.for_each_around(v, [&](Remeshing_mesh::Index h) { angle += corner_angle(mesh, h); });
  return std::clamp(faces_in_angle(angle), (std::min)(valence, 6), (std::min)((std::max)(valence, 6), LARGEST));
}

template <class ConcurrencyTag>
void measure_inner_vertices(Remeshing_mesh& mesh)
{
  using Index = Remeshing_mesh::Index;
  for_each_block<ConcurrencyTag>(mesh.number_of_vertex_slots(), SCAN_BLOCK, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (Index v = Index(begin); v < Index(end); ++v)
      if (mesh.is_vertex(v) && !mesh.is_on_curve(v)) mesh.set_regular_valence(v, regular_valence_by_angles(mesh, v));
  });
}

template <class ConcurrencyTag>
void measure_sectors(Remeshing_mesh& mesh)
{
  using Index = Remeshing_mesh::Index;
  if (!mesh.has_curves()) return;
  for_each_block<ConcurrencyTag>(mesh.number_of_face_slots(), SCAN_BLOCK, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (Index f = Index(begin); f < Index(end); ++f) {
      if (!mesh.is_face(f) || mesh.face_record(f).edge_flags == 0) continue;
      for (Index h = 4 * f; h < 4 * f + 3; ++h) {
        if (!mesh.has_place(h)) continue;
        double angle = 0;
        for (Index k = h;; k = mesh.rotate_ccw(k)) {
          angle += corner_angle(mesh, k);
          if (mesh.is_on_curve_edge(mesh.prev(k))) break;
        }
        mesh.set_regular_faces(mesh.curve_end(h), (std::max)(1, faces_in_angle(angle)));
      }
    }
  });
}

// Notes how many faces are regular in each sector, and around each vertex on no curve if the angles are asked there, too; six are, if
// they never were. Flips leave that as it is, near enough.
template <class ConcurrencyTag>
void measure_regular_valences(Remeshing_mesh& mesh, bool asks_angles_of_inner_vertices)
{
  measure_sectors<ConcurrencyTag>(mesh);
  if (asks_angles_of_inner_vertices) measure_inner_vertices<ConcurrencyTag>(mesh);
}

inline int deviation_on_curve(const Remeshing_mesh& mesh, Remeshing_mesh::Index h)
{
  using Index = Remeshing_mesh::Index;
  const Index v = mesh.origin(h);
  int faces = 1;
  for (Index k = h; !mesh.is_on_curve_edge(mesh.prev(k)); ++faces) {
    k = mesh.rotate_ccw(k);
    if (k == h) return mesh.deviation(v);      // a mark without an edge
  }
  Index first = h;
  for (; !mesh.is_on_curve_edge(first); ++faces) first = mesh.rotate_cw(first);
  return mesh.has_place(first) ? faces - mesh.regular_faces(mesh.curve_end(first)) : mesh.deviation(v);
}

// By how many faces the sector of the origin of h that holds the face of h is off.
inline int sector_deviation(const Remeshing_mesh& mesh, Remeshing_mesh::Index h)
{
  return mesh.is_on_curve(mesh.origin(h)) ? deviation_on_curve(mesh, h) : mesh.deviation(mesh.origin(h));
}

// Calls `function(h, faces, deviation)` for the sectors of v, a vertex on a curve: h is the half-edge with which one begins,
// counterclockwise.
template <class Function>
void for_each_sector(const Remeshing_mesh& mesh, Remeshing_mesh::Index v, const Function& function)
{
  using Index = Remeshing_mesh::Index;
  Index first = mesh.first(v);
  int left = mesh.number_of_faces_around(v);
  for (int k = 0; k < left && !mesh.is_on_curve_edge(first); ++k) first = mesh.rotate_ccw(first);
  while (left > 0) {
    int faces = 1;
    Index h = first;
    for (; faces < left && !mesh.is_on_curve_edge(mesh.prev(h)); ++faces) h = mesh.rotate_ccw(h);
    function(first, faces, mesh.has_place(first) ? faces - mesh.regular_faces(mesh.curve_end(first)) : mesh.deviation(v));
    left -= faces;
    first = mesh.rotate_ccw(h);
  }
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_REGULAR_VALENCE_H
