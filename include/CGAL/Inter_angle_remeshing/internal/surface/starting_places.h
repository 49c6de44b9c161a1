// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_STARTING_PLACES_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_STARTING_PLACES_H

#include <CGAL/Inter_angle_remeshing/internal/mesh/cross_products.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/projection.h>

#include <cstddef>
#include <vector>

// Where on the surface a run begins to look for each vertex.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// Whether most vertices look to the other side than the surface where it is closest. Where all of a few look to the same side, that is
// believed; else more are asked.
inline bool looks_to_other_side(const Remeshing_mesh& mesh, const Reference_surface& surface, double factor)
{
  using Index = Remeshing_mesh::Index;
  constexpr Index FEW = 4, MANY = 64;
  const auto sum_of_sides = [&](Index samples, const auto& locate) {
    int sum = 0;
    mesh.for_each_sample_vertex(samples, [&](Index v) {
      Index f = 0;
      locate(factor * mesh.position(v), f);
      const double side = dot(surface.cross_product(f), star_cross_product(mesh, v));
      sum += side > 0 ? 1 : side < 0 ? -1 : 0;
    });
    return sum;
  };
  const int few = sum_of_sides(FEW, [&](const Vector3& q, Index& f) { surface.locate_by_scan(q, f, Vector3()); });
  return few < FEW && sum_of_sides(MANY, [&](const Vector3& q, Index& f) { surface.locate(q, f); }) < 0;
}

// Gives each vertex the face of the surface where it lies. A vertex starts from its neighbor's face; where that walk
// does not lead onto the surface, the place is searched for.
inline void find_hints(Remeshing_mesh& mesh, const Projection& projection)
{
  using Index = Remeshing_mesh::Index;
  constexpr double ON_SURFACE = 1e-20;          // squared distance; the extent of the mesh is about 1
  constexpr int SCANS = 4;                      // building the search structure takes as long as some ten scans
  int searches = 0;
  std::vector<char> is_found(mesh.number_of_vertex_slots(), 0);
  std::vector<Index> queue, missed;
  const auto is_reached_from = [&](Index v, Index hint) {
    mesh.hint(v) = hint;
    return squared_distance(projection(mesh.position(v), mesh.hint(v)), mesh.position(v)) <= ON_SURFACE;
  };
  const auto search = [&](Index v) {
    const Vector3 normal = projection.side * star_cross_product(mesh, v), q = projection.factor * mesh.position(v);
    if (++searches <= SCANS) projection.surface->locate_by_scan(q, mesh.hint(v), normal);
    else projection.surface->locate(q, mesh.hint(v), normal);
  };
  for (Index seed = 0; seed < Index(mesh.number_of_vertex_slots()); ++seed) {
    if (!mesh.is_vertex(seed) || is_found[seed]) continue;
    search(seed);
    is_found[seed] = 1;
    queue.assign(1, seed);
    for (std::size_t i = 0; i < queue.size(); ++i) {
      const Index v = queue[i];
      mesh.for_each_neighbor(v, [&](Index u) {
        if (is_found[u]) return;
        if (!is_reached_from(u, mesh.hint(v))) missed.push_back(u);
        is_found[u] = 1;
        queue.push_back(u);
      });
    }
  }
  for (const Index v : missed) {
    bool is_reached = false;
    mesh.for_each_neighbor(v, [&](Index u) {
      is_reached = is_reached || is_reached_from(v, mesh.hint(u));
    });
    if (!is_reached) search(v);
  }
}

// The same where the surface is a copy of the mesh as it is.
inline void start_where_vertices_are(Remeshing_mesh& mesh)
{
  for (Remeshing_mesh::Index v = 0; v < Remeshing_mesh::Index(mesh.number_of_vertex_slots()); ++v)
    mesh.hint(v) = mesh.face(mesh.first(v));
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_STARTING_PLACES_H
