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

// Of the edges of face f, but for that of `other`.
inline Remeshing_mesh::Index longest_edge(const Remeshing_mesh& mesh, Remeshing_mesh::Index f, Remeshing_mesh::Index other = -1)
{
  Remeshing_mesh::Index longest = 4 * f == other ? 4 * f + 1 : 4 * f;
  for (Remeshing_mesh::Index h = longest + 1; h < 4 * f + 3; ++h)
    if (h != other && mesh.squared_edge_length(h) > mesh.squared_edge_length(longest)) longest = h;
  return longest;
}

// Rounding says where a face looks whose altitude is no more than this: files have six digits of points, or floats. Of a scene of small
// parts a part of the diagonal would be too much.
inline double altitude_by_rounding(const Remeshing_mesh& mesh)
{
  constexpr double PART_OF_DIAGONAL = 4e-6, PART_OF_EDGE = 1e-3;
  Bounding_box box;
  for (const Vector3& p : mesh.positions()) box += p;
  return (std::min)(PART_OF_DIAGONAL * length(box.high - box.low), PART_OF_EDGE * mean_edge_length(mesh));
}

// Whether face f is no higher than that, over its longest edge, or than double precision tells.
inline bool looks_nowhere(const Remeshing_mesh& mesh, Remeshing_mesh::Index f, Remeshing_mesh::Index longest, double altitude)
{
  const Vector3 &a = mesh.position(mesh.origin(4 * f)), &b = mesh.position(mesh.origin(4 * f + 1)),
                &c = mesh.position(mesh.origin(4 * f + 2)), n = triangle_cross(a, b, c);
  return is_degenerate(n, a, b, c) || !(squared_length(n) > altitude * altitude * mesh.squared_edge_length(longest));
}

// The cross product of face f. One that looks nowhere is a part of the face beyond its longest edge, on which it lies, and looks as that
// does; where two share that edge, each looks as the face beyond its second one. Zero where too many in a row look nowhere.
inline Vector3 cross_product_of_surface(const Remeshing_mesh& mesh, Remeshing_mesh::Index f, double altitude)
{
  using Index = Remeshing_mesh::Index;
  constexpr int FARTHEST = 16;
  for (int i = 0; i < FARTHEST && f >= 0; ++i) {
    const Index longest = longest_edge(mesh, f), o = mesh.opposite(longest);
    if (!looks_nowhere(mesh, f, longest, altitude)) return mesh.cross_product(f);
    const bool is_one_of_two = o >= 0 && longest_edge(mesh, o >> 2) == o && looks_nowhere(mesh, o >> 2, o, altitude);
    const Index beyond = is_one_of_two ? mesh.opposite(longest_edge(mesh, f, longest)) : o;
    f = beyond < 0 ? -1 : beyond >> 2;
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
