// Copyright (c) 2026 The Inter_angle_remeshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The same bits come out of isotropic_remeshing() in every run, for every type of mesh, whatever its descriptors look
// like, for every number of threads, and at every scale.

#include "invariants.h"

#include <CGAL/Inter_angle_remeshing/Attribute_transfer.h>
#include <CGAL/Inter_angle_remeshing/Curvature_sizing_field.h>
#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>
#include <CGAL/Inter_angle_remeshing/triangle_quality.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/Euler_operations.h>

#ifdef CGAL_LINKED_WITH_TBB
#  include <tbb/global_control.h>
#  include <tbb/parallel_for.h>
#  include <tbb/task_arena.h>
#  include <tbb/task_group.h>
#endif

#include "check.h"
#include "meshes.h"
#include "models.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace IAR = CGAL::Inter_angle_remeshing;
namespace parameters = CGAL::parameters;
using namespace invariants;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using meshes::Picture;
using meshes::Soup;

// The run under the sanitizers takes small meshes: the first of these of each kind.
struct Input
{
  std::string name;
  Mesh mesh;
  double length;

  explicit Input(const std::string& file, double factor = 1)
    : name(file), mesh(models::of_cgal(file)), length(factor * mean_edge_length(mesh))
  {}
};

Input closed_input() { return meshes::is_small_run() ? Input("eight") : Input("elephant"); }
Input input_with_border() { return meshes::is_small_run() ? Input("nefertiti") : Input("lion-head"); }
Input input_with_features() { return meshes::is_small_run() ? Input("joint") : Input("fandisk"); }
// More than 50,000 vertices while it is remeshed: above that, sweeps run over larger blocks.
Input large_input() { return meshes::is_small_run() ? Input("cactus") : Input("armadillo", .7); }

Soup soup(const Mesh& mesh)
{
  Soup result;
  for(const Vertex v : vertices(mesh))
    result.points.push_back({mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()});
  for(const Face f : faces(mesh))
  {
    const auto h = halfedge(f, mesh);
    result.faces.push_back({source(h, mesh).idx(), target(h, mesh).idx(), target(next(h, mesh), mesh).idx()});
  }
  return result;
}

// The faces by the bits of their points, without a trace of descriptors.
template <class Graph>
std::vector<std::array<meshes::Bits, 3>> triangles_of_points(const Graph& g)
{
  std::vector<std::array<meshes::Bits, 3>> result;
  for(const auto f : faces(g))
  {
    const auto h = halfedge(f, g);
    std::array<meshes::Bits, 3> t = {meshes::bits(get(CGAL::vertex_point, g, source(h, g))),
                                     meshes::bits(get(CGAL::vertex_point, g, target(h, g))),
                                     meshes::bits(get(CGAL::vertex_point, g, target(next(h, g), g)))};
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    result.push_back(t);
  }
  std::sort(result.begin(), result.end());
  return result;
}

// --- settings ----------------------------------------------------------------------------------------------------

// A user's policy: takes decisions that depend on numbers that a faulty profile would get wrong.
struct Picky_policy
{
  template <class Profile>
  bool operator()(const Profile& profile) const
  {
    return profile.length() < 3 * profile.target_length() && profile.maximum_adjacent_angle() < 160;
  }
};

// Counts what it is told of; the same operations in the same order leave the same hash.
struct Hashing_visitor : IAR::Default_visitor
{
  std::size_t hash = 0;

  void add(std::size_t value) { hash = hash * 1000003 + value; }
  template <class M>
  void end_pass(IAR::Pass pass, const M&, std::size_t count) { add(std::size_t(pass)); add(count); }
  template <class V, class M>
  void after_split(V v, const M& m) { add(degree(v, m)); }
  template <class V, class M>
  void after_collapse(V v, const M& m) { add(degree(v, m) + 100); }
  template <class H, class M>
  void after_flip(H h, const M& m) { add(degree(target(h, m), m) + 200); }
};

// How to remesh, with a report of what visitors were told.
struct Plain
{
  template <class ConcurrencyTag, class Graph>
  static std::size_t remesh(Graph& g, double length)
  {
    Hashing_visitor visitor;
    IAR::isotropic_remeshing<ConcurrencyTag>(length, g, parameters::visitor(std::ref(visitor)));
    return visitor.hash;
  }
};

// Constraints, policies and a range: the faces but each hundredth.
struct Elaborate
{
  template <class ConcurrencyTag>
  static std::size_t remesh(Mesh& mesh, double length)
  {
    auto is_constrained_edge = mesh.add_property_map<Edge, bool>("e:is_constrained", false).first;
    auto is_constrained_vertex = mesh.add_property_map<Vertex, bool>("v:is_constrained", false).first;
    for(const Edge e : edges(mesh))
      is_constrained_edge[e] = e.idx() % 30 == 7;
    for(const Vertex v : vertices(mesh))
      is_constrained_vertex[v] = v.idx() % 50 == 3;
    std::vector<Face> range;
    for(const Face f : faces(mesh))
      if(f.idx() % 100 != 11)
        range.push_back(f);

    Hashing_visitor visitor;
    IAR::isotropic_remeshing<ConcurrencyTag>(range, length, mesh,
      parameters::do_split(Picky_policy()).do_collapse(Picky_policy()).do_flip(Picky_policy())
        .edge_is_constrained_map(is_constrained_edge).vertex_is_constrained_map(is_constrained_vertex)
        .sharpness_angle(40).number_of_iterations(6).visitor(std::ref(visitor)));
    for(const Edge e : edges(mesh))
      visitor.add(is_constrained_edge[e]);
    return visitor.hash;
  }
};

// A projector of the user's, and a wanted number of faces.
struct Projected
{
  struct Onto_unit_sphere
  {
    Point operator()(const Point& p) const
    {
      const Vector v = p - CGAL::ORIGIN;
      return CGAL::ORIGIN + v / std::sqrt(v.squared_length());
    }
  };

  template <class ConcurrencyTag>
  static std::size_t remesh(Mesh& mesh, double)
  {
    const auto report = IAR::isotropic_remeshing<ConcurrencyTag>(IAR::Face_count(mesh.number_of_faces() * 2 / 3), mesh,
                                                                 parameters::projection_functor(Onto_unit_sphere()));
    return report.output_faces;
  }
};

// Lengths by the curvature, then by the position, with an attribute that is carried over twice.
struct Graded
{
  template <class ConcurrencyTag>
  static std::size_t remesh(Mesh& mesh, double length)
  {
    const auto height = mesh.add_property_map<Vertex, double>("v:height", 0).first;
    for(const Vertex v : mesh.vertices())
      height[v] = mesh.point(v).z();
    IAR::Attribute_transfer<Mesh> transfer;
    transfer.add_vertex_map(height);
    const IAR::Curvature_sizing_field<Mesh> curvature(.03 * length, {length / 2, 2 * length}, faces(mesh), mesh);
    IAR::isotropic_remeshing<ConcurrencyTag>(curvature, mesh, parameters::visitor(std::ref(transfer)));
    const auto wave = [=](const Point& p) { return length * (1 + .2 * std::sin(p.x() / length / 5)); };
    IAR::isotropic_remeshing<ConcurrencyTag>(wave, mesh, parameters::visitor(std::ref(transfer)));
    std::size_t hash = 0;
    for(const Vertex v : mesh.vertices())
      hash = hash * 1000003 + std::hash<double>()(height[v]);
    return hash;
  }
};

// --- runs, descriptors, types of meshes --------------------------------------------------------------------------

void two_runs_agree()
{
  for(const Input& input : {closed_input(), input_with_border()})
  {
    Mesh first = input.mesh, second = input.mesh;
    const std::size_t hash = Plain::remesh<CGAL::Sequential_tag>(first, input.length);
    CHECK_MESSAGE(Plain::remesh<CGAL::Sequential_tag>(second, input.length) == hash, input.name);
    CHECK_MESSAGE(Picture<Mesh>(first) == Picture<Mesh>(second), input.name);
    CHECK_MESSAGE(Picture<Mesh>(first) != Picture<Mesh>(input.mesh), input.name << ": nothing was done");
  }
}

// Every third vertex and about every seventh face is followed by one that is removed in the end.
Mesh with_garbage(const Soup& input)
{
  Mesh mesh;
  std::vector<Vertex> corners, unwanted;
  for(const auto& p : input.points)
  {
    corners.push_back(mesh.add_vertex(Point(p[0], p[1], p[2])));
    if(corners.size() % 3 == 0)
      unwanted.push_back(mesh.add_vertex(Point(7, 7, double(corners.size()))));
  }
  std::vector<Face> unwanted_faces;
  for(const auto& f : input.faces)
  {
    CGAL::Euler::add_face(std::vector<Vertex>{corners[f[0]], corners[f[1]], corners[f[2]]}, mesh);
    const std::size_t k = 3 * unwanted_faces.size();
    if(mesh.number_of_faces() % 7 == 0 && k + 3 <= unwanted.size())
      unwanted_faces.push_back(mesh.add_face(unwanted[k], unwanted[k + 1], unwanted[k + 2]));
  }
  for(const Face f : unwanted_faces)
    CGAL::Euler::remove_face(halfedge(f, mesh), mesh); // takes its vertices along
  for(const Vertex v : unwanted)
    if(!mesh.is_removed(v))
      mesh.remove_vertex(v);
  return mesh;
}

void holes_among_the_descriptors_change_nothing()
{
  for(const Input& input : {closed_input(), input_with_border()})
  {
    const Soup faces_and_points = soup(input.mesh);
    Mesh dense = meshes::to_mesh<Mesh>(faces_and_points), holey = with_garbage(faces_and_points);
    CHECK_MESSAGE(holey.has_garbage() && holey.number_of_removed_faces() > 0, input.name);
    CHECK_MESSAGE(triangles_of_points(holey) == triangles_of_points(dense), input.name << ": not the same input");
    const std::size_t hash = Plain::remesh<CGAL::Sequential_tag>(dense, input.length);
    CHECK_MESSAGE(Plain::remesh<CGAL::Sequential_tag>(holey, input.length) == hash, input.name);
    CHECK_MESSAGE(triangles_of_points(holey) == triangles_of_points(dense), input.name);
    CHECK_MESSAGE(topology(holey) == topology(dense), input.name);
  }
}

void a_polyhedron_becomes_the_same()
{
  for(const Input& input : {closed_input(), input_with_border()})
  {
    const Soup faces_and_points = soup(input.mesh);
    Mesh mesh = meshes::to_mesh<Mesh>(faces_and_points);
    Polyhedron polyhedron = meshes::to_mesh<Polyhedron>(faces_and_points);
    const std::size_t hash = Plain::remesh<CGAL::Sequential_tag>(mesh, input.length);
    CHECK_MESSAGE(Plain::remesh<CGAL::Sequential_tag>(polyhedron, input.length) == hash, input.name);
    CHECK_MESSAGE(polyhedron.is_valid(), input.name);
    CHECK_MESSAGE(triangles_of_points(polyhedron) == triangles_of_points(mesh), input.name);
  }
}

// --- threads -----------------------------------------------------------------------------------------------------

#ifdef CGAL_LINKED_WITH_TBB
template <class Setting>
void check_threads(const Input& input)
{
  Mesh expected = input.mesh;
  const std::size_t hash = Setting::template remesh<CGAL::Sequential_tag>(expected, input.length);
  const Picture<Mesh> picture(expected);
  CHECK_MESSAGE(CGAL::is_valid_polygon_mesh(expected), input.name);
  for(const int threads : {1, 2, 4})
  {
    Mesh mesh = input.mesh;
    std::size_t parallel_hash = 0;
    // More threads than the machine has cores: an arena asks for them, the control allows them.
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, std::size_t(threads));
    tbb::task_arena arena(threads);
    arena.execute([&]() { parallel_hash = Setting::template remesh<CGAL::Parallel_tag>(mesh, input.length); });
    CHECK_MESSAGE(parallel_hash == hash, input.name << " with " << threads << " threads");
    CHECK_MESSAGE(Picture<Mesh>(mesh) == picture, input.name << " with " << threads << " threads");
  }
}

void any_number_of_threads_yields_the_same()
{
  check_threads<Plain>(closed_input());
  check_threads<Plain>(input_with_border());
  check_threads<Plain>(large_input());
  check_threads<Elaborate>(closed_input());
  check_threads<Elaborate>(input_with_border());
  check_threads<Elaborate>(input_with_features());
  check_threads<Graded>(closed_input());
  check_threads<Graded>(input_with_border());
  Input sphere("sphere");
  sphere.mesh = meshes::to_mesh<Mesh>(meshes::sphere(meshes::is_small_run() ? 2 : 5));
  check_threads<Projected>(sphere);
}

// A run that goes on while the tasks around it are cancelled must not leave out what it would do in tasks of its own.
void cancelled_tasks_around_a_run_change_nothing()
{
  const Input input = closed_input();
  Mesh expected = input.mesh, mesh = input.mesh;
  const std::size_t hash = Plain::remesh<CGAL::Sequential_tag>(expected, input.length);
  std::size_t hash_within_cancelled = 0;
  tbb::task_group_context context;
  tbb::parallel_for(0, 1, [&](int) {
    context.cancel_group_execution();
    hash_within_cancelled = Plain::remesh<CGAL::Parallel_tag>(mesh, input.length);
  }, context);
  CHECK(context.is_group_execution_cancelled());
  CHECK(hash_within_cancelled == hash);
  CHECK(Picture<Mesh>(mesh) == Picture<Mesh>(expected));
}
#endif

// --- scale and place ---------------------------------------------------------------------------------------------

void powers_of_two_commute_with_remeshing()
{
  for(const Input& input : {closed_input(), input_with_border()})
  {
    Mesh expected = input.mesh;
    Plain::remesh<CGAL::Sequential_tag>(expected, input.length);
    for(const int exponent : {-900, -332, -3, 1, 332, 900}) // no coordinate becomes subnormal: 1e-10 * 2^-900 = 1e-281
    {
      const auto scale = [exponent](Mesh& mesh) {
        for(const Vertex v : vertices(mesh))
        {
          const Point p = mesh.point(v);
          mesh.point(v) = Point(std::ldexp(p.x(), exponent), std::ldexp(p.y(), exponent), std::ldexp(p.z(), exponent));
        }
      };
      Mesh mesh = input.mesh, scaled_result = expected;
      scale(mesh);
      scale(scaled_result);
      Plain::remesh<CGAL::Sequential_tag>(mesh, std::ldexp(input.length, exponent));
      CHECK_MESSAGE(Picture<Mesh>(mesh) == Picture<Mesh>(scaled_result), input.name << " times 2^" << exponent);
    }
  }
}

// The mesh with each point p at factor p + offset is as good, up to rounding.
void tiny_huge_and_far_away_meshes_are_remeshed()
{
  struct Place { double factor, offset; };
  for(const Input& input : {closed_input(), input_with_border()})
  {
    Mesh reference = input.mesh;
    Plain::remesh<CGAL::Sequential_tag>(reference, input.length);
    const auto reference_angles = IAR::inter_angle_statistics(reference);
    for(const Place place : {Place{1e-100, 0}, Place{1e100, 0}, Place{1, 1e6}, Place{1e-3, -1e5}})
    {
      const std::string what = input.name + " times " + std::to_string(place.factor) + " plus " +
                               std::to_string(place.offset);
      Mesh mesh = input.mesh;
      for(const Vertex v : vertices(mesh))
      {
        const Point p = mesh.point(v);
        mesh.point(v) = Point(place.factor * p.x() + place.offset, place.factor * p.y() + place.offset,
                              place.factor * p.z() + place.offset);
      }
      Plain::remesh<CGAL::Sequential_tag>(mesh, place.factor * input.length);
      CHECK_MESSAGE(CGAL::is_valid_polygon_mesh(mesh), what);
      CHECK_MESSAGE(is_finite(mesh), what);
      CHECK_MESSAGE(topology(mesh) == topology(input.mesh), what);
      // Rounding the input changes some decisions, and lengths 2% apart change the average by .1 degree.
      const auto angles = IAR::inter_angle_statistics(mesh);
      CHECK_MESSAGE(std::abs(angles.average - reference_angles.average) < 1, what << ": " << angles.average);
      const double faces = double(reference.number_of_faces());
      CHECK_MESSAGE(std::abs(double(mesh.number_of_faces()) - faces) < .05 * faces, what << ": " << faces);
    }
  }
}

int main()
{
  two_runs_agree();
  holes_among_the_descriptors_change_nothing();
  a_polyhedron_becomes_the_same();
#ifdef CGAL_LINKED_WITH_TBB
  any_number_of_threads_yields_the_same();
  cancelled_tasks_around_a_run_change_nothing();
#endif
  powers_of_two_commute_with_remeshing();
  tiny_huge_and_far_away_meshes_are_remeshed();
  return result();
}
