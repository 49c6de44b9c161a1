// Copyright (c) 2026 The Inter_angle_remeshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The same history - ranges, constraints, patches - on every type of mesh, kernel and property map: what comes out is the
// same to the last bit, up to what the point map can hold.

#include <CGAL/Inter_angle_remeshing/Attribute_transfer.h>
#include <CGAL/Inter_angle_remeshing/Curvature_sizing_field.h>
#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Linear_cell_complex_for_bgl_combinatorial_map_helper.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/graph_traits_Linear_cell_complex_for_combinatorial_map.h>
#include <CGAL/boost/graph/helpers.h>

#ifdef TEST_WITH_OPENMESH
#  include <OpenMesh/Core/IO/MeshIO.hh>
#  include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#  include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#  include <CGAL/boost/graph/graph_traits_PolyMesh_ArrayKernelT.h>
#  include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>
#endif

#include "check.h"
#include "failing_memory.h"
#include "meshes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iostream>
#include <map>
#include <memory>
#include <new>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace IAR = CGAL::Inter_angle_remeshing;
namespace parameters = CGAL::parameters;
using meshes::Point_of;
using meshes::Soup;

using Float_kernel = CGAL::Simple_cartesian<float>;
using Double_kernel = CGAL::Simple_cartesian<double>;
using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
using Float_mesh = CGAL::Surface_mesh<Float_kernel::Point_3>;
using Double_mesh = CGAL::Surface_mesh<Double_kernel::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Double_kernel>;
using Polyhedron_with_ids = CGAL::Polyhedron_3<Epick, CGAL::Polyhedron_items_with_id_3>;
using Cell_complex =
  CGAL::Linear_cell_complex_for_bgl_combinatorial_map_helper<2, 3, CGAL::Linear_cell_complex_traits<3, Double_kernel>>::type;

template <class Graph> using Vertex_of = typename boost::graph_traits<Graph>::vertex_descriptor;
template <class Graph> using Halfedge_of = typename boost::graph_traits<Graph>::halfedge_descriptor;
template <class Graph> using Edge_of = typename boost::graph_traits<Graph>::edge_descriptor;
template <class Graph> using Face_of = typename boost::graph_traits<Graph>::face_descriptor;

// --- property maps of a user's own -------------------------------------------------------------------------------

// In a hash table outside of the mesh. To ask for what was never put is an error.
template <class Key, class Value>
class Table
{
public:
  using key_type = Key;
  using value_type = Value;
  using reference = Value;
  using category = boost::read_write_property_map_tag;

  friend Value get(const Table& table, const Key& k) { return table.values_->at(k); }
  friend void put(const Table& table, const Key& k, const Value& value)
  {
    if(*table.puts_left_ > 0 && --*table.puts_left_ == 0)
      throw std::runtime_error("no room in the table");
    (*table.values_)[k] = value;
  }
  void let_put_fail_after(std::size_t puts) { *puts_left_ = puts; }

private:
  std::shared_ptr<std::unordered_map<Key, Value>> values_ = std::make_shared<std::unordered_map<Key, Value>>();
  std::shared_ptr<std::size_t> puts_left_ = std::make_shared<std::size_t>(0);   // 0: none fails
};

// The constrained edges or vertices: all others are not.
template <class Key>
class Marks
{
public:
  using key_type = Key;
  using value_type = bool;
  using reference = bool;
  using category = boost::read_write_property_map_tag;

  friend bool get(const Marks& marks, const Key& k) { return marks.keys_->count(k) > 0; }
  friend void put(const Marks& marks, const Key& k, bool value)
  {
    if(value)
      marks.keys_->insert(k);
    else
      marks.keys_->erase(k);
  }

private:
  std::shared_ptr<std::unordered_set<Key>> keys_ = std::make_shared<std::unordered_set<Key>>();
};

// In a vector that grows with the numbers of the vertices.
template <class Index_map, class Value>
class Growing_vector
{
public:
  using key_type = typename boost::property_traits<Index_map>::key_type;
  using value_type = Value;
  using reference = Value;
  using category = boost::read_write_property_map_tag;

  explicit Growing_vector(Index_map index_map) : index_map_(index_map) {}
  friend Value get(const Growing_vector& v, const key_type& k) { return v.values_->at(get(v.index_map_, k)); }
  friend void put(const Growing_vector& v, const key_type& k, const Value& value)
  {
    const std::size_t i = get(v.index_map_, k);
    if(i >= v.values_->size())
      v.values_->resize(i + 1);
    (*v.values_)[i] = value;
  }

private:
  Index_map index_map_;
  std::shared_ptr<std::vector<Value>> values_ = std::make_shared<std::vector<Value>>();
};

// Where a test keeps the points.
struct In_the_mesh
{
  template <class Graph>
  static auto map(Graph& g) { return get(CGAL::vertex_point, g); }
};
struct In_a_table
{
  template <class Graph>
  static auto map(Graph&) { return Table<Vertex_of<Graph>, Point_of<Graph>>(); }
};
struct In_a_vector
{
  template <class Graph>
  static auto map(Graph& g)
  {
    const auto index_map = get(boost::vertex_index, g);
    return Growing_vector<std::decay_t<decltype(index_map)>, Point_of<Graph>>(index_map);
  }
};

// --- meshes as values --------------------------------------------------------------------------------------------

// Numbers, for comparison: an exact kernel knows no sign of zero.
using Coordinates = std::array<double, 3>;
using Triangle = std::array<Coordinates, 3>;   // begins with its smallest corner

template <class Point>
Coordinates coordinates(const Point& p) { return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())}; }

// The numbers of the triangles, sorted.
std::vector<std::size_t> ranks(const std::vector<Triangle>& triangles)
{
  std::vector<std::size_t> numbers(triangles.size());
  std::iota(numbers.begin(), numbers.end(), std::size_t(0));
  std::sort(numbers.begin(), numbers.end(), [&](std::size_t i, std::size_t k) { return triangles[i] < triangles[k]; });
  return numbers;
}

// What a user can see, whatever the type of the mesh.
struct State
{
  std::vector<std::pair<Triangle, int>> faces;            // with their patches
  std::vector<std::array<Coordinates, 2>> marked_edges;
  std::size_t vertices, edges;

  friend bool operator==(const State& a, const State& b)
  {
    return std::tie(a.faces, a.marked_edges, a.vertices, a.edges) == std::tie(b.faces, b.marked_edges, b.vertices, b.edges);
  }
};

// The states that a mesh went through.
using History = std::vector<std::pair<std::string, State>>;

template <class Range>
std::size_t length_of(const Range& range) { return std::size_t(std::distance(range.begin(), range.end())); }

// What the mesh's own class asks for and has to say.
template <class Graph>
bool is_valid_in_its_own_way(const Graph& g) { return g.is_valid(); }

template <class Graph>
void finish(Graph&) {}

#ifdef TEST_WITH_OPENMESH
// OpenMesh calls a vertex one of the border by the half-edge that it knows, which CGAL's Euler operations leave to the user.
template <class Graph>
void adjust_borders(Graph& g)
{
  for(const auto v : vertices(g))
    adjust_border_halfedge(v, g);
}
template <class Traits>
void finish(OpenMesh::PolyMesh_ArrayKernelT<Traits>& g) { adjust_borders(g); }
template <class Traits>
void finish(OpenMesh::TriMesh_ArrayKernelT<Traits>& g) { adjust_borders(g); }

template <class Graph>
bool are_borders_known_to_open_mesh(const Graph& g)
{
  std::set<Vertex_of<Graph>> on_border;
  for(const auto h : halfedges(g))
    if(CGAL::is_border(h, g))
      on_border.insert(target(h, g));
  for(const auto v : vertices(g))
    if(g.is_boundary(v) != (on_border.count(v) > 0))
      return false;
  return true;
}
template <class Traits>
bool is_valid_in_its_own_way(const OpenMesh::PolyMesh_ArrayKernelT<Traits>& g) { return are_borders_known_to_open_mesh(g); }
template <class Traits>
bool is_valid_in_its_own_way(const OpenMesh::TriMesh_ArrayKernelT<Traits>& g) { return are_borders_known_to_open_mesh(g); }
#endif

// A mesh, with maps of every kind, and what is done to it.
template <class Graph, class Place>
class Subject
{
public:
  using Vertex = Vertex_of<Graph>;
  using Face = Face_of<Graph>;
  using Faces = std::vector<Face>;

  explicit Subject(const Soup& soup)
    : points_(Place::map(g_))
  {
    const std::vector<Vertex> vertices = meshes::add_soup(soup, g_);
    finish(g_);
    faces_.assign(faces(g_).begin(), faces(g_).end());
    for(std::size_t i = 0; i < soup.points.size(); ++i)
    {
      const auto& p = soup.points[i];
      if(!HAS_OWN_POINTS)
        put(CGAL::vertex_point, g_, vertices[i], Point_of<Graph>(1e6, 0, 0));
      put(points_, vertices[i], Point_of<Graph>(p[0], p[1], p[2]));
    }
    for(const Face f : faces_)
      put(patches_, f, 0);
  }
  Subject(const Subject&) = delete;              // the maps know the mesh by its address
  Subject& operator=(const Subject&) = delete;

  Graph& graph() { return g_; }
  auto& points() { return points_; }
  Coordinates position(Vertex v) const { return coordinates(get(points_, v)); }

  Triangle triangle(Face f) const
  {
    const auto h = halfedge(f, g_);
    Triangle t = {position(source(h, g_)), position(target(h, g_)), position(target(next(h, g_), g_))};
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    return t;
  }

  Coordinates centroid(Face f) const
  {
    Coordinates c = {0, 0, 0};
    for(const Coordinates& p : triangle(f))
      for(int k = 0; k < 3; ++k)
        c[k] += p[k] / 3;
    return c;
  }

  template <class Predicate>
  Faces soup_faces_where(const Predicate& is_inside) const
  {
    Faces range;
    std::copy_if(faces_.begin(), faces_.end(), std::back_inserter(range), [&](Face f) { return is_inside(centroid(f)); });
    return range;
  }

  std::vector<Triangle> triangles() const
  {
    std::vector<Triangle> result;
    for(const Face f : faces(g_))
      result.push_back(triangle(f));
    return result;
  }

  // All faces, in an order that the type of the mesh has no part in.
  Faces sorted_faces() const
  {
    const Faces all(faces(g_).begin(), faces(g_).end());
    Faces result;
    for(const std::size_t i : ranks(triangles()))
      result.push_back(all[i]);
    return result;
  }

  // Marks edges whose midpoint, patches faces whose centroid, and vertices whose point the functors say.
  template <class Is_marked_edge, class Patch, class Is_marked_vertex>
  void mark(const Is_marked_edge& is_marked_edge, const Patch& patch, const Is_marked_vertex& is_marked_vertex)
  {
    for(const auto e : edges(g_))
      put(edge_marks_, e, is_marked_edge(position(source(e, g_)), position(target(e, g_))));
    for(const Face f : faces(g_))
      put(patches_, f, patch(centroid(f)));
    for(const Vertex v : vertices(g_))
      if(is_marked_vertex(position(v)))
      {
        put(vertex_marks_, v, true);
        kept_.emplace_back(v, position(v));
      }
  }

  // The whole mesh, without a map of faces: new ones have no patch yet.
  void remesh(double length)
  {
    if constexpr(HAS_OWN_POINTS)
      IAR::isotropic_remeshing(length, g_);
    else
      IAR::isotropic_remeshing(length, g_, parameters::vertex_point_map(points_));
    for(const Face f : faces(g_))
      put(patches_, f, 0);
    check_validity();
  }

  // A range, with every map: unmarked edges, one patch and no kept vertex unless mark() was called.
  IAR::Remeshing_report remesh(const Faces& range, double length, bool splits_rim = false)
  {
    const auto is_in_range = [&](Face f) { return std::find(range.begin(), range.end(), f) != range.end(); };
    const auto is_divided = [&](Face f) {
      bool result = false;
      if(splits_rim)
        for(const auto h : CGAL::halfedges_around_face(halfedge(f, g_), g_))
          result = result || (!CGAL::is_border(opposite(h, g_), g_) && is_in_range(face(opposite(h, g_), g_)));
      return result;
    };
    std::vector<std::pair<Face, Triangle>> outside;
    for(const Face f : faces(g_))
      if(!is_in_range(f) && !is_divided(f))
        outside.emplace_back(f, triangle(f));
    IAR::Recipe recipe;
    recipe.split_rim = splits_rim;
    const auto np = IAR::recipe(recipe, parameters::edge_is_constrained_map(edge_marks_).vertex_is_constrained_map(vertex_marks_)
                               .face_patch_map(patches_).face_index_map(face_numbers_).number_of_iterations(5));
    IAR::Remeshing_report report;
    if constexpr(HAS_OWN_POINTS)
      report = IAR::isotropic_remeshing(range, length, g_, np);
    else
      report = IAR::isotropic_remeshing(range, length, g_, np.vertex_point_map(points_));
    check_validity();
    for(const auto& [f, t] : outside)
      CHECK(triangle(f) == t);
    for(const auto& [v, p] : kept_)
    {
      const auto h = halfedge(v, g_);
      CHECK(target(h, g_) == v && position(v) == p);
    }
    return report;
  }

  // A range, edges as long as the curvature admits.
  void remesh_by_curvature(const Faces& range, double tolerance, double shortest, double longest)
  {
    const auto run = [&](const auto& np) {
      const IAR::Curvature_sizing_field<Graph> field(tolerance, {shortest, longest}, range, g_, np);
      IAR::isotropic_remeshing(range, field, g_, np);
    };
    if constexpr(HAS_OWN_POINTS)
      run(parameters::default_values());
    else
      run(parameters::vertex_point_map(points_));
    for(const Face f : faces(g_))
      put(patches_, f, 0);
    check_validity();
  }

  // The whole mesh, of which one side moves.
  void move_one_side(double length)
  {
    std::size_t new_ones = 0, denials = 0;
    const auto may_move = [&](Vertex v, const Point_of<Graph>&, const Point_of<Graph>& to)
    {
      new_ones += v == boost::graph_traits<Graph>::null_vertex();
      const bool is_permitted = coordinates(to)[0] < .4567;
      denials += !is_permitted;
      return is_permitted;
    };
    const auto np = parameters::allow_move_functor(may_move);
    if constexpr(HAS_OWN_POINTS)
      IAR::isotropic_remeshing(length, g_, np);
    else
      IAR::isotropic_remeshing(length, g_, np.vertex_point_map(points_));
    for(const Face f : faces(g_))
      put(patches_, f, 0);
    check_validity();
    CHECK(new_ones > 0 && denials > 0);
  }

  // Of a square whose halves are two patches: vertices carry their x and its square, corners the x of their vertex and the number of their half.
  void carry_attributes(double length)
  {
    Table<Vertex, double> of_vertex, smooth;
    Table<Halfedge_of<Graph>, double> of_corner;
    for(const Vertex v : vertices(g_))
    {
      put(of_vertex, v, position(v)[0]);
      put(smooth, v, CGAL::square(position(v)[0]));
    }
    for(const Face f : faces(g_))
    {
      put(patches_, f, centroid(f)[0] < .5 ? 1 : 2);
      for(const auto h : CGAL::halfedges_around_face(halfedge(f, g_), g_))
        put(of_corner, h, position(target(h, g_))[0] + get(patches_, f));
    }
    IAR::Attribute_transfer<Graph> transfer;
    transfer.add_vertex_map(of_vertex);
    if constexpr(HAS_OWN_POINTS)
      transfer.add_smooth_vertex_map(smooth, g_);
    else
      transfer.add_smooth_vertex_map(smooth, g_, parameters::vertex_point_map(points_));
    transfer.add_corner_map(of_corner);
    transfer.add_face_map(patches_);
    Marks<Edge_of<Graph>> seams;
    CHECK(transfer.mark_seams(g_, seams) == 6);
    const auto np = parameters::visitor(transfer).face_patch_map(patches_);
    if constexpr(HAS_OWN_POINTS)
      IAR::isotropic_remeshing(length, g_, np);
    else
      IAR::isotropic_remeshing(length, g_, np.vertex_point_map(points_));
    check_validity();
    for(const Vertex v : vertices(g_))
    {
      CHECK(std::abs(get(of_vertex, v) - position(v)[0]) < 1e-6);
      CHECK(std::abs(get(smooth, v) - CGAL::square(position(v)[0])) < 1e-5);
    }
    for(const Face f : faces(g_))
    {
      CHECK(get(patches_, f) == (centroid(f)[0] < .5 ? 1 : 2));
      for(const auto h : CGAL::halfedges_around_face(halfedge(f, g_), g_))
        CHECK(std::abs(get(of_corner, h) - position(target(h, g_))[0] - get(patches_, f)) < 1e-6);
    }
  }

  bool is_marked(Edge_of<Graph> e) const { return get(edge_marks_, e); }

  State state() const
  {
    State s;
    for(const Face f : faces(g_))
      s.faces.emplace_back(triangle(f), get(patches_, f));
    for(const auto e : edges(g_))
      if(get(edge_marks_, e))
      {
        s.marked_edges.push_back({position(source(e, g_)), position(target(e, g_))});
        std::sort(s.marked_edges.back().begin(), s.marked_edges.back().end());
      }
    std::sort(s.faces.begin(), s.faces.end());
    std::sort(s.marked_edges.begin(), s.marked_edges.end());
    s.vertices = length_of(vertices(g_));
    s.edges = length_of(edges(g_));
    return s;
  }

  // Whether no point was written into the mesh, if the points are elsewhere.
  bool are_own_points_untouched() const
  {
    return HAS_OWN_POINTS || std::none_of(vertices(g_).begin(), vertices(g_).end(), [&](Vertex v) {
      return coordinates(get(CGAL::vertex_point, g_, v)) == position(v);
    });
  }

  void check_validity() const
  {
    CHECK(CGAL::is_valid_polygon_mesh(g_));
    CHECK(CGAL::is_triangle_mesh(g_));
    CHECK(is_valid_in_its_own_way(g_));
  }

private:
  static constexpr bool HAS_OWN_POINTS = std::is_same<Place, In_the_mesh>::value;

  Graph g_;
  decltype(Place::map(std::declval<Graph&>())) points_;
  Faces faces_;                       // of the soup
  Marks<Edge_of<Graph>> edge_marks_;
  Marks<Vertex> vertex_marks_;
  Table<Face, int> patches_, face_numbers_;   // the latter is empty: nobody asks for it
  std::vector<std::pair<Vertex, Coordinates>> kept_;
};

// --- the history -------------------------------------------------------------------------------------------------

// Every point map can hold these points.
Soup in_floats(Soup soup)
{
  for(auto& p : soup.points)
    for(double& c : p)
      c = float(c);
  return soup;
}

// A ball at the origin, one at (3, 0, 0), and a square at (0, 3, 0), with a border.
Soup scene()
{
  return in_floats(meshes::sphere(2).joined_with(meshes::sphere(2).moved(3, 0, 0)).joined_with(meshes::square(6).moved(0, 3, 0)));
}

bool is_at_home(const Coordinates& p) { return p[0] < 1.5 && p[1] < 1.5; }
bool is_in_square(const Coordinates& p) { return p[1] > 1.5; }

template <class Graph, class Place>
History history_of_ranges()
{
  Subject<Graph, Place> s(scene());
  History history;
  const auto remember = [&](const char* what) { history.emplace_back(what, s.state()); };
  const auto run = [&](const auto& range, double length, const char* what) {
    const IAR::Remeshing_report report = s.remesh(range, length);
    CHECK_MESSAGE(report.splits + report.collapses > 0, what);
    remember(what);
  };
  // All ranges before anything is done, for their faces are in the soup's order, and no two share one.
  const auto upper = s.soup_faces_where([](const Coordinates& c) { return is_at_home(c) && c[2] > 0; });
  const auto lower = s.soup_faces_where([](const Coordinates& c) { return is_at_home(c) && c[2] < 0; });
  const auto ball = s.soup_faces_where([](const Coordinates& c) { return c[0] > 1.5; });
  const auto radius = [](const Coordinates& c) { return (std::max)(std::abs(c[0] - .5), std::abs(c[1] - 3.5)); };
  const auto ring = s.soup_faces_where([&](const Coordinates& c) { return is_in_square(c) && radius(c) > .2; });
  const auto core = s.soup_faces_where([&](const Coordinates& c) { return is_in_square(c) && radius(c) < .2; });

  remember("the soup");
  s.remesh(std::vector<Face_of<Graph>>(), .1);
  remember("an empty range");
  CHECK(history[1].second == history[0].second);
  run(upper, .2, "half of a ball, refined");
  run(lower, .6, "the other half, coarsened");
  run(ball, .5, "a whole component");
  run(ring, .07, "a range with a hole, on the border of the mesh");
  run(core, .05, "the hole of that range");
  // All of its edges are shared with faces that stay.
  s.remesh({core.front()}, .01);
  remember("a single face");
  CHECK(history.back().second == history[history.size() - 2].second);
  CHECK(s.remesh({core.front()}, .01, true).splits > 0);
  remember("a single face whose edges may be split");
  run(s.sorted_faces(), .3, "all of it");
  CHECK(s.are_own_points_untouched());
  return history;
}

template <class Graph, class Place>
History history_of_constraints()
{
  Subject<Graph, Place> s(in_floats(meshes::sphere(3)));
  const auto is_on_equator = [](const Coordinates& p, const Coordinates& q) { return p[2] == 0 && q[2] == 0; };
  const auto is_on_border_of_patch = [](const Coordinates& p, const Coordinates& q) { return p[0] == 0 && q[0] == 0; };
  const auto side = [](const Coordinates& c) { return c[0] > 0 ? 1 : 2; };
  s.mark(is_on_equator, side, [](const Coordinates& p) { return p[1] > .8; });
  History history;
  for(const double length : {.3, .1, .2})
  {
    s.remesh(s.sorted_faces(), length);
    history.emplace_back("constraints, length " + std::to_string(length), s.state());
    const State& state = history.back().second;
    CHECK(state.marked_edges.size() > 10);
    for(const auto e : edges(s.graph()))
    {
      const Coordinates p = s.position(source(e, s.graph())), q = s.position(target(e, s.graph()));
      CHECK(s.is_marked(e) == (is_on_equator(p, q) || is_on_border_of_patch(p, q)));
    }
    std::array<std::size_t, 3> of_patch = {0, 0, 0};
    for(const auto& [t, patch] : state.faces)
    {
      ++of_patch[patch];
      const double x = t[0][0] + t[1][0] + t[2][0];
      CHECK(patch == side({x, 0, 0}));
    }
    CHECK(of_patch[0] == 0 && of_patch[1] > 10 && of_patch[2] > 10);
  }
  return history;
}

// A mesh of one component without marks: the shortest way to call the function.
template <class Graph, class Place>
History history_of_a_whole_mesh()
{
  Subject<Graph, Place> s(in_floats(meshes::torus(16, 10, .4)));
  s.remesh(.2);
  return {{"a torus", s.state()}};
}

template <class Graph, class Place>
History history_of_a_sizing_field()
{
  Subject<Graph, Place> s(in_floats(meshes::torus(24, 12, .4)));
  s.remesh_by_curvature(s.soup_faces_where([](const Coordinates& c) { return c[0] > 0; }), .01, .1, .5);
  return {{"half of a torus, by its curvature", s.state()}};
}

// Cells of a chess board, as one mesh.
template <class Graph, class Place>
History history_of_parts_that_touch()
{
  Subject<Graph, Place> s(in_floats(meshes::without_isolated_points(meshes::square_without(6, [](std::size_t i, std::size_t j) {
    return (i / 2 + j / 2) % 2 == 1;
  }))));
  History history;
  for(const double length : {.05, .2})
  {
    s.remesh(s.sorted_faces(), length);
    history.emplace_back("parts that touch, length " + std::to_string(length), s.state());
  }
  return history;
}

template <class Graph, class Place>
History history_of_attributes()
{
  Subject<Graph, Place> s(in_floats(meshes::square(6)));
  s.carry_attributes(.1);
  return {{"a square with attributes", s.state()}};
}

template <class Graph, class Place>
History history_of_moves()
{
  Subject<Graph, Place> s(in_floats(meshes::torus(20, 12, .4)));
  s.move_one_side(.2);
  return {{"a torus of which one side moves", s.state()}};
}

template <class Graph, class Place>
History history()
{
  History result = history_of_ranges<Graph, Place>();
  for(auto&& entry : history_of_constraints<Graph, Place>())
    result.push_back(entry);
  for(auto&& entry : history_of_parts_that_touch<Graph, Place>())
    result.push_back(entry);
  result.push_back(history_of_a_whole_mesh<Graph, Place>().front());
  result.push_back(history_of_a_sizing_field<Graph, Place>().front());
  result.push_back(history_of_attributes<Graph, Place>().front());
  result.push_back(history_of_moves<Graph, Place>().front());
  return result;
}

// Whether the point map keeps no more than a float of each coordinate.
template <class Graph, class Place>
bool holds_floats()
{
  Graph g;
  const auto points = Place::map(g);
  const auto v = add_vertex(g);
  put(points, v, Point_of<Graph>(1 / 3., 0, 0));
  return coordinates(get(points, v))[0] != 1 / 3.;
}

const History& reference(bool in_floats)
{
  static const History of_doubles = history<Double_mesh, In_the_mesh>(), of_floats = history<Float_mesh, In_the_mesh>();
  return in_floats ? of_floats : of_doubles;
}

template <class Graph, class Place = In_the_mesh>
void every_type_comes_to_the_same(const char* name)
{
  const std::size_t failures = checks::number_of_failures();
  const History expected = reference(holds_floats<Graph, Place>()), actual = history<Graph, Place>();
  CHECK(actual.size() == expected.size());
  for(std::size_t i = 0; i < expected.size(); ++i)
    CHECK_MESSAGE(actual[i].second == expected[i].second, name << ": " << expected[i].first);
  if(checks::number_of_failures() > failures)
    std::cerr << "... on " << name << std::endl;
}

// Each of the last allocations of a run fails once: those for the result, in the mesh.
// (The containers of a cell complex do not survive that themselves.)
template <class Graph>
void running_out_of_memory_changes_nothing()
{
  constexpr std::size_t MANY = std::size_t(1) << 30;
  std::size_t allocations = 0;
  for(std::size_t back = 0; back <= 50; ++back)
  {
    // Vertices are made on the square, and removed from the ball.
    Subject<Graph, In_the_mesh> s(in_floats(meshes::square(3).joined_with(meshes::sphere(2).moved(3, 0, 0))));
    const std::vector<Triangle> before = s.triangles();
    bool has_failed = false;
    allocations_left = back == 0 ? MANY : allocations - back + 1;
    try
    {
      IAR::isotropic_remeshing(.3, s.graph());
    }
    catch(const std::bad_alloc&)
    {
      has_failed = true;
    }
    if(back == 0)
      allocations = MANY - allocations_left;
    allocations_left = 0;
    CHECK(allocations > 50);
    CHECK_MESSAGE(has_failed == (back > 0), back << " allocations before the last");
    CHECK_MESSAGE((s.triangles() == before) == has_failed, back << " allocations before the last");
    s.check_validity();
  }
}

// The point map fails when the result is written.
template <class Graph>
void a_point_map_that_throws_changes_nothing()
{
  for(const std::size_t puts : {1, 10, 60})
  {
    Subject<Graph, In_a_table> s(in_floats(meshes::sphere(2)));
    const std::vector<Triangle> before = s.triangles();
    s.points().let_put_fail_after(puts);
    CHECK_THROWS_AS(s.remesh(.3), std::runtime_error, "no room");
    CHECK(s.triangles() == before);
    s.check_validity();
  }
}

// --- what only one type has --------------------------------------------------------------------------------------

// The run is in double precision, whatever the kernel: a mesh of floats gets its result, rounded once.
void floats_are_rounded_once()
{
  const State floats = history_of_a_whole_mesh<Float_mesh, In_the_mesh>().front().second;
  State doubles = history_of_a_whole_mesh<Double_mesh, In_the_mesh>().front().second;
  CHECK(!(doubles == floats));
  for(auto& [t, patch] : doubles.faces)
  {
    for(Coordinates& p : t)
      for(double& c : p)
        c = float(c);
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  }
  std::sort(doubles.faces.begin(), doubles.faces.end());
  CHECK(doubles == floats);
}

// Patches may be of any type that can be compared.
void patches_may_have_names()
{
  Double_mesh m = meshes::to_mesh<Double_mesh>(meshes::sphere(3));
  auto names = m.add_property_map<Double_mesh::Face_index, std::string>("f:name").first;
  const auto name = [&](Double_mesh::Face_index f) {
    double z = 0;
    for(const auto v : vertices_around_face(m.halfedge(f), m))
      z += m.point(v).z();
    return std::string(z > 0 ? "the northern hemisphere" : "the southern hemisphere");
  };
  for(const auto f : m.faces())
    names[f] = name(f);
  const std::size_t faces_before = m.number_of_faces();
  IAR::isotropic_remeshing(.1, m, parameters::face_patch_map(names));
  CHECK(m.number_of_faces() > faces_before);
  for(const auto f : m.faces())
    CHECK_MESSAGE(names[f] == name(f), names[f]);
}

// A length as a function of exact points, with exact values, comes to what it comes to in doubles.
void lengths_may_be_exact()
{
  const Soup soup = meshes::sphere(3);
  auto exact = meshes::to_mesh<CGAL::Surface_mesh<Epeck::Point_3>>(soup);
  auto plain = meshes::to_mesh<Double_mesh>(soup);
  IAR::isotropic_remeshing([](const Epeck::Point_3& p) -> Epeck::FT { return (3 + p.z()) / 16; }, exact,
                           parameters::number_of_iterations(Epeck::FT(10)).sharpness_angle(Epeck::FT(180)));
  IAR::isotropic_remeshing([](const Double_kernel::Point_3& p) { return (3 + p.z()) / 16; }, plain, parameters::sharpness_angle(180));
  CHECK(exact.number_of_faces() != soup.faces.size());
  CHECK(exact.number_of_vertices() == plain.number_of_vertices() && exact.number_of_faces() == plain.number_of_faces());
  for(const auto v : plain.vertices())
    CHECK(coordinates(exact.point(v)) == coordinates(plain.point(v)));
}

// Points that were constructed have no doubles of their own, and what stands for them may change as exact values are asked for. That
// changes neither points of vertices that stay nor the result.
void constructed_points_are_kept()
{
  using Exact_mesh = CGAL::Surface_mesh<Epeck::Point_3>;
  using Exact_vertex = Exact_mesh::Vertex_index;
  const auto turned = [&]() {
    auto m = meshes::to_mesh<Exact_mesh>(meshes::sphere(3));
    for(const Exact_vertex v : m.vertices())
    {
      const Epeck::Point_3 p = m.point(v);
      m.point(v) = Epeck::Point_3((3 * p.x() - 4 * p.y()) / 5, (4 * p.x() + 3 * p.y()) / 5, p.z() / 3);
    }
    return m;
  };
  const auto as_doubles = [](const Exact_mesh& m) {
    std::vector<std::array<double, 3>> result;
    for(const Exact_vertex v : m.vertices())
    {
      const auto p = CGAL::exact(m.point(v));
      result.push_back({CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
    }
    return result;
  };
  const double length = .1;
  Exact_mesh lazy = turned(), evaluated = turned();
  for(const Exact_vertex v : evaluated.vertices())
    CGAL::exact(evaluated.point(v));
  IAR::isotropic_remeshing(length, lazy);
  IAR::isotropic_remeshing(length, evaluated);
  CHECK(as_doubles(lazy) == as_doubles(evaluated));

  // The user's code asks for exact values while the run is under way.
  const Exact_mesh input = turned();
  Exact_mesh m = turned();
  const auto is_kept = m.add_property_map<Exact_vertex, bool>("v:kept", false).first;
  for(const Exact_vertex v : m.vertices())
    is_kept[v] = v.idx() % 3 == 0;
  IAR::isotropic_remeshing([&](const Epeck::Point_3&) {
    for(const Exact_vertex v : m.vertices())
      CGAL::exact(m.point(v));
    return length;
  }, m, parameters::vertex_is_constrained_map(is_kept).number_of_iterations(1));
  for(const Exact_vertex v : input.vertices())
    if(v.idx() % 3 == 0)
      CHECK(!m.is_removed(v) && m.point(v) == input.point(v));
}

// A part of a mesh as a mesh of its own cannot be changed, as a range of faces it can be remeshed.
void a_filtered_mesh_is_a_range()
{
  using Filtered = CGAL::Face_filtered_graph<Double_mesh>;
  using IAR::internal::Is_mutable_face_graph;
  static_assert(Is_mutable_face_graph<Double_mesh>::value && Is_mutable_face_graph<Polyhedron>::value &&
                Is_mutable_face_graph<Cell_complex>::value, "these can be remeshed");
  static_assert(!Is_mutable_face_graph<Filtered>::value && !Is_mutable_face_graph<const Double_mesh>::value, "these cannot");

  Double_mesh m = meshes::to_mesh<Double_mesh>(meshes::square(6));
  auto patch = m.add_property_map<Double_mesh::Face_index, int>("f:patch", 0).first;
  for(std::size_t f = 0; f < m.number_of_faces() / 2; ++f)
    patch[Double_mesh::Face_index(Double_mesh::size_type(f))] = 1;
  const std::size_t others = m.number_of_faces() / 2;
  const Filtered part(m, 1, patch);
  const IAR::Remeshing_report report = IAR::isotropic_remeshing(faces(part), .07, m, parameters::face_patch_map(patch));
  CHECK(report.splits > 0);
  CHECK(CGAL::is_valid_polygon_mesh(m));
  CHECK(std::size_t(std::count_if(m.faces_begin(), m.faces_end(), [&](auto f) { return patch[f] == 0; })) == others);
}

// A point of an application of its own, which has a function that the package has, too, by that name.
namespace application {

struct Point
{
  std::array<double, 3> coordinates{};

  Point() = default;
  Point(double x, double y, double z) : coordinates{x, y, z} {}
  double x() const { return coordinates[0]; }
  double y() const { return coordinates[1]; }
  double z() const { return coordinates[2]; }
};

inline std::array<double, 3> to_vector3(const Point& p) { return p.coordinates; }

} // namespace application

// The containers of the standard library, as property maps.
void a_map_of_points_will_do()
{
  Double_mesh m = meshes::to_mesh<Double_mesh>(meshes::torus(16, 10, .4)), other = m;
  std::map<Double_mesh::Vertex_index, application::Point> points;
  std::vector<std::size_t> numbers;
  for(const auto v : m.vertices())
  {
    points[v] = {m.point(v).x(), m.point(v).y(), m.point(v).z()};
    m.point(v) = CGAL::ORIGIN;
  }
  for(const auto f : m.faces())
    numbers.push_back(std::size_t(f));
  const auto number_map = boost::make_iterator_property_map(numbers.begin(), get(CGAL::face_index, m));
  IAR::isotropic_remeshing(.2, m, parameters::vertex_point_map(boost::make_assoc_property_map(points)).face_index_map(number_map));
  IAR::isotropic_remeshing(.2, other);
  CHECK(m.number_of_vertices() == other.number_of_vertices());
  for(const auto v : other.vertices())
    CHECK(to_vector3(points.at(v)) == (std::array{other.point(v).x(), other.point(v).y(), other.point(v).z()}));
}

#ifdef TEST_WITH_OPENMESH
struct Double_traits : OpenMesh::DefaultTraits
{
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using Float_poly_mesh = OpenMesh::PolyMesh_ArrayKernelT<>;
using Double_tri_mesh = OpenMesh::TriMesh_ArrayKernelT<Double_traits>;

// What was removed waits for the collection, and the mesh is one for OpenMesh's own functions.
template <class Graph>
void garbage_can_be_collected()
{
  Graph g = meshes::to_mesh<Graph>(in_floats(meshes::square(12)));
  const std::size_t vertices_before = g.n_vertices();
  IAR::isotropic_remeshing(.2, g);
  const std::size_t vertices_after = length_of(vertices(g)), faces_after = length_of(faces(g));
  CHECK(vertices_after < vertices_before && vertices_after < g.n_vertices());
  g.garbage_collection();
  CHECK(g.n_vertices() == vertices_after && g.n_faces() == faces_after);
  CHECK(CGAL::is_valid_polygon_mesh(g));
  CHECK(are_borders_known_to_open_mesh(g));
  std::size_t sum = 0;
  for(const auto v : g.vertices())
    for(auto f = g.vf_iter(v); f.is_valid(); ++f)
      ++sum;
  CHECK(sum == 3 * faces_after);
}
#endif

int main()
{
  floats_are_rounded_once();
  every_type_comes_to_the_same<CGAL::Surface_mesh<Epeck::Point_3>, In_a_vector>("Surface_mesh, exact points in a vector");
  every_type_comes_to_the_same<Polyhedron>("Polyhedron_3");
  every_type_comes_to_the_same<Polyhedron_with_ids, In_a_table>("Polyhedron_3 with ids, points in a table");
  every_type_comes_to_the_same<Cell_complex>("Linear_cell_complex");
  a_point_map_that_throws_changes_nothing<Cell_complex>();
#ifdef TEST_WITH_OPENMESH
  every_type_comes_to_the_same<Float_poly_mesh>("OpenMesh::PolyMesh_ArrayKernelT");
  // In a table, for CGAL's own map of these points rounds to floats in some versions.
  every_type_comes_to_the_same<Double_tri_mesh, In_a_table>("OpenMesh::TriMesh_ArrayKernelT in double precision");
#  ifdef NDEBUG      // OpenMesh's assertions allocate names, wherever a flag is set
  running_out_of_memory_changes_nothing<Double_tri_mesh>();
#  endif
  garbage_can_be_collected<Float_poly_mesh>();
  garbage_can_be_collected<Double_tri_mesh>();
#endif
  patches_may_have_names();
  lengths_may_be_exact();
  constructed_points_are_kept();
  a_map_of_points_will_do();
  a_filtered_mesh_is_a_range();
  return result();
}
