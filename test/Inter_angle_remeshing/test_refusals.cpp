// Copyright (c) 2026 The Inter_angle_remeshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What is refused, and in which words; what a run tells about itself, and how it is stopped; and the projector alone.

#include <CGAL/Inter_angle_remeshing/Projection/Closest_point_projector.h>
#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>
#include <CGAL/Inter_angle_remeshing/target_edge_length.h>
#include <CGAL/Inter_angle_remeshing/triangle_quality.h>

#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include "check.h"
#include "meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <memory>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace IAR = CGAL::Inter_angle_remeshing;
namespace parameters = CGAL::parameters;
using namespace meshes;

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Report = IAR::Remeshing_report;
using Projector = IAR::Closest_point_projector<Mesh>;

constexpr double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();
constexpr double INFINITE = std::numeric_limits<double>::infinity();

double distance(const Point& p, const Point& q) { return std::sqrt(CGAL::squared_distance(p, q)); }

// --- refusals ----------------------------------------------------------------------------------------------------

void refusals_hold_in_release_builds()
{
#ifdef NDEBUG
  const bool is_release = true;
#else
  const bool is_release = false;
#endif
  CHECK_MESSAGE(is_release || is_small_run(), "build this test with NDEBUG: CGAL's own checks must be off");
}

template <class Value>
std::string to_text(const Value& value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}

// `call(mesh)` is refused with a message that contains `text`, and the mesh stays as it was.
template <class Graph, class Call>
void check_refused(Graph& g, const std::string& text, const Call& call)
{
  const Picture<Graph> before(g);
  CHECK_THROWS_AS(call(g), CGAL::Precondition_exception, text);
  CHECK_MESSAGE(Picture<Graph>(g) == before, text);
}

template <class Call>
void check_refused(const std::string& text, const Call& call)
{
  Mesh m = to_mesh<Mesh>(sphere(1));
  check_refused(m, text, call);
}

// The square with its first two triangles made into one quadrangle.
template <class Graph>
Graph square_with_a_quadrangle()
{
  Graph g = to_mesh<Graph>(square(4));
  for(const auto h : halfedges(g))
    if(!CGAL::is_border_edge(h, g))
    {
      CGAL::Euler::join_face(h, g);
      return g;
    }
  return g;
}

template <class Graph>
bool is_triangle(typename boost::graph_traits<Graph>::face_descriptor f, const Graph& g)
{
  return CGAL::is_triangle(halfedge(f, g), g);
}

template <class Graph>
void faces_that_are_no_triangles_are_refused()
{
  Graph g = square_with_a_quadrangle<Graph>();
  check_refused(g, "is not a triangle", [](Graph& m) { IAR::isotropic_remeshing(.1, m); });
  check_refused(g, "triangulate_faces", [](Graph& m) { IAR::isotropic_remeshing(IAR::Face_count(100), m); });
  check_refused(g, "is not a triangle", [](Graph& m) { IAR::target_edge_length(faces(m), m, 100); });
  check_refused(g, "is not a triangle", [](Graph& m) { IAR::Closest_point_projector<Graph> projector(m); });

  // ... in the range. Elsewhere, they are left alone
  std::vector<typename boost::graph_traits<Graph>::face_descriptor> range, others;
  for(const auto f : faces(g))
    (is_triangle(f, g) ? range : others).push_back(f);
  CHECK(others.size() == 1);
  // a face is named by its place in the range, whatever the range lists twice before
  const std::vector<typename boost::graph_traits<Graph>::face_descriptor> repeated{range[0], range[0], range[1], others[0]};
  check_refused(g, "face number 3 of the range is not a triangle", [&](Graph& m) { IAR::isotropic_remeshing(repeated, .1, m); });
  IAR::isotropic_remeshing(range, .1, g);
  CHECK(CGAL::is_valid_polygon_mesh(g));
  CHECK(CGAL::halfedges_around_face(halfedge(others[0], g), g).size() == 4);
}

void coordinates_that_are_not_finite_are_refused()
{
  for(const double bad : {NOT_A_NUMBER, INFINITE, -INFINITE})
    for(int axis = 0; axis < 3; ++axis)
    {
      Mesh m = to_mesh<Mesh>(sphere(1));
      std::array<double, 3> p = {1, 2, 3};
      p[axis] = bad;
      m.point(Mesh::Vertex_index(5)) = Point(p[0], p[1], p[2]);
      check_refused(m, "a corner of face number ", [](Mesh& g) { IAR::isotropic_remeshing(.1, g); });
      check_refused(m, "not finite", [](Mesh& g) { IAR::target_edge_length(faces(g), g, 100); });
      check_refused(m, "not finite", [](Mesh& g) { Projector projector(g); });
    }
  // finite, but too far apart for a difference
  Mesh wide = to_mesh<Mesh>(sphere(1).scaled(1.7e308));
  check_refused(wide, "too large", [](Mesh& g) { IAR::isotropic_remeshing(1e307, g); });
  check_refused(wide, "too large", [](Mesh& g) { Projector projector(g); });
}

void a_range_that_is_one_point_is_refused()
{
  Mesh m = to_mesh<Mesh>(sphere(1).scaled(0).moved(1, 2, 3));
  check_refused(m, "all points of the range are equal", [](Mesh& g) { IAR::isotropic_remeshing(.1, g); });
  check_refused(m, "all points of the range are equal", [](Mesh& g) { IAR::target_edge_length(faces(g), g, 100); });
  check_refused(m, "all points of the range are equal", [](Mesh& g) { Projector projector(g); });
}

void lengths_that_are_none_are_refused()
{
  check_refused("target edge length", [](Mesh& g) { IAR::isotropic_remeshing(-1., g); });
  check_refused("target edge length is -1", [](Mesh& g) { IAR::isotropic_remeshing(-1, g); });
  check_refused("target edge length is -1e-300", [](Mesh& g) { IAR::isotropic_remeshing(-1e-300, g); });
  check_refused("must be finite", [](Mesh& g) { IAR::isotropic_remeshing(NOT_A_NUMBER, g); });
  check_refused("must be finite", [](Mesh& g) { IAR::isotropic_remeshing(INFINITE, g); });
  check_refused("must be finite", [](Mesh& g) { IAR::isotropic_remeshing(-INFINITE, g); });
  check_refused("must be finite", [](Mesh& g) { IAR::isotropic_remeshing(std::numeric_limits<float>::infinity(), g); });
}

void lengths_that_make_too_many_faces_are_refused()
{
  // The sphere's area is less than 4 pi, so of equilateral triangles of area sqrt(3) / 4 l^2 about 29 / l^2 are needed,
  // which is 2.9e9 for 1e-4 and 2.9e8 for 3.2e-4; 3.6e8 can be had.
  for(const double length : {1e-4, 1e-9, 1e-100, 1e-200, 1e-320})
    check_refused("target edge length is " + to_text(length) + ", so small", [&](Mesh& g) { IAR::isotropic_remeshing(length, g); });
  check_refused("the wanted number of faces is 1e+12", [&](Mesh& g) { IAR::isotropic_remeshing(IAR::Face_count(1000000000000), g); });
  // at another scale, where the length is no small number
  Mesh large = to_mesh<Mesh>(sphere(1).scaled(1e12));
  check_refused(large, "so small", [&](Mesh& g) { IAR::isotropic_remeshing(1., g); });
  check_refused(large, "so small", [&](Mesh& g) { IAR::isotropic_remeshing(std::numeric_limits<double>::denorm_min(), g); });
  // and one that is finite in the user's units, but not in those of a tiny mesh
  Mesh tiny = to_mesh<Mesh>(sphere(2).scaled(1e-20)), as_large = tiny;
  IAR::isotropic_remeshing(1e300, tiny);
  IAR::isotropic_remeshing(1., as_large);
  CHECK(CGAL::is_valid_polygon_mesh(tiny) && Picture<Mesh>(tiny) == Picture<Mesh>(as_large));
  // a needle has hardly an area, but edges that would be split a thousand million times
  Mesh needle = to_mesh<Mesh>(Soup{{{{0, 0, 0}}, {{1, 0, 0}}, {{1, 1e-12, 0}}}, {{{0, 1, 2}}}});
  check_refused(needle, "so small", [&](Mesh& g) { IAR::isotropic_remeshing(1e-9, g); });
  // So far from the origin coordinates are .125 apart, and the ends of such an edge are the same point as often as not.
  Mesh far = to_mesh<Mesh>(sphere(2).moved(1e15, 0, 0));
  check_refused(far, "double precision", [](Mesh& g) { IAR::isotropic_remeshing(.3, g); });
  check_refused(far, "double precision", [](Mesh& g) { IAR::isotropic_remeshing(IAR::Face_count(1000), g); });
  Mesh nearer = to_mesh<Mesh>(sphere(2).moved(1e13, 0, 0));
  IAR::isotropic_remeshing(.3, nearer);
  CHECK(CGAL::is_valid_polygon_mesh(nearer));
}

void no_faces_are_refused_as_a_wish()
{
  check_refused("the wanted number of faces is 0", [](Mesh& g) { IAR::isotropic_remeshing(IAR::Face_count(0), g); });
  check_refused("the wanted number of faces is 0", [](Mesh& g) { IAR::target_edge_length(faces(g), g, 0); });
  check_refused("the wanted number of faces is 1e+18", [](Mesh& g) { IAR::isotropic_remeshing(IAR::Face_count(1e18), g); });
  {
    Mesh flat;
    flat.add_face(flat.add_vertex(Point(0, 0, 0)), flat.add_vertex(Point(1, 0, 0)), flat.add_vertex(Point(3, 0, 0)));
    CHECK_THROWS_WITH_TEXT(IAR::isotropic_remeshing(IAR::Face_count(100), flat), CGAL::Precondition_exception, "without an area");
    CHECK(flat.number_of_faces() == 1);
  }
}

void parameters_out_of_their_range_are_refused()
{
  const auto check = [](const std::string& text, const auto& np)
  {
    check_refused(text, [&](Mesh& g) { IAR::isotropic_remeshing(.3, g, np); });
  };
  for(const double angle : {-1., -1e-9, 180.001, 1000., NOT_A_NUMBER, INFINITE})
    check("sharpness_angle is " + to_text(angle), parameters::sharpness_angle(angle));
  check("number_of_iterations is -1", parameters::number_of_iterations(-1));
  check("number_of_iterations is nan", parameters::number_of_iterations(NOT_A_NUMBER));
  check("number_of_relaxation_steps is inf", parameters::number_of_relaxation_steps(INFINITE));
  check("number_of_relaxation_steps is -2", parameters::number_of_relaxation_steps(-2));

  // at the ends of the ranges nothing is refused
  Mesh m = to_mesh<Mesh>(sphere(1));
  CHECK(IAR::isotropic_remeshing(.3, m, parameters::sharpness_angle(180)).ending == Report::Ending::completed);
  CHECK(IAR::isotropic_remeshing(.3, m, parameters::sharpness_angle(0.)).ending == Report::Ending::completed);
  CHECK(IAR::isotropic_remeshing(.3, m, parameters::relax_constraints(false)).ending == Report::Ending::completed);
}

void counts_that_do_not_fit_are_refused()
{
  // 2^32 is 0 as an unsigned int
  const auto np = parameters::number_of_iterations(1ll << 32);
  check_refused("number_of_iterations", [&](Mesh& g) { IAR::isotropic_remeshing(.3, g, np); });
}

// Bad values of a member are refused by a message with this text and the value, good ones are not.
template <class T>
void check_range_of(const std::string& text, T IAR::Recipe::*member, const std::vector<T>& bad, const std::vector<T>& good)
{
  IAR::Recipe r;
  for(const T value : bad)
  {
    r.*member = value;
    check_refused(text, [&](Mesh& g) { IAR::isotropic_remeshing(.4, g, IAR::recipe(r)); });
    check_refused(to_text(value), [&](Mesh& g) { IAR::isotropic_remeshing(.4, g, IAR::recipe(r)); });
  }
  for(const T value : good)
  {
    r.*member = value;
    Mesh m = to_mesh<Mesh>(sphere(1));
    const Report report = IAR::isotropic_remeshing(.4, m, IAR::recipe(r, parameters::number_of_iterations(1)));
    CHECK_MESSAGE(report.ending == Report::Ending::completed, text << " " << value);
  }
}

void recipes_out_of_range_are_refused()
{
  using Recipe = IAR::Recipe;
  check_range_of("relaxation", &Recipe::relaxation, {0., -1., 1.601, 2., NOT_A_NUMBER, INFINITE}, {1e-9, 1., 1.6});
  check_range_of("split_ratio", &Recipe::split_ratio, {1., 0., -1., 2.01, NOT_A_NUMBER, INFINITE}, {2.});
  check_range_of("collapse_ratio", &Recipe::collapse_ratio, {-.1, 1., 2., NOT_A_NUMBER}, {0., .99});
  // together: a new edge must not be too short again
  Recipe narrow;
  narrow.split_ratio = 1.05;
  narrow.collapse_ratio = .9;
  check_refused("collapse_ratio", [&](Mesh& g) { IAR::isotropic_remeshing(.4, g, IAR::recipe(narrow)); });
  check_range_of("glide_depth", &Recipe::glide_depth, {17u, 1000000u}, {16u, 0u});
  check_range_of("Recipe::fits", &Recipe::fits, {101u, 4294967295u}, {0u, 100u});
  check_range_of("collapse_tolerance", &Recipe::collapse_tolerance, {-.1, NOT_A_NUMBER}, {0.});
  check_range_of("grading", &Recipe::grading, {-.1, NOT_A_NUMBER}, {0.});
  check_range_of("fit_tangential_weight", &Recipe::fit_tangential_weight, {0., -.1, 1.01, NOT_A_NUMBER, INFINITE}, {1e-9, 1.});
  check_range_of("fillet_width", &Recipe::fillet_width, {-.01, 1.01, NOT_A_NUMBER}, {0., 1.});
  check_range_of("crest_width", &Recipe::crest_width, {-.01, 2.01, NOT_A_NUMBER}, {0., 2.});
  check_range_of("relief_density", &Recipe::relief_density, {-1., NOT_A_NUMBER}, {0., 1., INFINITE});
  check_range_of("merging_distance", &Recipe::merging_distance, {-.01, .11, NOT_A_NUMBER}, {0., .1});
  check_range_of("distance_tolerance", &Recipe::distance_tolerance, {-.1, NOT_A_NUMBER}, {0.});
  check_range_of("Recipe::lower_angle", &Recipe::lower_angle, {-1., 60., 61., NOT_A_NUMBER}, {0.});
  check_range_of("Recipe::upper_angle", &Recipe::upper_angle, {59., 60., 181., NOT_A_NUMBER}, {180.});
}

// A cone with `n` faces.
Soup cone(std::size_t n)
{
  Soup soup{{{0, 0, 1}}, {}};
  for(std::size_t i = 0; i < n; ++i)
  {
    const double angle = 2 * CGAL_PI * double(i) / double(n);
    soup.points.push_back({std::cos(angle), std::sin(angle), 0});
    soup.faces.push_back({0, 1 + i, 1 + (i + 1) % n});
  }
  return soup;
}

void vertices_with_too_many_faces_are_refused()
{
  Mesh too_many = to_mesh<Mesh>(cone(16384));
  check_refused(too_many, "16384 faces", [](Mesh& g) { IAR::isotropic_remeshing(.1, g); });
  Mesh many = to_mesh<Mesh>(cone(16383));
  IAR::Recipe recipe;
  if(is_small_run())
    recipe.distance_tolerance = 0;     // walks around the tip take minutes under the sanitizers
  IAR::isotropic_remeshing(.3, many, IAR::recipe(recipe, parameters::number_of_iterations(1)));
  CHECK(CGAL::is_valid_polygon_mesh(many));
}

// A cone of one face, two edges of which are one.
// Of another mesh, removed, or none at all.
template <class Graph>
void faces_of_no_mesh_are_refused()
{
  const Graph larger = to_mesh<Graph>(sphere(3));
  Graph g = to_mesh<Graph>(sphere(1));
  check_refused(g, "none of the mesh's", [&](Graph& m) { IAR::isotropic_remeshing(faces(larger), .1, m); });
  check_refused(g, "none of the mesh's", [&](Graph& m) {
    auto range = std::vector(faces(m).begin(), faces(m).end());
    range.back() = *std::prev(faces(larger).end());
    IAR::isotropic_remeshing(range, IAR::Face_count(10), m);
  });
  check_refused(g, "none of the mesh's", [&](Graph& m) {
    IAR::isotropic_remeshing(std::vector{*faces(m).begin(), boost::graph_traits<Graph>::null_face()}, .1, m);
  });
}

void removed_faces_are_refused()
{
  Mesh m = to_mesh<Mesh>(sphere(2));
  const std::vector<Mesh::Face_index> stale(faces(m).begin(), faces(m).end());
  IAR::isotropic_remeshing(stale, 1., m);
  check_refused(m, "or was removed", [&](Mesh& g) { IAR::isotropic_remeshing(stale, .1, g); });
}

void faces_glued_to_themselves_are_refused()
{
  Mesh m;
  const Mesh::Vertex_index tip = m.add_vertex(Point(0, 0, 1)), foot = m.add_vertex(Point(1, 0, 0));
  const Mesh::Halfedge_index side = m.add_edge(foot, tip), rim = halfedge(CGAL::add_edge(m), m);
  m.set_target(rim, foot);
  m.set_target(m.opposite(rim), foot);
  const Mesh::Face_index f = m.add_face();
  const std::array<Mesh::Halfedge_index, 3> around = {side, m.opposite(side), rim};
  for(int k = 0; k < 3; ++k)
  {
    m.set_next(around[k], around[(k + 1) % 3]);
    m.set_face(around[k], f);
  }
  m.set_next(m.opposite(rim), m.opposite(rim));
  m.set_halfedge(f, side);
  m.set_halfedge(tip, side);
  m.set_halfedge(foot, m.opposite(side));
  CHECK(m.is_valid() && !CGAL::is_valid_polygon_mesh(m));
  check_refused(m, "two edges of face number 0 of the range are one", [](Mesh& g) { IAR::isotropic_remeshing(.1, g); });
}

// Triangles whose sides are named: as many edges between two vertices as have names.
struct Named_triangle
{
  std::array<std::size_t, 3> corners;
  std::array<std::size_t, 3> sides;  // from corner k to corner k + 1
};

Mesh to_mesh(const std::vector<std::array<double, 3>>& points, const std::vector<Named_triangle>& triangles)
{
  Mesh m;
  for(const auto& p : points)
    m.add_vertex(Point(p[0], p[1], p[2]));
  std::map<std::size_t, Mesh::Halfedge_index> free_side;
  for(const Named_triangle& t : triangles)
  {
    const Mesh::Face_index f = m.add_face();
    std::array<Mesh::Halfedge_index, 3> h;
    for(int k = 0; k < 3; ++k)
    {
      const auto known = free_side.find(t.sides[k]);
      h[k] = known == free_side.end() ? m.halfedge(CGAL::add_edge(m)) : known->second;
      free_side[t.sides[k]] = m.opposite(h[k]);
    }
    for(int k = 0; k < 3; ++k)
    {
      const Mesh::Vertex_index target(unsigned(t.corners[(k + 1) % 3]));
      m.set_target(h[k], target);
      m.set_halfedge(target, h[k]);
      m.set_next(h[k], h[(k + 1) % 3]);
      m.set_face(h[k], f);
    }
    m.set_halfedge(f, h[0]);
  }
  return m;
}

// A sphere on whose equator two edges, 0 and 1, join the vertices 0 and 1; two more vertices above, and two below.
Mesh sphere_with_a_doubled_edge()
{
  const Mesh m = to_mesh({{-1, 0, 0}, {1, 0, 0}, {0, .6, .6}, {0, -.6, .6}, {0, .6, -.6}, {0, -.6, -.6}},
                         {{{0, 1, 2}, {0, 2, 3}}, {{1, 0, 3}, {1, 4, 5}}, {{1, 3, 2}, {5, 6, 2}}, {{0, 2, 3}, {3, 6, 4}},
                          {{1, 0, 4}, {0, 7, 8}}, {{0, 1, 5}, {1, 9, 10}}, {{0, 5, 4}, {10, 11, 7}},
                          {{1, 4, 5}, {8, 11, 9}}});
  CHECK(CGAL::is_valid_polygon_mesh(m) && CGAL::is_closed(m) && m.number_of_edges() == 12);
  return m;
}

void doubled_edges_are_refused_only_where_they_are_protected()
{
  Mesh m = sphere_with_a_doubled_edge();
  auto marks = m.add_property_map<Mesh::Edge_index, bool>("e:mark", false).first;
  std::size_t doubled = 0;
  for(const auto e : m.edges())
    if(std::max(m.vertex(e, 0), m.vertex(e, 1)) == Mesh::Vertex_index(1))
    {
      marks[e] = true;
      ++doubled;
    }
  CHECK(doubled == 2);
  check_refused(m, "join the same two vertices", [&](Mesh& g) {
    IAR::isotropic_remeshing(.5, g, parameters::edge_is_constrained_map(marks).protect_constraints(true));
  });
  const Report report = IAR::isotropic_remeshing(.3, m);
  CHECK(report.ending == Report::Ending::completed);
  CHECK(CGAL::is_valid_polygon_mesh(m) && CGAL::is_closed(m));
}

void an_empty_range_is_nothing_to_do()
{
  Mesh m = to_mesh<Mesh>(sphere(1));
  const Picture<Mesh> before(m);
  const std::vector<Mesh::Face_index> none;
  const auto check = [&](const Report& report)
  {
    CHECK(report.ending == Report::Ending::nothing_to_do);
    CHECK(report.iterations == 0 && report.splits == 0 && report.input_faces == 0);
    CHECK(Picture<Mesh>(m) == before);
  };
  check(IAR::isotropic_remeshing(none, .1, m));
  check(IAR::isotropic_remeshing(none, IAR::Face_count(100), m));
  CHECK_THROWS_WITH_TEXT(IAR::isotropic_remeshing(none, -.1, m), CGAL::Precondition_exception, "not negative");
  CHECK_THROWS_WITH_TEXT(IAR::isotropic_remeshing(none, IAR::Face_count(0), m), CGAL::Precondition_exception, "faces is 0");
  Mesh empty;
  CHECK(IAR::isotropic_remeshing(.1, empty).ending == Report::Ending::nothing_to_do);
  CHECK(empty.is_empty());
}

// A round without a flip or a glide is the last one of its iteration.
void rounds_of_flips_end_when_nothing_is_left_to_flip()
{
  Mesh m = to_mesh<Mesh>(sphere(2)), other = m;
  IAR::Recipe recipe;
  recipe.flip_rounds = 100;
  IAR::isotropic_remeshing(.2, m, IAR::recipe(recipe));
  recipe.flip_rounds = (std::numeric_limits<unsigned>::max)();
  IAR::isotropic_remeshing(.2, other, IAR::recipe(recipe));
  CHECK(Picture<Mesh>(m) == Picture<Mesh>(other));
}

void no_iteration_is_nothing_to_do()
{
  Mesh m = to_mesh<Mesh>(sphere(1));
  const Picture<Mesh> before(m);
  std::vector<double> told;
  const Report report = IAR::isotropic_remeshing(.1, m, parameters::number_of_iterations(0).callback([&](double progress) {
    told.push_back(progress);
    return true;
  }));
  CHECK(told == std::vector<double>{1});
  CHECK(report.ending == Report::Ending::nothing_to_do && report.iterations == 0);
  CHECK(report.input_faces == m.number_of_faces() && report.output_faces == m.number_of_faces());
  CHECK(report.target_edge_length == .1 && report.angles_after.minimum > 40);
  CHECK(Picture<Mesh>(m) == before);
}

void a_projection_that_is_not_finite_ends_the_run()
{
  for(const double bad : {NOT_A_NUMBER, INFINITE})
  {
    Mesh m = to_mesh<Mesh>(sphere(2));
    const Picture<Mesh> before(m);
    int calls = 0;
    const auto fails_later = [&](const Point& p) { return ++calls == 100 ? Point(bad, 0, 0) : p; };
    CHECK_THROWS_AS(IAR::isotropic_remeshing(.2, m, parameters::projection_functor(std::cref(fails_later))),
                    CGAL::Postcondition_exception, "not finite");
    CHECK(Picture<Mesh>(m) == before);
  }
  // nor does one go on whose products would not be finite
  Mesh m = to_mesh<Mesh>(sphere(2));
  const Picture<Mesh> before(m);
  const auto far_away = [](const Point& p) { return Point(std::copysign(1e200, p.x()), p.y(), p.z()); };
  CHECK_THROWS_AS(IAR::isotropic_remeshing(.2, m, parameters::projection_functor(far_away)), CGAL::Postcondition_exception,
                  "far away");
  CHECK(Picture<Mesh>(m) == before);
}

// --- how a run goes on -------------------------------------------------------------------------------------------

void progress_rises_from_0_to_1()
{
  for(const bool is_paper : {false, true})
  {
    Mesh m = to_mesh<Mesh>(sphere(2));
    std::vector<double> progress;
    IAR::isotropic_remeshing(.2, m, IAR::recipe(is_paper ? IAR::Recipe::paper() : IAR::Recipe(),
      parameters::number_of_iterations(4).callback([&](double done) { progress.push_back(done); return true; })));
    CHECK(progress.size() >= 4 * 3);
    CHECK(std::is_sorted(progress.begin(), progress.end()));
    CHECK(progress.front() > 0 && progress.front() < .1);
    CHECK(progress.back() == 1 && std::count(progress.begin(), progress.end(), 1.) == 1);
    // six passes of the clean-up, and what it takes of the time beside four iterations
    if(!is_paper)
      CHECK_MESSAGE(std::count_if(progress.begin(), progress.end(), [](double p) { return p > 4 / (4 + .8 * 4); }) >= 6,
                    progress.size());
  }
  // a clean-up that is gone through again, as it misses the wanted number of faces
  Mesh m = to_mesh<Mesh>(sphere(4));
  std::vector<double> progress;
  IAR::isotropic_remeshing(IAR::Face_count(12), m,
    parameters::callback([&](double done) { progress.push_back(done); return true; }));
  CHECK(std::is_sorted(progress.begin(), progress.end()));
  CHECK(progress.back() == 1 && std::count(progress.begin(), progress.end(), 1.) == 1);
}

template <class Graph>
void a_run_can_be_cancelled_after_each_pass()
{
  const Graph input = to_mesh<Graph>(sphere(2));
  std::size_t last = 0;
  IAR::isotropic_remeshing(.2, *std::make_unique<Graph>(input),
                           parameters::number_of_iterations(3).callback([&](double) { ++last; return true; }));
  CHECK(last > 10);
  for(std::size_t k = 1; k <= last; k += k < 12 ? 1 : 3)
  {
    Graph g = input;
    std::size_t calls = 0;
    const Report report = IAR::isotropic_remeshing(.2, g, parameters::number_of_iterations(3)
                                                            .callback([&](double) { return ++calls != k; }));
    CHECK_MESSAGE(report.ending == Report::Ending::cancelled, "call " << k);
    CHECK_MESSAGE(calls == k, "called " << calls << " times, cancelled at call " << k);
    CHECK(CGAL::is_valid_polygon_mesh(g) && CGAL::is_closed(g));
    CHECK(report.output_faces == faces(g).size());
    // the first pass splits edges; before the finest level nothing of that is in the mesh
    CHECK(report.splits > 0 || report.output_faces == report.input_faces);
    CHECK(report.iterations <= 3);
  }
}

void pass_names_are_distinct()
{
  const std::set<IAR::Pass> passes = {IAR::Pass::split, IAR::Pass::collapse, IAR::Pass::flip, IAR::Pass::glide,
                                      IAR::Pass::relax, IAR::Pass::clean_up, IAR::Pass::fit, IAR::Pass::polish,
                                      IAR::Pass::distance, IAR::Pass::repair, IAR::Pass::subdivide, IAR::Pass::mend};
  CHECK(passes.size() == 12);
}

// Checks the order of what it is told, and counts.
class Witness
{
public:
  std::size_t splits = 0, collapses = 0, flips = 0, moves = 0;
  std::map<IAR::Pass, std::size_t> counted, passes;
  unsigned iterations = 0;

  template <class M>
  void start_iteration(unsigned i, const M&)
  {
    CHECK(!is_in_iteration_ && !is_in_pass_ && i == iterations);
    is_in_iteration_ = true;
  }

  template <class M>
  void end_iteration(unsigned i, const M&)
  {
    CHECK(is_in_iteration_ && !is_in_pass_ && i == iterations);
    is_in_iteration_ = false;
    ++iterations;
  }

  template <class M>
  void start_pass(IAR::Pass pass, const M& mesh)
  {
    CHECK(!is_in_pass_ && !is_in_operation_);
    // what lies outside of an iteration is the clean-up after the last one
    if(!is_in_iteration_)
      CHECK(pass != IAR::Pass::split && pass != IAR::Pass::collapse && pass != IAR::Pass::glide && iterations > 0);
    else
      CHECK(pass != IAR::Pass::clean_up && pass != IAR::Pass::fit && pass != IAR::Pass::polish &&
            pass != IAR::Pass::distance && pass != IAR::Pass::repair);
    is_in_pass_ = true;
    pass_ = pass;
    ++passes[pass];
    at_start_ = {splits, collapses, flips, moves};
    faces_at_start_ = num_faces(mesh);
    before_move_.clear();
    after_move_.clear();
  }

  template <class M>
  void end_pass(IAR::Pass pass, const M& mesh, std::size_t count)
  {
    CHECK(is_in_pass_ && !is_in_operation_ && pass == pass_);
    is_in_pass_ = false;
    counted[pass] += count;
    const std::size_t split = splits - at_start_[0], collapsed = collapses - at_start_[1],
                      flipped = flips - at_start_[2];
    switch(pass)
    {
    case IAR::Pass::split:
      CHECK(count == split && collapsed == 0 && flipped == 0 && num_faces(mesh) >= faces_at_start_);
      break;
    case IAR::Pass::collapse:
    case IAR::Pass::clean_up:
      CHECK(count == collapsed && split == 0 && flipped == 0 && num_faces(mesh) <= faces_at_start_);
      break;
    case IAR::Pass::flip:
      CHECK(count == flipped && split == 0 && collapsed == 0);
      break;
    case IAR::Pass::glide:
      CHECK(count <= flipped && split == 0 && collapsed == 0);
      break;
    case IAR::Pass::relax:
      CHECK(split + collapsed + flipped == 0);
      CHECK(before_move_ == after_move_);
      CHECK_MESSAGE(count == before_move_.size(), count << " vertices relaxed, " << before_move_.size() << " announced");
      break;
    case IAR::Pass::fit:
      CHECK(split + collapsed + flipped == 0);
      break;
    case IAR::Pass::polish:
      CHECK(split + collapsed == 0 && flipped <= count);
      break;
    case IAR::Pass::distance:
      CHECK(collapsed == 0 && split <= count);
      break;
    case IAR::Pass::repair:
      CHECK(count == split + collapsed + flipped);
      break;
    case IAR::Pass::subdivide:
      CHECK(count == split && collapsed == 0 && flipped == 0);
      break;
    case IAR::Pass::mend:
      break;
    }
  }

  template <class Halfedge, class M>
  void before_split(Halfedge h, const M& mesh)
  {
    begin({IAR::Pass::split, IAR::Pass::distance, IAR::Pass::repair});
    faces_before_ = num_faces(mesh);
    is_border_ = CGAL::is_border_edge(h, mesh);
    midpoint_ = CGAL::midpoint(get(CGAL::vertex_point, mesh, source(h, mesh)), get(CGAL::vertex_point, mesh, target(h, mesh)));
  }
  template <class Vertex, class M>
  void after_split(Vertex v, const M& mesh)
  {
    end();
    ++splits;
    CHECK(degree(v, mesh) == (is_border_ ? 3 : 4));
    CHECK(num_faces(mesh) == faces_before_ + (is_border_ ? 1 : 2));
    CHECK(distance(get(CGAL::vertex_point, mesh, v), midpoint_) < 1e-12);
  }

  template <class Halfedge, class M>
  void before_collapse(Halfedge h, const M& mesh)
  {
    begin({IAR::Pass::collapse, IAR::Pass::clean_up, IAR::Pass::repair});
    faces_before_ = num_faces(mesh);
    is_border_ = CGAL::is_border_edge(h, mesh);
    kept_ = get(CGAL::vertex_point, mesh, target(h, mesh));
  }
  template <class Vertex, class M>
  void after_collapse(Vertex v, const M& mesh)
  {
    end();
    ++collapses;
    CHECK(num_faces(mesh) + (is_border_ ? 1 : 2) == faces_before_);
    CHECK(get(CGAL::vertex_point, mesh, v) == kept_);
  }

  template <class Halfedge, class M>
  void before_flip(Halfedge h, const M& mesh)
  {
    begin({IAR::Pass::flip, IAR::Pass::glide, IAR::Pass::polish, IAR::Pass::distance, IAR::Pass::repair});
    diagonal_ = {target(next(h, mesh), mesh).index(), target(next(opposite(h, mesh), mesh), mesh).index()};
  }
  template <class Halfedge, class M>
  void after_flip(Halfedge h, const M& mesh)
  {
    end();
    ++flips;
    CHECK((std::set<int>{source(h, mesh).index(), target(h, mesh).index()} == diagonal_));
  }

  template <class Vertex, class M>
  void before_move(Vertex v, const M&)
  {
    CHECK(is_in_pass_ && (pass_ == IAR::Pass::relax || pass_ == IAR::Pass::polish));
    before_move_.insert(v.index());
    ++moves;
  }
  template <class Vertex, class M>
  void after_move(Vertex v, const M&)
  {
    CHECK(is_in_pass_ && (pass_ == IAR::Pass::relax || pass_ == IAR::Pass::polish));
    after_move_.insert(v.index());
  }

private:
  void begin(const std::set<IAR::Pass>& passes)
  {
    CHECK(is_in_pass_ && !is_in_operation_ && passes.count(pass_) == 1);
    is_in_operation_ = true;
  }
  void end()
  {
    CHECK(is_in_operation_);
    is_in_operation_ = false;
  }

  bool is_in_iteration_ = false, is_in_pass_ = false, is_in_operation_ = false, is_border_ = false;
  IAR::Pass pass_ = IAR::Pass::split;
  std::array<std::size_t, 4> at_start_;
  std::size_t faces_at_start_ = 0, faces_before_ = 0;
  Point midpoint_, kept_;
  std::set<int> diagonal_, before_move_, after_move_;
};

// A sphere with a part cut off, with short and long edges, and vertices of 5, 6 and 7 edges.
Mesh uneven_mesh_with_a_border(int levels = 3)
{
  Soup soup = sphere(levels);
  for(auto& p : soup.points)
  {
    const double factor = 1 + .8 * p[0];
    for(double& coordinate : p)
      coordinate *= factor;
  }
  Mesh m = to_mesh<Mesh>(soup);
  for(const auto f : std::vector<Mesh::Face_index>(m.faces().begin(), m.faces().end()))
    if(m.point(m.target(m.halfedge(f))).z() > .8)
      CGAL::Euler::remove_face(m.halfedge(f), m);
  m.collect_garbage();
  scramble(m, [](std::size_t edge) { return edge % 7 == 0; });
  return m;
}

void a_visitor_is_told_everything_in_order()
{
  for(const bool is_closed : {true, false})
  {
    Mesh m = is_closed ? to_mesh<Mesh>(sphere(3)) : uneven_mesh_with_a_border();
    Witness w;
    const Report report = IAR::isotropic_remeshing(.3, m, parameters::number_of_iterations(4).visitor(std::ref(w)));
    CHECK(w.iterations == report.iterations && report.iterations <= 4 && (is_closed || report.iterations == 4));
    CHECK(w.splits == report.splits && w.counted[IAR::Pass::split] == report.splits);
    CHECK(w.collapses == report.collapses);
    CHECK(w.counted[IAR::Pass::collapse] + w.counted[IAR::Pass::clean_up] == report.collapses);
    CHECK(w.counted[IAR::Pass::flip] == report.flips);
    CHECK(w.counted[IAR::Pass::glide] == report.glides);
    CHECK(w.flips >= report.flips + report.glides);
    CHECK(w.moves > 0);
    CHECK(w.passes[IAR::Pass::split] == w.iterations && w.passes[IAR::Pass::collapse] == w.iterations);
    CHECK(w.passes[IAR::Pass::clean_up] == 1 && w.passes[IAR::Pass::fit] == 1);
    CHECK(report.collapses > 0 && report.flips > 0);
    CHECK(is_closed || (report.splits > 0 && report.glides > 0));
  }
}

void a_visitor_can_be_copied_in()
{
  struct Silent : IAR::Default_visitor
  {};
  Mesh m = to_mesh<Mesh>(sphere(1));
  CHECK(IAR::isotropic_remeshing(.3, m, parameters::visitor(Silent())).splits > 0);
}

void a_report_agrees_with_the_mesh()
{
  Mesh m = uneven_mesh_with_a_border();
  const std::size_t before = m.number_of_faces();
  const auto angles_before = IAR::inter_angle_statistics(m);
  const Report r = IAR::isotropic_remeshing(.25, m, parameters::number_of_iterations(7));
  const auto angles_after = IAR::inter_angle_statistics(m);
  CHECK(r.ending == Report::Ending::completed && r.iterations == 7);
  CHECK(r.target_edge_length == .25);
  CHECK(r.input_faces == before && r.output_faces == m.number_of_faces());
  const auto agree = [](const Report::Angles& a, const IAR::Inter_angle_statistics& s)
  {
    // the report takes the arc cosine from a polynomial that is good to 2e-6 degrees
    return std::abs(a.minimum - s.minimum_angle) < 1e-5 && std::abs(a.maximum - s.maximum_angle) < 1e-5 &&
           std::abs(a.average - s.average) < 1e-5;
  };
  CHECK(agree(r.angles_before, angles_before));
  CHECK(agree(r.angles_after, angles_after));
}

void verbose_prints_a_line_an_iteration()
{
  const auto printed = [](bool is_verbose, int levels)
  {
    Mesh m = to_mesh<Mesh>(sphere(2));
    std::ostringstream out;
    std::streambuf* const before = std::cout.rdbuf(out.rdbuf());
    IAR::Recipe recipe;
    recipe.multi_level = levels > 0;
    IAR::isotropic_remeshing(.2, m, IAR::recipe(recipe, parameters::number_of_iterations(5).verbose(is_verbose)));
    std::cout.rdbuf(before);
    return out.str();
  };
  const std::string text = printed(true, 0);
  CHECK(std::count(text.begin(), text.end(), '\n') == 6);
  const std::string with_a_level = printed(true, 1);
  CHECK(std::count(with_a_level.begin(), with_a_level.end(), '\n') == 7);
  CHECK(text.find("faces") != std::string::npos && text.find("splits") != std::string::npos);
  CHECK(printed(false, 0).empty());
}

void without_relaxation_steps_nothing_is_relaxed()
{
  Mesh m = uneven_mesh_with_a_border();
  Witness w;
  const Report report = IAR::isotropic_remeshing(.3, m, parameters::number_of_relaxation_steps(0)
                                                          .number_of_iterations(3).visitor(std::ref(w)));
  CHECK(w.moves == 0 && w.passes[IAR::Pass::relax] == 0 && w.passes[IAR::Pass::polish] == 0);
  CHECK(report.splits > 0);
  // Nothing widens what a flip leaves thin.
  Mesh sphere = meshes::to_mesh<Mesh>(meshes::sphere(3));
  const Report flipped = IAR::isotropic_remeshing(.07, sphere, parameters::number_of_relaxation_steps(0).number_of_iterations(3));
  CHECK(flipped.flips > 0);
  CHECK_MESSAGE(flipped.angles_after.minimum > 5, flipped.angles_after.minimum);
}

void with_length_0_nothing_is_split_or_collapsed()
{
  Mesh m = uneven_mesh_with_a_border();
  const std::size_t vertices = m.number_of_vertices(), faces = m.number_of_faces();
  const Picture<Mesh> before(m);
  const Report report = IAR::isotropic_remeshing(0, m);
  CHECK(report.ending == Report::Ending::completed);
  CHECK(report.splits == 0 && report.collapses == 0 && report.flips > 0);
  CHECK(m.number_of_vertices() == vertices && m.number_of_faces() == faces && m.number_of_removed_vertices() == 0);
  CHECK(Picture<Mesh>(m) != before);
  CHECK(report.angles_after.average > report.angles_before.average + 1);
  CHECK(CGAL::is_valid_polygon_mesh(m));
}

// A face without a height is as long as many target lengths, and about as many faces come of it: not as many as of a
// triangle with three sides of that length, 20^2, nor more and more from round to round.
void needles_do_not_multiply()
{
  for(const double height : {0., 1e-6, 1e-3})
  {
    Mesh m = to_mesh<Mesh>(Soup{{{0, 0, 0}, {1, 0, 0}, {.5, height, 0}}, {{0, 1, 2}}});
    const Report report = IAR::isotropic_remeshing(.05, m);
    CHECK_MESSAGE(report.output_faces > 10 && report.output_faces < 4 * 20, report.output_faces << " at height " << height);
    CHECK(CGAL::is_valid_polygon_mesh(m));
  }
}

// --- the projector -----------------------------------------------------------------------------------------------

// The distance from a point to a mesh, triangle by triangle.
double brute_force_distance(const Point& p, const Mesh& m)
{
  double best = INFINITE;
  for(const auto f : m.faces())
  {
    const auto h = m.halfedge(f);
    const Kernel::Triangle_3 t(m.point(m.source(h)), m.point(m.target(h)), m.point(m.target(m.next(h))));
    best = std::min(best, CGAL::squared_distance(p, t));
  }
  return std::sqrt(best);
}

// Far above rounding, at coordinates of about 1.
constexpr double ROUNDING = 1e-12;

template <class Function>
void for_random_points(double low, double high, int n, const Function& function)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(low, high);
  for(int i = 0; i < n; ++i)
  {
    const double x = coordinate(random), y = coordinate(random), z = coordinate(random);
    function(Point(x, y, z));
  }
}

void points_fall_onto_a_square()
{
  const Mesh m = to_mesh<Mesh>(square(5));
  const Projector projector(m);
  for_random_points(-1, 2, 500, [&](const Point& p) {
    const Point expected(std::clamp(p.x(), 0., 1.), std::clamp(p.y(), 0., 1.), 0);
    CHECK(distance(projector.project(p), expected) < ROUNDING);
  });
}

void points_fall_onto_a_cube()
{
  const Mesh m = to_mesh<Mesh>(cube(3));
  const Projector projector(m);
  for_random_points(-1, 2, 500, [&](const Point& p) {
    const Point in_cube(std::clamp(p.x(), 0., 1.), std::clamp(p.y(), 0., 1.), std::clamp(p.z(), 0., 1.));
    const Point found = projector.project(p);
    double to_cube = distance(p, in_cube);
    if(to_cube == 0)  // inside: to the nearest side
      to_cube = std::min({p.x(), p.y(), p.z(), 1 - p.x(), 1 - p.y(), 1 - p.z()});
    CHECK(std::abs(distance(p, found) - to_cube) < ROUNDING);
    CHECK(brute_force_distance(found, m) < ROUNDING);
  });
}

void points_fall_where_brute_force_says()
{
  for(const double scale : {1., 1e-3, 1e6})
  {
    const Mesh m = to_mesh<Mesh>(sphere(2).scaled(scale));
    const Projector projector(m);
    for_random_points(-1.5 * scale, 1.5 * scale, 300, [&](const Point& p) {
      const Point found = projector.project(p);
      CHECK(std::abs(distance(p, found) - brute_force_distance(p, m)) < ROUNDING * scale);
      CHECK(brute_force_distance(found, m) < ROUNDING * scale);
    });
  }
}

void a_sheet_that_looks_the_same_way_wins()
{
  // two sheets .01 apart: the lower one looks down, the upper one up
  Soup lower = square(4), upper = square(4).moved(0, 0, .01);
  for(auto& f : lower.faces)
    std::swap(f[1], f[2]);
  const Mesh plate = to_mesh<Mesh>(lower.joined_with(upper));
  const Projector projector(plate);
  const Kernel::Vector_3 up(0, 0, 1), down(0, 0, -1), slanted(.5, 0, .1);
  for_random_points(0, 1, 100, [&](const Point& p) {
    const Point q(p.x(), p.y(), -.005 + .02 * p.z());
    const Point on_lower(q.x(), q.y(), 0), on_upper(q.x(), q.y(), .01);
    CHECK(distance(projector.project(q), q.z() < .005 ? on_lower : on_upper) < ROUNDING);
    CHECK(distance(projector.project(q, up), on_upper) < ROUNDING);
    CHECK(distance(projector.project(q, down), on_lower) < ROUNDING);
    CHECK(distance(projector.project(q, slanted), on_upper) < ROUNDING);
    // where there is no such sheet, the nearest point of all
    const Projector alone(to_mesh<Mesh>(upper));
    CHECK(distance(alone.project(q, down), on_upper) < ROUNDING);
  });
}

void a_projector_keeps_the_surface_as_it_was()
{
  auto m = std::make_unique<Mesh>(to_mesh<Mesh>(sphere(2)));
  const Mesh as_it_was = *m;
  auto original = std::make_unique<Projector>(*m);
  const Projector copy = *original;
  const Point p(.3, 1.2, -.7), expected = original->project(p);
  for(const auto v : m->vertices())
    m->point(v) = Point(9, 9, 9);
  CHECK(original->project(p) == expected);
  original.reset();
  m.reset();
  CHECK(copy.project(p) == expected);
  CHECK(std::abs(distance(p, expected) - brute_force_distance(p, as_it_was)) < ROUNDING);
}

void threads_get_the_same_points()
{
  const Mesh m = to_mesh<Mesh>(torus(30, 20, .4));
  std::vector<Point> queries;
  for_random_points(-1.5, 1.5, 500, [&](const Point& p) { queries.push_back(p); });
  const Projector once(m);
  std::vector<Bits> expected;
  for(const Point& p : queries)
    expected.push_back(bits(once.project(p)));
  const Projector shared(m);  // whose search tree the threads build
  std::array<std::vector<Bits>, 4> found;
  std::vector<std::thread> threads;
  for(auto& result : found)
    threads.emplace_back([&]() {
      for(const Point& p : queries)
        result.push_back(bits(shared.project(p)));
    });
  for(std::thread& t : threads)
    t.join();
  for(const auto& result : found)
    CHECK(result == expected);
}

void a_projector_reads_the_live_point_of_a_vertex()
{
  Mesh m = to_mesh<Mesh>(square(4));
  const Projector projector(m);
  const Mesh::Vertex_index v(7);
  m.point(v) = Point(.3, .4, .5);
  CHECK(distance(projector(v), Point(.3, .4, 0)) < ROUNDING);
  // or by a map
  const auto lifted = to_mesh<Mesh>(square(4));
  auto points = m.add_property_map<Mesh::Vertex_index, Point>("v:other").first;
  for(const auto u : m.vertices())
    points[u] = Point(lifted.point(u).x(), lifted.point(u).y(), 2);
  const IAR::Closest_point_projector<Mesh, Mesh::Property_map<Mesh::Vertex_index, Point>> by_map(m, points);
  points[v] = Point(.3, .4, .5);
  CHECK(distance(by_map(v), Point(.3, .4, 2)) < ROUNDING);
}

void a_projector_serves_polygon_mesh_processing()
{
  const Mesh input = to_mesh<Mesh>(sphere(2));
  Mesh m = input;
  const IAR::Closest_point_projector<Mesh, Mesh::Property_map<Mesh::Vertex_index, Point>> projector(m, m.points());
  CGAL::Polygon_mesh_processing::isotropic_remeshing(faces(m), .2, m,
    parameters::number_of_iterations(2).projection_functor(std::cref(projector)));
  CHECK(m.number_of_vertices() > input.number_of_vertices());
  for(const auto v : m.vertices())
    CHECK(brute_force_distance(m.point(v), input) < ROUNDING);
}

// Where no edge is much longer than the target.
void a_projector_does_what_the_default_does()
{
  const Mesh input = uneven_mesh_with_a_border(5);
  const Projector projector(input);
  Mesh by_default = input, by_reference = input, by_value = input;
  const double length = .1;   // some 3700 faces: of less, the averages scatter more
  IAR::Recipe recipe;
  recipe.fits = 0;            // which lifts vertices off the surface
  const Report a = IAR::isotropic_remeshing(faces(by_default), length, by_default, IAR::recipe(recipe));
  const Report b = IAR::isotropic_remeshing(faces(by_reference), length, by_reference,
                                            IAR::recipe(recipe, parameters::projection_functor(std::cref(projector))));
  const Report c = IAR::isotropic_remeshing(faces(by_value), length, by_value,
                                            IAR::recipe(recipe, parameters::projection_functor(projector)));
  CHECK(Picture<Mesh>(by_reference) == Picture<Mesh>(by_value));
  CHECK(b.output_faces == c.output_faces);
  // a run is chaotic: the projector's faces are numbered otherwise, and the last bit decides where two are equally near
  CHECK_MESSAGE(std::abs(double(a.output_faces) / double(b.output_faces) - 1) < .05, a.output_faces << ", " << b.output_faces);
  CHECK_MESSAGE(std::abs(a.angles_after.average - b.angles_after.average) < .5,
                a.angles_after.average << ", " << b.angles_after.average);
  // a vertex lies on the surface or, where it was polished or could not be pulled back, near it
  for(const Mesh* m : {&by_default, &by_reference})
    for(const auto v : m->vertices())
      CHECK(distance(m->point(v), projector.project(m->point(v))) < .02 * length);
}

// The projector of a whole mesh, for a part of it that is a hundredth as large.
void a_projector_of_a_larger_surface_will_do()
{
  Mesh m = to_mesh<Mesh>(square(40));
  const Mesh input = m;
  const Projector projector(input);
  std::vector<Mesh::Face_index> range;
  for(const auto f : m.faces())
    if(m.point(m.target(m.halfedge(f))).x() < .15 && m.point(m.target(m.halfedge(f))).y() < .15)
      range.push_back(f);
  const Report report = IAR::isotropic_remeshing(range, .01, m, parameters::projection_functor(std::cref(projector)));
  CHECK(report.splits > 0);
  for(const auto v : m.vertices())
    CHECK(m.point(v).z() == 0);
  CHECK(CGAL::is_valid_polygon_mesh(m));
}

void without_projection_vertices_leave_the_surface()
{
  const Mesh input = to_mesh<Mesh>(sphere(2));
  IAR::Recipe recipe;
  recipe.clean_up = false;
  const auto farthest = [&](bool does_project)
  {
    Mesh m = input;
    IAR::isotropic_remeshing(.25, m, IAR::recipe(recipe, parameters::do_project(does_project)
                                                                   .projection_functor(Projector(input))));
    double result = 0;
    for(const auto v : m.vertices())
      result = std::max(result, brute_force_distance(m.point(v), input));
    return result;
  };
  CHECK(farthest(true) < ROUNDING);
  // a vertex moves in the tangent plane of its star, which the chord of an edge leaves by l^2 / 8 = .008
  CHECK(farthest(false) > 1e-4);
}

void a_functor_of_points_or_of_vertices_is_obeyed()
{
  // onto the round sphere
  const auto lift = [](const Point& p)
  {
    const double r = distance(p, CGAL::ORIGIN);
    return Point(p.x() / r, p.y() / r, p.z() / r);
  };
  IAR::Recipe recipe;
  recipe.clean_up = false;
  Mesh by_points = to_mesh<Mesh>(sphere(2)), by_vertices = by_points;
  IAR::isotropic_remeshing(.25, by_points, IAR::recipe(recipe, parameters::projection_functor(lift)));
  IAR::isotropic_remeshing(.25, by_vertices, IAR::recipe(recipe,
    parameters::projection_functor([&](Mesh::Vertex_index v) { return lift(by_vertices.point(v)); })));
  CHECK(Picture<Mesh>(by_points) == Picture<Mesh>(by_vertices));
  for(const auto v : by_points.vertices())
    CHECK(std::abs(distance(by_points.point(v), CGAL::ORIGIN) - 1) < ROUNDING);
}

// Several target lengths away, whichever side it looks to.
void surfaces_far_from_the_mesh_are_reached()
{
  constexpr double RADIUS = 2.5;
  const auto lift = [](const Point& p) {
    const double r = distance(p, CGAL::ORIGIN);
    return Point(RADIUS * p.x() / r, RADIUS * p.y() / r, RADIUS * p.z() / r);
  };
  const auto check = [&](const Mesh& m, const Report& report, double tolerance, const char* name) {
    CHECK(CGAL::is_valid_polygon_mesh(m));
    CHECK_MESSAGE(report.angles_after.minimum > 40 && report.angles_after.maximum < 90, name);
    for(const auto v : m.vertices())
      CHECK(std::abs(distance(m.point(v), CGAL::ORIGIN) - RADIUS) < tolerance);
  };
  Mesh box = to_mesh<Mesh>(cube(20).moved(-.5, -.5, -.5));
  check(box, IAR::isotropic_remeshing(.05, box, parameters::projection_functor(lift)), .01, "from a cube");
  Mesh counted = to_mesh<Mesh>(sphere(3));
  check(counted, IAR::isotropic_remeshing(IAR::Face_count(3000), counted, parameters::projection_functor(lift)), .01, "a number of faces");
  CHECK(std::abs(double(counted.number_of_faces()) - 3000) < 30);
  Mesh around = to_mesh<Mesh>(sphere(4));
  for(const auto v : around.vertices())
    around.point(v) = lift(around.point(v));
  for(const bool is_reversed : {false, true})
  {
    if(is_reversed)
      CGAL::Polygon_mesh_processing::reverse_face_orientations(around);
    Mesh m = to_mesh<Mesh>(sphere(4));
    const Projector projector(around);
    check(m, IAR::isotropic_remeshing(.05, m, parameters::projection_functor(std::cref(projector))), .01,
          is_reversed ? "from a sphere to one inside out" : "from a sphere");
  }
}

// One that is larger than the mesh by any factor.
void surfaces_that_take_too_many_faces_are_refused()
{
  for(const double radius : {1e6, 1e90})
    check_refused("so large that about", [&](Mesh& m) {
      IAR::isotropic_remeshing(.1, m, parameters::projection_functor([&](const Point& p) {
        const double r = distance(p, CGAL::ORIGIN);
        return Point(radius * p.x() / r, radius * p.y() / r, radius * p.z() / r);
      }));
    });
}

void a_projector_needs_a_surface()
{
  Mesh isolated;
  isolated.add_vertex(Point(1, 2, 3));
  check_refused(isolated, "has no face", [](Mesh& g) { Projector projector(g); });
  Mesh empty;
  check_refused(empty, "has no face", [](Mesh& g) { Projector projector(g); });
  // degenerate faces are a surface of their own kind
  const Projector line(to_mesh<Mesh>(Soup{{{0, 0, 0}, {1, 0, 0}, {3, 0, 0}}, {{0, 1, 2}}}));
  CHECK(distance(line.project(Point(2, 1, 0)), Point(2, 0, 0)) < ROUNDING);
}

// --- the length for a number of faces ----------------------------------------------------------------------------

void the_length_follows_from_area_and_count()
{
  // n triangles of area sqrt(3) / 4 l^2, and edges 3.1% shorter than the target
  const auto expected = [](double area, double n) { return 1.05 * std::sqrt(4 * area / (std::sqrt(3.) * n)); };
  for(const double scale : {1., 1e-50, 1e50})
  {
    const Mesh m = to_mesh<Mesh>(cube(3).scaled(scale));
    const double length = IAR::target_edge_length(faces(m), m, 1000);
    CHECK(std::abs(length / (scale * expected(6, 1000)) - 1) < ROUNDING);
    std::vector<Mesh::Face_index> side;
    for(const auto f : m.faces())
      if(std::all_of(CGAL::vertices_around_face(m.halfedge(f), m).begin(),
                     CGAL::vertices_around_face(m.halfedge(f), m).end(),
                     [&](Mesh::Vertex_index v) { return m.point(v).x() == 0; }))
        side.push_back(f);
    CHECK(side.size() == 2 * 3 * 3);
    CHECK(std::abs(IAR::target_edge_length(side, m, 50) / (scale * expected(1, 50)) - 1) < ROUNDING);
  }
  const Polyhedron p = to_mesh<Polyhedron>(cube(2));
  CHECK(std::abs(IAR::target_edge_length(faces(p), p, 7) / expected(6, 7) - 1) < ROUNDING);
}

void a_number_of_faces_can_be_wished_for()
{
  Mesh m = to_mesh<Mesh>(torus(20, 10, .4));
  const Report report = IAR::isotropic_remeshing(IAR::Face_count(2000), m);
  // 2% on closed surfaces, as documented, and the length is told
  CHECK_MESSAGE(report.output_faces > 1960 && report.output_faces < 2040, report.output_faces);
  CHECK(report.target_edge_length > 0);
}

int main()
{
  refusals_hold_in_release_builds();
  faces_that_are_no_triangles_are_refused<Mesh>();
  faces_that_are_no_triangles_are_refused<Polyhedron>();
  coordinates_that_are_not_finite_are_refused();
  a_range_that_is_one_point_is_refused();
  lengths_that_are_none_are_refused();
  lengths_that_make_too_many_faces_are_refused();
  no_faces_are_refused_as_a_wish();
  parameters_out_of_their_range_are_refused();
  counts_that_do_not_fit_are_refused();
  recipes_out_of_range_are_refused();
  vertices_with_too_many_faces_are_refused();
  faces_glued_to_themselves_are_refused();
  faces_of_no_mesh_are_refused<Mesh>();
  faces_of_no_mesh_are_refused<Polyhedron>();
  removed_faces_are_refused();
  doubled_edges_are_refused_only_where_they_are_protected();
  an_empty_range_is_nothing_to_do();
  rounds_of_flips_end_when_nothing_is_left_to_flip();
  no_iteration_is_nothing_to_do();
  a_projection_that_is_not_finite_ends_the_run();

  progress_rises_from_0_to_1();
  a_run_can_be_cancelled_after_each_pass<Mesh>();
  a_run_can_be_cancelled_after_each_pass<Polyhedron>();
  pass_names_are_distinct();
  a_visitor_is_told_everything_in_order();
  a_visitor_can_be_copied_in();
  a_report_agrees_with_the_mesh();
  verbose_prints_a_line_an_iteration();
  without_relaxation_steps_nothing_is_relaxed();
  with_length_0_nothing_is_split_or_collapsed();
  needles_do_not_multiply();

  points_fall_onto_a_square();
  points_fall_onto_a_cube();
  points_fall_where_brute_force_says();
  a_sheet_that_looks_the_same_way_wins();
  a_projector_keeps_the_surface_as_it_was();
  threads_get_the_same_points();
  a_projector_reads_the_live_point_of_a_vertex();
  a_projector_serves_polygon_mesh_processing();
  a_projector_does_what_the_default_does();
  a_projector_of_a_larger_surface_will_do();
  without_projection_vertices_leave_the_surface();
  a_functor_of_points_or_of_vertices_is_obeyed();
  surfaces_far_from_the_mesh_are_reached();
  surfaces_that_take_too_many_faces_are_refused();
  a_projector_needs_a_surface();

  the_length_follows_from_area_and_count();
  a_number_of_faces_can_be_wished_for();
  return result();
}
