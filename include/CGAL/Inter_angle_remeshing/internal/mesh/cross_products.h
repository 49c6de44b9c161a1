// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_CROSS_PRODUCTS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_CROSS_PRODUCTS_H

#include <CGAL/Inter_angle_remeshing/internal/geometry/Bounding_box.h>
#include <CGAL/Inter_angle_remeshing/internal/geometry/Vector3.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/Remeshing_mesh.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/edge_lengths.h>

#include <algorithm>

// Where the surface looks at a face without an area, and at a vertex. CAD systems leave such faces along edges at which the faces of one
// side have vertices that those of the other side lack.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

inline Remeshing_mesh::Index longest_edge(const Remeshing_mesh& mesh, Remeshing_mesh::Index f)
{
  Remeshing_mesh::Index longest = 4 * f;
  for (Remeshing_mesh::Index h = 4 * f + 1; h < 4 * f + 3; ++h)
    if (mesh.squared_edge_length(h) > mesh.squared_edge_length(longest)) longest = h;
  return longest;
}

// Rounding says where a face looks whose altitude is no more than this: files have six digits of points, or floats. Of a scene of small parts
// a part of the diagonal would be too much.
inline double altitude_by_rounding(const Remeshing_mesh& mesh)
{
  constexpr double PART_OF_DIAGONAL = 4e-6, PART_OF_EDGE = 1e-3;
  Bounding_box box;
  for (const Vector3& p : mesh.positions()) box += p;
  return (std::min)(PART_OF_DIAGONAL * length(box.high - box.low), PART_OF_EDGE * mean_edge_length(mesh));
}

// The cross product of face f. One without an area, or no higher than that, is a part of the face beyond its longest edge, on which it
// lies, and looks as that does; zero where so many faces in a row have none.
inline Vector3 cross_product_of_surface(const Remeshing_mesh& mesh, Remeshing_mesh::Index f, double altitude)
{
  constexpr int FARTHEST = 16;
  for (int i = 0; i < FARTHEST && f >= 0; ++i) {
    const Vector3 &a = mesh.position(mesh.origin(4 * f)), &b = mesh.position(mesh.origin(4 * f + 1)),
                  &c = mesh.position(mesh.origin(4 * f + 2));
    const Vector3 n = triangle_cross(a, b, c);
    const Remeshing_mesh::Index longest = longest_edge(mesh, f), o = mesh.opposite(longest);
    if (!is_degenerate(n, a, b, c) && squared_length(n) > altitude * altitude * mesh.squared_edge_length(longest)) return n;
    f = o < 0 ? -1 : o >> 2;
  }
  return {};
}

// The sum of the cross products of the faces around v.
inline Vector3 star_cross_product(const Remeshing_mesh& mesh, Remeshing_mesh::Index v)
{
  Vector3 sum;
  mesh.for_each_around(v, [&](Remeshing_mesh::Index h) {
    sum += triangle_cross(mesh.position(v), mesh.position(mesh.target(h)), mesh.position(mesh.apex(h)));
  });
  return sum;
}

// Whether the surface rises on both sides of the edge of h, where the face of h looks in direction n and the one behind in direction m.
inline bool is_groove(const Remeshing_mesh& mesh, Remeshing_mesh::Index h, const Vector3& n, const Vector3& m)
{
  return dot(cross(n, m), mesh.position(mesh.target(h)) - mesh.position(mesh.origin(h))) < 0;
}

// The area of the mesh, in its own units.
inline double area(const Remeshing_mesh& mesh)
{
  double doubled = 0;
  for (Remeshing_mesh::Index f = 0; f < Remeshing_mesh::Index(mesh.number_of_face_slots()); ++f)
    if (mesh.is_face(f)) doubled += length(mesh.cross_product(f));
  return doubled / 2;
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_CROSS_PRODUCTS_H
