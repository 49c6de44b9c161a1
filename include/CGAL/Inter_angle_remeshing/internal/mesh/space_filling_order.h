// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_SPACE_FILLING_ORDER_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_SPACE_FILLING_ORDER_H

#include <CGAL/Inter_angle_remeshing/internal/geometry/Bounding_box.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/Remeshing_mesh.h>

#include <boost/sort/spreadsort/integer_sort.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// Bits a coordinate contributes to a Morton key: three of them and a 32-bit index make 62 bits.
constexpr int MORTON_BITS = 10;

// Moves the ten lowest bits apart: bit i goes to bit 3 i.
inline std::uint64_t spread_bits(std::uint64_t x)
{
  x = (x | x << 16) & 0x30000ff;
  x = (x | x << 8) & 0x300f00f;
  x = (x | x << 4) & 0x30c30c3;
  x = (x | x << 2) & 0x9249249;
  return x;
}

// The live vertices of the mesh along a Morton curve through its bounding box.
inline std::vector<Remeshing_mesh::Index> morton_order(const Remeshing_mesh& mesh)
{
  using Index = Remeshing_mesh::Index;
  const Index number_of_slots = Index(mesh.number_of_vertex_slots());
  Bounding_box box;
  for (Index v = 0; v < number_of_slots; ++v)
    if (mesh.is_vertex(v)) box += mesh.position(v);
  const Vector3 sides = box.high - box.low;
  const double extent = (std::max)({sides.x, sides.y, sides.z});
  const double cells = extent > 0 ? ((1 << MORTON_BITS) - 1) / extent : 0;

  std::vector<std::uint64_t> keys;
  keys.reserve(mesh.number_of_live_vertices());
  for (Index v = 0; v < number_of_slots; ++v) {
    if (!mesh.is_vertex(v)) continue;
    const Vector3 cell = cells * (mesh.position(v) - box.low);
    const std::uint64_t key = spread_bits(std::uint64_t(cell.x)) | spread_bits(std::uint64_t(cell.y)) << 1 |
                              spread_bits(std::uint64_t(cell.z)) << 2;
    keys.push_back(key << 32 | std::uint64_t(v));
  }
  boost::sort::spreadsort::integer_sort(keys.begin(), keys.end());

  std::vector<Index> order(keys.size());
  for (std::size_t i = 0; i < keys.size(); ++i)
    order[i] = Index(keys[i] & 0xffffffffu);
  return order;
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_SPACE_FILLING_ORDER_H
