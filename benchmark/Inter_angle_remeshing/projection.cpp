// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How much nearer to a smooth surface the projectors' surfaces are than the facets, and what queries cost, as tables in
// Markdown.
//
//   projection [mesh ...]        times on these meshes (elephant and bunny00 of CGAL's data where none is given)
//
// The models sample analytic surfaces with 300 to 5000 faces, isotropic ones and decimated ones; their vertices lie on the
// surface. Queries are random points within a twentieth of an edge of the facets. A gain is the mean distance from the
// truth of the closest points on the facets over that of the projections.

#include "meshes.h"

#include <CGAL/Inter_angle_remeshing/Projection/Closest_point_projector.h>
#include <CGAL/Inter_angle_remeshing/Projection/MLS_projector.h>
#include <CGAL/Inter_angle_remeshing/Projection/Upsampled_point_set.h>
#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>
#ifdef CGAL_EIGEN3_ENABLED
#  include <CGAL/Inter_angle_remeshing/Projection/Point_set_MLS_projector.h>
#endif

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_ratio_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/boost/graph/generators.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <random>
#include <string>
#include <vector>

namespace IAR = CGAL::Inter_angle_remeshing;
namespace SMS = CGAL::Surface_mesh_simplification;
namespace parameters = CGAL::parameters;

namespace {

using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;

// A surface f = 0.
struct Level_set
{
  const char* name;
  std::function<double(const Point&)> f;
  double extent;                          // of the part that is looked at, in x and y

  Vector gradient(const Point& p) const
  {
    constexpr double H = 1e-5;
    const auto slope = [&](const Vector& d) { return (f(p + H * d) - f(p - H * d)) / (2 * H); };
    return {slope({1, 0, 0}), slope({0, 1, 0}), slope({0, 0, 1})};
  }
  // By Newton's steps along the gradient.
  Point onto(Point p) const
  {
    for (int i = 0; i < 20; ++i) {
      const Vector g = gradient(p);
      const double l = g.squared_length();
      if (!(l > 0)) break;
      p = p - (f(p) / l) * g;
    }
    return p;
  }
  double distance(const Point& p) const { return std::sqrt(CGAL::squared_distance(p, onto(p))); }
};

const Level_set TORUS{"torus", [](const Point& p) {
  const double r = std::hypot(p.x(), p.y()) - 1;
  return r * r + p.z() * p.z() - .16; }, 2};
const Level_set ELLIPSOID{"ellipsoid", [](const Point& p) {
  return p.x() * p.x() + p.y() * p.y() / .49 + p.z() * p.z() / .25 - 1; }, 2};
const Level_set BUMPS{"sphere with bumps", [](const Point& p) {
  const double r = std::sqrt((p - CGAL::ORIGIN).squared_length());
  return r - (1 + .08 * std::sin(4 * p.x() / r) * std::cos(3 * p.y() / r) + .05 * std::sin(5 * p.z() / r)); }, 2};
const Level_set HEIGHTS{"height field", [](const Point& p) {
  return p.z() - .2 * std::sin(3 * p.x()) * std::cos(2 * p.y()) - .05 * std::sin(5 * p.y()); }, .9};

// A fine mesh of the surface.
Mesh fine_mesh(const Level_set& surface)
{
  Mesh mesh;
  if (&surface == &HEIGHTS)
    CGAL::make_grid(100, 100, mesh, [](std::size_t i, std::size_t j) {
      return Point(double(i) / 50 - 1, double(j) / 50 - 1, 0); }, true);
  else if (&surface == &TORUS) {
    mesh = torus_mesh(160, 64);
  } else {
    CGAL::make_icosahedron(mesh, Point(0, 0, 0), 1.);
    for (int level = 0; level < 5; ++level) {
      mesh = subdivide(mesh);
      for (const auto v : mesh.vertices()) {
        const Vector d = mesh.point(v) - CGAL::ORIGIN;
        mesh.point(v) = CGAL::ORIGIN + d / std::sqrt(d.squared_length());
      }
    }
  }
  for (const auto v : mesh.vertices()) mesh.point(v) = surface.onto(mesh.point(v));
  return mesh;
}

Mesh coarse_mesh(const Level_set& surface, std::size_t faces_wanted, bool is_decimated)
{
  Mesh mesh = fine_mesh(surface);
  if (is_decimated)
    SMS::edge_collapse(mesh, SMS::Count_ratio_stop_predicate<Mesh>(double(faces_wanted) / double(mesh.number_of_faces())));
  else
    IAR::isotropic_remeshing(IAR::Face_count(faces_wanted), mesh);
  mesh.collect_garbage();
  for (const auto v : mesh.vertices())
    if (!mesh.is_border(v)) mesh.point(v) = surface.onto(mesh.point(v));
  return mesh;
}

template <class Function>
void for_points_near(const Mesh& mesh, std::size_t per_face, const Function& function)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  for (const auto f : mesh.faces())
    for (std::size_t i = 0; i < per_face; ++i) {
      const auto h = mesh.halfedge(f);
      const Point &a = mesh.point(mesh.source(h)), &b = mesh.point(mesh.target(h)),
                  &c = mesh.point(mesh.target(mesh.next(h)));
      double s = unit(random), t = unit(random);
      if (s + t > 1) { s = 1 - s; t = 1 - t; }
      const Vector n = CGAL::cross_product(b - a, c - a);
      const double l = n.squared_length();
      const double height = .1 * (unit(random) - .5);
      function(a + s * (b - a) + t * (c - a) + (l > 0 ? height / std::sqrt(std::sqrt(l)) : 0.) * n);
    }
}

template <class Projector>
double mean_error(const Level_set& surface, const std::vector<Point>& queries, const Projector& projector)
{
  double sum = 0;
  for (const Point& q : queries) sum += surface.distance(projector.project(q));
  return sum / double(queries.size());
}

void print_gains()
{
  std::printf("| surface | input | faces | MLS_projector | Point_set_MLS_projector |\n|---|---|---|---|---|\n");
  for (const bool is_decimated : {false, true}) {
    double sum = 0, point_set_sum = 0, worst = 1e300;
    int count = 0;
    for (const Level_set* surface : {&TORUS, &ELLIPSOID, &BUMPS, &HEIGHTS})
      for (const std::size_t n : {300, 1000, 3000, 5000}) {
        const Mesh mesh = coarse_mesh(*surface, n, is_decimated);
        std::vector<Point> queries;
        for_points_near(mesh, std::max<std::size_t>(1, 20000 / n), [&](const Point& p) {
          if (std::abs(p.x()) < surface->extent && std::abs(p.y()) < surface->extent) queries.push_back(p);
        });
        const double facets = mean_error(*surface, queries, IAR::Closest_point_projector<Mesh>(mesh));
        const double gain = facets / mean_error(*surface, queries, IAR::MLS_projector<Mesh>(mesh));
        double point_set_gain = 0;
#ifdef CGAL_EIGEN3_ENABLED
        const IAR::Point_set_MLS_projector<Point> point_set{IAR::Upsampled_point_set<Mesh>(mesh)};
        point_set_gain = facets / mean_error(*surface, queries, point_set);
#endif
        std::printf("| %s | %s | %zu | %.1f | %.1f |\n", surface->name, is_decimated ? "decimated" : "isotropic",
                    std::size_t(mesh.number_of_faces()), gain, point_set_gain);
        sum += gain;
        point_set_sum += point_set_gain;
        worst = (std::min)(worst, gain);
        ++count;
      }
    std::printf("| mean (least) | %s | | %.1f (%.1f) | %.1f |\n", is_decimated ? "decimated" : "isotropic", sum / count,
                worst, point_set_sum / count);
  }
}

// Microseconds a call, the least of several rounds.
template <class Call>
double microseconds(std::size_t calls, const Call& call)
{
  double best = 1e300;
  for (int round = 0; round < 5; ++round) {
    CGAL::Real_timer timer;
    timer.start();
    call();
    best = (std::min)(best, timer.time());
  }
  return 1e6 * best / double(calls);
}

void print_times(const std::string& path)
{
  const Mesh mesh = read_mesh(path);
  std::vector<Point> queries;
  for_points_near(mesh, 2, [&](const Point& p) { queries.push_back(p); });
  double sink = 0;
  const auto all_queries = [&](const auto& projector) {
    return microseconds(queries.size(), [&]() { for (const Point& q : queries) sink += projector.project(q).x(); });
  };
  const double construction =
    microseconds(mesh.number_of_faces(), [&]() { IAR::MLS_projector<Mesh> projector(mesh); sink += 1; });
  const IAR::MLS_projector<Mesh> mls(mesh);
  const double cold = (mls.project(queries.front()), all_queries(mls));

  const auto& surface = mls.reference_surface();
  const double scale = 1 / surface.unit();
  std::vector<IAR::internal::Corner_table::Index> hints;
  for (const Point& q : queries) {
    hints.push_back(0);
    surface.locate(scale * IAR::internal::to_vector3(q), hints.back());
  }
  const double warm = microseconds(queries.size(), [&]() {
    for (std::size_t i = 0; i < queries.size(); ++i) {
      const auto q = scale * IAR::internal::to_vector3(queries[i]);
      auto f = hints[i];
      const auto closest = surface.closest_point_near(q, f);
      sink += mls.mls_surface().project(q, f, closest).x;
    }
  });

  using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh>;
  CGAL::AABB_tree<IAR::internal::AABB_traits<Kernel, Primitive>> tree(faces(mesh).begin(), faces(mesh).end(), mesh);
  tree.build();
  tree.accelerate_distance_queries();
  const double aabb = microseconds(queries.size(), [&]() {
    for (const Point& q : queries) sink += tree.closest_point(q).x();
  });
  std::printf("| %s | %zu | %.2f | %.3f | %.3f | %.3f | %.1f |\n", path.substr(path.find_last_of('/') + 1).c_str(),
              std::size_t(mesh.number_of_faces()), construction, warm, cold, aabb, aabb / cold);
  if (std::isnan(sink)) std::printf("\n");
}

} // namespace

int main(int argc, char** argv)
{
  std::vector<std::string> paths(argv + 1, argv + argc);
  if (paths.empty())
    for (const char* name : {"elephant", "bunny00"})
      paths.push_back(CGAL::data_file_path(std::string("meshes/") + name + ".off"));
  print_gains();
  std::printf("\n| mesh | faces | construction, µs a face | warm query, µs | cold query, µs | AABB_tree, µs | AABB_tree : cold |\n"
              "|---|---|---|---|---|---|---|\n");
  for (const std::string& path : paths) print_times(path);
}
