// Copyright (c) 2026 The Inter_angle_remeshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Curves: features that are marked or found, and borders. What is found; what stays, and where; what slides.

#include <CGAL/Inter_angle_remeshing/Attribute_transfer.h>
#include <CGAL/Inter_angle_remeshing/Projection/Closest_point_projector.h>
#include <CGAL/Inter_angle_remeshing/Projection/MLS_projector.h>
#include <CGAL/Inter_angle_remeshing/detect_features.h>
#include <CGAL/Inter_angle_remeshing/internal/curves/corners.h>
#include <CGAL/Inter_angle_remeshing/internal/exchange/whole_surface.h>
#include <CGAL/Inter_angle_remeshing/internal/features/Feature_graph.h>
#include <CGAL/Inter_angle_remeshing/internal/features/Feature_pruning.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/angle_energy.h>
#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>
#include <CGAL/Inter_angle_remeshing/triangle_quality.h>

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/selection.h>
#include <CGAL/centroid.h>

#include <boost/property_map/function_property_map.hpp>

#include "check.h"
#include "invariants.h"
#include "marching_cubes.h"
#include "marching_tetrahedra.h"
#include "meshes.h"
#include "models.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace IAR = CGAL::Inter_angle_remeshing;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace parameters = CGAL::parameters;
using namespace invariants;
using meshes::Soup;
using Features = IAR::Remeshing_report::Features;
using Edge_map = Mesh::Property_map<Edge, bool>;
using Segment_3 = Kernel::Segment_3;

double edge_length(Edge e, const Mesh& m) { return PMP::edge_length(m.halfedge(e), m); }

Segment_3 segment(Edge e, const Mesh& m) { return Segment_3(m.point(m.vertex(e, 0)), m.point(m.vertex(e, 1))); }

// In degrees; 180 on the border.
double dihedral_angle(Edge e, const Mesh& m)
{
  if(m.is_border(e))
    return 180;
  const auto normal = [&](Mesh::Halfedge_index h) {
    return CGAL::normal(m.point(m.source(h)), m.point(m.target(h)), m.point(m.target(m.next(h))));
  };
  const Vector a = normal(m.halfedge(e)), b = normal(m.opposite(m.halfedge(e)));
  return std::atan2(std::sqrt(CGAL::cross_product(a, b).squared_length()), a * b) * 180 / CGAL_PI;
}

// The distance from the nearest of some segments.
class Segments
{
public:
  Segments(std::vector<Segment_3> segments, double reach) : segments_(std::move(segments)), reach_(reach)
  {
    for(std::size_t i = 0; i < segments_.size(); ++i)
    {
      const int n = 1 + int(2 * std::sqrt(segments_[i].squared_length()) / reach_);
      for(int k = 0; k <= n; ++k)
        cells_[cell(segments_[i].source() + double(k) / n * segments_[i].to_vector())].insert(i);
    }
  }
  // At most `reach`.
  double distance(const Point& p) const
  {
    const auto c = cell(p);
    double best = reach_ * reach_;
    for(int i = -1; i <= 1; ++i)
      for(int j = -1; j <= 1; ++j)
        for(int k = -1; k <= 1; ++k)
        {
          const auto found = cells_.find({c[0] + i, c[1] + j, c[2] + k});
          if(found != cells_.end())
            for(const std::size_t s : found->second)
              best = std::min(best, CGAL::squared_distance(p, segments_[s]));
        }
    return std::sqrt(best);
  }

private:
  std::array<long, 3> cell(const Point& p) const
  {
    return {long(std::floor(p.x() / reach_)), long(std::floor(p.y() / reach_)), long(std::floor(p.z() / reach_))};
  }
  std::vector<Segment_3> segments_;
  double reach_;
  std::map<std::array<long, 3>, std::set<std::size_t>> cells_;
};

template <class Predicate>
std::vector<Segment_3> edges_where(const Mesh& m, const Predicate& is_wanted)
{
  std::vector<Segment_3> result;
  for(const Edge e : m.edges())
    if(is_wanted(e))
      result.push_back(segment(e, m));
  return result;
}

// The part of the length of `from` that lies within `tolerance` of `to`.
double share_kept(const std::vector<Segment_3>& from, const std::vector<Segment_3>& to, double tolerance)
{
  const Segments near(to, 2 * tolerance);
  double all = 0, kept = 0;
  for(const Segment_3& s : from)
    for(double t = .05; t < 1; t += .1)
    {
      const double l = std::sqrt(s.squared_length());
      all += l;
      kept += near.distance(s.source() + t * s.to_vector()) <= tolerance ? l : 0;
    }
  return all > 0 ? kept / all : 1;
}

// --- detection ---------------------------------------------------------------------------------------------------

std::set<Edge> found_features(const Mesh& m, double scale = 0)
{
  Mesh copy = m;
  Edge_map map = copy.add_property_map<Edge, bool>("e:feature", true).first;
  const std::size_t n = IAR::detect_features(faces(copy), copy, map, scale);
  std::set<Edge> result;
  for(const Edge e : copy.edges())
    if(map[e])
      result.insert(e);
  CHECK(result.size() == n);
  return result;
}

void cad_models_have_all_their_sharp_edges()
{
  CHECK(found_features(meshes::to_mesh<Mesh>(meshes::cube(4))).size() == 12 * 4);
  CHECK(found_features(meshes::to_mesh<Mesh>(meshes::octahedron())).size() == 12);
  for(const char* name : {"fandisk", "joint", "anchor", "rotor", "couplingdown", "part", "spool", "pinion", "cheese", "pipe",
                          "dragknob", "cross", "oblong", "u", "cube-meshed"})
  {
    const Mesh m = models::of_cgal(name);
    const std::set<Edge> found = found_features(m);
    std::size_t sharp = 0;
    for(const Edge e : m.edges())
    {
      const double angle = m.is_border(e) ? 0 : dihedral_angle(e, m);
      sharp += angle > 40.01;
      CHECK(angle < 40.01 || angle > 179.9 || found.count(e) > 0);
      CHECK(angle > 39.99 || found.count(e) == 0);
    }
    CHECK_MESSAGE(sharp > 0, name);
  }
}

// Turned, and written with six digits: what has no area then has next to none, and looks anywhere.
Soup turned_and_rounded(Soup soup)
{
  for(auto& p : soup.points)
  {
    const std::array<double, 3> q = {.48 * p[0] - .6 * p[1] + .64 * p[2], .36 * p[0] + .8 * p[1] + .48 * p[2], -.8 * p[0] + .6 * p[2]};
    for(int k = 0; k < 3; ++k)
      p[k] = std::round(1e6 * q[k]) / 1e6;
  }
  return soup;
}

void faces_without_an_area_hide_no_edge()
{
  for(const auto& [n, is_rounded] : {std::pair(1, false), std::pair(4, false), std::pair(1, true), std::pair(3, true), std::pair(7, true)})
  {
    const Soup soup = meshes::cube_with_caps(n);
    const Mesh input = meshes::to_mesh<Mesh>(is_rounded ? turned_and_rounded(soup) : soup);
    CHECK(found_features(input).size() == std::size_t(24 * n));
    for(const bool is_found : {true, false})
    {
      Mesh m = input;
      const auto report = is_found ? IAR::isotropic_remeshing(.1, m)
                                   : IAR::isotropic_remeshing(.1, m, parameters::sharpness_angle(40));
      CHECK_MESSAGE(report.feature_edges == std::size_t(24 * n), report.feature_edges);
      CHECK_MESSAGE(invariants::surface_distance(input, m, 10000).hausdorff() < (is_rounded ? 2e-6 : 1e-9), n);
      CHECK_MESSAGE(report.angles_after.minimum > 30, n << ", " << is_rounded << ": " << report.angles_after.minimum);
    }
  }
}

// Along sharp edges of a cube faces have, on both sides, vertices that those of the other side lack: two faces without an area fill what is
// between, and share an edge.
Soup cube_with_double_caps(std::size_t n)
{
  Soup soup = meshes::cube(n);
  using Index = std::size_t;
  std::map<std::array<Index, 2>, Index> face_of;
  for(Index f = 0; f < soup.faces.size(); ++f)
    for(int k = 0; k < 3; ++k)
      face_of[{soup.faces[f][k], soup.faces[f][(k + 1) % 3]}] = f;
  const auto normal = [&](Index f) {
    const auto point = [&](int k) { const auto& p = soup.points[soup.faces[f][k]]; return Point(p[0], p[1], p[2]); };
    return CGAL::normal(point(0), point(1), point(2));
  };
  std::set<Index> used;
  const auto edges = face_of;
  for(const auto& [edge, f] : edges)
  {
    const auto [a, b] = edge;
    const Index g = edges.at({b, a});
    if(used.count(f) > 0 || used.count(g) > 0 || normal(f) * normal(g) != 0)
      continue;
    used.insert({f, g});
    const auto third = [&](Index face, Index u, Index v) {
      const auto& t = soup.faces[face];
      return t[0] != u && t[0] != v ? t[0] : t[1] != u && t[1] != v ? t[1] : t[2];
    };
    const Index p = third(f, a, b), q = third(g, a, b), c = soup.points.size(), d = c + 1;
    for(const double share : {.3, .6})
    {
      std::array<double, 3> point;
      for(int k = 0; k < 3; ++k)
        point[k] = (1 - share) * soup.points[a][k] + share * soup.points[b][k];
      soup.points.push_back(point);
    }
    soup.faces[f] = {a, c, p};
    soup.faces[g] = {b, d, q};
    for(const auto& t : {std::array<Index, 3>{c, b, p}, std::array<Index, 3>{d, a, q}, std::array<Index, 3>{a, d, b}, std::array<Index, 3>{b, c, a}})
      soup.faces.push_back(t);
  }
  return soup;
}

void two_faces_without_an_area_hide_no_edge()
{
  for(const int n : {3, 6})
    for(const bool is_rounded : {false, true})
    {
      const Soup soup = cube_with_double_caps(n);
      const Mesh input = meshes::to_mesh<Mesh>(is_rounded ? turned_and_rounded(soup) : soup);
      CHECK(soup.faces.size() > meshes::cube(n).faces.size() + 24);
      CHECK_MESSAGE(found_features(input).size() == std::size_t(12 * n), n << ", " << is_rounded << ": " << found_features(input).size());
      Mesh m = input;
      const auto report = IAR::isotropic_remeshing(.15, m);
      CHECK_MESSAGE(invariants::surface_distance(input, m, 10000).hausdorff() < 2e-6, n << ", " << is_rounded);
      CHECK_MESSAGE(report.angles_after.minimum > 30, n << ", " << is_rounded << ": " << report.angles_after.minimum);
    }
}

// Every n-th edge gets one more vertex, where its source is or a little beside it: edges of no length, and faces without an area.
Mesh with_doubled_points(Mesh m, int n, double beside)
{
  std::vector<Edge> edges;
  int i = 0;
  for(const Edge e : m.edges())
    if(i++ % n == 0 && !m.is_border(e))
      edges.push_back(e);
  for(const Edge e : edges)
  {
    const Halfedge h = m.halfedge(e), o = m.opposite(h);
    const Point p = m.point(m.source(h)) + beside * (m.point(m.target(h)) - m.point(m.source(h)));
    const Halfedge first = CGAL::Euler::split_edge(h, m);
    m.point(m.target(first)) = p;
    CGAL::Euler::split_face(first, m.next(h), m);
    CGAL::Euler::split_face(o, m.next(m.next(o)), m);
  }
  return m;
}

void doubled_points_on_features_are_merged()
{
  for(const char* name : {"cross", "anchor", "joint"})
    for(const double beside : {0., 1e-9})
    {
      const Mesh input = with_doubled_points(models::of_cgal(name), name == std::string("cross") ? 4 : 7, beside);
      Mesh m = input;
      const auto report = IAR::isotropic_remeshing(mean_edge_length(m), m);
      CHECK_MESSAGE(report.angles_after.minimum > 25 && report.angles_after.maximum < 115, name << ": " << report.angles_after.minimum);
      CHECK_MESSAGE(report.crossing_faces == 0, name << ": " << report.crossing_faces);
      if(beside == 0)
      {
        // Without doubled points joint and anchor come as far as .11 of the length at lengths around this one.
        const double distance = invariants::surface_distance(input, m, 10000).hausdorff();
        CHECK_MESSAGE(distance < .15 * mean_edge_length(input), name << ": " << distance / mean_edge_length(input));
      }
    }
}

// Where vertices only move, the features are those of the edges that there are.
void without_a_length_features_are_those_of_the_mesh()
{
  for(const char* name : {"bones", "fandisk", "b9_mesh"})
  {
    Mesh m = models::of_cgal(name);
    const std::size_t found = found_features(m).size();
    CHECK_MESSAGE(IAR::isotropic_remeshing(0, m, parameters::number_of_iterations(1)).feature_edges == found, name);
  }
}

// As few facets as 10 to 24 around: they meet at 36 to 15 degrees along lines that are much longer than the sharp edges.
void cylinders_of_few_facets_are_cad_models()
{
  const meshes::Profile pipe = {{1, 0}, {1, 6}, {.8, 6}, {.8, 0}}, shaft = {{1, 0}, {1, 4}, {1.5, 4}, {1.5, 5}, {1, 5}, {1, 9}, {.6, 9}, {.6, 14}},
                cone = {{1, 0}, {.3, 5}, {.3, 8}}, rod = {{1, 0}, {1, 200}};
  for(const std::size_t n : {10, 16, 24})
    for(const auto& [profile, is_closed] : {std::make_pair(pipe, true), std::make_pair(shaft, false), std::make_pair(cone, false),
                                           std::make_pair(rod, false)})
    {
      const Mesh m = meshes::to_mesh<Mesh>(meshes::turned(profile, n, is_closed));
      const std::set<Edge> found = found_features(m);
      std::size_t sharp = 0;
      for(const Edge e : m.edges())
        sharp += dihedral_angle(e, m) > 40;
      CHECK_MESSAGE(sharp > 0 && found.size() == sharp, n << " facets: " << found.size() << " of " << sharp);
      for(const Edge e : found)
        CHECK(dihedral_angle(e, m) > 40);
      Mesh output = m;
      const double length = .3;
      const auto report = IAR::isotropic_remeshing(length, output);
      output.collect_garbage();
      CHECK(report.features == Features::all_sharp_edges && !does_self_intersect(output));
      CHECK(invariants::surface_distance(m, output).hausdorff() < .5 * length);
      if(meshes::is_small_run())
        break;
    }
}

// A ring of square section whose edges are beveled: of the sides of a strip far narrower than the length one is a feature, of those
// of a wider one both are; and so are the rims of a plate, however thin.
void of_two_sides_of_a_narrow_strip_one_is_a_feature()
{
  constexpr std::size_t N = 48;
  for(const auto& [strip, chains] : std::vector<std::pair<double, std::size_t>>{{.02, 4}, {.1, 8}})
  {
    const double a = 1 - strip;
    const Mesh m = meshes::to_mesh<Mesh>(meshes::turned({{6, -a}, {6, a}, {5 + a, 1}, {5 - a, 1}, {4, a}, {4, -a}, {5 - a, -1}, {5 + a, -1}},
                                                        N, true));
    CHECK_MESSAGE(found_features(m, 1).size() == N * chains, strip << ": " << found_features(m, 1).size());
    Mesh output = m;
    const auto report = IAR::isotropic_remeshing(1, output);
    CHECK(report.features == Features::all_sharp_edges);
    const auto quality = IAR::inter_angle_statistics(output);
    CHECK_MESSAGE(strip > .02 || quality.minimum_angle > 30, quality.minimum_angle);
    CHECK_MESSAGE(invariants::surface_distance(m, output).hausdorff() < .15, invariants::surface_distance(m, output).hausdorff());
  }
  Soup plate = meshes::cube(6);
  for(auto& p : plate.points)
    p[2] *= .01;
  const Mesh m = meshes::to_mesh<Mesh>(plate);
  std::size_t sharp = 0;
  for(const Edge e : m.edges())
    sharp += dihedral_angle(e, m) > 40;
  CHECK(sharp > 48 && found_features(m, .5).size() == sharp);
}

// A ring of square section with a step on top, round or with corners. The ridge of a step far lower than the target length is a feature
// all around, its groove is none, nor what joins both; of a higher one, or at a shorter length, all of them are.
void of_a_low_step_the_ridge_is_a_feature()
{
  for(const std::size_t n : {4, 8, 48})
    for(const double step : {.02, .1})
    {
      const Mesh m = meshes::to_mesh<Mesh>(meshes::turned({{6, -1}, {6, 1}, {5.5, 1}, {5.5, 1 - step}, {4, 1 - step}, {4, -1}}, n, true));
      const std::size_t chains = n == 48 ? 6 : 9, at_step = n == 48 ? 1 : 2;        // with those up along the corners
      CHECK_MESSAGE(found_features(m, 1).size() == n * (step < .05 ? chains - at_step : chains), n << ", " << step << ": "
                                                                                           << found_features(m, 1).size());
      CHECK_MESSAGE(found_features(m, .2).size() == n * chains, n << ", " << step << ": " << found_features(m, .2).size());
      if(step > .05)
        continue;
      std::size_t of_ridge = 0, of_groove = 0;
      for(const Edge e : found_features(m, 1))
        if(const Point &p = m.point(m.vertex(e, 0)), &q = m.point(m.vertex(e, 1));
           std::abs(std::hypot(p.x(), p.y()) - 5.5) < 1e-9 && std::abs(std::hypot(q.x(), q.y()) - 5.5) < 1e-9)
          ++(p.z() == 1 && q.z() == 1 ? of_ridge : of_groove);
      CHECK_MESSAGE(of_ridge == n && of_groove == 0, of_ridge << ", " << of_groove);
      Mesh output = m;
      IAR::isotropic_remeshing(1, output);
      CHECK_MESSAGE(IAR::inter_angle_statistics(output).minimum_angle > 30, IAR::inter_angle_statistics(output).minimum_angle);
      CHECK_MESSAGE(invariants::surface_distance(m, output).hausdorff() < .06, invariants::surface_distance(m, output).hausdorff());
      CHECK(!does_self_intersect(output));
    }
}

// A plate whose sides have a vertex amid each edge of the top, which the top lacks: a face without an area lies between, at which nothing
// shows on which side of it the surface is. The top's edges were taken for grooves, of low steps.
void rims_at_faces_without_an_area_are_no_grooves()
{
  for(const bool slivers_first : {false, true})
  {
    Soup plate;
    plate.points = {{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}, {0, 0, .02}, {10, 0, .02}, {10, 10, .02}, {0, 10, .02},
                    {5, 0, .02}, {10, 5, .02}, {5, 10, .02}, {0, 5, .02}};
    decltype(plate.faces) slivers, others = {{4, 5, 6}, {4, 6, 7}, {0, 2, 1}, {0, 3, 2}};
    for(std::size_t i = 0; i < 4; ++i)
    {
      const std::size_t k = (i + 1) % 4, middle = 8 + i;
      slivers.push_back({4 + i, middle, 4 + k});
      others.insert(others.begin(), {{i, k, middle}, {i, middle, 4 + i}, {k, 4 + k, middle}});
    }
    plate.faces = slivers_first ? slivers : others;
    const auto& rest = slivers_first ? others : slivers;
    plate.faces.insert(plate.faces.end(), rest.begin(), rest.end());
    const Mesh m = meshes::to_mesh<Mesh>(plate);
    std::size_t on_top = 0;
    for(const Edge e : found_features(m, 1))
      on_top += m.point(m.vertex(e, 0)).z() > .01 && m.point(m.vertex(e, 1)).z() > .01;
    CHECK_MESSAGE(on_top >= 4, slivers_first << ": " << on_top);
  }
}

void organic_models_have_next_to_none()
{
  CHECK(found_features(meshes::to_mesh<Mesh>(meshes::sphere(3))).empty());
  CHECK(found_features(meshes::to_mesh<Mesh>(meshes::torus(24, 12, .4))).empty());
  std::size_t models = 0;
  for(const char* name : {"elephant", "armadillo", "camel", "cow", "cactus", "dino", "eight", "femur", "bones", "handle", "head",
                          "helmet", "homer", "hand", "knot1", "knot2", "lion", "lion-head", "man", "mannequin-devil", "pig",
                          "triceratops", "bear_bis", "blobby"})
  {
    const Mesh m = models::of_cgal(name);
    if(meshes::is_small_run() && m.number_of_faces() > 3000)
      continue;
    double all = 0, marked = 0;
    const std::set<Edge> found = found_features(m);
    for(const Edge e : m.edges())
    {
      all += edge_length(e, m);
      marked += found.count(e) > 0 ? edge_length(e, m) : 0;
    }
    CHECK_MESSAGE(marked <= .01 * all, name << ": " << marked / all);
    ++models;
  }
  CHECK(models >= (meshes::is_small_run() ? 4u : 20u));
}

// An animal that was cut off by a plane keeps the rim of the cut, wherever that meets a crease.
void rims_of_cuts_are_features()
{
  const auto middle = [](double low, double high) { return .45 * low + .55 * high; };
  for(const auto& [name, normal] : {std::make_pair("knot1", Vector(.3, .5, .81)), std::make_pair("homer", Vector(1, .2, -.4)),
                                    std::make_pair("dino", Vector(0, 1, 0))})
  {
    const Mesh animal = models::of_cgal(name);
    const CGAL::Bbox_3 box = PMP::bbox(animal);
    const Kernel::Plane_3 plane(Point(middle(box.xmin(), box.xmax()), middle(box.ymin(), box.ymax()), middle(box.zmin(), box.zmax())),
                                normal);
    const Mesh m = models::cut_off(animal, plane);
    const double length = mean_edge_length(m);
    const auto is_on_plane = [&](Vertex v) { return CGAL::squared_distance(plane, m.point(v)) < 1e-12 * length * length; };
    const auto is_cut = [&](Face f) {
      const auto h = m.halfedge(f);
      return is_on_plane(m.source(h)) && is_on_plane(m.target(h)) && is_on_plane(m.target(m.next(h)));
    };
    const std::set<Edge> found = found_features(m);
    double rim = 0, marked = 0;
    std::vector<Point> on_rim;
    for(const Edge e : m.edges())
      if(is_cut(m.face(m.halfedge(e))) != is_cut(m.face(m.opposite(m.halfedge(e)))) && dihedral_angle(e, m) >= 60)
      {
        rim += edge_length(e, m);
        marked += found.count(e) > 0 ? edge_length(e, m) : 0;
        on_rim.push_back(CGAL::midpoint(m.point(m.vertex(e, 0)), m.point(m.vertex(e, 1))));
      }
    CHECK_MESSAGE(rim > 20 * length && marked >= .95 * rim, name << ": " << marked << " of " << rim);
    Mesh remeshed = m;
    const auto report = IAR::isotropic_remeshing(length, remeshed);
    CHECK_MESSAGE(report.features == Features::outstanding_edges, name);
    const double distance = largest_distance(on_rim, remeshed);
    CHECK_MESSAGE(distance < .06 * length, name << ": " << distance / length);
    if(meshes::is_small_run())
      break;
  }
}

// The wall of a cylinder, open at both ends: n sides, m rings.
Soup cylinder_wall(std::size_t n, std::size_t m, double height)
{
  Soup soup;
  for(std::size_t j = 0; j <= m; ++j)
    for(std::size_t i = 0; i < n; ++i)
    {
      const double a = 2 * CGAL_PI * double(i) / double(n);
      soup.points.push_back({std::cos(a), std::sin(a), height * double(j) / double(m)});
    }
  for(std::size_t j = 0; j < m; ++j)
    for(std::size_t i = 0; i < n; ++i)
    {
      const std::size_t k = (i + 1) % n;
      soup.faces.push_back({j * n + i, j * n + k, j * n + n + k});
      soup.faces.push_back({j * n + i, j * n + n + k, j * n + n + i});
    }
  return soup;
}

// The same, its first and last ring of so many points closed by a plane each.
Soup closed(Soup wall, std::size_t sides)
{
  const std::size_t last = wall.points.size() - sides;
  for(std::size_t i = 1; i + 1 < sides; ++i)
  {
    wall.faces.push_back({0, i + 1, i});
    wall.faces.push_back({last, last + i, last + i + 1});
  }
  return wall;
}

// A quarter of a turn of a coil of radius 4, whose section is a polygon of so many sides and radius 0.1, in so many long steps, closed by
// two planes.
Mesh bent_hose(std::size_t sides, std::size_t steps)
{
  Soup soup = cylinder_wall(sides, steps, CGAL_PI / 2);
  for(auto& p : soup.points)
  {
    const double r = 4 + .1 * p[0], angle = p[2];
    p = {r * std::cos(angle), r * std::sin(angle), 2 * angle - .1 * p[1]};
  }
  return meshes::to_mesh<Mesh>(closed(std::move(soup), sides));
}

// Where a drill enters and leaves an animal, each rim is one ring.
void rims_of_drilled_holes_are_features()
{
  for(const auto& [name, part] : {std::make_pair("bear", .04), std::make_pair("dino", .03), std::make_pair("homer", .04),
                                  std::make_pair("bunny00", .06)})
  {
    const Mesh animal = models::of_cgal(name);
    const CGAL::Bbox_3 box = PMP::bbox(animal);
    const double size = std::max({box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin()});
    const double radius = part * size;
    Mesh drill = meshes::to_mesh<Mesh>(closed(cylinder_wall(48, 1, 4), 48));
    for(const Vertex v : drill.vertices())
    {
      const Point& p = drill.point(v);
      drill.point(v) = Point((box.xmin() + box.xmax()) / 2 + radius * p.x(), (box.ymin() + box.ymax()) / 2 + radius * p.y(),
                             (box.zmin() + box.zmax()) / 2 + size * (p.z() - 2));
    }
    const Mesh m = models::difference(animal, drill);
    const auto is_drilled = [&](Face f) {
      const auto h = m.halfedge(f);
      const Vector n = CGAL::normal(m.point(m.source(h)), m.point(m.target(h)), m.point(m.target(m.next(h))));
      const Point c = CGAL::centroid(m.point(m.source(h)), m.point(m.target(h)), m.point(m.target(m.next(h))));
      const double d = std::hypot(c.x() - (box.xmin() + box.xmax()) / 2, c.y() - (box.ymin() + box.ymax()) / 2);
      return std::abs(d - radius) < .02 * radius && std::abs(n.z()) < 1e-6 * std::sqrt(n.squared_length());
    };
    const double length = mean_edge_length(m);
    for(const double target : {length, 2 * length})
    {
      const std::set<Edge> found = found_features(m, target);
      double rim = 0, marked = 0;
      std::vector<Point> on_rim;
      for(const Edge e : m.edges())
        if(is_drilled(m.face(m.halfedge(e))) != is_drilled(m.face(m.opposite(m.halfedge(e)))))
        {
          rim += edge_length(e, m);
          marked += found.count(e) > 0 ? edge_length(e, m) : 0;
          on_rim.push_back(CGAL::midpoint(m.point(m.vertex(e, 0)), m.point(m.vertex(e, 1))));
        }
      CHECK_MESSAGE(rim > 3 * target && marked == rim, name << ", " << target / length << ": " << marked / rim);
      Mesh remeshed = m;
      const auto report = IAR::isotropic_remeshing(target, remeshed);
      CHECK_MESSAGE(report.angles_after.minimum > 20 && report.angles_after.maximum < 110,
                    name << ": " << report.angles_after.minimum << " to " << report.angles_after.maximum);
      const double distance = largest_distance(on_rim, remeshed);
      CHECK_MESSAGE(report.features == Features::outstanding_edges && distance < .05 * target, name << ": " << distance / target);
    }
    if(meshes::is_small_run())
      break;
  }
}

// The ends of a hose are small beside its edges, but not beside those that are wanted: they had become points, a target length short.
void ends_of_thin_hoses_stay_flat()
{
  for(const std::size_t sides : {12, 24})
  {
    const Mesh hose = bent_hose(sides, 16);
    std::vector<Point> on_rims;
    for(const Edge e : hose.edges())
      if(dihedral_angle(e, hose) > 60)
        on_rims.push_back(CGAL::midpoint(hose.point(hose.vertex(e, 0)), hose.point(hose.vertex(e, 1))));
    CHECK(on_rims.size() == 2 * sides);
    CHECK(found_features(hose).empty());
    CHECK(found_features(hose, .1).size() == 2 * sides);
    Mesh remeshed = hose;
    const auto report = IAR::isotropic_remeshing(.1, remeshed);
    CHECK(report.features == Features::outstanding_edges && report.feature_edges == 2 * sides);
    CHECK_MESSAGE(largest_distance(on_rims, remeshed) < .006, largest_distance(on_rims, remeshed));
    CHECK_MESSAGE(report.angles_after.minimum > 20 && report.angles_after.maximum < 115,
                  report.angles_after.minimum << " " << report.angles_after.maximum);
  }
}

// Each coordinate of each vertex moved by some mean edge lengths, at random, with this standard deviation.
Mesh with_noise(Mesh m, double deviation, unsigned seed = 1)
{
  const double length = mean_edge_length(m);
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  for(const Vertex v : m.vertices())
    m.point(v) += deviation * length * Vector{normal(random), normal(random), normal(random)};
  return m;
}

void noise_hides_no_edge_and_makes_none()
{
  const Mesh m = models::of_cgal("fandisk");
  for(const double noise : {.05, .15})
  {
    const Mesh noisy = with_noise(m, noise / std::sqrt(3.));
    const std::set<Edge> found = found_features(noisy);
    std::size_t sharp = 0, right = 0;
    for(const Edge e : m.edges())
      if(dihedral_angle(e, m) >= 40)
      {
        ++sharp;
        right += found.count(e);
      }
    CHECK_MESSAGE(right >= .95 * sharp, noise << ": recall " << double(right) / double(sharp));
    CHECK_MESSAGE(right >= .9 * found.size(), noise << ": precision " << double(right) / double(found.size()));
  }
}

// Where noise makes most of the edges sharp, the mesh is no CAD model: all of the noise would be kept.
void the_roughest_noise_is_no_feature()
{
  for(const double deviation : {.2, .4, .6})
  {
    Mesh m = with_noise(models::of_cgal("elephant"), deviation);
    const std::size_t found = found_features(m).size();
    CHECK_MESSAGE(100 * found <= m.number_of_edges(), deviation << ": " << found);
    if(deviation != .4)
      continue;
    const auto report = IAR::isotropic_remeshing(2.5 * mean_edge_length(m), m);
    CHECK(report.features != Features::all_sharp_edges);
    CHECK_MESSAGE(report.output_faces < 1200, report.output_faces);
  }
}

// Every vertex of a noisy mesh is the tip of a spike, which a clean one has few of, and those stay. Were the noise's kept, faces
// would be poor and cross each other.
void the_tips_of_noise_do_not_stay()
{
  for(const char* name : {"elephant", "hand", "homer"})
  {
    const Mesh noisy = with_noise(models::of_cgal(name), .25);
    const double length = mean_edge_length(noisy);
    Mesh ours = noisy;
    const Mesh theirs = models::remeshed_by_pmp(noisy, length);
    const auto report = IAR::isotropic_remeshing(length, ours);
    const std::size_t crossing = self_intersections(ours).size();
    CHECK(does_self_intersect(noisy));
    CHECK_MESSAGE(5 * crossing <= self_intersections(theirs).size(), name << ": " << crossing);
    CHECK_MESSAGE(200 * report.number_of_faces_out_of_band <= report.output_faces,
                  name << ": " << report.number_of_faces_out_of_band);
    CHECK_MESSAGE(report.angles_after.average > IAR::inter_angle_statistics(theirs).average - .3,
                  name << ": " << report.angles_after.average);
    CHECK_MESSAGE(invariants::surface_distance(noisy, ours).mean() < invariants::surface_distance(noisy, theirs).mean(), name);
    if(meshes::is_small_run())
      break;
  }
}

// Spikes that cross nothing, and that the target length resolves, are no noise, but the shape of rugged ground. Sweeps took them away.
void rugged_ground_keeps_its_shape()
{
  for(const unsigned seed : {1u, 2u})
    for(const double factor : {.5, 1.})
    {
      Mesh ground = meshes::to_mesh<Mesh>(meshes::square(40));
      std::mt19937 random(seed);
      std::normal_distribution<double> height(0, mean_edge_length(ground));
      for(const Vertex v : ground.vertices())
        ground.point(v) += Vector(0, 0, height(random));
      const double length = factor * mean_edge_length(ground);
      Mesh m = ground;
      const auto report = IAR::isotropic_remeshing(length, m);
      const auto ours = surface_distance(ground, m), theirs = surface_distance(ground, models::remeshed_by_pmp(ground, length));
      CHECK_MESSAGE(ours.mean() < .95 * theirs.mean() && ours.hausdorff() < .95 * theirs.hausdorff(),
                    seed << ", " << factor << ": " << ours.mean() / theirs.mean() << ", " << ours.hausdorff() / theirs.hausdorff());
      CHECK_MESSAGE(report.angles_after.minimum > 15 && report.angles_after.maximum < 120,
                    seed << ", " << factor << ": " << report.angles_after.minimum << " " << report.angles_after.maximum);
      CHECK(!does_self_intersect(ground) && self_intersections(m).size() < 20);
      if(meshes::is_small_run())
        break;
    }
}

// Bars with many rings: the short edges along their creases are collapsed, although each collapse makes the needles beside it thinner.
void creases_with_short_edges_are_coarsened()
{
  for(const int sides : {4, 6})
    for(const double spacing : {.2, .3, .4})
    {
      meshes::Profile profile;
      for(double z = 0; z < 6; z += spacing)
        profile.push_back({1, z});
      const Mesh bar = meshes::to_mesh<Mesh>(meshes::turned(profile, std::size_t(sides), false));
      const double side = 2 * std::sin(CGAL_PI / sides);
      Mesh m = bar;
      const auto report = IAR::isotropic_remeshing(1.2 * side, m);
      CHECK_MESSAGE(report.angles_after.minimum > 25, sides << ", " << spacing << ": " << report.angles_after.minimum);
      CHECK_MESSAGE(4 * report.output_faces < 3 * bar.number_of_faces(),
                    sides << ", " << spacing << ": " << report.output_faces << " of " << bar.number_of_faces());
      CHECK_MESSAGE(surface_distance(bar, m).hausdorff() < .01 * side, sides << ", " << spacing);
    }
}

// However rough a surface is, it can be coarsened. Were all spikes spared as tips, a sphere with them would have more faces at three
// times its edge length than at twice.
void the_roughest_surface_can_be_coarsened()
{
  for(const double deviation : {1., 2.})
  {
    Mesh rough = meshes::to_mesh<Mesh>(meshes::sphere(5));
    const double radius_deviation = deviation * mean_edge_length(rough);
    std::mt19937 random(1);
    std::normal_distribution<double> normal(0, radius_deviation);
    for(const Vertex v : rough.vertices())
      rough.point(v) = CGAL::ORIGIN + (1 + normal(random)) * (rough.point(v) - CGAL::ORIGIN);
    std::size_t before = rough.number_of_faces();
    for(const double factor : {1.5, 3., 6.})
    {
      Mesh m = rough;
      const auto report = IAR::isotropic_remeshing(factor * mean_edge_length(rough), m);
      CHECK_MESSAGE(CGAL::is_closed(m) && topology(m) == topology(rough), deviation << ", " << factor);
      CHECK_MESSAGE(report.output_faces < before, deviation << ", " << factor << ": " << report.output_faces);
      CHECK_MESSAGE(report.angles_after.minimum > 5, deviation << ", " << factor << ": " << report.angles_after.minimum);
      before = report.output_faces;
    }
  }
}

// A wanted number of faces is met there, too, though the spikes take most of the area with them when they go.
void the_roughest_surface_gets_the_wanted_number_of_faces()
{
  Mesh rough = meshes::to_mesh<Mesh>(meshes::square(40));
  std::mt19937 random(1);
  std::normal_distribution<double> height(0, 2 * mean_edge_length(rough));
  for(const Vertex v : rough.vertices())
    if(!rough.is_border(v))
      rough.point(v) += Vector(0, 0, height(random));
  for(const std::size_t wanted : {100, 200, 500})
  {
    Mesh m = rough;
    const auto report = IAR::isotropic_remeshing(m.faces(), IAR::Face_count(wanted), m);
    CHECK_MESSAGE(std::abs(double(report.output_faces) - double(wanted)) <= .05 * double(wanted),
                  wanted << ": " << report.output_faces);
  }
}

// Noise makes the input cross itself where what is under the noise does not, which is no reason to let the result do so.
void what_noise_makes_cross_is_parted()
{
  std::size_t ours = 0, theirs = 0;
  for(const char* name : {"camel", "dino", "homer"})
    for(const double deviation : {.1, .25})
      for(const unsigned seed : {1u, 2u, 3u})
      {
        if(meshes::is_small_run() && (deviation > .1 || seed > 1))
          continue;
        const Mesh noisy = with_noise(models::of_cgal(name), deviation, seed);
        const double length = mean_edge_length(noisy);
        Mesh m = noisy;
        IAR::isotropic_remeshing(length, m);
        CHECK_MESSAGE(does_self_intersect(noisy) && topology(m) == topology(noisy), name << ", " << deviation);
        ours += self_intersections(m).size();
        theirs += self_intersections(models::remeshed_by_pmp(noisy, length)).size();
      }
  CHECK_MESSAGE(10 * ours <= theirs, ours << " against " << theirs);
}

// As sharp everywhere as the roughest noise, and with as many saddles, but a CAD model.
void knurled_plates_keep_their_pyramids()
{
  constexpr std::size_t N = 14;     // pyramids a side
  meshes::Soup plate;
  for(std::size_t j = 0; j <= N; ++j)
    for(std::size_t i = 0; i <= N; ++i)
      plate.points.push_back({double(i), double(j), 0});
  for(std::size_t j = 0; j < N; ++j)
    for(std::size_t i = 0; i < N; ++i)
    {
      const std::size_t a = j * (N + 1) + i, base[] = {a, a + 1, a + N + 2, a + N + 1};
      for(int k = 0; k < 4; ++k)
        plate.faces.push_back({base[k], base[(k + 1) % 4], plate.points.size()});
      plate.points.push_back({double(i) + .5, double(j) + .5, .5});
    }
  const Mesh knurled = meshes::to_mesh<Mesh>(plate);
  std::size_t sharp = 0;
  for(const Edge e : knurled.edges())
    sharp += !knurled.is_border(e) && dihedral_angle(e, knurled) >= 40;
  const std::size_t found = found_features(knurled).size();
  CHECK_MESSAGE(sharp > 1000 && found == sharp, found << " of " << sharp);
}

void a_range_and_other_types_will_do()
{
  // of a cube, the top: its edges are its border, where nothing is a feature
  Mesh m = meshes::to_mesh<Mesh>(meshes::cube(3));
  double high = -1;
  for(const Vertex v : m.vertices())
    high = std::max(high, m.point(v).z());
  std::vector<Face> top;
  for(const Face f : m.faces())
  {
    const auto h = m.halfedge(f);
    if(m.point(m.source(h)).z() == high && m.point(m.target(h)).z() == high && m.point(m.target(m.next(h))).z() == high)
      top.push_back(f);
  }
  Edge_map map = m.add_property_map<Edge, bool>("e:feature", true).first;
  CHECK(top.size() == 18 && IAR::detect_features(top, m, map) == 0);
  CHECK(IAR::detect_features(std::vector<Face>(), m, map) == 0);
  CHECK_THROWS_WITH_TEXT(IAR::detect_features(top, m, map, -1e-9), CGAL::Precondition_exception, "scale is -1e-09");
  CHECK_THROWS_WITH_TEXT(IAR::detect_features(top, m, map, std::numeric_limits<double>::infinity()),
                         CGAL::Precondition_exception, "scale");

  using Polyhedron = CGAL::Polyhedron_3<Kernel>;
  Polyhedron p = meshes::to_mesh<Polyhedron>(meshes::cube(2));
  std::map<boost::graph_traits<Polyhedron>::edge_descriptor, bool> marks;
  CHECK(IAR::detect_features(faces(p), p, boost::make_assoc_property_map(marks)) == 12 * 2);
}

// --- what stays --------------------------------------------------------------------------------------------------

void cad_models_keep_their_features()
{
  std::size_t kept_models = 0, models = 0;
  for(const char* name : {"fandisk", "joint", "anchor", "rotor", "part", "spool", "pinion", "pipe", "dragknob", "cross", "oblong",
                          "u", "cube-meshed", "anchor_dense", "rotor_small", "corner_tris_with_hole", "couplingdown", "patch-20",
                          "boeing", "mpi_triang"})
  {
    const Mesh input = models::of_cgal(name);
    if(meshes::is_small_run() && input.number_of_faces() > 1300)
      continue;
    const double length = mean_edge_length(input);
    Mesh output = input;
    const auto report = IAR::isotropic_remeshing(length, output);
    output.collect_garbage();
    CHECK_MESSAGE(report.features == Features::all_sharp_edges && report.feature_edges > 0,
                  name << ": " << report.feature_edges << " features of kind " << int(report.features));
    const auto is_sharp = [](const Mesh& m, double bound) {
      return [&m, bound](Edge e) { return dihedral_angle(e, m) > bound; };
    };
    const double kept = share_kept(edges_where(input, is_sharp(input, 40)), edges_where(output, is_sharp(output, 24)), .1 * length);
    ++models;
    kept_models += kept >= .98;
    CHECK_MESSAGE(kept >= .9, name << ": " << kept);
  }
  CHECK_MESSAGE(4 * kept_models >= 3 * models, kept_models << " of " << models);
}

void features_cost_nothing_but_angles()
{
  for(const char* name : {"fandisk", "joint", "anchor_dense"})
  {
    const Mesh input = models::of_cgal(name);
    if(meshes::is_small_run() && input.number_of_faces() > 1300)
      continue;
    double near = 0, far = 0;    // the largest distances are those of single points, which scatter from length to length
    for(const double factor : {.95, 1., 1.05})
    {
      Mesh with = input, without = input;
      const double length = factor * (input.number_of_faces() < 1000 ? .15 : 1.) * mean_edge_length(input);
      CHECK(IAR::isotropic_remeshing(length, with).features == Features::all_sharp_edges);
      CHECK(IAR::isotropic_remeshing(length, without, parameters::sharpness_angle(180)).features == Features::none);
      with.collect_garbage();
      without.collect_garbage();
      near += invariants::surface_distance(input, with, 100000).hausdorff();
      far += invariants::surface_distance(input, without, 100000).hausdorff();
      CHECK_MESSAGE(!does_self_intersect(with), name << " at " << factor);
      if(meshes::is_small_run())
        break;
    }
    CHECK_MESSAGE(3 * near < far, name << ": " << near << " against " << far);
  }
}

// A map or an angle says all.
void what_is_marked_rules()
{
  const Mesh input = meshes::to_mesh<Mesh>(meshes::cube(6));
  const double length = mean_edge_length(input);
  Mesh m = input;
  Edge_map none = m.add_property_map<Edge, bool>("e:none", false).first;
  CHECK(IAR::isotropic_remeshing(length, m, parameters::edge_is_constrained_map(none)).features == Features::none);
  m = input;
  const auto report = IAR::isotropic_remeshing(length, m, parameters::sharpness_angle(80));
  CHECK(report.features == Features::marked && report.feature_edges == 12 * 6);
  // Where a functor leads to another surface, the input's edges mean nothing.
  m = input;
  const Point centre = CGAL::centroid(input.points().begin(), input.points().end());
  const auto onto_sphere = [&](const Point& p) { return centre + (p - centre) / std::sqrt((p - centre).squared_length()); };
  CHECK(IAR::isotropic_remeshing(length, m, parameters::projection_functor(onto_sphere)).features == Features::none);
  m = input;
  const IAR::Closest_point_projector<Mesh> itself(input);
  CHECK(IAR::isotropic_remeshing(length, m, parameters::projection_functor(std::cref(itself))).features ==
        Features::all_sharp_edges);
}

// Vertices on curves lie on the polylines of the input; the map says which edges these are.
void curves_stay_on_their_polylines()
{
  for(const auto& [name, factor] : std::vector<std::pair<std::string, double>>{{"joint", .15}, {"rotor", .5}, {"fandisk", 1}})
  {
    Mesh m = models::of_cgal(name);
    if(meshes::is_small_run() && m.number_of_faces() > 1300)
      continue;
    Edge_map map = m.add_property_map<Edge, bool>("e:constrained", false).first;
    PMP::detect_sharp_edges(m, 40, map);
    const std::vector<Segment_3> marked = edges_where(m, [&](Edge e) { return map[e]; });
    const double length = factor * mean_edge_length(m);
    IAR::isotropic_remeshing(length, m, parameters::edge_is_constrained_map(map));
    const std::vector<Segment_3> result = edges_where(m, [&](Edge e) { return map[e]; });
    const Segments input(marked, length);
    double total = 0, before = 0;
    for(const Segment_3& s : result)
    {
      CHECK(input.distance(s.source()) < 1e-9 && input.distance(s.target()) < 1e-9);
      total += std::sqrt(s.squared_length());
    }
    for(const Segment_3& s : marked)
      before += std::sqrt(s.squared_length());
    CHECK_MESSAGE(total <= before * (1 + 1e-9) && total > .97 * before, name << ": " << total / before);
    CHECK_MESSAGE(share_kept(marked, result, .0501 * length) > .999, name << ": " << share_kept(marked, result, .0501 * length));
  }
}

// With relax_constraints(false) the input's vertices on curves stay, or go; by default they slide.
void sliding_can_be_turned_off()
{
  const Mesh input = models::of_cgal("three_peaks");
  std::set<Point> border;
  for(const Vertex v : input.vertices())
    if(input.is_border(v))
      border.insert(input.point(v));
  for(const bool relaxes : {false, true})
  {
    Mesh m = input;
    IAR::isotropic_remeshing(.9 * mean_edge_length(input), m, parameters::relax_constraints(relaxes));
    std::size_t kept = 0, moved = 0;
    for(const Vertex v : m.vertices())
      if(std::size_t(v) < input.number_of_vertices() && input.is_border(v))
        (border.count(m.point(v)) > 0 ? kept : moved) += 1;
    CHECK_MESSAGE(relaxes ? moved > kept : moved == 0 && kept > 20, relaxes << ": " << kept << " kept, " << moved << " moved");
  }
  Mesh by_default = input, relaxed = input;
  IAR::isotropic_remeshing(.9 * mean_edge_length(input), by_default);
  IAR::isotropic_remeshing(.9 * mean_edge_length(input), relaxed, parameters::relax_constraints(true));
  CHECK(meshes::Picture<Mesh>(by_default) == meshes::Picture<Mesh>(relaxed));
}

// So, too, on features that nobody marked.
void vertices_of_found_features_stay_where_asked_for()
{
  // squares of uneven width: the columns of a cube moved towards one side
  Soup soup = meshes::cube(10);
  for(auto& p : soup.points)
    for(double& x : p)
      x += .3 * x * (1 - x);
  const Mesh input = meshes::to_mesh<Mesh>(soup);
  std::set<Point> sharp;
  for(const Edge e : input.edges())
    if(dihedral_angle(e, input) > 40)
      sharp.insert({input.point(input.vertex(e, 0)), input.point(input.vertex(e, 1))});
  CHECK(sharp.size() == 12 * 9 + 8);
  for(const bool relaxes : {false, true})
  {
    Mesh m = input;
    const auto report = IAR::isotropic_remeshing(mean_edge_length(input), m, parameters::relax_constraints(relaxes));
    CHECK(report.features == Features::all_sharp_edges && report.feature_edges == 120);
    std::size_t kept = 0, moved = 0;
    for(const Vertex v : m.vertices())
      if(std::size_t(v) < input.number_of_vertices() && sharp.count(input.point(v)) > 0)
        (m.point(v) == input.point(v) ? kept : moved) += 1;
    CHECK_MESSAGE(relaxes ? moved > kept : moved == 0 && kept > 60, relaxes << ": " << kept << " kept, " << moved << " moved");
  }
}

// collapse_constraints(false) speaks of what is marked and of the border.
void found_features_are_collapsed_in_any_case()
{
  const Mesh input = meshes::to_mesh<Mesh>(meshes::turned({{1, 0}, {1, 2}}, 64, false));
  for(const double length : {.2, .4})
  {
    Mesh by_default = input, kept = input, marked = input;
    const IAR::Remeshing_report r = IAR::isotropic_remeshing(length, by_default);
    const IAR::Remeshing_report s = IAR::isotropic_remeshing(length, kept, parameters::collapse_constraints(false));
    CHECK(r.feature_edges == 128 && s.feature_edges == 128);
    CHECK_MESSAGE(double(s.output_faces) < 1.1 * double(r.output_faces) && s.angles_after.minimum > 30,
                  r.output_faces << ", " << s.output_faces << ", " << s.angles_after.minimum);
    const Edge_map map = marked.add_property_map<Edge, bool>("e:marked", false).first;
    PMP::detect_sharp_edges(marked, 40, map);
    IAR::isotropic_remeshing(length, marked, parameters::edge_is_constrained_map(map).collapse_constraints(false));
    CHECK(std::count_if(marked.edges_begin(), marked.edges_end(), [&](Edge e) { return map[e]; }) >= 128);
  }
}

// What the user marks stays straight where the surface between coarse facets is a smooth one: by an edge map, and as the border of
// patches, beside features that are found.
void borders_of_patches_stay_on_their_polylines()
{
  const Mesh input = meshes::to_mesh<Mesh>(meshes::sphere(2));
  const double length = mean_edge_length(input) / 4;
  const auto centre = [](const Mesh& m, Face f) {
    const auto p = corners(f, m);
    return CGAL::centroid(p[0], p[1], p[2]);
  };
  Mesh m = input;
  auto patch = m.add_property_map<Face, int>("f:patch", 0).first;
  for(const Face f : m.faces())
    patch[f] = centre(m, f).z() > 0;
  const auto is_between_patches = [&](Edge e) {
    return patch[m.face(m.halfedge(e, 0))] != patch[m.face(m.halfedge(e, 1))];
  };
  const std::vector<Segment_3> border = edges_where(m, is_between_patches);
  const auto report = IAR::isotropic_remeshing(length, m, parameters::face_patch_map(patch));
  CHECK(border.size() > 10 && report.feature_edges == border.size() && report.features == Features::marked);
  const Segments polyline(border, length);
  double furthest = 0, off_facets = 0;
  for(const Segment_3& s : edges_where(m, is_between_patches))
    furthest = std::max({furthest, polyline.distance(s.source()), polyline.distance(s.target())});
  CHECK_MESSAGE(furthest < 1e-9, furthest / length);
  for(const Vertex v : m.vertices())
    off_facets = std::max(off_facets, std::sqrt((m.point(v) - CGAL::ORIGIN).squared_length()));
  CHECK_MESSAGE(off_facets > 1 - 1e-3 && invariants::surface_distance(input, m).hausdorff() > .1 * length, off_facets);
}

// Corners by turn and by degree, however coarse the target.
void corners_stay()
{
  for(const double factor : {.4, 1., 3., 20.})
  {
    const Mesh cube = meshes::to_mesh<Mesh>(meshes::cube(5)), plate = meshes::to_mesh<Mesh>(meshes::square(7));
    for(const Mesh* input : {&cube, &plate})
    {
      Mesh m = *input;
      IAR::isotropic_remeshing(factor * mean_edge_length(m), m);
      std::set<Point> points;
      double low = std::numeric_limits<double>::infinity(), high = -low;
      for(const Vertex v : input->vertices())
      {
        low = std::min(low, input->point(v).x());
        high = std::max(high, input->point(v).x());
      }
      for(const Vertex v : m.vertices())
        points.insert(m.point(v));
      std::size_t corners = 0;
      for(const Vertex v : input->vertices())
      {
        const Point& p = input->point(v);
        const auto is_extreme = [&](double c) { return c == low || c == high; };
        if(!is_extreme(p.x()) || !is_extreme(p.y()) || (input == &cube && !is_extreme(p.z())))
          continue;
        ++corners;
        CHECK_MESSAGE(points.count(p) == 1, factor << ": " << p);
      }
      CHECK(corners == (input == &cube ? 8 : 4));
    }
  }
}

// Closed curves without a corner: on the polygon at its own length, on the circle where the target is much finer.
void rims_stay_closed_and_become_round()
{
  const Mesh input = meshes::to_mesh<Mesh>(cylinder_wall(16, 6, 2.4));
  for(const double length : {1., .4, .1})
  {
    Mesh m = input;
    const auto report = IAR::isotropic_remeshing(length, m);
    CHECK(topology(m) == topology(input));
    double error = 0;
    for(const Vertex v : m.vertices())
      if(m.is_border(v))
      {
        error = std::max(error, std::abs(std::hypot(m.point(v).x(), m.point(v).y()) - 1));
        CHECK(m.point(v).z() == 0 || std::abs(m.point(v).z() - 2.4) < 1e-12);
      }
    const double sagitta = 1 - std::cos(CGAL_PI / 16);
    CHECK_MESSAGE(error < (length == .1 ? sagitta / 20 : 1.01 * sagitta), length << ": " << error);
    CHECK(length == 1. || (report.angles_after.minimum > 30 && report.angles_after.maximum < 105));
  }
}

// A projector of the mesh itself keeps to the patches as the default does: without that, these models crossed themselves.
void projectors_keep_to_their_patches()
{
  for(const auto& [name, factor] : std::vector<std::pair<std::string, double>>{{"part", .3}, {"rotor", .5}})
  {
    const Mesh input = models::of_cgal(name);
    const double length = factor * mean_edge_length(input);
    Mesh by_default = input, by_closest_point = input, by_mls = input;
    const IAR::Closest_point_projector<Mesh> closest_point(input);
    const IAR::MLS_projector<Mesh> mls(input);
    const auto marked = [&](Mesh& m) {
      Edge_map map = m.add_property_map<Edge, bool>("e:constrained", false).first;
      PMP::detect_sharp_edges(m, 40, map);
      return map;
    };
    IAR::isotropic_remeshing(length, by_default, parameters::edge_is_constrained_map(marked(by_default)));
    IAR::isotropic_remeshing(length, by_closest_point, parameters::edge_is_constrained_map(marked(by_closest_point))
                                                         .projection_functor(std::cref(closest_point)));
    IAR::isotropic_remeshing(length, by_mls, parameters::edge_is_constrained_map(marked(by_mls))
                                               .projection_functor(std::cref(mls)));
    CHECK_MESSAGE(meshes::Picture<Mesh>(by_default) == meshes::Picture<Mesh>(by_closest_point), name);
    CHECK_MESSAGE(!does_self_intersect(by_closest_point) && !does_self_intersect(by_mls), name);
  }
}

// A projector of the whole mesh does for a range what one of the range does: with the edges unmarked, vertices went around them and out of
// the range.
void projectors_keep_to_the_range()
{
  for(const auto& [name, factor] : std::vector<std::pair<std::string, double>>{{"joint", .25}, {"part", .3}})
  {
    const Mesh input = models::of_cgal(name);
    const double length = factor * mean_edge_length(input);
    const CGAL::Bbox_3 box = PMP::bbox(input);
    const auto half = [&](const Mesh& m) {
      std::vector<Face> range;
      for(const Face f : m.faces())
      {
        double sum = 0;
        for(const Vertex v : vertices_around_face(m.halfedge(f), m))
          sum += m.point(v).x();
        if(sum / 3 < (box.xmin() + box.xmax()) / 2)
          range.push_back(f);
      }
      return range;
    };
    const auto unmarked = [](Mesh& m) { return m.add_property_map<Edge, bool>("e:unmarked", false).first; };
    Mesh by_default = input, by_closest_point = input, by_mls = input;
    const IAR::Closest_point_projector<Mesh> closest_point(input);
    const IAR::MLS_projector<Mesh> mls(input);
    IAR::isotropic_remeshing(half(by_default), length, by_default, parameters::edge_is_constrained_map(unmarked(by_default)));
    IAR::isotropic_remeshing(half(by_closest_point), length, by_closest_point,
                             parameters::edge_is_constrained_map(unmarked(by_closest_point))
                               .projection_functor(std::cref(closest_point)));
    CHECK_MESSAGE(meshes::Picture<Mesh>(by_default) == meshes::Picture<Mesh>(by_closest_point), name);
    // Where edges are marked, the MLS surface has them, too.
    const auto marked = [&](Mesh& m) {
      Edge_map map = unmarked(m);
      PMP::detect_sharp_edges(m, 40, map);
      return map;
    };
    IAR::isotropic_remeshing(half(by_mls), length, by_mls, parameters::edge_is_constrained_map(marked(by_mls))
                                                             .projection_functor(std::cref(mls)));
    CHECK_MESSAGE(topology(by_mls) == topology(input) && !does_self_intersect(by_mls), name);
  }
}

// The end of a mesh with the smaller x, that share of its extent.
std::vector<Face> end_of(const Mesh& m, double share)
{
  const CGAL::Bbox_3 box = PMP::bbox(m);
  std::vector<Face> range;
  for(const Face f : m.faces())
    if(m.point(m.target(m.halfedge(f))).x() < box.xmin() + share * (box.xmax() - box.xmin()))
      range.push_back(f);
  return range;
}

// With nothing marked, too: vertices between features were projected onto the wrong side of these, and nothing lowered distances.
void an_mls_projector_of_the_whole_serves_a_range()
{
  for(const char* name : {"anchor", "oblong", "part", "rotor"})
    for(const double share : {.125, .5})
    {
      const Mesh input = models::of_cgal(name);
      const double length = .25 * mean_edge_length(input);
      const IAR::MLS_projector<Mesh> mls(input);
      Mesh m = input;
      IAR::isotropic_remeshing(end_of(m, share), length, m, parameters::projection_functor(std::cref(mls)));
      m.collect_garbage();
      const double distance = surface_distance(input, m).hausdorff() / length;
      CHECK_MESSAGE(m.number_of_faces() > input.number_of_faces() && distance < .3 && !does_self_intersect(m),
                    name << ", " << share << ": " << distance);
    }
}

// --- small ranges ------------------------------------------------------------------------------------------------

// The dihedral angles of a few faces tell nothing about the model; those around them do. Edges of organic models were taken for features,
// too, where a range looked like a part.
void features_of_a_range_are_those_of_the_mesh()
{
  for(const char* name : {"couplingdown", "anchor_dense", "rotor", "camel"})
  {
    Mesh m = models::of_cgal(name);
    const double length = mean_edge_length(m);
    const std::set<Edge> all = found_features(m, length);
    const Edge_map of_range = m.add_property_map<Edge, bool>("e:of_range", false).first;
    std::mt19937 random(3);
    std::size_t same = 0, missed = 0, wrong = 0;
    const std::size_t ranges = meshes::is_small_run() ? 5 : 40;
    for(const std::size_t n : {10, 50, 250, 1000})
      for(std::size_t k = 0; k < ranges; ++k)
      {
        const std::vector<Face> range = faces_around(Face(unsigned(random() % m.number_of_faces())), n, m);
        IAR::detect_features(range, m, of_range, length);
        const std::set<Face> inside(range.begin(), range.end());
        for(const Face f : range)
          for(const auto h : CGAL::halfedges_around_face(m.halfedge(f), m))
          {
            const Face across = m.face(m.opposite(h));
            if(!(f < across) || inside.count(across) == 0)
              continue;
            const bool is_one = all.count(m.edge(h)) > 0, is_found = of_range[m.edge(h)];
            same += is_one && is_found;
            missed += is_one && !is_found;
            wrong += is_found && !is_one;
          }
      }
    CHECK_MESSAGE(100 * missed <= same && wrong <= (all.empty() ? 3 * ranges : 0) && (same > 100 || all.empty()),
                  name << ": " << same << " found, " << missed << " missed, " << wrong << " wrong");
  }
}

// Few faces at the rim of a cylinder.
void few_faces_keep_a_rim()
{
  const Mesh cylinder = meshes::to_mesh<Mesh>(meshes::turned({{1, 0}, {1, 2}}, 64, false));
  std::size_t kept = 0, ranges = 0;
  for(const Edge e : cylinder.edges())
  {
    if(cylinder.is_border(e) || dihedral_angle(e, cylinder) < 80)
      continue;
    ++ranges;
    Mesh m = cylinder;
    const auto report = IAR::isotropic_remeshing(faces_around(m.face(m.halfedge(e)), 5, m), .6 * mean_edge_length(m), m);
    m.collect_garbage();
    kept += report.features == Features::all_sharp_edges && std::abs(PMP::area(m) / PMP::area(cylinder) - 1) < 1e-3 &&
            !does_self_intersect(m);
  }
  CHECK_MESSAGE(ranges >= 64 && kept == ranges, kept << " of " << ranges);
}

// Faces outside that are unfit for anything, near the range or not, are left out: nothing is refused for them, nor lost.
void what_lies_outside_need_not_be_fit()
{
  const Mesh whole = models::of_cgal("anchor");
  const double length = mean_edge_length(whole);
  const std::vector<Face> range = end_of(whole, .5);
  std::set<Vertex> inside;
  for(const Face f : range)
    for(const Vertex v : whole.vertices_around_face(whole.halfedge(f)))
      inside.insert(v);
  std::vector<Vertex> outside;
  for(const Vertex v : whole.vertices())
    if(inside.count(v) == 0)
      outside.push_back(v);
  const double infinity = std::numeric_limits<double>::infinity(), unknown = std::numeric_limits<double>::quiet_NaN();
  std::size_t places = 0;
  for(const double coordinate : {infinity, unknown, std::numeric_limits<double>::max()})
    for(std::size_t i = 0; i < outside.size(); i += outside.size() / 3, ++places)
    {
      Mesh m = whole;
      m.point(outside[i]) = Point(coordinate, 0, -coordinate);
      const Edge_map map = m.add_property_map<Edge, bool>("e:feature", false).first;
      CHECK(IAR::detect_features(range, m, map, length) > 100);
      const auto report = IAR::isotropic_remeshing(range, length, m);
      CHECK_MESSAGE(report.features == Features::all_sharp_edges && CGAL::is_valid_polygon_mesh(m), coordinate << ", " << i);
      CHECK(std::none_of(outside.begin(), outside.end(), [&](Vertex v) { return m.is_removed(v); }));
    }
  CHECK(places >= 9);
}

// The part of a model that is a CAD model on its own is one beside what is none: the notch in a ball of few facets.
void a_part_keeps_its_features_beside_what_is_none()
{
  Mesh cube = meshes::to_mesh<Mesh>(meshes::cube(1));
  const CGAL::Bbox_3 box = PMP::bbox(cube);
  const auto scaled = [](double x, double least, double most) { return .6 * (x - least) / (most - least) - .3; };
  for(const Vertex v : cube.vertices())
    cube.point(v) = Point(1 + scaled(cube.point(v).x(), box.xmin(), box.xmax()), scaled(cube.point(v).y(), box.ymin(), box.ymax()),
                          scaled(cube.point(v).z(), box.zmin(), box.zmax()));
  Mesh m = models::difference(meshes::to_mesh<Mesh>(meshes::sphere(1)), cube);
  const auto is_of_notch = [&](Vertex v) {
    const Point& p = m.point(v);
    return p.x() > .7 - 1e-9 && std::abs(p.y()) < .3 + 1e-9 && std::abs(p.z()) < .3 + 1e-9;
  };
  std::vector<Face> notch;
  for(const Face f : m.faces())
  {
    const auto corners = m.vertices_around_face(m.halfedge(f));
    if(std::all_of(corners.begin(), corners.end(), is_of_notch))
      notch.push_back(f);
  }
  const Edge_map map = m.add_property_map<Edge, bool>("e:feature", false).first;
  const double length = .1;
  const std::size_t of_all = IAR::detect_features(m.faces(), m, map, length), of_notch = IAR::detect_features(notch, m, map, length);
  CHECK_MESSAGE(of_all < of_notch && of_notch >= 8, of_all << ", " << of_notch << " of " << notch.size() << " faces");
  const auto report = IAR::isotropic_remeshing(notch, length, m);
  CHECK_MESSAGE(report.features == Features::all_sharp_edges && report.feature_edges == of_notch, report.feature_edges);
}

// --- curves of every shape ---------------------------------------------------------------------------------------

// Marks edges of the square of 20 by 20 cells, by their ends in cells.
template <class Predicate>
Edge_map mark(Mesh& m, const Predicate& is_marked)
{
  const Edge_map map = m.add_property_map<Edge, bool>("e:marked", false).first;
  for(const Edge e : m.edges())
  {
    const auto cell = [&](int k) {
      const Point& p = m.point(m.vertex(e, k));
      return std::array<int, 2>{int(std::lround(20 * p.x())), int(std::lround(20 * p.y()))};
    };
    map[e] = is_marked(cell(0), cell(1));
  }
  return map;
}

// The marked edges are on the same lines, all of them; nothing folds over, though the curves be short or close together.
template <class Predicate>
void check_marked_square(const char* name, const Predicate& is_marked)
{
  for(const double factor : {.4, 1., 2.5, 6.})
  {
    Mesh m = meshes::to_mesh<Mesh>(meshes::square(20));
    const Edge_map map = mark(m, is_marked);
    const auto marked = [&]() { return segments(m, [&](Edge e) { return map[e]; }); };
    const std::vector<Segment> before = marked();
    const auto total = [](const std::vector<Segment>& all) {
      double sum = 0;
      for(const Segment& s : all)
        sum += std::sqrt(CGAL::squared_distance(s.source, s.target));
      return sum;
    };
    CHECK(!before.empty());
    IAR::isotropic_remeshing(factor / 20, m, parameters::edge_is_constrained_map(map));
    CHECK_MESSAGE(distance(before, marked()) < 1e-9, name << ", " << factor << ": " << distance(before, marked()));
    CHECK_MESSAGE(std::abs(total(before) - total(marked())) < 1e-9, name << ", " << factor);
    for(const Face f : m.faces())
      CHECK_MESSAGE(normal(f, m).z() > 0, name << ", " << factor);
    CHECK_MESSAGE(std::abs(PMP::area(m) - 1) < 1e-9, name << ", " << factor << ": " << PMP::area(m) - 1);
  }
}

void curves_may_end_meet_and_run_side_by_side()
{
  using Cell = std::array<int, 2>;
  const auto is_along_row = [](const Cell& a, const Cell& b, int row) { return a[1] == row && b[1] == row; };
  const auto is_along_column = [](const Cell& a, const Cell& b, int column) { return a[0] == column && b[0] == column; };
  check_marked_square("a curve that ends twice inside", [&](const Cell& a, const Cell& b) {
    return is_along_row(a, b, 9) && std::min(a[0], b[0]) >= 4 && std::max(a[0], b[0]) <= 13;
  });
  check_marked_square("one edge", [&](const Cell& a, const Cell& b) {
    return is_along_row(a, b, 9) && std::min(a[0], b[0]) == 9;
  });
  check_marked_square("a T", [&](const Cell& a, const Cell& b) {
    return is_along_row(a, b, 9) || (is_along_column(a, b, 12) && std::min(a[1], b[1]) >= 9);
  });
  check_marked_square("two curves one cell apart, and the border", [&](const Cell& a, const Cell& b) {
    return is_along_row(a, b, 9) || is_along_row(a, b, 10) || is_along_row(a, b, 19);
  });
  check_marked_square("a cusp of 45 degrees", [&](const Cell& a, const Cell& b) {
    return (is_along_row(a, b, 3) && std::min(a[0], b[0]) >= 3) ||
           (a[0] == a[1] && b[0] == b[1] && std::min(a[0], b[0]) >= 3);
  });
}

// Two circles' arcs that touch each other: the border's angle falls to nothing at the cusp.
void a_cusp_of_the_border_stays()
{
  constexpr std::size_t COLUMNS = 24, ROWS = 6;
  Soup soup;
  soup.points.push_back({0, 0, 0});
  for(std::size_t i = 1; i <= COLUMNS; ++i)
    for(std::size_t j = 0; j <= ROWS; ++j)
    {
      const double x = double(i) / COLUMNS;
      soup.points.push_back({x, .3 * x * x * double(j) / ROWS, 0});
    }
  const auto at = [&](std::size_t i, std::size_t j) { return 1 + (i - 1) * (ROWS + 1) + j; };
  for(std::size_t j = 0; j < ROWS; ++j)
    soup.faces.push_back({0, at(1, j), at(1, j + 1)});
  for(std::size_t i = 1; i < COLUMNS; ++i)
    for(std::size_t j = 0; j < ROWS; ++j)
    {
      soup.faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      soup.faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  const Mesh input = meshes::to_mesh<Mesh>(soup);
  for(const double length : {.02, .05, .2})
  {
    Mesh m = input;
    IAR::isotropic_remeshing(length, m);
    const double d = distance(border(input), border(m));
    CHECK_MESSAGE(d < .06 * length, length << ": " << d / length);
    CHECK(topology(m) == topology(input));
    CHECK(std::count(m.points().begin(), m.points().end(), Point(0, 0, 0)) == 1);
    CHECK(!does_self_intersect(m));
  }
}

// Holes much smaller than the target, and walls much thinner, with the faces that they ask for.
void small_holes_and_thin_walls_survive()
{
  const Mesh input = meshes::to_mesh<Mesh>(meshes::without_isolated_points(meshes::square_without(
    40, [](std::size_t i, std::size_t j) { return (i % 10 == 4 && j % 10 == 4) || (i % 10 == 6 && j % 10 == 4); })));
  for(const double factor : {1., 3., 6.})
  {
    Mesh m = input;
    IAR::isotropic_remeshing(factor / 40, m);
    CHECK_MESSAGE(topology(m) == topology(input), factor << ": " << topology(m));
    const double d = distance(border(input), border(m));
    CHECK_MESSAGE(d < .06 * factor / 40, factor << ": " << 40 * d / factor);
    CHECK(!does_self_intersect(m));
    const auto quality = IAR::inter_angle_statistics(m);
    CHECK_MESSAGE(quality.minimum_angle > 8, factor << ": " << quality.minimum_angle);
  }
}

// A border of steps is no row of corners where the steps are small: it has the faces of a straight one, within the
// tolerance. The three corners that are corners at the scale of the target stay.
void steps_are_no_corners()
{
  constexpr std::size_t N = 120;
  const Mesh input = meshes::to_mesh<Mesh>(meshes::without_isolated_points(meshes::square_without(
    N, [](std::size_t i, std::size_t j) { return i + j >= N; })));
  const double length = 20. / N;
  Mesh m = input;
  IAR::isotropic_remeshing(length, m);
  const auto quality = IAR::inter_angle_statistics(m);
  CHECK_MESSAGE(quality.minimum_angle > 20, quality.minimum_angle);
  const std::size_t before = border(input).size(), after = border(m).size();
  CHECK_MESSAGE(3 * after < before, after << " of " << before);
  for(const Point& p : {Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0)})
    CHECK(std::count(m.points().begin(), m.points().end(), p) == 1);
  CHECK(!does_self_intersect(m));
}

// Borders as good as the interior.
void borders_have_good_angles()
{
  for(const auto& [name, factor] : std::vector<std::pair<std::string, double>>{
        {"patch-30", .5}, {"three_peaks", 1}, {"holes", 1}, {"nefertiti", .5}, {"mesh_with_border", 1}, {"mushroom", 1}, {"lion", 1}})
  {
    const Mesh input = models::of_cgal(name);
    if(meshes::is_small_run() && input.number_of_faces() > 1300)
      continue;
    Mesh ours = input;
    const double length = factor * mean_edge_length(input);
    IAR::isotropic_remeshing(length, ours);
    const Mesh theirs = models::remeshed_by_pmp(input, length);
    const auto quality = IAR::inter_angle_statistics(ours), peer = IAR::inter_angle_statistics(theirs);
    CHECK_MESSAGE(quality.minimum_unforced_angle > 25 && quality.maximum_unforced_angle < 115,
                  name << ": " << quality.minimum_unforced_angle << " to " << quality.maximum_unforced_angle);
    CHECK_MESSAGE(quality.average > peer.average + 1.5, name << ": " << quality.average << " against " << peer.average);
    CHECK_MESSAGE(topology(ours) == topology(input), name);
    CHECK_MESSAGE(!does_self_intersect(ours), name);
  }
}

// Behind the face of an acute corner, which nothing can change, no other one is thin: the corner's edges grow until there is room.
void acute_corners_spoil_one_face()
{
  for(const double apex : {8., 12.})
    for(const double length : {.07, .1, .15, .2, .3})
    {
      const double x = 10 * std::cos(apex / 360 * CGAL_PI), y = 10 * std::sin(apex / 360 * CGAL_PI);
      Mesh m = meshes::to_mesh<Mesh>(Soup{{{0, 0, 0}, {x, -y, 0}, {x, y, 0}}, {{0, 1, 2}}});
      IAR::isotropic_remeshing(length, m);
      const auto quality = IAR::inter_angle_statistics(m);
      CHECK_MESSAGE(quality.minimum_unforced_angle > 25 && quality.maximum_unforced_angle < 110,
                    apex << " at " << length << ": " << quality.minimum_unforced_angle << " to " << quality.maximum_unforced_angle);
      CHECK_MESSAGE(std::abs(quality.minimum_angle - apex) < 1e-6, quality.minimum_angle);
    }
}

// Rings of three and four sides are strips one face wide. Where the edges across were just too long, all edges along got another vertex
// between them, and flips laid the edges down: angles of 113 to 127 degrees, and twice the faces.
void rings_of_few_sides_have_no_flat_faces()
{
  for(const std::size_t sides : {3, 4})
    for(const std::size_t along : {96, 112, 128})
    {
      const Mesh input = models::from_soup(meshes::torus(along, sides, .02));
      for(const double factor : {.9, 1., 1.1})
      {
        Mesh m = input;
        IAR::isotropic_remeshing(factor * mean_edge_length(input), m);
        const auto angles = IAR::inter_angle_statistics(m);
        const std::string name = std::to_string(sides) + " sides, " + std::to_string(along) + " at " + std::to_string(factor) + ": ";
        CHECK_MESSAGE(angles.maximum_angle < 111, name << angles.maximum_angle);
        CHECK_MESSAGE(angles.average > 37, name << angles.average);
        CHECK_MESSAGE(m.number_of_faces() < 2 * input.number_of_faces(), name << m.number_of_faces());
      }
    }
}

// The lips of a closed mouth would be features side by side, with a strip of needles between them. The least angle is one of few beside
// other features: 25 to 35 degrees, as the length happens to be.
void slits_are_no_features()
{
  if(meshes::is_small_run())
    return;
  const Mesh input = models::of_cgal("mannequin-devil");
  double sum = 0;
  for(const double factor : {1.94, 2., 2.06})
  {
    Mesh m = input;
    IAR::isotropic_remeshing(factor * mean_edge_length(m), m);
    const auto quality = IAR::inter_angle_statistics(m);
    CHECK_MESSAGE(quality.minimum_angle > 22 && quality.maximum_angle < 112,
                  factor << ": " << quality.minimum_angle << " to " << quality.maximum_angle);
    sum += quality.minimum_angle;
  }
  CHECK_MESSAGE(sum > 3 * 30, sum / 3);
}

// Details smaller than the target: the target follows the curves' edges, or not.
void grading_mends_small_details()
{
  const Mesh input = models::of_cgal("couplingdown");
  const double length = .7 * mean_edge_length(input);
  Mesh graded = input, uniform = input;
  IAR::Recipe recipe;
  recipe.grading = 0;
  IAR::isotropic_remeshing(length, graded);
  IAR::isotropic_remeshing(faces(uniform), length, uniform, IAR::recipe(recipe));
  CHECK(graded.number_of_faces() > uniform.number_of_faces());
  const auto quality = IAR::inter_angle_statistics(graded);
  CHECK(quality.average > IAR::inter_angle_statistics(uniform).average + 2);
  CHECK_MESSAGE(quality.maximum_unforced_angle < 115, quality.maximum_unforced_angle);
  recipe.grading = -1;
  CHECK_THROWS_WITH_TEXT(IAR::isotropic_remeshing(faces(uniform), length, uniform, IAR::recipe(recipe)),
                         CGAL::Precondition_exception, "grading");
}

// A box over the unit square whose upright edges are chamfers, so wide that they take `c` of each side; its sides are in so many rows.
Mesh chamfered_box(double c, double height, int rows = 1)
{
  Soup box;
  for(int row = 0; row <= rows; ++row)
    for(const auto& [x, y] : {std::pair{c, 0.}, {1 - c, 0.}, {1., c}, {1., 1 - c}, {1 - c, 1.}, {c, 1.}, {0., 1 - c}, {0., c}})
      box.points.push_back({x, y, height * row / rows});
  const std::size_t top = 8 * std::size_t(rows);
  for(std::size_t i = 0; i < 8; ++i)
  {
    const std::size_t j = (i + 1) % 8;
    for(std::size_t row = 0; row < top; row += 8)
    {
      box.faces.push_back({row + i, row + j, row + 8 + j});
      box.faces.push_back({row + i, row + 8 + j, row + 8 + i});
    }
    if(i == 0 || j == 0)
      continue;
    box.faces.push_back({0, j, i});
    box.faces.push_back({top, top + i, top + j});
  }
  return meshes::to_mesh<Mesh>(box);
}

double distance_to_nearest_vertex(const Point& p, const Mesh& m)
{
  double best = std::numeric_limits<double>::infinity();
  for(const Vertex v : m.vertices())
    best = std::min(best, CGAL::squared_distance(p, m.point(v)));
  return std::sqrt(best);
}

bool keeps_all_corners(const Mesh& before, const Mesh& after)
{
  return std::all_of(before.vertices_begin(), before.vertices_end(), [&](Vertex v) {
    return distance_to_nearest_vertex(before.point(v), after) < 1e-12;
  });
}

// Chamfers that are tiny beside the target length are one edge afterwards, and the needles on them are gone; those that are wider
// stay, as all do where that is turned off.
void tiny_chamfers_are_merged()
{
  const double length = .1;
  const Mesh input = chamfered_box(.0005, .4);
  IAR::Recipe kept;
  kept.merging_distance = 0;
  Mesh merged = input, unmerged = input;
  const auto report = IAR::isotropic_remeshing(length, merged);
  CHECK(CGAL::is_valid_polygon_mesh(merged) && topology(merged) == topology(input) && !does_self_intersect(merged));
  CHECK(report.features == Features::all_sharp_edges && report.angles_after.minimum > 30 && report.angles_after.maximum < 110);
  CHECK(report.input_faces == input.number_of_faces() && report.angles_before.minimum < 1);     // before, not after they are merged
  CHECK_MESSAGE(invariants::surface_distance(input, merged).hausdorff() < .02 * length,
                invariants::surface_distance(input, merged).hausdorff());
  CHECK(PMP::volume(merged) > .3995 && PMP::volume(merged) < .4005);
  CHECK(IAR::isotropic_remeshing(faces(unmerged), length, unmerged, IAR::recipe(kept)).angles_after.minimum < 5);
  CHECK(!keeps_all_corners(input, merged) && keeps_all_corners(input, unmerged));

  // So are corners of borders.
  Mesh open = input;
  for(const Mesh::Face_index f : std::vector<Mesh::Face_index>(open.faces_begin(), open.faces_end()))
    if(PMP::compute_face_normal(f, open).z() > .5)
      CGAL::Euler::remove_face(open.halfedge(f), open);
  open.collect_garbage();
  Mesh without_top = open;
  const auto of_open = IAR::isotropic_remeshing(length, without_top);
  CHECK(CGAL::is_valid_polygon_mesh(without_top) && topology(without_top) == topology(open));
  CHECK(of_open.angles_after.minimum > 30 && of_open.angles_after.maximum < 110);

  const Mesh wide = chamfered_box(.008, .4);
  Mesh m = wide;
  IAR::isotropic_remeshing(length, m);
  CHECK(keeps_all_corners(wide, m));
}

// Where two bodies meet, their curve crosses the edges of both: many corners are close together. Each pair left needles. (Measured: least
// angles of 2, 3, 2 and 5 degrees.)
void close_corners_of_unions_are_merged()
{
  for(const char* name : {"double-torus-3-holes", "double-torus-example"})
  {
    const Mesh input = models::from_file(CGAL::data_file_path(std::string("meshes/") + name + ".off"));
    for(const double factor : {1., 2.})
    {
      const double length = factor * mean_edge_length(input);
      Mesh m = input;
      const auto report = IAR::isotropic_remeshing(length, m);
      CHECK(topology(m) == topology(input) && !does_self_intersect(m));
      CHECK_MESSAGE(report.angles_after.minimum > 18, name << " at " << factor << ": " << report.angles_after.minimum);
      CHECK(invariants::surface_distance(input, m).hausdorff() < .2 * length);
    }
  }
}

Mesh rod(const Point& from, const Point& to, double radius, std::size_t sides)
{
  const Vector along = to - from, any = std::abs(along.x()) < std::abs(along.z()) ? Vector(1, 0, 0) : Vector(0, 0, 1);
  Vector x = CGAL::cross_product(along, any), y = CGAL::cross_product(along, x);
  x = x / std::sqrt(x.squared_length());
  y = y / std::sqrt(y.squared_length());
  Mesh m;
  std::vector<Vertex> start, end;
  for(std::size_t i = 0; i < sides; ++i)
  {
    const double t = 2 * CGAL_PI * (double(i) + .13) / double(sides);
    const Vector out = radius * (std::cos(t) * x + std::sin(t) * y);
    start.push_back(m.add_vertex(from + out));
    end.push_back(m.add_vertex(to + out));
  }
  const Vertex first = m.add_vertex(from), last = m.add_vertex(to);
  for(std::size_t i = 0; i < sides; ++i)
  {
    const std::size_t j = (i + 1) % sides;
    m.add_face(start[i], start[j], end[j]);
    m.add_face(start[i], end[j], end[i]);
    m.add_face(first, start[j], start[i]);
    m.add_face(last, end[i], end[j]);
  }
  return m;
}

// A block with twelve bores upright and one along it, wherever chance puts them.
Mesh drilled_block(unsigned seed)
{
  std::mt19937 random(seed);
  const auto in = [&](double a, double b) { return a + (b - a) * (double(random()) / 4294967296.); };
  Mesh block = meshes::to_mesh<Mesh>(meshes::cube(1));
  for(const Vertex v : block.vertices())
  {
    const Point p = block.point(v);
    block.point(v) = Point(2 * p.x() - 1, .7 * (2 * p.y() - 1), .3 * (2 * p.z() - 1));
  }
  for(int bore = 0; bore < 12; ++bore)
  {
    const double radius = in(.03, .12), x = in(-.9, .9), y = in(-.6, .6);
    block = models::difference(block, rod(Point(x, y, -.5), Point(x, y, .5), radius, 24 + std::size_t(in(0, 40))));
  }
  return models::difference(block, rod(Point(-2, .1, 0), Point(2, .1, .02), .11, 48));
}

// Where bores meet and graze each other, many vertices of their rims are tiny distances apart. Merged to junctions they left needles between
// these. (Measured: .06, 0 and 9 degrees.) In the second block two bores leave a wall of a tenth of the target length, where the last bits
// of the input decide between 8 and 34 degrees.
void curves_that_would_touch_stay_apart()
{
  struct Case { unsigned seed; double least_angle; };
  for(const auto& [seed, least_angle] : {Case{4, 20}, Case{9, 4}, Case{10, 10}})
  {
    Mesh m = drilled_block(seed);
    const Topology before = topology(m);
    const auto report = IAR::isotropic_remeshing(.117, m);
    CHECK(CGAL::is_valid_polygon_mesh(m) && topology(m) == before && report.crossing_faces == 0);
    CHECK_MESSAGE(report.angles_after.minimum > least_angle, seed << ": " << report.angles_after.minimum);
  }
}

// A plate that is thinner than that keeps its thickness: its rims are no chamfer.
void thin_plates_do_not_become_flat()
{
  const double length = .1;
  for(const double corner : {.1, .3})
    for(const double thickness : {.0005, .0015})
    {
      const Mesh plate = chamfered_box(corner, thickness);
      Mesh m = plate;
      IAR::isotropic_remeshing(length, m);
      CHECK_MESSAGE(CGAL::is_valid_polygon_mesh(m) && topology(m) == topology(plate), corner << ", " << thickness);
      CHECK_MESSAGE(keeps_all_corners(plate, m), corner << ", " << thickness);
      CHECK_MESSAGE(std::abs(PMP::volume(m) / PMP::volume(plate) - 1) < .01, corner << ", " << thickness << ": " << PMP::volume(m));
    }
}

// A block, 4 by 1 by 1, with a groove along it, so wide at its bottom and at the top; in so many lengths.
Mesh grooved_block(double bottom, double top, std::size_t lengths)
{
  const std::array<std::array<double, 2>, 8> section{{{0, 0}, {1, 0}, {1, 1}, {.5 + top / 2, 1}, {.5 + bottom / 2, .4},
                                                      {.5 - bottom / 2, .4}, {.5 - top / 2, 1}, {0, 1}}};
  const std::size_t n = section.size();
  meshes::Soup soup;
  for(std::size_t i = 0; i <= lengths; ++i)
    for(const auto& [y, z] : section)
      soup.points.push_back({4 * double(i) / double(lengths), y, z});
  for(std::size_t i = 0; i < lengths; ++i)
    for(std::size_t j = 0; j < n; ++j)
    {
      const std::size_t a = i * n + j, b = i * n + (j + 1) % n;
      soup.faces.push_back({a, b + n, b});
      soup.faces.push_back({a, a + n, b + n});
    }
  for(const auto& [a, b, c] : std::vector<std::array<std::size_t, 3>>{{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {0, 4, 5}, {0, 5, 7}, {5, 6, 7}})
  {
    soup.faces.push_back({a, b, c});
    soup.faces.push_back({lengths * n + a, lengths * n + c, lengths * n + b});
  }
  return meshes::to_mesh<Mesh>(soup);
}

// Beside the width that a groove or a wing has one target length away from its edge, the bottom or the blunt edge may be nothing.
void blunt_edges_of_wedges_become_sharp()
{
  const double length = .1;
  for(const double width : {.0005, .004})
    for(const std::size_t lengths : {1, 40})
    {
      const Mesh input = grooved_block(width, .2, lengths);
      Mesh m = input;
      const auto report = IAR::isotropic_remeshing(length, m);
      CHECK(topology(m) == topology(input) && !does_self_intersect(m));
      CHECK_MESSAGE(report.angles_after.minimum > 30 && report.angles_after.maximum < 105,
                    width << ", " << lengths << ": " << report.angles_after.minimum << " to " << report.angles_after.maximum);
      CHECK(invariants::surface_distance(input, m).hausdorff() < 1.1 * width);
    }
  // What is wider stays, and what would close a slit.
  for(const auto& [bottom, top] : {std::make_pair(.008, .2), std::make_pair(.0005, .0005), std::make_pair(.001, .002)})
  {
    const Mesh input = grooved_block(bottom, top, 40);
    Mesh m = input;
    IAR::isotropic_remeshing(length, m);
    CHECK_MESSAGE(keeps_all_corners(grooved_block(bottom, top, 1), m) && topology(m) == topology(input), bottom << ", " << top);
  }
}

// The sides of a plate are strips whose ends are corners. Where nothing else was to be split, they had stayed as they were, with angles of
// 6 and 11 degrees.
void plates_and_bars_have_good_angles_at_long_targets()
{
  for(const auto& [width, height, lengths] : {std::make_tuple(1., .2, std::vector<double>{.75, .78, 1., 1.5}),
                                              std::make_tuple(1., .1, std::vector<double>{.45, .6, .8}),
                                              std::make_tuple(.2, .2, std::vector<double>{.7, .9})})
    for(const double length : lengths)
    {
      Mesh box = meshes::to_mesh<Mesh>(meshes::cube(1));
      for(const Vertex v : box.vertices())
        box.point(v) = Point(box.point(v).x(), width * box.point(v).y(), height * box.point(v).z());
      const double volume = PMP::volume(box);
      Mesh m = box;
      const auto report = IAR::isotropic_remeshing(length, m);
      CHECK_MESSAGE(report.angles_after.minimum > 30 && report.angles_after.maximum < 105,
                    width << " " << height << " " << length << ": " << report.angles_after.minimum << " to " << report.angles_after.maximum);
      CHECK(topology(m) == topology(box) && std::abs(PMP::volume(m) - volume) < 1e-9 * volume);
    }
}

// Where the target length is long beside the cross section of a part, what is tiny beside it is the part itself: merged, it would cross
// itself.
void merging_makes_nothing_cross()
{
  Mesh input = models::of_cgal("joint");
  for(const Vertex v : input.vertices())
    input.point(v) = Point(20 * input.point(v).x(), input.point(v).y(), input.point(v).z());
  CHECK(!does_self_intersect(input));
  for(const double factor : {3.5, 4., 4.5, 5.})
  {
    Mesh m = input;
    IAR::isotropic_remeshing(factor * mean_edge_length(input), m);
    CHECK_MESSAGE(!does_self_intersect(m), factor);
    CHECK(topology(m) == topology(input));
  }
}

// The attributes of faces that stay are found on the input.
void attributes_of_merged_chamfers_are_found()
{
  Mesh attributed = chamfered_box(.0005, .4);
  const auto side = attributed.add_property_map<Mesh::Face_index, int>("f:side", -1).first;
  const auto height = attributed.add_property_map<Vertex, double>("v:height", -1).first;
  for(const Mesh::Face_index f : attributed.faces())
    side[f] = PMP::compute_face_normal(f, attributed).z() > .5;
  for(const Vertex v : attributed.vertices())
    height[v] = attributed.point(v).z();
  IAR::Attribute_transfer<Mesh> transfer;
  transfer.add_face_map(side);
  transfer.add_vertex_map(height);
  IAR::isotropic_remeshing(faces(attributed), .1, attributed, parameters::visitor(transfer));
  for(const Mesh::Face_index f : attributed.faces())
    CHECK(side[f] == (PMP::compute_face_normal(f, attributed).z() > .5));
  for(const Vertex v : attributed.vertices())
    CHECK(std::abs(height[v] - attributed.point(v).z()) < 1e-9);
}

// Nothing is merged that the user speaks about.
void chamfers_stay_where_the_user_says_so()
{
  const double length = .1;
  const Mesh input = chamfered_box(.0005, .4);
  Mesh marked = input;
  Edge_map map = marked.add_property_map<Edge, bool>("e:marked", false).first;
  PMP::detect_sharp_edges(marked, 40, map);
  IAR::isotropic_remeshing(faces(marked), length, marked, parameters::edge_is_constrained_map(map));
  CHECK(keeps_all_corners(input, marked));
  for(const bool protects : {false, true})
  {
    Mesh m = input;
    IAR::isotropic_remeshing(faces(m), length, m,
                             parameters::protect_constraints(protects).collapse_constraints(false));
    CHECK_MESSAGE(keeps_all_corners(input, m), protects);
  }
  Mesh locked = input;
  const auto is_locked = locked.add_property_map<Vertex, bool>("v:locked", false).first;
  for(const std::size_t i : {0, 7, 9})
    is_locked[Vertex(typename Mesh::size_type(i))] = true;
  IAR::isotropic_remeshing(faces(locked), length, locked, parameters::vertex_is_constrained_map(is_locked));
  for(const std::size_t i : {0, 7, 9})
    CHECK_MESSAGE(distance_to_nearest_vertex(input.point(Vertex(typename Mesh::size_type(i))), locked) == 0, i);
  CHECK(!keeps_all_corners(input, locked));
}

// How far the middles of the fillets of a box, and the tips of its corners, are from a mesh; with that of the edges that
// `rounded_box()` stands for.
double distance_of_rounded_edges(const std::array<double, 3>& half, double r, const Mesh& m)
{
  Soup ridges;
  for(std::size_t axis = 0; axis < 3; ++axis)
    for(const int s : {-1, 1})
      for(const int t : {-1, 1})
      {
        const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
        for(int k = -10; k <= 10; ++k)
        {
          std::array<double, 3> p{};
          p[axis] = .1 * k * half[axis];
          p[u] = s * (half[u] + r * std::sqrt(.5));
          p[v] = t * (half[v] + r * std::sqrt(.5));
          ridges.points.push_back(p);
        }
      }
  std::vector<Point> points;
  for(const auto& p : ridges.points)
    points.emplace_back(p[0], p[1], p[2]);
  return largest_distance(points, m);
}

// Fillets that no face of the result can follow are as good as sharp edges, in corners, too, and whether an edge of the input lies in
// their middle or not. Wider ones are not, nor what is round all over.
void fillets_narrower_than_the_target_are_features()
{
  const std::array<double, 3> half = {1, .7, .5};
  const double length = .4, r = .1;
  IAR::Recipe none;
  none.fillet_width = 0;
  for(const std::size_t n : {4, 5, 12})
  {
    const Mesh input = meshes::to_mesh<Mesh>(meshes::rounded_box(half, r, n));
    CHECK(CGAL::is_closed(input) && CGAL::is_valid_polygon_mesh(input));
    Mesh sharp = input, serrated = input;
    const auto report = IAR::isotropic_remeshing(length, sharp);
    IAR::isotropic_remeshing(faces(serrated), length, serrated, IAR::recipe(none));
    CHECK(CGAL::is_valid_polygon_mesh(sharp) && topology(sharp) == topology(input) && !does_self_intersect(sharp));
    CHECK_MESSAGE(report.features != Features::none && report.angles_after.minimum > 25 && report.angles_after.maximum < 110,
                  report.angles_after.minimum << " to " << report.angles_after.maximum);
    CHECK_MESSAGE(distance_of_rounded_edges(half, r, sharp) < .08 * length, distance_of_rounded_edges(half, r, sharp));
    CHECK_MESSAGE(distance_of_rounded_edges(half, r, serrated) > .15 * length, distance_of_rounded_edges(half, r, serrated));
    const double hausdorff = invariants::surface_distance(input, sharp).hausdorff();
    CHECK_MESSAGE(hausdorff < .5 * invariants::surface_distance(input, serrated).hausdorff(), hausdorff);

    // The detector finds the same, and nothing at a length that resolves the fillets.
    CHECK(found_features(input, length).size() == report.feature_edges);
    CHECK(found_features(input, length / 2).empty() && found_features(input).empty());
    Mesh fine = input, other = input;
    IAR::isotropic_remeshing(length / 2, fine);
    IAR::isotropic_remeshing(faces(other), length / 2, other, IAR::recipe(none));
    CHECK(meshes::triangles(fine) == meshes::triangles(other));
    CHECK(std::equal(fine.points().begin(), fine.points().end(), other.points().begin(), other.points().end()));
    if(meshes::is_small_run())
      break;
  }

  // A pin is round all over; the bevelled rim of a disk is as good as one edge.
  const Mesh pin = meshes::to_mesh<Mesh>(meshes::rounded_box({0, 0, 2}, r, 6));
  CHECK(found_features(pin, length).empty());
  meshes::Profile rim = meshes::arc(.95, .05, .05, -.5, 0, 3);
  rim = meshes::joined(rim, meshes::arc(.95, .4, .05, 0, .5, 3));
  const Mesh disk = meshes::to_mesh<Mesh>(meshes::turned(rim, 64, false));
  Mesh m = disk;
  IAR::isotropic_remeshing(.2, m);
  CHECK_MESSAGE(invariants::surface_distance(disk, m).hausdorff() < .03, invariants::surface_distance(disk, m).hausdorff());
  CHECK(!does_self_intersect(m) && IAR::inter_angle_statistics(m).minimum_angle > 30);
}

// A shaft with a head and 20 grooves, .1 apart and of this depth, in 96 facets.
Mesh grooved_shaft(double depth)
{
  meshes::Profile profile = {{2, 0}, {2, 1}, {1, 1}};
  for(int k = 0; k < 20; ++k)
    profile = meshes::joined(profile, {{1 - depth, 1.05 + .1 * k}, {1, 1.1 + .1 * k}});
  return meshes::to_mesh<Mesh>(meshes::turned(meshes::joined(profile, {{1, 4}}), 96, false));
}

// Ridges and grooves that lie much closer together than the target length, and are low, are given up; high ones, ridges alone, and
// what else is sharp are kept.
void a_relief_too_fine_for_the_target_is_no_feature()
{
  IAR::Recipe all;
  all.relief_density = std::numeric_limits<double>::infinity();

  // The stairs of voxels.
  const int radius = 10;
  const Mesh ball = meshes::to_mesh<Mesh>(meshes::voxels(radius, [&](const std::array<int, 3>& c) {
    const auto squared = [](double x) { return x * x; };
    return squared(c[0] + .5) + squared(c[1] + .5) + squared(c[2] + .5) < squared(radius); }));
  CHECK(CGAL::is_closed(ball) && CGAL::is_valid_polygon_mesh(ball));
  Mesh m = ball, stairs = ball;
  const double length = 4, expected = 4 * (4 * CGAL_PI * radius * radius) / (std::sqrt(3.) * length * length);
  const auto report = IAR::isotropic_remeshing(length, m);
  CHECK(report.features == Features::none && report.feature_edges == 0 && found_features(ball, length).empty());
  CHECK_MESSAGE(report.angles_after.minimum > 35 && report.angles_after.maximum < 100,
                report.angles_after.minimum << " to " << report.angles_after.maximum);
  CHECK_MESSAGE(double(report.output_faces) < 1.4 * expected, report.output_faces << " of " << expected);
  CHECK_MESSAGE(invariants::surface_distance(ball, m).hausdorff() < .5 * length, invariants::surface_distance(ball, m).hausdorff());
  CHECK(topology(m) == topology(ball) && !does_self_intersect(m));
  const auto with_stairs = IAR::isotropic_remeshing(faces(stairs), length, stairs, IAR::recipe(all));
  CHECK_MESSAGE(with_stairs.feature_edges == found_features(ball).size() && with_stairs.output_faces > 2 * report.output_faces,
                with_stairs.output_faces);

  // Grooves go, the rims of the head, of the end, and beside the last groove stay; edges that resolve them, or that are short beside
  // their depth, keep all. (Under the head the shallow grooves begin at an angle of just under 40 degrees.)
  const Mesh shaft = grooved_shaft(.06), deep = grooved_shaft(.3);
  const std::size_t rims = 4 * 96, rings = 43 * 96;
  CHECK(found_features(shaft).size() == rings && found_features(deep).size() >= rings);
  CHECK_MESSAGE(found_features(shaft, .4).size() == rims, found_features(shaft, .4).size());
  CHECK(found_features(shaft, .08).size() == rings && found_features(deep, .4) == found_features(deep));
  Mesh smooth = shaft;
  const auto of_shaft = IAR::isotropic_remeshing(.4, smooth);
  CHECK(of_shaft.features == Features::all_sharp_edges && of_shaft.feature_edges == rims);
  CHECK_MESSAGE(of_shaft.angles_after.minimum > 30 && of_shaft.angles_after.average > 52, of_shaft.angles_after.average);
  CHECK_MESSAGE(invariants::surface_distance(shaft, smooth).hausdorff() < .16, invariants::surface_distance(shaft, smooth).hausdorff());

  // By the length there: the same everywhere, or short on the lower half of the grooves.
  Mesh by_field = shaft;
  CHECK(IAR::isotropic_remeshing([](const Point&) { return .4; }, by_field).feature_edges == rims);
  by_field = shaft;
  const std::size_t half = IAR::isotropic_remeshing([](const Point& p) { return p.z() < 2 ? .08 : .4; }, by_field).feature_edges;
  CHECK_MESSAGE(half > rims + 12 * 96 && half < rings - 12 * 96, half);

  // A thin plate has ridges alone.
  Mesh plate = meshes::to_mesh<Mesh>(meshes::cube(10));
  for(const Vertex v : plate.vertices())
    plate.point(v) = Point(plate.point(v).x(), plate.point(v).y(), plate.point(v).z() / 50);
  CHECK(found_features(plate, .3).size() == found_features(plate).size());
}

double total_length(const std::set<Edge>& edges, const Mesh& m)
{
  return std::accumulate(edges.begin(), edges.end(), 0., [&](double sum, Edge e) {
    return sum + std::sqrt(CGAL::squared_distance(m.point(m.vertex(e, 0)), m.point(m.vertex(e, 1)))); });
}

// Where bars of a pile meet, ridges and grooves may lie close together; that is no reason to give up the others.
void piles_of_bars_keep_their_edges()
{
  std::mt19937 random(3);
  const auto any = [&]() { return double(random() % 2001) / 1000 - 1; };
  const auto any_vector = [&]() {
    const double z = any(), y = any(), x = any();
    return Vector(x, y, z);
  };
  Mesh pile = meshes::to_mesh<Mesh>(meshes::cube(1));
  for(const Vertex v : pile.vertices())
    pile.point(v) = CGAL::ORIGIN + 4 * (pile.point(v) - Point(.5, .5, .5));
  for(int i = 0; i < 7; ++i)
  {
    Mesh bar = meshes::to_mesh<Mesh>(meshes::cube(1));
    const Vector axis = any_vector(), side = CGAL::cross_product(axis, any_vector());
    const Vector z = axis / std::sqrt(axis.squared_length()), x = side / std::sqrt(side.squared_length()), y = CGAL::cross_product(z, x);
    for(const Vertex v : bar.vertices())
    {
      const Vector p = bar.point(v) - Point(.5, .5, .5);
      bar.point(v) = CGAL::ORIGIN + .8 * p.x() * x + .8 * p.y() * y + 3.6 * p.z() * z;
    }
    pile = models::difference(pile, bar);
  }
  const double all = total_length(found_features(pile), pile), mean = mean_edge_length(pile);
  for(const double factor : {1., 2., 3.})
    CHECK_MESSAGE(total_length(found_features(pile, factor * mean), pile) > .7 * all,
                  factor << ": " << total_length(found_features(pile, factor * mean), pile) / all);
}

// Faces along a knife's edge are thin, and look away from each other; they are sides of it all the same, and no folded slivers.
void knife_edges_are_features()
{
  constexpr int SECTIONS = 40;
  const std::vector<double> chords = {0, .003, .009, .05, .2, .4, .6, .8, 1};
  for(const double half_angle : {5., 12.})
    for(const double sweep : {0., .1, .3})
    {
      meshes::Soup blade;              // its sharp edge is its first row
      const std::size_t n = chords.size(), rows = 2 * n - 1;
      for(int i = 0; i <= SECTIONS; ++i)
        for(std::size_t j = 0; j < rows; ++j)
        {
          const double x = chords[j < n ? n - 1 - j : j - n + 1], z = x * std::tan(half_angle * CGAL_PI / 180), y = 4. * i / SECTIONS;
          blade.points.push_back({x + sweep * y, y, j < n ? z : -z});
        }
      for(std::size_t i = 0; i < SECTIONS; ++i)
        for(std::size_t j = 0; j + 1 < rows; ++j)
        {
          const std::size_t a = i * rows + j, b = a + rows;
          blade.faces.push_back({a, b, b + 1});
          blade.faces.push_back({a, b + 1, a + 1});
        }
      const Mesh input = meshes::to_mesh<Mesh>(blade);
      CHECK_MESSAGE(found_features(input).size() == SECTIONS, sweep << ": " << found_features(input).size());
      Mesh m = input;
      IAR::isotropic_remeshing(mean_edge_length(input), m);
      CHECK_MESSAGE(invariants::surface_distance(input, m).hausdorff() < .05 * mean_edge_length(input), sweep << ", " << half_angle);
    }
}

// Facets of a round rim are no details: the target follows those edges only that the rim needs. (Measured: 360 and 938 faces, 424
// and 1010 in three iterations, where its facets ruled 1024 to 2188, and equilateral ones would be 203 and 812.)
void round_rims_are_coarsened()
{
  const meshes::Profile wall = {{.2, 0}, {.2, .5}};
  const Mesh input = meshes::to_mesh<Mesh>(meshes::turned(wall, 64, false));
  for(const double length : {.1, .05})
    for(const unsigned iterations : {3, 10})
    {
      Mesh m = input;
      const auto report = IAR::isotropic_remeshing(faces(m), length, m, parameters::number_of_iterations(iterations));
      const double wanted = PMP::area(m) / (std::sqrt(3.) / 4 * length * length);
      CHECK_MESSAGE(double(m.number_of_faces()) < 2.5 * wanted, m.number_of_faces() << " for " << wanted);
      CHECK(report.features == Features::all_sharp_edges && report.angles_after.minimum > 30);
      CHECK(invariants::surface_distance(input, m).hausdorff() < .1 * length);
      if(meshes::is_small_run())
        break;
    }
}

double length_of_features(const Mesh& m)
{
  double sum = 0;
  for(const Edge& e : found_features(m))
    sum += PMP::edge_length(m.halfedge(e), m);
  return sum;
}

// A round tower whose wall, with an outer radius of 1, is higher by .3 over half of its `n` parts of six facets each.
Mesh battlements(std::size_t n)
{
  constexpr std::size_t FACETS = 6;
  const double inner = .8, heights[] = {-1, 0, .3};
  const std::size_t around = 2 * n * FACETS;
  meshes::Soup soup;
  const auto vertex = [&](std::size_t i, bool is_outer, std::size_t level) { return 6 * (i % around) + 3 * is_outer + level; };
  for(std::size_t i = 0; i < around; ++i)
    for(const double r : {inner, 1.})
      for(const double z : heights)
        soup.points.push_back({r * std::cos(2 * CGAL_PI * double(i) / double(around)),
                               r * std::sin(2 * CGAL_PI * double(i) / double(around)), z});
  const auto quad = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t d)
  {
    soup.faces.push_back({a, b, c});
    soup.faces.push_back({a, c, d});
  };
  for(std::size_t i = 0; i < around; ++i)
  {
    const auto is_high = [&](std::size_t k) { return k % around / FACETS % 2 == 0; };
    const std::size_t j = i + 1, top = is_high(i) ? 2 : 1;
    for(std::size_t level = 0; level < top; ++level)
    {
      quad(vertex(i, true, level), vertex(j, true, level), vertex(j, true, level + 1), vertex(i, true, level + 1));
      quad(vertex(j, false, level), vertex(i, false, level), vertex(i, false, level + 1), vertex(j, false, level + 1));
    }
    quad(vertex(i, false, 0), vertex(j, false, 0), vertex(j, true, 0), vertex(i, true, 0));
    quad(vertex(i, true, top), vertex(j, true, top), vertex(j, false, top), vertex(i, false, top));
    if(is_high(i) && !is_high(j)) quad(vertex(j, true, 1), vertex(j, false, 1), vertex(j, false, 2), vertex(j, true, 2));
    if(!is_high(i) && is_high(j)) quad(vertex(j, false, 1), vertex(j, true, 1), vertex(j, true, 2), vertex(j, false, 2));
  }
  return models::from_soup(meshes::without_isolated_points(soup));
}

// Remeshed coarsely, round parts have large dihedral angles as well; the sharp edges are still known by the network they form. Where
// edges are long beside the details, chains turn to and fro; but the faces between them are not flat, as on alpha wraps.
void coarse_results_are_still_cad_models()
{
  const auto check = [](const Mesh& input, double length, const std::string& name)
  {
    Mesh m = input;
    IAR::isotropic_remeshing(length, m);
    m.collect_garbage();
    const double features = (std::min)(length_of_features(input), length_of_features(m));
    for(int again = 0; again < 4; ++again)
    {
      const auto report = IAR::isotropic_remeshing(length, m);
      m.collect_garbage();
      CHECK_MESSAGE(report.features == Features::all_sharp_edges, name << ", " << again);
    }
    CHECK_MESSAGE(length_of_features(m) > .9 * features, name << ": " << length_of_features(m) << " of " << features);
    const double distance = invariants::surface_distance(input, m).hausdorff();
    CHECK_MESSAGE(distance < .6 * length, name << ": " << distance / length);
  };
  for(const char* name : {"joint", "anchor", "oblong", "couplingdown", "turbine"})
    if(const Mesh input = models::of_cgal(name); !meshes::is_small_run() || input.number_of_faces() <= 2000)
      check(input, mean_edge_length(input), name);

  // Curves of a few edges each meet at a third to a half of their vertices.
  const Mesh joint = models::of_cgal("joint");
  check(joint, 3 * mean_edge_length(joint), "joint, coarsely");
  check(battlements(6), .4, "battlements");
}

// Simplification breaks the sharp edges of a part: much of them leads to free ends then. The part is plane over a third of its area and more,
// what has grown and was simplified is not. Of few faces, the edges run through, but meet and bend often; in the end, three tenths of the
// edges and more are sharp.
void simplified_parts_are_cad_models()
{
  struct Part { const char* name; std::size_t faces; };
  for(const auto& [name, faces] : {Part{"couplingdown", 2000}, Part{"couplingdown", 2500}, Part{"turbine", 4000}, Part{"couplingdown", 740},
                                   Part{"pinion", 258}, Part{"couplingdown", 250}, Part{"boeing", 250}, Part{"couplingdown", 300},
                                   Part{"pinion", 200}})
  {
    if(meshes::is_small_run() && faces > 2500)
      continue;
    const Mesh input = models::simplified(models::of_cgal(name), faces);
    Mesh m = input;
    const double length = mean_edge_length(input);
    const auto report = IAR::isotropic_remeshing(length, m);
    CHECK_MESSAGE(report.features == Features::all_sharp_edges, name << ", " << faces << ": " << int(report.features));
    const double distance = invariants::surface_distance(input, m).hausdorff();
    CHECK_MESSAGE(distance < .35 * length, name << ", " << faces << ": " << distance / length);
  }
  for(const char* name : {"elephant", "bear", "bull", "camel", "cactus", "homer"})
    for(const std::size_t faces : {500, 1000})
    {
      Mesh m = models::simplified(models::of_cgal(name), faces);
      const auto report = IAR::isotropic_remeshing(mean_edge_length(m), m);
      CHECK_MESSAGE(report.features != Features::all_sharp_edges, name << ", " << faces);
    }
}

// Faces that simplification made long and thin are no samples of a smooth surface, on what has grown, either: the cactus was a tenth of the
// target length thicker on average.
void simplified_plants_are_no_thicker()
{
  for(const std::size_t faces : {400, 600})
  {
    const Mesh input = models::simplified(models::of_cgal("cactus"), faces);
    Mesh m = input;
    const double length = mean_edge_length(input) / 5;
    const auto report = IAR::isotropic_remeshing(length, m);
    CHECK_MESSAGE(report.features != Features::all_sharp_edges, faces);
    const double distance = invariants::surface_distance(input, m).mean();
    CHECK_MESSAGE(distance < .03 * length, faces << ": " << distance / length);
  }
}

// The number of faces with an angle under that, in degrees.
std::size_t number_of_needles(const Mesh& m, double angle = 20)
{
  return std::count_if(m.faces_begin(), m.faces_end(), [&](const Mesh::Face_index f) {
    const auto h = m.halfedge(f);
    const Point p = m.point(m.source(h)), q = m.point(m.target(h)), r = m.point(m.target(m.next(h)));
    return std::min({CGAL::approximate_angle(p, q, r), CGAL::approximate_angle(q, r, p), CGAL::approximate_angle(r, p, q)}) < angle;
  });
}

// What marching cubes make of the voxels that `is_marked` names, each so long along the axes.
template <class Predicate>
Mesh segmentation(const std::array<int, 3>& size, const std::array<double, 3>& voxel, const Predicate& is_marked)
{
  Soup surface = meshes::marching_cubes(size, is_marked);
  for(auto& p : surface.points)
    p = {voxel[0] * p[0], voxel[1] * p[1], voxel[2] * p[2]};
  return models::from_soup(surface);     // turned: two cubes may have cut the side between them in the same way
}

// The mesh without the vertices around which it is flat, as simplification leaves it.
Mesh without_flat_vertices(Mesh m)
{
  const auto cross = [&](Vertex u, Vertex v, Vertex w) {
    return CGAL::cross_product(m.point(v) - m.point(u), m.point(w) - m.point(u)); };
  const auto normal = [&](Halfedge h) { return cross(source(h, m), target(h, m), target(next(h, m), m)); };
  const auto is_parallel = [](const auto& u, const auto& v) {
    return u * v > (1 - 1e-9) * std::sqrt(u.squared_length() * v.squared_length()); };
  for(const Vertex v : std::vector<Vertex>(m.vertices_begin(), m.vertices_end()))
  {
    if(m.is_removed(v))
      continue;
    const auto star = CGAL::halfedges_around_target(v, m);
    const auto plane = normal(m.halfedge(v));
    if(!std::all_of(star.begin(), star.end(), [&](Halfedge h) { return is_parallel(normal(h), plane); }))
      continue;
    const auto is_free = [&](Halfedge way)
    {
      const Vertex u = source(way, m);
      return CGAL::Euler::does_satisfy_link_condition(edge(way, m), m) && std::all_of(star.begin(), star.end(), [&](Halfedge h) {
        const Vertex a = source(h, m), b = target(next(h, m), m);
        return a == u || b == u || is_parallel(cross(a, u, b), plane);
      });
    };
    const auto way = std::find_if(star.begin(), star.end(), is_free);
    if(way == star.end())
      continue;
    const Point p = m.point(source(*way, m));
    const Vertex kept = CGAL::Euler::collapse_edge(edge(*way, m), m);
    m.point(kept) = p;
  }
  m.collect_garbage();
  return m;
}

constexpr double RADIUS = 12.3;
bool is_in_ball(double x, double y, double z) { return x * x + y * y + z * z < RADIUS * RADIUS; }
bool is_in_tilted_ring(double x, double y, double z)
{
  const double u = .8 * x - .6 * z, w = .6 * x + .8 * z, from_circle = std::hypot(u, y) - .66 * RADIUS;
  return from_circle * from_circle + w * w < .1 * RADIUS * RADIUS;
}

// Of what lies within that radius.
template <class Predicate>
Mesh segmentation(const Predicate& is_marked, const std::array<double, 3>& voxel = {1, 1, 1})
{
  const auto size = [&](int k) { return int(2 * RADIUS / voxel[k]) + 2; };
  return segmentation({size(0), size(1), size(2)}, voxel, [&](int x, int y, int z) {
    return is_marked(voxel[0] * x - RADIUS, voxel[1] * y - RADIUS, voxel[2] * z - RADIUS); });
}

void check_remeshed_stairs(const Mesh& stairs, double factor)
{
  Mesh m = stairs;
  const double length = factor * mean_edge_length(stairs);
  const auto report = IAR::isotropic_remeshing(length, m);
  CHECK(report.features == Features::none && report.feature_edges == 0);
  CHECK_MESSAGE(report.angles_after.minimum > 38 && report.angles_after.maximum < 92,
                report.angles_after.minimum << " to " << report.angles_after.maximum);
  CHECK(CGAL::is_valid_polygon_mesh(m) && topology(m) == topology(stairs) && !does_self_intersect(m));
  const double moved = invariants::surface_distance(stairs, m).hausdorff();
  CHECK_MESSAGE(moved < .5 * length, moved / length);
  const double grown = PMP::volume(m) / PMP::volume(stairs);
  CHECK_MESSAGE(grown > .98 && grown < 1.02, grown);
}

// The stairs that marching cubes leave around the voxels of a segmentation are not the object's edges.
void stairs_of_voxels_are_no_features()
{
  std::vector<Mesh> segmentations = {segmentation(is_in_tilted_ring)};
  for(const std::array<double, 3>& voxel : {std::array<double, 3>{1, 1, 1}, {1, 1, 3}, {2, 1, 1}})
    segmentations.push_back(segmentation(is_in_ball, voxel));
  for(const Mesh& stairs : segmentations)
  {
    CHECK(CGAL::is_closed(stairs) && PMP::is_outward_oriented(stairs));
    CHECK(std::count_if(stairs.edges_begin(), stairs.edges_end(), [&](Edge e) { return dihedral_angle(e, stairs) > 40; }) > 500);
    CHECK(found_features(stairs).empty());
    for(const double factor : {1., 3.})
      check_remeshed_stairs(stairs, factor);
    if(meshes::is_small_run())
      break;
  }
}

// A few stairs of voxels look like a part.
void small_ranges_on_stairs_have_no_features()
{
  Mesh m = segmentation({20, 20, 20}, {1, 1, 1}, [](int x, int y, int z) {
    return (x - 10) * (x - 10) + (y - 10) * (y - 10) + (z - 10) * (z - 10) < 64; });
  const double length = .25 * mean_edge_length(m);
  const Edge_map map = m.add_property_map<Edge, bool>("e:feature", false).first;
  CHECK(IAR::detect_features(m.faces(), m, map, length) == 0);
  std::mt19937 random(11);
  std::size_t found = 0;
  for(const std::size_t n : {5, 20, 100})
    for(int k = 0; k < 10; ++k)
      found += IAR::detect_features(faces_around(Face(unsigned(random() % m.number_of_faces())), n, m), m, map, length) > 0;
  CHECK_MESSAGE(found == 0, found);
}

// However they lie, with coordinates of single precision, and cut open.
void turned_stairs_are_no_features()
{
  const Mesh ball = segmentation(is_in_ball);
  Mesh turned = ball;
  for(const Vertex v : turned.vertices())
  {
    const Point p = ball.point(v);
    turned.point(v) = Point(float(120 + .48 * p.x() - .6 * p.y() + .64 * p.z()), float(-75 + .8 * p.x() - .6 * p.z()),
                            float(.36 * p.x() + .8 * p.y() + .48 * p.z()));
  }
  CHECK(found_features(turned).empty());
  for(const Mesh::Face_index f : std::vector<Mesh::Face_index>(turned.faces_begin(), turned.faces_end()))
    if(turned.point(target(turned.halfedge(f), turned)).x() > 125)
      CGAL::Euler::remove_face(turned.halfedge(f), turned);
  turned.collect_garbage();
  CHECK(turned.number_of_faces() > 1000 && !CGAL::is_closed(turned) && found_features(turned).empty());
}

// So it is where their flat parts were simplified, if the object is not just some voxels thick.
void simplified_stairs_are_no_features()
{
  for(const Mesh& stairs : {segmentation(is_in_ball), segmentation(is_in_tilted_ring, {.5, .5, .5})})
  {
    const Mesh simplified = without_flat_vertices(stairs);
    CHECK(CGAL::is_valid_polygon_mesh(simplified) && 10 * simplified.number_of_faces() < 9 * stairs.number_of_faces());
    CHECK(std::abs(PMP::volume(simplified) / PMP::volume(stairs) - 1) < 1e-6 && found_features(simplified).empty());
    for(const double factor : {.5, 1.})
      check_remeshed_stairs(simplified, factor);
    if(meshes::is_small_run())
      break;
  }
}

// Nor are those of vessels about as thick as a slice, though many of them are rims of thin walls.
bool is_in_vessels(double x, double y, double z)
{
  const Point fork(0, 0, -4), left(-5, 2, 3), right(4, -3, 4);
  const std::array<Segment_3, 7> axes = {Segment_3(Point(0, 0, -11), fork), Segment_3(fork, left), Segment_3(fork, right),
    Segment_3(left, Point(-9, 5, 10)), Segment_3(left, Point(-2, 6, 9)), Segment_3(right, Point(9, 1, 9)),
    Segment_3(right, Point(5, -9, 10))};
  return std::any_of(axes.begin(), axes.end(), [&](const Segment_3& s) { return CGAL::squared_distance(Point(x, y, z), s) < 1.44; });
}

void stairs_of_thin_vessels_are_no_features()
{
  const Mesh stairs = segmentation(is_in_vessels, {.4, .4, 1.6});
  CHECK(CGAL::is_closed(stairs) && found_features(stairs).empty());
  for(const double factor : {1.5, 3.})
  {
    Mesh m = stairs, with_all = stairs;
    const double length = factor * mean_edge_length(stairs);
    const auto report = IAR::isotropic_remeshing(length, m);
    IAR::isotropic_remeshing(length, with_all, parameters::sharpness_angle(40));
    CHECK(report.features == Features::none && report.feature_edges == 0);
    CHECK(CGAL::is_valid_polygon_mesh(m) && topology(m) == topology(stairs) && !does_self_intersect(m));
    CHECK_MESSAGE(5 * number_of_needles(m) < number_of_needles(with_all), number_of_needles(m) << " of " << number_of_needles(with_all));
    const double moved = invariants::surface_distance(stairs, m).hausdorff();
    CHECK_MESSAGE(moved < .8 * length, moved / length);
  }
}

// Voxels themselves, and bars that are as regular, were designed. Noise is too thin to do without its edges.
void what_resembles_stairs_keeps_its_edges()
{
  CHECK(!found_features(meshes::to_mesh<Mesh>(meshes::voxels(6, [&](const std::array<int, 3>& c) {
    return is_in_ball(2 * c[0], 2 * c[1], 2 * c[2]); }))).empty());
  const int rows = 30;
  CHECK(found_features(chamfered_box(.1, 6, rows)).size() == std::size_t(8 * rows + 2 * 8));
  std::mt19937 random(1);
  std::vector<char> is_noise(26 * 26 * 26);
  for(char& c : is_noise)
    c = random() % 2 == 0;
  const Mesh speckled = segmentation({26, 26, 26}, {1, 1, 1}, [&](int x, int y, int z) {
    const double r = std::hypot(x - RADIUS, y - RADIUS, z - RADIUS);
    return r < RADIUS - 4 || (r < RADIUS - 1 && is_noise[26 * (26 * x + y) + z]); });
  CHECK(!found_features(speckled).empty());
  // Its chamfers are as even as those of a part that has been remeshed; what tells it from one are its saddles.
  Mesh m = speckled;
  CHECK(IAR::isotropic_remeshing(2 * mean_edge_length(speckled), m).features == Features::outstanding_edges);
}

// A plate is no relief, though what is engraved on it lies closer together than the target length: only edges on the side of the groove, half
// or .7 of the plate of 8 by 4, counted, and all edges were given up; volumes of -.7 to 1.6 of the true one were left. Wherever the plate lies.
void a_plate_with_a_groove_stays_a_plate()
{
  constexpr double WIDTH = 4, DEPTH = .02;
  for(const double inside : {.5, .7})
    for(const double thickness : {.6, 1.})
      for(const double bottom : {0., -thickness / 2, .3})
      {
        const double top = bottom + thickness, h = top - DEPTH;
        Mesh input = meshes::to_mesh<Mesh>(meshes::turned({{1, bottom}, {1, top}, {inside, top}, {inside, h}, {inside - DEPTH, h},
                                                           {inside - DEPTH, top}}, 4, false));
        for(const Vertex v : input.vertices())
        {
          const Point p = input.point(v);
          input.point(v) = Point(WIDTH * (p.x() - p.y()), WIDTH / 2 * (p.x() + p.y()), p.z());
        }
        for(const double length : {3.1, 3.3, 4.5})
        {
          Mesh m = input;
          IAR::isotropic_remeshing(length, m);
          const double volume = PMP::volume(m) / PMP::volume(input);
          CHECK_MESSAGE(std::abs(volume - 1) < .05, inside << ", " << thickness << ", " << bottom << ", " << length << ": " << volume);
          CHECK(topology(m) == topology(input));
        }
      }
}

// The sides of steps and grooves are narrow strips, here .057 to .1 target lengths wide. Edges along them were up to four times as long as
// they are wide, and what moves vertices gave up any small angle for a large one: 212, 136 and 510 needles.
void narrow_strips_have_few_needles()
{
  constexpr double R = 4, H = .02;
  const meshes::Profile step{{R, 0}, {R, 1}, {R / 2, 1}, {R / 2, 1 + H}},
                        groove{{R, 0}, {R, 1}, {R / 2, 1}, {R / 2, 1 - H}, {R / 2 - H, 1 - H}, {R / 2 - H, 1}};
  for(const auto& [profile, length] : {std::pair{step, .3}, {groove, .2}, {groove, .25}})
  {
    const Mesh input = meshes::to_mesh<Mesh>(meshes::turned(profile, 4, false));
    Mesh m = input;
    IAR::isotropic_remeshing(length, m);
    const std::size_t needles = number_of_needles(m, 25);
    CHECK_MESSAGE(200 * needles < m.number_of_faces(), length << ": " << needles << " of " << m.number_of_faces());
    CHECK(topology(m) == topology(input) && invariants::surface_distance(input, m).hausdorff() < .01 * length);
  }
}

// A prism between z = 0 and `height`, with edges all around at as many steps; its ends are fans around the axis.
meshes::Soup bar(std::size_t sides, std::size_t rings, double height)
{
  meshes::Profile profile;
  for(std::size_t i = 0; i <= rings; ++i)
    profile.push_back({1, height * double(i) / double(rings)});
  meshes::Soup soup = meshes::turned(profile, sides, false);
  soup.faces.resize(2 * sides * rings);
  const std::size_t bottom = soup.points.size(), top = bottom + 1;
  soup.points.push_back({0, 0, 0});
  soup.points.push_back({0, 0, height});
  for(std::size_t i = 0; i < sides; ++i)
  {
    const std::size_t k = (i + 1) % sides;
    soup.faces.push_back({bottom, k, i});
    soup.faces.push_back({top, rings * sides + i, rings * sides + k});
  }
  return soup;
}

// The facets of a bar are as long as the bar. They were taken for bevels beside the mean edge, and every other edge was lost; volumes of
// .43 to .86. With rings of edges, of hexagons, it was taken for the stairs of voxels many times as long as they are wide: .66 to .94.
void slender_bars_keep_their_edges()
{
  struct Bar { std::size_t sides, rings; double height, length; };
  for(const Bar& b : {Bar{8, 1, 100, 2.2}, {8, 1, 100, 5}, {7, 1, 100, 10}, {8, 1, 50, 3}, {6, 12, 300, 5}, {6, 8, 300, 3}, {6, 40, 1000, 8}})
  {
    const Mesh input = meshes::to_mesh<Mesh>(bar(b.sides, b.rings, b.height));
    CHECK(found_features(input).size() == b.sides * (b.rings + 2));
    Mesh m = input;
    IAR::isotropic_remeshing(b.length, m);
    const double volume = PMP::volume(m) / PMP::volume(input);
    CHECK_MESSAGE(std::abs(volume - 1) < 1e-3, b.sides << ", " << b.rings << ", " << b.length << ": " << volume);
    CHECK(topology(m) == topology(input) && !does_self_intersect(m));
  }
}

// A cylinder whose ends have chamfers, .057 target lengths wide, keeps one rim of each, however its flat ends are cut into faces: from
// one vertex, or by cutting off every other vertex, around and around, which leaves low faces along the rim.
void flat_ends_are_no_strips()
{
  constexpr std::size_t SIDES = 64;
  constexpr double WIDTH = .01, LENGTH = .25;
  const meshes::Profile profile{{1 - WIDTH, 0}, {1, WIDTH}, {1, 1 - WIDTH}, {1 - WIDTH, 1}};
  const meshes::Soup with_fans = meshes::turned(profile, SIDES, false);
  meshes::Soup with_ears = with_fans;
  with_ears.faces.resize(2 * SIDES * (profile.size() - 1));
  const std::size_t top = SIDES * (profile.size() - 1);
  for(std::size_t step = 1; step < SIDES / 2; step *= 2)
    for(std::size_t i = 0; i < SIDES; i += 2 * step)
    {
      const std::size_t j = i + step, k = (i + 2 * step) % SIDES;
      with_ears.faces.push_back({i, k, j});
      with_ears.faces.push_back({top + i, top + j, top + k});
    }
  for(const meshes::Soup& soup : {with_fans, with_ears})
  {
    const Mesh m = meshes::to_mesh<Mesh>(soup);
    CHECK(CGAL::is_closed(m));
    CHECK(found_features(m, LENGTH).size() == 2 * SIDES);
  }
}

// Of ten steps, 1 by 1 by 10, in long faces.
Mesh staircase()
{
  constexpr std::size_t STEPS = 10;
  constexpr double LENGTH = 10;
  meshes::Soup soup;
  std::vector<std::array<double, 2>> profile{{0, 0}, {1, 0}};
  for(std::size_t i = 1; i < STEPS; ++i)
  {
    profile.push_back({1 - (i - 1.) / STEPS, double(i) / STEPS});
    profile.push_back({1 - double(i) / STEPS, double(i) / STEPS});
  }
  profile.push_back({1. / STEPS, 1});
  profile.push_back({0, 1});
  const std::size_t n = profile.size();
  for(const double z : {0., LENGTH})
    for(const auto& p : profile)
      soup.points.push_back({p[0], p[1], z});
  for(std::size_t i = 0; i < n; ++i)
  {
    const std::size_t k = (i + 1) % n;
    soup.faces.push_back({i, k, n + k});
    soup.faces.push_back({i, n + k, n + i});
    if(i == 0 || k == 0)
      continue;
    soup.faces.push_back({0, k, i});
    soup.faces.push_back({n, n + i, n + k});
  }
  return meshes::to_mesh<Mesh>(soup);
}

// Where the steps of a staircase are a relief, its large sides are none: with them went all edges within lengths of the mesh's own, which are
// those of the long steps; volumes of .70 to .97, and distances of .64 to .68 target lengths.
void the_sides_of_a_staircase_stay()
{
  const Mesh input = staircase();
  for(const double length : {.3, .7, 1.})
  {
    Mesh m = input;
    IAR::isotropic_remeshing(length, m);
    const double volume = PMP::volume(m) / PMP::volume(input);
    CHECK_MESSAGE(std::abs(volume - 1) < .03, length << ": " << volume);
    CHECK(topology(m) == topology(input) && !does_self_intersect(m));
    const double moved = invariants::surface_distance(input, m).hausdorff() / length;
    CHECK_MESSAGE(moved < .4, length << ": " << moved);
  }
}

// Lengths far longer elsewhere change nothing in that: volumes were .82 to .93.
void the_sides_of_a_staircase_stay_beside_longer_edges()
{
  const Mesh stairs = staircase();
  Mesh box = meshes::to_mesh<Mesh>(meshes::cube(1));
  for(const Vertex v : box.vertices())
    box.point(v) = Point(20, 0, 0) + 30 * (box.point(v) - CGAL::ORIGIN);
  for(const double length : {.5, .7, .9})
  {
    Mesh m = stairs;
    m += box;
    IAR::isotropic_remeshing([&](const Point& p) { return p.x() < 10 ? length : 6.; }, m);
    const double volume = (PMP::volume(m) - PMP::volume(box)) / PMP::volume(stairs);
    CHECK_MESSAGE(std::abs(volume - 1) < .06, length << ": " << volume);
  }
}

// A bar of .8 by `thickness`, 4 long, whose section turns by so many degrees from end to end.
Mesh twisted_bar(double thickness, std::size_t stations, double degrees)
{
  meshes::Soup soup;
  const double half = thickness / 2;
  for(std::size_t i = 0; i <= stations; ++i)
  {
    const double t = double(i) / double(stations), angle = t * degrees * CGAL_PI / 180, c = std::cos(angle), s = std::sin(angle);
    for(const auto& [x, y] : {std::pair(-.4, -half), std::pair(.4, -half), std::pair(.4, half), std::pair(-.4, half)})
      soup.points.push_back({c * x - s * y, s * x + c * y, 4 * t});
  }
  for(std::size_t i = 0; i < 4 * stations; i += 4)
    for(std::size_t k = 0; k < 4; ++k)
    {
      const std::size_t a = i + k, b = i + (k + 1) % 4;
      soup.faces.push_back({a, b, b + 4});
      soup.faces.push_back({a, b + 4, a + 4});
    }
  const std::size_t last = 4 * stations;
  for(const std::array<std::size_t, 3>& f : {std::array<std::size_t, 3>{0, 2, 1}, {0, 3, 2}, {last, last + 1, last + 2},
                                             {last, last + 2, last + 3}})
    soup.faces.push_back(f);
  return meshes::to_mesh<Mesh>(soup);
}

// Two triangles for each cell of a grid of n by m points, row by row.
void add_cells(meshes::Soup& soup, std::size_t n, std::size_t m)
{
  for(std::size_t i = 0; i + 1 < n; ++i)
    for(std::size_t j = 0; j + 1 < m; ++j)
    {
      const std::size_t a = i * m + j, b = a + m;
      soup.faces.push_back({a, b, b + 1});
      soup.faces.push_back({a, b + 1, a + 1});
    }
}

// The sheet of these n by m points, and its copy at this distance below, joined along their rims.
meshes::Soup plate_under(meshes::Soup soup, std::size_t n, std::size_t m, double thickness)
{
  add_cells(soup, n, m);
  const std::size_t points = soup.points.size(), faces = soup.faces.size();
  for(std::size_t v = 0; v < points; ++v)
    soup.points.push_back({soup.points[v][0], soup.points[v][1], soup.points[v][2] - thickness});
  for(std::size_t f = 0; f < faces; ++f)
    soup.faces.push_back({soup.faces[f][0] + points, soup.faces[f][2] + points, soup.faces[f][1] + points});
  std::vector<std::size_t> rim;
  for(std::size_t i = 0; i + 1 < n; ++i)
    rim.push_back(i * m);
  for(std::size_t j = 0; j + 1 < m; ++j)
    rim.push_back((n - 1) * m + j);
  for(std::size_t i = n - 1; i > 0; --i)
    rim.push_back(i * m + m - 1);
  for(std::size_t j = m - 1; j > 0; --j)
    rim.push_back(j);
  for(std::size_t k = 0; k < rim.size(); ++k)
  {
    const std::size_t a = rim[k], b = rim[(k + 1) % rim.size()];
    soup.faces.push_back({b, a, a + points});
    soup.faces.push_back({b, a + points, b + points});
  }
  return soup;
}

// Paper folded like a map (Miura): n by n parallelograms, whose creases zigzag.
meshes::Soup folded_paper(std::size_t n)
{
  meshes::Soup soup;
  for(std::size_t i = 0; i <= n; ++i)
    for(std::size_t j = 0; j <= n; ++j)
      soup.points.push_back({.5 * double(i), .5 * double(j) + .25 * double(i % 2), .3 * double(j % 2)});
  return soup;
}

// Where all creases turn to and fro, they were taken for stairs of voxels, or for jagged chamfers of a wrap, and went; sheets of a thick
// paper crossed each other then, in 183 to 555 pairs. So did the edges of turned parts of six facets, of which some turn so.
void zigzags_by_design_are_features()
{
  constexpr std::size_t N = 12;
  meshes::Soup sheet = folded_paper(N);
  add_cells(sheet, N + 1, N + 1);
  const Mesh paper = meshes::to_mesh<Mesh>(sheet), plate = meshes::to_mesh<Mesh>(plate_under(folded_paper(N), N + 1, N + 1, .04));
  CHECK(found_features(paper).size() == N * (N - 1));
  CHECK(CGAL::is_closed(plate) && PMP::is_outward_oriented(plate) && found_features(plate).size() == 2 * N * (N - 1) + 8 * N + 2 * (N + 1));
  const Mesh bottle = meshes::to_mesh<Mesh>(meshes::turned({{.6, 0}, {.7, .1}, {.7, 1}, {.6, 1.3}, {.25, 1.6}, {.2, 2}, {.22, 2.1}}, 6, false));
  CHECK(found_features(bottle).size() == 54);
  for(const Mesh& input : {paper, plate, bottle})
    for(const double length : {.1, .2, .4})
    {
      Mesh m = input;
      IAR::isotropic_remeshing(length, m);
      const double moved = invariants::surface_distance(input, m).hausdorff() / length;
      CHECK_MESSAGE(moved < .3 && topology(m) == topology(input) && !does_self_intersect(m),
                    input.number_of_faces() << " faces at " << length << ": " << moved);
      CHECK(!CGAL::is_closed(m) || std::abs(PMP::volume(m) / PMP::volume(input) - 1) < .02);
    }
}

// A curved panel, 2 by 1.4, with noise, and its copy at this distance below, joined along their rims.
Mesh noisy_panel(double thickness, double noise, unsigned seed)
{
  constexpr std::size_t N = 24, M = 17;
  std::mt19937 random(seed);
  const auto any = [&]() { return noise * (2 * double(random()) / 4294967296. - 1); };
  meshes::Soup soup;
  for(std::size_t i = 0; i < N; ++i)
    for(std::size_t j = 0; j < M; ++j)
    {
      const double x = 2 * double(i) / (N - 1) - 1, y = 1.4 * double(j) / (M - 1) - .7;
      soup.points.push_back({x + any(), y + any(), .2 * x * x - .15 * y * y + any()});
    }
  return meshes::to_mesh<Mesh>(plate_under(soup, N, M, thickness));
}

// Between the sharp edges of a twisted bar, and of what is noisy, there are hardly any flat ones, so that these are no CAD models; and of
// edges along both sides of a thin plate's rim, one went, with up to a fifth of the volume.
void thin_plates_keep_both_edges_of_their_rims()
{
  const auto check = [](const Mesh& input, double length, const std::string& name)
  {
    Mesh m = input;
    IAR::isotropic_remeshing(length, m);
    const double volume = PMP::volume(m) / PMP::volume(input), moved = invariants::surface_distance(input, m).hausdorff() / length;
    CHECK_MESSAGE(std::abs(volume - 1) < .02 && moved < .2, name << " at " << length << ": " << volume << ", " << moved);
    CHECK_MESSAGE(topology(m) == topology(input) && number_of_needles(m) == 0, name << " at " << length << ": " << number_of_needles(m));
  };
  for(const double degrees : {90., 180.})
    for(const std::size_t stations : {24, 96})
    {
      const Mesh bar = twisted_bar(.1, stations, degrees);
      CHECK(CGAL::is_closed(bar) && found_features(bar).size() == 4 * stations + 8);
      for(const double length : {.1, .2, .4})
        check(bar, length, std::to_string(stations) + " stations, " + std::to_string(degrees));
    }
  for(const double length : {.1, .15, .3})
    check(noisy_panel(.04, .012, 1), length, "panel");
  // In large company.
  Mesh scene = twisted_bar(.1, 24, 90);
  const std::size_t edges_of_bar = found_features(scene).size();
  Mesh sphere = meshes::to_mesh<Mesh>(meshes::sphere(4));
  for(const Vertex v : sphere.vertices())
    sphere.point(v) = Point(10, 0, 0) + 5 * (sphere.point(v) - CGAL::ORIGIN);
  scene += sphere;
  CHECK(found_features(scene).size() == edges_of_bar && found_features(scene, .2).size() == edges_of_bar);
}

// A crease close to the border is the side of a narrow strip, too: between both there is room for needles only.
void creases_close_to_the_border_are_no_features()
{
  constexpr std::size_t N = 8;
  constexpr double WIDTH = .01;
  meshes::Soup soup = meshes::square(N);
  for(auto& [x, y, z] : soup.points)
    if(y == 0)
    {
      y = 1. / N - .5 * WIDTH;
      z = WIDTH * std::sqrt(.75);
    }
  const Mesh input = meshes::to_mesh<Mesh>(soup);
  CHECK(found_features(input, .1).size() == N && found_features(input, .25).empty());
  Mesh m = input;
  IAR::isotropic_remeshing(.25, m);
  CHECK_MESSAGE(number_of_needles(m) == 0, number_of_needles(m));
}

// Whether the edges of a part are long is a question of that part, however many there are beside it. Of 400 tetrahedra none had a feature,
// and volumes fell to .76.
void parts_keep_their_edges_in_any_company()
{
  constexpr int MANY = 20;
  meshes::Soup scene;
  for(int i = 0; i < MANY * MANY; ++i)
    scene = scene.joined_with(meshes::tetrahedron().moved(4 * (i % MANY), 4 * (i / MANY), 0));
  const Mesh input = meshes::to_mesh<Mesh>(scene);
  for(const double factor : {.5, .7})
  {
    Mesh m = input;
    const auto report = IAR::isotropic_remeshing(factor * mean_edge_length(input), m);
    CHECK_MESSAGE(report.features == Features::all_sharp_edges && report.feature_edges == 6 * MANY * MANY, report.feature_edges);
    CHECK(std::abs(PMP::volume(m) / PMP::volume(input) - 1) < 1e-9 && topology(m) == topology(input));
    if(meshes::is_small_run())
      break;
  }
}

// Alpha wraps have jagged chamfers instead of edges. To keep both rims of each would take many more faces, and needles between them;
// one of them is enough for a sharp edge.
void one_rim_of_a_jagged_chamfer_is_a_feature()
{
  std::size_t one = 0, both = 0, needles_of_one = 0, needles_of_both = 0;
  for(const char* name : {"spool", "part", "pinion"})
  {
    const Mesh wrap = models::wrap(models::of_cgal(name));
    const double length = 2 * mean_edge_length(wrap);
    Mesh m = wrap, with_both = wrap;
    const auto report = IAR::isotropic_remeshing(length, m);
    CHECK_MESSAGE(report.features == Features::outstanding_edges, name);
    CHECK_MESSAGE(CGAL::is_valid_polygon_mesh(m) && topology(m) == topology(wrap) && !does_self_intersect(m), name);
    const double moved = invariants::surface_distance(wrap, m).hausdorff();
    CHECK_MESSAGE(moved < .45 * length, name << ": " << moved / length);

    IAR::isotropic_remeshing(length, with_both, parameters::sharpness_angle(40));
    one += m.number_of_faces();
    both += with_both.number_of_faces();
    needles_of_one += number_of_needles(m);
    needles_of_both += number_of_needles(with_both);
    if(meshes::is_small_run())
      break;
  }
  CHECK_MESSAGE(one < .75 * both, one << " of " << both);
  CHECK_MESSAGE(4 * needles_of_one < needles_of_both, needles_of_one << " of " << needles_of_both);

  // Designed chamfers are straight.
  for(const double length : {.03, .04, .06})
  {
    Mesh even = chamfered_box(.02, .4);
    IAR::isotropic_remeshing(length, even);
    CHECK_MESSAGE(IAR::isotropic_remeshing(2 * length, even).features == Features::all_sharp_edges, length);
  }

  // Thin walls would go with the rims that go.
  const Mesh blade = models::wrap(models::of_cgal("blade"));
  Mesh m = blade;
  CHECK(IAR::isotropic_remeshing(2 * mean_edge_length(blade), m).features == Features::all_sharp_edges);
  CHECK_MESSAGE(PMP::volume(m) > .9 * PMP::volume(blade), PMP::volume(m) << " of " << PMP::volume(blade));
}

// Borders of organic models have such details where they are jagged and their edges not short: fewer of the faces beside them are out of their
// bands then. (Measured: 34 instead of 288, 153 of 304, 23 of 60, 1 of 15.)
void grading_mends_jagged_borders()
{
  IAR::Recipe recipe;
  recipe.grading = 0;
  std::size_t out_with = 0, out_without = 0;
  std::vector<double> gains;
  for(const auto& [name, factor] : std::vector<std::pair<std::string, double>>{
        {"elephant-with-holes", 2}, {"b9_mesh", 2}, {"polygon_mesh", 2}, {"mech-holes-shark", 2}})
  {
    Mesh graded = models::of_cgal(name), uniform = graded;
    if(meshes::is_small_run() && graded.number_of_faces() > 5000)
      continue;
    const double length = factor * mean_edge_length(graded);
    const auto with = IAR::isotropic_remeshing(length, graded);
    const auto without = IAR::isotropic_remeshing(faces(uniform), length, uniform, IAR::recipe(recipe));
    CHECK_MESSAGE(3 * with.number_of_faces_out_of_band < 2 * without.number_of_faces_out_of_band,
                  name << ": " << with.number_of_faces_out_of_band << ", " << without.number_of_faces_out_of_band);
    const double gain = with.angles_after.average - without.angles_after.average;
    CHECK_MESSAGE(gain > .2, name << ": " << gain);
    gains.push_back(gain);
    out_with += with.number_of_faces_out_of_band;
    out_without += without.number_of_faces_out_of_band;
  }
  CHECK_MESSAGE(5 * out_with < 2 * out_without, out_with << ", " << out_without);
  const double gain = std::accumulate(gains.begin(), gains.end(), 0.);
  CHECK_MESSAGE(gain > double(gains.size()), gain);
  // Not where the edges that are short are protected: they say nothing about details.
  Mesh square = meshes::to_mesh<Mesh>(meshes::square(24)), plain = square;
  const auto protect = parameters::protect_constraints(true);
  IAR::isotropic_remeshing(faces(square), .2, square, protect);
  IAR::isotropic_remeshing(faces(plain), .2, plain, IAR::recipe(recipe, protect));
  CHECK(square.number_of_faces() == plain.number_of_faces());
}

// The border of two patches of labels on a sphere zigzags along the input's edges, around a plane. A result that is coarser need not follow
// that: seams run straight on, no farther off than half of the target length.
void jagged_seams_are_followed_at_the_scale_of_the_target()
{
  const Mesh input = meshes::to_mesh<Mesh>(meshes::sphere(5));
  const double edge = mean_edge_length(input);
  for(const Vector& way : {Vector(.3, .5, .8), Vector(.1, -.9, .2), Vector(1, 1, 1)})
    for(const double factor : {2., 3., 4.})
    {
      const double length = factor * edge;
      const Vector normal = way / std::sqrt(way.squared_length());
      Mesh m = input, plain = input;
      auto patch = m.add_property_map<Face, int>("f:patch", 0).first;
      for(const Face f : m.faces())
      {
        const Halfedge h = m.halfedge(f);
        const Point c = CGAL::centroid(m.point(m.source(h)), m.point(m.target(h)), m.point(m.target(m.next(h))));
        patch[f] = (c - CGAL::ORIGIN) * normal > 0 ? 1 : -1;
      }
      IAR::isotropic_remeshing(faces(m), length, m, parameters::face_patch_map(patch));
      IAR::isotropic_remeshing(length, plain);
      const auto angles = IAR::inter_angle_statistics(m);
      CHECK_MESSAGE(angles.minimum_angle > 30 && angles.maximum_angle < 105, factor << ": " << angles.minimum_angle << ".." << angles.maximum_angle);
      CHECK_MESSAGE(double(m.number_of_faces()) < 1.25 * double(plain.number_of_faces()), factor << ": " << m.number_of_faces());
      double farthest = 0;
      for(const Face f : m.faces())
        for(const Vertex v : m.vertices_around_face(m.halfedge(f)))
          farthest = std::max(farthest, -patch[f] * ((m.point(v) - CGAL::ORIGIN) * normal));
      CHECK_MESSAGE(farthest < .5 * length + edge, factor << ": " << farthest / length);
    }
}

// So does the border of a scan that was trimmed triangle by triangle, where the target is long beside its edges: no farther off than .3 of
// it. (Measured as it is followed exactly: angles from 1 degree, 1.3 to 3 times the faces.) It is where its edges are marked, and where they
// are long; so is a border that is smooth.
void jagged_borders_are_followed_at_the_scale_of_the_target()
{
  const Mesh ball = meshes::to_mesh<Mesh>(meshes::sphere(5));
  for(const Vector& way : {Vector(.3, .5, .8), Vector(.1, -.9, .2), Vector(1, 1, 1)})
  {
    Mesh input = ball;
    for(const Face f : std::vector<Face>(input.faces_begin(), input.faces_end()))
    {
      const Halfedge h = input.halfedge(f);
      const Point c = CGAL::centroid(input.point(input.source(h)), input.point(input.target(h)), input.point(input.target(input.next(h))));
      if((c - CGAL::ORIGIN) * way > .4 * std::sqrt(way.squared_length()))
        CGAL::Euler::remove_face(h, input);
    }
    input.collect_garbage();
    const double edge = mean_edge_length(input), of_area = 4 / std::sqrt(3.) * PMP::area(input);
    for(const double factor : {3., 4., 6.})
    {
      Mesh m = input;
      const auto report = IAR::isotropic_remeshing(factor * edge, m);
      CHECK(CGAL::is_valid_polygon_mesh(m) && topology(m) == topology(input));
      CHECK_MESSAGE(report.angles_after.minimum > 25 && report.angles_after.maximum < 115,
                    factor << ": " << report.angles_after.minimum << ".." << report.angles_after.maximum);
      CHECK_MESSAGE(double(m.number_of_faces()) < 1.25 * of_area / (factor * edge * factor * edge), factor << ": " << m.number_of_faces());
      const double moved = distance(border(input), border(m));
      CHECK_MESSAGE(moved < .31 * factor * edge, factor << ": " << moved / (factor * edge));
    }
    const double tolerance = .051;
    Mesh fine = input, marked = input;
    IAR::isotropic_remeshing(edge, fine);
    CHECK_MESSAGE(distance(border(input), border(fine)) < tolerance * edge, distance(border(input), border(fine)) / edge);
    auto is_marked = marked.add_property_map<Edge, bool>("e:marked", false).first;
    for(const Edge e : marked.edges())
      is_marked[e] = marked.is_border(e);
    IAR::isotropic_remeshing(faces(marked), 4 * edge, marked, parameters::edge_is_constrained_map(is_marked));
    CHECK_MESSAGE(distance(border(input), border(marked)) < tolerance * 4 * edge, distance(border(input), border(marked)) / (4 * edge));
  }

  Mesh wave = meshes::to_mesh<Mesh>(meshes::square(60));
  for(const Vertex v : wave.vertices())
  {
    const Point p = wave.point(v);
    wave.point(v) = Point(p.x() + .1 * std::sin(9 * p.y()), p.y() + .1 * std::sin(7 * p.x()), .2 * std::sin(5 * p.x()) * std::cos(6 * p.y()));
  }
  const Mesh smooth = wave;
  const double length = 4 * mean_edge_length(wave);
  IAR::isotropic_remeshing(length, wave);
  CHECK_MESSAGE(distance(border(smooth), border(wave)) < .051 * length, distance(border(smooth), border(wave)) / length);
}

// A sheet of n by n squares of side 1, each with a round hole of 16 edges.
meshes::Soup perforated_sheet(std::size_t n, double radius)
{
  constexpr std::size_t AROUND = 16;
  meshes::Soup soup;
  std::map<std::array<long, 2>, std::size_t> numbers;          // by the place, in millionths
  const auto number = [&](double x, double y)
  {
    const auto [place, is_new] = numbers.insert({{std::lround(1e6 * x), std::lround(1e6 * y)}, soup.points.size()});
    if(is_new)
      soup.points.push_back({x, y, 0});
    return place->second;
  };
  for(std::size_t i = 0; i < n; ++i)
    for(std::size_t j = 0; j < n; ++j)
    {
      std::array<std::size_t, AROUND> hole, frame;
      for(std::size_t k = 0; k < AROUND; ++k)
      {
        const double x = std::cos(2 * CGAL_PI * double(k) / AROUND), y = std::sin(2 * CGAL_PI * double(k) / AROUND);
        const double to_frame = .5 / std::max(std::abs(x), std::abs(y));
        hole[k] = number(double(i) + radius * x, double(j) + radius * y);
        frame[k] = number(double(i) + to_frame * x, double(j) + to_frame * y);
      }
      for(std::size_t k = 0; k < AROUND; ++k)
      {
        const std::size_t l = (k + 1) % AROUND;
        soup.faces.push_back({hole[k], frame[k], frame[l]});
        soup.faces.push_back({hole[k], frame[l], hole[l]});
      }
    }
  return soup;
}

// No corner says that a round hole is a detail, but its edges must be short to stay on it, and the target falls to them.
void grading_mends_round_holes()
{
  const Mesh input = meshes::to_mesh<Mesh>(perforated_sheet(6, .25));
  IAR::Recipe recipe;
  recipe.grading = 0;
  for(const double length : {.45, .6, .8})
  {
    Mesh graded = input, uniform = input;
    IAR::isotropic_remeshing(length, graded);
    IAR::isotropic_remeshing(faces(uniform), length, uniform, IAR::recipe(recipe));
    const auto with = IAR::inter_angle_statistics(graded), without = IAR::inter_angle_statistics(uniform);
    CHECK_MESSAGE(with.minimum_angle > 25 && with.maximum_angle < 115, length << ": " << with.minimum_angle << ".." << with.maximum_angle);
    CHECK_MESSAGE(with.average > without.average + 5,
                  length << ": " << with.average << ", " << without.average);
    // Chords lie within a twentieth of the length from the holes' circles.
    const double growth = PMP::area(graded) - PMP::area(input), bound = .05 * length * 36 * 2 * CGAL_PI * .25;
    CHECK_MESSAGE(growth > 0 && growth < bound, length << ": " << growth << ", " << bound);
  }
}

// A wanted number of faces is met although grading and strips add some: measured -10 to +12% where it is at least that of
// the input, which has to keep its features.
void a_count_is_met_in_spite_of_grading()
{
  for(const auto& [name, count] : std::vector<std::pair<std::string, std::size_t>>{
        {"spool", 8000}, {"rotor", 4800}, {"anchor_dense", 7600}, {"fandisk", 13000}, {"joint", 4500}})
  {
    Mesh m = models::of_cgal(name);
    if(meshes::is_small_run() && m.number_of_faces() > 1300)
      continue;
    IAR::isotropic_remeshing(IAR::Face_count(count), m);
    const double ratio = double(m.number_of_faces()) / double(count);
    CHECK_MESSAGE(ratio > .85 && ratio < 1.15, name << ": " << ratio);
  }
  // A plate of twelve facets: nearly all of its iterations went by with halving them, while the length was corrected for what was to come.
  meshes::Soup plate = meshes::cube(1);
  for(auto& p : plate.points)
    p = {10 * p[0], 6 * p[1], .3 * p[2]};
  for(const std::size_t count : {3000, 12000, 40000})
  {
    Mesh m = meshes::to_mesh<Mesh>(plate);
    IAR::isotropic_remeshing(IAR::Face_count(count), m);
    const double ratio = double(m.number_of_faces()) / double(count);
    CHECK_MESSAGE(std::abs(ratio - 1) < .02, "plate, " << count << ": " << ratio);
  }
}

// Parts of CAD models whose rims have edges of dozens of target lengths: sweeps turned faces over beside these. Where creases are no features
// faces may still cross others; then the report says so, also of those outside, as it did not of rotor and cheese.
void ranges_beside_long_facets_cross_nothing()
{
  struct Part
  {
    const char* name;
    unsigned centre, rings;
    double factor, sharpness;
  };
  for(const Part& part : {Part{"rotor", 330, 5, 1, 180}, {"anchor", 1021, 5, .25, 180}, {"oblong", 601, 5, .25, 0}, {"cheese", 2298, 8, .25, 180},
                          {"turbine", 7668, 8, .25, 0}, {"turbine", 7668, 8, .25, 180}, {"turbine", 1448, 11, 1, 180}})
  {
    Mesh m = models::of_cgal(part.name);
    if(meshes::is_small_run() && m.number_of_faces() > 2000)
      continue;
    const double length = part.factor * mean_edge_length(m);
    auto is_inside = m.add_property_map<Face, bool>("f:inside", false).first;
    std::vector<Face> range = {Face(part.centre)};
    is_inside[range.front()] = true;
    CGAL::expand_face_selection(std::vector<Face>(range), m, part.rings, is_inside, std::back_inserter(range));
    const auto report = part.sharpness > 0 ? IAR::isotropic_remeshing(range, length, m, parameters::sharpness_angle(part.sharpness))
                                           : IAR::isotropic_remeshing(range, length, m);
    const bool crosses = does_self_intersect(m);
    CHECK_MESSAGE(report.are_crossing_faces_known && crosses == (report.crossing_faces > 0), part.name << ": " << report.crossing_faces);
    CHECK_MESSAGE(part.sharpness > 0 || !crosses, part.name);
  }
}

// --- inside --------------------------------------------------------------------------------------------------------

// A greater length finds nothing that the mesh has not at its own.
void coarser_runs_find_no_more()
{
  for(const char* name : {"elephant", "bones", "hand", "handle"})
  {
    const Mesh m = models::of_cgal(name);
    std::set<Edge> before = found_features(m);
    for(const double factor : {1.25, 1.5, 2., 3., 6.})
    {
      const std::set<Edge> found = found_features(m, factor * mean_edge_length(m));
      CHECK_MESSAGE(std::includes(before.begin(), before.end(), found.begin(), found.end()), name << ", " << factor);
    }
  }
}

// The ring around a double pyramid, as sharp as can be and a few lengths long: kept if it is known by enough edges.
void rings_of_a_few_edges_are_no_features()
{
  namespace internal = IAR::internal;
  using Index = internal::Remeshing_mesh::Index;
  for(const std::size_t n : {8, 11, 12, 30})
  {
    Soup soup;
    for(std::size_t i = 0; i < n; ++i)
      soup.points.push_back({std::cos(2 * CGAL_PI * double(i) / double(n)), std::sin(2 * CGAL_PI * double(i) / double(n)), 0});
    soup.points.push_back({0, 0, 1});
    soup.points.push_back({0, 0, -1});
    for(std::size_t i = 0; i < n; ++i)
    {
      soup.faces.push_back({i, (i + 1) % n, n});
      soup.faces.push_back({(i + 1) % n, i, n + 1});
    }
    const Mesh m = meshes::to_mesh<Mesh>(soup);
    const auto copy = internal::copy_whole_surface(m, get(CGAL::vertex_point, m), "test");
    const auto is_on_ring = [&](Index v) { return copy.mesh.position(v).z == 0; };
    internal::Feature_graph graph(copy.mesh, CGAL_PI / 4 / copy.mesh.unit());      // an eighth of the circle
    for(Index h = 0; h < 4 * Index(copy.mesh.number_of_face_slots()); ++h)
      if(copy.mesh.corner(h) < 3 && copy.mesh.opposite(h) > h && is_on_ring(copy.mesh.origin(h)) && is_on_ring(copy.mesh.target(h)))
        graph.add(h, 90);
    CHECK(graph.edges().size() == n);
    internal::Feature_pruning(graph).prune();
    CHECK_MESSAGE(graph.edges().size() == (n < 12 ? 0 : n), n << ": " << graph.edges().size());
  }
}

// Places on a curve are found as by looking at every segment.
void places_on_curves_are_found()
{
  namespace internal = IAR::internal;
  for(const bool is_closed : {false, true})
  {
    // a ring of faces; the outer border has vertices at very uneven distances
    constexpr std::size_t N = 50;
    std::mt19937 random(3);
    std::vector<double> angles;
    for(std::size_t i = 0; i < N; ++i)
      angles.push_back(6.2 * std::pow(std::uniform_real_distribution<>(0, 1)(random), 4));
    std::sort(angles.begin(), angles.end());
    Soup soup;
    for(const double a : angles)
      for(const double r : {1., 2.})
        soup.points.push_back({r * std::cos(a), r * std::sin(a), 0});
    for(std::size_t i = 0; i < (is_closed ? N : N - 1); ++i)
    {
      const std::size_t k = (i + 1) % N;
      soup.faces.push_back({2 * i, 2 * i + 1, 2 * k + 1});
      soup.faces.push_back({2 * i, 2 * k + 1, 2 * k});
    }
    const Mesh m = meshes::to_mesh<Mesh>(soup);
    auto copy = internal::copy_whole_surface(m, get(CGAL::vertex_point, m), "test");
    internal::lock_corners(copy.mesh, std::vector<double>(copy.mesh.number_of_vertex_slots(), 0));
    const internal::Input_curves curves(copy.mesh);
    std::size_t places = 0;
    for(internal::Remeshing_mesh::Index h = 0; h < 4 * internal::Remeshing_mesh::Index(copy.mesh.number_of_face_slots()); ++h)
    {
      if(copy.mesh.corner(h) == 3 || !copy.mesh.has_place(h))
        continue;
      const auto place = copy.mesh.curve_place(h);
      const internal::Vector3 a = copy.mesh.position(copy.mesh.origin(h)), b = copy.mesh.position(copy.mesh.target(h));
      for(const double t : {0., 1e-9, .3, .5, 1 - 1e-9, 1.})
      {
        const internal::Vector3 p = curves.point(place.curve, (1 - t) * place.origin + t * place.target);
        CHECK(length(p - ((1 - t) * a + t * b)) < 1e-12);
        ++places;
      }
      CHECK(curves.deviation(place.curve, place.origin, place.target, a, b) < 1e-12);
    }
    CHECK(places == 6 * 2 * N);
  }
}

// The energy of angles out of a band: as by its definition, and with the gradient of difference quotients.
void the_energy_of_angles_has_its_gradient()
{
  namespace internal = IAR::internal;
  const internal::Angle_band band(44, 85, .3);
  const internal::Vector3 somewhere{.3, .4, .5};
  CHECK(!band.holds(somewhere, somewhere, somewhere));
  std::mt19937 random(11);
  std::uniform_real_distribution<> jitter(-.12, .12);
  for(const bool has_border : {false, true})
  {
    Mesh m = meshes::to_mesh<Mesh>(has_border ? meshes::square(6) : meshes::sphere(2));
    for(const Vertex v : m.vertices())
      m.point(v) = m.point(v) + Vector{jitter(random), jitter(random), jitter(random)};
    const auto copy = internal::copy_whole_surface(m, get(CGAL::vertex_point, m), "test");
    internal::Star_energy star;
    for(internal::Remeshing_mesh::Index v = 0; v < internal::Remeshing_mesh::Index(copy.mesh.number_of_vertex_slots()); ++v)
    {
      star.read(copy.mesh, v, [&](auto, auto) -> const internal::Angle_band& { return band; });
      const internal::Vector3 p = copy.mesh.position(v);
      // At its own place, and at that of a neighbor, where two edges have no length.
      double energy = 0;
      bool holds = true;
      for(const internal::Vector3& q : {copy.mesh.position(copy.mesh.target(copy.mesh.first(v))), p})
      {
        double largest = -1;
        energy = 0;
        holds = true;
        copy.mesh.for_each_around(v, [&](auto h) {
          const internal::Vector3 &a = copy.mesh.position(copy.mesh.target(h)), &b = copy.mesh.position(copy.mesh.apex(h));
          for(const double c : {internal::corner_cosine(q, a, b), internal::corner_cosine(a, b, q), internal::corner_cosine(b, q, a)})
          {
            energy += band.energy(c);
            largest = std::max(largest, c);
          }
          holds = holds && band.holds(q, a, b);
        });
        CHECK(std::abs(star.value(q) - energy) < 1e-12 && std::abs(star.largest_cosine() - largest) < 1e-12);
      }
      CHECK(holds == (energy == 0));
      star.value(p);
      const internal::Vector3 gradient = star.gradient();
      const double d = 1e-6;
      const auto quotient = [&](const internal::Vector3& u) {
        return (star.value(p + d * u) - star.value(p - d * u)) / (2 * d);
      };
      const internal::Vector3 quotients{quotient({1, 0, 0}), quotient({0, 1, 0}), quotient({0, 0, 1})};
      CHECK_MESSAGE(length(gradient - quotients) < 1e-5 * (1 + length(quotients)), length(gradient - quotients));
    }
  }
}

// A vertex pushed over its neighbor makes sharp edges where there was none, which say nothing about the sphere.
void a_fold_is_no_feature()
{
  Mesh m = meshes::to_mesh<Mesh>(meshes::sphere(4));
  const auto h = *m.halfedges().begin();
  m.point(m.source(h)) = m.point(m.target(h)) + .3 * (m.point(m.target(h)) - m.point(m.source(h)));
  const auto report = IAR::isotropic_remeshing(.06, m);
  CHECK_MESSAGE(report.features == Features::none, report.feature_edges);
  CHECK(report.crossing_faces == 0);
}

// A shaft with a bore across, of many facets: boolean operations leave fans of needles, whose sides are too long for a collapse and
// whose angles are too obtuse for a split.
void needles_of_boolean_operations_are_removed()
{
  const meshes::Soup shaft = meshes::turned({{1, -2}, {1, 2}}, 100, false);
  meshes::Soup bore = shaft.scaled(.75);
  for(auto& [x, y, z] : bore.points)
  {
    std::swap(x, z);
    x += .3;
    y += .0123;
    z += .01;
  }
  const Mesh part = models::difference(meshes::to_mesh<Mesh>(shaft), meshes::to_mesh<Mesh>(bore));
  const double mean = mean_edge_length(part);
  for(const double factor : {1., 1.2, 1.5, 1.8, 2.})
  {
    Mesh m = part;
    const auto report = IAR::isotropic_remeshing(factor * mean, m);
    const auto angles = IAR::inter_angle_statistics(m);
    CHECK_MESSAGE(report.features == Features::all_sharp_edges, factor);
    CHECK_MESSAGE(angles.minimum_angle > 30 && angles.maximum_angle < 110,
                  factor << ": " << angles.minimum_angle << ".." << angles.maximum_angle << " of " << m.number_of_faces());
    CHECK_MESSAGE(report.crossing_faces == 0, factor);
    if(meshes::is_small_run())
      break;
  }
}

// Thin faces along a border, folded back onto the surface, make sharp edges, too. The gutter is as round as before, and the result
// has nothing of them.
void folded_slivers_are_no_features()
{
  meshes::Soup gutter = meshes::square(24);
  for(auto& [x, y, z] : gutter.points)
  {
    z = std::sin(3 * x);
    x = std::cos(3 * x);
    y *= 3;
  }
  Mesh m = meshes::to_mesh<Mesh>(gutter);
  const std::vector<Halfedge> all(m.halfedges_begin(), m.halfedges_end());
  int slivers = 0;
  for(const Halfedge h : all)
  {
    if(!m.is_border(h))
      continue;
    ++slivers;
    // a vertex in the middle of the edge, which the face leads to, and the sliver between it and its ends
    const Halfedge inner = m.opposite(h);
    const Point a = m.point(m.source(inner)), b = m.point(m.target(inner)), c = m.point(m.target(m.next(inner)));
    const Point middle = CGAL::midpoint(a, b);
    const Halfedge made = CGAL::Euler::split_edge(inner, m);
    m.point(m.target(made)) = middle + .05 * (middle - c);
    CGAL::Euler::split_face(made, m.next(m.next(made)), m);
    CGAL::Euler::add_face_to_border(m.prev(h), m.opposite(made), m);
  }
  CHECK(slivers >= 20 && CGAL::is_valid_polygon_mesh(m) && CGAL::is_triangle_mesh(m));
  double steepest = 0;
  for(const Edge e : m.edges())
    if(!m.is_border(e))
      steepest = std::max(steepest, dihedral_angle(e, m));
  CHECK_MESSAGE(steepest > 170, steepest);
  CHECK_MESSAGE(found_features(m).empty(), found_features(m).size());
  const auto report = IAR::isotropic_remeshing(mean_edge_length(m), m);
  CHECK_MESSAGE(report.features == Features::none, report.feature_edges);
  const auto angles = IAR::inter_angle_statistics(m);
  CHECK_MESSAGE(angles.minimum_angle > 30 && angles.maximum_angle < 110, angles.minimum_angle << ".." << angles.maximum_angle);
}

// A coarse organic model has creases. They are no features at its own length, but where it is refined: cut off from both sides
// there, the sides run through each other.
void coarse_models_keep_their_creases()
{
  using Case = std::pair<const char*, std::size_t>;
  std::size_t runs = 0, crossing_runs = 0, out_with = 0, out_without = 0;
  double distance_with = 0, distance_without = 0;
  IAR::Recipe no_crests, ungraded;             // they would hold creases at thin parts, too
  no_crests.crest_width = 0;
  ungraded.grading = 0;
  for(const auto& [name, coarse] : {Case{"triceratops", 150}, {"triceratops", 200}, {"triceratops", 300}, {"dino", 200}, {"dino", 300},
                                    {"dino", 400}, {"elephant", 300}, {"elephant", 400}, {"camel", 300}, {"camel", 400}})
  {
    Mesh m = models::of_cgal(name);
    const std::size_t fine = 67 * coarse;
    // by a length, the same everywhere: what an input is must not depend on how numbers of faces are met, or limbs are graded
    const auto of_itself = IAR::isotropic_remeshing(faces(m), IAR::target_edge_length(faces(m), m, coarse), m, IAR::recipe(ungraded));
    m.collect_garbage();
    CHECK(of_itself.features == Features::none);
    CHECK_MESSAGE(found_features(m).empty(), name);
    if(does_self_intersect(m))           // one in some dozens does, and what is made of it is no wonder
      continue;

    Mesh with = m, without = m, smoothed = m;
    const auto report = IAR::isotropic_remeshing(IAR::Face_count(fine), with);
    CHECK_MESSAGE(found_features(m, IAR::target_edge_length(faces(m), m, fine)).size() == report.feature_edges, name);
    CHECK_MESSAGE(IAR::isotropic_remeshing(0., smoothed, parameters::number_of_iterations(1)).features == Features::none, name);
    CHECK_MESSAGE(report.features == Features::outstanding_edges && report.feature_edges > 20,
                  name << ": " << report.feature_edges);
    CHECK_MESSAGE(report.number_of_faces_out_of_band < 10, name << ": " << report.number_of_faces_out_of_band);
    const auto rounded = IAR::isotropic_remeshing(IAR::Face_count(fine), without,
                                                  IAR::recipe(no_crests, parameters::sharpness_angle(180)));
    distance_with += invariants::surface_distance(m, with).relative_mean();
    distance_without += invariants::surface_distance(m, without).relative_mean();
    ++runs;
    crossing_runs += does_self_intersect(with);
    out_with += report.number_of_faces_out_of_band;
    out_without += rounded.number_of_faces_out_of_band;
    CHECK_MESSAGE(rounded.are_crossing_faces_known || rounded.number_of_faces_out_of_band == 0, name);
    if(meshes::is_small_run())
      break;
  }
  CHECK_MESSAGE(crossing_runs <= 2 && (runs >= 8 || meshes::is_small_run()), crossing_runs << " of " << runs);
  // in the small run, a single one, there are none with features, and none without
  CHECK_MESSAGE(5 * out_with <= out_without && (out_without > 0 || meshes::is_small_run()), out_with << ", without " << out_without);
  // sums over ten runs, in diagonals: .0067; without features .0070, and .0076 when long edges were not all split first.
  CHECK_MESSAGE(distance_with < .0071 && distance_with < distance_without, distance_with << ", without " << distance_without);
}

// Creases of implicit surfaces by marching tetrahedra are jagged. Where corners of features lie so close together that no good face has
// room between them, features are given up; and no spur is left of a tiny way around.
void jagged_creases_leave_room_for_good_angles()
{
  const auto lattice = [](double x, double y, double z) {
    const auto from_axis = [](double a) { return std::abs(a - std::floor(a) - .5); };
    const double u = from_axis(x), v = from_axis(y), w = from_axis(z);
    return std::min({std::hypot(u, v), std::hypot(v, w), std::hypot(u, w)}) - .09;
  };
  const auto gyroid = [](double x, double y, double z) {
    return std::abs(std::sin(x) * std::cos(y) + std::sin(y) * std::cos(z) + std::sin(z) * std::cos(x)) - .35;
  };
  struct Case { Soup soup; double factor; };
  std::vector<Case> cases = {{meshes::marching_tetrahedra(-.1, 1.1, 20, lattice), 2}};
  if(!meshes::is_small_run())
  {
    cases.push_back({meshes::marching_tetrahedra(-.1, 2.1, 55, lattice), 1.5});
    cases.push_back({cases.back().soup, 2});
    cases.push_back({meshes::marching_tetrahedra(0, 6.3, 36, gyroid), 1});
  }
  for(const auto& [soup, factor] : cases)
  {
    const Mesh input = meshes::to_mesh<Mesh>(soup);
    CHECK(CGAL::is_closed(input) && CGAL::is_valid_polygon_mesh(input) && PMP::is_outward_oriented(input));
    Mesh m = input;
    const double length = factor * mean_edge_length(input);
    const auto report = IAR::isotropic_remeshing(length, m);
    m.collect_garbage();
    CHECK(report.features == Features::outstanding_edges && topology(m) == topology(input) && !does_self_intersect(m));
    CHECK_MESSAGE(report.angles_after.minimum > 15, report.angles_after.minimum);
    CHECK_MESSAGE(100 * report.number_of_faces_out_of_band < report.output_faces, report.number_of_faces_out_of_band);
    const double moved = invariants::surface_distance(input, m).hausdorff();
    CHECK_MESSAGE(moved < .6 * length, moved / length);
  }
}

// A lens of radius 1, or a ring from `inner` to 1 if that is positive, stretched along the x axis: round rims of this radius, between
// which it is thicker by the bulge on both sides.
Mesh lens(double inner, double rim, double bulge, double stretch = 1)
{
  constexpr int STEPS = 30, RIM_STEPS = 16;
  const auto height = [&](double t) { return rim + bulge * (inner > 0 ? 4 * t * (1 - t) : 1 - t * t); };
  const auto radius = [&](double t) { return inner + t * (1 - inner); };
  meshes::Profile bottom, top;
  for(int i = 1; i < STEPS; ++i)
  {
    const double t = double(i) / STEPS;
    bottom.push_back({radius(t), -height(t)});
    top.push_back({radius(1 - t), height(1 - t)});
  }
  meshes::Profile profile = meshes::joined(meshes::joined(bottom, meshes::arc(1, 0, rim, -.5, .5, RIM_STEPS)), top);
  if(inner > 0)
    profile = meshes::joined(profile, meshes::arc(inner, 0, rim, .5, 1.5, RIM_STEPS));
  Soup soup = meshes::turned(profile, 240, inner > 0);
  for(auto& p : soup.points)
    p[0] *= stretch;
  return meshes::to_mesh<Mesh>(soup);
}

// A mesh whose coordinates are rounded otherwise: each a unit in the last place more or less, or as it was.
Mesh rounded_otherwise(Mesh m, unsigned seed)
{
  std::mt19937 random(seed);
  const auto rounded = [&](double x)
  {
    const auto choice = random() % 3;
    return choice == 0 ? x : std::nextafter(x, choice == 1 ? x - 1 : x + 1);
  };
  for(const Vertex v : m.vertices())
  {
    const Point p = m.point(v);
    m.point(v) = Point(rounded(p.x()), rounded(p.y()), rounded(p.z()));
  }
  return m;
}

// The sharp rim of a thin plate is no feature where it is not marked in the map that is handed over. But it holds the outline, which had
// withdrawn by a target length, and still did so where right angles were a little less than that.
void rims_of_thin_plates_stay_unmarked()
{
  for(const double thickness : {.008, .0166})
  {
    const meshes::Profile profile = {{.33, -thickness / 2}, {.67, -thickness / 2}, {1, -thickness / 2},
                                     {1, thickness / 2}, {.67, thickness / 2}, {.33, thickness / 2}};
    const Mesh plate = meshes::to_mesh<Mesh>(meshes::turned(profile, 26, false));
    CHECK(CGAL::is_closed(plate) && CGAL::is_valid_polygon_mesh(plate));
    for(const double length : {.08, .1})
      for(const unsigned seed : {1u, 2u, 3u})
      {
        const Mesh input = rounded_otherwise(plate, seed);
        Mesh m = input;
        const Edge_map is_marked = m.add_property_map<Edge, bool>("e:marked", false).first;
        const auto report = IAR::isotropic_remeshing(faces(m), length, m, parameters::edge_is_constrained_map(is_marked));
        m.collect_garbage();
        CHECK(report.features == Features::none && topology(m) == topology(input) && !does_self_intersect(m));
        CHECK(std::none_of(m.edges().begin(), m.edges().end(), [&](Edge e) { return is_marked[e]; }));
        const double distance = invariants::surface_distance(input, m).hausdorff();
        CHECK_MESSAGE(distance < .7 * length, thickness << " at " << length << ", " << seed << ": " << distance / length);
      }
  }
}

// Over the rim of a lens the surface turns back within less than the target length. Edges that lead across would cut it off. What guides
// the iterations there is no feature: angles are as good as elsewhere, and nothing is marked.
void crests_guide_on_thin_bodies()
{
  struct Case { Mesh input; double length; };
  std::vector<Case> cases = {{lens(0, .02, .1), .16}};
  if(!meshes::is_small_run())
    cases.insert(cases.end(), {{lens(0, .02, .1), .08}, {lens(0, .015, 0), .1}, {lens(0, .02, .1, 1.7), .12},
                               {lens(.4, .02, .06), .12}, {lens(.6, .01, .03, 1.5), .06}});
  double largest_with = 0, largest_without = 0;                // sums, in target lengths
  for(const auto& [input, length] : cases)
  {
    Mesh with = input, without = input, marked = input;
    const auto report = IAR::isotropic_remeshing(length, with);
    IAR::Recipe recipe;
    recipe.crest_width = 0;
    IAR::isotropic_remeshing(length, without, IAR::recipe(recipe));
    with.collect_garbage();
    without.collect_garbage();
    CHECK(report.features == Features::none && report.feature_edges == 0);
    CHECK_MESSAGE(report.number_of_faces_out_of_band <= 2, length << ": " << report.number_of_faces_out_of_band);
    CHECK(topology(with) == topology(input) && !does_self_intersect(with));
    const auto near = invariants::surface_distance(input, with), far = invariants::surface_distance(input, without);
    CHECK_MESSAGE(near.hausdorff() < .6 * length, length << ": " << near.hausdorff() / length);
    CHECK_MESSAGE(near.mean() < .85 * far.mean(), length << ": " << near.mean() / far.mean());
    largest_with += near.hausdorff() / length;
    largest_without += far.hausdorff() / length;

    // Nor is one in an edge map that is handed over, whenever the run is cancelled; and vertices that are held stay so.
    Edge_map is_marked = marked.add_property_map<Edge, bool>("e:marked", false).first;
    std::map<Vertex, Point> held;
    for(const Vertex v : marked.vertices())
      if(v.idx() % 97 == 0)
        held[v] = marked.point(v);
    const auto is_held = CGAL::parameters::vertex_is_constrained_map(
      boost::make_function_property_map<Vertex>([&](Vertex v) { return held.count(v) != 0; }));
    for(const int calls : {20, 1000})
    {
      Mesh m = marked;
      is_marked = m.add_property_map<Edge, bool>("e:marked", false).first;   // the one that is there
      int left = calls;
      IAR::isotropic_remeshing(length, m, is_held.edge_is_constrained_map(is_marked).callback([&](double) { return --left > 0; }));
      for(const auto& [v, p] : held)
        CHECK(!m.is_removed(v) && m.point(v) == p);
      CHECK(std::none_of(m.edges_begin(), m.edges_end(), [&](Edge e) { return is_marked[e]; }));
      m.collect_garbage();
      CHECK(topology(m) == topology(input));
    }
  }
  CHECK_MESSAGE(largest_without > 1.5 * largest_with, largest_without / largest_with);
}

// A box, or a machine part, beside something that has grown: all in all no CAD model. Its edges, a few among thousands, are kept all the
// same, and its facets, however large they are, are not bent into a smooth surface.
void parts_keep_their_edges_beside_others()
{
  struct Case { const char *part, *other; double distance; };    // what becomes of the part alone, in target lengths, and some more
  std::vector<Case> cases = {{"tetrahedron", "elephant", 1e-6}};
  if(!meshes::is_small_run())
    cases.insert(cases.end(), {{"cube", "bear", 1e-6}, {"tetrahedron", "camel", 1e-6}, {"open_cube", "bunny00", 1e-6},
                               {"cube", "dino", 1e-6}, {"tripod", "elephant", .3}, {"anchor", "elephant", .2}});
  const auto of_size_one = [](Mesh m, double x)
  {
    const auto box = PMP::bbox(m);
    const double size = (std::max)({box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin()});
    for(const Vertex v : m.vertices())
    {
      const Point p = m.point(v);
      m.point(v) = Point(x + (p.x() - box.xmin()) / size, (p.y() - box.ymin()) / size, (p.z() - box.zmin()) / size);
    }
    return m;
  };
  for(const auto& [name, other, largest_distance] : cases)
  {
    const Mesh part = of_size_one(models::of_cgal(name), 2), rest = of_size_one(models::of_cgal(other), 0);
    for(const double length : {.02, .08})
    {
      Mesh m = rest;
      m += part;
      const auto of_part = found_features(part, length), of_rest = found_features(rest, length), together = found_features(m, length);
      // On a part with many edges the rules for what has grown may find some more.
      const std::size_t least = of_rest.size() + of_part.size();
      CHECK_MESSAGE(!of_part.empty() && together.size() >= least && together.size() <= least + of_part.size() / 100,
                    name << ", " << other << ": " << of_part.size() << " and " << of_rest.size() << ", " << together.size());
      const auto report = IAR::isotropic_remeshing(length, m);
      CHECK_MESSAGE(report.feature_edges == together.size() && report.features == Features::outstanding_edges, report.feature_edges);
      m.collect_garbage();
      for(const Face f : std::vector<Face>(m.faces_begin(), m.faces_end()))
        if(m.point(target(halfedge(f, m), m)).x() < 1.5)
          CGAL::Euler::remove_face(halfedge(f, m), m);
      m.collect_garbage();
      CHECK(topology(m) == topology(part) && !does_self_intersect(m));
      const double distance = invariants::surface_distance(part, m).hausdorff();
      CHECK_MESSAGE(distance < largest_distance * length, name << ", " << other << ": " << distance / length);
    }
  }
}

// What has grown and is as flat as a leaf has a rim that is a tangle of sharp edges: the features of a part would leave needles. Crests
// guide there instead.
void leaves_are_no_cad_models()
{
  struct Case { const char* name; double height; };
  std::vector<Case> cases = {{"elephant", .1}};
  if(!meshes::is_small_run())
    cases.insert(cases.end(), {{"homer", .05}, {"knot1", .05}, {"triceratops", .1}, {"elephant", .02}});
  for(const auto& [name, height] : cases)
  {
    Mesh input = models::of_cgal(name);
    for(const Vertex v : input.vertices())
      input.point(v) = Point(input.point(v).x(), input.point(v).y(), height * input.point(v).z());
    for(const double factor : {.5, 1., 2.})
    {
      Mesh m = input;
      const double length = factor * mean_edge_length(input);
      const auto report = IAR::isotropic_remeshing(length, m);
      m.collect_garbage();
      CHECK_MESSAGE(report.features != Features::all_sharp_edges, name);
      CHECK(topology(m) == topology(input));
      CHECK_MESSAGE(100 * report.crossing_faces < m.number_of_faces(), name << ": " << report.crossing_faces);
      const auto histogram = IAR::inter_angle_statistics(m).histogram;      // bins of 5 degrees
      const std::size_t needles = histogram[0] + histogram[1] + histogram[2];
      CHECK_MESSAGE(200 * needles < m.number_of_faces(), name << ": " << needles);
      CHECK_MESSAGE(factor * factor * m.number_of_faces() < 1.4 * input.number_of_faces(), name << ": " << m.number_of_faces());
      const double moved = invariants::surface_distance(input, m).mean();
      CHECK_MESSAGE(moved < .03 * length, name << ": " << moved / length);
    }
  }
}

// Between curves with many vertices, edges across are sides of needles, which obtuse angles would hold back from being split.
void dense_curves_leave_no_needles()
{
  meshes::Profile vase;
  for(int i = 0; i <= 200; ++i)
    vase.push_back({1 + .3 * std::sin(.03 * i), .02 * i});
  for(const std::size_t sides : {8, 6})
  {
    const Mesh input = meshes::to_mesh<Mesh>(meshes::turned(vase, sides, false));
    for(const double length : {.4, .55, .7})
    {
      Mesh m = input;
      const auto report = IAR::isotropic_remeshing(length, m);
      m.collect_garbage();
      CHECK(report.features == Features::all_sharp_edges && topology(m) == topology(input) && !does_self_intersect(m));
      CHECK_MESSAGE(report.angles_after.minimum > 25, sides << ", " << length << ": " << report.angles_after.minimum);
      const double wanted = PMP::area(input) / (std::sqrt(3.) / 4 * length * length);
      CHECK_MESSAGE(double(report.output_faces) < 2.5 * wanted, report.output_faces << " for " << wanted);
      CHECK(invariants::surface_distance(input, m).hausdorff() < .25 * length);
      if(meshes::is_small_run())
        break;
    }
  }
}

// Sides of prisms that are a little narrower than the target length, with rows of vertices at the same heights, have no vertices in their
// middles, which needles would surround.
void sides_of_prisms_have_no_vertices_in_their_middles()
{
  for(const std::size_t sides : {4, 6})
    for(const auto& [spacing, length] : {std::make_pair(1.5, 1.2), std::make_pair(2.5, 1.05), std::make_pair(2.5, 1.2)})
    {
      const double radius = .5 / std::sin(CGAL_PI / double(sides));     // of sides of width 1
      meshes::Profile profile;
      for(int ring = 0; ring <= 40; ++ring)
        profile.push_back({radius, spacing * ring});
      const Mesh prism = meshes::to_mesh<Mesh>(meshes::turned(profile, sides, false));
      Mesh m = prism;
      const auto report = IAR::isotropic_remeshing(length, m);
      CHECK(topology(m) == topology(prism) && std::abs(PMP::area(m) / PMP::area(prism) - 1) < 1e-6);
      CHECK_MESSAGE(report.angles_after.minimum > 28, sides << ", " << spacing << ", " << length << ": " << report.angles_after.minimum);
    }
}

int main()
{
  coarser_runs_find_no_more();
  rings_of_a_few_edges_are_no_features();
  places_on_curves_are_found();
  the_energy_of_angles_has_its_gradient();
  cad_models_have_all_their_sharp_edges();
  faces_without_an_area_hide_no_edge();
  two_faces_without_an_area_hide_no_edge();
  doubled_points_on_features_are_merged();
  without_a_length_features_are_those_of_the_mesh();
  cylinders_of_few_facets_are_cad_models();
  of_two_sides_of_a_narrow_strip_one_is_a_feature();
  of_a_low_step_the_ridge_is_a_feature();
  rims_at_faces_without_an_area_are_no_grooves();
  narrow_strips_have_few_needles();
  rings_of_few_sides_have_no_flat_faces();
  a_plate_with_a_groove_stays_a_plate();
  slender_bars_keep_their_edges();
  flat_ends_are_no_strips();
  the_sides_of_a_staircase_stay();
  the_sides_of_a_staircase_stay_beside_longer_edges();
  thin_plates_keep_both_edges_of_their_rims();
  creases_close_to_the_border_are_no_features();
  parts_keep_their_edges_in_any_company();
  organic_models_have_next_to_none();
  rims_of_cuts_are_features();
  rims_of_drilled_holes_are_features();
  ends_of_thin_hoses_stay_flat();
  a_fold_is_no_feature();
  folded_slivers_are_no_features();
  coarse_models_keep_their_creases();
  needles_of_boolean_operations_are_removed();
  noise_hides_no_edge_and_makes_none();
  the_roughest_noise_is_no_feature();
  the_tips_of_noise_do_not_stay();
  rugged_ground_keeps_its_shape();
  creases_with_short_edges_are_coarsened();
  the_roughest_surface_can_be_coarsened();
  the_roughest_surface_gets_the_wanted_number_of_faces();
  what_noise_makes_cross_is_parted();
  knurled_plates_keep_their_pyramids();
  a_range_and_other_types_will_do();
  cad_models_keep_their_features();
  features_cost_nothing_but_angles();
  what_is_marked_rules();
  curves_stay_on_their_polylines();
  sliding_can_be_turned_off();
  vertices_of_found_features_stay_where_asked_for();
  found_features_are_collapsed_in_any_case();
  borders_of_patches_stay_on_their_polylines();
  corners_stay();
  rims_stay_closed_and_become_round();
  projectors_keep_to_their_patches();
  projectors_keep_to_the_range();
  an_mls_projector_of_the_whole_serves_a_range();
  features_of_a_range_are_those_of_the_mesh();
  few_faces_keep_a_rim();
  what_lies_outside_need_not_be_fit();
  a_part_keeps_its_features_beside_what_is_none();
  curves_may_end_meet_and_run_side_by_side();
  a_cusp_of_the_border_stays();
  small_holes_and_thin_walls_survive();
  steps_are_no_corners();
  borders_have_good_angles();
  acute_corners_spoil_one_face();
  slits_are_no_features();
  grading_mends_small_details();
  tiny_chamfers_are_merged();
  close_corners_of_unions_are_merged();
  curves_that_would_touch_stay_apart();
  thin_plates_do_not_become_flat();
  blunt_edges_of_wedges_become_sharp();
  plates_and_bars_have_good_angles_at_long_targets();
  merging_makes_nothing_cross();
  attributes_of_merged_chamfers_are_found();
  chamfers_stay_where_the_user_says_so();
  fillets_narrower_than_the_target_are_features();
  a_relief_too_fine_for_the_target_is_no_feature();
  piles_of_bars_keep_their_edges();
  knife_edges_are_features();
  stairs_of_voxels_are_no_features();
  small_ranges_on_stairs_have_no_features();
  stairs_of_thin_vessels_are_no_features();
  turned_stairs_are_no_features();
  simplified_stairs_are_no_features();
  what_resembles_stairs_keeps_its_edges();
  zigzags_by_design_are_features();
  one_rim_of_a_jagged_chamfer_is_a_feature();
  jagged_creases_leave_room_for_good_angles();
  leaves_are_no_cad_models();
  crests_guide_on_thin_bodies();
  rims_of_thin_plates_stay_unmarked();
  parts_keep_their_edges_beside_others();
  grading_mends_jagged_borders();
  grading_mends_round_holes();
  jagged_seams_are_followed_at_the_scale_of_the_target();
  jagged_borders_are_followed_at_the_scale_of_the_target();
  dense_curves_leave_no_needles();
  sides_of_prisms_have_no_vertices_in_their_middles();
  round_rims_are_coarsened();
  coarse_results_are_still_cad_models();
  simplified_parts_are_cad_models();
  simplified_plants_are_no_thicker();
  a_count_is_met_in_spite_of_grading();
  ranges_beside_long_facets_cross_nothing();
  return result();
}
