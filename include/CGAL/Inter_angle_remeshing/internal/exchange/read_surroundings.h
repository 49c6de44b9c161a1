// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_EXCHANGE_READ_SURROUNDINGS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_EXCHANGE_READ_SURROUNDINGS_H

#include <CGAL/Inter_angle_remeshing/internal/exchange/Descriptor_index.h>
#include <CGAL/Inter_angle_remeshing/internal/exchange/flat_copy.h>
#include <CGAL/Inter_angle_remeshing/internal/geometry/to_vector3.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/Surroundings.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// The faces of the user's mesh, beside those of the copy, at the vertices of the copy that have faces outside. Triangles that is, with
// finite points; any others are left out.
template <class TriangleMesh, class VertexPointMap>
Surroundings read_surroundings(const Flat_copy<TriangleMesh>& copy, const TriangleMesh& tmesh, const VertexPointMap& vpm)
{
  using Traits = boost::graph_traits<TriangleMesh>;
  using Index = Remeshing_mesh::Index;
  std::vector<Index> rim;
  for (Index v = 0; v < Index(copy.vertices.size()); ++v)
    if (copy.mesh.marks(v) & Remeshing_mesh::NEXT_TO_OUTSIDE) rim.push_back(v);
  Surroundings result;
  if (rim.empty()) return result;

  Descriptor_index<typename Traits::face_descriptor> is_inside(copy.faces.size());
  for (const auto f : copy.faces) is_inside.insert(f, 0);
  const auto point = [&](const auto& v) { return (1 / copy.mesh.unit()) * internal::to_vector3(get(vpm, v)); };
  const auto is_triangle = [&](const auto& h) {
    const auto following = next(h, tmesh), last = next(following, tmesh);
    return next(last, tmesh) == h && is_finite(point(target(h, tmesh))) && is_finite(point(target(following, tmesh))) &&
           is_finite(point(target(last, tmesh)));
  };
  std::vector<typename Traits::halfedge_descriptor> around;
  for (const Index v : rim)
    for (const auto h : CGAL::halfedges_around_target(copy.vertices[v], tmesh)) {
      const auto f = face(h, tmesh);
      if (f != Traits::null_face() && is_inside.find(f) < 0 && is_triangle(h)) around.push_back(h);
    }

  Descriptor_index<typename Traits::face_descriptor> is_known(around.size());
  Descriptor_index<typename Traits::vertex_descriptor> name(3 * around.size() + rim.size());
  for (const Index v : rim) name.insert(copy.vertices[v], v);
  std::size_t points = 0;
  for (auto h : around) {
    if (!is_known.insert(face(h, tmesh), 0).second) continue;
    std::array<Index, 3> corners;
    for (Index& corner : corners) {
      const auto v = target(h, tmesh);
      const auto [number, is_new] = name.insert(v, Index(copy.vertices.size() + points));
      if (is_new) { result.points.push_back(point(v)); ++points; }
      corner = number < Index(copy.vertices.size()) ? number : ~(number - Index(copy.vertices.size()));
      h = next(h, tmesh);
    }
    result.faces.push_back(corners);
  }
  return result;
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_EXCHANGE_READ_SURROUNDINGS_H
