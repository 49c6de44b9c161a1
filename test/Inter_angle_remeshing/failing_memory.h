// Copyright (c) 2026 The Inter_angle_remeshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_TEST_FAILING_MEMORY_H
#define CGAL_INTER_ANGLE_REMESHING_TEST_FAILING_MEMORY_H

// Memory that runs out when a test wants it to. Replaces the program's allocation functions: for its one source file.

#include <cstddef>
#include <cstdlib>
#include <new>

// Allocations until one fails; 0: none does.
inline std::size_t allocations_left = 0;

#ifdef __GNUC__
#  define NOT_INLINED __attribute__((noinline))   // or the compiler finds malloc() behind new without free() behind delete
#else
#  define NOT_INLINED
#endif

NOT_INLINED void* operator new(std::size_t size)
{
  if(allocations_left > 0 && --allocations_left == 0)
    throw std::bad_alloc();
  if(void* p = std::malloc(size > 0 ? size : 1))
    return p;
  throw std::bad_alloc();
}
NOT_INLINED void* operator new(std::size_t size, const std::nothrow_t&) noexcept // what sorts take their buffers by
{
  if(allocations_left > 0 && --allocations_left == 0)
    return nullptr;
  return std::malloc(size > 0 ? size : 1);
}
NOT_INLINED void operator delete(void* p) noexcept { std::free(p); }
NOT_INLINED void operator delete(void* p, const std::nothrow_t&) noexcept { std::free(p); }
NOT_INLINED void operator delete(void* p, std::size_t) noexcept { std::free(p); }

#endif // CGAL_INTER_ANGLE_REMESHING_TEST_FAILING_MEMORY_H
