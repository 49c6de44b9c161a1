// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What each rule is worth: the paper's rules one at a time, against the default and against plain Botsch-Kobbelt
// remeshing, as a table in Markdown.
//
//   ablation [mesh ...]        (elephant, armadillo and bunny00 of CGAL's data where none is given)
//   ablation steps [factor]    what each step of a run is worth, on ten models at so many times their mean edge length (1)
//
// A change of the target length by a percent changes a figure by more than some rules do: every row is the mean over
// seven target lengths, from .94 to 1.06 of the mesh's mean edge length; the angles are the extremes over all of them.
// Times are medians of these seven runs.

#include "meshes.h"

#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>
#include <CGAL/Inter_angle_remeshing/surface_distance.h>
#include <CGAL/Inter_angle_remeshing/triangle_quality.h>

#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Real_timer.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace IAR = CGAL::Inter_angle_remeshing;

namespace {

struct Row
{
  double minimum = 180, maximum = 0, average = 0, regular = 0, hausdorff = 0, mean = 0, faces = 0, out = 0;
  std::vector<double> seconds;
};

template <class Remesh>
void add_run(Row& row, const Mesh& input, const Remesh& remesh)
{
  Mesh mesh(input);
  CGAL::Real_timer timer;
  timer.start();
  remesh(mesh);
  timer.stop();
  mesh.collect_garbage();
  const auto angles = IAR::inter_angle_statistics(mesh);
  const auto distance = IAR::surface_distance(input, mesh);
  row.minimum = (std::min)(row.minimum, angles.minimum_angle);
  row.maximum = (std::max)(row.maximum, angles.maximum_angle);
  row.average += angles.average;
  row.regular += angles.percentage_of_regular_vertices();
  row.hausdorff += 100 * distance.relative_hausdorff();
  row.mean += 100 * distance.relative_mean();
  row.faces += double(mesh.number_of_faces());
  row.seconds.push_back(timer.time());
}

template <class Remesh>
void print_row(const char* name, const Mesh& input, double length, const Remesh& remesh)
{
  constexpr int RUNS = 7;
  Row row;
  for (int i = 0; i < RUNS; ++i)
    add_run(row, input, [&](Mesh& mesh) { remesh(mesh, (0.94 + 0.02 * i) * length); });
  std::nth_element(row.seconds.begin(), row.seconds.begin() + RUNS / 2, row.seconds.end());
  std::printf("| %s | %.0f | %.1f..%.1f | %.2f | %.1f | %.3f | %.4f | %.1f |\n", name, row.faces / RUNS, row.minimum,
              row.maximum, row.average / RUNS, row.regular / RUNS, row.hausdorff / RUNS, row.mean / RUNS,
              1e3 * row.seconds[RUNS / 2]);
  std::fflush(stdout);
}

void print_table(const std::string& path)
{
  namespace parameters = CGAL::parameters;
  const Mesh input = read_mesh(path);
  const double length = mean_edge_length(input);
  const auto row = [&](const char* name, const auto& np) {
    print_row(name, input, length, [&](Mesh& mesh, double l) { IAR::isotropic_remeshing(faces(mesh), l, mesh, np); });
  };
  std::printf("\n%s, %zu faces\n\n| | faces | θ | θ_avg | valence 6 %% | Hd %% | Md %% | ms |\n|---|---|---|---|---|---|---|---|\n",
              path.substr(path.find_last_of('/') + 1).c_str(), std::size_t(input.number_of_faces()));
  print_row("PMP", input, length, [](Mesh& mesh, double l) {
    CGAL::Polygon_mesh_processing::isotropic_remeshing(faces(mesh), l, mesh, parameters::number_of_iterations(10));
  });
  const auto plain = parameters::do_split(true).do_collapse(true).do_flip(true);
  row("default", parameters::default_values());
  row("default without the split rule", parameters::do_split(true));
  row("no rule", plain);
  row("split rule as printed, alone", parameters::do_split(IAR::Inter_angle_split_policy<>(90, {}, 1e9)).do_collapse(true).do_flip(true));
  row("degree judgment alone", parameters::do_split(true).do_collapse(IAR::Inter_angle_collapse_policy<>(false, true)).do_flip(true));
  row("boundary condition alone", parameters::do_split(true).do_collapse(IAR::Inter_angle_collapse_policy<>(true, false)).do_flip(true));
  row("obtuse flips blocked, alone", parameters::do_split(true).do_collapse(true).do_flip(IAR::Inter_angle_flip_policy<>(90, 180)));
  row("flips over 20 degrees blocked, alone", parameters::do_split(true).do_collapse(true).do_flip(IAR::Inter_angle_flip_policy<>(180, 20)));

  IAR::Recipe all;
  all.policies = IAR::Recipe::Policies::paper;
  row("all rules", IAR::recipe(all));
  row("all rules but the split rule", IAR::recipe(all, parameters::do_split(true)));
  row("all rules but the degree judgment", IAR::recipe(all, parameters::do_collapse(IAR::Inter_angle_collapse_policy<>(true, false))));
  row("all rules but the boundary condition", IAR::recipe(all, parameters::do_collapse(IAR::Inter_angle_collapse_policy<>(false, true))));
  row("all rules but the obtuse flips'", IAR::recipe(all, parameters::do_flip(IAR::Inter_angle_flip_policy<>(180, 20))));
  row("all rules but the 20 degrees'", IAR::recipe(all, parameters::do_flip(IAR::Inter_angle_flip_policy<>(90, 180))));
  row("Recipe::paper()", IAR::recipe(IAR::Recipe::paper()));

  IAR::Recipe recipe;
  recipe.glide_depth = 0;
  row("default without glides", IAR::recipe(recipe));
  recipe = IAR::Recipe();
  recipe.curvature_valences = false;
  row("default, tips and saddles regular with six edges, too", IAR::recipe(recipe));
  recipe = IAR::Recipe();
  recipe.clean_up = false;
  row("default without the clean-up and the fit", IAR::recipe(recipe));
  recipe = IAR::Recipe();
  recipe.fits = 0;
  row("default without the fit", IAR::recipe(recipe));
  recipe.fits = 2;
  row("default with two passes of the fit", IAR::recipe(recipe));
  recipe = IAR::Recipe();
  recipe.last_sweeps = recipe.sweeps;
  row("default with 3 sweeps throughout", IAR::recipe(recipe));
  recipe = IAR::Recipe();
  recipe.last_sweeps = 16;
  row("default with 16 sweeps in the last two iterations", IAR::recipe(recipe));
  recipe = IAR::Recipe();
  recipe.split_ratio = 4. / 3;
  row("default with a split ratio of 4/3", IAR::recipe(recipe));
}

// --- the steps of a run -----------------------------------------------------------------------------------------------

struct Step
{
  const char* name;
  IAR::Recipe recipe;
};

std::vector<Step> steps()
{
  using Recipe = IAR::Recipe;
  std::vector<Step> result;
  const auto add = [&](const char* name, const auto& change) {
    Recipe r;
    change(r);
    result.push_back({name, r});
  };
  add("default", [](Recipe&) {});
  add("without glides", [](Recipe& r) { r.glide_depth = 0; });
  add("glides of 4 flips, no slack", [](Recipe& r) { r.glide_depth = 4; r.glide_slack = 0; });
  add("glides of 8 flips, no slack", [](Recipe& r) { r.glide_depth = 8; r.glide_slack = 0; });
  add("glides of 12 flips", [](Recipe& r) { r.glide_depth = 12; });
  add("tips and saddles regular with six edges, too", [](Recipe& r) { r.curvature_valences = false; });
  add("3 sweeps in the last two iterations, too", [](Recipe& r) { r.last_sweeps = 3; });
  add("16 sweeps in the last two iterations", [](Recipe& r) { r.last_sweeps = 16; });
  add("without the fit", [](Recipe& r) { r.fits = 0; });
  add("two passes of the fit", [](Recipe& r) { r.fits = 2; });
  add("without the repair", [](Recipe& r) { r.repair = false; });
  add("without lowering distances", [](Recipe& r) { r.distance_tolerance = 0; });
  add("distances lowered to .15", [](Recipe& r) { r.distance_tolerance = 0.15; });
  add("without these two", [](Recipe& r) { r.repair = false; r.distance_tolerance = 0; });
  add("without the clean-up", [](Recipe& r) { r.clean_up = false; });
  return result;
}

// Each row is the mean over the models, of three target lengths each, about `factor` times their mean edge length; Hd, Md and time
// are ratios to PMP's; the angles are the extremes.
void print_steps(double factor)
{
  std::vector<Mesh> inputs;
  for (const char* name : {"elephant", "bear_bis", "armadillo", "homer", "camel", "dino", "hand", "knot1", "cactus", "retinal"})
    inputs.push_back(read_mesh(CGAL::data_file_path(std::string("meshes/") + name + ".off")));
  constexpr int RUNS = 3;
  const auto row_of = [&](const Mesh& input, const auto& remesh) {
    Row row;
    const double length = factor * mean_edge_length(input);
    for (int i = 0; i < RUNS; ++i) add_run(row, input, [&](Mesh& mesh) { row.out += remesh(mesh, (0.97 + 0.03 * i) * length); });
    std::nth_element(row.seconds.begin(), row.seconds.begin() + RUNS / 2, row.seconds.end());
    return row;
  };
  std::printf("\n| | θ | θ_avg | valence 6 %% | faces out | Hd / PMP's | Md / PMP's | times as fast |\n|---|---|---|---|---|---|---|---|\n");
  std::vector<Row> of_pmp;
  for (const Mesh& input : inputs)
    of_pmp.push_back(row_of(input, [](Mesh& mesh, double l) {
      CGAL::Polygon_mesh_processing::isotropic_remeshing(faces(mesh), l, mesh, CGAL::parameters::number_of_iterations(10));
      return 0.;
    }));
  for (const Step& step : steps()) {
    Row all;
    double speed = 0;
    for (std::size_t k = 0; k < inputs.size(); ++k) {
      const Row row = row_of(inputs[k], [&](Mesh& mesh, double l) {
        return double(IAR::isotropic_remeshing(faces(mesh), l, mesh, IAR::recipe(step.recipe)).number_of_faces_out_of_band); });
      all.minimum = (std::min)(all.minimum, row.minimum);
      all.maximum = (std::max)(all.maximum, row.maximum);
      all.average += row.average / RUNS;
      all.regular += row.regular / RUNS;
      all.out += row.out / RUNS;
      all.hausdorff += row.hausdorff / of_pmp[k].hausdorff;
      all.mean += row.mean / of_pmp[k].mean;
      speed += of_pmp[k].seconds[RUNS / 2] / row.seconds[RUNS / 2];
    }
    const double n = double(inputs.size());
    std::printf("| %s | %.1f..%.1f | %.2f | %.1f | %.1f | %.2f | %.2f | %.1f |\n", step.name, all.minimum, all.maximum, all.average / n,
                all.regular / n, all.out / n, all.hausdorff / n, all.mean / n, speed / n);
    std::fflush(stdout);
  }
}

} // namespace

int main(int argc, char** argv)
{
  if (argc > 1 && std::string(argv[1]) == "steps") {
    print_steps(argc > 2 ? std::stod(argv[2]) : 1);
    return EXIT_SUCCESS;
  }
  std::vector<std::string> paths(argv + 1, argv + argc);
  if (paths.empty())
    for (const char* name : {"elephant", "armadillo", "bunny00"})
      paths.push_back(CGAL::data_file_path(std::string("meshes/") + name + ".off"));
  for (const std::string& path : paths) print_table(path);
}
