// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Wanted numbers of faces: every triangle mesh of a folder (that of CGAL's data where none is given) to several parts of its own
// number, where that is at least 40 and at most a million. Per part, apart for models with features: how many results miss it by
// more than 2 and 5 percent, the mean of the inter-angles, the faces out of their bands and the distances in target lengths. Tables
// in Markdown; the misses by name before them.
//
//   face_counts [folder]

#include "meshes.h"

#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>
#include <CGAL/Inter_angle_remeshing/surface_distance.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

namespace IAR = CGAL::Inter_angle_remeshing;

namespace {

constexpr double PARTS[] = {.02, .05, .1, .3, 1, 3};
constexpr std::size_t FEWEST = 40, MOST = 1000000;

struct Row
{
  double part;
  std::size_t runs = 0, over_2 = 0, over_5 = 0, out = 0;
  double average = 0, hausdorff = 0, mean = 0;
};

void add_run(std::vector<Row>& smooth, std::vector<Row>& with_features, std::size_t k, const std::string& name, const Mesh& input)
{
  const std::size_t wanted = std::size_t(PARTS[k] * double(input.number_of_faces()));
  if (wanted < FEWEST || wanted > MOST) return;
  Mesh mesh = input;
  const IAR::Remeshing_report report =
    IAR::isotropic_remeshing(IAR::Face_count(wanted), mesh, CGAL::parameters::number_of_iterations(10));
  mesh.collect_garbage();
  const double miss = std::abs(double(mesh.number_of_faces()) / double(wanted) - 1);
  if (miss > .02)
    std::printf("%s: %zu faces of %zu\n", name.c_str(), std::size_t(mesh.number_of_faces()), wanted);
  const IAR::Surface_distance distance = IAR::surface_distance(input, mesh);
  Row& row = (report.feature_edges > 0 ? with_features : smooth)[k];
  ++row.runs;
  row.over_2 += miss > .02;
  row.over_5 += miss > .05;
  row.out += report.number_of_faces_out_of_band;
  row.average += report.angles_after.average;
  row.hausdorff += distance.hausdorff() / report.target_edge_length;
  row.mean += distance.mean() / report.target_edge_length;
}

void print(const char* title, const std::vector<Row>& rows)
{
  std::printf("\n%s\n\n| times the faces | runs | over 2%% | over 5%% | θ_avg | out | Hd | Md |\n|---|---|---|---|---|---|---|---|\n", title);
  for (const Row& row : rows) {
    const double n = double((std::max)(row.runs, std::size_t(1)));
    std::printf("| %g | %zu | %zu | %zu | %.2f | %zu | %.2f | %.3f |\n", row.part, row.runs, row.over_2, row.over_5, row.average / n,
                row.out, row.hausdorff / n, row.mean / n);
  }
}

}

int main(int argc, char* argv[])
{
  namespace fs = std::filesystem;
  std::vector<fs::path> paths;
  for (const fs::directory_entry& entry : fs::directory_iterator(argc > 1 ? argv[1] : CGAL::data_file_path("meshes")))
    if (entry.path().extension() == ".off") paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  std::vector<Row> smooth, with_features;
  for (const double part : PARTS) {
    smooth.push_back({part});
    with_features.push_back({part});
  }
  for (const fs::path& path : paths)
    try {
      const Mesh input = read_mesh(path.string());
      for (std::size_t k = 0; k < smooth.size(); ++k) add_run(smooth, with_features, k, path.stem().string(), input);
    } catch (const std::exception& e) {
      std::printf("%s: %s\n", path.stem().string().c_str(), e.what());
    }
  print("Without features", smooth);
  print("With features", with_features);
}
