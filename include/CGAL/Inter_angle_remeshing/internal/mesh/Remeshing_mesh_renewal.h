// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_REMESHING_MESH_RENEWAL_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_REMESHING_MESH_RENEWAL_H

#include <CGAL/Inter_angle_remeshing/internal/mesh/Remeshing_mesh.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/parallel_blocks.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

// What makes the mesh anew as a whole: it is renumbered, or every face is cut into four.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

inline std::vector<Remeshing_mesh::Index> Remeshing_mesh::block_order() const
{
  Index last = 0;
  for (const Index k : block_)
    last = (std::max)(last, k);
  std::vector<Index> start(std::size_t(last) + 2, 0);
  for (std::size_t v = 0; v < position_.size(); ++v)
    if (first_[v] >= 0) ++start[block_[v] + 1];
  for (std::size_t k = 0; k + 1 < start.size(); ++k)
    start[k + 1] += start[k];
  std::vector<Index> order(start.back());
  for (std::size_t v = 0; v < position_.size(); ++v)
    if (first_[v] >= 0) order[start[block_[v]]++] = Index(v);
  return order;
}

template <class ConcurrencyTag>
void Remeshing_mesh::renumber(const std::vector<Index>& order)
{
  const std::size_t n = order.size();
  std::vector<Index> new_vertex_of(number_of_vertex_slots(), NO_VERTEX);
  for (std::size_t i = 0; i < n; ++i)
    new_vertex_of[order[i]] = Index(i);

  // Faces in the order of their smallest vertex, so that a sweep meets them one after the other. Each is written down at every
  // corner, and kept at one.
  std::vector<Index> new_face_of(number_of_face_slots(), -1), face_order(number_of_live_faces() + 1);
  std::size_t found = 0;
  for (std::size_t i = 0; i < n; ++i)
    for_each_around(order[i], [&](Index h) {
      face_order[found] = h >> 2;
      found += std::size_t((std::min)(new_vertex_of[target(h)], new_vertex_of[apex(h)]) > Index(i));
    });
  face_order.resize(found);
  for (std::size_t i = 0; i < found; ++i) new_face_of[face_order[i]] = Index(i);

  const auto new_corner_of = [&](Index h) { return 4 * new_face_of[h >> 2] + (h & 3); };
  std::vector<Face> faces;
  faces.reserve(face_order.size() + face_order.size() / 8);   // room for the splits that follow
  faces.resize(face_order.size());
  for_each_block<ConcurrencyTag>(faces.size(), SCAN_BLOCK, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) {
      const Face& old = faces_[face_order[i]];
      faces[i] = old;
      for (int k = 0; k < 3; ++k) {
        faces[i].vertex[k] = new_vertex_of[old.vertex[k]];
        faces[i].opposite[k] = old.opposite[k] >= 0 ? new_corner_of(old.opposite[k]) : ~Index(4 * i + k);
      }
    }
  });

  Remeshing_mesh result;
  result.unit_ = unit_;
  result.reserve_vertices(n + n / 8);
  result.resize_vertices(n);
  const unsigned shift = block_shift(n);
  for_each_block<ConcurrencyTag>(n, SCAN_BLOCK, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) {
      const Index v = order[i];
      result.position_[i] = position_[v];
      result.first_[i] = new_corner_of(first_[v]);
      result.state_[i] = state_[v];
      result.hint_[i] = hint_[v];
      result.input_[i] = input_[v];
      result.block_[i] = Index(i >> shift);
    }
  });
  if (has_curves()) {
    result.curve_edge_of_.resize(4 * faces.size());
    for (std::size_t i = 0; i < faces.size(); ++i)
      for (int k = 0; k < 3; ++k) result.curve_edge_of_[4 * i + k] = curve_edge_of_[4 * face_order[i] + k];
    result.curve_edges_ = std::move(curve_edges_);
  }
  result.faces_ = std::move(faces);
  *this = std::move(result);
}

inline Remeshing_mesh::Subdivision_numbers Remeshing_mesh::subdivision_numbers() const
{
  Subdivision_numbers result;
  result.vertex.resize(number_of_vertex_slots());
  result.middle.assign(4 * number_of_face_slots(), -1);
  result.edges.reserve(number_of_face_slots() + number_of_face_slots() / 2);
  Index next_number = 0;
  const auto number_middle = [&](Index h) {
    if (result.middle[h] >= 0) return;
    if (!is_border(h)) result.middle[opposite(h)] = next_number;
    result.middle[h] = next_number++;
    result.edges.push_back(h);
  };
  for (Index v = 0; v < Index(result.vertex.size()); ++v) {
    result.vertex[v] = next_number++;
    for_each_around(v, [&](Index h) {
      number_middle(h);
      number_middle(prev(h));            // the last edge of an open fan
    });
  }
  return result;
}

inline std::array<Corner_table::Face, 4> Remeshing_mesh::subdivided_face(Index f, const Subdivision_numbers& numbers) const
{
  const Face& whole = faces_[f];
  std::array<Face, 4> parts;
  for (int k = 0; k < 3; ++k) {
    const int after = (k + 1) % 3, before = (k + 2) % 3;
    const Index o = whole.opposite[k], o_before = whole.opposite[before];
    Face& part = parts[k];
    part.vertex[k] = numbers.vertex[whole.vertex[k]];
    part.vertex[after] = numbers.middle[4 * f + k];
    part.vertex[before] = numbers.middle[4 * f + before];
    part.opposite[k] = o >= 0 ? second_half(o) : ~first_half(4 * f + k);
    part.opposite[after] = 4 * (4 * f + 3) + before;
    part.opposite[before] = o_before >= 0 ? first_half(o_before) : ~second_half(4 * f + before);
    part.edge_flags = whole.edge_flags & (edge_bits(k) | edge_bits(before));
    parts[3].vertex[k] = part.vertex[after];
    parts[3].opposite[before] = 4 * (4 * f + k) + after;
  }
  for (Face& part : parts) part.source = whole.source;
  return parts;
}

// The edges on curves and their places: each half has one half of the arc.
inline void Remeshing_mesh::subdivide_curves(const std::vector<Index>& edges, Remeshing_mesh& result) const
{
  result.curve_edge_of_.assign(4 * result.faces_.size(), -1);
  const auto add_half = [&](Index half, Index curve, double begin, double end) {
    const Index e = result.new_curve_edge(curve, begin, end);
    result.curve_edge_of_[half] = 2 * e;
    if (!result.is_border(half)) result.curve_edge_of_[result.opposite(half)] = 2 * e + 1;
  };
  for (const Index h : edges) {
    if (!has_place(h)) continue;
    const Curve_place place = curve_place(h);
    const double middle = 0.5 * (place.origin + place.target);
    add_half(first_half(h), place.curve, place.origin, middle);
    add_half(second_half(h), place.curve, middle, place.target);
  }
}

template <class ConcurrencyTag>
void Remeshing_mesh::subdivide(const Subdivision_numbers& numbers, const std::vector<Vector3>& points)
{
  const std::size_t vertices = number_of_vertex_slots(), edges = numbers.edges.size(), faces = number_of_face_slots();
  check_number_of_faces(4 * faces);
  Remeshing_mesh result;
  result.unit_ = unit_;
  result.faces_.resize(4 * faces);
  for_each_block<ConcurrencyTag>(faces, SCAN_BLOCK, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t f = begin; f < end; ++f) {
      const std::array<Face, 4> parts = subdivided_face(Index(f), numbers);
      std::copy(parts.begin(), parts.end(), result.faces_.begin() + std::ptrdiff_t(4 * f));
    }
  });
  result.resize_vertices(vertices + edges);
  for_each_block<ConcurrencyTag>(vertices, SCAN_BLOCK, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t v = begin; v < end; ++v) {
      const Index i = numbers.vertex[v];
      result.position_[i] = position_[v];
      result.first_[i] = first_half(first_[v]);
      result.state_[i] = state_[v];
      result.hint_[i] = hint_[v];
      result.input_[i] = input_[v];
    }
  });
  for_each_block<ConcurrencyTag>(edges, SCAN_BLOCK, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t e = begin; e < end; ++e) {
      const Index h = numbers.edges[e], i = numbers.middle[h];
      result.position_[i] = points[e];
      result.first_[i] = second_half(h);
      result.state_[i] = Vertex_state{std::uint16_t(is_border(h) ? 4 : 6), 0, 6};
      if (is_border(h)) result.add_marks(i, ON_BORDER);
      if (is_constrained(h)) result.add_marks(i, ON_FEATURE);
      if (is_on_rim(h)) result.add_marks(i, NEXT_TO_OUTSIDE);
    }
  });
  const unsigned shift = block_shift(result.block_.size());
  for (std::size_t i = 0; i < result.block_.size(); ++i) result.block_[i] = Index(i >> shift);
  if (has_curves()) subdivide_curves(numbers.edges, result);
  *this = std::move(result);
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_REMESHING_MESH_RENEWAL_H
