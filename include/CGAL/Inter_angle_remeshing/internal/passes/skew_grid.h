// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_SKEW_GRID_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_SKEW_GRID_H

#include <CGAL/Inter_angle_remeshing/internal/geometry/Vector3.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/Remeshing_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

// Grids of quadrangles, all cut into triangles the same way, as revolved and swept surfaces and height fields are. Where their edges have
// nearly the target length, all of their vertices are regular, and at the centres of their neighbors, however skew the faces are:
// splits, collapses, flips and sweeps have little to do.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// 1 for an equilateral triangle, .87 for half a square, 0 for a flat one (R. Bank's measure).
inline double triangle_shape(const Vector3& a, const Vector3& b, const Vector3& c)
{
  return 2 * std::sqrt(3.) * length(triangle_cross(a, b, c)) /
         (squared_distance(a, b) + squared_distance(b, c) + squared_distance(c, a));
}

// Whether most faces are those of such a grid: off the curves nearly all of them have regular vertices alone, and these have not the
// shape that regular vertices have in other meshes after a few iterations.
inline bool is_skew_grid(const Remeshing_mesh& mesh)
{
  using Index = Remeshing_mesh::Index;
  // Parts of the faces off the curves, and of all. After three iterations skew grids have .82 to .89 of them, other inputs up to .77; but of
  // those with .7 none has a mean shape under .98. One of .97 goes with a θ_avg of 53 degrees.
  constexpr double REGULAR = 0.7, MOST = 0.5, SKEW = 0.97;
  constexpr int REGULAR_VALENCE = 6;
  std::size_t off_curves = 0, regular = 0;
  double shapes = 0;
  for (Index f = 0; f < Index(mesh.number_of_face_slots()); ++f) {
    if (!mesh.is_face(f)) continue;
    const auto& corner = mesh.face_record(f).vertex;
    if (std::any_of(corner, corner + 3, [&](Index v) { return mesh.is_on_curve(v); })) continue;
    ++off_curves;
    if (std::any_of(corner, corner + 3, [&](Index v) { return mesh.valence(v) != REGULAR_VALENCE; })) continue;
    ++regular;
    shapes += triangle_shape(mesh.position(corner[0]), mesh.position(corner[1]), mesh.position(corner[2]));
  }
  return double(regular) >= REGULAR * double(off_curves) && double(regular) >= MOST * double(mesh.number_of_live_faces()) &&
         shapes < SKEW * double(regular);
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_SKEW_GRID_H
