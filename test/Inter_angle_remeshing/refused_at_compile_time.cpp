// Copyright (c) 2026 The Inter_angle_remeshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Programs with one mistake each: an argument of a type that cannot be meant. Not to be built: the test refused_at_compile_time
// looks at what the compiler says about them, which is one sentence each, the one behind `expect:`, and nothing else. One of
// them alone is looked at with -DCASE=<number>; with -DCASE=0 there is no mistake, and everything compiles.

#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <string>
#include <vector>

#ifndef CASE
#  define HAS_CASE(number) 1
#else
#  define HAS_CASE(number) (CASE == number)
#endif

namespace IAR = CGAL::Inter_angle_remeshing;
namespace parameters = CGAL::parameters;

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
template <class Value>
using Edge_map = Mesh::Property_map<Mesh::Edge_index, Value>;
template <class Value>
using Vertex_map = Mesh::Property_map<Mesh::Vertex_index, Value>;
template <class Value>
using Face_map = Mesh::Property_map<Mesh::Face_index, Value>;

struct Nameless {};    // nothing can be done with it

struct Takes_strings
{
  bool operator()(const std::string&) const { return true; }
};

struct Listens_to_splits_alone
{
  template <class Halfedge, class Graph>
  void before_split(Halfedge, const Graph&) {}
};

void wrong(Mesh& mesh, const Mesh& const_mesh, std::vector<int>& numbers)
{
  (void)mesh; (void)const_mesh; (void)numbers;
  const auto remesh = [&mesh](const auto& np) { IAR::isotropic_remeshing(faces(mesh), .1, mesh, np); };
  (void)remesh;

#if HAS_CASE(0) && defined(CASE)
  remesh(parameters::edge_is_constrained_map(Edge_map<int>()).vertex_is_constrained_map(Vertex_map<char>())
           .face_patch_map(Face_map<std::string>()).do_split([](const auto& edge) { return edge.length() < 1; }).do_collapse(1)
           .do_flip(IAR::Inter_angle_flip_policy<>()).protect_constraints(1).verbose(0).sharpness_angle(40.f)
           .visitor(IAR::Default_visitor()).callback([](double) { return true; }).projection_functor([](const Point& p) { return p; })
           .allow_move_functor([](Mesh::Vertex_index, const Point&, const Point&) { return true; }));
  IAR::isotropic_remeshing<CGAL::Parallel_if_available_tag>([](const Point& p) { return 1 + p.x(); }, mesh);
#endif
#if HAS_CASE(1)   // expect: edge_is_constrained_map: expected a property map with edges of the mesh as keys
  remesh(parameters::edge_is_constrained_map(Vertex_map<bool>()));
#endif
#if HAS_CASE(2)   // expect: edge_is_constrained_map: expected a property map with edges of the mesh as keys and bool as value type
  remesh(parameters::edge_is_constrained_map(Edge_map<std::string>()));
#endif
#if HAS_CASE(3)   // expect: vertex_is_constrained_map: expected a property map with vertices of the mesh as keys
  remesh(parameters::vertex_is_constrained_map(Edge_map<bool>()));
#endif
#if HAS_CASE(4)   // expect: face_patch_map: expected a property map with faces of the mesh as keys
  remesh(parameters::face_patch_map(Edge_map<int>()));
#endif
#if HAS_CASE(5)   // expect: face_patch_map: expected a property map with faces of the mesh as keys and values that can be copied and compared
  remesh(parameters::face_patch_map(Face_map<Nameless>()));
#endif
#if HAS_CASE(6)   // expect: do_split: expected a bool or a policy
  remesh(parameters::do_split(std::string("never")));
#endif
#if HAS_CASE(7)   // expect: do_collapse: expected a bool or a policy
  remesh(parameters::do_collapse(Takes_strings()));
#endif
#if HAS_CASE(8)   // expect: projection_functor: expected a functor
  remesh(parameters::projection_functor(Takes_strings()));
#endif
#if HAS_CASE(9)   // expect: callback: expected a functor
  remesh(parameters::callback([](const std::string&) { return true; }));
#endif
#if HAS_CASE(10)  // expect: visitor: expected a model of RemeshingVisitor
  remesh(parameters::visitor(Listens_to_splits_alone()));
#endif
#if HAS_CASE(11)  // expect: number_of_iterations, number_of_relaxation_steps: expected a number
  remesh(parameters::number_of_iterations(std::string("many")));
#endif
#if HAS_CASE(12)  // expect: protect_constraints, collapse_constraints, relax_constraints, verbose: expected a bool
  remesh(parameters::protect_constraints(std::string("yes")));
#endif
#if HAS_CASE(13)  // expect: the length must be a number, Face_count(n), a sizing field
  IAR::isotropic_remeshing(std::string("long"), mesh);
#endif
#if HAS_CASE(14)  // expect: the mesh must be a model of MutableFaceGraph
  IAR::isotropic_remeshing(.1, numbers);
#endif
#if HAS_CASE(15)  // expect: the mesh must be a model of MutableFaceGraph that is not const
  IAR::isotropic_remeshing(faces(const_mesh), .1, const_mesh);
#endif
#if HAS_CASE(16)  // expect: the range must be one of faces of the mesh
  IAR::isotropic_remeshing(vertices(mesh), .1, mesh);
#endif
#if HAS_CASE(17)  // expect: CGAL::Parallel_tag was asked for, but TBB is not linked
  IAR::isotropic_remeshing<CGAL::Parallel_tag>(.1, mesh);
#endif
#if HAS_CASE(18)  // expect: vertex_point_map: expected a property map that can be written
  remesh(parameters::vertex_point_map(Vertex_map<double>()));
#endif
#if HAS_CASE(19)  // expect: sharpness_angle: expected a number
  remesh(parameters::sharpness_angle(std::string("sharp")));
#endif
#if HAS_CASE(20)  // expect: what follows the mesh must be named parameters
  IAR::isotropic_remeshing(faces(mesh), .1, mesh, IAR::Recipe());
#endif
#if HAS_CASE(21)  // expect: what follows the mesh must be named parameters
  const unsigned iterations = 5;
  IAR::isotropic_remeshing(.1, mesh, iterations);
#endif
#if HAS_CASE(22)  // expect: allow_move_functor: expected a functor
  remesh(parameters::allow_move_functor([](const Point&) { return true; }));
#endif
}
