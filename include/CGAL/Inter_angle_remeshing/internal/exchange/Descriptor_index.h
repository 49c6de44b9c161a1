// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_EXCHANGE_DESCRIPTOR_INDEX_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_EXCHANGE_DESCRIPTOR_INDEX_H

#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// Numbers for the descriptors of a range: memory and time follow the range, not the mesh, and the mesh needs no
// index maps. An open-addressing table. The first probe is the hash value itself, for meshes hash their descriptors
// by index or by address and lie in the table as in memory: in long runs of taken slots. A probe that meets a taken
// slot is therefore followed by jumps of a width that depends on the value (double hashing), not by the next slots.
template <class Descriptor>
class Descriptor_index
{
public:
  using Index = std::int32_t;

  explicit Descriptor_index(std::size_t capacity)
  {
    std::size_t size = 16;
    while (size < 2 * capacity) size *= 2;
    slots_.resize(size, Slot{Descriptor(), -1});
  }

  // Gives `d` the number `i`, unless it has one; returns its number and whether it is new.
  std::pair<Index, bool> insert(const Descriptor& d, Index i)
  {
    Slot& slot = slots_[find_slot(d)];
    if (slot.second >= 0) return {slot.second, false};
    slot = {d, i};
    return {i, true};
  }

  // The number of `d`, -1 where it has none.
  Index find(const Descriptor& d) const { return slots_[find_slot(d)].second; }

private:
  using Slot = std::pair<Descriptor, Index>;

  std::size_t find_slot(const Descriptor& d) const
  {
    const std::size_t mask = slots_.size() - 1;
    const std::size_t hash = std::hash<Descriptor>()(d);
    std::size_t i = hash & mask;
    if (is_at(i, d)) return i;
    // Fibonacci hashing: the golden ratio times 2^64 spreads any pattern.
    const std::uint64_t mixed = std::uint64_t(hash) * 0x9E3779B97F4A7C15ull;
    const std::size_t jump = std::size_t(mixed >> 13) | 1;   // odd: it meets every slot
    i = std::size_t(mixed >> 32) & mask;
    while (!is_at(i, d)) i = (i + jump) & mask;
    return i;
  }

  bool is_at(std::size_t i, const Descriptor& d) const
  {
    return slots_[i].second < 0 || slots_[i].first == d;
  }

  std::vector<Slot> slots_;
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_EXCHANGE_DESCRIPTOR_INDEX_H
