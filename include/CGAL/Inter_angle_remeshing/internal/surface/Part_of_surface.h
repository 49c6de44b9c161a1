// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_PART_OF_SURFACE_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_PART_OF_SURFACE_H

#include <CGAL/Inter_angle_remeshing/internal/mesh/Remeshing_mesh.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/Reference_surface.h>

#include <boost/functional/hash.hpp>

#include <cstddef>
#include <unordered_map>
#include <vector>

// Whether a mesh that has no free slots is a part of a surface: a range of faces, where the surface is that of the whole mesh. Points are
// compared exactly, the mesh's times `factor`.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

class Part_of_surface
{
  using Index = Remeshing_mesh::Index;

public:
  Part_of_surface(const Remeshing_mesh& mesh, const Reference_surface& surface, double factor)
    : mesh_(mesh), surface_(surface), factor_(factor), first_(mesh.number_of_face_slots(), -1)
  {
    if (first_.size() > surface.number_of_faces() || !(place_one_face_of_each_component() && place_neighbors())) first_.clear();
  }

  bool is_part() const { return !first_.empty(); }

  // The half-edge of the surface that is the mesh's.
  Index halfedge(Index h) const
  {
    Index result = first_[mesh_.face(h)];
    for (int k = mesh_.corner(h); k > 0; --k) result = surface_.next(result);
    return result;
  }

private:
  struct Hash
  {
    std::size_t operator()(const Vector3& p) const
    {
      std::size_t result = 0;
      for (const double x : {p.x, p.y, p.z}) boost::hash_combine(result, x == 0 ? 0. : x);    // of -0, too
      return result;
    }
  };

  Vector3 point(Index h) const { return factor_ * mesh_.position(mesh_.origin(h)); }

  // Whether the face of the surface has the corners of the mesh's face f, from k on.
  bool is_at(Index f, Index k) const
  {
    for (Index h = 4 * f; h < 4 * f + 3; ++h, k = surface_.next(k))
      if (point(h) != surface_.position(surface_.origin(k))) return false;
    return true;
  }

  // Whether they are the same face of the user's, if all are numbered alike.
  bool has_number_of(Index f, Index k) const { return mesh_.face_record(f).source == surface_.face_record(surface_.face(k)).source; }

  // Looks for the first face of each component among all faces of the surface. Of components that lie upon each other each finds one for
  // itself, where the two are numbered alike its own.
  bool place_one_face_of_each_component()
  {
    std::unordered_multimap<Vector3, Index, Hash> sought;
    std::vector<char> is_reached(first_.size(), 0);
    std::vector<Index> queue;
    for (Index seed = 0; seed < Index(first_.size()); ++seed) {
      if (is_reached[seed]) continue;
      sought.emplace(point(4 * seed), seed);
      is_reached[seed] = 1;
      for (queue.assign(1, seed); !queue.empty();) {
        const Index f = queue.back();
        queue.pop_back();
        for (Index h = 4 * f; h < 4 * f + 3; ++h) {
          if (mesh_.is_border(h)) continue;
          const Index g = mesh_.face(mesh_.opposite(h));
          if (!is_reached[g]) { is_reached[g] = 1; queue.push_back(g); }
        }
      }
    }
    surface_.for_each_halfedge([&](Index k) {
      const auto candidates = sought.equal_range(surface_.position(surface_.origin(k)));
      auto found = candidates.second;
      for (auto c = candidates.first; c != candidates.second; ++c)
        if (is_at(c->second, k) && (found == candidates.second || has_number_of(c->second, k))) found = c;
      if (found == candidates.second) return;
      first_[found->second] = k;
      sought.erase(found);
    });
    return sought.empty();
  }

  // From there on, over the edges.
  bool place_neighbors()
  {
    std::vector<Index> queue;
    for (Index f = 0; f < Index(first_.size()); ++f) if (first_[f] >= 0) queue.push_back(f);
    while (!queue.empty()) {
      const Index f = queue.back();
      queue.pop_back();
      for (Index h = 4 * f; h < 4 * f + 3; ++h) {
        if (mesh_.is_border(h)) continue;
        const Index o = mesh_.opposite(h), g = mesh_.face(o);
        Index k = surface_.opposite(halfedge(h));
        if (k < 0) return false;
        for (int c = mesh_.corner(o); c > 0; --c) k = surface_.prev(k);
        if (first_[g] == k) continue;
        if (first_[g] >= 0 || !is_at(g, k)) return false;
        first_[g] = k;
        queue.push_back(g);
      }
    }
    return true;
  }

  const Remeshing_mesh& mesh_;
  const Reference_surface& surface_;
  double factor_;
  std::vector<Index> first_;             // the surface's half-edge that is the mesh's at corner 0, by face; empty: it is no part
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_PART_OF_SURFACE_H
