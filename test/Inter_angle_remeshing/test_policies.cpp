// Copyright (c) 2026 The Inter_angle_remeshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The rules of inter-angle optimization, one by one, on the configuration of their figures; what policies see, and
// that isotropic_remeshing() does what they say.

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <CGAL/Inter_angle_remeshing/Edge_profile.h>
#include <CGAL/Inter_angle_remeshing/Policies/Inter_angle_collapse_policy.h>
#include <CGAL/Inter_angle_remeshing/Policies/Inter_angle_flip_policy.h>
#include <CGAL/Inter_angle_remeshing/Policies/Inter_angle_split_policy.h>
#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>

#include <boost/property_map/function_property_map.hpp>

#include "check.h"
#include "meshes.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace IAR = CGAL::Inter_angle_remeshing;
namespace parameters = CGAL::parameters;
using namespace meshes;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Edge_profile = IAR::Edge_profile<Mesh>;
using Vertex = Mesh::Vertex_index;

// The vertices of a configuration, as numbers of its soup's points.
constexpr std::size_t SOURCE = 0, TARGET = 1, LEFT = 2, RIGHT = 3;

constexpr double ROOT_3 = 1.7320508075688772;
constexpr double INFINITE = std::numeric_limits<double>::infinity();

// Far above rounding, far below any angle that matters. (Near 0 and 180 degrees the arc cosine makes 1e-6 of 1e-14.)
constexpr double ANGLE_TOLERANCE = 1e-10;

bool near(double value, double expected, double tolerance) { return std::abs(value - expected) <= tolerance; }

template <std::size_t n>
bool near(const std::array<double, n>& values, const std::array<double, n>& expected)
{
  for(std::size_t i = 0; i < n; ++i)
    if(!near(values[i], expected[i], ANGLE_TOLERANCE))
      return false;
  return true;
}

// Two triangles that share the edge from SOURCE to TARGET.
Soup hinge(std::array<double, 3> source, std::array<double, 3> target, std::array<double, 3> left,
           std::array<double, 3> right)
{
  return {{source, target, left, right}, {{SOURCE, TARGET, LEFT}, {TARGET, SOURCE, RIGHT}}};
}

// A right isosceles triangle on the left, an equilateral one on the right of an edge of length 2.
Soup half_square_and_equilateral()
{
  return hinge({0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {1, -ROOT_3, 0});
}

// Two equilateral triangles whose normals differ by `angle` degrees.
Soup roof(double angle)
{
  const double a = angle * CGAL_PI / 180;
  return hinge({0, 0, 0}, {1, 0, 0}, {.5, ROOT_3 / 2 * std::cos(a), ROOT_3 / 2 * std::sin(a)}, {.5, -ROOT_3 / 2, 0});
}

// Two inner vertices of the valences p and q, joined by an edge: SOURCE and TARGET, in a ring of border vertices.
Soup double_wheel(std::size_t p, std::size_t q)
{
  Soup soup{{{-.5, 0, 0}, {.5, 0, 0}, {0, 1, 0}, {0, -1, 0}}, {{SOURCE, TARGET, LEFT}, {TARGET, SOURCE, RIGHT}}};
  const auto add_fan = [&soup](std::size_t centre, std::size_t valence, std::size_t from, std::size_t to, double start)
  {
    std::size_t last = from;
    for(std::size_t i = 1; i + 2 < valence; ++i)
    {
      const double angle = start + CGAL_PI * double(i) / double(valence - 2);
      soup.points.push_back({std::cos(angle), std::sin(angle), 0});
      soup.faces.push_back({centre, last, soup.points.size() - 1});
      last = soup.points.size() - 1;
    }
    soup.faces.push_back({centre, last, to});
  };
  add_fan(SOURCE, p, LEFT, RIGHT, CGAL_PI / 2);
  add_fan(TARGET, q, RIGHT, LEFT, -CGAL_PI / 2);
  return soup;
}

// A mesh and the profile of its edge from SOURCE to TARGET.
template <class Graph>
struct Configuration
{
  using Vertices = std::vector<typename boost::graph_traits<Graph>::vertex_descriptor>;

  Graph mesh;
  Vertices corners;

  explicit Configuration(const Soup& soup) { corners = add_soup(soup, mesh); }

  IAR::Edge_profile<Graph> profile(std::size_t from = SOURCE, std::size_t to = TARGET,
                                   double target_length = INFINITE, bool is_transient = false) const
  {
    return {halfedge(corners[from], corners[to], mesh).first, mesh, get(CGAL::vertex_point, mesh), target_length,
            is_transient};
  }
};

using Case = Configuration<Mesh>;

// Asks a policy for the edge from SOURCE to TARGET.
template <class Policy>
bool permits(const Policy& policy, const Soup& soup, double target_length = INFINITE, bool is_transient = false)
{
  return policy(Case(soup).profile(SOURCE, TARGET, target_length, is_transient));
}

// --- Edge_profile ------------------------------------------------------------------------------------------------

template <class Graph>
void a_profile_knows_the_edge_and_what_is_around_it()
{
  const Configuration<Graph> c(half_square_and_equilateral());
  const auto edge = c.profile(SOURCE, TARGET, 4);
  CHECK(edge.source() == c.corners[SOURCE]);
  CHECK(edge.target() == c.corners[TARGET]);
  CHECK(edge.left_vertex() == c.corners[LEFT]);
  CHECK(edge.right_vertex() == c.corners[RIGHT]);
  CHECK(edge.has_left_face() && edge.has_right_face());
  CHECK(!edge.is_border());
  CHECK(!edge.is_constrained());
  CHECK(!edge.is_transient());
  CHECK(edge.point(edge.target()) == Kernel::Point_3(2, 0, 0));
  CHECK(edge.input_vertex(edge.target()) == c.corners[TARGET]);
  CHECK(&edge.mesh() == &c.mesh);
  CHECK(edge.length() == 2);
  CHECK(edge.target_length() == 4);
  CHECK(edge.relative_length() == .5);
  CHECK(c.profile(SOURCE, TARGET, 4, true).is_transient());

  // at the source and the target: 90 and 45 on the left, 60 and 60 on the right
  CHECK(near(edge.adjacent_angles(), {90, 45, 60, 60}));
  CHECK(near(edge.maximum_adjacent_angle(), 90, ANGLE_TOLERANCE));
  CHECK(near(edge.opposite_angles(), std::array<double, 2>{45, 60}));
  // acos is steep at 0: what rounding leaves of 1, 1e-16, is sqrt(2e-16) radians
  CHECK(near(edge.dihedral_angle(), 0, 1e-6));

  // the other way round, left is right
  const auto reversed = c.profile(TARGET, SOURCE, 4);
  CHECK(reversed.left_vertex() == c.corners[RIGHT]);
  CHECK(near(reversed.adjacent_angles(), {60, 60, 45, 90}));
  CHECK(near(reversed.opposite_angles(), std::array<double, 2>{60, 45}));
}

template <class Graph>
void a_profile_foretells_a_flip()
{
  const Configuration<Graph> c(half_square_and_equilateral());
  // The three edges at the source have the length 2 but for that to be flipped; the angles between the others is
  // 90 + 60, so the triangle beside the source has 150 there and 15 at the left and the right vertex. What remains of
  // the 45 degrees of the left vertex and the 60 of the right one lies beside the target, with 45 + 60 there.
  CHECK(near(c.profile().flipped_angles(), {15, 150, 15, 45 - 15, 105, 60 - 15}));
  CHECK(near(c.profile().maximum_flipped_angle(), 150, ANGLE_TOLERANCE));

  // random quadrangles: the corner angles of the faces that Euler::flip_edge() makes are the ones foretold
  std::mt19937 random(1);
  std::uniform_real_distribution<double> noise(-.3, .3);
  for(int trial = 0; trial < 20; ++trial)
  {
    Soup soup = hinge({0, 0, 0}, {1, 0, 0}, {.5, 1, 0}, {.5, -1, 0});
    for(auto& p : soup.points)
      for(double& coordinate : p)
        coordinate += noise(random);
    Configuration<Graph> flipped(soup);
    const auto before = flipped.profile();
    std::array<double, 6> foretold = before.flipped_angles();
    const double largest = before.maximum_flipped_angle();
    CGAL::Euler::flip_edge(before.halfedge(), flipped.mesh);
    const auto after = flipped.profile(LEFT, RIGHT);
    std::array<double, 6> found;
    const auto adjacent = after.adjacent_angles();
    const auto opposite = after.opposite_angles();
    std::copy(adjacent.begin(), adjacent.end(), found.begin());
    std::copy(opposite.begin(), opposite.end(), found.begin() + 4);
    CHECK(near(largest, *std::max_element(found.begin(), found.end()), ANGLE_TOLERANCE));
    std::sort(found.begin(), found.end());
    std::sort(foretold.begin(), foretold.end());
    CHECK(near(foretold, found));
  }
}

template <class Graph>
void a_profile_counts_edges()
{
  for(std::size_t p = 3; p <= 8; ++p)
    for(std::size_t q = 3; q <= 8; ++q)
    {
      if(p + q == 6)
        continue;  // a tetrahedron
      Configuration<Graph> c(double_wheel(p, q));
      const auto edge = c.profile();
      CHECK(edge.valence(edge.source()) == p);
      CHECK(edge.valence(edge.target()) == q);
      CHECK(!edge.is_border(edge.source()) && !edge.is_border(edge.target()));
      CHECK(edge.valence_deviation(edge.source()) == int(p) - 6);
      // the left vertex lies on the border: two edges along it, and those to the two inner vertices
      CHECK(edge.is_border(edge.left_vertex()));
      CHECK(edge.valence_deviation(edge.left_vertex()) == 0);
      CHECK(edge.valence_after_collapse() == p + q - 4);

      const std::size_t foretold = edge.valence_after_collapse();
      CGAL::Euler::collapse_edge(CGAL::edge(edge.halfedge(), c.mesh), c.mesh);
      std::size_t inner = 0;
      for(const auto v : vertices(c.mesh))
        if(!CGAL::is_border(v, c.mesh))
        {
          CHECK(degree(v, c.mesh) == foretold);
          ++inner;
        }
      CHECK(inner == 1);
    }
}

template <class Graph>
void a_profile_on_the_border_has_one_face()
{
  const Configuration<Graph> c(half_square_and_equilateral());
  const auto edge = c.profile(TARGET, LEFT, 1);  // the hypotenuse of the half square, with its face on the left
  CHECK(edge.is_border());
  CHECK(edge.has_left_face() && !edge.has_right_face());
  CHECK(edge.left_vertex() == c.corners[SOURCE]);
  CHECK(near(edge.adjacent_angles(), {45, 45, 0, 0}));
  CHECK(near(edge.opposite_angles(), std::array<double, 2>{90, 0}));
  CHECK(near(edge.maximum_adjacent_angle(), 45, ANGLE_TOLERANCE));
  CHECK(edge.dihedral_angle() == 0);
  CHECK(edge.is_border(edge.source()) && edge.is_border(edge.target()));
  CHECK(edge.valence(edge.source()) == 3);
  CHECK(edge.valence_deviation(edge.source()) == 3 - 4);
  // the three edges at the target and the two at the left vertex, less the edge itself, counted twice, and one of the
  // two that become one
  CHECK(edge.valence_after_collapse() == 2);

  const auto from_outside = c.profile(LEFT, TARGET, 1);
  CHECK(from_outside.is_border());
  CHECK(!from_outside.has_left_face() && from_outside.has_right_face());
  CHECK(from_outside.right_vertex() == c.corners[SOURCE]);
  CHECK(near(from_outside.adjacent_angles(), {0, 0, 45, 45}));
  CHECK(near(from_outside.opposite_angles(), std::array<double, 2>{0, 90}));
}

template <class Graph>
void a_profile_measures_the_angle_between_the_normals()
{
  for(const double angle : {1., 19., 21., 45., 90., 135., 179.})
    CHECK_MESSAGE(near(Configuration<Graph>(roof(angle)).profile().dihedral_angle(), angle, ANGLE_TOLERANCE), angle);
  CHECK(near(Configuration<Graph>(roof(180)).profile().dihedral_angle(), 180, 1e-5));
  // a face without a normal
  CHECK(Configuration<Graph>(hinge({0, 0, 0}, {1, 0, 0}, {.5, 0, 0}, {.5, -1, 0})).profile().dihedral_angle() == 180);
}

void mean_angles_fill_a_flat_neighborhood()
{
  CHECK(Edge_profile::mean_angle(6, false) == 60);
  CHECK(Edge_profile::mean_angle(4, true) == 60);  // three faces in 180 degrees
  CHECK(Edge_profile::mean_angle(5, false) == 72);
  CHECK(Edge_profile::mean_angle(2, true) == 180);
}

void a_profile_takes_maps_of_all_kinds()
{
  // constrained edges, points of the user's own, and vertices of another mesh
  const Case c(half_square_and_equilateral());
  const auto tenfold = boost::make_function_property_map<Vertex>([&](Vertex v) {
    const auto& p = c.mesh.point(v);
    return Kernel::Point_3(10 * p.x(), 10 * p.y(), 10 * p.z());
  });
  const auto all = CGAL::Static_boolean_property_map<Mesh::Edge_index, true>();
  const auto numbers = boost::make_function_property_map<Vertex>([](Vertex v) { return int(v) + 100; });
  const IAR::Edge_profile<Mesh, decltype(tenfold), decltype(all), decltype(numbers)> edge(
    c.profile().halfedge(), c.mesh, tenfold, 1, false, all, numbers);
  CHECK(edge.length() == 20);
  CHECK(edge.is_constrained());
  CHECK(edge.input_vertex(edge.target()) == int(c.corners[TARGET]) + 100);
}

// --- split -------------------------------------------------------------------------------------------------------

// The angle at the source in the left triangle is `angle`, the three others beside the edge are smaller than 90.
Soup edge_beside_an_angle_of(double angle)
{
  const double a = angle * CGAL_PI / 180;
  return hinge({0, 0, 0}, {1, 0, 0}, {.5 * std::cos(a), .5 * std::sin(a), 0}, {.5, -1, 0});
}

void a_split_waits_for_an_obtuse_neighbor()
{
  const IAR::Inter_angle_split_policy<> rule;
  CHECK(permits(rule, edge_beside_an_angle_of(80)));
  CHECK(!permits(rule, edge_beside_an_angle_of(91)));
  CHECK(!permits(rule, edge_beside_an_angle_of(120)));

  // each of the four places
  const Case c(edge_beside_an_angle_of(120));
  CHECK(!rule(c.profile(TARGET, SOURCE)));
  Soup at_target = edge_beside_an_angle_of(120);
  for(auto& p : at_target.points)
    p[0] = 1 - p[0];  // mirrored, so its faces look down
  std::swap(at_target.points[SOURCE], at_target.points[TARGET]);
  CHECK(!permits(rule, at_target));
  CHECK(!rule(Case(at_target).profile(TARGET, SOURCE)));

  // on the border
  CHECK(!permits(rule, Soup{{{0, 0, 0}, {1, 0, 0}, {-.2, 1, 0}}, {{SOURCE, TARGET, LEFT}}}));
  CHECK(permits(rule, Soup{{{0, 0, 0}, {1, 0, 0}, {.2, 1, 0}}, {{SOURCE, TARGET, LEFT}}}));
}

void an_obtuse_angle_opposite_of_the_edge_is_what_a_split_is_for()
{
  CHECK(permits(IAR::Inter_angle_split_policy<>(), hinge({0, 0, 0}, {2, 0, 0}, {1, .1, 0}, {1, -.1, 0})));
}

void a_right_angle_is_not_obtuse()
{
  CHECK(permits(IAR::Inter_angle_split_policy<>(), half_square_and_equilateral()));
  // nor does rounding make it so
  std::mt19937 random(2);
  std::uniform_real_distribution<double> angle(0, 2 * CGAL_PI);
  for(int trial = 0; trial < 1000; ++trial)
  {
    const double a = angle(random), b = angle(random), scale = std::exp2(trial % 20);
    const auto turned = [&](double x, double y) -> std::array<double, 3>
    {
      const double u = std::cos(a) * x - std::sin(a) * y, v = std::sin(a) * x + std::cos(a) * y;
      return {scale * u, scale * std::cos(b) * v, scale * std::sin(b) * v};
    };
    CHECK(permits(IAR::Inter_angle_split_policy<>(), hinge(turned(0, 0), turned(2, 0), turned(0, 2), turned(1, -1.7))));
  }
}

void a_much_too_long_edge_is_split_beside_any_angle()
{
  // the edge has the length 1, the rule yields from twice the target length on
  const Soup obtuse = edge_beside_an_angle_of(120);
  const IAR::Inter_angle_split_policy<> rule;
  CHECK(!permits(rule, obtuse, 1 / 1.4));
  CHECK(!permits(rule, obtuse, 1 / 2.));
  CHECK(permits(rule, obtuse, 1 / 2.01));
  // or at a ratio of the user's choice
  CHECK(!permits(IAR::Inter_angle_split_policy<>(90, IAR::Permit_all(), 3), obtuse, 1 / 2.9));
  CHECK(permits(IAR::Inter_angle_split_policy<>(90, IAR::Permit_all(), 3), obtuse, 1 / 3.1));
  // or never
  CHECK(!permits(IAR::Inter_angle_split_policy<>(90, IAR::Permit_all(), INFINITE), obtuse, 1e-9));
}

void beside_needles_the_split_rule_yields_where_asked_to()
{
  const auto rule = [](double needle_angle) { return IAR::Inter_angle_split_policy<>(90, IAR::Permit_all(), INFINITE, needle_angle); };
  // obtuse on the left, 9.5 degrees at the source on the right; and the other way round, and on the border
  const double t = std::tan(9.5 * CGAL_PI / 180);
  for(const Soup& edge : {hinge({0, 0, 0}, {1, 0, 0}, {-.2, 1, 0}, {.9, -.9 * t, 0}), hinge({0, 0, 0}, {1, 0, 0}, {.9, .9 * t, 0}, {-.2, -1, 0})})
  {
    CHECK(permits(rule(10), edge) && !permits(rule(9), edge) && !permits(rule(0), edge));
    CHECK(!permits(IAR::Inter_angle_split_policy<>(), edge));
  }
  CHECK(!permits(rule(10), edge_beside_an_angle_of(120)));
  const Soup triangle = {{{0, 0, 0}, {1, 0, 0}, {-.2, 1, 0}}, {{0, 1, 2}}};
  CHECK(!permits(rule(10), triangle));
}

void the_angle_of_the_split_rule_is_a_parameter()
{
  CHECK(permits(IAR::Inter_angle_split_policy<>(100), edge_beside_an_angle_of(99)));
  CHECK(!permits(IAR::Inter_angle_split_policy<>(100), edge_beside_an_angle_of(101)));
  CHECK(!permits(IAR::Inter_angle_split_policy<>(70), edge_beside_an_angle_of(71)));
  // 180 turns it off, for the flattest triangle
  CHECK(permits(IAR::Inter_angle_split_policy<>(180), hinge({0, 0, 0}, {1, 0, 0}, {-1, 0, 0}, {.5, -1, 0})));
  CHECK(!permits(IAR::Inter_angle_split_policy<>(179), hinge({0, 0, 0}, {1, 0, 0}, {-1, 0, 0}, {.5, -1, 0})));
}

// --- collapse ----------------------------------------------------------------------------------------------------

void collapses_stay_away_from_the_border()
{
  const IAR::Inter_angle_collapse_policy<> with_condition(true, false), without(false, false), by_default;
  const Case c(double_wheel(6, 6));
  const auto check = [&](std::size_t from, std::size_t to, bool is_at_border)
  {
    CHECK_MESSAGE(with_condition(c.profile(from, to)) != is_at_border, from << " to " << to);
    CHECK_MESSAGE(without(c.profile(from, to)), from << " to " << to);
    CHECK_MESSAGE(by_default(c.profile(from, to)), from << " to " << to);
  };
  check(SOURCE, TARGET, false);                                      // interior, interior
  check(SOURCE, LEFT, true);                                         // interior, border
  check(LEFT, SOURCE, true);                                         // border, interior
  check(LEFT, 4, true);                                              // border, border: 4 is next to the left vertex
  check(4, LEFT, true);
}

// The degree judgment, written once more: the mean angle of the merged vertex against that of the two.
bool comes_nearer_to_60(std::size_t p, std::size_t q)
{
  const double before = (360. / double(p) + 360. / double(q)) / 2, after = 360. / double(p + q - 4);
  return std::abs(after - 60) <= std::abs(before - 60);
}

void a_collapse_must_not_crowd_a_vertex()
{
  const IAR::Inter_angle_collapse_policy<> judging(false, true), by_default;
  // (72 + 60) / 2 = 66, six from 60; 360 / 7 = 51.4, nearly nine
  CHECK(!permits(judging, double_wheel(5, 6), 1));
  CHECK(!permits(judging, double_wheel(6, 5), 1));
  // 60, none from 60; 360 / 8 = 45
  CHECK(!permits(judging, double_wheel(6, 6), 1));
  // 72, twelve from 60; 360 / 6 = 60
  CHECK(permits(judging, double_wheel(5, 5), 1));
  // (90 + 72) / 2 = 81, 21 from 60; 360 / 5 = 72
  CHECK(permits(judging, double_wheel(4, 5), 1));
  // (51.4 + 120) / 2 = 85.7; 360 / 6 = 60
  CHECK(permits(judging, double_wheel(7, 3), 1));
  for(std::size_t p = 3; p <= 9; ++p)
    for(std::size_t q = p == 3 ? 4 : 3; q <= 9; ++q)
    {
      CHECK_MESSAGE(permits(judging, double_wheel(p, q), 1) == comes_nearer_to_60(p, q), p << " and " << q);
      CHECK_MESSAGE(permits(by_default, double_wheel(p, q), 1), p << " and " << q);
    }
}

void a_border_vertex_is_judged_by_180_degrees()
{
  // The edge from TARGET to LEFT of the hinge lies on the border, with the valences 3 and 2, and becomes 2:
  // 180 / 2 and 180 / 1 are 135 on the average, 75 from 60; 180 / 1 is 120 from it.
  const IAR::Inter_angle_collapse_policy<> judging(false, true);
  CHECK(!judging(Case(half_square_and_equilateral()).profile(TARGET, LEFT, 2)));
  // An inner vertex with 6 edges into a border vertex with 4 (LEFT of the double wheel): 60 and 60 before, and
  // 180 / 7 after: 6 + 4 - 4 edges, 6 on the border, 5 faces, 36 degrees.
  CHECK(!judging(Case(double_wheel(6, 6)).profile(SOURCE, LEFT, 1)));
  // One with 3: 120 and 60 before, 30 from 60; 3 + 4 - 4 edges, 2 faces, 90 degrees, 30 from 60: no further.
  CHECK(judging(Case(double_wheel(3, 6)).profile(SOURCE, LEFT, 1)));
}

void the_degree_judgment_yields_to_length()
{
  const Soup crowded = double_wheel(5, 6);  // the edge has the length 1
  const IAR::Inter_angle_collapse_policy<> judging(false, true);
  CHECK(!permits(judging, crowded, 1.25));
  CHECK(!permits(judging, crowded, 2));
  CHECK(permits(judging, crowded, 2.01));
  const IAR::Inter_angle_collapse_policy<> yields_late(false, true, IAR::Permit_all(), .3);
  CHECK(!permits(yields_late, crowded, 2.01));
  CHECK(permits(yields_late, crowded, 3.5));
  const IAR::Inter_angle_collapse_policy<> never_yields(false, true, IAR::Permit_all(), 0);
  CHECK(!permits(never_yields, crowded, 1e9));
  // where no target length is known, it does not yield
  CHECK(!permits(judging, crowded, std::numeric_limits<double>::infinity()));
  // the boundary condition never does
  CHECK(!IAR::Inter_angle_collapse_policy<>(true, false)(Case(crowded).profile(SOURCE, LEFT, 1e9)));
}

// --- flip --------------------------------------------------------------------------------------------------------

void a_flip_must_not_make_an_obtuse_angle()
{
  const Soup makes_150 = half_square_and_equilateral();
  CHECK(!permits(IAR::Inter_angle_flip_policy<>(), makes_150));
  CHECK(!permits(IAR::Inter_angle_flip_policy<>(149, 180), makes_150));
  CHECK(permits(IAR::Inter_angle_flip_policy<>(151, 180), makes_150));
  CHECK(permits(IAR::Inter_angle_flip_policy<>(180, 20), makes_150));
  // the other diagonal of a square makes two right angles
  CHECK(permits(IAR::Inter_angle_flip_policy<>(), hinge({0, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 0})));
  // of a rhombus, from the long diagonal to the short one, equilateral triangles; back, 120 degrees
  const std::array<double, 3> w = {0, 0, 0}, e = {ROOT_3, 0, 0}, n = {ROOT_3 / 2, .5, 0}, s = {ROOT_3 / 2, -.5, 0};
  CHECK(permits(IAR::Inter_angle_flip_policy<>(), hinge(w, e, n, s)));
  CHECK(!permits(IAR::Inter_angle_flip_policy<>(), hinge(s, n, w, e)));
  CHECK(permits(IAR::Inter_angle_flip_policy<>(121, 20), hinge(s, n, w, e)));
}

void a_flip_must_not_crease_the_surface()
{
  const IAR::Inter_angle_flip_policy<> dihedral_alone(180, 20), more(180, 30), off(180, 180);
  CHECK(permits(dihedral_alone, roof(19)));
  CHECK(!permits(dihedral_alone, roof(21)));
  CHECK(permits(dihedral_alone, roof(-19)));   // a valley
  CHECK(!permits(dihedral_alone, roof(-21)));
  CHECK(permits(more, roof(29)));
  CHECK(!permits(more, roof(31)));
  for(const double angle : {45., 90., 179., 180.})
    CHECK_MESSAGE(permits(off, roof(angle)), angle);
  // a face without a normal: only the rule's absence lets it pass
  const Soup flat = hinge({0, 0, 0}, {1, 0, 0}, {.5, 0, 0}, {.5, -1, 0});
  CHECK(!permits(IAR::Inter_angle_flip_policy<>(180, 179), flat));
  CHECK(permits(off, flat));
}

void the_two_flip_rules_are_independent()
{
  // a roof of equilateral triangles: its flip makes an angle of nearly 120
  CHECK(!permits(IAR::Inter_angle_flip_policy<>(90, 180), roof(10)));
  CHECK(permits(IAR::Inter_angle_flip_policy<>(121, 180), roof(10)));
  CHECK(!permits(IAR::Inter_angle_flip_policy<>(121, 9), roof(10)));
  CHECK(permits(IAR::Inter_angle_flip_policy<>(121, 11), roof(10)));
}

void the_flips_of_a_glide_pass()
{
  const IAR::Inter_angle_flip_policy<> rules(90, 20);
  for(const Soup& soup : {half_square_and_equilateral(), roof(60)})
  {
    CHECK(!permits(rules, soup, INFINITE, false));
    CHECK(permits(rules, soup, INFINITE, true));
  }
}

// --- policies that decorate each other ---------------------------------------------------------------------------

void rules_ask_their_base_first()
{
  int asked = 0;
  const auto deny = [&asked](const auto&) { ++asked; return false; };
  const auto permit = [&asked](const auto&) { ++asked; return true; };
  const Soup fine = hinge({0, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 0});

  CHECK(!permits(IAR::Inter_angle_flip_policy(90, 20, deny), fine));
  CHECK(permits(IAR::Inter_angle_flip_policy(90, 20, permit), fine));
  CHECK(!permits(IAR::Inter_angle_split_policy(90, deny), fine));
  CHECK(permits(IAR::Inter_angle_split_policy(90, permit), fine));
  CHECK(!permits(IAR::Inter_angle_collapse_policy(false, false, deny), fine));
  CHECK(permits(IAR::Inter_angle_collapse_policy(false, false, permit), fine));
  CHECK(asked == 6);

  // of a glide's flips, too
  CHECK(!permits(IAR::Inter_angle_flip_policy(90, 20, deny), fine, INFINITE, true));
  CHECK(asked == 7);
  // what the base permits must still pass the rule
  CHECK(!permits(IAR::Inter_angle_flip_policy(90, 20, permit), half_square_and_equilateral()));
  CHECK(!permits(IAR::Inter_angle_split_policy(90, permit), edge_beside_an_angle_of(120)));
  CHECK(!permits(IAR::Inter_angle_collapse_policy(false, true, permit), double_wheel(5, 6), 1));
  CHECK(!permits(IAR::Inter_angle_collapse_policy(true, false, permit), fine));
}

void rules_can_be_stacked()
{
  const auto is_short = [](const auto& edge) { return edge.length() < 1.5; };
  const auto stacked = IAR::Inter_angle_flip_policy(180, 20, IAR::Inter_angle_flip_policy(90, 180, is_short));
  const Soup square_cell = hinge({0, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 0});
  CHECK(permits(stacked, square_cell));
  CHECK(!permits(stacked, square_cell.scaled(2)));           // the innermost
  CHECK(!permits(stacked, roof(10)));                        // the middle one: 120 degrees
  CHECK(!permits(stacked, hinge({0, 0, 0}, {1, 1, 0}, {0, 1, .8}, {1, 0, .8})));  // the outermost
}

void rules_work_on_a_polyhedron()
{
  const auto ask = [](const auto& policy, const Soup& soup)
  {
    return policy(Configuration<Polyhedron>(soup).profile(SOURCE, TARGET, 1));
  };
  CHECK(!ask(IAR::Inter_angle_split_policy<>(), edge_beside_an_angle_of(120)));
  CHECK(!ask(IAR::Inter_angle_collapse_policy<>(false, true), double_wheel(5, 6)));
  CHECK(ask(IAR::Inter_angle_collapse_policy<>(false, true), double_wheel(5, 5)));
  CHECK(!ask(IAR::Inter_angle_flip_policy<>(), half_square_and_equilateral()));
}

// --- inside of isotropic_remeshing() -----------------------------------------------------------------------------

// Edges from .05 to .45, which is far from LENGTH at both ends, and valences of 5, 6 and 7.
Soup uneven_sphere()
{
  Soup soup = sphere(3);
  for(auto& p : soup.points)
  {
    const double factor = 1 + .8 * p[0];
    for(double& coordinate : p)
      coordinate *= factor;
  }
  return soup;
}

Mesh uneven_mesh(double scale = 1)
{
  Mesh m = to_mesh<Mesh>(uneven_sphere().scaled(scale));
  scramble(m, [](std::size_t edge) { return edge % 7 == 0; });
  return m;
}

constexpr double LENGTH = .2;

using Report = IAR::Remeshing_report;

void false_binds_every_step()
{
  const std::size_t input_vertices = uneven_sphere().points.size();
  Mesh m = uneven_mesh();
  const Report all = IAR::isotropic_remeshing(LENGTH, m);
  CHECK(all.splits > 0 && all.collapses > 0 && all.flips > 0 && all.glides > 0);

  m = uneven_mesh();
  const Report no_split = IAR::isotropic_remeshing(LENGTH, m, parameters::do_split(false));
  CHECK(no_split.splits == 0 && no_split.collapses > 0 && no_split.flips > 0);
  // no split, no new vertex: those left over are the user's
  CHECK(m.number_of_vertices() == input_vertices - no_split.collapses);
  CHECK(std::all_of(m.vertices().begin(), m.vertices().end(), [&](Vertex v) { return std::size_t(v) < input_vertices; }));

  m = uneven_mesh();
  const Report no_collapse = IAR::isotropic_remeshing(LENGTH, m, parameters::do_collapse(false));
  CHECK(no_collapse.splits > 0 && no_collapse.collapses == 0 && no_collapse.flips > 0);
  CHECK(m.number_of_vertices() == input_vertices + no_collapse.splits);
  CHECK(m.number_of_removed_vertices() == 0);

  m = uneven_mesh();
  const Report no_flip = IAR::isotropic_remeshing(LENGTH, m, parameters::do_flip(false));
  CHECK(no_flip.splits > 0 && no_flip.collapses > 0 && no_flip.flips == 0 && no_flip.glides == 0);

  m = uneven_mesh();
  const auto before = triangles(m);
  const Picture<Mesh> unmoved(m);
  const Report nothing = IAR::isotropic_remeshing(LENGTH, m,
                                                  parameters::do_split(false).do_collapse(false).do_flip(false));
  CHECK(nothing.splits == 0 && nothing.collapses == 0 && nothing.flips == 0 && nothing.glides == 0);
  CHECK(triangles(m) == before);
  CHECK(Picture<Mesh>(m) != unmoved);  // but vertices were relaxed
}

// Denies everything, and counts how often it was asked.
struct Counting_denial
{
  std::atomic<std::size_t> asked{0};

  template <class P>
  bool operator()(const P&) const
  {
    ++const_cast<std::atomic<std::size_t>&>(asked);
    return false;
  }
};

bool deny_everything(const IAR::internal::Run_profile<Vertex>&) { return false; }

void a_policy_of_any_kind_is_asked()
{
  // A lambda without captures converts to a pointer to a function, and that to `true`.
  {
    Mesh m = uneven_mesh();
    const auto before = triangles(m);
    const Report r = IAR::isotropic_remeshing(LENGTH, m,
      parameters::do_split([](const auto&) { return false; })
                 .do_collapse([](const IAR::internal::Run_profile<Vertex>&) { return false; })
                 .do_flip(&deny_everything));
    CHECK(r.splits == 0 && r.collapses == 0 && r.flips == 0 && r.glides == 0);
    CHECK(triangles(m) == before);
  }
  // Functors by reference: the caller sees what they count.
  {
    Mesh m = uneven_mesh();
    Counting_denial split, collapse, flip;
    const Report r = IAR::isotropic_remeshing<CGAL::Parallel_if_available_tag>(LENGTH, m,
      parameters::do_split(std::ref(split)).do_collapse(std::ref(collapse)).do_flip(std::cref(flip)));
    CHECK(r.splits == 0 && r.collapses == 0 && r.flips == 0 && r.glides == 0);
    CHECK(split.asked > 0 && collapse.asked > 0 && flip.asked > 0);
  }
}

void a_policy_that_permits_all_is_no_policy()
{
  Mesh given = uneven_mesh(), absent = given;
  IAR::isotropic_remeshing(LENGTH, given,
    parameters::do_split([](const auto&) { return true; }).do_collapse(IAR::Permit_all()).do_flip(IAR::Permit_all()));
  IAR::isotropic_remeshing(LENGTH, absent, parameters::do_split(true).do_collapse(true).do_flip(true));
  CHECK(Picture<Mesh>(given) == Picture<Mesh>(absent));
}

// What a policy was told in the run, by the user's vertices.
struct Told
{
  Vertex source, target, left, right;
  double length, target_length;
  std::array<double, 4> adjacent;
  std::array<double, 2> opposite;
  double dihedral;
  std::size_t valence_of_source, valence_after;
  bool is_border, is_source_border, is_constrained;
};

template <class P>
Told tell(const P& edge)
{
  return {edge.input_vertex(edge.source()), edge.input_vertex(edge.target()),
          edge.has_left_face() ? edge.input_vertex(edge.left_vertex()) : Vertex(),
          edge.has_right_face() ? edge.input_vertex(edge.right_vertex()) : Vertex(),
          edge.length(), edge.target_length(), edge.adjacent_angles(), edge.opposite_angles(), edge.dihedral_angle(),
          edge.valence(edge.source()), edge.valence_after_collapse(), edge.is_border(), edge.is_border(edge.source()),
          edge.is_constrained()};
}

// What a policy was told during a run is what it finds in the user's mesh.
void check_as_in_the_mesh(const Told& told, const Told& own, double length)
{
  CHECK(told.source == own.source && told.target == own.target && told.left == own.left && told.right == own.right);
  CHECK(told.length == own.length);  // scaling by a power of two loses nothing
  CHECK(told.target_length == length);
  CHECK(near(told.adjacent, own.adjacent));
  CHECK(near(told.opposite, own.opposite));
  CHECK(near(told.dihedral, own.dihedral, 1e-6));
  CHECK(told.valence_of_source == own.valence_of_source);
  CHECK(told.valence_after == own.valence_after);
  CHECK(told.is_border == own.is_border);
  CHECK(told.is_source_border == own.is_source_border);
}

// A run that is denied everything shows its policies the user's mesh, edge by edge.
void a_policy_sees_the_mesh_as_the_user_has_it()
{
  Soup soup = square_without(6, [](std::size_t i, std::size_t j) { return (i == 2 || i == 3) && j == 2; });
  for(auto& p : soup.points)
    p = {1000 * p[0] * p[0], 1000 * p[1] * p[1], 50 * std::sin(5 * p[0] + 3 * p[1])};  // edges from 28 to 450
  const double length = 150;
  Mesh m = to_mesh<Mesh>(soup);
  const Mesh copy = m;
  Mesh::Property_map<Mesh::Edge_index, bool> constrained = m.add_property_map<Mesh::Edge_index, bool>("e", false).first;
  for(const auto e : m.edges())
    constrained[e] = unsigned(e) % 5 == 0;
  const std::vector<bool> was_constrained(constrained.begin(), constrained.end());

  IAR::Recipe recipe;
  recipe.grading = 0;                    // one length everywhere, although the constrained edges have details
  std::vector<Told> splits, collapses;
  IAR::isotropic_remeshing(faces(m), length, m, IAR::recipe(recipe,
    parameters::number_of_iterations(1).do_project(false).number_of_relaxation_steps(0).edge_is_constrained_map(constrained)
               .do_split([&](const auto& edge) { splits.push_back(tell(edge)); return false; })
               .do_collapse([&](const auto& edge) { collapses.push_back(tell(edge)); return false; })
               .do_flip(false)));

  // edges that are too long were asked for, the longest of all among them
  const double too_long = recipe.split_ratio * length;
  std::size_t long_edges = 0, border_edges = 0, constrained_edges = 0;
  double longest = 0, longest_asked = 0;
  for(const auto e : copy.edges())
  {
    const double l = IAR::Edge_profile<Mesh>(copy.halfedge(e), copy, copy.points()).length();
    long_edges += l > too_long || copy.is_border(e) || was_constrained[e];
    longest = std::max(longest, l);
  }
  for(const Told& told : splits)
  {
    CHECK(told.length > too_long || told.is_border || told.is_constrained);   // these may also leave their curve
    longest_asked = std::max(longest_asked, told.length);
  }
  CHECK(splits.size() <= long_edges && splits.size() > 10 && !collapses.empty());
  CHECK(longest_asked == longest);

  splits.insert(splits.end(), collapses.begin(), collapses.end());
  for(const Told& told : splits)
  {
    const auto found = CGAL::halfedge(told.source, told.target, copy);
    CHECK(found.second);
    if(!found.second)
      continue;
    check_as_in_the_mesh(told, tell(IAR::Edge_profile<Mesh>(found.first, copy, copy.points(), length)), length);
    CHECK(told.is_constrained == was_constrained[copy.edge(found.first)]);
    border_edges += told.is_border;
    constrained_edges += told.is_constrained;
  }
  CHECK(border_edges > 0 && constrained_edges > 0);
}

// Short edges that are constrained are details: beside them edges are split and collapsed by a shorter length than farther away.
// What policies are told is the length that was asked for.
void a_policy_is_asked_by_the_graded_length()
{
  Soup soup = square(12);
  for(auto& p : soup.points)
    p = {1000 * p[0] * p[0], 1000 * p[1] * p[1], 0};        // edges from 7 to 225
  const Mesh input = to_mesh<Mesh>(soup);
  const Kernel::Point_3 origin(0, 0, 0);
  const double length = 60;
  struct Asked
  {
    std::vector<Told> splits, collapses;        // of edges that are on no curve
  };
  const auto asked_with = [&](double grading)
  {
    Mesh m = input;
    Mesh::Property_map<Mesh::Edge_index, bool> constrained = m.add_property_map<Mesh::Edge_index, bool>("e", false).first;
    for(const auto e : m.edges())
      constrained[e] = unsigned(e) % 5 == 0 && CGAL::squared_distance(m.point(m.vertex(e, 0)), origin) < 10000;
    Asked asked;
    const auto note = [](std::vector<Told>& told, const auto& edge)
    {
      if(!edge.is_border() && !edge.is_constrained())
        told.push_back(tell(edge));
      return false;
    };
    IAR::Recipe recipe;
    recipe.grading = grading;
    IAR::isotropic_remeshing(length, m, IAR::recipe(recipe,
      parameters::number_of_iterations(1).do_project(false).number_of_relaxation_steps(0).edge_is_constrained_map(constrained)
                 .do_split([&](const auto& edge) { return note(asked.splits, edge); })
                 .do_collapse([&](const auto& edge) { return note(asked.collapses, edge); })
                 .do_flip(false)));
    return asked;
  };
  const IAR::Recipe recipe;
  const Asked uniform = asked_with(0), graded = asked_with(recipe.grading);
  const auto is_shorter = [](const Told& a, const Told& b) { return a.length < b.length; };
  const auto shortest = [&](const std::vector<Told>& told) { return std::min_element(told.begin(), told.end(), is_shorter)->length; };
  const bool are_all_asked = !uniform.splits.empty() && !uniform.collapses.empty() && !graded.splits.empty() && !graded.collapses.empty();
  CHECK(are_all_asked);
  if(!are_all_asked)
    return;
  CHECK_MESSAGE(shortest(uniform.splits) > recipe.split_ratio * length, shortest(uniform.splits));
  CHECK_MESSAGE(shortest(graded.splits) < recipe.split_ratio * length, shortest(graded.splits));
  CHECK_MESSAGE(graded.collapses.size() < uniform.collapses.size(), graded.collapses.size() << ", " << uniform.collapses.size());
  for(const Asked& asked : {uniform, graded})
    for(const std::vector<Told>& told : {asked.splits, asked.collapses})
      CHECK(std::all_of(told.begin(), told.end(), [&](const Told& t) { return t.target_length == length; }));
}

// With the length 0 nothing is split or collapsed, and flips are asked for without a target.
void without_a_length_no_target_is_known()
{
  Mesh m = uneven_mesh();
  std::size_t asked = 0, known = 0;
  IAR::isotropic_remeshing(0., m, parameters::do_flip([&](const auto& edge) {
    ++asked;
    known += edge.has_target_length() || edge.relative_length() != 0;
    return true;
  }));
  CHECK_MESSAGE(asked > 0 && known == 0, known << " of " << asked);
}

void input_vertices_are_the_users_and_new_ones_have_none()
{
  Mesh m = uneven_mesh();
  const Mesh copy = m;
  std::set<Kernel::Point_3> input_points;
  for(const Vertex v : copy.vertices())
    input_points.insert(copy.point(v));
  std::size_t old_ones = 0, new_ones = 0;
  // no vertex moves: an old one is where the user has it, and a new one where the user has none
  const auto look = [&](const auto& edge)
  {
    for(const auto v : {edge.source(), edge.target(), edge.left_vertex(), edge.right_vertex()})
    {
      const Vertex input = edge.input_vertex(v);
      const auto p = edge.point(v);
      if(input == Mesh::null_vertex())
      {
        ++new_ones;
        CHECK(input_points.count(Kernel::Point_3(p.x(), p.y(), p.z())) == 0);
      }
      else
      {
        ++old_ones;
        CHECK(copy.is_valid(input) && bits(copy.point(input)) == bits(p));
      }
    }
    return true;
  };
  IAR::isotropic_remeshing(LENGTH, m, parameters::number_of_iterations(3).number_of_relaxation_steps(0).do_project(false)
                                                .do_split(std::cref(look)).do_collapse(std::cref(look))
                                                .do_flip(std::cref(look)));
  CHECK(old_ones > 0 && new_ones > 0);
}

void what_a_policy_denies_stays_as_it_was()
{
  Mesh m = uneven_mesh();
  const Mesh copy = m;
  const auto is_left = [](const auto& p) { return p.x() <= 0; };
  const auto is_right = [&](const auto& edge)
  {
    return !is_left(edge.point(edge.source())) && !is_left(edge.point(edge.target()));
  };
  const auto left_faces = [&](const Mesh& mesh)
  {
    auto all = triangles(mesh);
    all.erase(std::remove_if(all.begin(), all.end(), [&](const auto& t) {
      return !(is_left(mesh.point(t[0])) && is_left(mesh.point(t[1])) && is_left(mesh.point(t[2])));
    }), all.end());
    return all;
  };
  const auto before = left_faces(m);
  // vertices stay where they are, so that left stays left
  const Report r = IAR::isotropic_remeshing(LENGTH, m, parameters::number_of_relaxation_steps(0)
    .do_split(is_right).do_collapse(is_right).do_flip(is_right));
  CHECK(r.splits > 0 && r.collapses > 0 && r.flips > 0);
  CHECK(!before.empty());
  CHECK(left_faces(m) == before);
  for(const auto& t : before)
    for(const Vertex v : t)
      CHECK(bits(m.point(v)) == bits(copy.point(v)));
}

struct Input
{
  Soup soup;
  double length;
};

// A torus, a square with a border, and a cube, along whose edges vertices slide.
std::vector<Input> inputs_that_move() { return {{torus(24, 16, .4), .15}, {square(12), .06}, {cube(6), .12}}; }

// Wherever a vertex is asked for, and where it is in the end, it was before, or had leave to go to.
void vertices_go_where_they_may()
{
  for(const auto& [soup, length] : inputs_that_move())
  {
    Mesh m = to_mesh<Mesh>(soup);
    const Mesh copy = m;
    std::vector<std::set<Kernel::Point_3>> places(copy.number_of_vertices());
    for(const Vertex v : copy.vertices())
      places[v].insert(copy.point(v));
    std::size_t leaves = 0, denials = 0, new_ones = 0;
    const auto may_move = [&](Vertex v, const Kernel::Point_3& from, const Kernel::Point_3& to)
    {
      const bool is_permitted = (to.x() < from.x()) == (to.y() < from.y());
      ++(is_permitted ? leaves : denials);
      new_ones += v == Mesh::null_vertex();
      if(v != Mesh::null_vertex())
      {
        CHECK(places[v].count(from) == 1);
        if(is_permitted)
          places[v].insert(to);
      }
      return is_permitted;
    };
    IAR::isotropic_remeshing(length, m, parameters::allow_move_functor(may_move));
    CHECK(CGAL::is_valid_polygon_mesh(m));
    CHECK(leaves > 0 && denials > 0 && new_ones > 0);
    std::size_t moved = 0;
    for(const Vertex v : m.vertices())
      if(std::size_t(v) < places.size())
      {
        moved += m.point(v) != copy.point(v);
        CHECK(places[v].count(m.point(v)) == 1);
      }
    CHECK(moved > 0);
  }
}

// Without leave no vertex of the input moves, onto another surface neither.
void vertices_without_leave_stay()
{
  const auto never = [](Vertex, const Kernel::Point_3&, const Kernel::Point_3&) { return false; };
  const auto upwards = [](const Kernel::Point_3& p) { return Kernel::Point_3(p.x(), p.y(), p.z() + .3); };
  for(const auto& [soup, length] : inputs_that_move())
    for(const bool is_elsewhere : {false, true})
    {
      Mesh m = to_mesh<Mesh>(soup);
      const Mesh copy = m;
      const Report r = is_elsewhere ? IAR::isotropic_remeshing(length, m, parameters::allow_move_functor(never).projection_functor(upwards))
                                    : IAR::isotropic_remeshing(length, m, parameters::allow_move_functor(never));
      CHECK(r.splits > 0 && r.flips > 0 && CGAL::is_valid_polygon_mesh(m));
      for(const Vertex v : m.vertices())
        if(std::size_t(v) < copy.number_of_vertices())
          CHECK(bits(m.point(v)) == bits(copy.point(v)));
    }
}

// Leave for all costs next to nothing, a state of the functor's is its own, and the mesh is the user's while it is asked.
void leave_for_all_is_as_good_as_none()
{
  Mesh free = to_mesh<Mesh>(torus(24, 16, .4)), asked = free, by_reference = free;
  const double length = .15;
  std::atomic<std::size_t> questions(0);
  struct Counts
  {
    std::atomic<std::size_t>* all;
    std::size_t own = 0;
    bool operator()(Vertex, Kernel::Point_3, Kernel::Point_3) { ++own; ++*all; return true; }
  };
  Counts counts{&questions};
  const Report r = IAR::isotropic_remeshing(length, free);
  const Report s = IAR::isotropic_remeshing<CGAL::Parallel_if_available_tag>(length, asked, parameters::allow_move_functor(counts));
  CHECK(questions > 0 && counts.own == 0);
  IAR::isotropic_remeshing(length, by_reference, parameters::allow_move_functor(std::ref(counts)));
  CHECK(counts.own > 0 && questions == 2 * counts.own);
  CHECK(Picture<Mesh>(asked) == Picture<Mesh>(by_reference));
  CHECK_MESSAGE(s.angles_after.average > r.angles_after.average - 1 && s.angles_after.minimum > 40,
                r.angles_after.average << ", " << s.angles_after.average << ", " << s.angles_after.minimum);
}

void transient_flips_are_asked_for_as_such()
{
  const auto run = [](unsigned glide_depth)
  {
    Mesh m = uneven_mesh();
    IAR::Recipe recipe;
    recipe.glide_depth = glide_depth;
    std::array<std::size_t, 2> asked = {0, 0};
    const Report r = IAR::isotropic_remeshing(LENGTH, m, IAR::recipe(recipe,
      parameters::do_flip([&](const auto& edge) { ++asked[edge.is_transient()]; return true; })));
    return std::make_tuple(asked[0], asked[1], r.flips, r.glides);
  };
  const auto [flips_asked, glide_flips_asked, flips, glides] = run(6);
  CHECK(flips_asked >= flips && flips > 0);
  CHECK(glide_flips_asked >= glides && glides > 0);
  const auto [flips_asked_without, glide_flips_asked_without, flips_without, glides_without] = run(0);
  CHECK(flips_asked_without >= flips_without && flips_without > 0);
  CHECK(glide_flips_asked_without == 0 && glides_without == 0);
}

void the_papers_recipe_has_the_papers_rules()
{
  Mesh by_recipe = uneven_mesh(), by_hand = by_recipe;
  IAR::isotropic_remeshing(LENGTH, by_recipe, IAR::recipe(IAR::Recipe::paper()));
  IAR::Recipe recipe = IAR::Recipe::paper();
  recipe.policies = IAR::Recipe::Policies::measured;
  IAR::isotropic_remeshing(LENGTH, by_hand, IAR::recipe(recipe,
    parameters::do_split(IAR::Inter_angle_split_policy<>(90, IAR::Permit_all(), INFINITE))
               .do_collapse(IAR::Inter_angle_collapse_policy<>(true, true))
               .do_flip(IAR::Inter_angle_flip_policy<>(90, 20))));
  CHECK(Picture<Mesh>(by_recipe) == Picture<Mesh>(by_hand));
}

void rules_are_kept_at_any_scale()
{
  const int iterations = 4;
  Mesh reference = uneven_mesh();
  IAR::isotropic_remeshing(LENGTH, reference, IAR::recipe(IAR::Recipe::paper(), parameters::number_of_iterations(iterations)));
  for(const int exponent : {100, -100, 300, -300})
  {
    const double scale = std::ldexp(1., exponent);
    Mesh scaled = uneven_mesh(scale);
    IAR::isotropic_remeshing(scale * LENGTH, scaled,
                             IAR::recipe(IAR::Recipe::paper(), parameters::number_of_iterations(iterations)));
    CHECK_MESSAGE(triangles(scaled) == triangles(reference), "2^" << exponent);
  }
}

template <class Graph>
void a_profile_is_right()
{
  a_profile_knows_the_edge_and_what_is_around_it<Graph>();
  a_profile_foretells_a_flip<Graph>();
  a_profile_counts_edges<Graph>();
  a_profile_on_the_border_has_one_face<Graph>();
  a_profile_measures_the_angle_between_the_normals<Graph>();
}

int main()
{
  a_profile_is_right<Mesh>();
  a_profile_is_right<Polyhedron>();
  mean_angles_fill_a_flat_neighborhood();
  a_profile_takes_maps_of_all_kinds();

  a_split_waits_for_an_obtuse_neighbor();
  an_obtuse_angle_opposite_of_the_edge_is_what_a_split_is_for();
  a_right_angle_is_not_obtuse();
  a_much_too_long_edge_is_split_beside_any_angle();
  beside_needles_the_split_rule_yields_where_asked_to();
  the_angle_of_the_split_rule_is_a_parameter();

  collapses_stay_away_from_the_border();
  a_collapse_must_not_crowd_a_vertex();
  a_border_vertex_is_judged_by_180_degrees();
  the_degree_judgment_yields_to_length();

  a_flip_must_not_make_an_obtuse_angle();
  a_flip_must_not_crease_the_surface();
  the_two_flip_rules_are_independent();
  the_flips_of_a_glide_pass();

  rules_ask_their_base_first();
  rules_can_be_stacked();
  rules_work_on_a_polyhedron();

  false_binds_every_step();
  a_policy_of_any_kind_is_asked();
  a_policy_that_permits_all_is_no_policy();
  a_policy_sees_the_mesh_as_the_user_has_it();
  a_policy_is_asked_by_the_graded_length();
  without_a_length_no_target_is_known();
  input_vertices_are_the_users_and_new_ones_have_none();
  what_a_policy_denies_stays_as_it_was();
  vertices_go_where_they_may();
  vertices_without_leave_stay();
  leave_for_all_is_as_good_as_none();
  transient_flips_are_asked_for_as_such();
  the_papers_recipe_has_the_papers_rules();
  rules_are_kept_at_any_scale();
  return result();
}
