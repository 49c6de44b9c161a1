// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_CORNER_TABLE_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_CORNER_TABLE_H

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// Triangles and their adjacency: 32 bytes a face.
//
// Corner k (0..2) of face f has the index h = 4 f + k; it stands for the half-edge from its own vertex to the next
// one of f, with f on its left. The opposite of a half-edge on the border is the negative number ~h: that is the name
// of its border side, and ~~h = h leads back.
class Corner_table
{
public:
  using Index = std::int32_t;

  struct Face
  {
    Index vertex[3] = {-1, -1, -1};
    Index source = -1;                // the input face that this one descends from
    Index opposite[3] = {-1, -1, -1};
    std::uint32_t edge_flags = 0;     // of the three edges, see Remeshing_mesh
  };

  // The next half-edge of the face, and the one before; without branches, as which corner comes next is not foretold well.
  static constexpr Index next(Index h) { return h + 1 - 3 * ((h >> 1) & 1); }
  static constexpr Index prev(Index h) { return h + 2 - 3 * (((h & 3) + 3) >> 2); }
  static constexpr Index face(Index h) { return h >> 2; }
  static constexpr int corner(Index h) { return h & 3; }

  Index origin(Index h) const { return faces_[h >> 2].vertex[h & 3]; }
  Index target(Index h) const { return origin(next(h)); }
  Index apex(Index h) const { return origin(prev(h)); }
  // The origin of any half-edge, border sides included.
  Index source(Index h) const { return h >= 0 ? origin(h) : target(~h); }
  Index opposite(Index h) const { return h < 0 ? ~h : faces_[h >> 2].opposite[h & 3]; }
  // Whether h stands for its edge: of two half-edges the smaller one; at the border the only one, as its opposite is negative.
  bool names_edge(Index h) const { return std::uint32_t(faces_[h >> 2].opposite[h & 3]) > std::uint32_t(h); }
  bool is_border(Index h) const { return faces_[h >> 2].opposite[h & 3] < 0; }

  // The next half-edge with the same origin, counterclockwise; a border side where the fan ends.
  Index rotate_ccw(Index h) const { return faces_[h >> 2].opposite[prev(h) & 3]; }
  // The next one clockwise; negative where h is on the border.
  Index rotate_cw(Index h) const
  {
    const Index o = faces_[h >> 2].opposite[h & 3];
    return o < 0 ? o : next(o);
  }

  bool is_face(Index f) const { return faces_[f].vertex[0] >= 0; }
  std::size_t number_of_face_slots() const { return faces_.size(); }

  Face& face_record(Index f) { return faces_[f]; }
  const Face& face_record(Index f) const { return faces_[f]; }

  void set_origin(Index h, Index v) { faces_[h >> 2].vertex[h & 3] = v; }
  // Makes g and h opposite half-edges; where one of them is a border side, the other one becomes a border.
  void glue(Index g, Index h)
  {
    if (g >= 0) faces_[g >> 2].opposite[g & 3] = h >= 0 ? h : ~g;
    if (h >= 0) faces_[h >> 2].opposite[h & 3] = g >= 0 ? g : ~h;
  }

  void resize_faces(std::size_t n) { faces_.resize(n); }
  void reserve_faces(std::size_t n) { faces_.reserve(n); }

  // Calls `function(h)` for the half-edges of the faces.
  template <class Function>
  void for_each_halfedge(const Function& function) const
  {
    for (Index f = 0; f < Index(faces_.size()); ++f)
      if (is_face(f)) { function(4 * f); function(4 * f + 1); function(4 * f + 2); }
  }
  // Calls `function(h)` for one half-edge of each edge.
  template <class Function>
  void for_each_edge(const Function& function) const
  {
    for_each_halfedge([&](Index h) { if (names_edge(h)) function(h); });
  }

  // Calls `function(k)` for the half-edges k that leave the origin of `first` through a face, counterclockwise.
  // Where the origin is on the border, `first` must be the one that begins the fan, see fan_start().
  template <class Function>
  void for_each_in_fan(Index first, const Function& function) const
  {
    Index k = first;
    do {
      const Index following = rotate_ccw(k);
      function(k);
      k = following;
    } while (k >= 0 && k != first);
  }

  // The half-edge with which the fan of h's origin begins: h itself unless the origin is on the border.
  Index fan_start(Index h) const
  {
    Index k = h;
    for (;;) {
      const Index before = rotate_cw(k);
      if (before < 0) return k;
      if (before == h) return h;
      k = before;
    }
  }

protected:
  std::vector<Face> faces_;
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_CORNER_TABLE_H
