// Copyright (c) 2026 The Inter_angle_remeshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Fields over the surface. Target lengths that vary: functions of the position, sizing fields, the field of the curvature, and
// wanted numbers of faces that scale one. Attributes that are carried over.

#include <CGAL/Inter_angle_remeshing/Attribute_transfer.h>
#include <CGAL/Inter_angle_remeshing/Curvature_sizing_field.h>
#include <CGAL/Inter_angle_remeshing/Projection/Closest_point_projector.h>
#include <CGAL/Inter_angle_remeshing/Uniform_sizing_field.h>
#include <CGAL/Inter_angle_remeshing/detect_features.h>
#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>

#if CGAL_VERSION_NR >= 1060000000
#  include <CGAL/Polygon_mesh_processing/Adaptive_sizing_field.h>
#  include <CGAL/Polygon_mesh_processing/Uniform_sizing_field.h>
#endif

#include <CGAL/Polygon_mesh_processing/connected_components.h>

#include "check.h"
#include "invariants.h"
#include "meshes.h"
#include "models.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace IAR = CGAL::Inter_angle_remeshing;
namespace PMP = CGAL::Polygon_mesh_processing;
using meshes::Soup;
namespace parameters = CGAL::parameters;
using namespace invariants;

double length_of(Edge e, const Mesh& m)
{
  return std::sqrt(CGAL::squared_distance(m.point(m.vertex(e, 0)), m.point(m.vertex(e, 1))));
}

// Edge lengths over what they are to be, in the middle of the edge.
struct Fit
{
  double mean = 0, share = 0;      // the share lies in [0.7, 1.4]
};

template <class Field>
Fit fit(const Mesh& m, const Field& field)
{
  Fit result;
  for(const Edge e : m.edges())
  {
    const double ratio = length_of(e, m) / field(CGAL::midpoint(m.point(m.vertex(e, 0)), m.point(m.vertex(e, 1))));
    result.mean += ratio / m.number_of_edges();
    result.share += (ratio >= .7 && ratio <= 1.4) / double(m.number_of_edges());
  }
  return result;
}

// Lengths that rise along an axis from a half to twice the mean edge length, or swing across it.
struct Ramp
{
  double low, width, length;
  Ramp(const Mesh& m)
    : length(mean_edge_length(m))
  {
    CGAL::Bbox_3 box;
    for(const Vertex v : m.vertices())
      box += m.point(v).bbox();
    low = box.xmin();
    width = box.xmax() - box.xmin();
  }
  double operator()(const Point& p) const { return length * (.5 + 1.5 * (p.x() - low) / width); }
};

struct Wave : Ramp
{
  using Ramp::Ramp;
  double operator()(const Point& p) const { return length * (1.2 + .6 * std::sin(4 * CGAL_PI * (p.x() - low) / width)); }
};

template <class Field>
void fits(const Mesh& m, const Field& field, const IAR::Remeshing_report& report, double smallest_angle, double largest_angle,
          const std::string& name)
{
  const Fit f = fit(m, field);
  CHECK_MESSAGE(m.is_valid(false) && CGAL::is_triangle_mesh(m) && is_finite(m), name);
  CHECK_MESSAGE(std::abs(f.mean - 1) < .05, name << ": mean " << f.mean);
  CHECK_MESSAGE(f.share > .95, name << ": share " << f.share);
  const auto& angles = report.angles_after;
  CHECK_MESSAGE(angles.average > 55, name << ": " << angles.average);
  CHECK_MESSAGE(angles.minimum >= smallest_angle && angles.maximum <= largest_angle,
                name << ": " << angles.minimum << " to " << angles.maximum);
}

void functions_of_the_position_are_followed()
{
  // Of a border, whose corners may ask for other angles.
  struct Case { const char* name; double smallest, largest; };
  for(const Case& c : {Case{"elephant", 40, 90}, Case{"bunny00", 40, 90}, Case{"mesh_with_border", 33, 103}})
  {
    const Mesh input = models::of_cgal(c.name);
    Mesh m = input;
    IAR::Remeshing_report report = IAR::isotropic_remeshing(Ramp(input), m);
    fits(m, Ramp(input), report, c.smallest, c.largest, c.name + std::string(", ramp"));
    CHECK(topology(m) == topology(input));
    if(meshes::is_small_run())
      continue;
    m = input;
    report = IAR::isotropic_remeshing(Wave(input), m);
    fits(m, Wave(input), report, c.smallest, c.largest, c.name + std::string(", wave"));
    CHECK(topology(m) == topology(input));
    CHECK(invariants::surface_distance(m, input).hausdorff() < 2 * mean_edge_length(input));
  }
}

// A field with values at the vertices of the input.
struct Field_at_vertices
{
  Ramp ramp;
  double at(Vertex v, const Mesh& m) const { return ramp(m.point(v)); }
};

// Whatever pulls vertices back, or nothing does.
void fields_are_followed_with_every_projector()
{
  const Mesh input = meshes::to_mesh<Mesh>(meshes::sphere(meshes::is_small_run() ? 4 : 5));
  const Field_at_vertices field{Ramp(input)};
  const auto run = [&](const std::string& name, const auto& np) {
    Mesh m = input;
    const IAR::Remeshing_report report = IAR::isotropic_remeshing(field, m, np);
    fits(m, field.ramp, report, 40, 90, name);
  };
  run("default", parameters::default_values());
  run("none", parameters::do_project(false));
  run("functor", parameters::projection_functor([](const Point& p) {
    return CGAL::ORIGIN + (p - CGAL::ORIGIN) / std::sqrt(CGAL::squared_distance(p, Point(0, 0, 0))); }));
  const IAR::Closest_point_projector<Mesh> projector(input);
  run("projector", parameters::projection_functor(std::ref(projector)));
  const IAR::Closest_point_projector<Mesh> other(meshes::to_mesh<Mesh>(meshes::sphere(4)));
  run("projector of another surface", parameters::projection_functor(std::ref(other)));
}

// A field that is the same everywhere does what its number does.
void uniform_fields_are_numbers()
{
  const Mesh input = meshes::to_mesh<Mesh>(meshes::torus(40, 20, .4));
  const double l = 1.2 * mean_edge_length(input);
  Mesh by_number = input, by_field = input, by_reference = input;
  IAR::isotropic_remeshing(l, by_number);
  const IAR::Uniform_sizing_field<Mesh> field(l, input);
  IAR::isotropic_remeshing(field, by_field);
  IAR::isotropic_remeshing(faces(by_reference), std::cref(field), by_reference);
  CHECK(meshes::Picture<Mesh>(by_number) == meshes::Picture<Mesh>(by_field));
  CHECK(meshes::Picture<Mesh>(by_number) == meshes::Picture<Mesh>(by_reference));
}

void numbers_of_faces_scale_fields()
{
  const Mesh input = meshes::to_mesh<Mesh>(meshes::torus(60, 30, .4));
  for(const double factor : {.1, .7, 5.})
  {
    if(meshes::is_small_run() && factor > 1)
      continue;
    const std::size_t n = std::size_t(factor * input.number_of_faces());
    const Ramp ramp(input);
    Mesh m = input;
    const IAR::Remeshing_report report = IAR::isotropic_remeshing(IAR::Face_count(n).scaling(ramp), m);
    CHECK_MESSAGE(std::abs(double(m.number_of_faces()) / n - 1) < .02, factor << ": " << m.number_of_faces() << " of " << n);
    CHECK(report.output_faces == m.number_of_faces());
    // The lengths have the field's ratios.
    const double mean = fit(m, ramp).mean;
    const Fit f = fit(m, [&](const Point& p) { return mean * ramp(p); });
    CHECK_MESSAGE(f.share > .9, factor << ": " << f.share);
  }
  // Only they count: powers of two, which are exact, change nothing.
  const Ramp ramp(input);
  const auto by = [&](double power) {
    Mesh m = input;
    IAR::isotropic_remeshing(IAR::Face_count(1000).scaling([&](const Point& p) { return power * ramp(p); }), m);
    return meshes::Picture<Mesh>(m);
  };
  const meshes::Picture<Mesh> as_it_is = by(1);
  for(const double power : {std::ldexp(1., -40), std::ldexp(1., 10), std::ldexp(1., 100)})
    CHECK_MESSAGE(by(power) == as_it_is, power);
}

// Few large faces tell little of a function at their corners.
void functions_are_asked_inside_of_faces()
{
  const auto rising_from = [](double least) {
    return [=](const Point& p) {
      double squared = 0;
      for(int k = 0; k < 3; ++k)
        squared += CGAL::square((std::min)(p[k], 1 - p[k]));
      return least + .45 * std::sqrt(squared);
    };
  };
  const Mesh coarse = meshes::to_mesh<Mesh>(meshes::cube(1));
  Mesh m = coarse;
  const auto field = rising_from(.01);
  IAR::isotropic_remeshing(IAR::Face_count(4000).scaling(field), m);
  CHECK_MESSAGE(std::abs(m.number_of_faces() / 4000. - 1) < .02, m.number_of_faces());
  const double mean = fit(m, field).mean;
  const Fit f = fit(m, [&](const Point& p) { return mean * field(p); });
  CHECK_MESSAGE(f.share > .85, f.share);
  // One that is tiny at the corners alone needs no more faces.
  m = coarse;
  IAR::isotropic_remeshing(rising_from(1e-5), m);
  CHECK_MESSAGE(m.number_of_faces() > 1000 && m.number_of_faces() < 10000, m.number_of_faces());
}

// What a function says in the middle of a large face, far from its vertices, is not overlooked. (The cube stayed as it was, or had up to
// sixteen times the wanted number of faces.)
void details_inside_of_faces_are_found()
{
  const Mesh cube = meshes::to_mesh<Mesh>(meshes::cube(1));
  for(const Point& centre : {Point(.5, .5, 1), Point(.68, .4, 1)})
  {
    constexpr double RADIUS = .15, SHORT = .025, LONG = 1.25;
    const auto spot = [&](const Point& p) { return CGAL::squared_distance(p, centre) < RADIUS * RADIUS ? SHORT : LONG; };
    Mesh m = cube;
    const auto report = IAR::isotropic_remeshing(spot, m);
    double sum = 0;
    int edges = 0;
    for(const Edge e : m.edges())
      if(CGAL::squared_distance(CGAL::midpoint(m.point(m.vertex(e, 0)), m.point(m.vertex(e, 1))), centre) < .8 * RADIUS * RADIUS)
      {
        sum += length_of(e, m);
        ++edges;
      }
    CHECK_MESSAGE(edges > 150 && std::abs(sum / (edges * SHORT) - 1) < .2, centre << ": " << edges << ", " << sum / edges);
    CHECK_MESSAGE(m.number_of_faces() < 2000 && report.band_holds, centre << ": " << m.number_of_faces());
    m = cube;
    IAR::isotropic_remeshing(IAR::Face_count(4000).scaling(spot), m);
    CHECK_MESSAGE(std::abs(m.number_of_faces() / 4000. - 1) < .02, centre << ": " << m.number_of_faces());
    m = cube;
    IAR::isotropic_remeshing(faces(m), spot, m, parameters::do_split(false));
    CHECK(m.number_of_faces() <= cube.number_of_faces());
  }
}

// --- curvature ---------------------------------------------------------------------------------------------------

using Curvature_field = IAR::Curvature_sizing_field<Mesh>;

double length_for(double curvature, double tolerance)
{
  return std::sqrt(6 * tolerance / curvature - 3 * tolerance * tolerance);
}

std::vector<double> lengths(const Curvature_field& field, const Mesh& m)
{
  std::vector<double> result;
  for(const Vertex v : m.vertices())
    result.push_back(field.at(v, m));
  return result;
}

void curvature_of_a_sphere_and_a_torus()
{
  const double tolerance = 1e-3;
  const std::pair<double, double> range(1e-3, 10);
  const Mesh sphere = meshes::to_mesh<Mesh>(meshes::sphere(4));
  for(const double l : lengths(Curvature_field(tolerance, range, sphere.faces(), sphere), sphere))
    CHECK_MESSAGE(std::abs(l / length_for(1, tolerance) - 1) < .05, l);
  // Of the circle that turns about the axis; around the hole the curvature 1 / (1 - r) is smaller.
  const double r = .4;
  const Mesh torus = meshes::to_mesh<Mesh>(meshes::torus(120, 60, r));
  for(const double l : lengths(Curvature_field(tolerance, range, torus.faces(), torus), torus))
    CHECK_MESSAGE(std::abs(l / length_for(1 / r, tolerance) - 1) < .05, l);
}

void curvature_with_noise()
{
  Mesh sphere = meshes::to_mesh<Mesh>(meshes::sphere(5));
  std::mt19937 random(11);
  std::normal_distribution<double> noise(0, .05 * mean_edge_length(sphere));
  for(const Vertex v : sphere.vertices())
    sphere.point(v) = CGAL::ORIGIN + (1 + noise(random)) * (sphere.point(v) - CGAL::ORIGIN);
  const double tolerance = 1e-3, expected = length_for(1, tolerance);
  std::vector<double> l = lengths(Curvature_field(tolerance, {1e-3, 10}, sphere.faces(), sphere), sphere);
  std::sort(l.begin(), l.end());
  CHECK_MESSAGE(l[l.size() / 2] > .75 * expected && l[l.size() / 2] < 1.25 * expected, l[l.size() / 2] / expected);
  CHECK_MESSAGE(l[l.size() / 20] > .55 * expected, l[l.size() / 20] / expected);
}

// Flat faces have no curvature, be they beside a sharp edge; bent borders and features have one.
void curvature_at_features_and_borders()
{
  const Mesh cube = meshes::to_mesh<Mesh>(meshes::cube(8));
  for(const double l : lengths(Curvature_field(.001, {.01, .5}, cube.faces(), cube), cube))
    CHECK_MESSAGE(std::abs(l - .5) < 1e-9, l);

  // A disk: flat inside, a circle of radius 1 around it.
  const std::size_t n = 40;
  meshes::Soup disk;
  disk.points.push_back({0, 0, 0});
  for(std::size_t i = 0; i < n; ++i)
    disk.points.push_back({std::cos(2 * CGAL_PI * i / n), std::sin(2 * CGAL_PI * i / n), 0});
  for(std::size_t i = 0; i < n; ++i)
    disk.faces.push_back({0, 1 + i, 1 + (i + 1) % n});
  const Mesh m = meshes::to_mesh<Mesh>(disk);
  const Curvature_field field(.001, {.01, 5}, m.faces(), m);
  for(const Vertex v : m.vertices())
  {
    const double expected = m.is_border(v) ? length_for(1, .001) : length_for(1, .001) + .3;
    CHECK_MESSAGE(std::abs(field.at(v, m) / expected - 1) < .02, field.at(v, m) << " " << expected);
  }
}

void gradation_is_bounded()
{
  const Mesh m = models::of_cgal("elephant");
  const double mean = mean_edge_length(m), gradation = .2;
  const std::pair<double, double> range(mean / 4, 4 * mean);
  const Curvature_field field(.02 * mean, range, m.faces(), m, parameters::default_values(), gradation);
  std::size_t shortest = 0, longest = 0;
  for(const Edge e : m.edges())
  {
    const double a = field.at(m.vertex(e, 0), m), b = field.at(m.vertex(e, 1), m);
    CHECK_MESSAGE(std::abs(a - b) <= gradation * length_of(e, m) * (1 + 1e-9), a << " " << b);
    shortest += a < mean;
    longest += a > mean;
  }
  CHECK(shortest > 0 && longest > 0);
  for(const double l : lengths(field, m))
    CHECK(l >= range.first && l <= range.second);
  Mesh result = m;
  const IAR::Remeshing_report report = IAR::isotropic_remeshing(field, result);
  CHECK_MESSAGE(report.angles_after.minimum > 40 && report.angles_after.maximum < 90,
                report.angles_after.minimum << " to " << report.angles_after.maximum);
  CHECK_MESSAGE(report.angles_after.average > 55, report.angles_after.average);
}

// A larger tolerance never asks for shorter edges.
void lengths_rise_with_the_tolerance()
{
  const Mesh m = models::of_cgal("blobby_3cc");
  const double mean = mean_edge_length(m);
  std::vector<double> before(m.number_of_vertices(), 0);
  for(const double tolerance : {.01, .1, 1., 100., 1e6})
  {
    const std::vector<double> now = lengths(Curvature_field(tolerance * mean, {mean / 10, 10 * mean}, m.faces(), m), m);
    std::size_t shorter = 0;
    for(std::size_t i = 0; i < now.size(); ++i)
      shorter += now[i] < .8 * before[i];      // averages are taken over larger neighborhoods
    CHECK_MESSAGE(shorter <= now.size() / 100, tolerance << ": " << shorter << " of " << now.size());
    before = now;
  }
  // As good as none at all.
  for(const double l : lengths(Curvature_field(1e300, {mean / 10, mean}, m.faces(), m), m))
    CHECK(l == mean);
}

// A part of the faces has vertices that the field does not know.
void curvature_of_a_range()
{
  const Mesh m = meshes::to_mesh<Mesh>(meshes::sphere(3));
  std::vector<Face> half(m.faces().begin(), m.faces().begin() + m.number_of_faces() / 2);
  const Curvature_field field(.001, {.01, 7}, half, m);
  std::size_t unknown = 0;
  for(const Vertex v : m.vertices())
    unknown += field.at(v, m) == 7;
  CHECK(unknown > 0 && unknown < m.number_of_vertices());
  const Curvature_field none(.001, {.01, 7}, std::vector<Face>(), m);
  CHECK(none.at(*m.vertices().begin(), m) == 7);
}

// Lengths of a range are those of the mesh: the rim is no border, and there are features that a few faces do not tell. A map may know the
// range alone.
void curvature_of_a_range_is_that_of_the_mesh()
{
  enum class Marks { found, of_mesh, of_range };
  for(const char* name : {"elephant", "fandisk", "anchor_dense"})
    for(const Marks marks : {Marks::found, Marks::of_mesh, Marks::of_range})
    {
      Mesh m = models::of_cgal(name);
      const double mean = mean_edge_length(m);
      const auto feature = m.add_property_map<Edge, bool>("e:feature", false).first;
      const auto field_of = [&](const auto& range, bool is_marked) {
        const std::pair<double, double> lengths(.25 * mean, 4 * mean);
        return is_marked ? Curvature_field(.02 * mean, lengths, range, m, parameters::edge_is_constrained_map(feature))
                         : Curvature_field(.02 * mean, lengths, range, m);
      };
      if(marks == Marks::of_mesh)
        IAR::detect_features(m.faces(), m, feature);
      const Curvature_field whole = field_of(m.faces(), marks == Marks::of_mesh);
      std::mt19937 random(9);
      for(const std::size_t n : {10, 100, 1000})
      {
        std::size_t vertices = 0, off = 0;
        for(int k = 0; k < 20; ++k)
        {
          const std::vector<Face> range = faces_around(Face(unsigned(random() % m.number_of_faces())), n, m);
          if(marks == Marks::of_range)
            IAR::detect_features(range, m, feature);
          const Curvature_field part = field_of(range, marks != Marks::found);
          for(const Face f : range)
            for(const Vertex v : CGAL::vertices_around_face(m.halfedge(f), m))
            {
              const double ratio = part.at(v, m) / whole.at(v, m);
              ++vertices;
              off += ratio < .8 || ratio > 1.25;
            }
          if(marks == Marks::of_range)
            for(const Edge e : m.edges())
              feature[e] = false;
        }
        CHECK_MESSAGE(100 * off <= 2 * vertices, name << ", " << int(marks) << ", " << n << ": " << off << " of " << vertices);
      }
    }
}

// The rim is no curve, but where it is marked: a disk of triangles in a plane, around it quadrangles.
void a_marked_rim_is_a_curve()
{
  const std::size_t n = 40;
  Mesh m;
  for(const double r : {1., 2.})
    for(std::size_t i = 0; i < n; ++i)
      m.add_vertex(Point(r * std::cos(2 * CGAL_PI * double(i) / n), r * std::sin(2 * CGAL_PI * double(i) / n), 0));
  const Vertex centre = m.add_vertex(Point(0, 0, 0));
  for(std::size_t i = 0; i < n; ++i)
  {
    const auto vertex = [](std::size_t number) { return Vertex(unsigned(number)); };
    const std::size_t next = (i + 1) % n;
    m.add_face(centre, vertex(i), vertex(next));
    m.add_face(vertex(i), vertex(n + i), vertex(n + next), vertex(next));
  }
  std::vector<Face> triangles;
  const auto is_rim = m.add_property_map<Edge, bool>("e:rim", false).first;
  for(const Face f : m.faces())
    if(m.degree(f) == 3)
      triangles.push_back(f);
    else
      for(const auto h : CGAL::halfedges_around_face(m.halfedge(f), m))
        is_rim[m.edge(h)] = is_rim[m.edge(h)] || (!m.is_border(m.opposite(h)) && m.degree(m.face(m.opposite(h))) == 3);
  const std::pair<double, double> range(.01, 5);
  const Curvature_field plain(.001, range, triangles, m), marked(.001, range, triangles, m, parameters::edge_is_constrained_map(is_rim));
  for(std::size_t i = 0; i < n; ++i)
  {
    const Vertex v = Vertex(unsigned(i));
    CHECK_MESSAGE(plain.at(v, m) == 5 && std::abs(marked.at(v, m) / length_for(1, .001) - 1) < .02, plain.at(v, m) << " " << marked.at(v, m));
  }
}

#if CGAL_VERSION_NR >= 1060000000
void fields_of_polygon_mesh_processing_are_taken()
{
  Mesh input = meshes::to_mesh<Mesh>(meshes::torus(60, 30, .4));
  const double l = mean_edge_length(input);
  Mesh by_number = input, by_field = input, adaptive = input;
  IAR::isotropic_remeshing(l, by_number);
  IAR::isotropic_remeshing(PMP::Uniform_sizing_field<Mesh>(l, by_field), by_field);
  CHECK(meshes::Picture<Mesh>(by_number) == meshes::Picture<Mesh>(by_field));
  const PMP::Adaptive_sizing_field<Mesh> field(.02 * l, std::make_pair(l / 3, 3 * l), adaptive.faces(), adaptive);
  const IAR::Remeshing_report report = IAR::isotropic_remeshing(adaptive.faces(), field, adaptive);
  CHECK(report.angles_after.minimum > 40 && report.angles_after.maximum < 90);
}
#endif

// --- what is refused ---------------------------------------------------------------------------------------------

// Lengths that all but vanish at a point, as towards the tip of a crack, need few faces: as many in a ring of half the size.
void lengths_may_vanish_at_a_point()
{
  const Mesh input = meshes::to_mesh<Mesh>(meshes::sphere(2));
  const Point tip = input.point(*input.vertices().begin());
  for(const double least : {1e-3, 1e-5})
  {
    if(meshes::is_small_run() && least < 1e-3)
      continue;
    Mesh m = input;
    IAR::isotropic_remeshing([&](const Point& p) { return (std::max)(least, .4 * std::sqrt(CGAL::squared_distance(p, tip))); }, m);
    CHECK(CGAL::is_valid_polygon_mesh(m));
    CHECK_MESSAGE(m.number_of_faces() > input.number_of_faces() && m.number_of_faces() < 4000, least << ": " << m.number_of_faces());
  }
}

void bad_lengths_are_refused()
{
  const Mesh input = meshes::to_mesh<Mesh>(meshes::sphere(2));
  const double bad_values[] = {0., -1., std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()};
  for(const double bad : bad_values)
  {
    Mesh m = input;
    CHECK_THROWS_WITH_TEXT(IAR::isotropic_remeshing([=](const Point& p) { return p.z() > .5 ? bad : .1; }, m),
                           CGAL::Precondition_exception, "the sizing field is ");
    CHECK(meshes::Picture<Mesh>(m) == meshes::Picture<Mesh>(input));
    CHECK_THROWS_WITH_TEXT(IAR::isotropic_remeshing(IAR::Uniform_sizing_field<Mesh>(bad, m), m),
                           CGAL::Precondition_exception, "the sizing field is");
    CHECK(meshes::Picture<Mesh>(m) == meshes::Picture<Mesh>(input));
  }
  Mesh m = input;
  // Good at the vertices of the input, bad later on: the run ends, and the mesh is as it was.
  std::size_t calls = 0;
  const auto late = [&](const Point&) { return ++calls > 3 * input.number_of_vertices() ? 0. : .1; };
  CHECK_THROWS_WITH_TEXT(IAR::isotropic_remeshing(std::cref(late), m), CGAL::Precondition_exception, "the sizing field is 0");
  CHECK(meshes::Picture<Mesh>(m) == meshes::Picture<Mesh>(input));
  const auto throwing = [&](const Point&) -> double { throw std::runtime_error("no length"); };
  CHECK_THROWS_WITH_TEXT(IAR::isotropic_remeshing(throwing, m), std::runtime_error, "no length");
  CHECK(meshes::Picture<Mesh>(m) == meshes::Picture<Mesh>(input));
  CHECK_THROWS_WITH_TEXT(IAR::isotropic_remeshing(IAR::Face_count(0).scaling(Ramp(input)), m), CGAL::Precondition_exception,
                         "the wanted number of faces is 0");
  CHECK_THROWS_WITH_TEXT(IAR::isotropic_remeshing([](const Point&) { return 1e-9; }, m), CGAL::Precondition_exception, "so small");

  // Lengths that nothing can be compared with: hardly any, and far too long ones, which stand for no bound.
  struct Two_lengths
  {
    double left, right;
    double at(Vertex v, const Mesh& mesh) const { return mesh.point(v).x() < .5 ? left : right; }
  };
  const double longest = (std::numeric_limits<double>::max)();
  CHECK_THROWS_WITH_TEXT(IAR::isotropic_remeshing(Two_lengths{1e-200, 2e-200}, m), CGAL::Precondition_exception, "so small");
  CHECK_THROWS_WITH_TEXT(IAR::isotropic_remeshing(Two_lengths{longest, 1e-200}, m), CGAL::Precondition_exception, "so small");
  // Small only where the input has no vertex.
  Mesh square = meshes::to_mesh<Mesh>(meshes::square(1));
  const auto pit = [](const Point& p) { return CGAL::square(p.x() - .5) + CGAL::square(p.y() - .5) < .49 ? 1e-7 : 1.; };
  CHECK_THROWS_WITH_TEXT(IAR::isotropic_remeshing(pit, square), CGAL::Precondition_exception, "so small");
  CHECK(square.number_of_faces() == 2);
  for(const Two_lengths& field : {Two_lengths{longest, .1}, Two_lengths{.1, longest}})
  {
    Mesh half_bounded = input;
    IAR::isotropic_remeshing(field, half_bounded);
    CHECK(CGAL::is_valid_polygon_mesh(half_bounded) && half_bounded.number_of_faces() > input.number_of_faces());
  }

  const auto construct = [&](double tolerance, double low, double high, double gradation) {
    return Curvature_field(tolerance, {low, high}, m.faces(), m, parameters::default_values(), gradation);
  };
  for(const double bad : bad_values)
  {
    CHECK_THROWS_WITH_TEXT(construct(bad, .1, 1, .3), CGAL::Precondition_exception, "the tolerance is");
    CHECK_THROWS_WITH_TEXT(construct(.1, bad, 1, .3), CGAL::Precondition_exception, "the range of lengths is");
    if(!(bad > 0))
      CHECK_THROWS_WITH_TEXT(construct(.1, .1, 1, bad), CGAL::Precondition_exception, "the gradation is");
  }
  CHECK_THROWS_WITH_TEXT(construct(.1, 1, .5, .3), CGAL::Precondition_exception, "the range of lengths is");
}

// Features and the border stay where they are, and their edges have the field's lengths.
void curves_follow_the_field()
{
  const Mesh input = meshes::to_mesh<Mesh>(meshes::cube(10));
  const Ramp ramp(input);
  Mesh m = input;
  IAR::isotropic_remeshing(ramp, m);
  std::vector<double> ratios;
  double total = 0;
  for(const Edge e : m.edges())
  {
    const Point p = CGAL::midpoint(m.point(m.vertex(e, 0)), m.point(m.vertex(e, 1)));
    int extreme = 0;
    for(int k = 0; k < 3; ++k)
      extreme += std::abs(p[k]) < 1e-9 || std::abs(p[k] - 1) < 1e-9;
    if(extreme < 2)
      continue;
    total += length_of(e, m);
    ratios.push_back(length_of(e, m) / ramp(p));
  }
  CHECK_MESSAGE(std::abs(total - 12) < 1e-9, total);
  std::size_t fitting = 0;
  for(const double r : ratios)
    fitting += r >= .6 && r <= 1.5;
  CHECK_MESSAGE(fitting >= .95 * ratios.size(), fitting << " of " << ratios.size());
}

// --- attributes --------------------------------------------------------------------------------------------------

// A sum of spherical harmonics.
double harmonic(const Point& p)
{
  const double r = std::sqrt(CGAL::squared_distance(p, Point(0, 0, 0))), x = p.x() / r, y = p.y() / r, z = p.z() / r;
  return 3 * x * y * z + .5 * (5 * z * z * z - 3 * z) + x * x - y * y;
}

// The root mean square of the error of the values, linear on faces, over points on the faces; and at the vertices alone.
struct Error
{
  double on_faces = 0, at_vertices = 0;
};

Error error(const Mesh& m, Mesh::Property_map<Vertex, double> value)
{
  Error result;
  double area = 0;
  for(const Face f : m.faces())
  {
    std::array<Vertex, 3> v;
    std::size_t n = 0;
    for(const Vertex w : m.vertices_around_face(m.halfedge(f)))
      v[n++] = w;
    const double part = std::sqrt(CGAL::squared_area(m.point(v[0]), m.point(v[1]), m.point(v[2])));
    for(int i = 1; i < 6; ++i)
      for(int j = 1; i + j < 6; ++j)
      {
        const double a = i / 6., b = j / 6., c = 1 - a - b;
        const Point q = CGAL::barycenter(m.point(v[0]), a, m.point(v[1]), b, m.point(v[2]), c);
        const double e = a * value[v[0]] + b * value[v[1]] + c * value[v[2]] - harmonic(q);
        result.on_faces += part * e * e;
        area += part;
      }
  }
  for(const Vertex v : m.vertices())
    result.at_vertices += CGAL::square(value[v] - harmonic(m.point(v)));
  result.on_faces = std::sqrt(result.on_faces / area);
  result.at_vertices = std::sqrt(result.at_vertices / m.number_of_vertices());
  return result;
}

// Values at the vertices of the result are as near to the truth as the input's are in between.
void scalars_are_interpolated()
{
  const Mesh input = meshes::to_mesh<Mesh>(meshes::sphere(4));
  for(const double factor : {.5, 1., 2.})
  {
    Mesh m = input;
    const auto value = m.add_property_map<Vertex, double>("v:value", 0).first;
    for(const Vertex v : m.vertices())
      value[v] = harmonic(m.point(v));
    const Error before = error(m, value);
    IAR::Attribute_transfer<Mesh> transfer;
    transfer.add_vertex_map(value);
    IAR::isotropic_remeshing(factor * mean_edge_length(input), m, parameters::visitor(std::ref(transfer)));
    const Error after = error(m, value);
    CHECK_MESSAGE(after.at_vertices <= 1.5 * before.on_faces, factor << ": " << after.at_vertices << " " << before.on_faces);
    if(factor < 1)
      CHECK_MESSAGE(after.on_faces <= 1.5 * before.on_faces, factor << ": " << after.on_faces << " " << before.on_faces);
  }
}

// What is smooth is carried over as if it had been known all along, again and again: linear values on the result's faces are about as near
// to the truth as the true ones at its vertices would be.
void smooth_functions_do_not_wear_off()
{
  Mesh m = meshes::to_mesh<Mesh>(meshes::sphere(4));
  const double length = mean_edge_length(m);
  const auto smooth = m.add_property_map<Vertex, double>("v:smooth", 0).first, truth = m.add_property_map<Vertex, double>("v:truth", 0).first;
  for(const Vertex v : m.vertices())
    smooth[v] = harmonic(m.point(v));
  const Error before = error(m, smooth);
  for(int run = 0; run < 5; ++run)
  {
    IAR::Attribute_transfer<Mesh> transfer;
    transfer.add_smooth_vertex_map(smooth, m);
    IAR::isotropic_remeshing((run % 2 == 0 ? 1. : .7) * length, m, parameters::visitor(transfer));
    for(const Vertex v : m.vertices())
      truth[v] = harmonic(m.point(v));
    const Error after = error(m, smooth);
    CHECK_MESSAGE(after.at_vertices <= .1 * before.on_faces, run << ": " << after.at_vertices << " " << before.on_faces);
    CHECK_MESSAGE(after.on_faces <= 1.15 * error(m, truth).on_faces, run << ": " << after.on_faces << " " << error(m, truth).on_faces);
    CHECK_MESSAGE(after.on_faces <= 1.1 * before.on_faces, run << ": " << after.on_faces << " " << before.on_faces);
  }
}

// In the plane quadratic functions are reproduced, at its border, too, in any unit of length; points are, on any surface, where they lie.
void quadratic_functions_are_kept()
{
  const auto quadratic = [](double x, double y) { return 1 + 2 * x - y + 3 * x * x - 4 * x * y + .5 * y * y; };
  for(const double unit : {1., 1e-100, 1e100})
  {
    Mesh m = meshes::to_mesh<Mesh>(meshes::square(8));
    std::mt19937 random(7);
    for(const Vertex v : m.vertices())
    {
      const Point p = m.point(v);
      const auto shifted = [&](double x) { return x > .01 && x < .99 ? x + std::uniform_real_distribution<>(-.03, .03)(random) : x; };
      m.point(v) = Point(unit * shifted(p.x()), unit * shifted(p.y()), 0);
    }
    using Values = std::array<float, 2>;
    const auto value = m.add_property_map<Vertex, double>("v:value", 0).first;
    const auto values = m.add_property_map<Vertex, Values>("v:values").first;
    const auto place = m.add_property_map<Vertex, Point>("v:place").first;
    for(const Vertex v : m.vertices())
    {
      value[v] = quadratic(m.point(v).x() / unit, m.point(v).y() / unit);
      values[v] = {float(value[v]), float(-value[v])};
      place[v] = m.point(v);
    }
    IAR::Attribute_transfer<Mesh> transfer;
    transfer.add_smooth_vertex_map(value, m);
    transfer.add_smooth_vertex_map(values, m, parameters::vertex_point_map(m.points()));
    transfer.add_smooth_vertex_map(place, m);
    IAR::isotropic_remeshing(.6 * mean_edge_length(m), m, parameters::visitor(transfer));
    for(const Vertex v : m.vertices())
    {
      const double x = m.point(v).x() / unit, y = m.point(v).y() / unit;
      CHECK_MESSAGE(std::abs(value[v] - quadratic(x, y)) < 1e-9, m.point(v) << ": " << value[v] << " " << quadratic(x, y));
      CHECK(std::abs(values[v][0] - value[v]) < 1e-4 && std::abs(values[v][1] + value[v]) < 1e-4);
      CHECK(std::abs(place[v].x() / unit - x) < 1e-9 && std::abs(place[v].y() / unit - y) < 1e-9 && place[v].z() == 0);
    }
  }
}

// What is not smooth, on whatever surface, comes out finite, and not far beyond the values that there are.
void anything_can_be_taken_for_smooth()
{
  std::vector<std::pair<const char*, Mesh>> inputs;
  inputs.emplace_back("cube", meshes::to_mesh<Mesh>(meshes::cube(3)));
  inputs.emplace_back("cube with caps", meshes::to_mesh<Mesh>(meshes::cube_with_caps(3)));
  inputs.emplace_back("tetrahedron", meshes::to_mesh<Mesh>(meshes::tetrahedron()));
  inputs.emplace_back("octahedron", meshes::to_mesh<Mesh>(meshes::octahedron()));
  inputs.emplace_back("one square", meshes::to_mesh<Mesh>(meshes::square(1)));
  inputs.emplace_back("fans", meshes::to_mesh<Mesh>(meshes::turned({{1, 0}, {1, .5}}, 200, false)));
  inputs.emplace_back("wall", meshes::to_mesh<Mesh>(meshes::turned(meshes::wall_with_round_ends(), 24, true)));
  for(auto& [name, m] : inputs)
  {
    const auto value = m.add_property_map<Vertex, double>("v:value", 0).first;
    const auto height = m.add_property_map<Vertex, double>("v:height", 0).first;
    std::mt19937 random(3);
    for(const Vertex v : m.vertices())
    {
      value[v] = std::uniform_real_distribution<>(-1, 1)(random);
      height[v] = m.point(v).z();
    }
    IAR::Attribute_transfer<Mesh> transfer;
    transfer.add_smooth_vertex_map(value, m);
    transfer.add_smooth_vertex_map(height, m);
    IAR::isotropic_remeshing(.4 * mean_edge_length(m), m, parameters::visitor(transfer));
    for(const Vertex v : m.vertices())
    {
      CHECK_MESSAGE(std::abs(value[v]) <= 3, name << ": " << value[v]);
      CHECK_MESSAGE(std::isfinite(height[v]), name << ": " << height[v]);
    }
  }
}

// Linear functions of the position are carried over as exactly as the result lies on the input: in the plane, to rounding.
void linear_functions_are_kept()
{
  Mesh m = meshes::to_mesh<Mesh>(meshes::square(7));
  using Colour = std::array<float, 3>;
  const auto colour = m.add_property_map<Vertex, Colour>("v:colour").first;
  const auto vector = m.add_property_map<Vertex, Vector>("v:vector").first;
  const auto texture = m.add_property_map<Vertex, Kernel::Point_2>("v:texture").first;
  const auto rounded = m.add_property_map<Vertex, CGAL::IO::Color>("v:color").first;
  const auto id = m.add_property_map<Vertex, int>("v:id", -1).first;
  const auto channel = [](double x) { return static_cast<unsigned char>(std::lround(250 * x)); };
  for(const Vertex v : m.vertices())
  {
    const Point p = m.point(v);
    colour[v] = {float(p.x()), float(p.y()), .5f};
    rounded[v] = CGAL::IO::Color(channel(p.x()), channel(p.y()), 255, 0);
    vector[v] = Vector(p.y(), 2 * p.x(), 1);
    texture[v] = Kernel::Point_2(3 * p.x(), p.y() - 1);
    id[v] = p.x() < .5 ? 1 : 2;
  }
  IAR::Attribute_transfer<Mesh> transfer;
  transfer.add_vertex_map(colour);
  transfer.add_vertex_map(rounded);
  transfer.add_vertex_map(vector);
  transfer.add_vertex_map(texture);
  transfer.add_vertex_map(id, IAR::Nearest_value());
  for(int run = 0; run < 2; ++run)     // the helper can be used again, itself or a copy
  {
    if(run == 0)
      IAR::isotropic_remeshing(.4 * mean_edge_length(m), m, parameters::visitor(transfer));
    else
      IAR::isotropic_remeshing(1.7 * mean_edge_length(m), m, parameters::visitor(std::ref(transfer)));
    for(const Vertex v : m.vertices())
    {
      const Point p = m.point(v);
      CHECK(std::abs(colour[v][0] - p.x()) < 1e-5 && std::abs(colour[v][1] - p.y()) < 1e-5 && colour[v][2] == .5f);
      // each of the runs, and the input, rounds by half of a step
      CHECK(std::abs(rounded[v].red() - 250 * p.x()) < 2 && std::abs(rounded[v].green() - 250 * p.y()) < 2);
      CHECK(rounded[v].blue() == 255 && rounded[v].alpha() == 0);
      CHECK(CGAL::squared_distance(CGAL::ORIGIN + vector[v], Point(p.y(), 2 * p.x(), 1)) < 1e-20);
      CHECK(CGAL::squared_distance(texture[v], Kernel::Point_2(3 * p.x(), p.y() - 1)) < 1e-20);
      CHECK(id[v] == 1 || id[v] == 2);
      if(std::abs(p.x() - .5) > .2)
        CHECK_MESSAGE(id[v] == (p.x() < .5 ? 1 : 2), p << ": " << id[v]);
    }
  }
}

Vector unit_normal(Face f, const Mesh& m)
{
  const Vector n = normal(f, m);
  return n / std::sqrt(n.squared_length());
}

// Faces take the attributes of where they lie; with patches, exactly. Vertices that stay keep their values to the last bit.
void faces_and_kept_vertices()
{
  Mesh m = meshes::to_mesh<Mesh>(meshes::cube(6));
  const auto side = m.add_property_map<Face, std::string>("f:side").first;
  const auto name_of = [](const Vector& n) {
    return std::string(std::abs(n.x()) > .5 ? "x" : std::abs(n.y()) > .5 ? "y" : "z") + (n.x() + n.y() + n.z() > 0 ? "+" : "-");
  };
  for(const Face f : m.faces())
    side[f] = name_of(unit_normal(f, m));
  const auto is_side_x = m.add_property_map<Face, bool>("f:x", false).first;
  for(const Face f : m.faces())
    is_side_x[f] = side[f][0] == 'x';
  const auto value = m.add_property_map<Vertex, double>("v:value", 0).first;
  const auto is_kept = m.add_property_map<Vertex, bool>("v:kept", false).first;
  std::mt19937 random(3);
  std::map<Vertex, double> kept;
  for(const Vertex v : m.vertices())
  {
    value[v] = std::uniform_real_distribution<double>(0, 1)(random);
    if(random() % 5 == 0)
    {
      is_kept[v] = true;
      kept[v] = value[v];
    }
  }
  IAR::Attribute_transfer<Mesh> transfer;
  transfer.add_face_map(side);
  transfer.add_face_map(is_side_x);
  transfer.add_vertex_map(value);
  IAR::isotropic_remeshing(.7 * mean_edge_length(m), m, parameters::visitor(std::ref(transfer)).vertex_is_constrained_map(is_kept));
  for(const Face f : m.faces())
    CHECK_MESSAGE(side[f] == name_of(unit_normal(f, m)) && is_side_x[f] == (side[f][0] == 'x'), side[f]);
  for(const auto& [v, x] : kept)
    CHECK(!m.is_removed(v) && value[v] == x);
  for(const Vertex v : m.vertices())
    CHECK(value[v] >= 0 && value[v] <= 1);
}

// That of the input's face at the centroid, wherever flips have taken the face from: hardly further than the closest one.
void faces_are_those_at_the_centroids()
{
  for(const char* name : {"hand", "homer"})
  {
    Mesh m = models::of_cgal(name);
    const Mesh input = m;
    const double length = .4 * mean_edge_length(m);
    const auto number = m.add_property_map<Face, std::size_t>("f:number").first;
    for(const Face f : m.faces())
      number[f] = f;
    IAR::Attribute_transfer<Mesh> transfer;
    transfer.add_face_map(number);
    IAR::isotropic_remeshing(length, m, parameters::visitor(std::ref(transfer)));
    const IAR::Closest_point_projector<Mesh> projector(input);
    std::size_t far_ones = 0;
    for(const Face f : m.faces())
    {
      const auto triangle_of = [](const Mesh& g, Face face) {
        const Halfedge h = g.halfedge(face);
        return Kernel::Triangle_3(g.point(g.source(h)), g.point(g.target(h)), g.point(g.target(g.next(h))));
      };
      const Point c = CGAL::centroid(triangle_of(m, f));
      far_ones += std::sqrt(CGAL::squared_distance(c, triangle_of(input, Face(Mesh::size_type(number[f]))))) >
                  std::sqrt(CGAL::squared_distance(c, projector.project(c))) + .3 * length;
    }
    CHECK_MESSAGE(far_ones == 0, name << ": " << far_ones);
  }
}

// With a projector of the user's, or none, the input is asked all the same.
void attributes_with_every_projector()
{
  const Mesh input = meshes::to_mesh<Mesh>(meshes::sphere(3));
  const auto run = [&](const auto& np) {
    Mesh m = input;
    const auto place = m.add_property_map<Vertex, Point>("v:place").first;
    for(const Vertex v : m.vertices())
      place[v] = m.point(v);
    IAR::Attribute_transfer<Mesh> transfer;
    transfer.add_vertex_map(place);
    IAR::isotropic_remeshing(.8 * mean_edge_length(input), m, np.visitor(std::ref(transfer)));
    for(const Vertex v : m.vertices())
      CHECK_MESSAGE(CGAL::squared_distance(place[v], m.point(v)) < CGAL::square(.25 * mean_edge_length(input)),
                    place[v] << " " << m.point(v));
  };
  run(parameters::do_project(true));
  run(parameters::do_project(false));
  run(parameters::projection_functor([](const Point& p) { return p; }));
  run(parameters::projection_functor([](Vertex) { return Point(); }).do_project(false));
  const IAR::Closest_point_projector<Mesh> projector(input);
  run(parameters::projection_functor(std::ref(projector)));
}

// Faces have the attribute of a face of their own patch, whichever patch is nearest; and named parameters that have a name are taken.
void attributes_stay_in_their_patches(const std::string& name)
{
  const Mesh input = models::of_cgal(name);
  CGAL::Bbox_3 box;
  for(const Vertex v : input.vertices())
    box += input.point(v).bbox();
  const auto run = [&](const auto& np) {
    Mesh m = input;
    const auto patch = m.add_property_map<Face, int>("f:patch").first, attribute = m.add_property_map<Face, int>("f:attribute").first;
    for(const Face f : m.faces())
      attribute[f] = patch[f] = int(5 * (m.point(m.target(m.halfedge(f))).x() - box.xmin()) / (box.xmax() - box.xmin()));
    IAR::Attribute_transfer<Mesh> transfer;
    transfer.add_face_map(attribute);
    auto all = np.face_patch_map(patch).visitor(std::ref(transfer));
    IAR::isotropic_remeshing(IAR::Face_count(input.number_of_faces() / 10), m, all);
    const auto others = std::count_if(m.faces_begin(), m.faces_end(), [&](Face f) { return attribute[f] != patch[f]; });
    CHECK_MESSAGE(others == 0, name << ", " << others);
  };
  run(parameters::do_project(true));
  run(parameters::do_project(false));
  run(parameters::projection_functor([](const Point& p) { return p; }));
}

// --- attributes of corners ---------------------------------------------------------------------------------------

// Checks that the attribute of corners has seams at the marked edges, and nowhere else.
// Vertices, corners and faces have the number of their part, whose borders or sheets lie on each other or close together.
void attributes_stay_in_their_parts(const std::vector<Soup>& parts, double length)
{
  Soup soup;
  std::vector<std::size_t> first_face;
  for(const Soup& part : parts)
  {
    const std::size_t offset = soup.points.size();
    first_face.push_back(soup.faces.size());
    soup.points.insert(soup.points.end(), part.points.begin(), part.points.end());
    for(auto face : part.faces)
    {
      for(std::size_t& v : face)
        v += offset;
      soup.faces.push_back(face);
    }
  }
  const Mesh input = meshes::to_mesh<Mesh>(soup);
  const auto run = [&](const auto& np)
  {
    Mesh m = input;
    const auto of_vertex = m.add_property_map<Vertex, double>("v:part", -1).first;
    const auto of_corner = m.add_property_map<Mesh::Halfedge_index, double>("h:part", -1).first;
    const auto of_face = m.add_property_map<Face, int>("f:part", -1).first;
    for(const Face f : m.faces())
    {
      of_face[f] = int(std::upper_bound(first_face.begin(), first_face.end(), std::size_t(f)) - first_face.begin());
      for(const auto h : halfedges_around_face(m.halfedge(f), m))
        of_vertex[m.target(h)] = of_corner[h] = of_face[f];
    }
    IAR::Attribute_transfer<Mesh> transfer;
    transfer.add_vertex_map(of_vertex);
    transfer.add_corner_map(of_corner);
    transfer.add_face_map(of_face);
    IAR::isotropic_remeshing(length, m, np.visitor(std::ref(transfer)));
    m.collect_garbage();
    const auto component = m.add_property_map<Face, std::size_t>("f:component", 0).first;
    CHECK(PMP::connected_components(m, component) == parts.size());
    std::map<std::size_t, std::set<double>> values;
    for(const Face f : m.faces())
    {
      values[component[f]].insert(of_face[f]);
      for(const auto h : halfedges_around_face(m.halfedge(f), m))
        values[component[f]].insert({of_vertex[m.target(h)], of_corner[h]});
    }
    for(const auto& [c, of_component] : values)
      CHECK_MESSAGE(*of_component.rbegin() - *of_component.begin() < 1e-9,
                    c << ": " << *of_component.begin() << " to " << *of_component.rbegin());
  };
  run(parameters::do_project(true));
  run(parameters::do_project(false));
  run(parameters::projection_functor([](const Point& p) { return p; }));
  const IAR::Closest_point_projector<Mesh> first(meshes::to_mesh<Mesh>(parts[0]));
  run(parameters::projection_functor(std::cref(first)));
}

void attributes_stay_in_their_parts()
{
  const auto moved = [](Soup soup, double x, double scale)
  {
    for(auto& p : soup.points)
      p = {x + scale * p[0], scale * p[1], scale * p[2]};
    return soup;
  };
  Soup inner = meshes::sphere(3);
  for(auto& p : inner.points)
    for(double& x : p)
      x *= .98;
  for(auto& face : inner.faces)
    std::swap(face[0], face[1]);
  attributes_stay_in_their_parts({meshes::square(10), moved(meshes::square(14), 1, 1)}, .06);
  attributes_stay_in_their_parts({meshes::sphere(3), inner}, .3);
}

template <class Marks>
void seams_are_the_marked_edges(const Mesh& m, const IAR::Attribute_transfer<Mesh>& transfer, const Marks& is_marked)
{
  std::map<Edge, bool> is_seam;
  const std::size_t seams = transfer.mark_seams(m, boost::make_assoc_property_map(is_seam));
  CHECK(seams == is_seam.size() && seams > 0);
  for(const Edge e : m.edges())
    if(!m.is_border(e))
      CHECK_MESSAGE(is_marked[e] == (is_seam.count(e) > 0), m.point(m.vertex(e, 0)) << " to " << m.point(m.vertex(e, 1)));
}

// Texture coordinates go around a torus twice, and jump where they begin anew.
constexpr double TORUS_RADIUS = .4;
using Texture = Mesh::Property_map<Halfedge, Kernel::Point_2>;

Kernel::Point_2 place_on_torus(const Point& p)
{
  const double pi = std::acos(-1.), to_axis = std::hypot(p.x(), p.y());
  const auto turns = [&](double y, double x) {
    const double t = std::atan2(y, x) / (2 * pi);
    return t < -1e-9 ? t + 1 : (std::max)(t, 0.);
  };
  return {turns(p.y(), p.x()), turns(p.z(), to_axis - 1)};
}
Point point_on_torus(const Kernel::Point_2& t)
{
  const double a = 2 * std::acos(-1.) * t.x(), b = 2 * std::acos(-1.) * t.y(), to_axis = 1 + TORUS_RADIUS * std::cos(b);
  return {to_axis * std::cos(a), to_axis * std::sin(a), TORUS_RADIUS * std::sin(b)};
}
Texture texture_of_torus(Mesh& m)
{
  const Texture texture = m.add_property_map<Halfedge, Kernel::Point_2>("h:texture").first;
  for(const Face f : m.faces())
  {
    std::array<double, 2> largest{0, 0};
    for(const Halfedge h : m.halfedges_around_face(m.halfedge(f)))
      for(int k = 0; k < 2; ++k)
        largest[k] = (std::max)(largest[k], place_on_torus(m.point(m.target(h)))[k]);
    for(const Halfedge h : m.halfedges_around_face(m.halfedge(f)))
    {
      const Kernel::Point_2 t = place_on_torus(m.point(m.target(h)));
      texture[h] = {t.x() + (largest[0] - t.x() > .5), t.y() + (largest[1] - t.y() > .5)};
    }
  }
  return texture;
}

void texture_coordinates_keep_their_seams()
{
  const Mesh input = meshes::to_mesh<Mesh>(meshes::torus(48, 20, TORUS_RADIUS));
  const auto run = [&](double factor, const auto& np) {
    Mesh m = input;
    const Texture texture = texture_of_torus(m);
    const auto is_marked = m.add_property_map<Edge, bool>("e:marked", false).first;
    IAR::Attribute_transfer<Mesh> transfer;
    transfer.add_corner_map(texture);
    CHECK(transfer.mark_seams(m, is_marked) == 48 + 20);
    IAR::isotropic_remeshing(factor * mean_edge_length(input), m, np.visitor(std::ref(transfer)).edge_is_constrained_map(is_marked));
    seams_are_the_marked_edges(m, transfer, is_marked);
    for(const Face f : m.faces())
      for(const Halfedge h : m.halfedges_around_face(m.halfedge(f)))
      {
        const Kernel::Point_2 t = texture[h], next = texture[m.next(h)];
        CHECK_MESSAGE(CGAL::squared_distance(point_on_torus(t), m.point(m.target(h))) < CGAL::square(.2 * mean_edge_length(input)),
                      factor << ": " << t << " at " << m.point(m.target(h)));
        CHECK(t.x() >= 0 && t.x() <= 1 && t.y() >= 0 && t.y() <= 1);
        CHECK(std::abs(t.x() - next.x()) < .5 && std::abs(t.y() - next.y()) < .5);
      }
  };
  for(const double factor : {.5, 1., 2.})
    run(factor, parameters::do_project(true));
  run(.8, parameters::do_project(false));
  run(.8, parameters::projection_functor([](const Point& p) { return p; }));
  const IAR::Closest_point_projector<Mesh> projector(input);
  run(.8, parameters::projection_functor(std::ref(projector)));
  run(.5, parameters::protect_constraints(true));
}

double volume(const Mesh& m)
{
  double sum = 0;
  for(const Face f : m.faces())
  {
    const Halfedge h = m.halfedge(f);
    sum += CGAL::volume(Point(0, 0, 0), m.point(m.source(h)), m.point(m.target(h)), m.point(m.target(m.next(h))));
  }
  return sum;
}

// Of radius 1 and height 3, with a wall of .03 and unsplit sides.
Mesh thin_tube()
{
  return meshes::to_mesh<Mesh>(meshes::turned({{.97, 0}, {1, 0}, {1, 3}, {.97, 3}}, 96, true));
}

// With a target length nearly as long as the radius: functions yield at small details as numbers do, and so do lengths that are looked for.
// These end at any length, and each has its own luck with walls so thin: five are looked at together.
void thin_walls_stay_with_functions_and_numbers_of_faces()
{
  const double expected = volume(thin_tube());
  CHECK(std::abs(expected - .557) < .001);
  const auto check = [&](const auto& length, const char* what) {
    Mesh m = thin_tube();
    const std::size_t crossing_faces = IAR::isotropic_remeshing(length, m).crossing_faces;
    CHECK_MESSAGE(std::abs(volume(m) - expected) < .1 && crossing_faces == 0,
                  what << ": " << volume(m) << ", " << crossing_faces << " crossing faces, " << m.number_of_faces());
  };
  check(.8, "a number");
  check([](const Point&) { return .8; }, "a function");
  double sum = 0;
  int crossing = 0;
  const std::vector<std::size_t> numbers{500, 550, 600, 650, 700};
  for(const std::size_t n : numbers)
  {
    Mesh m = thin_tube();
    const std::size_t crossing_faces = IAR::isotropic_remeshing(IAR::Face_count(n), m).crossing_faces;
    CHECK_MESSAGE(crossing_faces < 20, n << " faces: " << crossing_faces << " cross others");
    crossing += crossing_faces > 0;
    sum += volume(m);
  }
  CHECK_MESSAGE(std::abs(sum / double(numbers.size()) - expected) < .3 && crossing <= 1, sum / double(numbers.size()) << ", " << crossing);
}

// Half of a ball is to be much finer than the rest: the rest is as near to the surface as if all were coarse.
void a_fine_part_takes_nothing_from_the_rest()
{
  const Mesh input = meshes::to_mesh<Mesh>(meshes::sphere(5));
  const auto mean_height = [&](double fine) {
    Mesh m = input;
    IAR::isotropic_remeshing([=](const Point& p) { return p.x() < 0 ? fine : .4; }, m);
    double sum = 0, area = 0;
    for(const Face f : m.faces())
    {
      const Halfedge h = m.halfedge(f);
      const Point a = m.point(m.source(h)), b = m.point(m.target(h)), c = m.point(m.target(m.next(h))), center = CGAL::centroid(a, b, c);
      if(center.x() < .5)
        continue;
      const double weight = std::sqrt(CGAL::squared_area(a, b, c));
      sum += weight * (std::sqrt((center - CGAL::ORIGIN).squared_length()) - 1);
      area += weight;
    }
    return sum / area;
  };
  const double coarse = mean_height(.4), mixed = mean_height(.01);
  CHECK_MESSAGE(std::abs(mixed) < 2 * std::abs(coarse) + .001, coarse << " " << mixed);
}

// Where faces beside the range are divided, the parts have what their face had: corners a linear function, without a seam along the rim,
// and, with a seam there, the number of the side on which they are; faces their number.
void divided_faces_outside_the_range_have_their_part()
{
  Mesh m = meshes::to_mesh<Mesh>(meshes::square(6));
  const auto value = [](const Point& p) { return Kernel::Point_2(3 * p.x() - p.y(), p.y()); };
  const auto texture = m.add_property_map<Halfedge, Kernel::Point_2>("h:texture").first;
  const auto side = m.add_property_map<Halfedge, double>("h:side", 2).first;
  const auto number = m.add_property_map<Face, int>("f:number", -1).first;
  const auto cell = [&](Face f) {
    const Halfedge h = m.halfedge(f);
    const Point c = CGAL::centroid(m.point(m.source(h)), m.point(m.target(h)), m.point(m.target(m.next(h))));
    return 6 * int(6 * c.y()) + int(6 * c.x());
  };
  std::vector<Face> range;
  for(const Face f : m.faces())
  {
    number[f] = cell(f);
    if(number[f] % 6 < 3)
      range.push_back(f);
    for(const Halfedge h : m.halfedges_around_face(m.halfedge(f)))
    {
      texture[h] = value(m.point(m.target(h)));
      if(number[f] % 6 < 3)
        side[h] = 1;
    }
  }
  IAR::Attribute_transfer<Mesh> transfer;
  transfer.add_corner_map(texture);
  transfer.add_corner_map(side);
  transfer.add_face_map(number);
  IAR::Recipe recipe;
  recipe.split_rim = true;
  const std::size_t outside = m.number_of_faces() - range.size();
  const IAR::Remeshing_report report = IAR::isotropic_remeshing(range, .04, m, IAR::recipe(recipe, parameters::visitor(std::ref(transfer))));
  CHECK(m.number_of_faces() > report.output_faces + outside);
  for(const Face f : m.faces())
  {
    const Halfedge begin = m.halfedge(f);
    bool is_outside = true;
    for(const Halfedge h : m.halfedges_around_face(begin))
    {
      CHECK(CGAL::squared_distance(texture[h], value(m.point(m.target(h)))) < 1e-20);
      is_outside = is_outside && m.point(m.target(h)).x() > .5 - 1e-12;
    }
    if(is_outside)
      CHECK_MESSAGE(number[f] == cell(f), number[f] << " " << cell(f));
    for(const Halfedge h : m.halfedges_around_face(begin))
    {
      CHECK(std::abs(side[h] - (is_outside ? 2 : 1)) < 1e-12);
      CHECK(m.is_border(m.opposite(h)) || texture[h] == texture[m.prev(m.opposite(h))]);
    }
  }
}

// Outside the range corners keep their values to the last bit, and so do those that they share with it.
void corners_outside_the_range_are_kept()
{
  Mesh m = meshes::to_mesh<Mesh>(meshes::torus(48, 20, TORUS_RADIUS));
  const double length = .5 * mean_edge_length(m);
  const Texture texture = texture_of_torus(m);
  const auto is_marked = m.add_property_map<Edge, bool>("e:marked", false).first;
  std::vector<Face> range;
  std::map<Halfedge, Kernel::Point_2> outside;
  for(const Face f : m.faces())
    if(m.point(m.target(m.halfedge(f))).x() > .3)
      range.push_back(f);
    else
      for(const Halfedge h : m.halfedges_around_face(m.halfedge(f)))
        outside[h] = texture[h];
  IAR::Attribute_transfer<Mesh> transfer;
  transfer.add_corner_map(texture);
  transfer.mark_seams(m, is_marked);
  IAR::isotropic_remeshing(range, length, m, parameters::visitor(std::ref(transfer)).edge_is_constrained_map(is_marked));
  for(const auto& [h, t] : outside)
    CHECK(!m.is_removed(h) && texture[h] == t);
  seams_are_the_marked_edges(m, transfer, is_marked);
}

// A seam that ends inside a sheet: turns around its middle, from -.5 to .5.
void a_seam_may_end_inside()
{
  Mesh m = meshes::to_mesh<Mesh>(meshes::square(8));
  const auto turns = [&](const Point& p, bool is_above) {
    const double t = std::atan2(p.y() - .5, p.x() - .5) / (2 * std::acos(-1.));
    return std::abs(p.y() - .5) > 1e-9 ? t : p.x() > .5 - 1e-9 ? 0 : is_above ? .5 : -.5;
  };
  const auto is_above = [&](Face f) {
    double y = 0;
    for(const Vertex v : m.vertices_around_face(m.halfedge(f)))
      y += m.point(v).y() / 3;
    return y > .5;
  };
  const auto value = m.add_property_map<Halfedge, double>("h:turns", 0).first;
  const auto is_marked = m.add_property_map<Edge, bool>("e:marked", false).first;
  for(const Face f : m.faces())
    for(const Halfedge h : m.halfedges_around_face(m.halfedge(f)))
      value[h] = turns(m.point(m.target(h)), is_above(f));
  IAR::Attribute_transfer<Mesh> transfer;
  transfer.add_corner_map(value);
  CHECK(transfer.mark_seams(m, is_marked) == 4);
  IAR::isotropic_remeshing(.05, m, parameters::visitor(transfer).edge_is_constrained_map(is_marked));
  seams_are_the_marked_edges(m, transfer, is_marked);
  for(const Face f : m.faces())
    for(const Halfedge h : m.halfedges_around_face(m.halfedge(f)))
      if(const Point& p = m.point(m.target(h)); std::hypot(p.x() - .5, p.y() - .5) > .2)
        CHECK_MESSAGE(std::abs(value[h] - turns(p, is_above(f))) < .02, p << ": " << value[h]);
}

// The normals of the sides of a part, which jump at the features that are found.
void normals_jump_at_features()
{
  Mesh m = meshes::to_mesh<Mesh>(meshes::cube(6));
  const auto corner_normal = m.add_property_map<Halfedge, Vector>("h:normal").first;
  for(const Face f : m.faces())
    for(const Halfedge h : m.halfedges_around_face(m.halfedge(f)))
      corner_normal[h] = unit_normal(f, m);
  IAR::Attribute_transfer<Mesh> transfer;
  transfer.add_corner_map(corner_normal);
  IAR::isotropic_remeshing(.07, m, parameters::visitor(transfer));
  for(const Face f : m.faces())
    for(const Halfedge h : m.halfedges_around_face(m.halfedge(f)))
      CHECK((corner_normal[h] - unit_normal(f, m)).squared_length() < 1e-18);
}

// A projector of Polygon_mesh_processing's kind lends a vertex of the range during the run; that vertex keeps its value, too.
void the_lent_vertex_keeps_its_value()
{
  Mesh m = meshes::to_mesh<Mesh>(meshes::sphere(2));
  const auto value = m.add_property_map<Vertex, double>("v:value", 0).first;
  const auto is_kept = m.add_property_map<Vertex, bool>("v:kept", true).first;
  std::map<Vertex, double> before;
  for(const Vertex v : m.vertices())
    before[v] = value[v] = std::sin(double(v.idx()));
  IAR::Attribute_transfer<Mesh> transfer;
  transfer.add_vertex_map(value);
  IAR::isotropic_remeshing(.5 * mean_edge_length(m), m, parameters::visitor(std::ref(transfer))
                                                           .vertex_is_constrained_map(is_kept)
                                                           .projection_functor([&](Vertex v) { return m.point(v); }));
  CHECK(m.number_of_vertices() > before.size());
  for(const auto& [v, x] : before)
    CHECK_MESSAGE(value[v] == x, v);
}

// It has its own point again when values are read.
void readers_see_the_input()
{
  struct Reader : IAR::Default_visitor
  {
    Reader(const Mesh& mesh, const Mesh& input) : mesh(mesh), input(input) {}
    void read_vertex(std::size_t, const std::array<Vertex, 3>& corners, const std::array<double, 3>&)
    {
      for(const Vertex v : corners)
        (mesh.point(v) == input.point(v) ? same : other) += 1;
    }
    void write_vertex(std::size_t, Vertex) {}
    const Mesh &mesh, &input;
    std::size_t same = 0, other = 0;
  };
  const Mesh input = meshes::to_mesh<Mesh>(meshes::sphere(2));
  Mesh m = input;
  Reader reader(m, input);
  IAR::isotropic_remeshing(.5 * mean_edge_length(m), m, parameters::visitor(std::ref(reader))
                                                           .projection_functor([&](Vertex v) { return m.point(v); }));
  CHECK(reader.same > 0);
  CHECK_MESSAGE(reader.other == 0, reader.other);
}

// Whatever throws while values are read leaves mesh and maps as they were.
void nothing_is_lost()
{
  const Mesh input = meshes::to_mesh<Mesh>(meshes::sphere(2));
  Mesh m = input;
  const auto value = m.add_property_map<Vertex, double>("v:value", 1).first;
  IAR::Attribute_transfer<Mesh> transfer;
  transfer.add_vertex_map(value, [](const std::array<double, 3>&, const std::array<double, 3>&) -> double {
    throw std::runtime_error("cannot be mixed"); });
  CHECK_THROWS_WITH_TEXT(IAR::isotropic_remeshing(.1, m, parameters::visitor(std::ref(transfer))), std::runtime_error,
                         "cannot be mixed");
  CHECK(meshes::Picture<Mesh>(m) == meshes::Picture<Mesh>(input));
  for(const Vertex v : m.vertices())
    CHECK(value[v] == 1);
}

int main()
{
  functions_of_the_position_are_followed();
  fields_are_followed_with_every_projector();
  uniform_fields_are_numbers();
  numbers_of_faces_scale_fields();
  functions_are_asked_inside_of_faces();
  details_inside_of_faces_are_found();
  curvature_of_a_sphere_and_a_torus();
  curvature_with_noise();
  curvature_at_features_and_borders();
  gradation_is_bounded();
  lengths_rise_with_the_tolerance();
  curvature_of_a_range();
  curvature_of_a_range_is_that_of_the_mesh();
  a_marked_rim_is_a_curve();
#if CGAL_VERSION_NR >= 1060000000
  fields_of_polygon_mesh_processing_are_taken();
#endif
  lengths_may_vanish_at_a_point();
  bad_lengths_are_refused();
  curves_follow_the_field();
  scalars_are_interpolated();
  smooth_functions_do_not_wear_off();
  quadratic_functions_are_kept();
  anything_can_be_taken_for_smooth();
  linear_functions_are_kept();
  faces_and_kept_vertices();
  faces_are_those_at_the_centroids();
  attributes_with_every_projector();
  for(const char* name : {"mushroom", "couplingdown", "elephant"})
    attributes_stay_in_their_patches(name);
  attributes_stay_in_their_parts();
  texture_coordinates_keep_their_seams();
  thin_walls_stay_with_functions_and_numbers_of_faces();
  a_fine_part_takes_nothing_from_the_rest();
  corners_outside_the_range_are_kept();
  divided_faces_outside_the_range_have_their_part();
  a_seam_may_end_inside();
  normals_jump_at_features();
  the_lent_vertex_keeps_its_value();
  readers_see_the_input();
  nothing_is_lost();
  return result();
}
