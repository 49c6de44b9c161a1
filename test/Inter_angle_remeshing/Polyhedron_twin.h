// Copyright (c) 2026 The Inter_angle_remeshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_TEST_POLYHEDRON_TWIN_H
#define CGAL_INTER_ANGLE_REMESHING_TEST_POLYHEDRON_TWIN_H

// A Polyhedron_3 that is a copy of a Surface_mesh, with copies of the property maps of a call: the call on the one must come to
// the same as on the other.

#include <CGAL/Inter_angle_remeshing/internal/arguments/named_parameters.h>
#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include "invariants.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

class Polyhedron_twin
{
  using Polyhedron = CGAL::Polyhedron_3<invariants::Kernel>;
  using Traits = boost::graph_traits<Polyhedron>;
  using Point = invariants::Point;
  using Triangle = std::array<Point, 3>;

  template <class NamedParameters, class Tag>
  static constexpr bool has()
  {
    return CGAL::Inter_angle_remeshing::internal::has_parameter<NamedParameters, Tag>();
  }
  template <class NamedParameters, class Tag>
  static auto parameter(const NamedParameters& np, Tag tag) { return CGAL::parameters::get_parameter(np, tag); }

  // `add(np)` if that parameter is given, too, else np.
  template <class Given, class Tag, class NamedParameters, class Add>
  static auto with(const NamedParameters& np, const Add& add)
  {
    if constexpr(has<Given, Tag>())
      return add(np);
    else
      return np;
  }

  struct No_patches
  {
    template <class Face>
    friend int get(const No_patches&, const Face&) { return 0; }
  };

  template <class Graph, class Map>
  static auto triangles(const Graph& g, const Map& patches)
  {
    using Patch = std::decay_t<decltype(get(patches, *faces(g).begin()))>;
    std::vector<std::pair<Triangle, Patch>> result;
    const auto points = get(CGAL::vertex_point, g);
    for(const auto f : faces(g))
    {
      const auto h = halfedge(f, g);
      Triangle t = {get(points, source(h, g)), get(points, target(h, g)), get(points, target(next(h, g), g))};
      std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
      result.emplace_back(t, get(patches, f));
    }
    std::sort(result.begin(), result.end());
    return result;
  }

  template <class Graph, class Map>
  static std::multiset<std::pair<Point, Point>> marked_edges(const Graph& g, const Map& marks)
  {
    std::multiset<std::pair<Point, Point>> result;
    const auto points = get(CGAL::vertex_point, g);
    for(const auto e : edges(g))
      if(get(marks, e))
        result.insert(std::minmax(get(points, source(e, g)), get(points, target(e, g))));
    return result;
  }

public:
  template <class Faces, class NamedParameters>
  Polyhedron_twin(const invariants::Mesh& mesh, const Faces& range, const NamedParameters& np)
  {
    std::unordered_map<invariants::Face, Traits::face_descriptor> twin_of_face;
    std::unordered_map<invariants::Vertex, Traits::vertex_descriptor> twin_of_vertex;
    std::unordered_map<invariants::Mesh::Halfedge_index, Traits::halfedge_descriptor> twin_of_halfedge;
    CGAL::copy_face_graph(mesh, polyhedron_,
                          CGAL::parameters::vertex_to_vertex_output_iterator(std::inserter(twin_of_vertex, twin_of_vertex.end()))
                            .halfedge_to_halfedge_output_iterator(std::inserter(twin_of_halfedge, twin_of_halfedge.end()))
                            .face_to_face_output_iterator(std::inserter(twin_of_face, twin_of_face.end())));
    // Elements are met in the same order when their half-edges are the same.
    for(const auto f : mesh.faces())
      set_halfedge(twin_of_face.at(f), twin_of_halfedge.at(mesh.halfedge(f)), polyhedron_);
    for(const auto f : range)
      range_.push_back(twin_of_face.at(f));
    if constexpr(has<NamedParameters, CGAL::internal_np::edge_is_constrained_t>())
      for(const auto e : mesh.edges())
        edge_marks_[edge(twin_of_halfedge.at(mesh.halfedge(e)), polyhedron_)] =
          get(parameter(np, CGAL::internal_np::edge_is_constrained), e);
    if constexpr(has<NamedParameters, CGAL::internal_np::vertex_is_constrained_t>())
      for(const auto v : mesh.vertices())
        vertex_marks_[twin_of_vertex.at(v)] = get(parameter(np, CGAL::internal_np::vertex_is_constrained), v);
    if constexpr(has<NamedParameters, CGAL::internal_np::face_patch_t>())
      for(const auto f : mesh.faces())
        patches_[twin_of_face.at(f)] = get(parameter(np, CGAL::internal_np::face_patch), f);
  }

  template <class Given>
  void run(double length, const Given& given)
  {
    using CGAL::parameters::choose_parameter;
    namespace tags = CGAL::internal_np;
    const auto choices =
      CGAL::parameters::number_of_iterations(choose_parameter(parameter(given, tags::number_of_iterations), 10u))
        .protect_constraints(choose_parameter(parameter(given, tags::protect_constraints), false))
        .collapse_constraints(choose_parameter(parameter(given, tags::collapse_constraints), true))
        .relax_constraints(choose_parameter(parameter(given, tags::relax_constraints), true));
    const auto splits = with<Given, tags::do_split_t>(choices, [&](const auto& np) { return np.do_split(parameter(given, tags::do_split)); });
    const auto collapses = with<Given, tags::do_collapse_t>(splits, [&](const auto& np) {
      return np.do_collapse(parameter(given, tags::do_collapse)); });
    const auto steps = with<Given, tags::number_of_relaxation_steps_t>(collapses, [&](const auto& np) {
      return np.number_of_relaxation_steps(parameter(given, tags::number_of_relaxation_steps)); });
    const auto edges = with<Given, tags::edge_is_constrained_t>(steps, [&](const auto& np) {
      return np.edge_is_constrained_map(boost::make_assoc_property_map(edge_marks_)); });
    const auto vertices = with<Given, tags::vertex_is_constrained_t>(edges, [&](const auto& np) {
      return np.vertex_is_constrained_map(boost::make_assoc_property_map(vertex_marks_)); });
    CGAL::Inter_angle_remeshing::isotropic_remeshing(range_, length, polyhedron_,
      with<Given, tags::face_patch_t>(vertices, [&](const auto& np) {
        return np.face_patch_map(boost::make_assoc_property_map(patches_)); }));
  }

  // Whether the mesh, after the same call, has the same faces with the same patches, and the same marked edges.
  template <class NamedParameters>
  bool is_like(const invariants::Mesh& mesh, const NamedParameters& np) const
  {
    if constexpr(has<NamedParameters, CGAL::internal_np::edge_is_constrained_t>())
    {
      const auto map = parameter(np, CGAL::internal_np::edge_is_constrained);
      if(marked_edges(mesh, map) != marked_edges(polyhedron_, boost::make_assoc_property_map(edge_marks_)))
        return false;
    }
    if constexpr(has<NamedParameters, CGAL::internal_np::face_patch_t>())
    {
      const auto map = parameter(np, CGAL::internal_np::face_patch);
      if(triangles(mesh, map) != triangles(polyhedron_, boost::make_assoc_property_map(patches_)))
        return false;
    }
    const No_patches none;
    return polyhedron_.is_valid() && triangles(mesh, none) == triangles(polyhedron_, none);
  }

private:
  Polyhedron polyhedron_;
  std::vector<Traits::face_descriptor> range_;
  // Mutable, for a property map refers to what can be changed.
  std::unordered_map<Traits::edge_descriptor, bool> mutable edge_marks_;
  std::unordered_map<Traits::vertex_descriptor, bool> vertex_marks_;
  std::unordered_map<Traits::face_descriptor, int> mutable patches_;
};

#endif // CGAL_INTER_ANGLE_REMESHING_TEST_POLYHEDRON_TWIN_H
