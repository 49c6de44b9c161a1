// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_EXCHANGE_READ_WIDER_MESH_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_EXCHANGE_READ_WIDER_MESH_H

#include <CGAL/Inter_angle_remeshing/internal/exchange/Descriptor_index.h>
#include <CGAL/Inter_angle_remeshing/internal/exchange/flat_copy.h>
#include <CGAL/Inter_angle_remeshing/internal/features/Wider_mesh.h>
#include <CGAL/Inter_angle_remeshing/internal/geometry/to_vector3.h>

#include <CGAL/exceptions.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// See Wider_mesh.
template <class TriangleMesh>
struct Wider_copy : Flat_copy<TriangleMesh>
{
  std::vector<Remeshing_mesh::Index> nearest_face;
};

// The range that `copy` is of, and triangles that hang together with it over edges, ring by ring: about as many again, but at least 1000,
// and no further rings from 5000 on. What reaches farther than a thousand extents of the range, as where a point is broken, is not around
// it.
template <class TriangleMesh, class VertexPointMap>
Wider_copy<TriangleMesh> read_wider_copy(const Flat_copy<TriangleMesh>& copy, const TriangleMesh& tmesh, const VertexPointMap& vpm,
                                         const char* caller)
{
  using Traits = boost::graph_traits<TriangleMesh>;
  using Index = Remeshing_mesh::Index;
  constexpr std::size_t FEWEST = 1000, MOST = 5000;
  constexpr double FARTHEST = 1000;
  std::size_t rim = 0;
  copy.mesh.for_each_halfedge([&](Index h) { rim += copy.is_on_rim(h, tmesh); });
  if (rim == 0) return {};

  const std::size_t wanted = (std::min)((std::max)(copy.faces.size(), FEWEST), MOST), enough = copy.faces.size() + wanted;
  auto faces = copy.faces;
  Wider_copy<TriangleMesh> result;
  result.nearest_face.resize(faces.size());
  std::iota(result.nearest_face.begin(), result.nearest_face.end(), 0);
  const auto is_around = [&](const auto& v) {
    return squared_distance((1 / copy.mesh.unit()) * internal::to_vector3(get(vpm, v)), copy.mesh.position(0)) <= FARTHEST * FARTHEST; };
  // The first ring has no more faces than the rim has edges, each further one at most twice as many as the one before.
  Descriptor_index<typename Traits::face_descriptor> is_known(enough + rim + 2 * wanted);
  for (const auto f : faces) is_known.insert(f, 0);
  for (std::size_t i = 0; i < faces.size() && faces.size() < enough;)
    for (const std::size_t end = faces.size(); i < end; ++i) {
      auto h = halfedge(faces[i], tmesh);
      for (int k = 0; k < 3; ++k, h = next(h, tmesh)) {
        const auto side = opposite(h, tmesh);
        if (face(side, tmesh) == Traits::null_face() || next(next(next(side, tmesh), tmesh), tmesh) != side ||
            !is_around(target(next(side, tmesh), tmesh)) || !is_known.insert(face(side, tmesh), 0).second)
          continue;
        faces.push_back(face(side, tmesh));
        result.nearest_face.push_back(result.nearest_face[i]);
      }
    }
  if (faces.size() == copy.faces.size()) return {};
  // Where a face outside is unfit, the range is looked at alone.
  try {
    static_cast<Flat_copy<TriangleMesh>&>(result) = Flat_copy_builder<TriangleMesh, VertexPointMap>(tmesh, vpm, caller).build(faces);
  } catch (const CGAL::Precondition_exception&) {
    return {};
  }
  return result;
}

template <class TriangleMesh, class VertexPointMap>
Wider_mesh read_wider_mesh(const Flat_copy<TriangleMesh>& copy, const TriangleMesh& tmesh, const VertexPointMap& vpm, const char* caller)
{
  Wider_copy<TriangleMesh> wider = read_wider_copy(copy, tmesh, vpm, caller);
  return {std::move(wider.mesh), std::move(wider.nearest_face)};
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_EXCHANGE_READ_WIDER_MESH_H
