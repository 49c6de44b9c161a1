// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What it costs to remesh a small range of a large mesh, as a table in Markdown: a thousand connected faces, beside the whole
// mesh, by this package and by PMP, at the mean edge length of the range and at half of it, where the mesh grows. The first
// call on a mesh may have to make room for new elements, later ones on other ranges of the same mesh seldom.
//
//   range [file [subdivisions]]        homer.off subdivided four times: 2.5M faces
//
// Times are medians of 5 first and of 99 later calls (of 5 for PMP), memory is what the calls of a row add to the process.

#include "meshes.h"
#include "peak_memory.h"
#include "timing.h"

#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>

#include <CGAL/Polygon_mesh_processing/remesh.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <unordered_set>
#include <vector>

namespace {

using Faces = std::vector<Mesh::Face_index>;
constexpr std::size_t RANGE_SIZE = 1000;
constexpr unsigned ITERATIONS = 10;
constexpr int RANGES = 100;
constexpr int FIRST_CALLS = 5;

struct This_package
{
  static constexpr int LATER_CALLS = RANGES - 1;
  template <class Range>
  static void remesh(const Range& range, double length, Mesh& mesh)
  {
    CGAL::Inter_angle_remeshing::isotropic_remeshing(range, length, mesh, CGAL::parameters::number_of_iterations(ITERATIONS));
  }
};

struct Pmp
{
  static constexpr int LATER_CALLS = 5;
  template <class Range>
  static void remesh(const Range& range, double length, Mesh& mesh)
  {
    CGAL::Polygon_mesh_processing::isotropic_remeshing(range, length, mesh, CGAL::parameters::number_of_iterations(ITERATIONS));
  }
};

// The faces nearest to `seed`, breadth first.
Faces connected_faces(Mesh::Face_index seed, const Mesh& mesh)
{
  Faces result{seed};
  std::unordered_set<std::size_t> seen{seed};
  for (std::size_t i = 0; i < result.size() && result.size() < RANGE_SIZE; ++i)
    for (const auto h : mesh.halfedges_around_face(mesh.halfedge(result[i]))) {
      const auto f = mesh.face(mesh.opposite(h));
      if (f != Mesh::null_face() && seen.insert(f).second) result.push_back(f);
    }
  return result;
}

double mean_edge_length_of(const Faces& range, const Mesh& mesh)
{
  double sum = 0;
  for (const auto f : range)
    for (const auto h : mesh.halfedges_around_face(mesh.halfedge(f)))
      sum += CGAL::Polygon_mesh_processing::edge_length(h, mesh);
  return sum / (3 * double(range.size()));
}

// The k-th of RANGES ranges, spread over the mesh.
Faces range_number(int k, const Mesh& mesh)
{
  Mesh::Face_index seed(Mesh::size_type(mesh.num_faces() / RANGES * std::size_t(k)));
  while (mesh.is_removed(seed)) ++seed;
  return connected_faces(seed, mesh);
}

template <class Engine>
double remesh_range(int k, double factor, Mesh& mesh)
{
  const Faces range = range_number(k, mesh);
  const double length = factor * mean_edge_length_of(range, mesh);
  return seconds([&] { Engine::remesh(range, length, mesh); });
}

struct Cost
{
  double seconds, mebibytes;
};

template <class Engine>
Cost first_call(const Mesh& input, double factor)
{
  std::vector<double> times;
  double memory = 0;
  for (int i = 0; i < FIRST_CALLS; ++i) {
    Mesh mesh(input);
    reset_peak();
    const double before = peak_memory();
    times.push_back(remesh_range<Engine>(i, factor, mesh));
    memory = (std::max)(memory, peak_memory() - before);
  }
  return {median(times), memory};
}

template <class Engine>
Cost later_calls(const Mesh& input, double factor)
{
  Mesh mesh(input);
  remesh_range<Engine>(0, factor, mesh);
  std::vector<double> times;
  reset_peak();
  const double before = peak_memory();
  for (int k = 1; k <= Engine::LATER_CALLS; ++k) times.push_back(remesh_range<Engine>(k, factor, mesh));
  return {median(times), peak_memory() - before};
}

template <class Engine>
Cost whole_mesh(const Mesh& input)
{
  Mesh mesh(input);
  const double length = mean_edge_length(mesh);
  reset_peak();
  const double before = peak_memory();
  const double time = seconds([&] { Engine::remesh(faces(mesh), length, mesh); });
  return {time, peak_memory() - before};
}

void print(const char* what, double factor, const Cost& ours, const Cost& whole, const Cost& pmp)
{
  std::printf("| %s, %.1f | %.2f | 1 : %.0f | %.1f | %.2f | %.1f | %.1f |\n", what, factor, 1e3 * ours.seconds,
              whole.seconds / ours.seconds, ours.mebibytes, 1e3 * pmp.seconds, pmp.mebibytes, pmp.seconds / ours.seconds);
  std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv)
{
  Mesh input = read_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/homer.off"));
  for (int i = argc > 2 ? std::atoi(argv[2]) : 4; i > 0; --i) input = subdivide(input);

  std::printf("%zu faces; ranges of %zu\n\n", std::size_t(input.number_of_faces()), RANGE_SIZE);
  std::printf("| range, length | ms | to the whole mesh | MiB | PMP ms | PMP MiB | PMP : ours |\n|---|---|---|---|---|---|---|\n");
  const Cost whole = whole_mesh<This_package>(input);
  for (const double factor : {1., .5}) {
    print("first call", factor, first_call<This_package>(input, factor), whole, first_call<Pmp>(input, factor));
    print("later calls", factor, later_calls<This_package>(input, factor), whole, later_calls<Pmp>(input, factor));
  }
  print("all faces", 1., whole, whole, whole_mesh<Pmp>(input));
}
