// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_EDGE_RULE_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_EDGE_RULE_H

#include <CGAL/Inter_angle_remeshing/Edge_profile.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/Remeshing_mesh_graph.h>

#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// The profile that policies are asked with during a run.
template <class InputVertex>
using Run_profile = Edge_profile<Remeshing_mesh, Mesh_point_map, Mesh_edge_is_constrained_map,
                                 Mesh_input_vertex_map<InputVertex>>;

// Whether an edge may be split, collapsed or flipped, by a policy of any type; a bool stands for all edges.
class Edge_rule
{
public:
  using Index = Remeshing_mesh::Index;
  // The mesh, the target length in the user's units, the half-edge, and whether the flip is one of a glide's first ones.
  using Function = std::function<bool(const Remeshing_mesh&, double, Index, bool)>;

  Edge_rule(bool value) : value_(value) {}
  Edge_rule(Function function) : function_(std::move(function)) {}

  bool is_never() const { return !function_ && !value_; }

  bool operator()(const Remeshing_mesh& mesh, double length, Index h, bool is_transient) const
  {
    return function_ ? function_(mesh, length, h, is_transient) : value_;
  }

private:
  bool value_ = true;
  Function function_;
};

// By a policy that takes a profile. `input_vertices` must outlive the rule.
template <class Policy, class InputVertex>
Edge_rule make_edge_rule(const Policy& policy, const std::vector<InputVertex>& input_vertices, InputVertex null_vertex)
{
  return Edge_rule::Function(
    [policy, &input_vertices, null_vertex](const Remeshing_mesh& mesh, double length, Remeshing_mesh::Index h, bool is_transient) {
      return policy(Run_profile<InputVertex>(Mesh_halfedge(h), mesh, Mesh_point_map{&mesh}, length, is_transient,
                                             Mesh_edge_is_constrained_map{&mesh},
                                             Mesh_input_vertex_map<InputVertex>{&mesh, &input_vertices, null_vertex},
                                             1 / mesh.unit()));
    });
}
template <class InputVertex>
Edge_rule make_edge_rule(bool value, const std::vector<InputVertex>&, InputVertex) { return value; }

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_EDGE_RULE_H
