// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_SWEEP_DATA_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_SWEEP_DATA_H

#include <CGAL/Inter_angle_remeshing/internal/Remeshing_mesh.h>
#include <CGAL/Inter_angle_remeshing/internal/parallel_blocks.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// The mesh as sweeps over its vertices want it: live vertices in block order, numbered anew, their data and rings
// (as compressed rows) contiguous. Blocks that share an edge have different colours: the blocks of one colour may be
// swept concurrently, in place, and the result does not depend on how many threads do it.
class Sweep_data
{
public:
  using Index = Remeshing_mesh::Index;

  enum class Mobility : std::uint8_t
  {
    fixed,     // on a curve, or locked
    guarded,   // beside a curve, whose vertices cannot get out of the way: every step is tested
    free
  };

  // Reads the mesh. Buffers are used again from one pass to the next.
  template <class ConcurrencyTag>
  void read(const Remeshing_mesh& mesh);
  // Writes positions and hints back.
  void write(Remeshing_mesh& mesh) const
  {
    for (std::size_t i = 0; i < order.size(); ++i) {
      mesh.position(order[i]) = position[i];
      mesh.hint(order[i]) = hint[i];
    }
  }

  std::size_t size() const { return order.size(); }
  const Index* ring(std::size_t i) const { return rings_.data() + ring_start_[i]; }
  int valence(std::size_t i) const { return int(ring_start_[i + 1] - ring_start_[i]); }

  // Calls `function(begin, end)` for every block, colour by colour.
  template <class ConcurrencyTag, class Function>
  void for_each_coloured_block(const Function& function) const
  {
    for (const std::vector<Index>& colour : colours_)
      for_each_block<ConcurrencyTag>(colour.size(), 1, [&](std::size_t i, std::size_t, std::size_t) {
        const std::size_t begin = std::size_t(colour[i]) << block_shift_;
        function(begin, (std::min)(size(), begin + (std::size_t(1) << block_shift_)));
      });
  }

  std::vector<Index> order;            // the mesh's vertices
  std::vector<Vector3> position;
  std::vector<Index> hint;
  std::vector<Mobility> mobility;

private:
  template <class ConcurrencyTag>
  void read_rings(const Remeshing_mesh& mesh);
  template <class ConcurrencyTag>
  void guard_beside_curves(const Remeshing_mesh& mesh);
  template <class ConcurrencyTag>
  void colour_blocks();
  void find_neighbor_blocks(std::size_t block, std::vector<Index>& neighbors) const;

  std::vector<Index> rank_;            // of the mesh's vertices in the order
  std::vector<std::uint32_t> ring_start_;
  std::vector<Index> rings_;
  unsigned block_shift_ = 0;           // blocks hold 2^block_shift_ vertices
  std::vector<std::vector<Index>> neighbor_blocks_;
  std::vector<std::vector<Index>> colours_;
};

template <class ConcurrencyTag>
void Sweep_data::read(const Remeshing_mesh& mesh)
{
  order = mesh.block_order();
  const std::size_t n = order.size();
  rank_.resize(mesh.number_of_vertex_slots());
  position.resize(n);
  hint.resize(n);
  mobility.resize(n);
  ring_start_.resize(n + 1);
  for_each_block<ConcurrencyTag>(n, SCAN_BLOCK, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) {
      const Index v = order[i];
      const bool is_fixed = !mesh.is_free(v);
      rank_[v] = Index(i);
      position[i] = mesh.position(v);
      hint[i] = mesh.hint(v);
      mobility[i] = is_fixed ? Mobility::fixed : Mobility::free;
      ring_start_[i + 1] = is_fixed ? 0 : std::uint32_t(mesh.valence(v));
    }
  });
  ring_start_[0] = 0;
  for (std::size_t i = 0; i < n; ++i) ring_start_[i + 1] += ring_start_[i];
  read_rings<ConcurrencyTag>(mesh);
  if (std::find(mobility.begin(), mobility.end(), Mobility::fixed) != mobility.end())
    guard_beside_curves<ConcurrencyTag>(mesh);
  block_shift_ = Remeshing_mesh::block_shift(n);
  colour_blocks<ConcurrencyTag>();
}

template <class ConcurrencyTag>
void Sweep_data::read_rings(const Remeshing_mesh& mesh)
{
  rings_.resize(ring_start_.back());
  for_each_block<ConcurrencyTag>(size(), SCAN_BLOCK, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) {
      if (mobility[i] == Mobility::fixed) continue;
      Index* out = rings_.data() + ring_start_[i];
      mesh.for_each_in_fan(mesh.first(order[i]), [&](Index h) { *out++ = rank_[mesh.target(h)]; });
    }
  });
}

inline void Sweep_data::find_neighbor_blocks(std::size_t block, std::vector<Index>& neighbors) const
{
  const std::size_t begin = block << block_shift_;
  const std::size_t end = (std::min)(size(), begin + (std::size_t(1) << block_shift_));
  neighbors.clear();
  Index last = -1;
  for (std::uint32_t i = ring_start_[begin]; i < ring_start_[end]; ++i) {
    const Index other = rings_[i] >> block_shift_;
    if (other == last || std::size_t(other) == block) continue;
    last = other;
    if (std::find(neighbors.begin(), neighbors.end(), other) == neighbors.end()) neighbors.push_back(other);
  }
}

template <class ConcurrencyTag>
void Sweep_data::guard_beside_curves(const Remeshing_mesh& mesh)
{
  for_each_block<ConcurrencyTag>(size(), SCAN_BLOCK, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i)
      if (mobility[i] == Mobility::free &&
          std::any_of(ring(i), ring(i) + valence(i), [&](Index j) { return mesh.is_on_curve(order[j]); }))
        mobility[i] = Mobility::guarded;
  });
}

// Greedy, in block order; 8 to 10 colours.
template <class ConcurrencyTag>
void Sweep_data::colour_blocks()
{
  const std::size_t blocks = number_of_blocks(size(), std::size_t(1) << block_shift_);
  neighbor_blocks_.resize(blocks);
  for_each_block<ConcurrencyTag>(blocks, 8, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t b = begin; b < end; ++b) find_neighbor_blocks(b, neighbor_blocks_[b]);
  });
  colours_.clear();
  std::vector<Index> colour_of(blocks, -1), seen_by;
  for (std::size_t b = 0; b < blocks; ++b) {
    for (const Index other : neighbor_blocks_[b])
      if (colour_of[other] >= 0) seen_by[colour_of[other]] = Index(b);
    const Index colour = Index(std::find_if(seen_by.begin(), seen_by.end(), [&](Index s) { return s != Index(b); }) -
                               seen_by.begin());
    if (std::size_t(colour) == seen_by.size()) {
      seen_by.push_back(-1);
      colours_.emplace_back();
    }
    colour_of[b] = colour;
    colours_[colour].push_back(Index(b));
  }
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_SWEEP_DATA_H
