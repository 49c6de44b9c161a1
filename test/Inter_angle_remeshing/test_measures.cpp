// Copyright (c) 2026 The Inter_angle_remeshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The measures tell of meshes whose angles and distances are known on paper what is on the paper.

#include <CGAL/Inter_angle_remeshing/surface_distance.h>
#include <CGAL/Inter_angle_remeshing/triangle_quality.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>

#ifdef CGAL_LINKED_WITH_TBB
#  include <tbb/global_control.h>
#endif

#include "check.h"
#include "meshes.h"

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace IAR = CGAL::Inter_angle_remeshing;
namespace parameters = CGAL::parameters;

// With the default number of points, and fewer under the sanitizers.
template <class ConcurrencyTag = CGAL::Sequential_tag, class Mesh1, class Mesh2>
IAR::Surface_distance distance_between(const Mesh1& a, const Mesh2& b)
{
  return IAR::surface_distance<ConcurrencyTag>(
    a, b, parameters::number_of_points_on_faces(meshes::is_small_run() ? 5000 : 100000));
}

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Exact_mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<CGAL::Exact_rational>::Point_3>;

using Soup = meshes::Soup_of<std::vector<std::size_t>>;

template <class Graph>
Graph to_mesh(const Soup& soup)
{
  using Point_map = typename boost::property_map<Graph, CGAL::vertex_point_t>::type;
  using Point = typename boost::property_traits<Point_map>::value_type;
  Graph g;
  std::vector<typename boost::graph_traits<Graph>::vertex_descriptor> handles;
  for(const auto& p : soup.points)
  {
    handles.push_back(add_vertex(g));
    put(CGAL::vertex_point, g, handles.back(), Point(p[0], p[1], p[2]));
  }
  for(const auto& face : soup.faces)
  {
    std::vector<typename boost::graph_traits<Graph>::vertex_descriptor> corners;
    for(const std::size_t corner : face)
      corners.push_back(handles[corner]);
    CGAL::Euler::add_face(corners, g);
  }
  return g;
}

Mesh to_mesh(const Soup& soup) { return to_mesh<Mesh>(soup); }

Soup triangle(double ax, double ay, double bx, double by, double cx, double cy)
{
  return {{{ax, ay, 0}, {bx, by, 0}, {cx, cy, 0}}, {{0, 1, 2}}};
}

Soup regular_tetrahedron()
{
  return {{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
}

// n x n lattice cells, two triangles each; `u` and `v` are the sides of a cell
Soup lattice(std::size_t n, std::array<double, 2> u, std::array<double, 2> v)
{
  Soup soup;
  for(std::size_t j = 0; j <= n; ++j)
    for(std::size_t i = 0; i <= n; ++i)
      soup.points.push_back({double(i) * u[0] + double(j) * v[0], double(i) * u[1] + double(j) * v[1], 0});
  for(std::size_t j = 0; j < n; ++j)
    for(std::size_t i = 0; i < n; ++i)
    {
      const std::size_t a = j * (n + 1) + i, b = a + 1, c = a + n + 1, d = c + 1;
      soup.faces.push_back({a, b, c});
      soup.faces.push_back({b, d, c});
    }
  return soup;
}

Soup equilateral_lattice(std::size_t n) { return lattice(n, {1, 0}, {.5, std::sqrt(3.) / 2}); }

// the unit square
Soup square(std::size_t n) { return lattice(n, {1. / double(n), 0}, {0, 1. / double(n)}); }

void normalize(std::array<double, 3>& p)
{
  const double length = std::hypot(p[0], p[1], p[2]);
  for(double& coordinate : p)
    coordinate /= length;
}

Soup icosahedron()
{
  const double g = (1 + std::sqrt(5.)) / 2;
  Soup soup{{{-1, g, 0}, {1, g, 0}, {-1, -g, 0}, {1, -g, 0}, {0, -1, g}, {0, 1, g},
             {0, -1, -g}, {0, 1, -g}, {g, 0, -1}, {g, 0, 1}, {-g, 0, -1}, {-g, 0, 1}},
            {{0, 11, 5}, {0, 5, 1}, {0, 1, 7}, {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
             {11, 10, 2}, {10, 7, 6}, {7, 1, 8}, {3, 9, 4}, {3, 4, 2}, {3, 2, 6}, {3, 6, 8},
             {3, 8, 9}, {4, 9, 5}, {2, 4, 11}, {6, 2, 10}, {8, 6, 7}, {9, 8, 1}}};
  for(auto& p : soup.points)
    normalize(p);
  return soup;
}

// Cuts every triangle into four, with the midpoints of the edges lifted to the unit sphere.
Soup subdivided_on_sphere(const Soup& coarse)
{
  Soup fine{coarse.points, {}};
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> midpoints;
  const auto midpoint = [&](std::size_t a, std::size_t b)
  {
    const auto entry = midpoints.emplace(std::minmax(a, b), fine.points.size());
    if(entry.second)
    {
      const auto p = fine.points[a], q = fine.points[b];
      fine.points.push_back({p[0] + q[0], p[1] + q[1], p[2] + q[2]});
      normalize(fine.points.back());
    }
    return entry.first->second;
  };
  for(const auto& f : coarse.faces)
  {
    const std::size_t ab = midpoint(f[0], f[1]), bc = midpoint(f[1], f[2]), ca = midpoint(f[2], f[0]);
    fine.faces.insert(fine.faces.end(), {{f[0], ab, ca}, {f[1], bc, ab}, {f[2], ca, bc}, {ab, bc, ca}});
  }
  return fine;
}

Soup sphere(int levels)
{
  Soup soup = icosahedron();
  for(int i = 0; i < levels; ++i)
    soup = subdivided_on_sphere(soup);
  return soup;
}

bool near(double value, double expected, double tolerance) { return std::abs(value - expected) <= tolerance; }

double degrees(double radians) { return radians * 180 / CGAL_PI; }

// Far above the rounding errors of about 1e-14 degrees, far below any angle that matters.
constexpr double ANGLE_TOLERANCE = 1e-12;

std::size_t total(const IAR::Inter_angle_statistics& s)
{
  return std::accumulate(s.histogram.begin(), s.histogram.end(), std::size_t(0));
}

bool equal(const IAR::Surface_distance& a, const IAR::Surface_distance& b)
{
  return a.hausdorff_1_to_2 == b.hausdorff_1_to_2 && a.hausdorff_2_to_1 == b.hausdorff_2_to_1 &&
         a.mean_1_to_2 == b.mean_1_to_2 && a.mean_2_to_1 == b.mean_2_to_1 && a.diagonal == b.diagonal;
}

bool equal(const IAR::Inter_angle_statistics& a, const IAR::Inter_angle_statistics& b)
{
  return a.number_of_faces == b.number_of_faces && a.number_of_degenerate_faces == b.number_of_degenerate_faces &&
         a.minimum_angle == b.minimum_angle && a.maximum_angle == b.maximum_angle && a.average == b.average &&
         a.histogram == b.histogram && a.valence_histogram == b.valence_histogram;
}

void check_all_angles_are_60(const IAR::Inter_angle_statistics& s)
{
  CHECK(near(s.minimum_angle, 60, ANGLE_TOLERANCE));
  CHECK(near(s.maximum_angle, 60, ANGLE_TOLERANCE));
  CHECK(near(s.average, 60, ANGLE_TOLERANCE));
  CHECK(s.number_of_degenerate_faces == 0);
  CHECK(s.histogram[11] + s.histogram[12] == 3 * s.number_of_faces); // 60 is a bound of both
  CHECK(total(s) == 3 * s.number_of_faces);
}

void equilateral_triangles_have_60_degrees()
{
  const auto tetrahedron = IAR::inter_angle_statistics(to_mesh(regular_tetrahedron()));
  check_all_angles_are_60(tetrahedron);
  CHECK(tetrahedron.number_of_faces == 4);
  CHECK(tetrahedron.valence_histogram == std::vector<std::size_t>{0, 0, 0, 4});
  CHECK(tetrahedron.number_of_interior_vertices() == 4);
  CHECK(tetrahedron.regular_vertices() == 0);

  const auto grid = IAR::inter_angle_statistics(to_mesh(equilateral_lattice(5)));
  check_all_angles_are_60(grid);
  CHECK(grid.number_of_faces == 50);
}

void border_vertices_are_not_interior()
{
  // 6 x 6 vertices, of which 4 x 4 lie inside; every one of these has six neighbors
  const auto grid = IAR::inter_angle_statistics(to_mesh(equilateral_lattice(5)));
  CHECK(grid.valence_histogram == std::vector<std::size_t>{0, 0, 0, 0, 0, 0, 16});
  CHECK(grid.regular_vertices() == 1);
  CHECK(grid.percentage_of_regular_vertices() == 100);

  const auto lonely = IAR::inter_angle_statistics(to_mesh(triangle(0, 0, 1, 0, 0, 1)));
  CHECK(lonely.number_of_interior_vertices() == 0);
  CHECK(lonely.valence_histogram.empty());
  CHECK(lonely.regular_vertices() == 0);
}

void right_isosceles_triangle()
{
  const auto s = IAR::inter_angle_statistics(to_mesh(triangle(0, 0, 1, 0, 0, 1)));
  CHECK(near(s.minimum_angle, 45, ANGLE_TOLERANCE));
  CHECK(near(s.maximum_angle, 90, ANGLE_TOLERANCE));
  // 60 - (|45 - 60| + |45 - 60| + |90 - 60|) / 3 = 60 - 20
  CHECK(near(s.average, 40, ANGLE_TOLERANCE));
}

void angles_are_counted_in_bins_of_five_degrees()
{
  // the angles of the triangle with the sides 3, 4, 5: atan(3/4) = 36.9, atan(4/3) = 53.1 and 90, which is a bound
  const auto s = IAR::inter_angle_statistics(to_mesh(triangle(0, 0, 4, 0, 0, 3)));
  CHECK(s.histogram[7] == 1);
  CHECK(s.histogram[10] == 1);
  CHECK(s.histogram[17] + s.histogram[18] == 1);
  CHECK(total(s) == 3);
}

void sphere_from_an_icosahedron()
{
  // The neighboring corners of an icosahedron are alpha = acos(1 / sqrt 5) apart, seen from the centre; those of an
  // icosidodecahedron, which the midpoints form, 36 degrees. Of four triangles one is equilateral, and three have an
  // apex with two sides 2 sin(alpha / 4) and a base 2 sin(18 degrees).
  const double alpha = std::acos(1 / std::sqrt(5.));
  const double apex = degrees(2 * std::asin(std::sin(CGAL_PI / 10) / (2 * std::sin(alpha / 4))));
  const double base = (180 - apex) / 2;
  const double deviation = 3 * ((apex - 60) + 2 * (60 - base)) / 12;

  const auto s = IAR::inter_angle_statistics(to_mesh(sphere(1)));
  CHECK(s.number_of_faces == 80);
  CHECK(near(s.minimum_angle, base, ANGLE_TOLERANCE));
  CHECK(near(s.maximum_angle, apex, ANGLE_TOLERANCE));
  CHECK(near(s.average, 60 - deviation, ANGLE_TOLERANCE));
  CHECK(s.valence_histogram == std::vector<std::size_t>{0, 0, 0, 0, 0, 12, 30});
  CHECK(near(s.percentage_of_regular_vertices(), 100 * 30. / 42, 1e-12));
}

void scale_does_not_matter()
{
  const auto reference = IAR::inter_angle_statistics(to_mesh(sphere(1)));
  for(const double scale : {1e-300, 1e-150, 1e150, 1e300, 1.7e308})
  {
    const auto s = IAR::inter_angle_statistics(to_mesh(sphere(1).scaled(scale)));
    CHECK_MESSAGE(s.number_of_degenerate_faces == 0, scale);
    CHECK_MESSAGE(near(s.minimum_angle, reference.minimum_angle, ANGLE_TOLERANCE), scale << " " << s.minimum_angle);
    CHECK_MESSAGE(near(s.maximum_angle, reference.maximum_angle, ANGLE_TOLERANCE), scale << " " << s.maximum_angle);
    CHECK_MESSAGE(near(s.average, reference.average, ANGLE_TOLERANCE), scale << " " << s.average);
  }
}

void needles_are_measured_accurately()
{
  for(const double width : {1e-3, 1e-9, 1e-100, 1e-250})
  {
    // one right angle, and atan(width) opposite of the side `width`
    const auto needle = IAR::inter_angle_statistics(to_mesh(triangle(0, 0, 1, 0, 1, width)));
    const double tip = degrees(std::atan(width));
    CHECK_MESSAGE(near(needle.minimum_angle, tip, 1e-15 * tip), width);
    CHECK_MESSAGE(near(needle.maximum_angle, 90, ANGLE_TOLERANCE), width);
    CHECK(needle.number_of_degenerate_faces == 0);

    // two angles atan(2 width) at the ends of the unit side, the rest opposite of it
    const auto cap = IAR::inter_angle_statistics(to_mesh(triangle(0, 0, 1, 0, .5, width)));
    const double end = degrees(std::atan(2 * width));
    CHECK_MESSAGE(near(cap.minimum_angle, end, 1e-15 * end), width);
    CHECK_MESSAGE(near(cap.maximum_angle, 180 - 2 * end, ANGLE_TOLERANCE), width);
    CHECK_MESSAGE(near(cap.average, 60 - (2 * (60 - end) + (120 - 2 * end)) / 3, ANGLE_TOLERANCE), width);
  }
}

void degenerate_faces_are_counted_and_left_out_of_the_mean()
{
  const Soup line = triangle(0, 0, 1, 0, 3, 0);
  const Soup point = triangle(7, 7, 7, 7, 7, 7);
  const Soup doubled = triangle(0, 0, 0, 0, 1, 1);
  const Soup right = triangle(0, 0, 1, 0, 0, 1);
  const auto mixed =
    IAR::inter_angle_statistics(to_mesh(right.joined_with(line).joined_with(point).joined_with(doubled)));
  CHECK(mixed.number_of_faces == 4);
  CHECK(mixed.number_of_degenerate_faces == 3);
  CHECK(near(mixed.average, 40, ANGLE_TOLERANCE)); // that of the right triangle alone
  CHECK(total(mixed) == 3);
  CHECK(mixed.minimum_angle == 0);
  CHECK(mixed.maximum_angle == 180);

  const auto nothing_else = IAR::inter_angle_statistics(to_mesh(line));
  CHECK(nothing_else.number_of_degenerate_faces == 1);
  CHECK(nothing_else.average == 0);
  CHECK(total(nothing_else) == 0);
  CHECK(nothing_else.maximum_angle == 180);
}

void empty_range_gives_zeros()
{
  CHECK(equal(IAR::inter_angle_statistics(Mesh()), IAR::Inter_angle_statistics()));
  CHECK(equal(IAR::inter_angle_statistics(std::vector<Mesh::Face_index>(), to_mesh(sphere(0))),
              IAR::Inter_angle_statistics()));
  CHECK(IAR::Inter_angle_statistics().regular_vertices() == 0);
}

void a_range_is_measured_for_itself()
{
  const Mesh mesh = to_mesh(equilateral_lattice(5));
  CHECK(equal(IAR::inter_angle_statistics(faces(mesh), mesh), IAR::inter_angle_statistics(mesh)));

  // the six faces around one vertex: it alone has all of its faces in the range
  const Mesh::Vertex_index centre(2 * 6 + 2);
  std::vector<Mesh::Face_index> umbrella;
  for(const Mesh::Face_index f : CGAL::faces_around_target(mesh.halfedge(centre), mesh))
    umbrella.push_back(f);
  const auto around = IAR::inter_angle_statistics(umbrella, mesh);
  CHECK(around.number_of_faces == 6);
  CHECK(around.valence_histogram == std::vector<std::size_t>{0, 0, 0, 0, 0, 0, 1});

  umbrella.pop_back();
  CHECK(IAR::inter_angle_statistics(umbrella, mesh).number_of_interior_vertices() == 0);
}

void other_meshes_kernels_and_point_maps()
{
  const auto reference = IAR::inter_angle_statistics(to_mesh(sphere(2)));
  const Polyhedron polyhedron = to_mesh<Polyhedron>(sphere(2));
  CHECK(equal(IAR::inter_angle_statistics(polyhedron), reference));
  CHECK(equal(IAR::inter_angle_statistics(faces(polyhedron), polyhedron), reference));
  CHECK(equal(IAR::inter_angle_statistics(to_mesh<Exact_mesh>(sphere(2))), reference));

  Mesh flattened = to_mesh(sphere(2));
  auto elsewhere = flattened.add_property_map<Mesh::Vertex_index, Kernel::Point_3>("v:elsewhere").first;
  for(const Mesh::Vertex_index v : flattened.vertices())
  {
    elsewhere[v] = flattened.point(v);
    flattened.point(v) = CGAL::ORIGIN;
  }
  const auto np = parameters::vertex_point_map(elsewhere);
  CHECK(equal(IAR::inter_angle_statistics(flattened, np), reference));
  CHECK(equal(IAR::inter_angle_statistics(faces(flattened), flattened, np), reference));
  CHECK(equal(IAR::surface_distance(flattened, to_mesh(sphere(1)), np),
              IAR::surface_distance(to_mesh(sphere(2)), to_mesh(sphere(1)))));
}

// Measures of points that were constructed are those of the exact points, however often they are asked for.
void constructed_points_are_measured_exactly()
{
  using Lazy_kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  const Lazy_kernel::FT third = Lazy_kernel::FT(1e10) / 3;
  const Lazy_kernel::Vector_3 far_away(third, third, third);
  const auto there_and_back = [&]() {
    auto m = to_mesh<CGAL::Surface_mesh<Lazy_kernel::Point_3>>(sphere(1));
    for(const auto v : m.vertices())
      m.point(v) = m.point(v) + far_away - far_away;
    return m;
  };
  const Mesh plain = to_mesh(sphere(1));
  const auto m = there_and_back(), other = there_and_back();
  for(int call = 0; call < 2; ++call)
  {
    CHECK(equal(IAR::inter_angle_statistics(m), IAR::inter_angle_statistics(plain)));
    CHECK(equal(IAR::surface_distance(other, plain), IAR::surface_distance(plain, plain)));
  }
}

void angles_of_bad_faces_are_refused()
{
  using Refusal = CGAL::Precondition_exception;
  Soup with_quad = triangle(5, 5, 6, 5, 5, 6).joined_with(triangle(8, 8, 9, 8, 8, 9));
  with_quad = with_quad.joined_with({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}}});
  const Mesh quad = to_mesh(with_quad);
  CHECK_THROWS_AS(IAR::inter_angle_statistics(quad), Refusal, "face number 2 of the range is not a triangle");
  const std::vector<Mesh::Face_index> last(1, Mesh::Face_index(2));
  CHECK_THROWS_AS(IAR::inter_angle_statistics(last, quad), Refusal, "face number 0 of the range is not a triangle");
  CHECK(IAR::inter_angle_statistics(std::vector<Mesh::Face_index>(1, Mesh::Face_index(1)), quad).number_of_faces == 1);

  for(const double bad : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
  {
    const Mesh mesh = to_mesh(triangle(0, 0, 1, 0, 0, 1).joined_with(triangle(0, 0, 1, bad, 0, 1)));
    CHECK_THROWS_AS(IAR::inter_angle_statistics(mesh), Refusal, "face number 1");
    CHECK_THROWS_AS(IAR::inter_angle_statistics(mesh), Refusal, "not a finite number");
    CHECK_THROWS_AS(IAR::surface_distance(to_mesh(square(1)), mesh), Refusal, "face number 1 of the second mesh");
  }
}

void a_shifted_square_is_as_far_as_it_was_shifted()
{
  const double shift = .37;
  const double tolerance = 1e-13; // the rounding errors of a sum of 100000 numbers, amply
  const Mesh below = to_mesh(square(7)), above = to_mesh(square(10).moved(0, 0, shift));
  const auto d = distance_between(below, above);
  // every point of either square has its counterpart in the direction of the normal
  for(const double value : {d.hausdorff_1_to_2, d.hausdorff_2_to_1, d.mean_1_to_2, d.mean_2_to_1,
                            d.hausdorff(), d.mean()})
    CHECK_MESSAGE(near(value, shift, tolerance), value - shift);
  CHECK(near(d.diagonal, std::sqrt(2.), tolerance));
  CHECK(near(d.relative_hausdorff(), shift / std::sqrt(2.), tolerance));
  CHECK(near(d.relative_mean(), shift / std::sqrt(2.), tolerance));
}

void a_surface_has_no_distance_to_itself()
{
  const auto d = distance_between(to_mesh(sphere(3)), to_mesh(sphere(3)));
  CHECK(d.hausdorff() < 1e-15);
  CHECK(IAR::Surface_distance().relative_hausdorff() == 0);
}

void concentric_spheres()
{
  // Every point of the inner mesh lies between the radii r and 1, r being the distance of the largest face's plane from
  // the centre; those of the outer one between s r and s. The ball of radius r lies inside of the inner mesh, so a
  // point at radius R >= 1 is at most R - r from it, and at least R - 1; the same from inside.
  const Soup inner = sphere(3);
  double r = 1;
  for(const auto& f : inner.faces)
  {
    const auto p = [&](int i) { const auto& c = inner.points[f[i]]; return Kernel::Point_3(c[0], c[1], c[2]); };
    r = (std::min)(r, std::sqrt(CGAL::squared_distance(Kernel::Plane_3(p(0), p(1), p(2)), Kernel::Point_3(0, 0, 0))));
  }
  CHECK(r > .99); // else the bounds would say little
  const double s = 1.25, e = 1e-14;
  const auto d = distance_between(to_mesh(inner), to_mesh(inner.scaled(s)));
  CHECK(d.mean_1_to_2 >= s * r - 1 - e && d.mean_1_to_2 <= s - r + e);
  CHECK(d.mean_2_to_1 >= s * r - 1 - e && d.mean_2_to_1 <= s - r + e);
  CHECK(d.hausdorff_1_to_2 <= s - r + e);
  // a vertex of the outer mesh is s - 1 from the unit ball; the samples alone need not come so far
  CHECK(d.hausdorff_2_to_1 >= s - 1 - e && d.hausdorff_2_to_1 <= s - r + e);
}

void a_patch_that_one_surface_lacks_shows_in_one_direction()
{
  const double height = 3;
  const std::size_t n = 20000;
  const Soup patch = triangle(.2, .2, .6, .2, .2, .6).moved(0, 0, height);
  const auto d = IAR::surface_distance(to_mesh(square(4)), to_mesh(square(4).joined_with(patch)),
                                       parameters::number_of_points_on_faces(n));
  CHECK(d.hausdorff_1_to_2 < 1e-15);
  CHECK(d.mean_1_to_2 < 1e-15);
  CHECK(near(d.hausdorff_2_to_1, height, 1e-14));
  // The patch has .08 / 1.08 of the area. It is one piece of the strip that is cut in n pieces with one sample each:
  // all pieces inside of it have theirs there, and at most the two at its ends may or may not.
  CHECK(near(d.mean_2_to_1, height * .08 / 1.08, 2 * height / double(n)));
  CHECK(d.hausdorff() == d.hausdorff_2_to_1);
  CHECK(d.mean() == d.mean_2_to_1);
}

void the_mean_is_one_over_the_area()
{
  // A square at height 0 against one that is tilted from height 0 to 1, over it: the distance of (x, y, 0) from the
  // plane z = x is x / sqrt 2, with its foot (x/2, y, x/2) on the tilted square; the mean of x is 1/2, and more and
  // smaller triangles on one half change nothing.
  Soup tilted = square(1);
  for(auto& p : tilted.points)
    p[2] = p[0];
  Soup uneven = lattice(16, {1. / 32, 0}, {0, 1. / 16}); // x in [0, 1/2]
  uneven = uneven.joined_with(lattice(1, {.5, 0}, {0, 1}).moved(.5, 0, 0));
  const std::size_t n = 100000;
  const auto d = IAR::surface_distance(to_mesh(uneven), to_mesh(tilted), parameters::number_of_points_on_faces(n));
  // independent samples: a standard deviation of 1 / sqrt 24, and the error of the mean below six of 1 / sqrt(24 n)
  CHECK(near(d.mean_1_to_2, std::sqrt(.5) / 2, 6 / std::sqrt(24. * double(n))));
  CHECK(near(d.hausdorff_1_to_2, std::sqrt(.5), 1e-14)); // at the vertices with x = 1, exactly
}

void degenerate_and_needle_faces_are_surface_as_any_other()
{
  // A segment from (0,0,1) to (1,0,1) as a face without an area: the nearest surface to a small triangle over it.
  const Soup segment{{{1, 0, 1}, {0, 0, 1}, {.25, 0, 1}}, {{0, 1, 2}}};
  const Soup over_segment{{{.1, 0, 1.5}, {.2, 0, 1.5}, {.15, 0, 1.6}}, {{0, 1, 2}}};
  const Mesh floor_and_segment = to_mesh(square(2).moved(0, 0, -.5).joined_with(segment));
  const auto to_segment = distance_between(to_mesh(over_segment), floor_and_segment);
  CHECK(near(to_segment.hausdorff_1_to_2, .6, 1e-14)); // from the upper corner straight down

  // Needles of some width along (1, .3, .7), and a triangle in the vertical plane through this direction: its corners
  // lie .1, .1 and .085 over the line, at a distance from it of sqrt(1.09 / 1.58) times as much, and from the needle
  // that or up to its width less.
  const Soup over_needle{{{.4, .12, .38}, {.5, .15, .45}, {.45, .135, .4}}, {{0, 1, 2}}};
  for(const double width : {1e-8, 1e-13, 1e-16, 1e-40})
  {
    const Soup needle{{{0, 0, 0}, {1, .3, .7}, {.4, .12 + width, .28}}, {{0, 1, 2}}};
    const Mesh with_needle = to_mesh(needle.joined_with(square(1).moved(5, 5, 5)));
    const auto d = distance_between(to_mesh(over_needle), with_needle);
    CHECK_MESSAGE(near(d.hausdorff_1_to_2, .1 * std::sqrt(1.09 / 1.58), width + 1e-14),
                  width << " " << d.hausdorff_1_to_2);
  }
}

void distances_grow_with_the_scale()
{
  const Soup coarse = sphere(1), fine = sphere(2);
  const auto reference = distance_between(to_mesh(coarse), to_mesh(fine));
  for(const int exponent : {-500, 500}) // powers of two, that is, without rounding
  {
    const double scale = std::ldexp(1., exponent);
    auto d = distance_between(to_mesh(coarse.scaled(scale)), to_mesh(fine.scaled(scale)));
    CHECK(d.relative_hausdorff() == reference.relative_hausdorff());
    CHECK(d.relative_mean() == reference.relative_mean());
    for(double* value : {&d.hausdorff_1_to_2, &d.hausdorff_2_to_1, &d.mean_1_to_2, &d.mean_2_to_1, &d.diagonal})
      *value /= scale;
    CHECK(equal(d, reference));
  }
}

void isolated_vertices_are_not_surface()
{
  Soup with_vertex = square(3);
  with_vertex.points.push_back({0, 0, 100});
  CHECK(equal(distance_between(to_mesh(with_vertex), to_mesh(square(2))),
              distance_between(to_mesh(square(3)), to_mesh(square(2)))));
}

void samples_depend_on_the_seed_and_on_nothing_else()
{
  const Mesh coarse = to_mesh(sphere(1)), fine = to_mesh(sphere(3));
  const auto reference = distance_between(coarse, fine);
  CHECK(equal(reference, distance_between(coarse, fine)));
  if(!meshes::is_small_run())
  {
    CHECK(equal(reference, IAR::surface_distance(coarse, fine)));
    CHECK(equal(reference, IAR::surface_distance(coarse, fine, parameters::random_seed(0))));
    CHECK(reference.mean_1_to_2 != IAR::surface_distance(coarse, fine, parameters::random_seed(1)).mean_1_to_2);
  }

  // the second parameters have the first ones as defaults
  const auto np = parameters::random_seed(7).number_of_points_on_faces(1000);
  CHECK(equal(IAR::surface_distance(coarse, fine, np), IAR::surface_distance(coarse, fine, np, np)));
  const auto other = IAR::surface_distance(coarse, fine, np, parameters::random_seed(8));
  CHECK(other.mean_1_to_2 == IAR::surface_distance(coarse, fine, np).mean_1_to_2);
  CHECK(other.mean_2_to_1 != IAR::surface_distance(coarse, fine, np).mean_2_to_1);

  const auto swapped = distance_between(fine, coarse);
  CHECK(swapped.mean_2_to_1 == reference.mean_1_to_2 && swapped.mean_1_to_2 == reference.mean_2_to_1);
  CHECK(swapped.hausdorff_2_to_1 == reference.hausdorff_1_to_2);

  CHECK(equal(reference, distance_between(to_mesh<Polyhedron>(sphere(1)), to_mesh<Exact_mesh>(sphere(3)))));
  CHECK(equal(reference, distance_between<CGAL::Parallel_if_available_tag>(coarse, fine)));
}

void threads_do_not_change_a_bit()
{
#ifdef CGAL_LINKED_WITH_TBB
  const Mesh coarse = to_mesh(sphere(1)), fine = to_mesh(sphere(4));
  const auto reference = distance_between<CGAL::Sequential_tag>(coarse, fine);
  for(const std::size_t threads : {1, 2, 4})
  {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    CHECK_MESSAGE(equal(distance_between<CGAL::Parallel_tag>(coarse, fine), reference), threads);
  }
#endif
}

void distances_that_do_not_exist_are_refused()
{
  using Refusal = CGAL::Precondition_exception;
  const Mesh good = to_mesh(square(1)), line = to_mesh(triangle(0, 0, 1, 0, 2, 0));
  const Mesh quad = to_mesh(Soup{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}}});
  CHECK_THROWS_AS(IAR::surface_distance(Mesh(), good), Refusal, "the first mesh has no face");
  CHECK_THROWS_AS(IAR::surface_distance(good, Mesh()), Refusal, "the second mesh has no face");
  CHECK_THROWS_AS(IAR::surface_distance(line, good), Refusal, "the first mesh has no area");
  CHECK_THROWS_AS(IAR::surface_distance(good, quad), Refusal, "face number 0 of the second mesh is not a triangle");
  CHECK_THROWS_AS(IAR::surface_distance(good, good, parameters::number_of_points_on_faces(0)), Refusal, "at least 1");
  CHECK_THROWS_AS(IAR::surface_distance(good, good, parameters::number_of_points_on_faces(-1)), Refusal, "is -1");
  CHECK_THROWS_AS(IAR::surface_distance(good, good, parameters::number_of_points_on_faces(0.5)), Refusal, "at least 1");
}

// Two edges of the border, or constrained ones, that make less than 60 degrees force what is between them.
void forced_faces_are_told_from_the_others()
{
  Soup soup;
  soup.points = {{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {-.5, 1, 0}};
  soup.faces = {{0, 1, 2}, {0, 2, 3}};
  const Mesh m = to_mesh(soup);
  // (2, 0) has 45 degrees between edges of the border, (-.5, 1) some 63
  const auto border_only = IAR::inter_angle_statistics(m);
  CHECK(border_only.number_of_forced_faces == 1);
  CHECK(near(border_only.minimum_angle, 45, 1e-12) && near(border_only.maximum_angle, 90, 1e-12) &&
        border_only.maximum_unforced_angle < 80);
  std::map<boost::graph_traits<Mesh>::edge_descriptor, bool> marks;
  for(const auto e : edges(m))
    marks[e] = true;
  const auto all = IAR::inter_angle_statistics(m, parameters::edge_is_constrained_map(boost::make_assoc_property_map(marks)));
  CHECK(all.number_of_forced_faces == 2 && all.number_of_faces == 2 && all.minimum_unforced_angle == all.minimum_angle);
  CHECK(border_only.unforced_average > border_only.average);
  // A needle on a border edge between two corners, .1 long, and one on an edge in the middle of a straight border.
  Soup needle;
  needle.points = {{0, 0, 0}, {.1, 0, 0}, {.05, 1, 0}, {1, 1.05, 0}, {-1, 1.05, 0}};
  needle.faces = {{0, 1, 2}, {1, 3, 2}, {0, 2, 4}};
  const auto between_corners = IAR::inter_angle_statistics(to_mesh(needle.joined_with(sphere(1).moved(9, 0, 0))));
  CHECK(between_corners.minimum_angle < 6 && between_corners.minimum_unforced_angle > 40);
  needle.points[3] = {1, 0, 0};
  needle.points[4] = {-1, 0, 0};
  const auto on_a_line = IAR::inter_angle_statistics(to_mesh(needle));
  CHECK(on_a_line.minimum_angle < 6 && on_a_line.minimum_unforced_angle == on_a_line.minimum_angle);
  const auto closed = IAR::inter_angle_statistics(to_mesh(sphere(2)));
  CHECK(closed.number_of_forced_faces == 0 && closed.minimum_unforced_angle == closed.minimum_angle &&
        closed.maximum_unforced_angle == closed.maximum_angle && closed.unforced_average == closed.average);
}

int main()
{
  forced_faces_are_told_from_the_others();
  equilateral_triangles_have_60_degrees();
  border_vertices_are_not_interior();
  right_isosceles_triangle();
  angles_are_counted_in_bins_of_five_degrees();
  sphere_from_an_icosahedron();
  scale_does_not_matter();
  needles_are_measured_accurately();
  degenerate_faces_are_counted_and_left_out_of_the_mean();
  empty_range_gives_zeros();
  a_range_is_measured_for_itself();
  other_meshes_kernels_and_point_maps();
  constructed_points_are_measured_exactly();
  angles_of_bad_faces_are_refused();

  a_shifted_square_is_as_far_as_it_was_shifted();
  a_surface_has_no_distance_to_itself();
  concentric_spheres();
  a_patch_that_one_surface_lacks_shows_in_one_direction();
  the_mean_is_one_over_the_area();
  degenerate_and_needle_faces_are_surface_as_any_other();
  distances_grow_with_the_scale();
  isolated_vertices_are_not_surface();
  samples_depend_on_the_seed_and_on_nothing_else();
  threads_do_not_change_a_bit();
  distances_that_do_not_exist_are_refused();
  return result();
}
