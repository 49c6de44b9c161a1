// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_RIM_CHAINS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_RIM_CHAINS_H

#include <CGAL/Inter_angle_remeshing/internal/mesh/Remeshing_mesh.h>

#include <algorithm>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// What the edges of the input on the rim of the range have become that were split.
class Rim_chains
{
  using Index = Remeshing_mesh::Index;

public:
  struct Chain
  {
    Index source, target;                // input vertices, by number
    std::vector<Index> halfedges;        // from the one to the other, each through a face of the range
  };

  explicit Rim_chains(const Remeshing_mesh& mesh)
  {
    for (Index v = 0; v < Index(mesh.number_of_vertex_slots()); ++v) {
      if (!mesh.is_vertex(v) || mesh.input(v) < 0 || (mesh.marks(v) & Remeshing_mesh::NEXT_TO_OUTSIDE) == 0) continue;
      const Index h = mesh.first(v);
      if (mesh.is_on_rim(h) && mesh.input(mesh.target(h)) < 0) chains_.push_back(chain_from(mesh, h));
    }
    std::sort(chains_.begin(), chains_.end(), [](const Chain& a, const Chain& b) { return ends(a) < ends(b); });
  }

  std::vector<Chain>::const_iterator begin() const { return chains_.begin(); }
  std::vector<Chain>::const_iterator end() const { return chains_.end(); }

  // The chain between these input vertices, null where their edge is whole.
  const Chain* find(Index source, Index target) const
  {
    const auto i = std::lower_bound(chains_.begin(), chains_.end(), std::make_tuple(source, target),
                                    [](const Chain& a, const std::tuple<Index, Index>& b) { return ends(a) < b; });
    return i != chains_.end() && ends(*i) == std::make_tuple(source, target) ? &*i : nullptr;
  }

private:
  static std::tuple<Index, Index> ends(const Chain& c) { return {c.source, c.target}; }

  static Chain chain_from(const Remeshing_mesh& mesh, Index h)
  {
    Chain result{mesh.input(mesh.origin(h)), -1, {h}};
    while (mesh.input(mesh.target(h)) < 0) {
      h = mesh.first(mesh.target(h));
      result.halfedges.push_back(h);
    }
    result.target = mesh.input(mesh.target(h));
    return result;
  }

  std::vector<Chain> chains_;            // by their ends
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_RIM_CHAINS_H
