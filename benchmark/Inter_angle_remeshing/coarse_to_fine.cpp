// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a user sees of the MLS surface: coarse models are refined to 20,000 faces, by default and by PMP, and compared with
// the surface that the coarse model stands for. A table in Markdown, and the meshes.
// Then what the default's choice of the surface does, over the target length.
//
//   coarse_to_fine [folder]      the meshes are written there: NAME_coarse.off, NAME_pmp.off, NAME_facets.off, NAME.off
//
// Models: a sphere and a torus of 500 faces, and organic models of CGAL remeshed to 1500 and 4000 faces, or to 150 and 300, which
// leaves little but creases; the vertices lie on the full model. The distances are the mean and largest ones of points of the result
// (or of the coarse model) from the sphere or torus, or from the full model.

#include "meshes.h"

#include <CGAL/Inter_angle_remeshing/Projection/Closest_point_projector.h>
#include <CGAL/Inter_angle_remeshing/Projection/MLS_projector.h>
#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Real_timer.h>
#include <CGAL/boost/graph/generators.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

namespace IAR = CGAL::Inter_angle_remeshing;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace parameters = CGAL::parameters;

namespace {

using Point = Kernel::Point_3;
using Projection = std::function<Point(const Point&)>;

constexpr std::size_t FINE = 20000;

double distance(const Point& p, const Point& q) { return std::sqrt(CGAL::squared_distance(p, q)); }

struct Errors { double mean = 0, largest = 0; };

// Of the vertices, the middles of the edges and the centroids, weighted by the areas around them.
Errors errors(const Mesh& mesh, const Projection& truth)
{
  Errors result;
  double total = 0;
  const auto add = [&](const Point& p, double weight) {
    const double d = distance(p, truth(p));
    result.mean += weight * d;
    result.largest = (std::max)(result.largest, d);
    total += weight;
  };
  for (const auto f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    const Point corner[3] = {mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), mesh.point(mesh.target(mesh.next(h)))};
    const double area = std::sqrt(CGAL::squared_area(corner[0], corner[1], corner[2]));
    for (int k = 0; k < 3; ++k) {
      add(corner[k], area / 20);
      add(CGAL::midpoint(corner[k], corner[(k + 1) % 3]), 2 * area / 15);
    }
    add(CGAL::centroid(corner[0], corner[1], corner[2]), 9 * area / 20);
  }
  result.mean /= total;
  return result;
}

struct Model
{
  std::string name;
  Mesh coarse;
  Projection truth;
};

Point onto_sphere(const Point& p) { return CGAL::ORIGIN + (p - CGAL::ORIGIN) / distance(p, CGAL::ORIGIN); }

Point onto_torus(const Point& p)
{
  const double r = std::hypot(p.x(), p.y());
  const Point centre(p.x() / r, p.y() / r, 0);
  return centre + .4 / distance(p, centre) * (p - centre);
}

// A coarse mesh whose vertices lie on the surface.
Mesh coarse_mesh(Mesh mesh, std::size_t faces, const Projection& truth)
{
  IAR::isotropic_remeshing(IAR::Face_count(faces), mesh, parameters::projection_functor(truth));
  mesh.collect_garbage();
  for (const auto v : mesh.vertices()) mesh.point(v) = truth(mesh.point(v));
  return mesh;
}

Model sphere()
{
  Mesh mesh;
  CGAL::make_icosahedron(mesh, Point(0, 0, 0), 1.);
  return {"sphere", coarse_mesh(mesh, 500, onto_sphere), onto_sphere};
}

Model torus(std::size_t faces)
{
  return {"torus", coarse_mesh(torus_mesh(60, 24), faces, onto_torus), onto_torus};
}

Model organic(const std::string& name, std::size_t faces)
{
  const Mesh full = read_mesh(CGAL::data_file_path("meshes/" + name + ".off"));
  const IAR::Closest_point_projector<Mesh> projector(full);
  const Projection truth = [projector](const Point& p) { return projector.project(p); };
  return {name + "_" + std::to_string(faces), coarse_mesh(full, faces, truth), truth};
}

void refine(const Model& model, const std::string& folder)
{
  const Mesh& coarse = model.coarse;
  const double length = IAR::target_edge_length(faces(coarse), coarse, FINE);
  CGAL::Real_timer timer;
  const auto run = [&](const auto& remesh) {
    Mesh mesh = coarse;
    timer.reset();
    timer.start();
    remesh(mesh);
    timer.stop();
    mesh.collect_garbage();
    return mesh;
  };
  const Mesh by_default = run([&](Mesh& m) { IAR::isotropic_remeshing(faces(m), length, m); });
  const double time = timer.time();
  const Mesh by_pmp = run([&](Mesh& m) {
    PMP::isotropic_remeshing(faces(m), length, m, parameters::number_of_iterations(10));
  });
  const double pmp_time = timer.time();
  const Mesh on_facets = run([&](Mesh& m) {
    const IAR::Closest_point_projector<Mesh> facets(coarse);
    IAR::isotropic_remeshing(faces(m), length, m, parameters::projection_functor(std::cref(facets)));
  });
  const Errors before = errors(coarse, model.truth), ours = errors(by_default, model.truth),
               pmp = errors(by_pmp, model.truth), facets = errors(on_facets, model.truth);
  std::printf("| %s | %zu | %.2g / %.2g | %.2g / %.2g | %.2g / %.2g | %.2g / %.2g | %.1f / %.1f | %.1f | %zu / %zu |\n",
              model.name.c_str(), std::size_t(coarse.number_of_faces()), before.mean, before.largest, pmp.mean, pmp.largest,
              facets.mean, facets.largest, ours.mean, ours.largest, pmp.mean / ours.mean, pmp.largest / ours.largest,
              pmp_time / time, crossing_pairs(by_pmp), crossing_pairs(by_default));
  std::fflush(stdout);
  if (folder.empty()) return;
  const auto write = [&](const std::string& suffix, const Mesh& mesh) {
    CGAL::IO::write_polygon_mesh(folder + "/" + model.name + suffix + ".off", mesh);
  };
  write("_coarse", coarse);
  write("_pmp", by_pmp);
  write("_facets", on_facets);
  write("", by_default);
}

// Mean distances from the input, and from the truth, of results on the facets, by default, and on the MLS surface.
void print_rule(const Model& model)
{
  const Mesh& input = model.coarse;
  const IAR::Closest_point_projector<Mesh> facets(input);
  const IAR::MLS_projector<Mesh> mls(input);
  const Projection onto_input = [&](const Point& p) { return facets.project(p); };
  const double own_length = mean_edge_length(input);
  for (const double factor : {1., .7, .5, .45, .4, .35, .3, .2}) {
    Mesh result[3] = {input, input, input};
    IAR::isotropic_remeshing(factor * own_length, result[0], parameters::projection_functor(std::cref(facets)));
    IAR::isotropic_remeshing(factor * own_length, result[1]);
    IAR::isotropic_remeshing(factor * own_length, result[2], parameters::projection_functor(std::cref(mls)));
    std::printf("| %s | %.2f |", model.name.c_str(), factor);
    for (Mesh& mesh : result) mesh.collect_garbage();
    for (const Mesh& mesh : result) std::printf(" %.2g |", errors(mesh, onto_input).mean / own_length);
    for (const Mesh& mesh : result) std::printf(" %.2g |", errors(mesh, model.truth).mean / own_length);
    std::printf("\n");
  }
}

} // namespace

int main(int argc, char** argv)
{
  const std::string folder = argc > 1 ? argv[1] : "";
  std::printf("| model | faces | coarse | PMP | facets kept | default | PMP : default | PMP : default, time | "
              "crossings, PMP / default |\n|---|---|---|---|---|---|---|---|---|\n");
  refine(sphere(), folder);
  refine(torus(500), folder);
  for (const char* name : {"bunny00", "armadillo", "elephant"})
    for (const std::size_t faces : {1500, 4000}) refine(organic(name, faces), folder);
  refine(organic("elephant", 300), folder);
  refine(organic("triceratops", 150), folder);
  refine(organic("camel", 150), folder);
  std::printf("\n| model | target | to input: facets | default | MLS | to truth: facets | default | MLS |\n"
              "|---|---|---|---|---|---|---|---|\n");
  print_rule(torus(2000));
  print_rule(organic("bunny00", 4000));
}
