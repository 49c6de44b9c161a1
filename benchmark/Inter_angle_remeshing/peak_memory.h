// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_BENCHMARK_PEAK_MEMORY_H
#define CGAL_INTER_ANGLE_REMESHING_BENCHMARK_PEAK_MEMORY_H

#include <fstream>
#include <string>

#ifdef __GLIBC__
#  include <malloc.h>
#endif

// The most memory the process held since the last call of reset_peak(), in MiB; 0 where the system does not tell.
inline double peak_memory()
{
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (word == "VmHWM:") {
      double kibibytes = 0;
      status >> kibibytes;
      return kibibytes / 1024;
    }
  return 0;
}

// Gives back what earlier runs have left to the allocator: what a run takes is to be seen.
inline void reset_peak()
{
#ifdef __GLIBC__
  malloc_trim(0);
#endif
  std::ofstream("/proc/self/clear_refs") << "5\n";
}

#endif // CGAL_INTER_ANGLE_REMESHING_BENCHMARK_PEAK_MEMORY_H
