// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_SWEEP_DATA_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_SWEEP_DATA_H

#include <CGAL/Inter_angle_remeshing/internal/curves/curves.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/parallel_blocks.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
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
    fixed,                // locked, or pinned on a curve
    sliding,              // on a curve
    sliding_on_border,    // on one that is a border: the ring is open
    guarded,              // beside a curve, whose vertices cannot get out of the way: every step is tested
    free
  };

  // Vertices that move, as the first of these, and those around them, which do not.
  struct Region
  {
    std::vector<Index> vertices;
    std::size_t movable = 0;
  };

  // Reads the mesh, or a region of it. Buffers are used again from one pass to the next.
  template <class ConcurrencyTag>
  void read(const Remeshing_mesh& mesh, const Region* region = nullptr);
  // Writes positions and hints back.
  void write(Remeshing_mesh& mesh) const
  {
    for (std::size_t i = 0; i < order.size(); ++i) {
      mesh.position(order[i]) = position[i];
      mesh.hint(order[i]) = hint[i];
    }
  }

  std::size_t size() const { return order.size(); }
  std::size_t number_of_movable() const
  {
    return size() - std::size_t(std::count(mobility.begin(), mobility.end(), Mobility::fixed));
  }
  bool is_sliding(std::size_t i) const
  {
    return mobility[i] == Mobility::sliding || mobility[i] == Mobility::sliding_on_border;
  }
  // The two edges of a sliding vertex on its curve: its place there, see Remeshing_mesh::curve_end(), and their other ends.
  struct Slide
  {
    std::array<Index, 2> ends, neighbors;
  };
  const Slide& slide(std::size_t i) const { return slides_[slide_of_[i]]; }

  // Calls `function(u, v)` for the link edges of a vertex that is not fixed, as long as it returns true.
  template <class Function>
  bool all_of_link(std::size_t i, const Function& function) const
  {
    const int n = valence(i);
    const Index* r = ring(i);
    const bool is_open = mobility[i] == Mobility::sliding_on_border;
    for (int k = is_open ? 1 : 0; k < n; ++k)
      if (!function(r[k == 0 ? n - 1 : k - 1], r[k])) return false;
    return true;
  }
  // Where vertex v of the mesh is in the order.
  Index rank(Index v) const { return rank_[v]; }
  const Index* ring(std::size_t i) const { return rings_.data() + ring_start_[i]; }
  int valence(std::size_t i) const { return int(ring_start_[i + 1] - ring_start_[i]); }

  // Calls `function(begin, end)` for every block, colour by colour; one after the other where it is not concurrent.
  template <class ConcurrencyTag, class Function>
  void for_each_coloured_block(bool is_concurrent, const Function& function) const
  {
    for (const std::vector<Index>& colour : colours_)
      for_each_block_if<ConcurrencyTag>(is_concurrent, colour.size(), 1, [&](std::size_t i, std::size_t, std::size_t) {
        const std::size_t begin = std::size_t(colour[i]) << block_shift_;
        function(begin, (std::min)(size(), begin + (std::size_t(1) << block_shift_)));
      });
  }

  std::vector<Index> order;            // the mesh's vertices
  std::vector<Vector3> position;
  std::vector<Index> hint;
  std::vector<Mobility> mobility;

private:
  static constexpr std::size_t RINGS_AT_ONCE = 8;

  template <class ConcurrencyTag>
  void read_rings(const Remeshing_mesh& mesh);
  void read_some_rings(const Remeshing_mesh& mesh, std::size_t begin, std::size_t end);
  void read_slides(const Remeshing_mesh& mesh);
  void find_neighbor_blocks(std::size_t begin, std::size_t end, Index block);
  template <class ConcurrencyTag>
  void guard_beside_curves(const Remeshing_mesh& mesh);
  void colour_blocks();

  std::vector<Index> rank_;            // of the mesh's vertices in the order
  std::vector<std::uint32_t> ring_start_;
  std::vector<Index> rings_;
  std::vector<Index> slide_of_;        // by vertex, if there are sliding ones
  std::vector<Slide> slides_;
  unsigned block_shift_ = 0;           // blocks hold 2^block_shift_ vertices
  std::vector<std::vector<Index>> neighbor_blocks_;
  std::vector<std::vector<Index>> colours_;
};

template <class ConcurrencyTag>
void Sweep_data::read(const Remeshing_mesh& mesh, const Region* region)
{
  order = region == nullptr ? mesh.block_order() : region->vertices;
  const std::size_t n = order.size();
  rank_.resize(mesh.number_of_vertex_slots());
  position.resize(n);
  hint.resize(n);
  mobility.resize(n);
  ring_start_.resize(n + 1);
  for_each_block<ConcurrencyTag>(n, SCAN_BLOCK, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) {
      const Index v = order[i];
      const bool is_sliding = mesh.is_sliding(v), is_outer = region != nullptr && i >= region->movable,
                 is_fixed = is_outer || (!mesh.is_free(v) && !is_sliding);
      rank_[v] = Index(i);
      position[i] = mesh.position(v);
      hint[i] = mesh.hint(v);
      mobility[i] = is_fixed ? Mobility::fixed : !is_sliding ? Mobility::free
                    : mesh.is_border_vertex(v) ? Mobility::sliding_on_border : Mobility::sliding;
      ring_start_[i + 1] = is_fixed ? 0 : std::uint32_t(mesh.valence(v));
    }
  });
  ring_start_[0] = 0;
  for (std::size_t i = 0; i < n; ++i) ring_start_[i + 1] += ring_start_[i];
  block_shift_ = Remeshing_mesh::block_shift(n);
  read_rings<ConcurrencyTag>(mesh);
  if (mesh.has_curves()) read_slides(mesh);
  if (mesh.has_curves() || std::find(mobility.begin(), mobility.end(), Mobility::fixed) != mobility.end())
    guard_beside_curves<ConcurrencyTag>(mesh);
  colour_blocks();
}

// Turning about a vertex is a chain of loads that wait for each other: several rings are read side by side. Notes
// beside the rings which blocks border on which.
template <class ConcurrencyTag>
void Sweep_data::read_rings(const Remeshing_mesh& mesh)
{
  rings_.resize(ring_start_.back());
  const std::size_t block_size = std::size_t(1) << block_shift_;
  neighbor_blocks_.resize(number_of_blocks(size(), block_size));
  for_each_block<ConcurrencyTag>(size(), block_size, [&](std::size_t begin, std::size_t end, std::size_t block) {
    for (std::size_t i = begin; i < end; i += RINGS_AT_ONCE)
      read_some_rings(mesh, i, (std::min)(end, i + RINGS_AT_ONCE));
    find_neighbor_blocks(begin, end, Index(block));
  });
}

inline void Sweep_data::read_some_rings(const Remeshing_mesh& mesh, std::size_t begin, std::size_t end)
{
  std::array<Index, RINGS_AT_ONCE> h;
  std::array<Index*, RINGS_AT_ONCE> next, last;
  std::size_t n = 0;
  int shortest = (std::numeric_limits<int>::max)(), longest = 0;
  for (std::size_t i = begin; i < end; ++i) {
    if (mobility[i] == Mobility::fixed) continue;
    Index* r = rings_.data() + ring_start_[i];
    if (mobility[i] == Mobility::sliding_on_border) {
      mesh.for_each_neighbor(order[i], [&](Index u) { *r++ = rank_[u]; });
      continue;
    }
    h[n] = mesh.first(order[i]);
    next[n] = r;
    last[n++] = r + valence(i);
    shortest = (std::min)(shortest, valence(i));
    longest = (std::max)(longest, valence(i));
  }
  if (n == 0) return;                    // there is no least valence
  const auto read_neighbor = [&](std::size_t i) {
    *next[i]++ = rank_[mesh.target(h[i])];
    h[i] = mesh.rotate_ccw(h[i]);
  };
  for (int k = 0; k < shortest; ++k)
    for (std::size_t i = 0; i < n; ++i) read_neighbor(i);
  for (int k = shortest; k < longest; ++k)
    for (std::size_t i = 0; i < n; ++i)
      if (next[i] != last[i]) read_neighbor(i);
}

inline void Sweep_data::read_slides(const Remeshing_mesh& mesh)
{
  slide_of_.assign(size(), -1);
  slides_.clear();
  for (std::size_t i = 0; i < size(); ++i) {
    if (!is_sliding(i)) continue;
    Slide slide{};
    std::size_t n = 0;
    for_each_curve_halfedge(mesh, order[i], [&](Index h) {
      if (n == 2) return;
      slide.ends[n] = mesh.curve_end(h);
      slide.neighbors[n++] = rank_[mesh.source(mesh.opposite(h))];
    });
    slide_of_[i] = Index(slides_.size());
    slides_.push_back(slide);
  }
}

inline void Sweep_data::find_neighbor_blocks(std::size_t begin, std::size_t end, Index block)
{
  std::vector<Index>& neighbors = neighbor_blocks_[block];
  neighbors.clear();
  std::array<Index, 16> met;             // lately, by their last digits
  met.fill(-1);
  for (std::uint32_t k = ring_start_[begin]; k < ring_start_[end]; ++k) {
    const Index other = rings_[k] >> block_shift_;
    Index& last = met[std::size_t(other) % met.size()];
    if (last == other) continue;
    last = other;
    if (other != block && std::find(neighbors.begin(), neighbors.end(), other) == neighbors.end()) neighbors.push_back(other);
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
inline void Sweep_data::colour_blocks()
{
  const std::size_t blocks = neighbor_blocks_.size();
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

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_SWEEP_DATA_H
