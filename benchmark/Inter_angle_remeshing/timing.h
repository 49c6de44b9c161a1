// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTER_ANGLE_REMESHING_BENCHMARK_TIMING_H
#define INTER_ANGLE_REMESHING_BENCHMARK_TIMING_H

#include "meshes.h"

#include <CGAL/Real_timer.h>

#include <algorithm>
#include <cstddef>
#include <vector>

// Of nothing 0.
inline double median(std::vector<double> values)
{
  if (values.empty()) return 0;
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

template <class Function>
double seconds(const Function& function)
{
  CGAL::Real_timer timer;
  timer.start();
  function();
  timer.stop();
  return timer.time();
}

// For `remesh(result)` on a copy of the input; what follows finds no garbage.
template <class Remesh>
double seconds(const Mesh& input, Mesh& result, const Remesh& remesh)
{
  result = input;
  const double time = seconds([&]() { remesh(result); });
  result.collect_garbage();
  return time;
}

#endif // INTER_ANGLE_REMESHING_BENCHMARK_TIMING_H
