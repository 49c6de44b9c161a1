// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_MOVE_RULE_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_MOVE_RULE_H

#include <CGAL/Inter_angle_remeshing/internal/mesh/Remeshing_mesh_graph.h>

#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// Whether a vertex may move from one place to another, by a functor of the user's; where there is none, it may.
class Move_rule
{
public:
  using Index = Remeshing_mesh::Index;
  // The mesh, the vertex, and the two places, in the units of the mesh.
  using Function = std::function<bool(const Remeshing_mesh&, Index, const Vector3&, const Vector3&)>;

  Move_rule() = default;
  Move_rule(Function function) : function_(std::move(function)) {}

  bool is_given() const { return bool(function_); }
  bool operator()(const Remeshing_mesh& mesh, Index v, const Vector3& from, const Vector3& to) const
  {
    return !function_ || from == to || function_(mesh, v, from, to);
  }

private:
  Function function_;
};

// By a functor that takes a vertex of the input, or a null vertex for a new one, and two points. `input_vertices` must outlive the rule.
template <class Point_3, class Functor, class InputVertex>
Move_rule make_move_rule(const Functor& functor, const std::vector<InputVertex>& input_vertices, InputVertex null_vertex)
{
  return Move_rule::Function(
    [functor = functor, &input_vertices, null_vertex](const Remeshing_mesh& mesh, Remeshing_mesh::Index v,
                                                      const Vector3& from, const Vector3& to) mutable {
      const auto point = [&](const Vector3& p) { return Point_3(mesh.unit() * p.x, mesh.unit() * p.y, mesh.unit() * p.z); };
      const Mesh_input_vertex_map<InputVertex> input{&mesh, &input_vertices, null_vertex};
      return bool(functor(get(input, Mesh_vertex(v)), point(from), point(to)));
    });
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_MOVE_RULE_H
