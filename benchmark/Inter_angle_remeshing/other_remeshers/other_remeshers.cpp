// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Remeshers side by side, at the same number of faces, each with its defaults, in one thread. A table in Markdown for each model, and one
// of them all.
//
//   other_remeshers [-f faces] [mesh...]      faces: 20000; meshes: some of CGAL's
//
// A remesher that takes a length, or a number of points, is run until the number of faces is within 1% of what is wanted, five times at
// most; the time is the median of three runs with what it took then, and leaves out reading and writing the mesh. Distances are in
// percent of the diagonal of the bounding box. CGAL 6 has more remeshers than CGAL 5.

#include "../meshes.h"
#include "../timing.h"
#include "remeshers.h"

#include <CGAL/Inter_angle_remeshing/Projection/Closest_point_projector.h>
#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>
#include <CGAL/Inter_angle_remeshing/surface_distance.h>
#include <CGAL/Inter_angle_remeshing/target_edge_length.h>
#include <CGAL/Inter_angle_remeshing/triangle_quality.h>

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#if __has_include(<CGAL/Polygon_mesh_processing/approximated_centroidal_Voronoi_diagram_remeshing.h>)
#include <CGAL/Polygon_mesh_processing/approximated_centroidal_Voronoi_diagram_remeshing.h>
#define HAS_ACVD
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/surface_Delaunay_remeshing.h>)
#include <CGAL/Polygon_mesh_processing/surface_Delaunay_remeshing.h>
#define HAS_SURFACE_DELAUNAY
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace IAR = CGAL::Inter_angle_remeshing;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace parameters = CGAL::parameters;

namespace {

enum class Size { length, points };

struct Remesher
{
  std::string name;
  Size size;
  std::function<Timed_soup(const Triangle_soup&, double)> run;
};

Triangle_soup to_soup(const Mesh& mesh)
{
  Triangle_soup soup;
  std::vector<std::size_t> index(mesh.number_of_vertices() + mesh.number_of_removed_vertices());
  for (const auto v : mesh.vertices()) {
    index[v] = soup.points.size();
    const auto& p = mesh.point(v);
    soup.points.push_back({p.x(), p.y(), p.z()});
  }
  for (const auto f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    soup.triangles.push_back({index[mesh.source(h)], index[mesh.target(h)], index[mesh.target(mesh.next(h))]});
  }
  return soup;
}

bool is_manifold(const Triangle_soup& soup) { return PMP::is_polygon_soup_a_polygon_mesh(soup.triangles); }

// Vertices and edges of more sheets than one are doubled.
Mesh to_mesh(const Triangle_soup& soup)
{
  std::vector<Kernel::Point_3> points;
  for (const auto& p : soup.points) points.emplace_back(p[0], p[1], p[2]);
  std::vector<std::array<std::size_t, 3>> triangles = soup.triangles;
  if (!is_manifold(soup)) PMP::orient_polygon_soup(points, triangles);
  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(points, triangles, mesh);
  return mesh;
}

// Of a function that changes a mesh of CGAL.
template <class Function>
std::function<Timed_soup(const Triangle_soup&, double)> on_surface_mesh(const Function& remesh)
{
  return [remesh](const Triangle_soup& input, double size) {
    Mesh mesh = to_mesh(input);
    Timed_soup result;
    result.seconds = seconds([&]() { remesh(mesh, size); });
    result.soup = to_soup(mesh);
    return result;
  };
}

std::vector<Remesher> all_remeshers()
{
  std::vector<Remesher> all;
  all.push_back({"Inter_angle_remeshing", Size::length, on_surface_mesh([](Mesh& mesh, double length) {
    IAR::isotropic_remeshing(length, mesh);
  })});
  // The others take the facets of the input for the surface, however coarse they are.
  all.push_back({"the same, on the facets", Size::length, on_surface_mesh([](Mesh& mesh, double length) {
    const Mesh input = mesh;
    const IAR::Closest_point_projector<Mesh> facets(input);
    IAR::isotropic_remeshing(length, mesh, parameters::projection_functor(std::cref(facets)));
  })});
  all.push_back({"... by Recipe::closest()", Size::length, on_surface_mesh([](Mesh& mesh, double length) {
    const Mesh input = mesh;
    const IAR::Closest_point_projector<Mesh> facets(input);
    IAR::isotropic_remeshing(faces(mesh), length, mesh,
                             IAR::recipe(IAR::Recipe::closest(), parameters::projection_functor(std::cref(facets))));
  })});
  all.push_back({"CGAL, isotropic_remeshing", Size::length, on_surface_mesh([](Mesh& mesh, double length) {
    PMP::isotropic_remeshing(faces(mesh), length, mesh, parameters::number_of_iterations(10));
  })});
#ifdef HAS_ACVD
  all.push_back({"CGAL, ACVD", Size::points, on_surface_mesh([](Mesh& mesh, double points) {
    PMP::approximated_centroidal_Voronoi_diagram_remeshing(mesh, std::size_t(points), parameters::random_seed(0));
  })});
#endif
#ifdef HAS_SURFACE_DELAUNAY
  // With the best angle that is sure to be reached.
  all.push_back({"CGAL, surface_Delaunay", Size::length, on_surface_mesh([](Mesh& mesh, double length) {
    mesh = PMP::surface_Delaunay_remeshing(mesh, parameters::mesh_facet_size(length).mesh_facet_angle(30));
  })});
#endif
#ifdef HAS_PMP_LIBRARY
  all.push_back({"pmp-library", Size::length, remesh_by_pmp_library});
#endif
#ifdef HAS_VCGLIB
  all.push_back({"VCGlib", Size::length, remesh_by_vcglib});
#endif
#ifdef HAS_MMG
  all.push_back({"Mmg", Size::length, remesh_by_mmg});
#endif
#ifdef HAS_GEOGRAM
  all.push_back({"Geogram", Size::points, [](const Triangle_soup& input, double points) {
    return remesh_by_geogram(input, std::size_t(points));
  }});
#endif
  return all;
}

// Angles in degrees, regular vertices and distances in percent.
struct Score
{
  static constexpr const char* HEAD = "faces | θ_min | θ_max | θ_avg | valence 6 | Md | Hd | crossings | s";
  std::size_t faces = 0;
  double minimum = 0, maximum = 0, average = 0, regular = 0, mean = 0, hausdorff = 0;
  bool is_manifold = true;
  std::size_t crossings = 0;               // pairs of faces; where sheets were doubled, they are not looked for
  double seconds = 0;

  void print(const std::string& name) const
  {
    std::printf("| %s | %zu | %.1f | %.1f | %.2f | %.1f | %.4f | %.3f | %s | %.3g |\n", name.c_str(), faces, minimum, maximum, average,
                regular, mean, hausdorff, is_manifold ? std::to_string(crossings).c_str() : "not manifold", seconds);
    std::fflush(stdout);
  }
};

Timed_soup run_to_count(const Remesher& remesher, const Triangle_soup& input, double size, std::size_t wanted)
{
  constexpr int MOST_RUNS = 5;
  constexpr double CLOSE = 0.01;
  Timed_soup result;
  for (int run = 0; run < MOST_RUNS; ++run) {
    result = remesher.run(input, size);
    const double ratio = double(result.soup.triangles.size()) / double(wanted);
    if (std::abs(ratio - 1) < CLOSE || ratio == 0) break;
    if (run + 1 < MOST_RUNS) size *= remesher.size == Size::length ? std::sqrt(ratio) : 1 / ratio;
  }
  const double again = remesher.run(input, size).seconds, once_more = remesher.run(input, size).seconds;
  result.seconds = median({result.seconds, again, once_more});
  return result;
}

Score score(const Mesh& input, const Timed_soup& result)
{
  const Mesh mesh = to_mesh(result.soup);
  const CGAL::Bbox_3 box = PMP::bbox(input);
  const double percent = 100 / std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());
  const auto angles = IAR::inter_angle_statistics(mesh);
  const IAR::Surface_distance distance = IAR::surface_distance(input, mesh);
  const bool is_one = is_manifold(result.soup);
  return {mesh.number_of_faces(), angles.minimum_angle, angles.maximum_angle, angles.average, angles.percentage_of_regular_vertices(),
          percent * distance.mean(), percent * distance.hausdorff(), is_one, is_one ? crossing_pairs(mesh) : 0, result.seconds};
}

// Over the models that the remesher could do; distances and times as multiples of those of the first one, medians.
void print_all(const std::string& name, const std::vector<std::optional<Score>>& scores, const std::vector<std::optional<Score>>& first)
{
  std::vector<double> mean, hausdorff, time;
  Score all;
  all.minimum = 180;
  std::size_t n = 0, not_manifold = 0;
  for (std::size_t i = 0; i < scores.size(); ++i) {
    if (!scores[i] || !first[i]) continue;
    const Score &s = *scores[i], &f = *first[i];
    ++n;
    all.minimum = (std::min)(all.minimum, s.minimum);
    all.maximum = (std::max)(all.maximum, s.maximum);
    all.average += s.average;
    all.regular += s.regular;
    all.crossings += s.crossings;
    not_manifold += !s.is_manifold;
    mean.push_back(s.mean / f.mean);
    hausdorff.push_back(s.hausdorff / f.hausdorff);
    time.push_back(s.seconds / f.seconds);
  }
  if (n == 0) return;
  std::printf("| %s | %zu | %.1f | %.1f | %.2f | %.1f | %.2f | %.2f | %zu | %zu | %.1f |\n", name.c_str(), n, all.minimum, all.maximum,
              all.average / double(n), all.regular / double(n), median(mean), median(hausdorff), all.crossings, not_manifold, median(time));
}

} // namespace

int main(int argc, char** argv)
{
  std::size_t wanted = 20000;
  std::vector<std::string> paths;
  for (int k = 1; k < argc; ++k) {
    if (std::string(argv[k]) == "-f" && k + 1 < argc) wanted = std::size_t(std::atol(argv[++k]));
    else paths.push_back(argv[k]);
  }
  if (wanted == 0) {
    std::fprintf(stderr, "other_remeshers: the number of faces must be positive\n");
    return EXIT_FAILURE;
  }
  if (paths.empty())
    for (const char* name : {"elephant", "armadillo", "bunny00", "dino", "camel", "lion-head"})
      paths.push_back(CGAL::data_file_path("meshes/" + std::string(name) + ".off"));

  const std::vector<Remesher> remeshers = all_remeshers();
  std::vector<std::vector<std::optional<Score>>> scores(remeshers.size());
  for (const std::string& path : paths) {
    const Mesh input = read_mesh(path);
    const Triangle_soup soup = to_soup(input);
    const double length = IAR::target_edge_length(faces(input), input, wanted);
    std::printf("\n| %s, %zu faces | %s |\n|---|---|---|---|---|---|---|---|---|---|\n", path.substr(path.rfind('/') + 1).c_str(),
                soup.triangles.size(), Score::HEAD);
    for (std::size_t i = 0; i < remeshers.size(); ++i) {
      const Remesher& remesher = remeshers[i];
      std::optional<Score>& of_model = scores[i].emplace_back();
      const double size = remesher.size == Size::length ? length : double(wanted) / 2;
      try {
        of_model = score(input, run_to_count(remesher, soup, size, wanted));
        of_model->print(remesher.name);
      } catch (const std::exception& error) {
        std::printf("| %s | %s |\n", remesher.name.c_str(), error.what());
      }
    }
  }
  std::printf("\n| all, beside the first | models | least angle | largest | θ_avg | valence 6 | Md | Hd | crossings | not manifold | time |\n"
              "|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (std::size_t i = 0; i < remeshers.size(); ++i) print_all(remeshers[i].name, scores[i], scores.front());
}
