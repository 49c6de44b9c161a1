// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_PARALLEL_BLOCKS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_PARALLEL_BLOCKS_H

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>
#endif

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <vector>

// Loops over fixed blocks. How a range is cut depends on its length alone, never on the tag or on the number of
// threads; what a block yields is put together in block order: the result is the same to the last bit.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

template <class ConcurrencyTag>
constexpr bool is_parallel()
{
#ifdef CGAL_LINKED_WITH_TBB
  return std::is_convertible<ConcurrencyTag, CGAL::Parallel_tag>::value;
#else
  static_assert(!std::is_convertible<ConcurrencyTag, CGAL::Parallel_tag>::value,
                "CGAL::Parallel_tag was asked for, but TBB is not linked: link CGAL::TBB_support, "
                "or use CGAL::Parallel_if_available_tag.");
  return false;
#endif
}

inline std::size_t number_of_blocks(std::size_t n, std::size_t block_size)
{
  return (n + block_size - 1) / block_size;
}

// Calls `function(begin, end, block)` for every block of [0, n). What the caller's own tasks do has no part in it: that they are
// cancelled must not leave blocks out, and none of them is taken up while this thread waits for the others.
template <class ConcurrencyTag, class Function>
void for_each_block(std::size_t n, std::size_t block_size, const Function& function)
{
  const std::size_t blocks = number_of_blocks(n, block_size);
  const auto run = [&](std::size_t block) {
    function(block * block_size, (std::min)(n, (block + 1) * block_size), block);
  };
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr (is_parallel<ConcurrencyTag>()) {
    tbb::task_group_context context(tbb::task_group_context::isolated);
    tbb::this_task_arena::isolate([&]() { tbb::parallel_for(std::size_t(0), blocks, run, context); });
    return;
  }
#else
  (void)is_parallel<ConcurrencyTag>();
#endif
  for (std::size_t block = 0; block < blocks; ++block)
    run(block);
}

// The same, but one block after the other where the function is not one for several threads.
template <class ConcurrencyTag, class Function>
void for_each_block_if(bool is_concurrent, std::size_t n, std::size_t block_size, const Function& function)
{
  if (is_concurrent) for_each_block<ConcurrencyTag>(n, block_size, function);
  else for_each_block<CGAL::Sequential_tag>(n, block_size, function);
}

// Elements scanned by one task: large enough that the task's own cost (about 1 us) is lost in it.
constexpr std::size_t SCAN_BLOCK = 8192;

// Gathers what `scan(i, out)` appends to `out` for every i of [0, n), in the order of i.
template <class ConcurrencyTag, class T, class Scan>
void scan_into(std::vector<T>& result, std::size_t n, const Scan& scan)
{
  result.clear();
  if constexpr (!is_parallel<ConcurrencyTag>()) {
    for (std::size_t i = 0; i < n; ++i)
      scan(i, result);
  } else {
    std::vector<std::vector<T>> found(number_of_blocks(n, SCAN_BLOCK));
    for_each_block<ConcurrencyTag>(n, SCAN_BLOCK, [&](std::size_t begin, std::size_t end, std::size_t block) {
      for (std::size_t i = begin; i < end; ++i)
        scan(i, found[block]);
    });
    for (const std::vector<T>& part : found)
      result.insert(result.end(), part.begin(), part.end());
  }
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_PARALLEL_BLOCKS_H
