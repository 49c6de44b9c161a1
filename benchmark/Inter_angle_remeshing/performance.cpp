// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Time and memory of isotropic_remeshing(), of this package and of Polygon_mesh_processing, on the same mesh in the
// same run: machines are noisy, ratios less so. The mesh is elephant.off, subdivided 0 to 4 times (5.5k to 1.4M faces),
// remeshed at its mean edge length with 10 iterations. The argument is the number of subdivisions.
//
//   performance [--benchmark_filter=own_length/2] [Google Benchmark's options]

#include "meshes.h"
#include "peak_memory.h"

#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>

#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Real_timer.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <benchmark/benchmark.h>

#include <string>

namespace {

struct Cost
{
  double seconds = 0;
  double mebibytes = 0;
};

template <class TriangleMesh, class Remesh>
Cost measure(const TriangleMesh& input, const Remesh& remesh)
{
  TriangleMesh mesh(input);
  reset_peak();
  const double before = peak_memory();
  CGAL::Real_timer timer;
  timer.start();
  remesh(mesh);
  timer.stop();
  return {timer.time(), peak_memory() - before};
}

Mesh subdivided_elephant(int times)
{
  Mesh mesh = read_mesh(CGAL::data_file_path("meshes/elephant.off"));
  for (int i = 0; i < times; ++i) mesh = subdivide(mesh);
  return mesh;
}

constexpr unsigned ITERATIONS = 10;
const auto parameters = CGAL::parameters::number_of_iterations(ITERATIONS);

template <class ConcurrencyTag, class TriangleMesh>
Cost cost_of_this_package(const TriangleMesh& input, double length)
{
  return measure(input, [&](TriangleMesh& mesh) {
    CGAL::Inter_angle_remeshing::isotropic_remeshing<ConcurrencyTag>(faces(mesh), length, mesh, parameters);
  });
}

void own_length(benchmark::State& state)
{
  const Mesh input = subdivided_elephant(int(state.range(0)));
  const double length = mean_edge_length(input);
  double seconds = 0, pmp_seconds = 0;
  for (auto _ : state) {
    const Cost ours = cost_of_this_package<CGAL::Sequential_tag>(input, length);
    const Cost pmp = measure(input, [&](Mesh& mesh) {
      CGAL::Polygon_mesh_processing::isotropic_remeshing(faces(mesh), length, mesh, parameters);
    });
    state.SetIterationTime(ours.seconds);
    seconds += ours.seconds;
    pmp_seconds += pmp.seconds;
    state.counters["MiB"] = ours.mebibytes;
    state.counters["PMP_MiB"] = pmp.mebibytes;
  }
  state.counters["faces"] = double(input.number_of_faces());
  state.counters["us_a_face"] = 1e6 * seconds / double(state.iterations()) / double(input.number_of_faces());
  state.counters["PMP_ms"] = 1e3 * pmp_seconds / double(state.iterations());
  state.counters["PMP_to_ours"] = pmp_seconds / seconds;
}
BENCHMARK(own_length)->DenseRange(0, 4)->UseManualTime()->Unit(benchmark::kMillisecond);

void polyhedron(benchmark::State& state)
{
  using Polyhedron = CGAL::Polyhedron_3<Kernel>;
  const Mesh input = subdivided_elephant(int(state.range(0)));
  const double length = mean_edge_length(input);
  Polyhedron polyhedron;
  CGAL::copy_face_graph(input, polyhedron);
  double seconds = 0, surface_mesh_seconds = 0;
  for (auto _ : state) {
    const double time = cost_of_this_package<CGAL::Sequential_tag>(polyhedron, length).seconds;
    state.SetIterationTime(time);
    seconds += time;
    surface_mesh_seconds += cost_of_this_package<CGAL::Sequential_tag>(input, length).seconds;
  }
  state.counters["faces"] = double(input.number_of_faces());
  state.counters["to_Surface_mesh"] = seconds / surface_mesh_seconds;
}
BENCHMARK(polyhedron)->DenseRange(1, 4)->UseManualTime()->Unit(benchmark::kMillisecond);

#ifdef CGAL_LINKED_WITH_TBB
void parallel(benchmark::State& state)
{
  const Mesh input = subdivided_elephant(int(state.range(0)));
  const double length = mean_edge_length(input);
  double seconds = 0, sequential_seconds = 0;
  for (auto _ : state) {
    const double time = cost_of_this_package<CGAL::Parallel_tag>(input, length).seconds;
    state.SetIterationTime(time);
    seconds += time;
    sequential_seconds += cost_of_this_package<CGAL::Sequential_tag>(input, length).seconds;
  }
  state.counters["faces"] = double(input.number_of_faces());
  state.counters["speedup"] = sequential_seconds / seconds;
}
BENCHMARK(parallel)->DenseRange(1, 4)->UseManualTime()->Unit(benchmark::kMillisecond);
#endif

} // namespace

BENCHMARK_MAIN();
