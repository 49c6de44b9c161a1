// Copyright (c) 2026 The Inter_angle_remeshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The flat mesh is a graph that its operations keep consistent; the way from the user's mesh to it and back leaves
// alone what lies outside of the range and what the user holds on to; and an exception leaves everything as it was.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <CGAL/Inter_angle_remeshing/internal/curves/corners.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/crossings.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/collapse_pass.h>
#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>

#include <CGAL/Polygon_mesh_processing/manifoldness.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/graph_concepts.h>
#include <CGAL/boost/graph/helpers.h>

#include "check.h"
#include "failing_memory.h"
#include "meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>
#include <memory>
#include <new>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace IAR = CGAL::Inter_angle_remeshing;
namespace parameters = CGAL::parameters;
using namespace meshes;

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Flat = IAR::internal::Remeshing_mesh;
using Index = Flat::Index;
using Report = IAR::Remeshing_report;

template <class Graph> using Vertex_of = typename boost::graph_traits<Graph>::vertex_descriptor;
template <class Graph> using Halfedge_of = typename boost::graph_traits<Graph>::halfedge_descriptor;
template <class Graph> using Edge_of = typename boost::graph_traits<Graph>::edge_descriptor;
template <class Graph> using Face_of = typename boost::graph_traits<Graph>::face_descriptor;
template <class Graph> using Faces_of = std::vector<Face_of<Graph>>;
template <class Graph> using Point_map_of = typename boost::property_map<Graph, CGAL::vertex_point_t>::type;

// --- the flat mesh as a graph ------------------------------------------------------------------------------------

void the_flat_mesh_models_the_concepts_of_graphs()
{
  BOOST_CONCEPT_ASSERT((boost::concepts::Graph<Flat>));
  BOOST_CONCEPT_ASSERT((boost::concepts::VertexListGraph<Flat>));
  BOOST_CONCEPT_ASSERT((boost::concepts::EdgeListGraph<Flat>));
  BOOST_CONCEPT_ASSERT((CGAL::HalfedgeGraphConcept<Flat>));
  BOOST_CONCEPT_ASSERT((CGAL::HalfedgeListGraphConcept<Flat>));
  BOOST_CONCEPT_ASSERT((CGAL::FaceGraphConcept<Flat>));
  BOOST_CONCEPT_ASSERT((CGAL::FaceListGraphConcept<Flat>));
}

template <class Graph>
Flat flat_copy(const Graph& g)
{
  const auto vpm = get(CGAL::vertex_point, g);
  return IAR::internal::Flat_copy_builder<Graph, std::decay_t<decltype(vpm)>>(g, vpm, "test").build(faces(g)).mesh;
}

Flat flat_copy(const Soup& soup) { return flat_copy(to_mesh<Mesh>(soup)); }

// What is wrong with a flat mesh; nothing if it is consistent.
class Examination
{
public:
  explicit Examination(const Flat& mesh)
    : mesh_(mesh), corners_of_(mesh.number_of_vertex_slots(), 0)
  {
    for(Index f = 0; f < Index(mesh.number_of_face_slots()); ++f)
      if(mesh.is_face(f))
        examine_face(f);
    expect(faces_ == mesh.number_of_live_faces(), "number of faces", 0);
    std::size_t vertices = 0;
    for(Index v = 0; v < Index(mesh.number_of_vertex_slots()); ++v)
      if(mesh.is_vertex(v))
      {
        ++vertices;
        examine_vertex(v);
      } else
        expect(corners_of_[v] == 0, "a removed vertex has a corner", v);
    expect(vertices == mesh.number_of_live_vertices(), "number of vertices", 0);
  }

  const std::string& complaint() const { return complaint_; }

private:
  void expect(bool holds, const char* what, Index where)
  {
    if(!holds && complaint_.empty())
      complaint_ = what + (" at " + std::to_string(where));
  }

  bool is_live_vertex(Index v) const
  {
    return v >= 0 && v < Index(mesh_.number_of_vertex_slots()) && mesh_.is_vertex(v);
  }

  void examine_face(Index f)
  {
    ++faces_;
    const auto& record = mesh_.face_record(f);
    for(Index k = 0; k < 3; ++k)
    {
      const Index h = 4 * f + k, o = mesh_.opposite(h);
      const Index a = record.vertex[k], b = record.vertex[(k + 1) % 3];
      expect(is_live_vertex(a), "a face has no vertex", h);
      if(!complaint_.empty())
        return;
      ++corners_of_[a];
      expect(a != b, "an edge from a vertex to itself", h);
      expect(edges_.insert({a, b}).second, "two half-edges join the same vertices", h);
      expect(mesh_.source(h) == a && mesh_.target(h) == b, "source, target", h);
      expect(mesh_.opposite(o) == h, "opposite of opposite", h);
      expect(mesh_.is_border(h) == (o < 0), "is_border()", h);
      if(o < 0)
        expect(o == ~h && mesh_.source(o) == b, "border side", h);
      else
      {
        expect(Flat::corner(o) < 3 && mesh_.is_face(Flat::face(o)), "opposite is no half-edge", h);
        expect(mesh_.origin(o) == b && mesh_.target(o) == a, "opposite lies elsewhere", h);
        expect(mesh_.is_constrained(h) == mesh_.is_constrained(o) && mesh_.is_protected(h) == mesh_.is_protected(o),
               "flags differ from side to side", h);
      }
      if(mesh_.is_constrained(h))
        expect((mesh_.marks(a) & mesh_.marks(b) & Flat::ON_FEATURE) != 0, "a constrained edge without feature vertices", h);
      if(mesh_.is_protected(h))
        expect(mesh_.is_locked(a) && mesh_.is_locked(b), "a protected edge with ends that are not locked", h);
    }
    expect((record.edge_flags & ~(511u | 7 * Flat::ON_RIM)) == 0, "flags of no edge", f);
  }

  // One fan, of all corners that the vertex has, begun where the border begins it.
  void examine_vertex(Index v)
  {
    const Index first = mesh_.first(v);
    expect(mesh_.is_face(Flat::face(first)) && mesh_.origin(first) == v, "the fan begins elsewhere", v);
    if(!complaint_.empty())
      return;
    std::size_t corners = 0;
    Index last = first;
    for(Index h = first; corners <= corners_of_[v]; h = mesh_.rotate_ccw(h))
    {
      if(h < 0 || (corners > 0 && h == first))
        break;
      expect(mesh_.origin(h) == v, "the fan leaves the vertex", v);
      ++corners;
      last = h;
    }
    expect(corners == corners_of_[v], "several fans, or an endless one", v);
    const bool is_open = mesh_.rotate_ccw(last) < 0;
    expect(is_open == mesh_.is_border(first), "the fan begins in the middle", v);
    expect(is_open == mesh_.is_border_vertex(v), "ON_BORDER", v);
    expect(std::size_t(mesh_.valence(v)) == corners + (is_open ? 1 : 0), "valence", v);
    std::size_t neighbors = 0;
    mesh_.for_each_neighbor(v, [&](Index u) {
      ++neighbors;
      expect(mesh_.is_adjacent(u, v) && mesh_.is_adjacent(v, u), "is_adjacent()", v);
      expect(mesh_.find_halfedge(v, u) >= 0 || mesh_.find_halfedge(u, v) >= 0, "find_halfedge()", v);
    });
    expect(neighbors == std::size_t(mesh_.valence(v)), "neighbors", v);
  }

  const Flat& mesh_;
  std::vector<std::size_t> corners_of_;
  std::set<std::pair<Index, Index>> edges_;
  std::size_t faces_ = 0;
  std::string complaint_;
};

#define CHECK_CONSISTENT(mesh)                                                    \
  do                                                                              \
  {                                                                               \
    const std::string complaint = Examination(mesh).complaint();                  \
    CHECK_MESSAGE(complaint.empty(), complaint);                                  \
  } while(false)

// The functions of HalfedgeGraph and FaceGraph agree with each other, and with CGAL's reading of them.
void check_graph(const Flat& mesh)
{
  using Traits = boost::graph_traits<Flat>;
  std::size_t halfedge_count = 0, border_count = 0;
  for(const auto h : halfedges(mesh))
  {
    ++halfedge_count;
    CHECK(opposite(opposite(h, mesh), mesh) == h && opposite(h, mesh) != h);
    CHECK(prev(next(h, mesh), mesh) == h && next(prev(h, mesh), mesh) == h);
    CHECK(source(h, mesh) == target(opposite(h, mesh), mesh));
    CHECK(source(next(h, mesh), mesh) == target(h, mesh));
    CHECK(face(next(h, mesh), mesh) == face(h, mesh));
    CHECK(edge(h, mesh) == edge(opposite(h, mesh), mesh));
    const auto of_edge = halfedge(edge(h, mesh), mesh);
    CHECK(of_edge == h || of_edge == opposite(h, mesh));
    CHECK(halfedge(source(h, mesh), target(h, mesh), mesh).second);
    CHECK(edge(source(h, mesh), target(h, mesh), mesh).first == edge(h, mesh));
    const bool is_border = face(h, mesh) == Traits::null_face();
    border_count += is_border;
    CHECK(is_border == CGAL::is_border(h, mesh));
    if(!is_border)
      CHECK(next(next(next(h, mesh), mesh), mesh) == h);
  }
  CHECK(halfedge_count == num_halfedges(mesh) && halfedge_count == 2 * num_edges(mesh));
  CHECK(halfedge_count == 3 * num_faces(mesh) + border_count);
  CHECK(std::size_t(std::distance(edges(mesh).begin(), edges(mesh).end())) == num_edges(mesh));
  std::set<Traits::edge_descriptor> distinct(edges(mesh).begin(), edges(mesh).end());
  CHECK(distinct.size() == num_edges(mesh));
  for(const auto v : vertices(mesh))
  {
    CHECK(target(halfedge(v, mesh), mesh) == v);
    CHECK(bool(CGAL::is_border(v, mesh)) == mesh.is_border_vertex(v.index()));
    // a border vertex is known by its half-edge on the border, as Surface_mesh has it
    CHECK(CGAL::is_border(halfedge(v, mesh), mesh) == mesh.is_border_vertex(v.index()));
    CHECK(degree(v, mesh) == CGAL::halfedges_around_target(halfedge(v, mesh), mesh).size());
  }
  for(const auto f : faces(mesh))
    CHECK(face(halfedge(f, mesh), mesh) == f);
  CHECK(CGAL::is_triangle_mesh(mesh));
  CHECK(CGAL::is_valid_polygon_mesh(mesh));
}

// The number of half-edges in each cycle of the border, sorted.
template <class Graph>
std::vector<std::size_t> border_cycles(const Graph& g)
{
  std::vector<std::size_t> cycles;
  std::set<Halfedge_of<Graph>> seen;
  for(const auto h : halfedges(g))
    if(CGAL::is_border(h, g) && seen.count(h) == 0)
    {
      std::size_t length = 0;
      for(auto k = h; seen.insert(k).second; k = next(k, g))
        ++length;
      cycles.push_back(length);
    }
  std::sort(cycles.begin(), cycles.end());
  return cycles;
}

void borders_can_be_walked_along()
{
  // a square of 6 x 6 cells with two holes, of 1 x 1 and of 2 x 1 cells
  const Flat holed = flat_copy(square_without(6, [](std::size_t i, std::size_t j) {
    return (i == 1 && j == 1) || ((i == 3 || i == 4) && j == 4);
  }));
  CHECK_CONSISTENT(holed);
  check_graph(holed);
  CHECK(border_cycles(holed) == (std::vector<std::size_t>{4, 6, 24}));
  CHECK(!CGAL::is_closed(holed));

  const Flat closed = flat_copy(sphere(2));
  CHECK_CONSISTENT(closed);
  check_graph(closed);
  CHECK(border_cycles(closed).empty());
  CHECK(CGAL::is_closed(closed));

  const Flat triangle = flat_copy(Soup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
  CHECK_CONSISTENT(triangle);
  check_graph(triangle);
  CHECK(border_cycles(triangle) == std::vector<std::size_t>{3});
}

void points_come_back_in_the_users_units()
{
  const Soup soup = sphere(1).scaled(1000).moved(3, 4, 5);
  const Mesh m = to_mesh<Mesh>(soup);
  const Flat flat = flat_copy(m);
  CHECK(flat.unit() > 1);
  std::set<Bits> points, flat_points;
  for(const auto v : m.vertices())
    points.insert(bits(m.point(v)));
  for(const auto v : vertices(flat))
    flat_points.insert(bits(get(CGAL::vertex_point, flat, v)));
  CHECK(flat_points == points);
}

// --- operations --------------------------------------------------------------------------------------------------

using Triangle = std::array<Index, 3>;
using Pair = std::pair<Index, Index>;

Triangle rotated(Index a, Index b, Index c)
{
  Triangle t = {a, b, c};
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

// A mesh as a set of triangles and a set of constrained edges, on which operations are done by the book.
struct Paper_mesh
{
  std::set<Triangle> triangles;
  std::set<Pair> constrained;

  explicit Paper_mesh(const Flat& mesh)
  {
    for(const auto f : faces(mesh))
    {
      const auto& t = mesh.face_record(f.index()).vertex;
      triangles.insert(rotated(t[0], t[1], t[2]));
      for(Index k = 0; k < 3; ++k)
        if(mesh.is_constrained(4 * f.index() + k))
          constrained.insert(std::minmax(t[k], t[(k + 1) % 3]));
    }
  }

  friend bool operator==(const Paper_mesh& a, const Paper_mesh& b)
  {
    return a.triangles == b.triangles && a.constrained == b.constrained;
  }

  void flip(Index a, Index b, Index c, Index d)
  {
    triangles.erase(rotated(a, b, c));
    triangles.erase(rotated(b, a, d));
    triangles.insert(rotated(a, d, c));
    triangles.insert(rotated(d, b, c));
  }

  void split(Index a, Index b, Index c, Index d, Index m)
  {
    triangles.erase(rotated(a, b, c));
    triangles.insert(rotated(a, m, c));
    triangles.insert(rotated(m, b, c));
    if(d >= 0)
    {
      triangles.erase(rotated(b, a, d));
      triangles.insert(rotated(b, m, d));
      triangles.insert(rotated(m, a, d));
    }
    if(constrained.erase(std::minmax(a, b)) > 0)
      constrained.insert({std::minmax(a, m), std::minmax(b, m)});
  }

  void collapse(Index a, Index b)
  {
    const auto moved = [&](Index v) { return v == a ? b : v; };
    std::set<Triangle> all;
    for(const Triangle& t : triangles)
      if(std::count(t.begin(), t.end(), a) + std::count(t.begin(), t.end(), b) < 2)
        all.insert(rotated(moved(t[0]), moved(t[1]), moved(t[2])));
    triangles = all;
    std::set<Pair> edges;
    for(const Pair& e : constrained)
      if(moved(e.first) != moved(e.second))
        edges.insert(std::minmax(moved(e.first), moved(e.second)));
    constrained = edges;
  }

  void renumber(const std::vector<Index>& order)
  {
    std::map<Index, Index> number;
    for(std::size_t i = 0; i < order.size(); ++i)
      number[order[i]] = Index(i);
    std::set<Triangle> all;
    for(const Triangle& t : triangles)
      all.insert(rotated(number[t[0]], number[t[1]], number[t[2]]));
    triangles = all;
    std::set<Pair> edges;
    for(const Pair& e : constrained)
      edges.insert(std::minmax(number[e.first], number[e.second]));
    constrained = edges;
  }
};

// Operations at random places of a mesh, as far as they are legal.
class Random_operations
{
public:
  Random_operations(Flat& mesh, unsigned seed, std::size_t wanted_faces)
    : mesh_(mesh), random_(seed), wanted_faces_(wanted_faces)
  {}

  std::array<std::size_t, 3> done = {0, 0, 0};   // flips, splits, collapses

  // Tries one operation; `paper`, if given, is told about it.
  void step(Paper_mesh* paper)
  {
    const Index h = any_halfedge();
    const bool is_too_large = mesh_.number_of_live_faces() > wanted_faces_;
    const unsigned dice = random_() % 4;
    if(dice < 2)
      try_flip(h, paper);
    else if((dice == 2) != is_too_large)
      try_split(h, paper);
    else
      try_collapse(random_() % 2 == 0 ? h : mesh_.opposite(h), paper);
  }

private:
  Index any_halfedge()
  {
    for(;;)
    {
      const Index h = Index(random_() % (4 * mesh_.number_of_face_slots()));
      if(Flat::corner(h) < 3 && mesh_.is_face(Flat::face(h)))
        return h;
    }
  }

  void try_flip(Index h, Paper_mesh* paper)
  {
    if(!mesh_.is_flip_legal(h))
      return;
    const Index a = mesh_.origin(h), b = mesh_.target(h), c = mesh_.apex(h), d = mesh_.apex(mesh_.opposite(h));
    mesh_.flip(h);
    ++done[0];
    const Index diagonal = Flat::next(h);
    CHECK(std::minmax(mesh_.origin(diagonal), mesh_.target(diagonal)) == std::minmax(c, d));
    if(paper)
      paper->flip(a, b, c, d);
  }

  void try_split(Index h, Paper_mesh* paper)
  {
    if(!mesh_.is_split_legal(h))
      return;
    const Index a = mesh_.origin(h), b = mesh_.target(h), c = mesh_.apex(h), o = mesh_.opposite(h);
    const Index d = o >= 0 ? mesh_.apex(o) : -1;
    // a point of its own for every vertex
    const double t = std::uniform_real_distribution<double>(.25, .75)(random_);
    const IAR::internal::Vector3 p = (1 - t) * mesh_.position(a) + t * mesh_.position(b);
    const Index m = mesh_.split(h, p);
    ++done[1];
    CHECK(mesh_.position(m) == p);
    CHECK(mesh_.input(m) == Flat::NO_VERTEX);
    if(paper)
      paper->split(a, b, c, d, m);
  }

  void try_collapse(Index h, Paper_mesh* paper)
  {
    if(!mesh_.is_collapse_legal(h))
      return;
    const Index a = mesh_.source(h), b = mesh_.source(mesh_.opposite(h));
    const IAR::internal::Vector3 p = mesh_.position(b);
    CHECK(CGAL::Euler::does_satisfy_link_condition(edge(IAR::internal::Mesh_halfedge(h), mesh_), mesh_));
    mesh_.collapse(h);
    ++done[2];
    CHECK(!mesh_.is_vertex(a) && mesh_.is_vertex(b) && mesh_.position(b) == p);
    if(paper)
      paper->collapse(a, b);
  }

  Flat& mesh_;
  std::mt19937 random_;
  std::size_t wanted_faces_;
};

int euler_characteristic(const Flat& mesh)
{
  return int(num_vertices(mesh)) - int(num_edges(mesh)) + int(num_faces(mesh));
}

void check_random_operations(Flat mesh, const char* name, std::size_t steps, std::size_t wanted_faces)
{
  const int characteristic = euler_characteristic(mesh);
  const std::size_t cycles = border_cycles(mesh).size();
  Paper_mesh paper(mesh);
  Random_operations operations(mesh, unsigned(steps), wanted_faces);
  for(std::size_t i = 0; i < steps; ++i)
  {
    operations.step(&paper);
    if(i % 8 == 0 || mesh.number_of_live_faces() < 20)
    {
      const std::string complaint = Examination(mesh).complaint();
      CHECK_MESSAGE(complaint.empty(), name << ", step " << i << ": " << complaint);
      if(!complaint.empty())
        return;
    }
    if(i % 64 == 0)
      CHECK_MESSAGE(Paper_mesh(mesh) == paper, name << ", step " << i);
    if(i % 256 == 255)
    {
      const std::vector<Index> order = IAR::internal::morton_order(mesh);
      mesh.renumber<CGAL::Sequential_tag>(order);
      paper.renumber(order);
      CHECK_CONSISTENT(mesh);
      CHECK(mesh.number_of_face_slots() == mesh.number_of_live_faces());
      CHECK(mesh.number_of_vertex_slots() == mesh.number_of_live_vertices());
    }
  }
  CHECK_CONSISTENT(mesh);
  check_graph(mesh);
  CHECK_MESSAGE(Paper_mesh(mesh) == paper, name);
  CHECK_MESSAGE(euler_characteristic(mesh) == characteristic, name);
  CHECK_MESSAGE(border_cycles(mesh).size() == cycles, name);
  CHECK_MESSAGE(operations.done[0] > 0 && operations.done[1] > 0 && operations.done[2] > 0, name);
}

// Constrains every edge whose number `which` accepts, and locks the ends and junctions of curves.
template <class Predicate>
Flat constrained(Flat mesh, const Predicate& which)
{
  std::size_t number = 0;
  for(const auto e : edges(mesh))
    if(which(number++))
    {
      mesh.add_flags(e.index(), Flat::CONSTRAINED);
      mesh.add_marks(source(e, mesh).index(), Flat::ON_FEATURE);
      mesh.add_marks(target(e, mesh).index(), Flat::ON_FEATURE);
    }
  for(const auto v : vertices(mesh))
  {
    int curve_edges = 0;
    for(const auto h : CGAL::halfedges_around_target(halfedge(v, mesh), mesh))
      curve_edges += mesh.is_on_curve_edge(edge(h, mesh).index());
    if(curve_edges > 0 && curve_edges != 2)
      mesh.add_marks(v.index(), Flat::LOCKED);
  }
  return mesh;
}

void operations_keep_the_mesh_consistent()
{
  const std::size_t steps = is_small_run() ? 400 : 4000;
  const auto cross = [](std::size_t i, std::size_t j) { return i == 2 && j >= 2 && j <= 3; };
  check_random_operations(flat_copy(tetrahedron()), "tetrahedron", steps, 4);
  check_random_operations(flat_copy(octahedron()), "octahedron", steps, 8);
  check_random_operations(flat_copy(tetrahedron()), "growing tetrahedron", steps, 200);
  check_random_operations(flat_copy(Soup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}), "triangle", steps, 3);
  check_random_operations(flat_copy(square(1)), "two triangles", steps, 12);
  check_random_operations(flat_copy(square_without(6, cross)), "square with a hole", steps, 60);
  check_random_operations(flat_copy(torus(8, 5, .3)), "torus", steps, 80);
  check_random_operations(flat_copy(sphere(2).joined_with(square(3).moved(3, 0, 0))), "two components", steps, 100);
  check_random_operations(constrained(flat_copy(sphere(2)), [](std::size_t i) { return i % 5 == 0; }),
                          "constrained sphere", steps, 150);
  check_random_operations(constrained(flat_copy(square(5)), [](std::size_t i) { return i % 3 == 0; }),
                          "constrained square", steps, 60);
}

// What a tetrahedron cannot do.
void a_tetrahedron_can_be_split_and_no_more()
{
  const Flat mesh = flat_copy(tetrahedron());
  for(const auto h : halfedges(mesh))
  {
    CHECK(!mesh.is_flip_legal(h.index()));
    CHECK(!mesh.is_collapse_legal(h.index()));
    CHECK(mesh.is_split_legal(h.index()));
  }
}

// On a closed mesh without marks, everything is legal that the topology allows.
// A split of an edge between two faces with the same corners would join these by a second edge.
void two_faces_with_the_same_corners_stay()
{
  const Flat mesh = flat_copy(Soup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}});
  for(Index h = 0; h < 8; ++h)
    if(mesh.corner(h) < 3)
      CHECK(!mesh.is_split_legal(h) && !mesh.is_flip_legal(h) && !mesh.is_collapse_legal(h));
  Mesh m = to_mesh<Mesh>(Soup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}});
  const Picture<Mesh> before(m);
  IAR::isotropic_remeshing(.1, m);
  CHECK(Picture<Mesh>(m) == before);
}

void what_the_topology_allows_is_legal()
{
  Flat mesh = flat_copy(sphere(1));
  Random_operations operations(mesh, 5, 40);
  std::size_t legal_flips = 0, legal_collapses = 0;
  for(int i = 0; i < (is_small_run() ? 50 : 300); ++i)
  {
    for(const auto h : halfedges(mesh))
    {
      using IAR::internal::Mesh_vertex;
      const bool has_diagonal = halfedge(Mesh_vertex(mesh.apex(h.index())),
                                         Mesh_vertex(mesh.apex(mesh.opposite(h.index()))), mesh).second;
      CHECK(mesh.is_flip_legal(h.index()) == !has_diagonal);
      const bool has_link = CGAL::Euler::does_satisfy_link_condition(edge(h, mesh), mesh);
      CHECK(mesh.is_collapse_legal(h.index()) == has_link);
      legal_flips += !has_diagonal;
      legal_collapses += has_link;
    }
    operations.step(nullptr);
  }
  CHECK(legal_flips > 0 && legal_collapses > 0);
}

void marks_forbid()
{
  Flat mesh = flat_copy(square(4));
  Index inner = -1;
  for(const auto h : halfedges(mesh))
    if(h.index() >= 0 && !mesh.is_border_vertex(mesh.origin(h.index())) &&
       !mesh.is_border_vertex(mesh.target(h.index())))
      inner = h.index();
  const Index o = mesh.opposite(inner);
  CHECK(mesh.is_flip_legal(inner) && mesh.is_split_legal(inner));
  CHECK(mesh.is_collapse_legal(inner) && mesh.is_collapse_legal(o));

  Flat locked = mesh;
  locked.add_marks(locked.origin(inner), Flat::LOCKED);
  CHECK(!locked.is_collapse_legal(inner));
  CHECK(locked.is_collapse_legal(o));

  Flat on_feature = mesh;  // from a curve across the surface
  on_feature.add_marks(on_feature.origin(inner), Flat::ON_FEATURE);
  CHECK(!on_feature.is_collapse_legal(inner) && on_feature.is_collapse_legal(o));

  Flat feature = mesh;
  feature.add_flags(inner, Flat::CONSTRAINED);
  feature.add_marks(feature.origin(inner), Flat::ON_FEATURE);
  feature.add_marks(feature.target(inner), Flat::ON_FEATURE);
  CHECK(!feature.is_flip_legal(inner) && !feature.is_flip_legal(o));
  CHECK(feature.is_split_legal(inner) && feature.is_collapse_legal(inner));

  Flat guarded = mesh;
  guarded.add_flags(inner, Flat::PROTECTED);
  for(const Index h : {inner, o})
    CHECK(!guarded.is_flip_legal(h) && !guarded.is_split_legal(h) && !guarded.is_collapse_legal(h));
}

// --- there and back ----------------------------------------------------------------------------------------------

// Faces by their points: what is left when descriptors do not matter.
using Bits_triangle = std::array<Bits, 3>;

Bits_triangle rotated(Bits_triangle t)
{
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

template <class Graph, class Faces>
std::vector<Bits_triangle> shapes(const Faces& range, const Graph& g)
{
  std::vector<Bits_triangle> result;
  for(const auto f : range)
  {
    const auto h = halfedge(f, g);
    result.push_back(rotated({bits(get(CGAL::vertex_point, g, source(h, g))), bits(get(CGAL::vertex_point, g, target(h, g))),
                              bits(get(CGAL::vertex_point, g, target(next(h, g), g)))}));
  }
  std::sort(result.begin(), result.end());
  return result;
}

template <class Graph>
std::vector<Bits_triangle> shapes(const Graph& g) { return shapes(faces(g), g); }

// What must not change: the faces outside of a range with all that they refer to, their sides on the border, and the
// vertices without a face in the range, isolated ones included.
template <class Graph>
class Outside
{
public:
  Outside(const Graph& g, const Faces_of<Graph>& range)
  {
    std::set<Vertex_of<Graph>> near;
    for(const auto f : range)
      for(const auto v : CGAL::vertices_around_face(halfedge(f, g), g))
        near.insert(v);
    for(const auto v : vertices(g))
      if(near.count(v) == 0)
        vertices_.push_back(v);
    const std::set<Face_of<Graph>> inside(range.begin(), range.end());
    for(const auto f : faces(g))
      if(inside.count(f) == 0)
        faces_.push_back(f);
    std::sort(faces_.begin(), faces_.end());
    look(g);
  }

  const Faces_of<Graph>& faces_outside() const { return faces_; }

  bool is_as_it_was(const Graph& g) const
  {
    Outside now = *this;
    now.look(g);
    return now.halfedge_rows_ == halfedge_rows_ && now.face_rows_ == face_rows_ && now.points_ == points_ &&
           now.vertex_rows_ == vertex_rows_;
  }

private:
  using Halfedge_row = decltype(row(Halfedge_of<Graph>(), std::declval<const Graph&>()));
  using Face_row = decltype(face_row(Face_of<Graph>(), std::declval<const Graph&>()));
  using Vertex_row = decltype(vertex_row(Vertex_of<Graph>(), std::declval<const Graph&>()));

  void look(const Graph& g)
  {
    halfedge_rows_.clear();
    face_rows_.clear();
    vertex_rows_.clear();
    for(const auto f : faces_)
    {
      face_rows_.push_back(face_row<Graph>(f, g));
      for(const auto h : CGAL::halfedges_around_face(halfedge(f, g), g))
      {
        halfedge_rows_.push_back(row<Graph>(h, g));
        if(CGAL::is_border(opposite(h, g), g))
          halfedge_rows_.push_back(border_row(opposite(h, g), g));
      }
    }
    for(const auto v : vertices_)
      vertex_rows_.push_back(vertex_row<Graph>(v, g));
    points_ = shapes(faces_, g);
  }

  // Where the range touches the faces outside at a vertex, the border runs on along the range's edges, which may be others afterwards.
  Halfedge_row border_row(Halfedge_of<Graph> h, const Graph& g) const
  {
    Halfedge_row result = row<Graph>(h, g);
    for(Halfedge_of<Graph>* neighbor : {&std::get<1>(result), &std::get<2>(result)})
      if(!std::binary_search(faces_.begin(), faces_.end(), face(opposite(*neighbor, g), g)))
        *neighbor = Halfedge_of<Graph>();
    return result;
  }

  Faces_of<Graph> faces_;                    // sorted
  std::vector<Vertex_of<Graph>> vertices_;
  std::vector<Halfedge_row> halfedge_rows_;
  std::vector<Face_row> face_rows_;
  std::vector<Vertex_row> vertex_rows_;
  std::vector<Bits_triangle> points_;
};

template <class Graph>
std::size_t number_of_isolated_vertices(const Graph& g)
{
  return std::size_t(std::count_if(vertices(g).begin(), vertices(g).end(), [&](Vertex_of<Graph> v) {
    return halfedge(v, g) == boost::graph_traits<Graph>::null_halfedge();
  }));
}

// Isolated vertices are no flaw here, as they are for CGAL::is_valid_polygon_mesh().
template <class Graph>
bool is_valid_mesh(Graph g)
{
  std::vector<Vertex_of<Graph>> isolated;
  for(const auto v : vertices(g))
    if(halfedge(v, g) == boost::graph_traits<Graph>::null_halfedge())
      isolated.push_back(v);
  for(const auto v : isolated)
    remove_vertex(v, g);
  return CGAL::is_valid_polygon_mesh(g);
}

template <class Graph>
bool has_doubled_edges(const Graph& g)
{
  std::set<std::array<Vertex_of<Graph>, 2>> seen;
  for(const auto h : halfedges(g))
    if(!seen.insert({source(h, g), target(h, g)}).second)
      return true;
  return false;
}

template <class Graph>
Faces_of<Graph> all_faces(const Graph& g) { return Faces_of<Graph>(faces(g).begin(), faces(g).end()); }

template <class Graph>
Point_of<Graph> centroid(Face_of<Graph> f, const Graph& g)
{
  const auto h = halfedge(f, g);
  return CGAL::centroid(get(CGAL::vertex_point, g, source(h, g)), get(CGAL::vertex_point, g, target(h, g)),
                        get(CGAL::vertex_point, g, target(next(h, g), g)));
}

// The faces whose centroid `is_inside` accepts.
template <class Graph, class Predicate>
Faces_of<Graph> faces_where(const Graph& g, const Predicate& is_inside)
{
  Faces_of<Graph> range;
  for(const auto f : faces(g))
    if(is_inside(centroid(f, g)))
      range.push_back(f);
  return range;
}

// Meshes of every kind that the exchange must cope with.
struct Named_soup
{
  const char* name;
  Soup soup;
};

std::vector<Named_soup> soups()
{
  const auto cross = [](std::size_t i, std::size_t j) { return i == 2 && j >= 2 && j <= 3; };
  const auto frame = [](std::size_t i, std::size_t j) { return i >= 2 && i <= 3 && j >= 1 && j <= 4; };
  const auto bow_tie = [](std::size_t i, std::size_t j) { return (i < 2) != (j < 2); };
  const auto chess = [](std::size_t i, std::size_t j) { return (i + j) % 2 == 1; };
  return {{"sphere", sphere(2)},
          {"torus", torus(8, 5, .3)},
          {"tetrahedron", tetrahedron()},
          {"triangle", Soup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}},
          {"square with a hole", without_isolated_points(square_without(6, cross))},
          {"frame and isolated vertices", square_without(6, frame)},
          {"two wings at a vertex", without_isolated_points(square_without(4, bow_tie))},
          {"cells that touch at their corners", square_without(4, chess)},
          {"components", sphere(1).joined_with(sphere(1).moved(5, 0, 0)).joined_with(square(3).moved(0, 5, 0))}};
}

// Every other mesh that is known by its name has garbage: a component that has been removed.
Mesh mesh_with_garbage(const Soup& soup)
{
  Mesh m;
  add_soup(sphere(1).moved(0, 0, 9), m);
  const std::size_t garbage = m.number_of_faces();
  add_soup(soup, m);
  for(std::size_t f = 0; f < garbage; ++f)
    CGAL::Euler::remove_face(m.halfedge(Mesh::Face_index(unsigned(f))), m);
  return m;
}

// The range and the faces that share an edge with it.
template <class Graph>
Faces_of<Graph> with_faces_beside(const Faces_of<Graph>& range, const Graph& g)
{
  std::set<Face_of<Graph>> result(range.begin(), range.end());
  for(const auto f : range)
    for(const auto h : CGAL::halfedges_around_face(halfedge(f, g), g))
      if(!CGAL::is_border(opposite(h, g), g))
        result.insert(face(opposite(h, g), g));
  return {result.begin(), result.end()};
}

// Twice the area times the normal.
template <class Graph>
Kernel::Vector_3 cross_product(Face_of<Graph> f, const Graph& g)
{
  const auto h = halfedge(f, g);
  const auto point = [&](Vertex_of<Graph> v) { return Point(get(CGAL::vertex_point, g, v)); };
  const Point p = point(source(h, g));
  return CGAL::cross_product(point(target(h, g)) - p, point(target(next(h, g), g)) - p);
}

// Takes a range over to a flat mesh, works at random on it, and takes it back. Where the rim may be split, faces beside it are divided,
// each into triangles that have its area together. Returns how many faces that makes.
template <class Graph>
std::size_t check_random_exchange(Graph& g, const Faces_of<Graph>& range, const std::string& name, unsigned seed, bool may_split_rim)
{
  CHECK_MESSAGE(is_valid_mesh(g), name);
  const Outside<Graph> outside(g, may_split_rim ? with_faces_beside(range, g) : range);
  std::map<Face_of<Graph>, Kernel::Vector_3> areas;
  for(const auto f : faces(g))
    areas[f] = cross_product(f, g);
  const std::vector<std::size_t> cycles = border_cycles(g);
  const bool is_closed = CGAL::is_closed(g);
  const std::size_t isolated = number_of_isolated_vertices(g), input_faces = faces(g).size();
  std::map<Vertex_of<Graph>, Bits> points;
  for(const auto v : vertices(g))
    points[v] = bits(get(CGAL::vertex_point, g, v));

  const auto vpm = get(CGAL::vertex_point, g);
  IAR::internal::Mesh_exchange<Graph, Point_map_of<Graph>> exchange(range, g, vpm, "test");
  Flat flat = exchange.take_mesh(may_split_rim);
  CHECK_CONSISTENT(flat);
  flat.renumber<CGAL::Sequential_tag>(IAR::internal::morton_order(flat));
  Random_operations operations(flat, seed, seed % 2 == 0 ? range.size() / 2 : 2 * range.size());
  for(std::size_t i = 0; i < 10 * range.size(); ++i)
    operations.step(nullptr);
  flat.renumber<CGAL::Sequential_tag>(flat.block_order());
  CHECK_CONSISTENT(flat);
  exchange.plan_outside_faces(flat);
  exchange.write(flat, [](const auto&) {}, []() {});

  CHECK_MESSAGE(is_valid_mesh(g), name);
  if(!is_valid_mesh(g))
    return 0;
  CHECK_MESSAGE(!has_doubled_edges(g), name);
  CHECK_MESSAGE(outside.is_as_it_was(g), name);
  CHECK_MESSAGE(CGAL::is_closed(g) == is_closed, name);
  CHECK_MESSAGE(border_cycles(g).size() == cycles.size(), name);
  CHECK_MESSAGE(number_of_isolated_vertices(g) == isolated, name);
  const std::size_t new_faces = exchange.outside_faces().number_of_new_faces();
  CHECK_MESSAGE(may_split_rim || new_faces == 0, name);
  CHECK_MESSAGE(faces(g).size() == input_faces - range.size() + num_faces(flat) + new_faces, name);
  // the faces of the range are those of the flat mesh
  Faces_of<Graph> written;
  for(std::size_t f = 0; f < num_faces(flat); ++f)
    written.push_back(exchange.written_face(Flat::Index(f)));
  CHECK_MESSAGE(shapes(written, g) == shapes(flat), name);
  for(const auto f : range)
    areas.erase(f);
  std::map<Face_of<Graph>, Kernel::Vector_3> areas_now;
  for(const auto& [f, area] : areas)
    areas_now[f] = cross_product(f, g);
  exchange.outside_faces().for_each_new_face([&](auto from, auto f) { areas_now[from] = areas_now[from] + cross_product(f, g); });
  CHECK_MESSAGE(areas_now.size() == areas.size(), name);
  for(const auto& [f, area] : areas)
    CHECK_MESSAGE(CGAL::approximate_sqrt((areas_now[f] - area).squared_length()) < 1e-12, name);
  // who survived is where it was; who is not there any more was removed
  for(const auto v : vertices(flat))
    if(flat.input(v.index()) != Flat::NO_VERTEX)
    {
      const auto user = exchange.input_vertices()[std::size_t(flat.input(v.index()))];
      CHECK_MESSAGE(bits(get(CGAL::vertex_point, g, user)) == points[user], name);
      CHECK_MESSAGE(bits(get(CGAL::vertex_point, flat, v)) == points[user], name);
    }
  return new_faces;
}

template <class Graph, class Make>
void ranges_of_any_shape_come_back(const Make& make)
{
  const unsigned seeds = is_small_run() ? 2 : 12;
  std::size_t divided = 0;
  for(const Named_soup& s : soups())
    for(unsigned seed = 0; seed < seeds; ++seed)
    {
      // all faces; half of them; any; a single one; all but one
      std::mt19937 random(seed);
      const auto check = [&](const char* range_name, const auto& select)
      {
        Graph g = make(s.soup);
        Faces_of<Graph> range;
        std::size_t number = 0;
        for(const auto f : faces(g))
          if(select(number++, centroid(f, g)))
            range.push_back(f);
        if(!range.empty())
          divided += check_random_exchange(g, range, std::string(s.name) + ", " + range_name + ", " +
                                                     std::to_string(seed), seed, seed % 3 != 0);
      };
      const std::size_t one = random() % s.soup.faces.size();
      const double turn = seed;
      check("all", [](std::size_t, const Point&) { return true; });
      check("half", [&](std::size_t, const Point& p) { return p.x() * std::cos(turn) + p.y() * std::sin(turn) > .1; });
      check("any", [&](std::size_t, const Point&) { return random() % 2 == 0; });
      check("many", [&](std::size_t, const Point&) { return random() % 8 != 0; });
      check("one", [&](std::size_t number, const Point&) { return number == one; });
      check("all but one", [&](std::size_t number, const Point&) { return number != one; });
    }
  CHECK_MESSAGE(divided > 100, divided);
}

// --- ranges through isotropic_remeshing() ------------------------------------------------------------------------

// Remeshes a range with the defaults and checks that nothing else has changed.
template <class Graph>
Report check_range(Graph& g, const Faces_of<Graph>& range, double length, const char* name)
{
  const Outside<Graph> outside(g, range);
  const bool is_closed = CGAL::is_closed(g);
  const std::size_t cycles = border_cycles(g).size(), isolated = number_of_isolated_vertices(g);
  const Report report = IAR::isotropic_remeshing(range, length, g);
  CHECK_MESSAGE(report.ending == Report::Ending::completed, name);
  CHECK_MESSAGE(report.input_faces == range.size(), name);
  CHECK_MESSAGE(is_valid_mesh(g) && !has_doubled_edges(g), name);
  CHECK_MESSAGE(outside.is_as_it_was(g), name);
  CHECK_MESSAGE(faces(g).size() == outside.faces_outside().size() + report.output_faces, name);
  CHECK_MESSAGE(CGAL::is_closed(g) == is_closed, name);
  CHECK_MESSAGE(border_cycles(g).size() == cycles, name);
  CHECK_MESSAGE(number_of_isolated_vertices(g) == isolated, name);
  return report;
}

// Without a length and without flips vertices move, and that is all: whatever is attached to an element stays right.
template <class Graph>
void elements_stay_where_vertices_only_move()
{
  Graph g = to_mesh<Graph>(torus(24, 12, .3));
  for (const bool is_whole : {true, false}) {
    const auto corners = [&]() {
      std::vector<std::array<Vertex_of<Graph>, 3>> result;
      for (const auto f : faces(g)) {
        const auto h = halfedge(f, g);
        result.push_back({source(h, g), target(h, g), target(next(h, g), g)});
      }
      return result;
    };
    const auto ends = [&]() {
      std::vector<std::pair<Vertex_of<Graph>, Vertex_of<Graph>>> result;
      for (const auto e : edges(g)) result.emplace_back(source(e, g), target(e, g));
      return result;
    };
    const auto points = [&]() {
      std::vector<Point> result;
      for (const auto v : vertices(g)) result.push_back(get(CGAL::vertex_point, g, v));
      return result;
    };
    const Faces_of<Graph> before(faces(g).begin(), faces(g).end());
    const auto corners_before = corners();
    const auto ends_before = ends();
    const auto points_before = points();
    IAR::isotropic_remeshing(is_whole ? before : faces_where(g, [](const Point& p) { return p.x() > 0; }), 0, g,
                             CGAL::parameters::do_flip(false));
    CHECK(CGAL::is_valid_polygon_mesh(g));
    CHECK(Faces_of<Graph>(faces(g).begin(), faces(g).end()) == before);
    CHECK(corners() == corners_before);
    CHECK(ends() == ends_before);
    CHECK(points() != points_before);
  }
}

template <class Graph>
void half_of_a_mesh_can_be_remeshed()
{
  for(const double length : {.1, .5})
  {
    Graph g = to_mesh<Graph>(sphere(3));
    const auto right = faces_where(g, [](const Point& p) { return p.x() > 0; });
    const Report report = check_range(g, right, length, "half of a sphere");
    CHECK(length < .2 ? report.splits > 0 : report.collapses > 0);
  }
}

template <class Graph>
void one_face_can_be_remeshed()
{
  Graph g = to_mesh<Graph>(octahedron());
  const Report report = check_range(g, {*faces(g).begin()}, .2, "one face");
  // its edges, of the length 1.4, belong to the faces around, too; what is split lies inside
  CHECK(report.splits == 0 && report.output_faces == 1);
  Graph alone = to_mesh<Graph>(Soup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
  CHECK(check_range(alone, all_faces(alone), .1, "a triangle").output_faces > 50);
}

template <class Graph>
double least_angle(Face_of<Graph> f, const Graph& g)
{
  double result = 180;
  for(const auto h : CGAL::halfedges_around_face(halfedge(f, g), g))
    result = (std::min)(result, double(CGAL::approximate_angle(Point(get(CGAL::vertex_point, g, source(h, g))),
                                                               Point(get(CGAL::vertex_point, g, target(h, g))),
                                                               Point(get(CGAL::vertex_point, g, target(next(h, g), g))))));
  return result;
}

// A mesh in parts, one after the other, by the side on which the centroids of its faces lie: what the first one makes of the common rim
// is good for the second one, too. Returns the number of poor faces.
template <class Graph>
std::size_t poor_faces_after_both_halves(const Soup& soup, double length, bool splits_rim)
{
  Graph g = to_mesh<Graph>(soup);
  IAR::Recipe recipe;
  recipe.split_rim = splits_rim;
  for(const double side : {1., -1.})
  {
    const auto range = faces_where(g, [&](const Point& p) { return side * p.x() > 0; });
    const Outside<Graph> outside(g, splits_rim ? with_faces_beside(range, g) : range);
    const Report report = IAR::isotropic_remeshing(range, length, g, IAR::recipe(recipe));
    CHECK(is_valid_mesh(g) && CGAL::is_closed(g) && !has_doubled_edges(g) && outside.is_as_it_was(g));
    CHECK(report.crossing_faces == 0);
  }
  std::size_t poor = 0;
  for(const auto f : faces(g))
    poor += least_angle(f, g) < 33;
  return poor;
}

template <class Graph>
void rims_are_split_where_that_is_asked_for()
{
  for(const Soup& soup : {sphere(3), torus(40, 20, .4)})
    for(const double length : {.03, .015})
    {
      const std::size_t whole = poor_faces_after_both_halves<Graph>(soup, length, false),
                        split = poor_faces_after_both_halves<Graph>(soup, length, true);
      CHECK_MESSAGE(whole > 20 && 5 * split < whole, length << ": " << split << " of " << whole);
    }
}

template <class Graph>
void a_range_may_have_a_hole()
{
  Graph g = to_mesh<Graph>(square(12));
  const auto ring = faces_where(g, [](const Point& p) {
    const double r = std::max(std::abs(p.x() - .5), std::abs(p.y() - .5));
    return r > .2 && r < .4;
  });
  CHECK(check_range(g, ring, .03, "a ring").splits > 0);
}

template <class Graph>
void a_range_may_touch_itself()
{
  for(const double length : {.03, .3})
  {
    // two quarters that meet at (.5, .5) alone, where the other two lie between them
    Graph g = to_mesh<Graph>(square(8));
    const auto quarters = faces_where(g, [](const Point& p) { return (p.x() < .5) == (p.y() < .5); });
    check_range(g, quarters, length, "two quarters");
  }
}

template <class Graph>
double longest_edge(const Graph& g)
{
  double result = 0;
  for(const auto e : edges(g))
    result = (std::max)(result, CGAL::squared_distance(get(CGAL::vertex_point, g, source(e, g)),
                                                       get(CGAL::vertex_point, g, target(e, g))));
  return std::sqrt(result);
}

// Where only points are shared, the mesh is as good there as elsewhere.
template <class Graph>
void check_touching_parts(Graph& g, const Faces_of<Graph>& range, double length, const char* name)
{
  const Report report = check_range(g, range, length, name);
  CHECK_MESSAGE(report.angles_after.minimum > 30 && report.angles_after.maximum < 110, name);
  if(range.size() == faces(g).size())
    CHECK_MESSAGE(longest_edge(g) < 2 * length, name);
}

template <class Graph>
void a_mesh_may_touch_itself()
{
  const Soup wings = without_isolated_points(square_without(8, [](std::size_t i, std::size_t j) {
    return (i < 4) != (j < 4);
  }));
  for(const double length : {.03, .3})
  {
    Graph both = to_mesh<Graph>(wings);
    check_touching_parts(both, all_faces(both), length, "two wings");
    for(const bool is_left : {false, true})
    {
      Graph one = to_mesh<Graph>(wings);
      check_touching_parts(one, faces_where(one, [&](const Point& p) { return (p.x() < .5) == is_left; }), length,
                           "one of two wings");
    }
    Graph cells = to_mesh<Graph>(without_isolated_points(square_without(5, [](std::size_t i, std::size_t j) {
      return (i + j) % 2 == 1;
    })));
    check_touching_parts(cells, all_faces(cells), length / 4, "cells that touch at their corners");
  }
}

// Two spheres with a vertex in common, at which the mesh has no border.
void closed_parts_may_share_a_vertex()
{
  for(const double length : {.05, .2, .6})
  {
    Mesh g = to_mesh<Mesh>(sphere(2).joined_with(sphere(2).moved(2, 0, 0)));
    std::vector<Mesh::Vertex_index> shared;
    for(const auto v : g.vertices())
      if(CGAL::squared_distance(g.point(v), Point(1, 0, 0)) < 1e-12)
        shared.push_back(v);
    CHECK(shared.size() == 2);
    const Mesh::Vertex_index kept = shared.front(), doubled = shared.back();
    const std::vector<Mesh::Halfedge_index> fan(CGAL::halfedges_around_target(g.halfedge(doubled), g).begin(),
                                                CGAL::halfedges_around_target(g.halfedge(doubled), g).end());
    for(const auto h : fan)
      g.set_target(h, kept);
    g.set_halfedge(doubled, Mesh::null_halfedge());
    g.remove_vertex(doubled);
    IAR::isotropic_remeshing(g.faces(), length, g);
    CHECK(CGAL::is_closed(g) && g.is_valid(false));
    std::size_t fans = 0;
    for(const auto h : g.halfedges())
      fans += g.target(h) == kept && h == *std::min_element(CGAL::halfedges_around_target(h, g).begin(),
                                                            CGAL::halfedges_around_target(h, g).end());
    CHECK(fans == 2);
    CHECK(longest_edge(g) < 1.7 * length);
    // as meshes apart from each other they are manifold
    CHECK(CGAL::Polygon_mesh_processing::duplicate_non_manifold_vertices(g) == 1);
    CHECK(CGAL::is_valid_polygon_mesh(g));
  }
}

template <class Graph>
void one_component_of_several_can_be_remeshed()
{
  Graph g = to_mesh<Graph>(sphere(2).joined_with(sphere(2).moved(3, 0, 0)).joined_with(square(4).moved(0, 3, 0)));
  const auto middle = faces_where(g, [](const Point& p) { return p.x() > 1.5; });
  CHECK(check_range(g, middle, .1, "one of three components").splits > 0);
}

template <class Graph>
void isolated_vertices_stay()
{
  Graph g = to_mesh<Graph>(square_without(6, [](std::size_t i, std::size_t j) { return i < 3 && j < 3; }));
  CHECK(number_of_isolated_vertices(g) == 9);
  check_range(g, all_faces(g), .1, "isolated vertices");
}

template <class Graph>
void ranges_are_kept()
{
  elements_stay_where_vertices_only_move<Graph>();
  half_of_a_mesh_can_be_remeshed<Graph>();
  one_face_can_be_remeshed<Graph>();
  a_range_may_have_a_hole<Graph>();
  rims_are_split_where_that_is_asked_for<Graph>();
  a_range_may_touch_itself<Graph>();
  a_mesh_may_touch_itself<Graph>();
  one_component_of_several_can_be_remeshed<Graph>();
  isolated_vertices_stay<Graph>();
}

void garbage_makes_no_difference()
{
  Mesh with_garbage = mesh_with_garbage(sphere(2).scaled(1.5)), without = to_mesh<Mesh>(sphere(2).scaled(1.5));
  CHECK(with_garbage.has_garbage());
  IAR::isotropic_remeshing(.2, with_garbage);
  IAR::isotropic_remeshing(.2, without);
  CHECK(is_valid_mesh(with_garbage));
  CHECK(shapes(with_garbage) == shapes(without));
}

// Vertex numbers of the user's own tell who is who.
void vertices_keep_what_the_user_attached_to_them()
{
  Mesh m = to_mesh<Mesh>(sphere(3));
  const std::size_t input_vertices = m.number_of_vertices();
  const Mesh copy = m;
  auto number = m.add_property_map<Mesh::Vertex_index, int>("v:number", -1).first;
  for(const auto v : m.vertices())
    number[v] = int(v);
  // without relaxation a vertex that survives has its point, too
  const Report report = IAR::isotropic_remeshing(.2, m, parameters::number_of_relaxation_steps(0).do_project(false));
  CHECK(report.collapses > 0);
  std::size_t survivors = 0;
  for(const auto v : m.vertices())
    if(std::size_t(v) < input_vertices)
    {
      ++survivors;
      CHECK(number[v] == int(v));
      CHECK(bits(m.point(v)) == bits(copy.point(v)));
    } else
      CHECK(number[v] == -1);
  CHECK(survivors > input_vertices / 10 && survivors < input_vertices);
}

// A point that no double can hold stays what it is where its vertex does not move.
void exact_points_stay_exact()
{
  using Exact_kernel = CGAL::Simple_cartesian<CGAL::Exact_rational>;
  using Exact_point = Exact_kernel::Point_3;
  CGAL::Surface_mesh<Exact_point> m;
  const CGAL::Exact_rational third = CGAL::Exact_rational(1) / 3;
  const Soup soup = square(6);
  add_soup(soup, m);
  std::map<unsigned, Exact_point> points;
  for(const auto v : m.vertices())
    points[v] = m.point(v) = Exact_point(third * m.point(v).x(), third * m.point(v).y(), third);
  const auto range = faces_where(m, [&](const auto& p) { return p.x() < third / 2; });
  const Report report = IAR::isotropic_remeshing(range, .02, m, parameters::relax_constraints(false));
  CHECK(report.splits > 0);
  std::size_t kept = 0;
  for(const auto v : m.vertices())
    if(points.count(v) > 0 && (m.is_border(v) || points[v].x() >= third / 2))
    {
      ++kept;
      CHECK(m.point(v) == points[v]);
    }
  CHECK(kept > 7 * 4);
}

// What does not move keeps its point to the last bit, however far the coordinates lie apart.
void points_at_the_end_of_double_precision_are_kept()
{
  Mesh m = to_mesh<Mesh>(square(4).scaled(1e300));
  const Mesh::Vertex_index v(1);   // on the border
  m.point(v) = Point(m.point(v).x(), 1.2345678e-20, 0);
  const Bits before = bits(m.point(v));
  IAR::isotropic_remeshing(.2e300, m, parameters::do_split(false).do_collapse(false).relax_constraints(false));
  CHECK(bits(m.point(v)) == before);
}

// --- constraints -------------------------------------------------------------------------------------------------

// Where in a run something of the user's can fail.
enum class Place
{
  nowhere, split_policy, collapse_policy, flip_policy, move_functor, projector, callback,
  start_iteration, end_iteration, start_pass, end_pass, before_split, after_split, before_collapse, after_collapse,
  before_flip, after_flip, before_move, after_move,
  get_point, get_edge, get_vertex, get_face,
  put_point, put_edge, put_face
};

struct Burnt
{};

// Burns at a place when it is passed for the n-th time; once, or each time from then on.
struct Fuse
{
  Place place = Place::nowhere;
  int countdown = 0;
  bool burns_again = false;
  bool has_burnt = false;

  void pass(Place p)
  {
    if(p != place || (--countdown != 0 && !(burns_again && has_burnt)))
      return;
    has_burnt = true;
    throw Burnt();
  }
};

// A property map of the user's: values by key, and a fuse.
template <class Key, class Value, Place GET, Place PUT>
struct Marks
{
  using key_type = Key;
  using value_type = Value;
  using reference = Value;
  using category = boost::read_write_property_map_tag;

  Fuse* fuse;
  std::shared_ptr<std::unordered_map<Key, Value>> values = std::make_shared<std::unordered_map<Key, Value>>();

  bool operator[](const Key& key) const { return values->count(key) > 0 && values->at(key); }

  friend Value get(const Marks& map, const Key& key)
  {
    map.fuse->pass(GET);
    const auto found = map.values->find(key);
    return found == map.values->end() ? Value() : found->second;
  }
  friend void put(const Marks& map, const Key& key, const Value& value)
  {
    map.fuse->pass(PUT);
    (*map.values)[key] = value;
  }
};

// The mesh's own points, with a fuse.
template <class Graph>
struct Fused_points
{
  using key_type = Vertex_of<Graph>;
  using value_type = Point;
  using reference = Point;
  using category = boost::read_write_property_map_tag;

  Fuse* fuse;
  Point_map_of<Graph> points;

  friend Point get(const Fused_points& map, const key_type& v)
  {
    map.fuse->pass(Place::get_point);
    return get(map.points, v);
  }
  friend void put(const Fused_points& map, const key_type& v, const Point& p)
  {
    map.fuse->pass(Place::put_point);
    put(map.points, v, p);
  }
};

struct Fused_policy
{
  Fuse* fuse;
  Place place;

  template <class Profile>
  bool operator()(const Profile&) const
  {
    fuse->pass(place);
    return true;
  }
};

// Nowhere else, but by functors of the user's.
struct Identity_of_points
{
  Fuse* fuse;

  Point operator()(const Point& p) const
  {
    fuse->pass(Place::projector);
    return p;
  }
};

template <class Graph>
struct Identity_of_vertices
{
  Fuse* fuse;
  Fused_points<Graph> points;

  Point operator()(Vertex_of<Graph> v) const
  {
    fuse->pass(Place::projector);
    return get(points.points, v);
  }
};

struct Fused_visitor
{
  Fuse* fuse;

  template <class M> void start_iteration(unsigned, const M&) { fuse->pass(Place::start_iteration); }
  template <class M> void end_iteration(unsigned, const M&) { fuse->pass(Place::end_iteration); }
  template <class M> void start_pass(IAR::Pass, const M&) { fuse->pass(Place::start_pass); }
  template <class M> void end_pass(IAR::Pass, const M&, std::size_t) { fuse->pass(Place::end_pass); }
  template <class H, class M> void before_split(H, const M&) { fuse->pass(Place::before_split); }
  template <class V, class M> void after_split(V, const M&) { fuse->pass(Place::after_split); }
  template <class H, class M> void before_collapse(H, const M&) { fuse->pass(Place::before_collapse); }
  template <class V, class M> void after_collapse(V, const M&) { fuse->pass(Place::after_collapse); }
  template <class H, class M> void before_flip(H, const M&) { fuse->pass(Place::before_flip); }
  template <class H, class M> void after_flip(H, const M&) { fuse->pass(Place::after_flip); }
  template <class V, class M> void before_move(V, const M&) { fuse->pass(Place::before_move); }
  template <class V, class M> void after_move(V, const M&) { fuse->pass(Place::after_move); }
};

// A mesh with everything that a user can attach to a run.
template <class Graph>
struct Workpiece
{
  Graph mesh;
  Fuse fuse;
  Marks<Edge_of<Graph>, bool, Place::get_edge, Place::put_edge> edges{&fuse};
  Marks<Vertex_of<Graph>, bool, Place::get_vertex, Place::nowhere> vertices{&fuse};
  Marks<Face_of<Graph>, int, Place::get_face, Place::put_face> patches{&fuse};
  bool protects = false, collapses = true, splits_rim = false;
  unsigned iterations = 5;

  explicit Workpiece(const Soup& soup) { add_soup(soup, mesh); }
  Workpiece(const Workpiece&) = delete;

  const Point& point(Vertex_of<Graph> v) const { return get(CGAL::vertex_point, mesh, v); }
  const Point& source_point(Edge_of<Graph> e) const { return point(source(halfedge(e, mesh), mesh)); }
  const Point& target_point(Edge_of<Graph> e) const { return point(target(halfedge(e, mesh), mesh)); }

  template <class Predicate>
  void constrain_edges(const Predicate& is_constrained)
  {
    for(const auto e : CGAL::edges(mesh))
      if(is_constrained(source_point(e), target_point(e)))
        (*edges.values)[e] = true;
  }

  template <class Patch>
  void set_patches(const Patch& patch)
  {
    for(const auto f : faces(mesh))
      (*patches.values)[f] = patch(centroid(f, mesh));
  }

  Report remesh(const Faces_of<Graph>& range, double length)
  {
    return IAR::isotropic_remeshing(range, length, mesh, IAR::recipe(recipe(),
      parameters::edge_is_constrained_map(edges).vertex_is_constrained_map(vertices).face_patch_map(patches)
                 .protect_constraints(protects).collapse_constraints(collapses).number_of_iterations(iterations)));
  }
  Report remesh(double length) { return remesh(all_faces(mesh), length); }

  // The same with everything that can fail.
  template <class Projector>
  Report remesh_with_fuses(double length, const Projector& projector)
  {
    return remesh_with_fuses(all_faces(mesh), length, projector);
  }
  template <class Projector>
  Report remesh_with_fuses(const Faces_of<Graph>& range, double length, const Projector& projector)
  {
    return IAR::isotropic_remeshing(range, length, mesh, IAR::recipe(recipe(),
      parameters::edge_is_constrained_map(edges).vertex_is_constrained_map(vertices).face_patch_map(patches)
                 .number_of_iterations(iterations).vertex_point_map(points())
                 .do_split(Fused_policy{&fuse, Place::split_policy})
                 .do_collapse(Fused_policy{&fuse, Place::collapse_policy})
                 .do_flip(Fused_policy{&fuse, Place::flip_policy}).projection_functor(projector)
                 .allow_move_functor([this](Vertex_of<Graph>, const Point&, const Point&) { fuse.pass(Place::move_functor); return true; })
                 .callback([this](double) { fuse.pass(Place::callback); return true; })
                 .visitor(Fused_visitor{&fuse})));
  }

  IAR::Recipe recipe() const
  {
    IAR::Recipe result;
    result.split_rim = splits_rim;
    return result;
  }

  Fused_points<Graph> points() { return {&fuse, get(CGAL::vertex_point, mesh)}; }
};

double distance(const Point& p, const Point& q) { return std::sqrt(CGAL::squared_distance(p, q)); }

// Whether the segment lies on one of the twelve edges of the unit cube.
bool is_on_edge_of_cube(const Point& p, const Point& q)
{
  int sides = 0;
  for(int axis = 0; axis < 3; ++axis)
    sides += p[axis] == q[axis] && (p[axis] == 0 || p[axis] == 1);
  return sides >= 2;
}

// The side of the unit cube on which a point lies.
int side_of_cube(const Point& p)
{
  for(int axis = 0; axis < 3; ++axis)
    for(int side = 0; side < 2; ++side)
      if(std::abs(p[axis] - side) < 1e-12)
        return 2 * axis + side;
  return -1;
}

// The edges of a cube, marked: by a map on all faces, or on a part of them.
template <class Graph>
void marked_edges_stay(double length, bool is_whole, bool splits_rim)
{
  Workpiece<Graph> w(cube(6));
  w.splits_rim = splits_rim;
  w.constrain_edges(is_on_edge_of_cube);
  const auto range = is_whole ? all_faces(w.mesh) : faces_where(w.mesh, [](const Point& p) { return p.z() > .5; });
  const Outside<Graph> outside(w.mesh, splits_rim ? with_faces_beside(range, w.mesh) : range);
  const Report report = w.remesh(range, length);
  CHECK(is_valid_mesh(w.mesh));
  CHECK(outside.is_as_it_was(w.mesh));
  CHECK(length > .2 ? report.collapses > 0 : report.splits > 0);
  // The edges are straight and their ends do not move but by collapses: midpoints of points with the coordinates 0 and
  // 1 have them, too. So the map is right for each edge of the mesh by the edge's coordinates.
  double total = 0;
  for(const auto e : edges(w.mesh))
  {
    CHECK(w.edges[e] == is_on_edge_of_cube(w.source_point(e), w.target_point(e)));
    if(w.edges[e])
      total += distance(w.source_point(e), w.target_point(e));
  }
  CHECK_MESSAGE(std::abs(total - 12) < 1e-12, total);
}

// A line around a sphere, of edges so short that some are collapsed.
template <class Graph>
void a_marked_circle_stays()
{
  const double length = .3;
  Workpiece<Graph> w(sphere(4));
  w.constrain_edges([](const Point& p, const Point& q) { return p.z() == 0 && q.z() == 0; });
  const Report report = w.remesh(length);
  CHECK(report.collapses > 0);
  // 64 edges of 2 pi / 64 = .1: none is split, and a collapse makes none that would be. Its vertices slide on the 64 edges,
  // and those of the result are chords shorter than 1.5 of the length, whose middles lie near them.
  const double longest = 1.5 * length, nearest = std::sqrt(1 - longest * longest / 4) - .0013;
  std::map<Vertex_of<Graph>, int> ends;
  double total = 0;
  for(const auto e : edges(w.mesh))
    if(w.edges[e])
    {
      const Point p = w.source_point(e), q = w.target_point(e);
      CHECK(p.z() == 0 && q.z() == 0);
      CHECK(distance(p, Point(0, 0, 0)) < 1 + 1e-12 && distance(p, Point(0, 0, 0)) > std::cos(CGAL_PI / 64) - 1e-12);
      CHECK(distance(p, q) <= longest * (1 + 1e-12));
      total += distance(p, q);
      for(const auto h : {halfedge(e, w.mesh), opposite(halfedge(e, w.mesh), w.mesh)})
        ++ends[target(h, w.mesh)];
    }
  // a closed line around the disc of the nearest middles, inside of the circle
  CHECK(total > 2 * CGAL_PI * nearest && total < 2 * CGAL_PI);
  CHECK(ends.size() >= 2 * CGAL_PI / longest && ends.size() < 64);
  for(const auto& end : ends)
    CHECK(end.second == 2);
}

// A line of edges of .106, far under the length of .25, that turns by 40 degrees at each of its vertices, which makes
// none of them a corner. To leave one out would cut .036 off, nearly three times .05 of the length. What slides may cut that
// much off, no more.
template <class Graph>
void a_zigzag_stays()
{
  Soup soup = square(10);
  const double offset = .1 * std::tan(20 * CGAL_PI / 180);
  for(auto& p : soup.points)
    p[0] += std::lround(10 * p[1]) % 2 == 1 ? offset : 0;
  Workpiece<Graph> w(soup);
  w.constrain_edges([&](const Point& p, const Point& q) {
    const auto is_on_line = [&](const Point& r) { return r.x() == .5 || r.x() == .5 + offset; };
    return is_on_line(p) && is_on_line(q);
  });
  CHECK(w.remesh(.25).collapses > 0);
  std::vector<Kernel::Segment_3> pieces;
  for(const auto e : edges(w.mesh))
    if(w.edges[e])
      pieces.emplace_back(w.source_point(e), w.target_point(e));
  CHECK(pieces.size() >= 8 && pieces.size() <= 12);
  for(int i = 0; i <= 10; ++i)
  {
    const Point corner(i % 2 == 1 ? .5 + offset : .5, .1 * i, 0);
    double nearest = 1;
    for(const auto& piece : pieces)
      nearest = std::min(nearest, std::sqrt(CGAL::squared_distance(corner, piece)));
    CHECK_MESSAGE(nearest < .05 * .25 + 1e-9, i << ": " << nearest);
  }
  for(const auto& piece : pieces)
    for(const Point& p : {piece.source(), piece.target()})
    {
      const double t = 10 * p.y() - std::floor(10 * p.y()), s = std::lround(std::floor(10 * p.y())) % 2 == 0 ? t : 1 - t;
      CHECK_MESSAGE(std::abs(p.x() - .5 - s * offset) < 1e-12 || p.y() > 1 - 1e-12, p);
    }
}

// However coarse the target, and however little of the area they hold.
template <class Graph>
void corners_of_the_border_stay()
{
  // to leave a corner out would cut .05 / sqrt(2) off, less than .05 of the length
  Workpiece<Graph> w(square(20));
  CHECK(w.remesh(1).collapses > 0);
  std::set<Bits> points;
  for(const auto v : vertices(w.mesh))
    points.insert(bits(w.point(v)));
  for(const double x : {0., 1.})
    for(const double y : {0., 1.})
      CHECK(points.count(bits(Point(x, y, 0))) == 1);
}

// Marks on the border of the mesh and on that of the range.
template <class Graph>
void marks_on_borders_are_right()
{
  for(const bool is_whole : {true, false})
  {
    const auto is_marked = [](const Point& p, const Point& q) {
      return (p.y() == 0 && q.y() == 0) || (p.x() == .5 && q.x() == .5);
    };
    Workpiece<Graph> w(square(8));
    w.constrain_edges(is_marked);
    const auto range = is_whole ? all_faces(w.mesh) : faces_where(w.mesh, [](const Point& p) { return p.x() > .5; });
    CHECK(w.remesh(range, .07).splits > 0);
    double total = 0;
    for(const auto e : edges(w.mesh))
    {
      CHECK(w.edges[e] == is_marked(w.source_point(e), w.target_point(e)));
      if(w.edges[e])
        total += distance(w.source_point(e), w.target_point(e));
    }
    CHECK_MESSAGE(std::abs(total - 2) < 1e-12, total);
  }
}

template <class Graph>
void patches_keep_their_faces(bool is_whole, bool splits_rim)
{
  Workpiece<Graph> w(cube(6));
  w.splits_rim = splits_rim;
  w.set_patches(side_of_cube);
  const auto range = is_whole ? all_faces(w.mesh) : faces_where(w.mesh, [](const Point& p) { return p.z() > .5; });
  const Report report = w.remesh(range, .1);
  CHECK(report.splits > 0);
  CHECK(is_valid_mesh(w.mesh));
  std::array<double, 6> area = {0, 0, 0, 0, 0, 0};
  for(const auto f : faces(w.mesh))
  {
    const int side = side_of_cube(centroid(f, w.mesh));
    CHECK(side >= 0 && get(w.patches, f) == side);
    if(side < 0)
      continue;
    const auto h = halfedge(f, w.mesh);
    area[side] += std::sqrt(CGAL::squared_area(w.point(source(h, w.mesh)), w.point(target(h, w.mesh)),
                                               w.point(target(next(h, w.mesh), w.mesh))));
  }
  for(const double a : area)
    CHECK_MESSAGE(std::abs(a - 1) < 1e-12, a);
  // the borders of patches are constrained edges
  for(const auto e : edges(w.mesh))
    if(is_whole)
      CHECK(w.edges[e] == is_on_edge_of_cube(w.source_point(e), w.target_point(e)));
}

template <class Graph>
void marked_vertices_stay()
{
  for(const double length : {.1, .8})
  {
    Workpiece<Graph> w(torus(20, 10, .4));
    std::map<Vertex_of<Graph>, Bits> kept;
    std::size_t number = 0;
    for(const auto v : vertices(w.mesh))
      if(number++ % 9 == 0)
      {
        (*w.vertices.values)[v] = true;
        kept[v] = bits(w.point(v));
      }
    w.remesh(length);
    const std::set<Vertex_of<Graph>> left(vertices(w.mesh).begin(), vertices(w.mesh).end());
    for(const auto& v : kept)
    {
      CHECK(left.count(v.first) == 1);
      if(left.count(v.first) == 1)
        CHECK(bits(w.point(v.first)) == v.second && degree(v.first, w.mesh) >= 3);
    }
  }
}

template <class Graph>
void protected_edges_are_left_alone()
{
  for(const double length : {.04, .7})
  {
    // half of a square's border, and a line across
    Workpiece<Graph> w(square(8));
    w.protects = true;
    w.constrain_edges([](const Point& p, const Point& q) { return p.x() == .5 && q.x() == .5; });
    const auto is_protected = [&](Edge_of<Graph> e) { return w.edges[e] || CGAL::is_border(e, w.mesh); };
    std::set<std::pair<Edge_of<Graph>, std::array<Bits, 2>>> before, after;
    const auto look = [&](auto& seen)
    {
      for(const auto e : edges(w.mesh))
        if(is_protected(e))
          seen.insert({e, {bits(w.source_point(e)), bits(w.target_point(e))}});
    };
    look(before);
    CHECK(before.size() == 4 * 8 + 8);
    const Report report = w.remesh(length);
    CHECK(report.splits + report.collapses > 0);
    look(after);
    CHECK(before == after);
    CHECK(is_valid_mesh(w.mesh));
  }
}

// Triangles beside an edge that is not split must not be split until they are flat, round by round, nor be flattened
// afterwards.
template <class Graph>
void protected_edges_may_be_much_longer_than_the_target()
{
  for(const std::size_t squares : {2, 8})
    for(const double ratio : {3., 6., 12.})
      for(const unsigned iterations : {1, 5, 10})
        for(const bool is_whole : {true, false})
        {
          Workpiece<Graph> w(square(squares));
          w.protects = is_whole;          // of a part, the edges towards the rest are protected anyhow
          w.iterations = iterations;
          const auto range =
            is_whole ? all_faces(w.mesh) : faces_where(w.mesh, [](const Point& p) { return p.x() > .5; });
          const Report report = w.remesh(range, 1 / (ratio * double(squares)));
          CHECK_MESSAGE(report.angles_after.minimum > 5,
                        squares << " squares, " << iterations << " iterations, edges " << ratio
                                << " times as long as the target: " << report.angles_after.minimum << " degrees");
          std::set<Bits> points;
          for(const auto v : vertices(w.mesh))
            CHECK(points.insert(bits(w.point(v))).second);
        }
}

template <class Graph>
void constrained_edges_need_not_be_collapsed()
{
  for(const bool collapses : {false, true})
  {
    Workpiece<Graph> w(square(8));
    w.collapses = collapses;
    w.constrain_edges([](const Point& p, const Point& q) { return p.x() == .5 && q.x() == .5; });
    const Report report = w.remesh(.5);
    std::size_t on_line = 0, on_border = 0;
    for(const auto e : edges(w.mesh))
    {
      on_line += w.edges[e];
      on_border += CGAL::is_border(e, w.mesh);
    }
    CHECK(report.collapses > 0);
    // the edges are 1/8 long, well under 4/5 of the target length
    CHECK(collapses ? on_line < 8 : on_line == 8);
    CHECK(collapses ? on_border < 32 : on_border == 32);
  }
}

template <class Graph>
void constraints_are_kept()
{
  for(const double length : {.08, .4})
    for(const bool splits_rim : {true, false})
    {
      marked_edges_stay<Graph>(length, true, splits_rim);
      marked_edges_stay<Graph>(length, false, splits_rim);
    }
  a_marked_circle_stays<Graph>();
  a_zigzag_stays<Graph>();
  corners_of_the_border_stay<Graph>();
  marks_on_borders_are_right<Graph>();
  patches_keep_their_faces<Graph>(true, false);
  patches_keep_their_faces<Graph>(false, false);
  patches_keep_their_faces<Graph>(false, true);
  marked_vertices_stay<Graph>();
  protected_edges_are_left_alone<Graph>();
  protected_edges_may_be_much_longer_than_the_target<Graph>();
  constrained_edges_need_not_be_collapsed<Graph>();
}

// --- exceptions --------------------------------------------------------------------------------------------------

// Short and long edges, so that every pass has something to do.
template <class Graph>
std::unique_ptr<Workpiece<Graph>> uneven_workpiece()
{
  Soup soup = sphere(2);
  for(auto& p : soup.points)
  {
    const double factor = 1 + .8 * p[0];
    for(double& coordinate : p)
      coordinate *= factor;
  }
  auto w = std::make_unique<Workpiece<Graph>>(soup);
  scramble(w->mesh, [](std::size_t edge) { return edge % 7 == 0; });
  w->iterations = 2;
  w->constrain_edges([](const Point& p, const Point& q) { return p.z() == 0 && q.z() == 0 && p.x() > .5; });
  w->set_patches([](const Point& p) { return int(p.y() > 0); });
  return w;
}

constexpr double UNEVEN_LENGTH = .35;

// What a mesh is to its user, garbage left out.
template <class Graph>
bool are_equal_but_for_garbage(Picture<Graph> a, Picture<Graph> b)
{
  a.removed = b.removed = {0, 0, 0};
  return a == b;
}

template <class Graph, class Run>
void check_that_nothing_changes(Place place, int countdown, bool must_burn, const char* kind, const Run& run)
{
  const auto w = uneven_workpiece<Graph>();
  const Picture<Graph> before(w->mesh);
  const auto edges_before = *w->edges.values;
  const auto patches_before = *w->patches.values;
  w->fuse = Fuse{place, countdown};
  bool has_thrown = false;
  try
  {
    run(*w);
  }
  catch(const Burnt&)
  {
    has_thrown = true;
  }
  CHECK_MESSAGE(has_thrown == w->fuse.has_burnt, kind << ", place " << int(place) << ", " << countdown);
  CHECK_MESSAGE(has_thrown || !must_burn, kind << ", place " << int(place) << ", " << countdown);
  if(!has_thrown)
    return;
  if(place != Place::put_edge && place != Place::put_face)
  {
    // by the time that points are put the new elements have been made; taken back, a Surface_mesh counts them as garbage
    const Picture<Graph> after(w->mesh);
    CHECK_MESSAGE(place == Place::put_point ? are_equal_but_for_garbage(after, before) : after == before,
                  kind << ", place " << int(place) << ", " << countdown);
    CHECK(*w->edges.values == edges_before);
    CHECK(*w->patches.values == patches_before);
  } else   // these come last: the mesh is finished
    CHECK_MESSAGE(is_valid_mesh(w->mesh), kind << ", place " << int(place) << ", " << countdown);
}

template <class Graph>
void an_exception_leaves_everything_as_it_was()
{
  for(int place = int(Place::split_policy); place <= int(Place::put_face); ++place)
    for(const int countdown : {1, 2, 7, 40})
    {
      const bool must_burn = countdown == 1;
      check_that_nothing_changes<Graph>(Place(place), countdown, must_burn, "by points", [](Workpiece<Graph>& w) {
        w.remesh_with_fuses(UNEVEN_LENGTH, Identity_of_points{&w.fuse});
      });
      check_that_nothing_changes<Graph>(Place(place), countdown, must_burn, "by vertices", [](Workpiece<Graph>& w) {
        w.remesh_with_fuses(UNEVEN_LENGTH, Identity_of_vertices<Graph>{&w.fuse, w.points()});
      });
      check_that_nothing_changes<Graph>(Place(place), countdown, must_burn, "a part that is not alone", [](Workpiece<Graph>& w) {
        w.splits_rim = true;
        w.remesh_with_fuses(faces_where(w.mesh, [](const Point& p) { return p.x() > .3; }), .3 * UNEVEN_LENGTH, Identity_of_points{&w.fuse});
      });
    }
}

// Maps that can only be read say what is constrained as others do.
template <class Graph>
void maps_may_be_read_only()
{
  std::vector<Picture<Graph>> results;
  for(const bool can_be_written : {true, false})
  {
    const auto w = uneven_workpiece<Graph>();
    std::map<Edge_of<Graph>, bool> marks;
    for(const auto e : CGAL::edges(w->mesh))
      marks[e] = w->source_point(e).y() == 0 && w->target_point(e).y() == 0;
    std::map<Face_of<Graph>, int> patches;
    for(const auto f : faces(w->mesh))
      patches[f] = (*w->patches.values)[f];
    const auto marks_before = marks;
    const auto patches_before = patches;
    const auto remesh = [&](auto edge_map, auto patch_map) {
      IAR::isotropic_remeshing(UNEVEN_LENGTH, w->mesh, parameters::edge_is_constrained_map(edge_map).face_patch_map(patch_map));
    };
    if(can_be_written)
      remesh(boost::make_assoc_property_map(marks), boost::make_assoc_property_map(patches));
    else
      remesh(boost::const_associative_property_map<std::map<Edge_of<Graph>, bool>>(marks),
             boost::const_associative_property_map<std::map<Face_of<Graph>, int>>(patches));
    CHECK((marks == marks_before && patches == patches_before) == !can_be_written);
    results.emplace_back(w->mesh);
  }
  CHECK(results[0] == results[1]);
}

// Edges that are about to be removed lose their marks; where one of them cannot, all stay, and so do their marks.
template <class Graph>
void marks_come_back_where_their_map_fails()
{
  for(const int countdown : {1, 30, 60})
  {
    const auto w = uneven_workpiece<Graph>();
    w->constrain_edges([](const Point& p, const Point& q) { return p.y() == 0 && q.y() == 0; });      // borders of patches
    const Picture<Graph> before(w->mesh);
    const auto edges_before = *w->edges.values;
    w->fuse = Fuse{Place::put_edge, countdown};
    try
    {
      w->remesh_with_fuses(3 * UNEVEN_LENGTH, Identity_of_points{&w->fuse});
    }
    catch(const Burnt&)
    {}
    CHECK_MESSAGE(w->fuse.has_burnt, countdown);
    CHECK_MESSAGE(are_equal_but_for_garbage(Picture<Graph>(w->mesh), before), countdown);
    for(const auto e : CGAL::edges(w->mesh))
      CHECK_MESSAGE(w->edges[e] == (edges_before.count(e) > 0 && edges_before.at(e)), countdown);
  }
}

// Where a map of points fails for good, those that were put before it did cannot come back; everything else is as it was.
template <class Graph>
void a_map_that_fails_for_good_leaves_a_mesh()
{
  for(const int countdown : {1, 2, 40})
  {
    const auto w = uneven_workpiece<Graph>();
    const Picture<Graph> before(w->mesh);
    const auto edges_before = *w->edges.values;
    w->fuse = Fuse{Place::put_point, countdown, true};
    bool has_thrown = false;
    try
    {
      w->remesh_with_fuses(UNEVEN_LENGTH, Identity_of_points{&w->fuse});
    }
    catch(const Burnt&)
    {
      has_thrown = true;
    }
    CHECK_MESSAGE(has_thrown && is_valid_mesh(w->mesh), countdown);
    CHECK_MESSAGE(countdown > 1 || are_equal_but_for_garbage(Picture<Graph>(w->mesh), before), countdown);
    CHECK(all_faces(w->mesh).size() == all_faces(uneven_workpiece<Graph>()->mesh).size());
    CHECK(*w->edges.values == edges_before);
  }
}

// Without an exception, the same run does all that could have failed.
template <class Graph>
void without_an_exception_everything_happens()
{
  const auto w = uneven_workpiece<Graph>();
  const Report report = w->remesh_with_fuses(UNEVEN_LENGTH, Identity_of_points{&w->fuse});
  CHECK(report.splits > 0 && report.collapses > 0 && report.flips > 0);
  CHECK(is_valid_mesh(w->mesh));
}

template <class Graph>
void running_out_of_memory_leaves_the_mesh_as_it_was()
{
  const std::size_t stride = is_small_run() ? 17 : 1;
  for(std::size_t n = 1;; n += stride)
  {
    Graph g = to_mesh<Graph>(octahedron());
    const Picture<Graph> before(g);
    bool has_failed = false;
    allocations_left = n;
    try
    {
      IAR::isotropic_remeshing(.6, g, parameters::number_of_iterations(1));
    }
    catch(const std::bad_alloc&)
    {
      has_failed = true;
    }
    allocations_left = 0;
    if(!has_failed)
    {
      CHECK_MESSAGE(n > 50, "a run allocates more often than " << n << " times");
      CHECK(is_valid_mesh(g) && faces(g).size() > 8);
      return;
    }
    CHECK_MESSAGE(are_equal_but_for_garbage(Picture<Graph>(g), before), "allocation " << n);
  }
}

// --- crossings of its faces --------------------------------------------------------------------------------------

// A needle and a small face at its long edge cross where exact arithmetic says so, though the needle's normal is mostly rounding.
void needles_cross_what_they_cross()
{
  using Exact = CGAL::Exact_predicates_inexact_constructions_kernel;
  using IAR::internal::Vector3;
  Flat mesh = flat_copy(Soup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}}, {{0, 1, 2}, {3, 4, 5}}});
  std::mt19937 random(1);
  std::uniform_real_distribution<double> between(-1, 1);
  const auto any = [&]() { return Vector3{between(random), between(random), between(random)}; };
  const auto triangle = [&](Index f) {
    std::array<Exact::Point_3, 3> p;
    for(int k = 0; k < 3; ++k)
    {
      const Vector3& q = mesh.position(mesh.face_record(f).vertex[k]);
      p[k] = Exact::Point_3(q.x, q.y, q.z);
    }
    return Exact::Triangle_3(p[0], p[1], p[2]);
  };
  std::size_t crossing = 0, wrong = 0;
  for(int i = 0; i < 20000; ++i)
  {
    const Vector3 a = any(), b = any(), middle = a + .3 * (b - a);
    const double height = std::pow(10, 3 * between(random) - 13), size = std::pow(10, 4 * between(random) - 4);
    const Vector3 c = a + (.5 + .4 * between(random)) * (b - a) + height * any(), d = any();
    const Vector3 corners[6] = {a, b, c, middle + size * d, middle - .7 * size * d, middle + size * any()};
    for(Index k = 0; k < 6; ++k)
      mesh.position(mesh.face_record(k / 3).vertex[k % 3]) = corners[k];
    if(triangle(0).is_degenerate() || triangle(1).is_degenerate())
      continue;
    const bool expected = CGAL::do_intersect(triangle(0), triangle(1));
    crossing += expected;
    wrong += IAR::internal::cross_each_other(mesh, 0, 1) != expected;
  }
  CHECK_MESSAGE(crossing > 1000 && wrong == 0, wrong << " of " << crossing);
}

#ifdef CGAL_LINKED_WITH_TBB
// What is left of these faces after a pass over two short edges, given by their ends.
template <class ConcurrencyTag>
std::set<std::set<Flat::Index>> faces_after_collapses(const Soup& soup, const std::array<std::pair<int, int>, 2>& collapsed)
{
  namespace internal = IAR::internal;
  Mesh user = to_mesh<Mesh>(soup);
  const auto points = get(CGAL::vertex_point, user);
  internal::Mesh_exchange<Mesh, Point_map_of<Mesh>> exchange(faces(user), user, points, "test");
  Flat mesh = exchange.take_mesh(false);
  std::vector<Flat::Index> flat(soup.points.size());
  for(std::size_t v = 0; v < flat.size(); ++v)
    flat[exchange.input_vertices()[v]] = Flat::Index(v);
  internal::lock_corners(mesh, std::vector<double>(flat.size(), 0));
  internal::Input_curves curves(mesh);
  const IAR::Recipe recipe;
  const internal::Sizing uniform;
  const internal::Projection none;
  internal::Run_visitor visitor;
  internal::Remeshing_context context(mesh, exchange.surroundings(), recipe, curves, uniform, none, visitor, 1 / mesh.unit());
  const auto edge = [&](int u, int v) {
    const auto h = mesh.find_halfedge(flat[u], flat[v]);
    return h >= 0 ? h : mesh.find_halfedge(flat[v], flat[u]);
  };
  std::vector<Flat::Index> short_edges;
  for(const auto& [u, v] : collapsed)
    short_edges.push_back(edge(u, v));
  CHECK(internal::collapse_pass<ConcurrencyTag>(context, short_edges) > 0);
  std::set<std::set<Flat::Index>> result;
  for(Flat::Index g = 0; g < Flat::Index(mesh.number_of_face_slots()); ++g)
    if(mesh.is_face(g))
      result.emplace(std::begin(mesh.face_record(g).vertex), std::end(mesh.face_record(g).vertex));
  return result;
}

void check_collapses_with_threads(const Soup& soup, const std::array<std::pair<int, int>, 2>& collapsed)
{
  CHECK(faces_after_collapses<CGAL::Sequential_tag>(soup, collapsed) == faces_after_collapses<CGAL::Parallel_tag>(soup, collapsed));
}

// Of a pentagon, the first edge belongs to a flat ear on the side of a spike: its collapse makes that side a curve of the faces beyond, which
// the second one reads.
void threads_see_a_side_become_a_curve()
{
  enum { tip, middle, foot, side, ear, top };
  Soup soup;
  soup.points = {{0, 0, 0}, {.5, 0, 0}, {1, 0, 0}, {.45, .15, 0}, {.22, .08, 0}, {.8, .5, 0}};
  soup.faces = {{tip, middle, side}, {tip, side, ear}, {middle, top, side}, {middle, foot, top}};
  check_collapses_with_threads(soup, {{{ear, tip}, {middle, foot}}});
}

// The collapse of the first edge widens the end of a strip. What becomes of the second one depends on that, for its curve goes on there,
// though no vertex around it has another star.
void threads_see_a_strip_widen()
{
  enum { first, middle, last, end, near_end, beyond, inner, side };
  Soup soup;
  soup.faces = {{middle, last, end}, {middle, end, inner}, {end, near_end, inner}, {near_end, beyond, inner}, {middle, inner, side},
                {middle, side, first}};
  using Points = decltype(soup.points);
  for(const Points& points : {Points{{-.24, 0, 0}, {.52, 0, 0}, {1, 0, 0}, {.94, .5, 0}, {.65, .5875, 0}, {.36, .675, 0}, {.3, .325, 0}, {-.32, .825, 0}},
                              Points{{-.18, 0, 0}, {.52, 0, 0}, {1, 0, 0}, {1.02, .45, 0}, {.73, .5625, 0}, {.44, .675, 0}, {.3, .325, 0}, {-.04, .725, 0}}})
  {
    soup.points = points;
    check_collapses_with_threads(soup, {{{near_end, beyond}, {first, middle}}});
  }
}

void threads_do_not_change_a_bit()
{
  const Soup cells = without_isolated_points(square_without(12, [](std::size_t i, std::size_t j) { return (i / 2 + j / 2) % 2 == 1; }));
  for(const Soup& soup : {torus(30, 20, .4), cells})
    for(const double length : {.07, .2})
    {
      Mesh sequential = to_mesh<Mesh>(soup), parallel = sequential;
      IAR::isotropic_remeshing<CGAL::Sequential_tag>(length, sequential);
      IAR::isotropic_remeshing<CGAL::Parallel_tag>(length, parallel);
      CHECK(Picture<Mesh>(sequential) == Picture<Mesh>(parallel));
    }
  threads_see_a_side_become_a_curve();
  threads_see_a_strip_widen();
}
#endif

int main()
{
  the_flat_mesh_models_the_concepts_of_graphs();
  borders_can_be_walked_along();
  points_come_back_in_the_users_units();
  operations_keep_the_mesh_consistent();
  a_tetrahedron_can_be_split_and_no_more();
  two_faces_with_the_same_corners_stay();
  what_the_topology_allows_is_legal();
  marks_forbid();
  needles_cross_what_they_cross();

  ranges_of_any_shape_come_back<Mesh>(&to_mesh<Mesh>);
  ranges_of_any_shape_come_back<Mesh>(&mesh_with_garbage);
  ranges_of_any_shape_come_back<Polyhedron>(&to_mesh<Polyhedron>);

  ranges_are_kept<Mesh>();
  ranges_are_kept<Polyhedron>();
  closed_parts_may_share_a_vertex();
  garbage_makes_no_difference();
  vertices_keep_what_the_user_attached_to_them();
  exact_points_stay_exact();
  points_at_the_end_of_double_precision_are_kept();

  constraints_are_kept<Mesh>();
  constraints_are_kept<Polyhedron>();

  maps_may_be_read_only<Mesh>();
  without_an_exception_everything_happens<Mesh>();
  an_exception_leaves_everything_as_it_was<Mesh>();
  marks_come_back_where_their_map_fails<Mesh>();
  a_map_that_fails_for_good_leaves_a_mesh<Mesh>();
  an_exception_leaves_everything_as_it_was<Polyhedron>();
  marks_come_back_where_their_map_fails<Polyhedron>();
  a_map_that_fails_for_good_leaves_a_mesh<Polyhedron>();
  running_out_of_memory_leaves_the_mesh_as_it_was<Mesh>();
  running_out_of_memory_leaves_the_mesh_as_it_was<Polyhedron>();
#ifdef CGAL_LINKED_WITH_TBB
  threads_do_not_change_a_bit();
#endif
  return result();
}
